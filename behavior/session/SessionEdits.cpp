// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>

#include "behavior/session/Session.h"

/// Edits of the scene while a session runs.
namespace crowd::behavior {

namespace {

/// Whether clips move people over the ground at another speed, or others do.
bool isGaitOther(const model::TemplateEntry& a, const model::TemplateEntry& b)
{
    return a.clipRoles != b.clipRoles ||
           !std::ranges::equal(a.clipSpeeds, b.clipSpeeds, [](float x, float y) {
               return x == y || (std::isnan(x) && std::isnan(y));
           });
}

bool isSameList(const std::vector<model::TemplateEntry>& a,
                const std::vector<model::TemplateEntry>& b)
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
            act(row);
        }
    }
}

} // namespace

void Session::adopt(const model::Scene& scene, bool arePosesKept)
{
    const bool areTemplatesNew = !isSameList(*m_templates, scene.templates);
    if (areTemplatesNew) {
        adoptTemplates(scene);
    }
    adoptPaths(scene);
    countGroups(scene.population);
    if (!std::ranges::equal(m_population.ids(), scene.population.ids())) {
        adoptRows(scene);
    }
    adoptValues(scene, arePosesKept, areTemplatesNew);
    m_population = scene.population;
    m_follower.setGroups(m_population.column(model::columns::group));
    m_stages = scene.stages;
    m_seats.clear(); // read anew when somebody wants one
    publishLooks();
    m_rules.setRules(scene, arePosesKept);
    m_ownNumbers = m_rules.ownNumbers();
    for (std::uint32_t agent = 0; agent < m_shown.size(); ++agent) {
        markDirty(agent);
    }
}

/// Everybody finds his own template among those that there are now.
void Session::adoptTemplates(const model::Scene& scene)
{
    const auto former = m_templates;
    readTemplates(scene);
    for (std::uint32_t agent = 0; agent < m_shown.size(); ++agent) {
        adoptTemplate(agent, *former);
    }
}

void Session::adoptTemplate(std::uint32_t agent, const std::vector<model::TemplateEntry>& former)
{
    Shown& shown = markDirty(agent);
    const model::TemplateEntry* before =
        shown.table < former.size() ? &former[shown.table] : nullptr;
    const auto now =
        std::ranges::find(*m_templates, before != nullptr ? before->id : templateOf(agent),
                          &model::TemplateEntry::id);
    shown.table = static_cast<std::uint32_t>(now - m_templates->begin());
    const bool isSame = before != nullptr && now != m_templates->end() &&
                        now->asset == before->asset && now->clipNames == before->clipNames;
    if (isSame && !isGaitOther(*before, *now)) {
        return;
    }
    shown.style = styleOf(m_population, agent, shown.table);
    shown.gait = 0;
    shown.lastGait = 0;
    shown.fromGait = 0;
    if (!isSame) { // clips are counted anew
        shown.order = -1;
        shown.base = -1;
        shown.hasLast = false;
        shown.fadeBegin = -1.0;
        forgetLook(agent, model::columns::clip.id);
    }
}

void Session::adoptPaths(const model::Scene& scene)
{
    if (m_places == scene.places && m_paths == scene.paths) {
        return;
    }
    m_places = scene.places;
    m_paths = scene.paths;
    m_warnings = m_follower.setPaths(m_places, m_paths);
    setWalls(m_places);
    warnOfWays();
}

/// People came or went.
void Session::adoptRows(const model::Scene& scene)
{
    const model::Population& people = scene.population;
    std::vector<std::uint32_t> keep(people.size(), kNoAgent);
    std::vector<Shown> shown(people.size());
    for (std::size_t row = 0; row < people.size(); ++row) {
        const std::size_t former = m_population.rowOf(people.ids()[row]);
        if (former != model::Population::npos) {
            keep[row] = static_cast<std::uint32_t>(former);
            shown[row] = m_shown[former];
        } else {
            shown[row] = shownFrom(people, row);
        }
    }
    m_shown = std::move(shown);
    m_motion.rearrange(keep);
    for (std::uint32_t row = 0; row < people.size(); ++row) {
        if (keep[row] == kNoAgent) {
            setMotion(people, row);
        }
    }
    m_sitters.clear();
    for (std::uint32_t agent = 0; agent < m_shown.size(); ++agent) {
        if (m_shown[agent].sitting == Sitting::Goes || m_shown[agent].sitting == Sitting::Settles) {
            m_sitters.push_back(agent);
        }
    }
    m_follower.rearrange(keep);
    m_rules.setPeople(people, keep);
    for (std::size_t row = 0; row < people.size(); ++row) {
        if (keep[row] == kNoAgent) {
            const PathFollower::Assignment walk = walkOf(people, row);
            if (walk.path != 0) {
                m_follower.follow(walk);
            }
        }
    }
    // From here on the former values of the rows are those of the same people.
    std::vector<model::IndividualId> gone;
    std::ranges::set_difference(m_population.ids(), people.ids(), std::back_inserter(gone));
    std::vector<model::IndividualId> come;
    std::ranges::set_difference(people.ids(), m_population.ids(), std::back_inserter(come));
    (void)m_population.remove(gone);
    m_population.add(people.rows(come));
    leaveOutWhoIsNowhere();
    addBodies(people);
}

/// What rules have set, where an edit has set it anew.
void Session::adoptLooks(const model::Population& now)
{
    namespace keys = model::columns;
    const auto each = [&](const auto& key, const auto& act) {
        forEdited(m_population, now, key, act);
    };
    each(keys::tags, [&](std::size_t row) {
        // Only those that the edit is about: rules may have changed others.
        const std::uint64_t after = now.column(keys::tags)[row];
        const std::uint64_t edited = after ^ m_population.column(keys::tags)[row];
        const auto agent = static_cast<std::uint32_t>(row);
        const std::uint64_t tags = (m_rules.tags(agent) & ~edited) | (after & edited);
        m_rules.setTags(agent, tags);
        noteTags(agent, tags);
    });
    each(keys::height, [&](std::size_t row) {
        m_shown[row].height = now.column(keys::height)[row];
        forgetLook(static_cast<std::uint32_t>(row), keys::height.id);
    });
    for (int slot = 0; slot < 8; ++slot) {
        each(keys::tint(slot), [&](std::size_t row) {
            forgetLook(static_cast<std::uint32_t>(row), keys::tint(slot).id);
        });
    }
    each(keys::clip,
         [&](std::size_t row) { forgetLook(static_cast<std::uint32_t>(row), keys::clip.id); });
    each(keys::phase,
         [&](std::size_t row) { forgetLook(static_cast<std::uint32_t>(row), keys::phase.id); });
    each(keys::playbackSpeed, [&](std::size_t row) {
        forgetLook(static_cast<std::uint32_t>(row), keys::playbackSpeed.id);
    });
}

/// Values that an edit changed since the last look at the scene.
void Session::adoptValues(const model::Scene& scene, bool arePosesKept, bool areTemplatesNew)
{
    namespace keys = model::columns;
    const model::Population& now = scene.population;
    bool areBodiesNew = areTemplatesNew;
    const auto each = [&](const auto& key, const auto& act) {
        forEdited(m_population, now, key, act);
    };
    if (!arePosesKept) {
        each(keys::position, [&](std::size_t row) {
            m_motion.put(row, now.column(keys::position)[row]);
            m_motion.speed[row] = 0.0F;
            areBodiesNew = true;
        });
        each(keys::heading,
             [&](std::size_t row) { m_motion.heading[row] = now.column(keys::heading)[row]; });
    }
    each(keys::path, [&](std::size_t row) {
        PathFollower::Assignment walk = walkOf(now, row);
        walk.from = m_motion.position(row);
        m_follower.follow(walk);
    });
    each(keys::walkSpeed, [&](std::size_t row) {
        m_follower.setPace(static_cast<std::uint32_t>(row), paceOf(now, row));
    });
    if (!arePosesKept) {
        adoptLooks(now);
    }
    each(keys::templateId, [&](std::size_t row) {
        m_shown[row].table = shownFrom(now, row).table;
        m_shown[row].style = styleOf(now, row, m_shown[row].table);
        m_shown[row].gait = 0;
        m_shown[row].order = -1;
        m_shown[row].base = -1;
        m_follower.setPace(static_cast<std::uint32_t>(row), paceOf(now, row));
        areBodiesNew = true;
    });
    each(keys::girth, [&](std::size_t) { areBodiesNew = true; });
    each(keys::walkStyle,
         [&](std::size_t row) { m_shown[row].style = styleOf(now, row, m_shown[row].table); });
    each(keys::seat, [&](std::size_t row) {
        if (!arePosesKept) {
            m_shown[row].base = -1;
            m_shown[row].sitting = Sitting::No;
        }
        m_shown[row].seat = now.column(keys::seat)[row];
    });
    if (areBodiesNew) {
        leaveOutWhoIsNowhere();
        addBodies(now);
    }
}

} // namespace crowd::behavior
