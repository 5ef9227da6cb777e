// SPDX-License-Identifier: MIT
#include "model/brush/PropertyChange.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/Random.h"
#include "model/brush/ClipChoice.h"
#include "model/brush/SlotChoice.h"
#include "model/scene/NearestPath.h"

namespace crowd::model {

namespace {

/// Values of one column that differ from today's, in ascending order of id.
template<class T>
class ColumnChange
{
public:
    void set(IndividualId id, const T& before, const T& after)
    {
        if (!(before == after)) {
            m_ids.push_back(id);
            m_values.push_back(after);
        }
    }
    void apply(SceneEdit& edit, ColumnKey<T> key, std::vector<IndividualId>& changed) const
    {
        edit.setColumn(key, m_ids, std::span<const T>(m_values));
        std::vector<IndividualId> all;
        std::ranges::set_union(changed, m_ids, std::back_inserter(all));
        changed = std::move(all);
    }

private:
    std::vector<IndividualId> m_ids;
    std::vector<T> m_values;
};

/// The share, 0..1, at which the operator puts an individual.
class Shares
{
public:
    explicit Shares(const ChangeRequest& request)
        : m_request(request),
          m_shown(request.shown != nullptr ? *request.shown : request.edit.scene().population)
    {
    }

    [[nodiscard]] double at(std::size_t row, IndividualId id, DrawPurpose purpose,
                            std::uint64_t extra = 0) const
    {
        switch (m_request.settings.op) {
        case BrushOperator::Uniform:
            return 0.0;
        case BrushOperator::Random:
            return drawn(id, purpose, extra);
        case BrushOperator::Gradient:
            if (const auto foot = m_request.view.project(positionOf(row, id))) {
                return gradientShare(m_request.line, {foot->x, foot->y});
            }
            return 0.0;
        }
        return 0.0;
    }
    [[nodiscard]] double drawn(IndividualId id, DrawPurpose purpose, std::uint64_t extra) const
    {
        return m_request.settings.distribution.sample(
            randomUnit(hashKeys(m_request.seed, id), purpose, extra));
    }

    /// Where somebody is seen.
    [[nodiscard]] glm::vec3 positionOf(std::size_t row, IndividualId id) const
    {
        const std::size_t shownRow = m_request.shown != nullptr ? m_shown.rowOf(id) : row;
        return m_shown.column(columns::position)[shownRow];
    }

private:
    const ChangeRequest& m_request;
    const Population& m_shown;
};

/// Calls visit(row, id) for each of the request's individuals.
template<class Visit>
void forEachRow(const ChangeRequest& request, Visit&& visit)
{
    const Population& people = request.edit.scene().population;
    for (const IndividualId id : request.ids) {
        visit(people.rowOf(id), id);
    }
}

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

Tint targetTint(const BrushSettings& settings, double share)
{
    const std::vector<PaintColor>& colors = settings.colour.colors;
    const bool picksOne = settings.op == BrushOperator::Random && !settings.colour.blends;
    PaintColor color{255, 255, 255};
    if (!colors.empty()) {
        const auto picked = static_cast<std::size_t>(share * static_cast<double>(colors.size()));
        color = picksOne ? colors[std::min(picked, colors.size() - 1)] : colorAlong(colors, share);
    }
    return {color[0], color[1], color[2], mixedByte(0.0, 255.0, settings.colour.strength)};
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

ChangeResult changeColours(const ChangeRequest& request)
{
    const Scene& scene = request.edit.scene();
    const BrushSettings& settings = request.settings;
    const auto templates = scene.population.column(columns::templateId);
    const Shares shares(request);
    const auto replaced = scene.population.column(columns::tintReplaces);
    std::array<ColumnChange<Tint>, kMaxTintSlots> changes;
    ColumnChange<std::uint16_t> modeChange;
    bool hasSlot = false;
    forEachRow(request, [&](std::size_t row, IndividualId id) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        if (entry == nullptr || !entry->asset) {
            return;
        }
        const std::size_t slots = std::min<std::size_t>(entry->asset->slots.size(), kMaxTintSlots);
        const ColourSlots meant(*entry->asset, settings.colour);
        std::uint16_t modes = replaced[row];
        for (std::size_t slot = 0; slot < slots; ++slot) {
            if (!meant.contains(entry->asset->slots[slot])) {
                continue;
            }
            hasSlot = true;
            const auto bit = static_cast<std::uint16_t>(1U << slot);
            modes =
                static_cast<std::uint16_t>(settings.colour.replaces ? modes | bit : modes & ~bit);
            const double share = shares.at(row, id, DrawPurpose::Colour,
                                           settings.colour.eachSlotApart ? slot + 1 : 0);
            const Tint before = scene.population.column(columns::tint(static_cast<int>(slot)))[row];
            const Tint target = targetTint(settings, share);
            changes[slot].set(
                id, before, settings.buildUp ? steppedTint(before, target, settings.flow) : target);
        }
        modeChange.set(id, replaced[row], modes);
    });
    ChangeResult result;
    for (std::size_t slot = 0; slot < changes.size(); ++slot) {
        changes[slot].apply(request.edit, columns::tint(static_cast<int>(slot)), result.changed);
    }
    modeChange.apply(request.edit, columns::tintReplaces, result.changed);
    result.reason = hasSlot ? StrokeReason::AlreadyThisColour : StrokeReason::NoSuchSlot;
    return result;
}

/// Heading with which the operator lets somebody face.
std::optional<float> targetHeading(const ChangeRequest& request, const Shares& shares,
                                   IndividualId id, const glm::vec3& position)
{
    HeadingSettings heading = request.settings.orientation.heading;
    if (request.settings.op == BrushOperator::Gradient) {
        return request.strokeHeading;
    }
    const double u = shares.drawn(id, DrawPurpose::Heading, 0);
    const auto base = headingFor(heading, request.view, position, request.strokeHeading, u);
    if (!base || request.settings.op != BrushOperator::Random ||
        heading.mode == HeadingMode::Random) {
        return base;
    }
    heading.mode = HeadingMode::Random;
    heading.headingRadians = *base;
    return headingFor(heading, request.view, position, std::nullopt, u);
}

ChangeResult changeHeadings(const ChangeRequest& request)
{
    const Population& people = request.edit.scene().population;
    const auto headings = people.column(columns::heading);
    const auto positions = people.column(columns::position);
    const Shares shares(request);
    ColumnChange<float> change;
    bool hasTarget = false;
    forEachRow(request, [&](std::size_t row, IndividualId id) {
        auto target = targetHeading(request, shares, id, positions[row]);
        hasTarget = hasTarget || target;
        if (target && request.settings.buildUp) {
            const float way = wrappedAngle(*target - headings[row]);
            *target = wrappedAngle(headings[row] + way * request.settings.flow);
        }
        change.set(id, headings[row], target.value_or(headings[row]));
    });
    ChangeResult result;
    change.apply(request.edit, columns::heading, result.changed);
    result.reason = hasTarget ? StrokeReason::AlreadyThisHeading : StrokeReason::NoDirection;
    return result;
}

float inRange(const ValueRange& range, double share)
{
    return range.low + (range.high - range.low) * static_cast<float>(share);
}

ChangeResult changeAnimations(const ChangeRequest& request)
{
    const Scene& scene = request.edit.scene();
    const Population& people = scene.population;
    const AnimationSettings& settings = request.settings.animation;
    const auto templates = people.column(columns::templateId);
    const auto clips = people.column(columns::clip);
    const auto phases = people.column(columns::phase);
    const auto speeds = people.column(columns::playbackSpeed);
    const Shares shares(request);
    ColumnChange<std::uint16_t> clipChange;
    ColumnChange<float> phaseChange;
    ColumnChange<float> speedChange;
    bool hasValue = settings.setsPhase || settings.setsSpeed;
    forEachRow(request, [&](std::size_t row, IndividualId id) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        if (entry != nullptr) {
            const auto chosen =
                chosenClip(*entry, settings.clips, shares.at(row, id, DrawPurpose::Clip));
            hasValue = hasValue || chosen;
            clipChange.set(id, clips[row], chosen.value_or(clips[row]));
        }
        if (settings.setsPhase) {
            phaseChange.set(id, phases[row],
                            inRange(settings.phase, shares.at(row, id, DrawPurpose::Phase)));
        }
        if (settings.setsSpeed) {
            speedChange.set(id, speeds[row],
                            inRange(settings.speed, shares.at(row, id, DrawPurpose::Speed)));
        }
    });
    ChangeResult result;
    clipChange.apply(request.edit, columns::clip, result.changed);
    phaseChange.apply(request.edit, columns::phase, result.changed);
    speedChange.apply(request.edit, columns::playbackSpeed, result.changed);
    const StrokeReason missing =
        settings.clips.empty() ? StrokeReason::NothingChosen : StrokeReason::NoSuchClip;
    result.reason = hasValue ? StrokeReason::AlreadyThisAnimation : missing;
    return result;
}

ChangeResult changeWalks(const ChangeRequest& request)
{
    const Population& people = request.edit.scene().population;
    const WalkSettings& settings = request.settings.walk;
    const auto paths = people.column(columns::path);
    const auto speeds = people.column(columns::walkSpeed);
    const Shares shares(request);
    ColumnChange<PathId> pathChange;
    ColumnChange<float> speedChange;
    const bool isNearest = settings.path == kNearestPath;
    const std::optional<NearestPath> nearest =
        isNearest ? std::optional<NearestPath>(request.edit.scene()) : std::nullopt;
    const bool isThere = settings.path == 0 || (isNearest && !request.edit.scene().paths.empty()) ||
                         request.edit.scene().findPath(settings.path) != nullptr;
    forEachRow(request, [&](std::size_t row, IndividualId id) {
        if (settings.setsPath && isThere) {
            pathChange.set(id, paths[row],
                           nearest ? nearest->at(shares.positionOf(row, id)) : settings.path);
        }
        if (settings.setsSpeed) {
            // Nobody walks like his neighbour: the operator decides only how evenly.
            const double share = request.settings.op == BrushOperator::Gradient
                                     ? shares.at(row, id, DrawPurpose::Speed)
                                     : shares.drawn(id, DrawPurpose::Speed, 1);
            speedChange.set(id, speeds[row], inRange(settings.speed, share));
        }
    });
    ChangeResult result;
    pathChange.apply(request.edit, columns::path, result.changed);
    speedChange.apply(request.edit, columns::walkSpeed, result.changed);
    const bool setsAnything = (settings.setsPath && isThere) || settings.setsSpeed;
    result.reason = setsAnything ? StrokeReason::AlreadyThisWalk : StrokeReason::NothingChosen;
    return result;
}

/// Whether somebody can walk with a clip, as the clip column counts.
bool isToWalkWith(const TemplateEntry& entry, std::uint16_t clip)
{
    const int index = entry.asset ? entry.asset->clipIndex(entry.clipNames[clip]) : -1;
    return index >= 0 && movesOverGround(entry, clip, static_cast<std::size_t>(index));
}

ChangeResult changeStyles(const ChangeRequest& request)
{
    const Scene& scene = request.edit.scene();
    const Population& people = scene.population;
    const StyleSettings& settings = request.settings.style;
    const auto templates = people.column(columns::templateId);
    const auto styles = people.column(columns::walkStyle);
    const auto speeds = people.column(columns::walkSpeed);
    const Shares shares(request);
    // Nobody walks like his neighbour: the operator decides only how evenly.
    const auto shareOf = [&](std::size_t row, IndividualId id, DrawPurpose purpose) {
        return request.settings.op == BrushOperator::Gradient ? shares.at(row, id, purpose)
                                                              : shares.drawn(id, purpose, 2);
    };
    ColumnChange<std::uint16_t> styleChange;
    ColumnChange<float> speedChange;
    bool hasValue = settings.setsSpeed || (settings.setsStyle && settings.clips.empty());
    forEachRow(request, [&](std::size_t row, IndividualId id) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        if (settings.setsStyle && settings.clips.empty()) {
            styleChange.set(id, styles[row], 0);
        } else if (settings.setsStyle && entry != nullptr) {
            const auto chosen =
                chosenClip(*entry, settings.clips, shareOf(row, id, DrawPurpose::Clip));
            if (chosen && isToWalkWith(*entry, *chosen)) {
                hasValue = true;
                styleChange.set(id, styles[row], static_cast<std::uint16_t>(*chosen + 1));
            }
        }
        if (settings.setsSpeed) {
            speedChange.set(id, speeds[row],
                            inRange(settings.speed, shareOf(row, id, DrawPurpose::Speed)));
        }
    });
    ChangeResult result;
    styleChange.apply(request.edit, columns::walkStyle, result.changed);
    speedChange.apply(request.edit, columns::walkSpeed, result.changed);
    const StrokeReason missing =
        settings.setsStyle ? StrokeReason::NoSuchClip : StrokeReason::NothingChosen;
    result.reason = hasValue ? StrokeReason::AlreadyThisWalk : missing;
    return result;
}

ChangeResult changeTags(const ChangeRequest& request)
{
    const auto tags = request.edit.scene().population.column(columns::tags);
    const std::uint64_t bit = std::uint64_t{1} << request.settings.tag.tag;
    const bool isUntag = request.settings.kind == BrushKind::Untag;
    ColumnChange<std::uint64_t> change;
    forEachRow(request, [&](std::size_t row, IndividualId id) {
        change.set(id, tags[row], isUntag ? tags[row] & ~bit : tags[row] | bit);
    });
    ChangeResult result;
    change.apply(request.edit, columns::tags, result.changed);
    result.reason = isUntag ? StrokeReason::WithoutThisTag : StrokeReason::AlreadyThisTag;
    return result;
}

} // namespace

ChangeResult changeProperties(const ChangeRequest& request)
{
    ChangeResult result;
    switch (request.settings.kind) {
    case BrushKind::Colour:
        result = changeColours(request);
        break;
    case BrushKind::Orientation:
        result = changeHeadings(request);
        break;
    case BrushKind::Animation:
        result = changeAnimations(request);
        break;
    case BrushKind::Walk:
        result = changeWalks(request);
        break;
    case BrushKind::Style:
        result = changeStyles(request);
        break;
    case BrushKind::Tag:
    case BrushKind::Untag:
        result = changeTags(request);
        break;
    case BrushKind::Create:
    case BrushKind::Delete:
    case BrushKind::Event:
    case BrushKind::Path:
    case BrushKind::Environment:
    case BrushKind::Script:
        break;
    }
    if (!result.changed.empty()) {
        result.reason = StrokeReason::None;
    }
    return result;
}

} // namespace crowd::model
