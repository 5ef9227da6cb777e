// SPDX-License-Identifier: MIT
#include "widgets/state/ToolId.h"

#include <algorithm>
#include <deque>
#include <string>
#include <vector>

#include <QtCore/QtGlobal>

namespace crowd::widgets {

using model::BrushKind;

std::span<const ToolInfo> toolTable()
{
    static std::deque<std::string> ids; // of the tools below
    static const std::vector<ToolInfo> kTools = [] {
        std::vector<ToolInfo> tools{
            {ToolId::Select, "select", QT_TRANSLATE_NOOP("Tools", "Select"), "V", std::nullopt},
            {ToolId::Navigate, "navigate", QT_TRANSLATE_NOOP("Tools", "Navigate"), "N",
             std::nullopt}};
        for (const BrushKind kind : model::shownBrushes()) {
            const model::BrushInfo& info = model::brushType(kind).info;
            const std::string& id = ids.emplace_back(std::string("brush-") + info.id);
            tools.push_back({toolOf(kind), id.c_str(), info.name, info.shortcut, kind});
        }
        return tools;
    }();
    return kTools;
}

const ToolInfo& toolInfo(ToolId id)
{
    return *std::ranges::find(toolTable(), id, &ToolInfo::id);
}

std::optional<BrushKind> brushKindOf(ToolId id)
{
    return toolInfo(id).brush;
}

ToolId toolOf(BrushKind kind)
{
    constexpr int kFirst = static_cast<int>(ToolId::Navigate) + 1;
    return static_cast<ToolId>(kFirst + static_cast<int>(kind));
}

} // namespace crowd::widgets
