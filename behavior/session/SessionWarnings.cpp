// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include "behavior/rules/PlaceRooms.h"
#include "behavior/session/Session.h"
#include "behavior/surface/WalkSurface.h"

/// What the artist should know about places, paths and people while a session runs.
namespace crowd::behavior {

namespace {

constexpr float kSearchMetres = 30.0F;    ///< for ground near a place
constexpr float kLeastReach = 0.5F;       ///< metres around a place
constexpr float kDetourShare = 1.1F;      ///< of the straight way, from which it is one
constexpr float kDetourMetres = 1.0F;     ///< longer than the straight way
constexpr float kCrowdedPerMetre2 = 5.0F; ///< people; more do not fit
constexpr std::uint32_t kAFew = 10;

float lengthOf(const std::vector<glm::vec2>& way, glm::vec2 at)
{
    float length = 0.0F;
    for (const glm::vec2& corner : way) {
        length += glm::distance(at, corner);
        at = corner;
    }
    return length;
}

} // namespace

std::vector<Problem> Session::problems() const
{
    std::vector<Problem> problems = m_warnings;
    problems.insert(problems.end(), m_rules.problems().begin(), m_rules.problems().end());
    return problems;
}

void Session::warn(Problem problem)
{
    if (std::ranges::find(m_warnings, problem) == m_warnings.end()) {
        m_warnings.push_back(std::move(problem));
    }
}

/// As what can be walked on is now, in place of what was said of it before.
void Session::warnOfWays()
{
    std::erase_if(m_warnings, [this](const Problem& problem) {
        return std::ranges::find(m_saidOfWays, problem) != m_saidOfWays.end();
    });
    m_saidOfWays.clear();
    warnOfPlaces();
    warnOfPaths();
    warnOfPeople();
}

void Session::warnOfWay(const Problem& problem)
{
    m_saidOfWays.push_back(problem);
    warn(problem);
}

/// Places that nobody can get to.
void Session::warnOfPlaces()
{
    for (const model::Place& place : m_places) {
        const bool isOn = !m_surface || place.role != model::PlaceRole::Spot ||
                          m_surface->reaches(place.position, std::max(place.radius, kLeastReach));
        const glm::vec3 below(place.position.x, 0.0F, place.position.z);
        if (!isOn && (m_surface->reaches(place.position, kSearchMetres) ||
                      m_surface->reaches(below, kSearchMetres))) {
            warnOfWay({"Place \"" + place.name +
                           "\" is not on ground that characters can walk on; they go as near as "
                           "they can. "
                           "Move it.",
                       0, place.id});
        }
    }
}

/// Paths whose places have walls between them.
void Session::warnOfPaths()
{
    const auto placeOf = [this](model::PlaceId id) {
        const auto found = std::ranges::find(m_places, id, &model::Place::id);
        return found == m_places.end() ? nullptr : &*found;
    };
    for (const model::Path& path : m_paths) {
        const bool isRound = path.kind == model::PathKind::Cyclic;
        for (std::size_t i = 0; m_surface && i + (isRound ? 0 : 1) < path.places.size(); ++i) {
            const model::Place* from = placeOf(path.places[i]);
            const model::Place* to = placeOf(path.places[(i + 1) % path.places.size()]);
            if (from != nullptr && to != nullptr && from != to) {
                warnOfLeg(path, *from, *to);
            }
        }
    }
}

/// People who are to walk and stand where no way leads to or from.
void Session::warnOfPeople()
{
    Problem problem;
    for (std::uint32_t agent = 0; agent < m_shown.size() && m_surface; ++agent) {
        const bool isOff = m_follower.isWalking(agent) && !m_shown[agent].isGone &&
                           !isSeated(agent) && !m_surface->isWalkable(m_motion.position(agent));
        if (isOff) {
            problem.people.push_back(m_population.ids()[agent]);
        }
    }
    if (problem.people.empty()) {
        return;
    }
    problem.text = std::to_string(problem.people.size()) +
                   (problem.people.size() == 1 ? " character" : " characters") +
                   " who should walk stand where no way leads to or from: on roofs or trees, in "
                   "a basin, in the air. Put them on the nearest ground (Edit, Put on the Ground).";
    warnOfWay(problem);
}

void Session::warnOfLeg(const model::Path& path, const model::Place& from, const model::Place& to)
{
    const std::vector<glm::vec2> way = m_surface->way(from.position, to.position);
    if (way.empty()) {
        return; // it is the place that is somewhere else
    }
    const glm::vec2 start(from.position.x, from.position.z);
    const glm::vec2 end(to.position.x, to.position.z);
    const std::string between =
        "Path \"" + path.name + "\": between \"" + from.name + "\" and \"" + to.name + "\" ";
    const float straight = glm::distance(start, end);
    const float length = lengthOf(way, start);
    if (glm::distance(way.back(), end) > std::max(to.radius, kLeastReach)) {
        warnOfWay({between +
                       "no way leads; characters go as near as they can. Move one of them, or lead "
                       "the path around what is between.",
                   0, 0, path.id});
    } else if (way.size() > 1 && length > straight * kDetourShare &&
               length > straight + kDetourMetres) {
        warnOfWay({between +
                       "something is in the way; characters go around it. Add places where they "
                       "should go.",
                   0, 0, path.id});
    }
}

/// More people than can stand in a place are sent to it, or have come to the end of a path there.
void Session::warnOfCrowding()
{
    std::map<model::PlaceId, std::uint32_t> guests;
    for (std::uint32_t agent = 0; agent < m_shown.size(); ++agent) {
        const model::PlaceId held = m_rules.heldPlace(agent);
        const model::PlaceId place = held != 0 ? held : m_follower.endPlace(agent);
        if (place != 0 && !m_shown[agent].isGone) {
            ++guests[place];
        }
    }
    for (const auto& [id, count] : guests) {
        const auto place = std::ranges::find(m_places, id, &model::Place::id);
        if (place == m_places.end() || place->role == model::PlaceRole::Exit) {
            continue;
        }
        const float area = 3.14159265F * place->radius * place->radius;
        const bool isKnown = std::ranges::any_of(m_warnings, [id = id](const Problem& problem) {
            return problem.place == id && problem.text.find("characters want") != std::string::npos;
        });
        if (!isKnown && static_cast<float>(count) > area * kCrowdedPerMetre2 + kAFew) {
            warn({"Place \"" + place->name + "\": " + std::to_string(count) +
                      " characters want to stand there, " + std::to_string(model::roomOf(*place)) +
                      " have room. Make it larger, or send them to several places.",
                  0, id});
        }
    }
}

/// Whoever has no position stays out of it: one that is not a number would spread to all others.
void Session::leaveOutWhoIsNowhere()
{
    std::size_t lost = 0;
    for (std::uint32_t agent = 0; agent < m_shown.size(); ++agent) {
        if (!model::Bounds::isPlace(m_motion.position(agent)) ||
            !std::isfinite(m_motion.heading[agent])) {
            m_motion.put(agent, {0.0F, kGoneHeight, 0.0F});
            m_motion.heading[agent] = 0.0F;
            activate(agent).isGone = true;
            ++lost;
        }
    }
    if (lost > 0) {
        warn({"Characters without a position, left out: " + std::to_string(lost) +
              ". Delete them, or give them one."});
    }
}

} // namespace crowd::behavior
