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
        {ToolId::BrushPath, "brush-path", QT_TRANSLATE_NOOP("Tools", "Path Brush"), "P",
         BrushKind::Path},
        {ToolId::BrushWalk, "brush-walk", QT_TRANSLATE_NOOP("Tools", "Walk Brush"), "W",
         BrushKind::Walk},
        {ToolId::BrushStyle, "brush-style", QT_TRANSLATE_NOOP("Tools", "Walking Style Brush"), "R",
         BrushKind::Style},
        {ToolId::BrushEnvironment, "brush-environment",
         QT_TRANSLATE_NOOP("Tools", "Environment Brush"), "I", BrushKind::Environment},
        {ToolId::BrushEvent, "brush-event", QT_TRANSLATE_NOOP("Tools", "Event Brush"), "E",
         BrushKind::Event},
        {ToolId::BrushTag, "brush-tag", QT_TRANSLATE_NOOP("Tools", "Tag Brush"), "T",
         BrushKind::Tag},
        {ToolId::BrushUntag, "brush-untag", QT_TRANSLATE_NOOP("Tools", "Untag Brush"), "U",
         BrushKind::Untag},
        {ToolId::BrushScript, "brush-script", QT_TRANSLATE_NOOP("Tools", "Script Brush"), "S",
         BrushKind::Script},
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

model::BrushSettings initialBrush(BrushKind kind)
{
    model::BrushSettings settings;
    settings.kind = kind;
    switch (kind) {
    case BrushKind::Create:
        settings.create.variesFaces = true;
        settings.create.anywhere = false;
        // Clothes of an ordinary evening: nobody like his neighbour, nobody glaring.
        settings.create.palette = {{42, 52, 86},   {112, 40, 48},   {58, 84, 66},   {196, 186, 168},
                                   {70, 70, 76},   {150, 112, 70},  {92, 120, 156}, {206, 160, 72},
                                   {120, 84, 122}, {226, 222, 214}, {36, 38, 42},   {168, 92, 66}};
        break;
    case BrushKind::Delete:
        settings.selection = model::BrushSelection::AllInCircle;
        settings.radiusPixels = 24.0F;
        break;
    case BrushKind::Colour:
        settings.selection = model::BrushSelection::AllInCircle;
        settings.colour.sparesBody = true;
        break;
    case BrushKind::Orientation:
    case BrushKind::Script:
        settings.selection = model::BrushSelection::AllInCircle;
        break;
    case BrushKind::Animation:
        settings.selection = model::BrushSelection::AllInCircle;
        settings.op = model::BrushOperator::Random;
        break;
    case BrushKind::Walk:
    case BrushKind::Style:
    case BrushKind::Tag:
    case BrushKind::Untag:
    case BrushKind::Event:
        settings.selection = model::BrushSelection::AllInCircle;
        break;
    case BrushKind::Path:
    case BrushKind::Environment:
        settings.place.anywhere = false;
        settings.selection = model::BrushSelection::Point;
        break;
    }
    return settings;
}

} // namespace crowd::widgets
