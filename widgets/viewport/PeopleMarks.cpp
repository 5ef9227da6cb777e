// SPDX-License-Identifier: MIT
#include "widgets/viewport/PeopleMarks.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include "model/brush/FeatureBrush.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/FeatureTexts.h"

namespace crowd::widgets {

namespace {

constexpr std::size_t kTags = 64;
constexpr float kRingRadius = 0.42F; ///< metres: a little more than a person takes
constexpr float kRingInner = 0.66F;  ///< share of the radius
constexpr float kLeastPixels = 4.0F; ///< seen from far away
constexpr float kFiredRadius = 0.26F;
constexpr glm::vec4 kFiredColor{1.0F, 0.86F, 0.2F, 0.9F};

glm::vec4 ringColor(const QColor& color)
{
    return {color.redF(), color.greenF(), color.blueF(), 0.95F};
}

render::Marker ringAt(const glm::vec3& position, const glm::vec4& color)
{
    render::Marker ring{position, kRingRadius, color};
    ring.innerShare = kRingInner;
    ring.leastPixels = kLeastPixels;
    return ring;
}

QColor labelColor(const model::PaintColor& color)
{
    return {color[0], color[1], color[2]};
}

} // namespace

bool showsTags(const EditorState& state)
{
    return state.viewOptions().showTags || state.tool() == ToolId::BrushTag ||
           state.tool() == ToolId::BrushUntag;
}

void PeopleMarks::addRing(const glm::vec3& position, std::uint64_t tags,
                          std::span<const glm::vec4> colors)
{
    const float part = 1.0F / static_cast<float>(std::popcount(tags));
    float from = 0.0F;
    for (; tags != 0; tags &= tags - 1) {
        render::Marker ring =
            ringAt(position, colors[static_cast<std::size_t>(std::countr_zero(tags))]);
        ring.fromTurn = from;
        ring.toTurn = from + part;
        m_markers.push_back(ring);
        from += part;
    }
}

void PeopleMarks::addTags(const EditorState& state, const model::CrowdFrame& frame)
{
    const model::Population& people = frame.population;
    const auto positions = people.column(model::columns::position);
    std::array<glm::vec4, kTags> colors{};
    for (std::size_t bit = 0; bit < kTags; ++bit) {
        colors[bit] = ringColor(tagColor(state.scene(), static_cast<int>(bit)));
    }
    std::uint64_t worn = 0;
    const auto tags = people.column(model::columns::tags);
    const auto groups = people.column(model::columns::group);
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (tags[row] != 0 && !model::isAmong(frame.hiddenGroups, groups[row])) {
            addRing(positions[row], tags[row], colors);
            worn |= tags[row];
        }
    }
    for (; worn != 0; worn &= worn - 1) {
        const int bit = std::countr_zero(worn);
        m_legend.push_back({tagText(state.scene(), bit), tagColor(state.scene(), bit)});
    }
}

/// A ring for each whose entry of `worn` is the id of a label, in its colour.
template<class Id>
void PeopleMarks::addRings(const model::CrowdFrame& frame, std::span<const Id> worn,
                           std::span<const RingLabel> labels)
{
    const auto positions = frame.population.column(model::columns::position);
    const auto groups = frame.population.column(model::columns::group);
    std::vector<bool> isSeen(labels.size());
    for (std::size_t row = 0; row < worn.size(); ++row) {
        if (worn[row] == 0 || model::isAmong(frame.hiddenGroups, groups[row])) {
            continue;
        }
        const auto label = std::ranges::find(labels, std::uint32_t{worn[row]}, &RingLabel::id);
        if (label != labels.end()) {
            m_markers.push_back(ringAt(positions[row], ringColor(label->shown.color)));
            isSeen[static_cast<std::size_t>(label - labels.begin())] = true;
        }
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (isSeen[i]) {
            m_legend.push_back(labels[i].shown);
        }
    }
}

void PeopleMarks::addOfBrush(const EditorState& state, const model::CrowdFrame& frame)
{
    const model::BrushSettings* brush = state.activeBrush();
    const model::FeatureSettings* settings =
        brush != nullptr ? model::featureSettings(*brush) : nullptr;
    std::vector<RingLabel> labels;
    if (brush != nullptr && brush->kind() == model::BrushKind::Group) {
        for (const model::Group& group : state.scene().groups) {
            labels.push_back(
                {group.id, {QString::fromStdString(group.name), labelColor(group.color)}});
        }
        addRings(frame, frame.population.column(model::columns::group), labels);
    } else if (settings != nullptr) {
        const model::FeatureKind* kind =
            model::findKind(state.scene().features, std::string_view(settings->kind));
        if (kind != nullptr) {
            for (const model::FeatureValue& value : kind->values) {
                labels.push_back({value.id, {featureText(value.name), labelColor(value.color)}});
            }
            addRings(frame, frame.population.column(model::columns::feature(kind->id)), labels);
        }
    }
}

void PeopleMarks::make(const EditorState& state, const model::CrowdFrame& frame)
{
    m_markers.clear();
    m_legend.clear();
    const model::Population& people = frame.population;
    const auto positions = people.column(model::columns::position);
    if (showsTags(state)) {
        addTags(state, frame);
    }
    addOfBrush(state, frame);
    for (const model::IndividualId id : state.session().lit()) {
        const std::size_t row = people.rowOf(id);
        if (row != model::Population::npos) {
            m_markers.push_back({positions[row], kFiredRadius, kFiredColor});
        }
    }
}

void PeopleMarks::add(std::span<const render::Marker> others)
{
    m_markers.insert(m_markers.end(), others.begin(), others.end());
}

} // namespace crowd::widgets
