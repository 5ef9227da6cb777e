// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "behavior/base/Agents.h"
#include "behavior/base/Problem.h"
#include "behavior/rules/NearCells.h"
#include "behavior/rules/OwnNumber.h"
#include "behavior/rules/PlaceRooms.h"
#include "behavior/rules/RuleHost.h"
#include "model/population/Population.h"
#include "model/rules/Rule.h"
#include "model/rules/RuleSequence.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// "A rule fired", for the artist's log.
struct RuleFired
{
    double seconds = 0.0; ///< since the session began
    model::RuleId rule = 0;
    model::IndividualId who = 0;
    friend bool operator==(const RuleFired&, const RuleFired&) = default;
};

/// Runs rules over people: looks what has happened since the last step, starts sequences where
/// conditions hold and goes on with those that run. Serial and in a fixed order, so the same scene
/// and the same events give the same bits. Sent events arrive at the next step at the earliest: no
/// cycle of events can close within one.
class RuleEngine
{
public:
    /// Takes over rules and places; sequences that run go on where their rule is unchanged. When
    /// numbers were kept, those that everybody has here stay.
    void setRules(const model::Scene& scene, bool areNumbersKept = false);
    /// Agents are other ones now; keep[i] is the former agent, or kNoAgent for a new one. Tags come
    /// from the scene.
    void setPeople(const model::Population& people, std::span<const std::uint32_t> keep);
    void setTags(std::uint32_t agent, std::uint64_t tags);
    [[nodiscard]] std::uint64_t tags(std::uint32_t agent) const { return m_minds[agent].tags; }
    /// Of the artist's numbers, as it is now; 0 where there is none of that id.
    [[nodiscard]] float number(std::uint32_t agent, model::NumberId id) const;
    /// Those that are not what they were at the beginning, ascending by number and individual;
    /// null before there are any.
    [[nodiscard]] std::shared_ptr<const std::vector<OwnNumber>> ownNumbers();

    /// As long as the session's; 30 before it is said.
    void setStepsPerSecond(std::uint32_t steps) { m_stepsPerSecond = steps; }
    void step(RuleHost& host, std::uint64_t step);
    void send(const std::string& event, float payload, std::uint32_t agent,
              const glm::vec3& origin);

    /// How often a rule fired in this session.
    [[nodiscard]] std::uint64_t count(model::RuleId rule) const;
    [[nodiscard]] const std::map<model::RuleId, std::uint64_t>& counts() const { return m_counts; }
    /// What fired since the last call, at most some thousand entries.
    [[nodiscard]] std::vector<RuleFired> takeLog();
    /// What went wrong while running, each once.
    [[nodiscard]] const std::vector<Problem>& problems() const { return m_problems; }
    /// Place that counts somebody as its guest; 0: none does.
    [[nodiscard]] model::PlaceId heldPlace(std::uint32_t agent) const
    {
        return m_minds[agent].holds;
    }
    /// For whom a rule fired within the last half second.
    [[nodiscard]] std::vector<std::uint32_t> lit() const; ///< agents, ascending
    [[nodiscard]] bool isEmpty() const { return m_rules.empty(); }

private:
    static constexpr std::uint32_t kNone = kNoAgent;
    static constexpr std::uint64_t kNoStep = ~std::uint64_t{0};

    struct Cause
    {
        float payload = 0.0F;
        glm::vec3 origin{0.0F};
        bool hasOrigin = false;
        model::IndividualId sender = 0; ///< 0: nobody
    };
    /// A Repeat that runs.
    struct Round
    {
        std::uint32_t line = 0;
        std::uint32_t left = 0; ///< with the one that runs
    };
    struct Waiting
    {
        model::RuleId rule = 0;
        Cause cause;
    };
    /// What somebody is busy with.
    struct Mind
    {
        std::uint64_t tags = 0;
        std::uint32_t rule = kNone; ///< index
        std::uint32_t action = 0;
        std::uint32_t firings = 0; ///< keys his draws
        std::uint32_t turns = 0;   ///< of choices and repetitions: keys them
        std::vector<Round> rounds; ///< the innermost last
        bool isStarted = false;    ///< the action has begun
        bool isTravelling = false; ///< until an errand ends
        double until = 0.0;        ///< seconds
        Cause cause;
        std::vector<Waiting> queue;
        double litUntil = -1.0;     ///< seconds
        bool hasHeard = false;      ///< the event that he waited for
        model::PlaceId goal = 0;    ///< of the errand that he is on or was on last
        model::PlaceId arrived = 0; ///< where an errand ended in this step; 0: at no place
        /// Step in which his errand began: one that ended in it was the errand before.
        std::uint64_t setOutIn = kNoStep;
        model::PlaceId holds = 0;   ///< place that counts him as its guest
        std::uint64_t ticket = 0;   ///< his turn for a free place; 0: he waits for none
        std::vector<float> numbers; ///< as m_numbers
        // Going to somebody, following, looking at.
        model::IndividualId partner = 0;
        glm::vec3 aimedAt{0.0F};
        double nextLook = 0.0; ///< seconds
        bool isNear = false;
        double movedAt = 0.0; ///< seconds
    };
    /// What a rule knows of each individual.
    struct Memory
    {
        double last = -1e18;
        double since = -1.0; ///< Waited: when he came to stand
        std::uint32_t count = 0;
        std::uint32_t echoes = 0; ///< times that it fired right after the last time, by rules
        bool wasThere = false;    ///< Start, Entered, Left, TagNear, SpeedLimit, Waited
        bool isSeen = false;      ///< SpeedLimit: looked at before
        model::PlaceId place = 0; ///< AheadFree: that he had when it was free last
    };
    struct RuleMemory
    {
        std::vector<Memory> of;  ///< by agent
        std::vector<double> due; ///< Every: seconds, by agent; below 0: not known yet
        void resize(std::size_t agents)
        {
            of.resize(agents);
            due.resize(agents, -1.0);
        }
    };
    struct Event
    {
        double due = 0.0;
        std::uint64_t order = 0;
        std::string name;
        float payload = 0.0F;
        model::IndividualId who = 0;
        glm::vec3 origin{0.0F};
        model::IndividualId sender = 0;
    };
    /// Those who wait for a free place of the same choice: first come, first served.
    struct Turn
    {
        std::uint64_t ticket = 0;
        model::IndividualId who = 0;
    };
    using TurnsKey = std::array<std::uint32_t, 3>; ///< place, path, whether they leave there
    /// A clip that a rule let somebody play is over.
    struct ClipEnd
    {
        std::uint32_t agent = 0;
        std::uint32_t rule = kNone;
        Cause cause;
    };
    /// What rules may still do in this step; the rest comes in the next one. Counted, not timed,
    /// so that it is the same on any machine.
    struct Budget
    {
        std::size_t actions = 0;
        std::size_t heard = 0; ///< events that reach somebody
        std::size_t asked = 0; ///< people of whom a sent event asks whether they are meant
    };
    /// Going to somebody, or after him.
    struct Approach
    {
        model::AimChoice aim;
        float metres = 0.0F;  ///< how near
        float seconds = 0.0F; ///< at most; 0: however long
        bool isFollowing = false;
    };
    /// What an action is about, where it is now.
    struct Aim
    {
        glm::vec3 point{0.0F};
        std::uint32_t agent = kNone; ///< where it is somebody
    };

    static bool isLater(const Event& a, const Event& b)
    {
        return a.due > b.due || (a.due == b.due && a.order > b.order);
    }
    void post(Event event);
    void deliver(RuleHost& host);
    void hear(RuleHost& host, std::uint32_t agent, const Event& event);
    void endErrands(RuleHost& host);
    [[nodiscard]] bool hasErrandEnded(RuleHost& host, std::uint32_t agent) const;
    void goOnWithAll(RuleHost& host);
    void endClips(RuleHost& host);
    void hearClipEnd(RuleHost& host, std::uint32_t rule, const ClipEnd& end);
    void takeNextOfQueue(RuleHost& host, std::uint32_t agent);
    /// Neither its pause nor its limit keeps it from coming.
    [[nodiscard]] bool isDue(std::uint32_t rule, std::uint32_t agent) const;
    [[nodiscard]] bool isQueueable(std::uint32_t rule, std::uint32_t agent) const;
    void sayStorm(std::uint32_t rule);
    void lookAround(RuleHost& host);
    void lookAt(RuleHost& host, std::uint32_t rule);
    void lookAt(RuleHost& host, std::uint32_t rule, std::uint32_t agent);
    void noteTravelEvents(const RuleHost& host);
    /// The first one from there on whom a rule lets do something, or their number.
    [[nodiscard]] std::uint32_t nextBusy(std::uint32_t agent) const;
    void setBusy(std::uint32_t agent, std::uint32_t rule);
    void lookForTags(RuleHost& host, std::uint32_t rule, const model::triggers::TagNear& trigger);
    void lookAhead(RuleHost& host, std::uint32_t rule, model::PathId path);
    [[nodiscard]] bool happensTo(RuleHost& host, std::uint32_t rule, std::uint32_t agent);
    [[nodiscard]] bool hasArrived(RuleHost& host, std::uint32_t agent, model::PlaceId place) const;
    [[nodiscard]] bool isInside(RuleHost& host, std::uint32_t agent, model::PlaceId place) const;
    [[nodiscard]] bool isCrossed(const model::triggers::SpeedLimit& trigger, float speed,
                                 Memory& memory) const;
    [[nodiscard]] bool isTired(const model::triggers::Waited& trigger, float speed,
                               Memory& memory) const;
    [[nodiscard]] bool isTime(RuleHost& host, std::uint32_t rule, std::uint32_t agent,
                              const model::triggers::Every& trigger);
    [[nodiscard]] bool holds(RuleHost& host, const model::Rule& rule, std::uint32_t agent,
                             const Cause& cause);
    [[nodiscard]] bool holds(RuleHost& host, const model::Condition& condition, std::uint64_t key,
                             std::uint32_t agent, const Cause& cause);
    /// False: it does not come to it, now at least.
    bool fire(RuleHost& host, std::uint32_t rule, std::uint32_t agent, const Cause& cause);
    [[nodiscard]] bool mayBreakOff(std::uint32_t busy, std::uint32_t other) const;
    void noticeEcho(std::uint32_t rule, Memory& memory, const Cause& cause);
    void begin(RuleHost& host, std::uint32_t rule, std::uint32_t agent, const Cause& cause);
    void goOn(RuleHost& host, std::uint32_t agent);
    /// To what belongs to a Repeat or a OneOf, or to the beginning. False: it is neither.
    [[nodiscard]] bool branch(RuleHost& host, std::uint32_t agent, const model::Actions& actions);
    [[nodiscard]] std::size_t drawAlternative(RuleHost& host, std::uint32_t agent,
                                              const model::Actions& actions,
                                              const std::vector<std::size_t>& lines) const;
    /// Line to go on with after one that is over, with all that belongs to it.
    [[nodiscard]] std::uint32_t lineAfter(Mind& mind, const model::Actions& actions,
                                          std::size_t line) const;
    [[nodiscard]] bool goesRound(Mind& mind, const model::actions::Repeat& repeat,
                                 std::size_t line) const;
    /// True: the action is over.
    [[nodiscard]] bool run(RuleHost& host, std::uint32_t agent, const model::Action& action);
    void followPath(RuleHost& host, std::uint32_t agent, model::PathId path);
    void appear(RuleHost& host, std::uint32_t agent, model::PlaceId place);
    /// One of the clips by weight; empty: there are none.
    [[nodiscard]] std::string drawClip(RuleHost& host, std::uint32_t agent,
                                       const std::vector<model::ClipWeight>& clips) const;
    void changeTags(RuleHost& host, std::uint32_t agent, std::uint8_t tag, bool hasIt);
    [[nodiscard]] bool play(RuleHost& host, std::uint32_t agent,
                            const model::actions::PlayClip& action);
    [[nodiscard]] bool travel(RuleHost& host, std::uint32_t agent, const PlaceWish& wish);
    [[nodiscard]] bool setOut(RuleHost& host, std::uint32_t agent, const PlaceWish& wish);
    [[nodiscard]] bool leave(RuleHost& host, std::uint32_t agent,
                             const model::actions::LeaveScene& action);
    void goToPlace(RuleHost& host, std::uint32_t agent, model::PlaceId place);
    void closeUp(RuleHost& host, std::uint32_t agent, PlaceWish wish);
    [[nodiscard]] bool isAtGoal(RuleHost& host, std::uint32_t agent, float ahead) const;
    void sayNowhere(std::uint32_t rule, const PlaceWish& wish);
    [[nodiscard]] bool isHisTurn(std::uint32_t agent, const PlaceWish& wish);
    [[nodiscard]] bool isWaiting(const Turn& turn) const;
    void waitForPlace(std::uint32_t agent, const PlaceWish& wish);
    [[nodiscard]] static TurnsKey turnsOf(const PlaceWish& wish);
    void sendTo(RuleHost& host, std::uint32_t agent, const glm::vec3& point, float atLeast);
    [[nodiscard]] bool sitDown(RuleHost& host, std::uint32_t agent,
                               const model::actions::SitDown& action);
    [[nodiscard]] bool standUp(RuleHost& host, std::uint32_t agent);
    [[nodiscard]] bool wait(RuleHost& host, std::uint32_t agent,
                            const model::actions::Wait& action);
    [[nodiscard]] bool waitForEvent(std::uint32_t agent,
                                    const model::actions::WaitForEvent& action);
    [[nodiscard]] bool flee(RuleHost& host, std::uint32_t agent,
                            const model::actions::Flee& action);
    [[nodiscard]] bool approach(RuleHost& host, std::uint32_t agent, const Approach& action);
    [[nodiscard]] bool comeNear(RuleHost& host, std::uint32_t agent, const Approach& action);
    [[nodiscard]] bool giveWay(RuleHost& host, std::uint32_t agent, std::uint32_t other);
    [[nodiscard]] bool lookAtAim(RuleHost& host, std::uint32_t agent,
                                 const model::actions::LookAt& action);
    [[nodiscard]] std::optional<Aim> aimOf(RuleHost& host, std::uint32_t agent,
                                           const model::AimChoice& choice);
    [[nodiscard]] std::optional<Aim> partnerOf(RuleHost& host, std::uint32_t agent,
                                               const model::AimChoice& choice);
    [[nodiscard]] std::uint32_t nearestTagged(RuleHost& host, std::uint32_t agent,
                                              std::uint8_t tag);
    [[nodiscard]] std::uint32_t agentNamed(model::IndividualId id) const;
    void send(RuleHost& host, std::uint32_t agent, const model::actions::SendEvent& action);
    void tell(RuleHost& host, std::uint32_t agent, std::uint32_t other,
              const model::actions::SendEvent& action);
    /// Among whom those are whom a sent event reaches; null: everybody.
    [[nodiscard]] const std::vector<std::uint32_t>*
    findMeant(RuleHost& host, std::uint32_t agent, const model::actions::SendEvent& action);
    void fillCells(RuleHost& host);
    void fillGroups(RuleHost& host);
    [[nodiscard]] std::vector<std::uint32_t>& carriersOf(std::uint8_t tag);
    [[nodiscard]] bool isMeant(RuleHost& host, const model::actions::SendEvent& action,
                               std::uint32_t agent, std::uint32_t other) const;
    void hold(std::uint32_t agent, model::PlaceId place);
    [[nodiscard]] PlaceRooms& rooms(RuleHost& host);
    [[nodiscard]] glm::vec3 pointIn(RuleHost& host, std::uint32_t agent,
                                    const model::Place& place) const;
    /// Becomes the value, or that much more.
    void changeNumber(std::uint32_t agent, model::NumberId number, float value, bool isAdded);
    void giveNumbers(const model::Scene& scene, bool areKept);
    [[nodiscard]] float firstNumber(const model::NumberName& named, model::IndividualId id) const;
    [[nodiscard]] std::vector<float> firstNumbers(model::IndividualId id) const;
    [[nodiscard]] float draw(RuleHost& host, std::uint32_t agent, std::uint64_t purpose) const;
    void complain(Problem problem);
    /// Begins with the rule's name.
    void complainOf(std::uint32_t rule, const std::string& problem);
    void checkRules(const model::Scene& scene);

    std::vector<model::Rule> m_rules; ///< enabled ones, the first matters most
    std::vector<bool> m_bringsBack;   ///< rules that those who have left still hear
    PlaceRooms m_places;
    std::vector<model::NumberName> m_numbers;
    std::vector<Mind> m_minds;               ///< by agent
    std::vector<std::uint8_t> m_isBusy;      ///< by agent: has a rule
    std::vector<std::uint32_t> m_happenedTo; ///< agents to whom something did in this step
    std::vector<std::uint32_t> m_lit;        ///< agents, in any order
    std::vector<RuleMemory> m_memory;        ///< by rule
    std::map<TurnsKey, std::deque<Turn>> m_turns;
    std::uint64_t m_tickets = 0;
    std::vector<ClipEnd> m_clipsEnded; ///< in this step
    Budget m_left;
    std::uint32_t m_goesOnFirst = 0; ///< agent with whom a step begins to go on
    bool m_isStormSaid = false;      ///< in this step
    // Of this step, once somebody has asked.
    NearCells m_cells;                                             ///< where people are
    std::map<std::uint32_t, std::vector<std::uint32_t>> m_groups;  ///< agents, ascending
    std::map<std::uint8_t, std::vector<std::uint32_t>> m_carriers; ///< of a tag, ascending
    std::vector<std::uint32_t> m_meant;
    std::vector<Event> m_events; ///< heap: the earliest first
    std::vector<std::pair<model::IndividualId, std::uint32_t>> m_agentOf; ///< ascending
    /// Who has a tag, by tag: as of this step, for those that were asked for.
    std::map<std::uint8_t, NearCells> m_tagged;
    std::map<model::RuleId, std::uint64_t> m_counts;
    std::vector<RuleFired> m_log;
    std::vector<Problem> m_problems;
    std::uint64_t m_order = 0;
    std::uint64_t m_step = 0;
    std::uint32_t m_stepsPerSecond = 30;
    std::shared_ptr<const std::vector<OwnNumber>> m_ownNumbers;
    bool m_areNumbersStale = false;
    double m_now = 0.0;
    std::uint32_t m_seed = 1;
};

} // namespace crowd::behavior
