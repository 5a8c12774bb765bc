#pragma once

#include <epoxy/gl.h>
#include <span>
#include <utility>

namespace tractus::render::gl {

// Unique owner of an OpenGL object's name. Create, use and destroy it while the same OpenGL context
// is current.
template<typename Kind> class Object {
public:
    Object() { Kind::create(&name_); }
    Object(Object&& other) noexcept
        : name_(std::exchange(other.name_, 0))
    {
    }
    Object& operator=(Object&& other) noexcept
    {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Object()
    {
        if (name_ != 0)
            Kind::destroy(&name_);
    }

    GLuint name() const { return name_; }

private:
    GLuint name_ = 0;
};

struct BufferKind {
    static void create(GLuint* name) { glGenBuffers(1, name); }
    static void destroy(GLuint const* name) { glDeleteBuffers(1, name); }
};
struct VertexArrayKind {
    static void create(GLuint* name) { glGenVertexArrays(1, name); }
    static void destroy(GLuint const* name) { glDeleteVertexArrays(1, name); }
};
struct TextureKind {
    static void create(GLuint* name) { glGenTextures(1, name); }
    static void destroy(GLuint const* name) { glDeleteTextures(1, name); }
};
struct RenderbufferKind {
    static void create(GLuint* name) { glGenRenderbuffers(1, name); }
    static void destroy(GLuint const* name) { glDeleteRenderbuffers(1, name); }
};
struct FramebufferKind {
    static void create(GLuint* name) { glGenFramebuffers(1, name); }
    static void destroy(GLuint const* name) { glDeleteFramebuffers(1, name); }
};

using Buffer = Object<BufferKind>;
using VertexArray = Object<VertexArrayKind>;
using Texture = Object<TextureKind>;
using Renderbuffer = Object<RenderbufferKind>;
using Framebuffer = Object<FramebufferKind>;

// Copies `values` into the buffer, and leaves the buffer bound to `target`.
template<typename Value>
void upload(Buffer const& buffer, GLenum target, std::span<Value const> values)
{
    glBindBuffer(target, buffer.name());
    glBufferData(target, static_cast<GLsizeiptr>(values.size_bytes()), values.data(),
                 GL_STATIC_DRAW);
}

// Converts the offset of a vertex's member to the pointer that glVertexAttribPointer expects.
inline void const* offset(std::size_t bytes)
{
    return reinterpret_cast<void const*>(bytes);
}

} // namespace tractus::render::gl
