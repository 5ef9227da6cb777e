// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>

#include "model/brush/ColumnWriting.h"
#include "model/rules/RuleNames.h"

namespace crowd::model {

namespace {

ChangeResult changeTags(const ChangeRequest& request, std::uint8_t tag, bool isGiven)
{
    const auto tags = request.edit.scene().population.column(columns::tags);
    const std::uint64_t bit = std::uint64_t{1} << tag;
    ColumnChange<std::uint64_t> change;
    forEachRow(request, [&](std::size_t /*i*/, std::size_t row, IndividualId id) {
        change.set(id, tags[row], isGiven ? tags[row] | bit : tags[row] & ~bit);
    });
    ChangeResult result;
    change.apply(request.edit, columns::tags, result.changed);
    result.reason = StrokeReason::Unchanged;
    return result;
}

} // namespace

ChangeResult TagSettings::change(const ChangeRequest& request)
{
    return changeTags(request, request.settings.tag()->tag, true);
}

ChangeResult UntagSettings::change(const ChangeRequest& request)
{
    return changeTags(request, request.settings.tag()->tag, false);
}

MainNumber TagSettings::mainNumber(const BrushSettings& brush)
{
    return {QT_TRANSLATE_NOOP("BrushTexts", "Tag"),
            QT_TRANSLATE_NOOP("BrushTexts", "Tag: %1"),
            brush.tag()->tag + 1.0,
            1.0,
            kTagCount,
            1.0,
            0};
}

void TagSettings::setMainNumber(BrushSettings& brush, float value)
{
    const auto tag = static_cast<std::uint8_t>(std::lround(value) - 1);
    if (auto* given = brush.find<TagSettings>()) {
        given->tag = tag;
    } else if (auto* taken = brush.find<UntagSettings>()) {
        taken->tag = tag;
    }
}

std::string TagSettings::take(BrushSettings& brush, const TakenFrom& from)
{
    const std::uint64_t tags = from.value(columns::tags);
    if (tags == 0) {
        return {};
    }
    const int tag = std::countr_zero(tags);
    setMainNumber(brush, static_cast<float>(tag + 1));
    const auto named = std::ranges::find(
        from.scene.tags, tag, [](const TagName& each) { return static_cast<int>(each.bit); });
    return named != from.scene.tags.end() ? named->name : "#" + std::to_string(tag + 1);
}

} // namespace crowd::model
