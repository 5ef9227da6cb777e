// SPDX-License-Identifier: MIT
#include "behavior/session/SceneAdoption.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace crowd::behavior {

namespace {

namespace adoptedKeys = model::columns;
using Entries = TemplateTables::Entries;

/// Whether clips move people over the ground at another speed, or others do.
bool isGaitOther(const model::TemplateEntry& a, const model::TemplateEntry& b)
{
    return a.clipRoles != b.clipRoles ||
           !std::ranges::equal(a.clipSpeeds, b.clipSpeeds, [](float x, float y) {
               return x == y || (std::isnan(x) && std::isnan(y));
           });
}

bool isSameList(const Entries& a, const Entries& b)
{
    return std::ranges::equal(a, b, [](const auto& left, const auto& right) {
        return left.id == right.id && left.asset == right.asset &&
               left.clipNames == right.clipNames && !isGaitOther(left, right);
    });
}

/// Rows in which two versions of the same people differ.
template<class T, class Act>
void forEdited(const model::Population& before, const model::Population& now,
               model::ColumnKey<T> key, const Act& act)
{
    if (now.columnBytes(key.id).data() == before.columnBytes(key.id).data()) {
        return; // shared: nobody wrote
    }
    const auto former = before.column(key);
    const auto after = now.column(key);
    for (std::size_t row = 0; row < after.size(); ++row) {
        if (!(former[row] == after[row])) {
            act(static_cast<std::uint32_t>(row));
        }
    }
}

/// One adoption: the parts, and the scene as it is now.
class Adoption
{
public:
    Adoption(SessionParts& parts, const model::Scene& scene, const model::Population& people,
             bool arePosesKept)
        : m_parts(parts), m_scene(scene), m_now(people), m_arePosesKept(arePosesKept)
    {
    }
    void run();

private:
    void adoptTemplates();
    void adoptTemplate(std::uint32_t agent, const Entries& former);
    void adoptPaths();
    void adoptRows();
    void replaceRows();
    void adoptPositions();
    void adoptWalks();
    void adoptOverridden();
    void adoptTraits();
    void adoptFeatures();
    void adoptTags(std::uint32_t agent);
    /// The scene's value counts again where an edit has set it anew.
    void forgetOverrides(model::ColumnId column);
    template<class T, class Act>
    void forEach(model::ColumnKey<T> key, const Act& act) const
    {
        forEdited(m_parts.population, m_now, key, act);
    }

    SessionParts& m_parts;
    const model::Scene& m_scene;
    const model::Population& m_now;
    bool m_arePosesKept;
    bool m_areBodiesNew = false;
};

void Adoption::run()
{
    if (!isSameList(*m_parts.templates.entries(), m_scene.templates)) {
        adoptTemplates();
        m_areBodiesNew = true;
    }
    adoptPaths();
    m_parts.walkers.setParties(m_scene.parties());
    if (!std::ranges::equal(m_parts.population.ids(), m_now.ids())) {
        adoptRows();
    }
    if (!m_arePosesKept) {
        adoptPositions();
    }
    adoptWalks();
    if (!m_arePosesKept) {
        adoptOverridden();
    }
    adoptTraits();
    adoptFeatures();
    if (m_areBodiesNew) {
        m_parts.resetBodies(m_now);
    }
    m_parts.population = m_now;
    m_parts.adoptGroups(m_scene);
    m_parts.companions.read(m_scene);
    m_parts.seating.setStages(m_scene.stages);
    m_parts.shownOverrides = m_parts.overrides.publish();
    m_parts.rules.setRules(m_scene, m_arePosesKept);
    m_parts.shownNumbers = m_parts.rules.ownNumbers();
    for (std::uint32_t agent = 0; agent < m_parts.agents.size(); ++agent) {
        m_parts.agents.markDirty(agent);
    }
}

/// Everybody finds the own template among those that there are now.
void Adoption::adoptTemplates()
{
    const auto former = m_parts.templates.entries();
    m_parts.templates.read(m_scene.templates);
    for (std::uint32_t agent = 0; agent < m_parts.agents.size(); ++agent) {
        adoptTemplate(agent, *former);
    }
}

void Adoption::adoptTemplate(std::uint32_t agent, const Entries& former)
{
    m_parts.agents.markDirty(agent);
    std::uint32_t& table = m_parts.agents.table[agent];
    const model::Population& people = m_parts.population;
    const model::TemplateEntry* before = table < former.size() ? &former[table] : nullptr;
    table = m_parts.templates.indexOf(
        before != nullptr ? before->id : people.column(adoptedKeys::templateId)[agent]);
    const model::TemplateEntry* now = m_parts.templates.entry(table);
    const bool isSame = before != nullptr && now != nullptr && now->asset == before->asset &&
                        now->clipNames == before->clipNames;
    if (isSame && !isGaitOther(*before, *now)) {
        return;
    }
    m_parts.animation.setStyle(
        agent, m_parts.templates.gaitOfStyle(table, people.column(adoptedKeys::walkStyle)[agent]));
    m_parts.animation.forgetGaits(agent);
    if (!isSame) { // clips are counted anew
        m_parts.animation.endClip(agent);
        m_parts.animation.cut(agent);
        m_parts.idle.reset(agent);
        m_parts.idle.forget(agent, adoptedKeys::clip.id);
    }
}

void Adoption::adoptPaths()
{
    if (m_parts.places == m_scene.places && m_parts.paths == m_scene.paths) {
        return;
    }
    m_parts.places = m_scene.places;
    m_parts.paths = m_scene.paths;
    m_parts.problems.replace(m_parts.follower.setPaths(m_parts.places, m_parts.paths));
    m_parts.resetWalls();
    m_parts.checkWays();
}

/// People came or went.
void Adoption::adoptRows()
{
    std::vector<std::uint32_t> keep(m_now.size(), kNoAgent);
    for (std::size_t row = 0; row < m_now.size(); ++row) {
        const std::size_t former = m_parts.population.rowOf(m_now.ids()[row]);
        if (former != model::Population::npos) {
            keep[row] = static_cast<std::uint32_t>(former);
        }
    }
    m_parts.agents.rearrange(keep);
    m_parts.idle.rearrange(keep);
    m_parts.animation.rearrange(keep);
    m_parts.seating.rearrange(keep);
    m_parts.follower.rearrange(keep);
    m_parts.rules.setPeople(m_now, keep);
    for (std::uint32_t row = 0; row < m_now.size(); ++row) {
        if (keep[row] != kNoAgent) {
            continue;
        }
        m_parts.initAgent(m_now, row);
        const PathFollower::Assignment walk = m_parts.walkers.assignmentOf(m_now, row);
        if (walk.path != 0) {
            m_parts.follower.follow(walk);
        }
    }
    replaceRows();
    m_parts.resetBodies(m_now);
}

/// From here on the former values of the rows are those of the same people.
void Adoption::replaceRows()
{
    model::Population& before = m_parts.population;
    std::vector<model::IndividualId> gone;
    std::ranges::set_difference(before.ids(), m_now.ids(), std::back_inserter(gone));
    std::vector<model::IndividualId> come;
    std::ranges::set_difference(m_now.ids(), before.ids(), std::back_inserter(come));
    (void)before.remove(gone);
    before.add(m_now.rows(come));
}

void Adoption::adoptPositions()
{
    MotionState& motion = m_parts.agents.motion;
    forEach(adoptedKeys::position, [&](std::uint32_t agent) {
        motion.put(agent, m_now.column(adoptedKeys::position)[agent]);
        motion.speed[agent] = 0.0F;
        m_areBodiesNew = true;
    });
    forEach(adoptedKeys::heading, [&](std::uint32_t agent) {
        motion.heading[agent] = m_now.column(adoptedKeys::heading)[agent];
    });
}

void Adoption::adoptWalks()
{
    forEach(adoptedKeys::path, [&](std::uint32_t agent) {
        PathFollower::Assignment walk = m_parts.walkers.assignmentOf(m_now, agent);
        walk.from = m_parts.agents.motion.position(agent);
        m_parts.follower.follow(walk);
    });
    forEach(adoptedKeys::walkSpeed, [&](std::uint32_t agent) {
        m_parts.follower.setPace(agent, m_parts.walkers.paceOf(m_now, agent));
    });
}

/// Rules may have changed other tags than those that the edit is about.
void Adoption::adoptTags(std::uint32_t agent)
{
    const std::uint64_t after = m_now.column(adoptedKeys::tags)[agent];
    const std::uint64_t edited = after ^ m_parts.population.column(adoptedKeys::tags)[agent];
    const std::uint64_t tags = (m_parts.rules.tags(agent) & ~edited) | (after & edited);
    m_parts.rules.setTags(agent, tags);
    m_parts.overrides.set(adoptedKeys::tags, m_now.ids()[agent], tags);
}

void Adoption::forgetOverrides(model::ColumnId column)
{
    const auto before = m_parts.population.columnBytes(column);
    const auto after = m_now.columnBytes(column);
    if (before.data() == after.data()) {
        return; // shared: nobody wrote
    }
    const std::size_t stride = model::columnInfo(column).stride;
    for (std::uint32_t agent = 0; agent < m_parts.agents.size(); ++agent) {
        const std::size_t at = agent * stride;
        if (std::memcmp(before.data() + at, after.data() + at, stride) != 0) {
            m_parts.idle.forget(agent, column);
        }
    }
}

/// Properties that rules may have set, whichever they are.
void Adoption::adoptOverridden()
{
    forEach(adoptedKeys::tags, [&](std::uint32_t agent) { adoptTags(agent); });
    forEach(adoptedKeys::height, [&](std::uint32_t agent) {
        m_parts.agents.height[agent] = m_now.column(adoptedKeys::height)[agent];
    });
    for (std::size_t column = 0; column < model::kColumnCount; ++column) {
        if (static_cast<model::ColumnId>(column) != adoptedKeys::tags.id) {
            forgetOverrides(static_cast<model::ColumnId>(column));
        }
    }
}

void Adoption::adoptTraits()
{
    const auto setStyle = [&](std::uint32_t agent) {
        m_parts.animation.setStyle(
            agent, m_parts.templates.gaitOfStyle(m_parts.agents.table[agent],
                                                 m_now.column(adoptedKeys::walkStyle)[agent]));
    };
    forEach(adoptedKeys::templateId, [&](std::uint32_t agent) {
        m_parts.agents.table[agent] =
            m_parts.templates.indexOf(m_now.column(adoptedKeys::templateId)[agent]);
        setStyle(agent);
        m_parts.animation.stand(agent);
        m_parts.animation.endClip(agent);
        m_parts.idle.reset(agent);
        m_parts.follower.setPace(agent, m_parts.walkers.paceOf(m_now, agent));
        m_areBodiesNew = true;
    });
    forEach(adoptedKeys::girth, [&](std::uint32_t) { m_areBodiesNew = true; });
    forEach(adoptedKeys::walkStyle, setStyle);
    forEach(adoptedKeys::seat, [&](std::uint32_t agent) {
        if (!m_arePosesKept) {
            m_parts.idle.reset(agent);
        }
        m_parts.seating.setSeat(agent, m_now.column(adoptedKeys::seat)[agent], m_arePosesKept);
    });
}

/// What else they do has come with them.
void Adoption::adoptFeatures()
{
    for (std::uint8_t kind = 1; kind <= model::kMostFeatureKinds; ++kind) {
        const auto key = adoptedKeys::feature(kind);
        forEach(key, [&](std::uint32_t agent) {
            m_parts.rules.noteFeature(agent, m_now.column(key)[agent]);
        });
    }
}

} // namespace

void adoptPeople(SessionParts& parts, const model::Scene& scene, const model::Population& people,
                 bool arePosesKept)
{
    parts.fades.forgetEdited(parts.population, people);
    Adoption(parts, scene, people, arePosesKept).run();
}

void adoptScene(SessionParts& parts, const model::Scene& scene, bool arePosesKept)
{
    parts.recalled.forgetEdited(parts.lastScene.population, scene.population);
    adoptPeople(parts, scene, parts.recalled.over(scene.population), arePosesKept);
    if (parts.lastScene.timeline != scene.timeline) {
        parts.marks.read(scene.timeline);
    }
    parts.lastScene = scene;
}

} // namespace crowd::behavior
