#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

#include <epoxy/gl.h>
#include <initializer_list>
#include <string_view>

namespace tractus::render {

// GLSL sources of a shader program. Each list is joined, in order, after the line "#version 330".
struct ShaderSource {
    std::string_view name; // Name of the program in error messages.
    std::initializer_list<std::string_view> vertex;
    std::initializer_list<std::string_view> fragment;
};

// A linked shader program. Create, use and destroy it while the same OpenGL context is current.
class Shader {
public:
    // Fails with an internal error, which contains the driver's message, if the source does not
    // compile.
    static Result<Shader> build(ShaderSource const& source);

    Shader(Shader&& other) noexcept;
    Shader& operator=(Shader&& other) noexcept;
    ~Shader();

    void use() const { glUseProgram(program_); }

    // Sets a uniform of the program, which must be in use(). Unknown names are ignored, as
    // compilers remove unused uniforms.
    void set(char const* name, int value) const;
    void set(char const* name, float value) const;
    void set(char const* name, Vec2f const& value) const;
    void set(char const* name, Vec3f const& value) const;
    void set(char const* name, Eigen::Vector4f const& value) const;
    void set(char const* name, Eigen::Matrix4f const& value) const;

private:
    explicit Shader(GLuint program)
        : program_(program)
    {
    }

    GLuint program_ = 0;
};

} // namespace tractus::render
