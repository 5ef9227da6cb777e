// SPDX-License-Identifier: MIT
#include "widgets/state/PresetUse.h"

#include <algorithm>
#include <span>
#include <variant>
#include <vector>

#include <QtCore/QSettings>
#include <QtGui/QPainter>
#include <QtGui/QPixmap>

#include "model/base/Color.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kPictureSize = 32; ///< logical pixels
constexpr int kColourHeight = 8;
constexpr std::size_t kMostColours = 6;
const QString kLatestKey = QStringLiteral("presets/latest");

void addColour(std::vector<QColor>& colors, const model::PaintColor& color)
{
    if (colors.size() < kMostColours) {
        colors.emplace_back(color[0], color[1], color[2]);
    }
}

/// All that its own settings hold.
void addColours(std::vector<QColor>& colors, std::span<const model::FieldInfo> fields,
                const void* object)
{
    for (const model::FieldInfo& field : fields) {
        if (field.isGroup()) {
            addColours(colors, field.children,
                       field.childOf(const_cast<void*>(object))); // only read
            continue;
        }
        if (!field.meta.isStored || field.isList()) {
            continue;
        }
        const model::FieldValue value = field.get(object);
        if (const auto* one = std::get_if<model::PaintColor>(&value)) {
            addColour(colors, *one);
        } else if (const auto* many = std::get_if<std::vector<model::PaintColor>>(&value)) {
            for (const model::PaintColor& each : *many) {
                addColour(colors, each);
            }
        }
    }
}

} // namespace

void usePreset(EditorState& state, const model::BrushPreset& preset)
{
    state.setBrush(model::applied(preset, state.brush(preset.kind)));
    state.setTool(toolOf(preset.kind));
    QStringList latest = latestPresets();
    latest.removeAll(preset.name);
    latest.prepend(preset.name);
    QSettings().setValue(kLatestKey, latest.mid(0, kMostLatestPresets));
}

QStringList latestPresets()
{
    return QSettings().value(kLatestKey).toStringList();
}

QIcon presetPicture(const model::BrushPreset& preset)
{
    QIcon symbol = iconNamed(toolInfo(toolOf(preset.kind)).stableId);
    const model::BrushSettings brush = model::applied(preset, model::BrushSettings(preset.kind));
    std::vector<QColor> colors;
    const model::BrushType& type = model::brushType(preset.kind);
    addColours(colors, type.fields, type.settings(brush));
    if (preset.kind == model::BrushKind::Colour && brush.op == model::BrushOperator::Uniform) {
        colors.resize(std::min<std::size_t>(colors.size(), 1)); // it paints with the first
    }
    if (colors.empty()) {
        return symbol;
    }
    QPixmap picture(kPictureSize, kPictureSize);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    const int free = kPictureSize - kColourHeight - 1;
    symbol.paint(&painter, (kPictureSize - free) / 2, 0, free, free);
    const auto count = static_cast<int>(colors.size());
    for (int i = 0; i < count; ++i) {
        const int left = kPictureSize * i / count;
        const int right = kPictureSize * (i + 1) / count;
        painter.fillRect(left, kPictureSize - kColourHeight, right - left, kColourHeight,
                         colors[static_cast<std::size_t>(i)]);
    }
    painter.setPen(QColor(0, 0, 0, 90));
    painter.drawRect(0, kPictureSize - kColourHeight, kPictureSize - 1, kColourHeight - 1);
    return picture;
}

} // namespace crowd::widgets
