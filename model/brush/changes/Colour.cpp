// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "model/base/Color.h"
#include "model/brush/ColumnWriting.h"
#include "model/brush/SlotChoice.h"

namespace crowd::model {

namespace {

std::uint8_t mixedByte(double a, double b, double share)
{
    return static_cast<std::uint8_t>(std::floor(a + (b - a) * share + 0.5));
}

PaintColor colorAlong(const std::vector<PaintColor>& colors, double share)
{
    const double place = share * static_cast<double>(colors.size() - 1);
    const std::size_t first = std::min(static_cast<std::size_t>(place), colors.size() - 1);
    const std::size_t second = std::min(first + 1, colors.size() - 1);
    PaintColor mixed{};
    for (std::size_t c = 0; c < mixed.size(); ++c) {
        mixed[c] =
            mixedByte(colors[first][c], colors[second][c], place - static_cast<double>(first));
    }
    return mixed;
}

/// What is seen lies so far between what was seen and the colour: of the cloth one sees what
/// neither tint covers.
Tint tintOver(const Tint& before, const PaintColor& color, double share)
{
    constexpr double kFull = 255.0;
    const double left = before.strength / kFull * (1.0 - share);
    const double strength = left + share;
    if (strength <= 0.0) {
        return {color[0], color[1], color[2], 0};
    }
    const auto mixed = [&](std::uint8_t was, std::uint8_t now) {
        const auto light = [](std::uint8_t byte) {
            return static_cast<double>(linearFromSrgb(static_cast<float>(byte) / 255.0F));
        };
        const auto linear = (light(was) * left + light(now) * share) / strength;
        const double encoded = static_cast<double>(srgbFromLinear(static_cast<float>(linear)));
        return mixedByte(0.0, kFull, std::clamp(encoded, 0.0, 1.0));
    };
    return {mixed(before.red, color[0]), mixed(before.green, color[1]),
            mixed(before.blue, color[2]), mixedByte(0.0, kFull, std::min(strength, 1.0))};
}

Tint targetTint(const ColourSettings& settings, const OperatorResult& values, std::size_t i)
{
    const std::vector<PaintColor>& colors = settings.colors;
    const bool picksOne = values.isDraw && !settings.blends;
    const double share = values.shares[i];
    PaintColor color{255, 255, 255};
    if (!values.colors.empty()) {
        color = values.colors[i];
    } else if (!colors.empty()) {
        const auto picked = static_cast<std::size_t>(share * static_cast<double>(colors.size()));
        color = picksOne ? colors[std::min(picked, colors.size() - 1)] : colorAlong(colors, share);
    }
    return {color[0], color[1], color[2], mixedByte(0.0, 255.0, settings.strength)};
}

/// A step of the given share towards the target that always gets there in the end.
std::uint8_t stepped(std::uint8_t from, std::uint8_t to, float share)
{
    const float way = static_cast<float>(to - from) * share;
    return static_cast<std::uint8_t>(static_cast<float>(from) +
                                     (way > 0.0F ? std::ceil(way) : std::floor(way)));
}

Tint steppedTint(const Tint& from, const Tint& to, float share)
{
    return {stepped(from.red, to.red, share), stepped(from.green, to.green, share),
            stepped(from.blue, to.blue, share), stepped(from.strength, to.strength, share)};
}

/// What the operator brings to a slot: asked when it is first needed, once for all slots or once
/// for each.
class SlotValues
{
public:
    SlotValues(const ChangeRequest& request, bool eachApart)
        : m_shares(request), m_eachApart(eachApart)
    {
    }

    [[nodiscard]] const OperatorResult& of(std::size_t slot)
    {
        auto& asked = m_values[m_eachApart ? slot : 0];
        if (!asked) {
            asked = m_shares.of(DrawPurpose::Colour, m_eachApart ? slot + 1 : 0);
        }
        return *asked;
    }

private:
    OperatorShares m_shares;
    bool m_eachApart;
    std::array<std::optional<OperatorResult>, kMaxTintSlots> m_values;
};

} // namespace

ChangeResult ColourSettings::change(const ChangeRequest& request)
{
    const Scene& scene = request.edit.scene();
    const BrushSettings& brush = request.settings;
    const auto& settings = brush.as<ColourSettings>();
    const auto templates = scene.population.column(columns::templateId);
    SlotValues values(request, settings.eachSlotApart);
    const auto replaced = scene.population.column(columns::tintReplaces);
    std::array<ColumnChange<Tint>, kMaxTintSlots> changes;
    ColumnChange<std::uint16_t> modeChange;
    bool hasSlot = false;
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        if (entry == nullptr || !entry->asset) {
            return;
        }
        const std::size_t slots = std::min<std::size_t>(entry->asset->slots.size(), kMaxTintSlots);
        const ColourSlots meant(*entry->asset, settings);
        std::uint16_t modes = replaced[row];
        for (std::size_t index = 0; index < slots; ++index) {
            if (!meant.contains(entry->asset->slots[index])) {
                continue;
            }
            hasSlot = true;
            const auto bit = static_cast<std::uint16_t>(1U << index);
            modes = static_cast<std::uint16_t>(settings.replaces ? modes | bit : modes & ~bit);
            const Tint before =
                scene.population.column(columns::tint(static_cast<int>(index)))[row];
            const Tint full = targetTint(settings, values.of(index), i);
            // Replaced cloth and dyed cloth have no colour between them.
            const bool isAlike =
                before.strength == 0 || ((replaced[row] & bit) != 0) == settings.replaces;
            const Tint target = brush.buildUp || !isAlike || settings.strength >= 1.0F
                                    ? full
                                    : tintOver(before, {full.red, full.green, full.blue},
                                               static_cast<double>(settings.strength));
            changes[index].set(id, before,
                               brush.buildUp ? steppedTint(before, target, brush.flow) : target);
        }
        modeChange.set(id, replaced[row], modes);
    });
    ChangeResult result;
    for (std::size_t index = 0; index < changes.size(); ++index) {
        changes[index].apply(request.edit, columns::tint(static_cast<int>(index)), result.changed);
    }
    modeChange.apply(request.edit, columns::tintReplaces, result.changed);
    result.reason = hasSlot ? StrokeReason::Unchanged : StrokeReason::NoSuchSlot;
    return result;
}

void ColourSettings::prepare(BrushSettings& brush)
{
    brush.selection = BrushSelection::AllInCircle;
    brush.as<ColourSettings>().sparesBody = true;
}

MainNumber ColourSettings::mainNumber(const BrushSettings& brush)
{
    return {QT_TRANSLATE_NOOP("BrushTexts", "Strength, %"),
            QT_TRANSLATE_NOOP("BrushTexts", "Strength: %1 %"),
            brush.as<ColourSettings>().strength * 100.0,
            0.0,
            100.0,
            5.0,
            0};
}

void ColourSettings::setMainNumber(BrushSettings& brush, float value)
{
    brush.as<ColourSettings>().strength = value / 100.0F;
}

} // namespace crowd::model
