// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "behavior/agents/TemplateTables.h"
#include "behavior/session/SessionPose.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// People of a take as copies of other templates: where they are, what they do. Looks go over as
/// the template brush has them go over, clips by their names; who moves does so with a gait of the
/// other template that has a like speed, at a pace at which feet do not slide. One thread.
class SwappedPeople
{
public:
    /// `people`: ascending ids. Each becomes a copy of one of the templates, always of the same;
    /// who is not in the scene, and templates that are not there, are passed over.
    SwappedPeople(const model::Scene& scene, std::span<const model::IndividualId> people,
                  std::span<const int> templates);

    /// They are like these now. False: they were already.
    bool setPeople(const model::Population& people);
    /// In the pose, but for those who are swapped already; all are from then on.
    void apply(SessionPose& pose, std::set<model::IndividualId>& swapped);

private:
    struct Person
    {
        model::IndividualId id = 0;
        std::uint32_t before = 0; ///< tables of his templates
        std::uint32_t after = 0;
        float height = 1.0F;
        bool isSeated = false; ///< in the scene
    };
    /// A clip in another template.
    struct Other
    {
        ClipPlace clip{};
        const GaitTable::Gait* from = nullptr; ///< null: he does not move with it
        const GaitTable::Gait* to = nullptr;
    };
    void gather();
    using Clip = std::tuple<std::uint32_t, std::uint32_t, std::uint16_t, bool>;

    [[nodiscard]] const Other& otherOf(const Person& person, std::uint16_t clip, bool isSeated);
    [[nodiscard]] ClipPlace converted(const Person& person, const ClipPlace& clip, bool isSeated);
    void swapClip(SessionPose& pose, std::size_t row, const Person& person);
    void putLooks(SessionPose& pose, std::span<const model::IndividualId> ids);
    [[nodiscard]] model::IndividualRows looks(const SessionPose& pose,
                                              std::span<const model::IndividualId> ids) const;

    model::Scene m_templates;       ///< nothing else of the scene
    model::Population m_population; ///< of the scene
    TemplateTables m_tables;
    std::vector<model::IndividualId> m_wanted; ///< ascending
    std::vector<std::uint32_t> m_targets;      ///< tables
    std::vector<Person> m_people;              ///< ascending
    std::map<Clip, Other> m_others;
    /// What was put together last, and of what.
    std::vector<model::IndividualId> m_ids;
    std::shared_ptr<const OverrideColumns> m_overrides;
    std::shared_ptr<const OverrideColumns> m_recalled;
    std::shared_ptr<const OverrideColumns> m_made;
};

} // namespace crowd::behavior
