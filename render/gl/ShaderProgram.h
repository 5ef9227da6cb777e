// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/base/Result.h"
#include "render/gl/GlObjects.h"

namespace crowd::render {

/// A vertex and a fragment shader from resources/shaders ("NAME.vert", "NAME.frag"), compiled with
/// some of their #ifdef branches. Uniforms are set by name on the program in use; a name that a
/// variant does not have is passed over.
class ShaderProgram
{
public:
    /// `defines`: words separated by spaces, or WORD=VALUE.
    [[nodiscard]] static model::Result<ShaderProgram> build(std::string_view name,
                                                            std::string_view defines = {});

    void use() const;
    void set(const char* name, float value);
    void set(const char* name, int value);
    void set(const char* name, std::uint32_t value);
    void set(const char* name, const glm::vec2& value);
    void set(const char* name, const glm::ivec2& value);
    void set(const char* name, const glm::vec3& value);
    void set(const char* name, const glm::vec4& value);
    void set(const char* name, const glm::mat4& value);
    void set(const char* name, std::span<const float> values); ///< an array
    void set(const char* name, std::span<const glm::vec4> values);
    void set(const char* name, std::span<const glm::mat4> values);

private:
    [[nodiscard]] int location(const char* name);

    GlProgram m_program;
    std::map<std::string, int, std::less<>> m_locations;
};

} // namespace crowd::render
