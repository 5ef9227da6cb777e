// SPDX-License-Identifier: MIT
#include "render/gl/ShaderVariants.h"

#include <utility>

namespace crowd::render {

ShaderVariants::ShaderVariants(std::string name, std::function<void(ShaderProgram&)> begin)
    : m_name(std::move(name)), m_begin(std::move(begin))
{
}

model::Result<ShaderProgram*> ShaderVariants::get(const std::string& defines)
{
    const auto found = m_programs.find(defines);
    if (found != m_programs.end()) {
        return &found->second;
    }
    auto built = ShaderProgram::build(m_name, defines);
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = m_programs.emplace(defines, std::move(built).value()).first->second;
    if (m_begin) {
        program.use();
        m_begin(program);
    }
    return &program;
}

} // namespace crowd::render
