// SPDX-License-Identifier: MIT
#include "widgets/state/ToolId.h"

#include <QtCore/QCoreApplication>

namespace crowd::widgets {

using model::BrushKind;

const std::array<ToolInfo, static_cast<std::size_t>(ToolId::Count)>& toolTable()
{
    static constexpr std::array<ToolInfo, static_cast<std::size_t>(ToolId::Count)> kTools{{
        {ToolId::Select, "select", QT_TRANSLATE_NOOP("Tools", "Select"), "V", std::nullopt},
        {ToolId::Navigate, "navigate", QT_TRANSLATE_NOOP("Tools", "Navigate"), "N", std::nullopt},
        {ToolId::BrushCreate, "brush-create", QT_TRANSLATE_NOOP("Tools", "Create Brush"), "C",
         BrushKind::Create},
        {ToolId::BrushDelete, "brush-delete", QT_TRANSLATE_NOOP("Tools", "Delete Brush"), "X",
         BrushKind::Delete},
        {ToolId::BrushColour, "brush-colour", QT_TRANSLATE_NOOP("Tools", "Colour Brush"), "B",
         BrushKind::Colour},
        {ToolId::BrushOrientation, "brush-orientation",
         QT_TRANSLATE_NOOP("Tools", "Orientation Brush"), "O", BrushKind::Orientation},
        {ToolId::BrushAnimation, "brush-animation", QT_TRANSLATE_NOOP("Tools", "Animation Brush"),
         "A", BrushKind::Animation},
    }};
    return kTools;
}

const ToolInfo& toolInfo(ToolId id)
{
    return toolTable()[static_cast<std::size_t>(id)];
}

std::optional<BrushKind> brushKindOf(ToolId id)
{
    return toolInfo(id).brush;
}

ToolId toolOf(BrushKind kind)
{
    for (const ToolInfo& info : toolTable()) {
        if (info.brush == kind) {
            return info.id;
        }
    }
    return ToolId::Select;
}

} // namespace crowd::widgets
