// SPDX-License-Identifier: MIT
#include "widgets/tools/PickDrag.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QCoreApplication>
#include <QtGui/QColor>

#include "model/base/Color.h"
#include "model/brush/SlotChoice.h"
#include "model/brush/TakenFrom.h"
#include "model/template/SlotColour.h"

namespace crowd::widgets {

using model::BrushKind;
using model::BrushSettings;
using model::PaintColor;

namespace {

struct PickDragText
{
    Q_DECLARE_TR_FUNCTIONS(BrushTool)
};

PaintColor paintOf(const glm::vec3& linear)
{
    PaintColor color{};
    for (int c = 0; c < 3; ++c) {
        const float encoded = model::srgbFromLinear(std::clamp(linear[c], 0.0F, 1.0F));
        color[static_cast<std::size_t>(c)] =
            static_cast<std::uint8_t>(std::lround(encoded * 255.0F));
    }
    return color;
}

/// The colour that one sees. Of what is dyed, as clothes are, were its cloth white, so that
/// painting with it makes others alike: the tint as far as it covers; without one the colour of the
/// material.
PaintColor colorOf(const model::Population& people, std::size_t row, const model::Template& asset,
                   int slot)
{
    const model::Slot& worn = asset.slots[static_cast<std::size_t>(slot)];
    const auto& choices = people.column(model::columns::materialChoices)[row];
    std::size_t choice = slot < 8 ? choices[static_cast<std::size_t>(slot)] : 0;
    choice = choice < worn.choices.size() ? choice : 0;
    const glm::vec3 base = model::slotColour(asset, static_cast<std::size_t>(slot), choice);
    if (slot < model::kMaxTintSlots && worn.tintable) {
        const model::Tint tint = people.column(model::columns::tint(slot))[row];
        const bool isReplaced =
            ((people.column(model::columns::tintReplaces)[row] >> slot) & 1) != 0;
        const glm::vec3 under = isReplaced ? base : glm::vec3(1.0F);
        const glm::vec3 over =
            model::linearFromSrgb(glm::vec3(tint.red, tint.green, tint.blue) * (1.0F / 255.0F));
        const bool isDyed = !model::isOfTheBody(worn.name) || isReplaced; // hair is no cloth
        if (tint.strength == 255 && isDyed) {
            return {tint.red, tint.green, tint.blue};
        }
        if (tint.strength > 0) {
            const glm::vec3 dye = glm::mix(under, over, static_cast<float>(tint.strength) / 255.0F);
            return paintOf(isDyed ? dye : base * dye);
        }
    }
    return paintOf(base);
}

/// The slot that the colour brush is set to when the person has it, else the one that was hit.
int slotMeant(const BrushSettings& brush, const model::Template& asset, int hitSlot)
{
    const auto* colour = brush.find<model::ColourSettings>();
    const int named =
        colour != nullptr && !colour->slot.empty() ? asset.slotIndex(colour->slot) : -1;
    const int slot = named >= 0 ? named : std::max(hitSlot, 0);
    return std::min(slot, static_cast<int>(asset.slots.size()) - 1);
}

} // namespace

std::optional<PickKind> pickOfBrush(BrushKind kind)
{
    const model::BrushType& type = model::brushType(kind);
    switch (type.info.dropper) {
    case model::Dropper::Colour:
        return PickKind::Colour;
    case model::Dropper::Point:
        return PickKind::Point;
    case model::Dropper::None:
        break;
    }
    return type.take != nullptr ? std::optional(PickKind::Person) : std::nullopt;
}

QString pickText(PickKind kind)
{
    switch (kind) {
    case PickKind::Colour:
        return PickDragText::tr("Click somebody to take the colour · Escape: not now");
    case PickKind::Point:
        return PickDragText::tr("Click the point to face · Escape: not now");
    case PickKind::Person:
        return PickDragText::tr("Click somebody to set the brush by · Escape: not now");
    }
    return {};
}

PickDrag::PickDrag(const ToolContext& context, BrushKind brush, PickKind kind,
                   const ToolInput& press)
    : m_context(context), m_before(context.state.brush(brush)), m_kind(kind), m_current(press)
{
    pick();
}

void PickDrag::pick()
{
    if (m_kind == PickKind::Point) {
        pickPoint();
    } else {
        pickFromPerson();
    }
}

void PickDrag::pickPoint()
{
    const auto& pixel = m_current.pointer;
    const auto surface = m_context.queries.picker(pixel.shownSeconds).surfaceAt(pixel.pixels());
    if (!surface) {
        return;
    }
    BrushSettings brush = m_context.state.brush(m_before.kind());
    model::HeadingSettings* heading = brush.heading();
    if (heading == nullptr) {
        return;
    }
    heading->mode = model::HeadingMode::TowardsPoint;
    heading->towardsPoint = surface->point;
    m_context.state.setBrush(brush);
}

void PickDrag::pickFromPerson()
{
    const auto& pixel = m_current.pointer;
    const auto hit = m_context.queries.picker(pixel.shownSeconds).individualAt(pixel.pixels());
    const model::Scene& scene = m_context.state.scene();
    const std::size_t row = hit ? scene.population.rowOf(hit->id) : model::Population::npos;
    const model::TemplateEntry* entry =
        hit ? scene.findTemplate(scene.population.column(model::columns::templateId)[row])
            : nullptr;
    m_isPerson = entry != nullptr && entry->asset;
    if (!m_isPerson) {
        m_label.clear();
        return;
    }
    BrushSettings brush = m_context.state.brush(m_before.kind());
    if (m_kind == PickKind::Person) {
        m_label = QString::fromStdString(
            model::brushType(brush.kind()).take(brush, {scene, *entry, hit->id, row}));
        m_context.state.setBrush(brush);
    } else {
        const int slot = slotMeant(brush, *entry->asset, hit->slot);
        const PaintColor color = colorOf(scene.population, row, *entry->asset, slot);
        m_label = QStringLiteral("%1  %2").arg(
            QString::fromStdString(entry->asset->slots[static_cast<std::size_t>(slot)].name),
            QColor(color[0], color[1], color[2]).name());
        m_context.state.offerColor(color);
    }
}

void PickDrag::update(const ToolInput& input)
{
    m_current = input;
    pick();
}

void PickDrag::release(const ToolInput& input)
{
    update(input);
    m_context.state.setPicking(Picking::None);
    if (m_label.isEmpty() && m_kind != PickKind::Point) {
        m_context.state.refuse(m_isPerson ? PickDragText::tr("Nothing to take there for this brush")
                                          : PickDragText::tr("Nobody under the cursor"));
    } else if (!m_label.isEmpty()) {
        const auto* create = m_before.find<model::CreateSettings>();
        const bool areOthersLeft = create != nullptr && create->mix.size() > 1;
        m_context.state.showStatus(
            areOthersLeft
                ? PickDragText::tr("Taken: %1. The other characters are not ticked any more.")
                      .arg(m_label)
                : PickDragText::tr("Taken: %1").arg(m_label));
    }
}

void PickDrag::cancel()
{
    m_context.state.setBrush(m_before);
    m_context.state.setPicking(Picking::None);
}

void PickDrag::show(ToolPicture& picture) const
{
    picture.cursor = Qt::CrossCursor;
    picture.symbolAt = m_current.position();
    picture.label = m_label;
    if (m_kind == PickKind::Point) {
        picture.crosshair = m_current.position();
    }
}

} // namespace crowd::widgets
