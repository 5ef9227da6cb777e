// SPDX-License-Identifier: MIT
#include "model/features/FeatureWriting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "model/base/Random.h"
#include "model/base/WeightedDraw.h"
#include "model/brush/ClipChoice.h"
#include "model/features/FeatureLook.h"

namespace crowd::model {

namespace {

/// Values of a column that differ from today's.
template<class T>
class Writing
{
public:
    Writing(const Population& people, ColumnKey<T> key) : m_key(key), m_now(people.column(key)) {}

    [[nodiscard]] const T& now(std::size_t row) const { return m_now[row]; }
    void set(IndividualId id, std::size_t row, const T& value)
    {
        if (!(m_now[row] == value)) {
            m_ids.push_back(id);
            m_values.push_back(value);
        }
    }
    void addTo(std::vector<ChangedColumn>& all) const
    {
        if (!m_ids.empty()) {
            const auto bytes = std::as_bytes(std::span(m_values));
            all.push_back({m_key.id, m_ids, {bytes.begin(), bytes.end()}});
        }
    }

private:
    ColumnKey<T> m_key;
    std::span<const T> m_now;
    std::vector<IndividualId> m_ids;
    std::vector<T> m_values;
};

/// What draws of one individual are for.
class Draws
{
public:
    explicit Draws(std::uint64_t key) : m_key(key) {}
    [[nodiscard]] double of(std::string_view purpose, std::uint64_t extra = 0) const
    {
        return unitDouble(hashKeys(m_key, hashText(purpose), extra));
    }
    [[nodiscard]] float in(const ValueRange& range, const DistributionCurve& curve,
                           std::string_view purpose) const
    {
        return range.low + (range.high - range.low) * static_cast<float>(curve.sample(of(purpose)));
    }

private:
    std::uint64_t m_key;
};

template<std::size_t... Slots>
std::array<Writing<Tint>, sizeof...(Slots)> tintsOf(const Population& people,
                                                    std::index_sequence<Slots...> /*slots*/)
{
    return {Writing<Tint>(people, columns::tint(static_cast<int>(Slots)))...};
}

/// All that bearing values changes.
class Wearing
{
public:
    Wearing(const Scene& scene, const FeatureKind& kind)
        : m_scene(scene), m_kind(kind), m_templates(scene.population.column(columns::templateId)),
          m_seats(scene.population.column(columns::seat)),
          m_borne(scene.population, columns::feature(kind.id)),
          m_clip(scene.population, columns::clip), m_phase(scene.population, columns::phase),
          m_speed(scene.population, columns::playbackSpeed),
          m_style(scene.population, columns::walkStyle),
          m_walkSpeed(scene.population, columns::walkSpeed),
          m_height(scene.population, columns::height), m_girth(scene.population, columns::girth),
          m_choices(scene.population, columns::materialChoices),
          m_parts(scene.population, columns::parts),
          m_modes(scene.population, columns::tintReplaces),
          m_tints(tintsOf(scene.population, std::make_index_sequence<kMaxTintSlots>()))
    {
    }

    /// Null: none of the kind.
    void wear(IndividualId id, std::size_t row, const FeatureValue* value, std::uint64_t seed)
    {
        if (value == nullptr) {
            takeOff(id, row);
        } else if (const FeatureLook* look = lookOf(*value, m_templates[row])) {
            m_borne.set(id, row, value->id);
            const Draws draws(hashKeys(seed, id, value->id));
            move(id, row, *look, draws);
            dress(id, row, *look, draws);
        }
    }

    [[nodiscard]] std::vector<ChangedColumn> changes() const
    {
        std::vector<ChangedColumn> all;
        m_borne.addTo(all);
        m_clip.addTo(all);
        m_phase.addTo(all);
        m_speed.addTo(all);
        m_style.addTo(all);
        m_walkSpeed.addTo(all);
        m_height.addTo(all);
        m_girth.addTo(all);
        m_choices.addTo(all);
        m_parts.addTo(all);
        m_modes.addTo(all);
        for (const Writing<Tint>& tint : m_tints) {
            tint.addTo(all);
        }
        return all;
    }

private:
    /// Null: the value is not for them.
    const FeatureLook* lookOf(const FeatureValue& value, TemplateId id)
    {
        if (m_last != nullptr && m_lastOf == std::pair(value.id, id)) {
            return m_last;
        }
        m_lastOf = {value.id, id};
        auto& look = m_looks[m_lastOf];
        if (!look) {
            static const TemplateEntry kNone;
            const TemplateEntry* entry = m_scene.findTemplate(id);
            look.emplace(value, entry != nullptr ? *entry : kNone);
        }
        m_last = look->isMeant ? &*look : nullptr;
        return m_last;
    }

    /// What the value has done to somebody is as his template has it again.
    void takeOff(IndividualId id, std::size_t row)
    {
        const auto worn = std::ranges::find(m_kind.values, m_borne.now(row), &FeatureValue::id);
        m_borne.set(id, row, 0);
        const FeatureLook* look =
            worn != m_kind.values.end() ? lookOf(*worn, m_templates[row]) : nullptr;
        const TemplateEntry* entry = m_scene.findTemplate(m_templates[row]);
        if (look != nullptr && entry != nullptr && entry->asset) {
            rest(id, row, *look, *entry);
            undress(id, row, *look, *entry->asset);
        }
    }

    template<class T>
    void reset(Writing<T>& writing, IndividualId id, std::size_t row, ColumnKey<T> key)
    {
        writing.set(id, row, m_usual.column(key)[0]);
    }

    void rest(IndividualId id, std::size_t row, const FeatureLook& look, const TemplateEntry& entry)
    {
        const bool isSeated = m_seats[row] != kNoSeat;
        if (!(isSeated ? look.seated : look.standing).empty()) {
            m_clip.set(id, row, usualClip(entry, isSeated));
        }
        if (!look.walking.empty()) {
            reset(m_style, id, row, columns::walkStyle);
        }
        if (look.value.setsSpeed) {
            reset(m_speed, id, row, columns::playbackSpeed);
        }
        if (look.value.setsWalkSpeed) {
            reset(m_walkSpeed, id, row, columns::walkSpeed);
        }
        if (look.value.setsHeight) {
            reset(m_height, id, row, columns::height);
        }
        if (look.value.setsGirth) {
            reset(m_girth, id, row, columns::girth);
        }
    }

    void undress(IndividualId id, std::size_t row, const FeatureLook& look, const Template& asset)
    {
        std::uint16_t modes = m_modes.now(row);
        MaterialChoices choices = m_choices.now(row);
        for (std::size_t slot = 0; slot < look.slots.size(); ++slot) {
            if (!look.slots[slot].materials.empty()) {
                choices[slot] = 0;
            }
            if (look.slots[slot].colors != nullptr) {
                modes = static_cast<std::uint16_t>(modes & ~(1U << slot));
                reset(m_tints[slot], id, row, columns::tint(static_cast<int>(slot)));
            }
        }
        m_modes.set(id, row, modes);
        m_choices.set(id, row, choices);
        const std::uint32_t touched = look.shownParts | look.hiddenParts;
        m_parts.set(id, row, (m_parts.now(row) & ~touched) | (defaultParts(asset) & touched));
    }

    void move(IndividualId id, std::size_t row, const FeatureLook& look, const Draws& draws)
    {
        const FeatureValue& value = look.value;
        const auto& clips = m_seats[row] != kNoSeat ? look.seated : look.standing;
        if (!clips.empty()) {
            m_clip.set(id, row, pickedAt(clips, draws.of("clip")));
        }
        if (!look.walking.empty()) {
            m_style.set(id, row, pickedAt(look.walking, draws.of("style")));
        }
        if (value.setsPhase) {
            m_phase.set(id, row, draws.in(value.phase, value.phaseCurve, "phase"));
        }
        if (value.setsSpeed) {
            m_speed.set(id, row, draws.in(value.speed, value.speedCurve, "speed"));
        }
        if (value.setsWalkSpeed) {
            m_walkSpeed.set(id, row, draws.in(value.walkSpeed, value.walkSpeedCurve, "walk"));
        }
        if (value.setsHeight) {
            m_height.set(id, row, draws.in(value.height, value.heightCurve, "height"));
        }
        if (value.setsGirth) {
            m_girth.set(id, row, draws.in(value.girth, value.girthCurve, "girth"));
        }
    }

    void dress(IndividualId id, std::size_t row, const FeatureLook& look, const Draws& draws)
    {
        std::uint16_t modes = m_modes.now(row);
        MaterialChoices choices = m_choices.now(row);
        for (std::size_t slot = 0; slot < look.slots.size(); ++slot) {
            const FeatureLook::SlotLook& worn = look.slots[slot];
            if (!worn.materials.empty()) {
                choices[slot] =
                    static_cast<std::uint8_t>(pickedAt(worn.materials, draws.of("material", slot)));
            }
            if (worn.colors == nullptr) {
                continue;
            }
            const auto bit = static_cast<std::uint16_t>(1U << slot);
            modes = static_cast<std::uint16_t>(worn.colors->replaces ? modes | bit : modes & ~bit);
            const auto& colors = worn.colors->colors;
            const auto drawn = static_cast<std::size_t>(draws.of("colour", slot) *
                                                        static_cast<double>(colors.size()));
            const PaintColor& color = colors[std::min(drawn, colors.size() - 1)];
            m_tints[slot].set(
                id, row,
                {color[0], color[1], color[2],
                 static_cast<std::uint8_t>(std::floor(worn.colors->strength * 255.0F + 0.5F))});
        }
        m_modes.set(id, row, modes);
        m_choices.set(id, row, choices);
        m_parts.set(id, row, (m_parts.now(row) | look.shownParts) & ~look.hiddenParts);
    }

    const Scene& m_scene;
    const FeatureKind& m_kind;
    const IndividualRows m_usual = IndividualRows::withDefaults({1}); ///< somebody new
    std::span<const TemplateId> m_templates;
    std::span<const SeatId> m_seats;
    Writing<FeatureId> m_borne;
    Writing<std::uint16_t> m_clip;
    Writing<float> m_phase;
    Writing<float> m_speed;
    Writing<std::uint16_t> m_style;
    Writing<float> m_walkSpeed;
    Writing<float> m_height;
    Writing<float> m_girth;
    Writing<MaterialChoices> m_choices;
    Writing<std::uint32_t> m_parts;
    Writing<std::uint16_t> m_modes;
    std::array<Writing<Tint>, kMaxTintSlots> m_tints;
    std::map<std::pair<FeatureId, TemplateId>, std::optional<FeatureLook>> m_looks;
    std::pair<FeatureId, TemplateId> m_lastOf;
    const FeatureLook* m_last = nullptr;
};

/// Does the same to its bearers, whatever it is called.
bool doesTheSame(const FeatureValue& a, const FeatureValue& b)
{
    FeatureValue other = b;
    other.name = a.name;
    other.color = a.color;
    return a == other;
}

} // namespace

std::vector<ChangedColumn> featureChanges(const Scene& scene, const FeatureKind& kind,
                                          std::span<const IndividualId> ids,
                                          std::span<const FeatureId> wanted, std::uint64_t seed)
{
    Wearing wearing(scene, kind);
    for (std::size_t i = 0; i < ids.size(); ++i) {
        const auto value = std::ranges::find(kind.values, wanted[i], &FeatureValue::id);
        wearing.wear(ids[i], scene.population.rowOf(ids[i]),
                     value != kind.values.end() ? &*value : nullptr, seed);
    }
    return wearing.changes();
}

std::vector<IndividualId> setFeature(SceneEdit& edit, const FeatureKind& kind,
                                     std::span<const IndividualId> ids,
                                     std::span<const FeatureId> wanted, std::uint64_t seed)
{
    std::vector<IndividualId> changed;
    for (const ChangedColumn& each : featureChanges(edit.scene(), kind, ids, wanted, seed)) {
        edit.setColumn(each.column, each.ids, each.bytes);
        std::vector<IndividualId> all;
        std::ranges::set_union(changed, each.ids, std::back_inserter(all));
        changed = std::move(all);
    }
    return changed;
}

std::vector<FeatureId> drawnFeatures(std::span<const WeightedFeature> mix,
                                     std::span<const IndividualId> ids, std::uint64_t seed)
{
    std::vector<FeatureId> drawn;
    drawn.reserve(ids.size());
    for (const IndividualId id : ids) {
        const float share = unitFloat(hashKeys(seed, id, hashText("feature")));
        drawn.push_back(mix.empty()
                            ? FeatureId{0}
                            : mix[weightedIndex(mix, share, [](const WeightedFeature& each) {
                                  return each.weight;
                              })].id);
    }
    return drawn;
}

std::vector<IndividualId> bearersOf(const Scene& scene, FeatureId value)
{
    const FeatureKind* kind = kindOf(scene.features, value);
    return kind == nullptr ? std::vector<IndividualId>()
                           : peopleWith(scene.population, columns::feature(kind->id), value);
}

FeatureId freeFeatureId(const Scene& scene)
{
    constexpr std::uint32_t kMost = 0xFFFF;
    std::uint32_t highest = 0;
    for (std::uint8_t kind = 1; kind <= kMostFeatureKinds; ++kind) {
        for (const FeatureId borne : scene.population.column(columns::feature(kind))) {
            highest = std::max<std::uint32_t>(highest, borne);
        }
    }
    for (const FeatureKind& kind : scene.features) {
        for (const FeatureValue& value : kind.values) {
            highest = std::max<std::uint32_t>(highest, value.id);
        }
    }
    for (const Rule& rule : scene.rules) {
        for (const std::uint32_t named : idsNamedIn(rule, FieldRole::Feature)) {
            highest = named <= kMost ? std::max(highest, named) : highest;
        }
    }
    return highest < kMost ? static_cast<FeatureId>(highest + 1) : FeatureId{0};
}

std::uint8_t freeKindId(const Scene& scene)
{
    for (std::uint8_t id = 1; id <= kMostFeatureKinds; ++id) {
        const auto borne = scene.population.column(columns::feature(id));
        if (findKind(scene.features, id) == nullptr &&
            std::ranges::all_of(borne, [](FeatureId each) { return each == 0; })) {
            return id;
        }
    }
    return 0;
}

void changeFeatures(SceneEdit& edit, FeatureKinds kinds, bool isWorn)
{
    const FeatureKinds before = edit.scene().features;
    edit.setFeatures(std::move(kinds));
    const FeatureKinds& now = edit.scene().features;
    for (const FeatureKind& kind : before) {
        const FeatureKind* after = findKind(now, kind.id);
        FeatureKind bare; // where nobody knows any more what its values did
        bare.id = kind.id;
        for (const FeatureValue& value : kind.values) {
            const auto same = after != nullptr
                                  ? std::ranges::find(after->values, value.id, &FeatureValue::id)
                                  : kind.values.end();
            const bool isGone = after == nullptr || same == after->values.end();
            if (!isGone && (!isWorn || doesTheSame(value, *same))) {
                continue;
            }
            const auto bearers =
                peopleWith(edit.scene().population, columns::feature(kind.id), value.id);
            const std::vector<FeatureId> wanted(bearers.size(), isGone ? FeatureId{0} : value.id);
            (void)setFeature(edit, after != nullptr ? *after : bare, bearers, wanted,
                             edit.scene().seed);
        }
    }
}

} // namespace crowd::model
