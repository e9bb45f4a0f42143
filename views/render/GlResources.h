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

/// The OpenGL version and buffers that the program needs: 3.3 core, and only a colour buffer, because
/// everything is drawn into textures first.
QSurfaceFormat surfaceFormat();

/// OpenGL's functions of the current context; null if its version is below 3.3.
Gl* currentGl();

/// The name of an OpenGL object, which is deleted with this C++ object. Make, use and destroy it with the
/// same context current.
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

/// A buffer on the graphics card. It grows by at least half of its size.
class GlBuffer {
public:
    explicit GlBuffer(Gl& gl) : m_gl(gl), m_name(gl) {}

    GLuint name() const { return m_name.get(); }
    /// Size in bytes.
    std::size_t capacity() const { return m_capacity; }
    /// Makes room for @p bytes; returns true if it made a new, empty store.
    bool reserve(std::size_t bytes);
    /// Writes bytes into the buffer. Precondition: there is room for them.
    void write(std::size_t offset, const void* data, std::size_t bytes);

private:
    Gl& m_gl;
    GlBufferName m_name;
    std::size_t m_capacity = 0;
};

/// Makes a program of two shaders of the resources, such as "bark.vert" and "bark.frag". A line #include
/// "x.glsl" in them is replaced by that file; @p define, if not null, is a name that #ifdef finds in both.
/// The shaders are part of this program: an error in them is a defect and ends it.
std::unique_ptr<QOpenGLShaderProgram> loadProgram(const char* vertexShader, const char* fragmentShader,
                                                  const char* define = "");

enum class TextureContent {
    Colour, ///< sRGB, converted to linear on lookup
    Data,   ///< Normals and other numbers
};

/// Fills a texture with @p image, its bottom row at v = 0, with mipmaps, repeated or held at its edges.
void fillTexture(Gl& gl, const GlTexture& texture, const QImage& image, TextureContent content, bool repeat);

void setMatrix(QOpenGLShaderProgram& program, const char* name, const Matrix4& matrix);
void setVector(QOpenGLShaderProgram& program, const char* name, const Vec3& vector);

} // namespace espalier
