// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "model/base/Result.h"
#include "render/gl/ShaderProgram.h"

namespace crowd::render {

/// A shader with the variants that somebody asked for, compiled when first needed.
class ShaderVariants
{
public:
    /// `name`: as ShaderProgram::build; `begin` sets what stays, on the new program in use.
    explicit ShaderVariants(std::string name, std::function<void(ShaderProgram&)> begin = {});
    [[nodiscard]] model::Result<ShaderProgram*> get(const std::string& defines);

private:
    std::string m_name;
    std::function<void(ShaderProgram&)> m_begin;
    std::map<std::string, ShaderProgram, std::less<>> m_programs;
};

} // namespace crowd::render
