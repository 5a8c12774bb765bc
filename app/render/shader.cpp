#include "app/render/shader.h"

#include <algorithm>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace tractus::render {

namespace {

std::string message(GLuint object, decltype(glGetShaderiv) get,
                    decltype(glGetShaderInfoLog) get_log)
{
    GLint length = 0;
    get(object, GL_INFO_LOG_LENGTH, &length);
    std::string text(static_cast<std::size_t>(std::max(length, 1)), '\0');
    get_log(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
    return text.c_str();
}

Result<GLuint> compile(GLenum stage, std::string_view name,
                       std::initializer_list<std::string_view> pieces)
{
    std::string text = "#version 330 core\n";
    for (auto const piece : pieces)
        text += piece;
    GLuint const shader = glCreateShader(stage);
    char const* const start = text.c_str();
    glShaderSource(shader, 1, &start, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE)
        return shader;
    auto const reason = message(shader, glGetShaderiv, glGetShaderInfoLog);
    glDeleteShader(shader);
    return fail(Fault::Station,
                fmt::format("the graphics driver refuses the {} shader: {}", name, reason));
}

} // namespace

Result<Shader> Shader::build(ShaderSource const& source)
{
    GLuint const vertex = TRY(compile(GL_VERTEX_SHADER, source.name, source.vertex));
    auto const fragment = compile(GL_FRAGMENT_SHADER, source.name, source.fragment);
    Shader shader(glCreateProgram());
    glAttachShader(shader.program_, vertex);
    glDeleteShader(vertex); // The program keeps the shader until it is deleted itself.
    if (!fragment)
        return tl::unexpected(fragment.error());
    glAttachShader(shader.program_, *fragment);
    glDeleteShader(*fragment);
    glLinkProgram(shader.program_);
    GLint linked = GL_FALSE;
    glGetProgramiv(shader.program_, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE)
        return fail(Fault::Station,
                    fmt::format("the graphics driver cannot link the {} shader: {}", source.name,
                                message(shader.program_, glGetProgramiv, glGetProgramInfoLog)));
    return shader;
}

Shader::Shader(Shader&& other) noexcept
    : program_(std::exchange(other.program_, 0))
{
}

Shader& Shader::operator=(Shader&& other) noexcept
{
    std::swap(program_, other.program_);
    return *this;
}

Shader::~Shader()
{
    if (program_ != 0)
        glDeleteProgram(program_);
}

void Shader::set(char const* name, int value) const
{
    glUniform1i(glGetUniformLocation(program_, name), value);
}

void Shader::set(char const* name, float value) const
{
    glUniform1f(glGetUniformLocation(program_, name), value);
}

void Shader::set(char const* name, Vec2f const& value) const
{
    glUniform2fv(glGetUniformLocation(program_, name), 1, value.data());
}

void Shader::set(char const* name, Vec3f const& value) const
{
    glUniform3fv(glGetUniformLocation(program_, name), 1, value.data());
}

void Shader::set(char const* name, Eigen::Vector4f const& value) const
{
    glUniform4fv(glGetUniformLocation(program_, name), 1, value.data());
}

void Shader::set(char const* name, Eigen::Matrix4f const& value) const
{
    glUniformMatrix4fv(glGetUniformLocation(program_, name), 1, GL_FALSE, value.data());
}

} // namespace tractus::render
