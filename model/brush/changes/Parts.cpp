// SPDX-License-Identifier: MIT
#include "model/brush/ColumnWriting.h"

namespace crowd::model {

namespace {

/// Bits of the parts that are meant; 0: the template has none of them.
std::uint32_t partBits(const Template& asset, const std::string& part)
{
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < asset.parts.size(); ++i) {
        if (part.empty() || asset.parts[i].name == part) {
            bits |= std::uint32_t{1} << i;
        }
    }
    return bits;
}

} // namespace

ChangeResult PartsSettings::change(const ChangeRequest& request)
{
    const auto& settings = request.settings.as<PartsSettings>();
    const Scene& scene = request.edit.scene();
    const auto templates = scene.population.column(columns::templateId);
    const auto parts = scene.population.column(columns::parts);
    const auto draws = OperatorShares(request).of(BrushOperator::Random, "parts.share").shares;
    ColumnChange<std::uint32_t> change;
    bool hasPart = false;
    forEachRow(request, [&](std::size_t i, std::size_t row, IndividualId id) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        const std::uint32_t bits =
            entry != nullptr && entry->asset ? partBits(*entry->asset, settings.part) : 0;
        hasPart = hasPart || bits != 0;
        if (draws[i] * 100.0 < static_cast<double>(settings.percent)) {
            change.set(id, parts[row], settings.isShown ? parts[row] | bits : parts[row] & ~bits);
        }
    });
    ChangeResult result;
    change.apply(request.edit, columns::parts, result.changed);
    result.reason = hasPart ? StrokeReason::Unchanged : StrokeReason::NoSuchPart;
    return result;
}

} // namespace crowd::model
