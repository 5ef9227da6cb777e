// SPDX-License-Identifier: MIT
#include "behavior/session/SessionTimeline.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "behavior/session/Session.h"
#include "behavior/session/SessionParts.h"
#include "model/rules/MarkFlaws.h"
#include "model/states/StateKeeping.h"

namespace crowd::behavior {

namespace {

constexpr double kSameInstant = 1e-9; ///< seconds; sums of steps are not exact

using People = std::vector<model::IndividualId>;

/// One mark that happens.
class Performance
{
public:
    Performance(Session& session, SessionParts& parts, const model::Mark& mark)
        : m_session(session), m_parts(parts), m_mark(mark)
    {
    }
    void run();

private:
    void callCue(const model::Cue& cue);
    void recall(model::StateId id, const People* people, const model::RecallTiming& timing);
    [[nodiscard]] People everybody() const;
    [[nodiscard]] People ofMark() const { return {m_mark.people.begin(), m_mark.people.end()}; }

    Session& m_session;
    SessionParts& m_parts;
    const model::Mark& m_mark;
};

People Performance::everybody() const
{
    const auto ids = m_parts.population.ids();
    return {ids.begin(), ids.end()};
}

void Performance::recall(model::StateId id, const People* people, const model::RecallTiming& timing)
{
    const auto& states = m_parts.lastScene.states;
    const auto state = std::ranges::find(states, id, &model::State::id);
    if (state != states.end()) {
        (void)m_session.recall(
            {id, peopleOf(m_parts.lastScene, *state, people), state->columns, timing});
    }
}

void Performance::callCue(const model::Cue& cue)
{
    People people;
    if (!m_mark.people.empty()) {
        people = ofMark();
    } else if (cue.reach == model::CueReach::Tagged) {
        people = m_parts.tagged(cue.tag);
    } else if (cue.reach == model::CueReach::Everybody) {
        people = everybody();
    } else {
        return; // the selected are not the session's to know
    }
    if (cue.state != 0) {
        recall(cue.state, &people,
               {cue.seconds, {cue.spread, cue.order, cue.point, m_mark.headingRadians}});
    }
    if (!cue.event.empty()) {
        m_session.send(cue.event, cue.payload, people);
    }
}

void Performance::run()
{
    if (model::Message flaw = flawOf(m_parts.lastScene, m_mark); !flaw.empty()) {
        m_parts.problems.add({std::move(flaw)});
    }
    const People people = ofMark();
    if (m_mark.kind == model::MarkKind::State) {
        recall(m_mark.state, people.empty() ? nullptr : &people, m_mark.timing());
    } else if (m_mark.kind == model::MarkKind::Event) {
        m_session.send(m_mark.event, m_mark.payload, people.empty() ? everybody() : people);
    } else if (m_mark.kind == model::MarkKind::Cue) {
        const auto& cues = m_parts.lastScene.cues;
        const auto cue = std::ranges::find(cues, m_mark.cue, &model::Cue::id);
        if (cue != cues.end()) {
            callCue(*cue);
        }
    }
}

} // namespace

void DueMarks::read(const model::Timeline& timeline)
{
    model::Timeline acting;
    for (const model::Mark& mark : timeline) {
        if (model::isForPeople(mark.kind)) {
            std::ranges::move(atOneMomentEach(mark), std::back_inserter(acting));
        }
    }
    m_ahead = inOrder(std::move(acting));
}

model::Timeline DueMarks::take(double now)
{
    const double since = m_until.value_or(now - 2.0 * kSameInstant);
    m_until = now + kSameInstant;
    const auto first = std::ranges::find_if(
        m_ahead, [since](const model::Mark& mark) { return mark.seconds > since; });
    const auto last = std::find_if(
        first, m_ahead.end(), [this](const model::Mark& mark) { return mark.seconds > *m_until; });
    model::Timeline due;
    std::copy_if(first, last, std::back_inserter(due),
                 [this](const model::Mark& mark) { return !m_forgotten.contains(mark.id); });
    m_ahead.erase(m_ahead.begin(), last);
    return due;
}

void performMark(Session& session, SessionParts& parts, const model::Mark& mark)
{
    Performance(session, parts, mark).run();
}

} // namespace crowd::behavior
