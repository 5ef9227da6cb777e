// SPDX-License-Identifier: MIT
#include "behavior/takes/Retake.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "behavior/agents/TemplateTables.h"
#include "behavior/session/MotionReader.h"
#include "behavior/session/PoseKeeping.h"
#include "behavior/session/Session.h"
#include "behavior/takes/EditedTake.h"
#include "behavior/takes/TakeComposition.h"
#include "model/base/Random.h"
#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"

namespace crowd::behavior {

namespace {

using model::Error;
using model::Result;

constexpr double kPartOfStep = 0.5;
constexpr double kHomeShare = 0.4;    ///< of a stretch, in which people walk back
constexpr double kHomeSeconds = 6.0;  ///< at most
constexpr double kBlendShare = 0.2;   ///< of a stretch, at its end
constexpr double kBlendSeconds = 1.0; ///< at most
constexpr float kFastestHome = 2.2F;  ///< m/s: they hurry, but do not run
constexpr float kDetours = 1.25F;     ///< times the straight way
constexpr float kAtHome = 0.05F;      ///< metres

/// The take's steps that are one after the other, and how long each is.
struct Steps
{
    double first = 0.0;
    std::uint32_t perSecond = 30;
};

Result<Steps> stepsOf(MotionReader& reader)
{
    const MotionCache::Extent extent = reader.cache().extent();
    const auto [first, next] = reader.around(extent.first);
    if (!first || !next) {
        return Error{damagedTake()};
    }
    const double length = next->seconds - first->seconds;
    for (const std::uint32_t rate : model::kStepRates) {
        if (std::abs(length * rate - 1.0) < 1e-3) {
            return Steps{extent.first, rate};
        }
    }
    return Error{
        QT_TRANSLATE_NOOP("Messages", "The take is too short to take a part of it again.")};
}

/// Everybody else, as bodies.
class Others
{
public:
    Others(const model::Scene& scene, const std::vector<model::IndividualId>& people)
    {
        TemplateTables tables;
        tables.read(scene.templates);
        const model::Population& all = scene.population;
        const auto templates = all.column(model::columns::templateId);
        const auto girths = all.column(model::columns::girth);
        const auto places = all.column(model::columns::position);
        for (std::size_t row = 0; row < all.size(); ++row) {
            if (std::ranges::binary_search(people, all.ids()[row])) {
                continue;
            }
            AgentState& body = m_bodies.emplace_back();
            m_ids.push_back(all.ids()[row]);
            body.position = {places[row].x, places[row].z};
            body.groundHeight = places[row].y;
            body.radius = tables.footprint(tables.indexOf(templates[row])).radius * girths[row];
        }
    }
    /// On their way from one step of the take to the next.
    [[nodiscard]] std::span<const AgentState> at(const SessionPose& now, const SessionPose& next);

private:
    std::vector<model::IndividualId> m_ids; ///< ascending
    std::vector<AgentState> m_bodies;
    std::vector<AgentState> m_there; ///< those who have not left
};

std::span<const AgentState> Others::at(const SessionPose& now, const SessionPose& next)
{
    const double seconds = next.seconds - now.seconds;
    const float perSecond = seconds > 0.0 ? static_cast<float>(1.0 / seconds) : 0.0F;
    const bool isSame = now.ids == next.ids;
    std::size_t row = 0;
    m_there.clear();
    for (std::size_t i = 0; i < m_ids.size(); ++i) {
        while (row < now.ids.size() && now.ids[row] < m_ids[i]) {
            ++row;
        }
        if (row == now.ids.size() || now.ids[row] != m_ids[i]) {
            m_there.push_back(m_bodies[i]); // stays where the scene has him
            continue;
        }
        if ((now.flags[row] & kPoseGone) != 0) {
            continue;
        }
        const glm::vec2 here(now.x[row], now.z[row]);
        m_bodies[i].position = here;
        m_bodies[i].groundHeight = now.y[row];
        m_bodies[i].velocity =
            isSame ? (glm::vec2(next.x[row], next.z[row]) - here) * perSecond : glm::vec2(0.0F);
        m_there.push_back(m_bodies[i]);
    }
    return m_there;
}

/// The scene of those people alone, as they were seen at that moment.
model::Scene sceneOf(const model::Scene& scene, const RetakeWish& wish, const SessionPosePtr& begin,
                     std::uint32_t stepsPerSecond)
{
    model::SceneDocument scratch;
    scratch.replaceScene(scene, {});
    model::CrowdFrame shown{
        scene.population,
        std::make_shared<const std::vector<model::TemplateEntry>>(scene.templates), begin->seconds};
    applyPose(*begin, *begin, shown);
    scratch.edit(QString(), [&](model::SceneEdit& edit) {
        (void)keepPose(edit, shown.population, begin.get());
        std::vector<model::IndividualId> others;
        const auto all = scene.population.ids();
        std::ranges::set_difference(all, wish.people, std::back_inserter(others));
        edit.removeIndividuals(others);
        edit.setStepsPerSecond(stepsPerSecond);
    });
    model::Scene alone = scratch.scene();
    if (wish.seed != 0) {
        alone.seed = static_cast<std::uint32_t>(
            model::mixBits(alone.seed ^ (std::uint64_t{wish.seed} << 32U)));
    }
    return alone;
}

/// Where people of a session have to be at the end, and how they get there.
class WayHome
{
public:
    WayHome(const model::Population& people, const SessionPose& end) : m_homes(people.size())
    {
        for (std::size_t row = 0; row < people.size(); ++row) {
            const auto found = std::ranges::lower_bound(end.ids, people.ids()[row]);
            const bool isThere = found != end.ids.end() && *found == people.ids()[row];
            const auto i = static_cast<std::size_t>(found - end.ids.begin());
            if (isThere && (end.flags[i] & kPoseGone) == 0) {
                m_homes[row] = Home{{end.x[i], end.z[i]}};
            }
        }
    }
    /// `left`: seconds until then. They set out so many seconds before, earlier where it is far.
    void steer(CrowdSimulation& crowd, double left, double before) const
    {
        const std::span<Body> bodies = crowd.bodies();
        for (std::size_t row = 0; row < m_homes.size(); ++row) {
            if (!m_homes[row]) {
                continue;
            }
            const Home& home = *m_homes[row];
            const float metres = glm::distance(home.place, {bodies[row].x, bodies[row].z});
            if (left <= std::max(before, static_cast<double>(kDetours * metres / kFastestHome))) {
                steer(bodies[row], home.place, static_cast<float>(std::max(left, 0.1)));
            }
        }
    }
    [[nodiscard]] float furthest(const CrowdSimulation& crowd) const
    {
        float most = 0.0F;
        for (std::size_t row = 0; row < m_homes.size(); ++row) {
            const Body& body = crowd.bodies()[row];
            if (m_homes[row]) {
                most = std::max(most, glm::distance(m_homes[row]->place, {body.x, body.z}));
            }
        }
        return most;
    }

private:
    struct Home
    {
        glm::vec2 place{0.0F};
    };

    static void steer(Body& body, const glm::vec2& home, float left)
    {
        const glm::vec2 way = home - glm::vec2(body.x, body.z);
        const float metres = glm::length(way);
        if (metres < kAtHome) {
            body.desiredX = 0.0F;
            body.desiredZ = 0.0F;
            body.preferredSpeed = 0.0F;
            return;
        }
        const float speed = std::min(metres / left, kFastestHome);
        body.desiredX = way.x / metres * speed;
        body.desiredZ = way.y / metres * speed;
        body.preferredSpeed = speed;
    }

    std::vector<std::optional<Home>> m_homes; ///< by row; nothing: he has none
};

float smooth(double share)
{
    const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
    return s * s * (3.0F - 2.0F * s);
}

/// One retake, step by step.
class Retaking
{
public:
    Retaking(const model::Scene& scene, std::shared_ptr<MotionCache> take, const RetakeWish& wish,
             const TakeProgress& progress)
        : m_scene(scene), m_take(std::move(take)), m_wish(wish), m_progress(progress),
          m_reader(m_take)
    {
    }
    [[nodiscard]] Result<Retaken> run(const std::shared_ptr<const WalkSurface>& surface);

private:
    [[nodiscard]] Result<void> check();
    [[nodiscard]] SessionPosePtr at(double seconds);
    void begin(const std::shared_ptr<const WalkSurface>& surface);
    [[nodiscard]] SessionPosePtr next(const SessionPosePtr& take);
    [[nodiscard]] std::optional<Error> addPiece(std::size_t piece, double first, double last);
    [[nodiscard]] bool isWithin(double seconds) const
    {
        return seconds > m_wish.begin + kPartOfStep * m_step &&
               seconds < m_wish.end + kPartOfStep * m_step;
    }

    const model::Scene& m_scene;
    std::shared_ptr<MotionCache> m_take;
    RetakeWish m_wish; ///< at steps of the take, of people who are there
    const TakeProgress& m_progress;
    MotionReader m_reader;
    Steps m_steps;
    double m_step = 0.0; ///< seconds of one
    bool m_returns = false;
    model::Scene m_alone;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<Others> m_others;
    std::unique_ptr<EditedTake> m_edited; ///< where they are seen
    std::unique_ptr<TakeComposition> m_composition;
    std::unique_ptr<WayHome> m_home; ///< null: it goes on to the take's end
    SessionPosePtr m_before;         ///< the take's step that the session has come to
    SessionPosePtr m_last;           ///< the session's
    Retaken m_result;
};

SessionPosePtr Retaking::at(double seconds)
{
    return m_reader.around(seconds + kPartOfStep * m_step).first;
}

/// People, times at steps.
Result<void> Retaking::check()
{
    const auto steps = stepsOf(m_reader);
    if (!steps) {
        return steps.error();
    }
    m_steps = steps.value();
    m_step = 1.0 / m_steps.perSecond;
    const auto ids = m_scene.population.ids();
    std::vector<model::IndividualId> there;
    std::ranges::set_intersection(m_wish.people, ids, std::back_inserter(there));
    m_wish.people = std::move(there);
    if (m_wish.people.empty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "Nobody is chosen who could be taken again.")};
    }
    const double last = m_take->extent().last;
    const auto atStep = [this, last](double seconds) {
        const double within = std::clamp(seconds, m_steps.first, last) - m_steps.first;
        return m_steps.first + std::round(within * m_steps.perSecond) * m_step;
    };
    if (!std::isfinite(m_wish.begin) || !std::isfinite(m_wish.end)) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "A stretch of time has a beginning and an end.")};
    }
    m_wish.begin = atStep(m_wish.begin);
    m_wish.end = atStep(m_wish.end);
    m_returns = m_wish.end + kPartOfStep * m_step < last;
    if (m_wish.end < m_wish.begin + kPartOfStep * m_step) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "The stretch that is to be taken again lies outside the "
                                       "take, or is empty. Choose another one on the timeline.")};
    }
    return {};
}

void Retaking::begin(const std::shared_ptr<const WalkSurface>& surface)
{
    m_before = at(m_wish.begin);
    const SessionPosePtr earlier = at(std::max(m_steps.first, m_wish.begin - m_step));
    m_alone = sceneOf(m_scene, m_wish, m_before, m_steps.perSecond);
    m_session = std::make_unique<Session>(m_alone);
    m_session->setStart(m_wish.begin);
    if (surface) {
        m_session->setSurface(surface);
    }
    m_session->crowd().setLevels(true);
    m_session->beginAs(*earlier, *m_before);
    m_others = std::make_unique<Others>(m_scene, m_wish.people);
    m_edited = std::make_unique<EditedTake>(m_take, m_wish.edits, m_scene);
    m_composition = std::make_unique<TakeComposition>(m_wish.people, m_before, m_scene.population);
    m_result.people = m_alone.population.size();
    if (!m_returns) {
        return;
    }
    m_home = std::make_unique<WayHome>(m_alone.population, *at(m_wish.end));
    const double home = std::min(kHomeSeconds, kHomeShare * (m_wish.end - m_wish.begin));
    m_session->setSteering([this, home](CrowdSimulation& crowd) {
        m_home->steer(crowd, m_wish.end - m_session->seconds(), home);
    });
}

/// The next step of the stretch, which is at the time of that one of the take.
SessionPosePtr Retaking::next(const SessionPosePtr& take)
{
    const SessionPosePtr here = m_edited->edited(m_before);
    m_session->crowd().setPuppets(m_others->at(*here, *m_edited->edited(take)));
    m_session->step();
    ++m_result.steps;
    m_last = m_session->pose();
    m_before = take;
    const double blend = std::min(kBlendSeconds, kBlendShare * (m_wish.end - m_wish.begin));
    const double left = m_wish.end - take->seconds;
    if (m_home && left < kPartOfStep * m_step) {
        m_result.furthestFromHome = m_home->furthest(m_session->crowd());
    }
    return m_composition->composed(take, *m_last, m_home ? smooth(1.0 - left / blend) : 0.0F);
}

/// Nothing: done.
std::optional<Error> Retaking::addPiece(std::size_t piece, double first, double last)
{
    const bool isBefore = last < m_wish.begin + kPartOfStep * m_step;
    if (isBefore || first > m_wish.end + kFadeSeconds + m_step) {
        return m_result.motion->addPiece(*m_take, piece) ? std::nullopt
                                                         : std::optional(Error{damagedTake()});
    }
    const auto count = static_cast<std::uint64_t>(std::llround((last - first) / m_step)) + 1;
    for (std::uint64_t i = 0; i < count; ++i) {
        const SessionPosePtr take = at(first + static_cast<double>(i) * m_step);
        if (!take) {
            return Error{damagedTake()};
        }
        if (isWithin(take->seconds)) {
            m_result.motion->add(next(take));
        } else if (m_last && take->seconds > m_wish.end) {
            m_result.motion->add(m_composition->fadedIn(take, *m_last));
        } else {
            m_result.motion->add(take);
        }
    }
    return std::nullopt;
}

Result<Retaken> Retaking::run(const std::shared_ptr<const WalkSurface>& surface)
{
    if (const auto checked = check(); !checked) {
        return checked.error();
    }
    begin(surface);
    m_result.motion = std::make_shared<MotionCache>();
    const auto pieces = m_take->pieces();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (m_progress &&
            !m_progress(static_cast<double>(i) / static_cast<double>(pieces.size()))) {
            return Error{QT_TRANSLATE_NOOP("Messages", "Cancelled.")};
        }
        if (auto error = addPiece(i, pieces[i].first, pieces[i].second)) {
            return *error;
        }
    }
    return std::move(m_result);
}

} // namespace

Result<Retaken> retake(const model::Scene& scene, const std::shared_ptr<MotionCache>& take,
                       const RetakeWish& wish, const std::shared_ptr<const WalkSurface>& surface,
                       const TakeProgress& progress)
{
    return Retaking(scene, take, wish, progress).run(surface);
}

} // namespace crowd::behavior
