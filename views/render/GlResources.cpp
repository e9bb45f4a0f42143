// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/GlResources.h"

#include <QFile>
#include <QOpenGLContext>
#include <QOpenGLShaderProgram>
#include <QOpenGLVersionFunctionsFactory>

#include <algorithm>

namespace espalier {

namespace {

QByteArray readShader(const QString& name)
{
    QFile file(":/shaders/" + name);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("The shader %s is not in the program's resources", qPrintable(name));
    QByteArray text;
    constexpr QByteArrayView kInclude = "#include \"";
    for (const QByteArray& line : file.readAll().split('\n')) {
        if (line.startsWith(kInclude))
            text += readShader(
                QString::fromLatin1(line.mid(kInclude.size(), line.lastIndexOf('"') - kInclude.size())));
        else
            text += line + '\n';
    }
    return text;
}

} // namespace

QSurfaceFormat surfaceFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setVersion(3, 3);
    format.setDepthBufferSize(0);
    format.setStencilBufferSize(0);
    return format;
}

Gl* currentGl()
{
    QOpenGLContext* context = QOpenGLContext::currentContext();
    if (context == nullptr)
        return nullptr;
    auto* gl = QOpenGLVersionFunctionsFactory::get<Gl>(context);
    return gl != nullptr && gl->initializeOpenGLFunctions() ? gl : nullptr;
}

bool GlBuffer::reserve(std::size_t bytes)
{
    if (bytes <= m_capacity)
        return false;
    m_capacity = std::max(bytes, m_capacity + m_capacity / 2);
    m_gl.glBindBuffer(GL_COPY_WRITE_BUFFER, name());
    m_gl.glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(m_capacity), nullptr, GL_DYNAMIC_DRAW);
    return true;
}

void GlBuffer::write(std::size_t offset, const void* data, std::size_t bytes)
{
    // Binding to this target leaves the vertex arrays as they are.
    m_gl.glBindBuffer(GL_COPY_WRITE_BUFFER, name());
    m_gl.glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                         data);
}

std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char* vertexShader, const char* fragmentShader,
                                                  const char* define)
{
    const auto source = [define](const char* name) {
        QByteArray text = readShader(QString::fromLatin1(name));
        // The first line must stay the version.
        if (*define != '\0')
            text.insert(text.indexOf('\n') + 1, QByteArray("#define ") + define + '\n');
        return text;
    };
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const bool works = program->addShaderFromSourceCode(QOpenGLShader::Vertex, source(vertexShader)) &&
                       program->addShaderFromSourceCode(QOpenGLShader::Fragment, source(fragmentShader)) &&
                       program->link();
    if (!works)
        qFatal("%s and %s: %s", vertexShader, fragmentShader, qPrintable(program->log()));
    const GLuint id = program->programId();
    Gl* gl = currentGl();
    const GLuint frame = gl->glGetUniformBlockIndex(id, "Frame");
    if (frame != GL_INVALID_INDEX)
        gl->glUniformBlockBinding(id, frame, 0);
    return program;
}

void fillTexture(Gl& gl, const GlTexture& texture, const QImage& image, TextureContent content, bool repeat)
{
    const QImage upright = image.convertToFormat(QImage::Format_RGBA8888).mirrored();
    gl.glBindTexture(GL_TEXTURE_2D, texture.get());
    gl.glTexImage2D(GL_TEXTURE_2D, 0, content == TextureContent::Colour ? GL_SRGB8_ALPHA8 : GL_RGBA8,
                    upright.width(), upright.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE, upright.constBits());
    gl.glGenerateMipmap(GL_TEXTURE_2D);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    const GLint wrapping = repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapping);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapping);
}

void setMatrix(QOpenGLShaderProgram& program, const char* name, const Matrix4& matrix)
{
    // QMatrix4x4 reads row by row.
    const Matrix4 rows = matrix.transpose();
    program.setUniformValue(name, QMatrix4x4(rows.data()));
}

void setVector(QOpenGLShaderProgram& program, const char* name, const Vec3& vector)
{
    program.setUniformValue(name, QVector3D(vector.x(), vector.y(), vector.z()));
}

} // namespace espalier
