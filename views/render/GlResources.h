// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/Camera.h"

#include <QImage>
#include <QOpenGLFunctions_3_3_Core>
#include <QSurfaceFormat>

#include <cstddef>
#include <memory>
#include <vector>

class QOpenGLShaderProgram;

namespace espalier {

using Gl = QOpenGLFunctions_3_3_Core;

/// What this program asks of OpenGL: 3.3 core, no buffers but colour, for everything is drawn into textures
/// first.
QSurfaceFormat surfaceFormat();

/// OpenGL's functions of the current context; null if it has not got version 3.3.
Gl* currentGl();

/// The name of an object of OpenGL, deleted with its owner: make, use and destroy it with the same context
/// current.
template <auto Generate, auto Delete>
class GlName {
public:
    explicit GlName(Gl& gl) : m_gl(&gl) { (gl.*Generate)(1, &m_name); }
    ~GlName()
    {
        if (m_name != 0)
            (m_gl->*Delete)(1, &m_name);
    }
    GlName(GlName&& other) noexcept : m_gl(other.m_gl), m_name(std::exchange(other.m_name, 0)) {}
    GlName& operator=(GlName&& other) noexcept
    {
        std::swap(m_gl, other.m_gl);
        std::swap(m_name, other.m_name);
        return *this;
    }

    GLuint get() const { return m_name; }

private:
    Gl* m_gl;
    GLuint m_name = 0;
};

using GlBufferName = GlName<&Gl::glGenBuffers, &Gl::glDeleteBuffers>;
using GlTexture = GlName<&Gl::glGenTextures, &Gl::glDeleteTextures>;
using GlVertexArray = GlName<&Gl::glGenVertexArrays, &Gl::glDeleteVertexArrays>;
using GlFramebuffer = GlName<&Gl::glGenFramebuffers, &Gl::glDeleteFramebuffers>;
using GlRenderbuffer = GlName<&Gl::glGenRenderbuffers, &Gl::glDeleteRenderbuffers>;

/// A buffer on the graphics card that grows by half when it must.
class GlBuffer {
public:
    explicit GlBuffer(Gl& gl) : m_gl(gl), m_name(gl) {}

    GLuint name() const { return m_name.get(); }
    /// Bytes that it holds at least.
    std::size_t capacity() const { return m_capacity; }
    /// Makes room for @p bytes; true if that made another, empty store.
    bool reserve(std::size_t bytes);
    /// Precondition: there is room for it.
    void write(std::size_t offset, const void* data, std::size_t bytes);

private:
    Gl& m_gl;
    GlBufferName m_name;
    std::size_t m_capacity = 0;
};

/// Makes a program of two of the resources' shaders, such as "bark.vert" and "bark.frag"; a line #include
/// "x.glsl" in them stands for that file, and @p define, if any, is a name that #ifdef knows in both. The
/// shaders are parts of this program: an error in them is a defect and ends it.
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char* vertexShader, const char* fragmentShader,
                                                  const char* define = "");

enum class TextureContent {
    Colour, ///< sRGB, made linear when it is looked up
    Data,   ///< Normals and the like
};

/// Fills a texture with @p image, its bottom row at v = 0, with mipmaps, repeated or held at its edges.
void fillTexture(Gl& gl, const GlTexture& texture, const QImage& image, TextureContent content, bool repeat);

void setMatrix(QOpenGLShaderProgram& program, const char* name, const Matrix4& matrix);
void setVector(QOpenGLShaderProgram& program, const char* name, const Vec3& vector);

} // namespace espalier
