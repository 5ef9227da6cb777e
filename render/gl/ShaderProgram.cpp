// SPDX-License-Identifier: MIT
#include "render/gl/ShaderProgram.h"

#include <algorithm>
#include <array>
#include <regex>
#include <set>
#include <sstream>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "render/gl/ShaderSources.h"

namespace crowd::render {

namespace {

bool isDefined(std::string_view defines, std::string_view wanted)
{
    std::istringstream words{std::string(defines)};
    for (std::string word; words >> word;) {
        if (word == wanted) {
            return true;
        }
    }
    return false;
}

std::string fullText(const std::string& file, std::string_view defines)
{
    std::string_view own = shaderSource(file);
    if (own.empty() && file.ends_with(".vert")) {
        own = shaderSource("screen.vert"); // of passes over the whole picture
    }
    std::string text = "#version 330 core\n";
    std::istringstream words{std::string(defines)};
    for (std::string word; words >> word;) {
        std::ranges::replace(word, '=', ' ');
        text += "#define " + word + "\n";
    }
    text += shaderSource("highlights.glsl");
    text += shaderSource("lights.glsl");
    if (file.ends_with(".vert")) {
        text += shaderSource("lighting.glsl");
    } else {
        if (isDefined(defines, "RELIEF") || isDefined(defines, "IMPOSTOR")) {
            text += shaderSource("lighting.glsl");
        }
        text += shaderSource("shadow.glsl");
        text += shaderSource("tone.glsl");
        if (isDefined(defines, "AOV")) {
            text += shaderSource("aov.glsl");
        }
    }
    if (file == "crowd.vert" || file == "impostor.frag") {
        text += shaderSource("person.glsl");
    }
    text += own;
    return file == "impostor.frag" ? text.append(shaderSource("crowd.frag")) : text;
}

std::string logOf(GLuint object, bool isProgram)
{
    std::array<char, 1024> text{};
    if (isProgram) {
        glGetProgramInfoLog(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
    } else {
        glGetShaderInfoLog(object, static_cast<GLsizei>(text.size()), nullptr, text.data());
    }
    return text.data();
}

/// The lines that a driver's words speak of, as "0:12(3)" (Mesa) or "0(12)" (others), with their
/// numbers; none where it speaks of none.
std::string linesOf(const std::string& log, const std::string& text)
{
    static const std::regex place(R"(\b\d+[:(](\d+)\b)");
    std::set<int> wanted;
    for (std::sregex_iterator found(log.begin(), log.end(), place), end; found != end; ++found) {
        if (const std::string number = found->str(1); number.size() < 7) {
            wanted.insert(std::stoi(number));
        }
    }
    constexpr std::size_t kMost = 3; // what follows mostly comes of the first
    std::string quoted;
    std::istringstream lines(text);
    int number = 0;
    std::size_t count = 0;
    for (std::string line; count < kMost && std::getline(lines, line);) {
        if (wanted.contains(++number)) {
            quoted += std::to_string(number) + ": " + line + "\n";
            ++count;
        }
    }
    return quoted;
}

/// Compiles and attaches; the shader lives on with the program only.
model::Result<void> attach(GLuint program, GLenum stage, const std::string& file,
                           std::string_view defines)
{
    const std::string text = fullText(file, defines);
    const char* data = text.c_str();
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &data, nullptr);
    glCompileShader(shader);
    GLint isCompiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &isCompiled);
    glAttachShader(program, shader);
    std::string log;
    if (isCompiled != GL_TRUE) {
        log = logOf(shader, false);
        log += linesOf(log, text);
    }
    glDeleteShader(shader);
    if (isCompiled != GL_TRUE) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages",
                              "The graphics driver does not compile the shader %1 (%2): %3 A newer "
                              "driver, or LIBGL_ALWAYS_SOFTWARE=1, may help."),
            file, defines, log};
    }
    return {};
}

} // namespace

model::Result<ShaderProgram> ShaderProgram::build(std::string_view name, std::string_view defines)
{
    ShaderProgram program;
    program.m_program = GlProgram::create();
    const GLuint id = program.m_program.name();
    const std::string file(name);
    if (auto vertex = attach(id, GL_VERTEX_SHADER, file + ".vert", defines); !vertex) {
        return vertex.error();
    }
    if (auto fragment = attach(id, GL_FRAGMENT_SHADER, file + ".frag", defines); !fragment) {
        return fragment.error();
    }
    glLinkProgram(id);
    GLint isLinked = GL_FALSE;
    glGetProgramiv(id, GL_LINK_STATUS, &isLinked);
    if (isLinked != GL_TRUE) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages",
                              "The graphics driver does not link the shader %1 (%2): %3 A newer "
                              "driver, or LIBGL_ALWAYS_SOFTWARE=1, may help."),
            file, defines, logOf(id, true)};
    }
    return program;
}

void ShaderProgram::use() const
{
    glUseProgram(m_program.name());
}

int ShaderProgram::location(const char* name)
{
    const auto found = m_locations.find(std::string_view(name));
    if (found != m_locations.end()) {
        return found->second;
    }
    const int place = glGetUniformLocation(m_program.name(), name);
    m_locations.emplace(name, place);
    return place;
}

void ShaderProgram::set(const char* name, float value)
{
    glUniform1f(location(name), value);
}

void ShaderProgram::set(const char* name, int value)
{
    glUniform1i(location(name), value);
}

void ShaderProgram::set(const char* name, std::uint32_t value)
{
    glUniform1ui(location(name), value);
}

void ShaderProgram::set(const char* name, const glm::vec2& value)
{
    glUniform2fv(location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::ivec2& value)
{
    glUniform2iv(location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::vec3& value)
{
    glUniform3fv(location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::vec4& value)
{
    glUniform4fv(location(name), 1, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, const glm::mat4& value)
{
    glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

void ShaderProgram::set(const char* name, std::span<const float> values)
{
    glUniform1fv(location(name), static_cast<GLsizei>(values.size()), values.data());
}

void ShaderProgram::set(const char* name, std::span<const glm::vec4> values)
{
    glUniform4fv(location(name), static_cast<GLsizei>(values.size()),
                 reinterpret_cast<const GLfloat*>(values.data()));
}

void ShaderProgram::set(const char* name, std::span<const glm::mat4> values)
{
    glUniformMatrix4fv(location(name), static_cast<GLsizei>(values.size()), GL_FALSE,
                       reinterpret_cast<const GLfloat*>(values.data()));
}

} // namespace crowd::render
