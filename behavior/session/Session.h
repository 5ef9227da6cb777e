// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "behavior/crowd/CrowdSimulation.h"
#include "behavior/crowd/ParkedBodies.h"
#include "behavior/motion/GaitTable.h"
#include "behavior/motion/MotionState.h"
#include "behavior/motion/PathFollower.h"
#include "behavior/motion/StrideKernel.h"
#include "behavior/rules/RuleEngine.h"
#include "behavior/session/SessionPose.h"
#include "behavior/session/SessionTally.h"
#include "behavior/surface/WalkSurface.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Path.h"
#include "model/scene/Scene.h"

namespace crowd::behavior {

/// What a session needs to know beside the scene.
struct SessionPlan
{
    struct Walker
    {
        model::IndividualId id = 0;
        model::PathId path = 0;
        float metresPerSecond = model::kUsualWalkingSpeed;
    };
    std::vector<model::Place> places;
    std::vector<model::Path> paths;
    std::vector<Walker> walkers;
    std::vector<Wall> walls;

    /// What the scene itself says. Who was given no speed has one of his own.
    [[nodiscard]] static SessionPlan of(const model::Scene& scene);
};

/// One run of the simulation. Starts from the scene, keeps columns of its own and never writes to
/// the scene. Whoever does not walk is an obstacle that stays. Steps are as long as the scene said
/// when the session began; the same scene, plan, edits and number of steps give the same bits. One
/// thread at a time; frames and poses may be read on any.
class Session : private RuleHost
{
public:
    Session(const model::Scene& scene, const SessionPlan& plan);
    explicit Session(const model::Scene& scene) : Session(scene, SessionPlan::of(scene)) {}
    ~Session() override;

    void step();
    [[nodiscard]] std::uint64_t steps() const { return m_steps; }
    [[nodiscard]] double seconds() const
    {
        return m_start + static_cast<double>(m_steps) / m_stepsPerSecond;
    }
    /// The transport's time at the beginning: only where clips stand depends on it.
    void setStart(double seconds) { m_start = seconds; }

    /// The scene was edited: what is another there now is another here from the next step on,
    /// everything else goes on as it is. After poses were kept, where people are in the scene is
    /// where they are here.
    void adopt(const model::Scene& scene, bool arePosesKept = false);
    /// What there is to walk on, and its walls; null: open ground.
    void setSurface(std::shared_ptr<const WalkSurface> surface);
    /// An event happens to these people at the next step.
    void send(const std::string& event, float payload, const std::vector<model::IndividualId>& ids);
    /// To those who have a tag in this session.
    void sendTagged(const std::string& event, float payload, std::uint8_t tag);

    /// Those whom the session moves, as of the last step.
    [[nodiscard]] SessionPosePtr pose() const;
    /// Everybody as of the last step, for the renderer.
    [[nodiscard]] model::CrowdFramePtr frame() const;
    /// People counted, as of the last step.
    [[nodiscard]] SessionTally tally() const;
    /// What in the plan could not be followed, or came to grief.
    [[nodiscard]] const std::vector<Problem>& warnings() const { return m_warnings; }
    /// Those, and what went wrong with rules.
    [[nodiscard]] std::vector<Problem> problems() const;
    [[nodiscard]] RuleEngine& rules() { return m_rules; }

    /// For measuring and tuning.
    [[nodiscard]] CrowdSimulation& crowd() { return m_crowd; }
    [[nodiscard]] const PathFollower& follower() const { return m_follower; }

private:
    enum class Sitting : std::uint8_t {
        No,
        Goes,    ///< on its way to the seat
        Settles, ///< the last bit, past whoever sits there
        Sits     ///< since this session let it; else the scene's seat counts
    };
    /// What an individual shows beside his bearing, and why; one per row of the population, which
    /// is its agent. Who writes it lets the agent be looked at: see markDirty().
    struct Shown
    {
        std::uint32_t table = 0;
        std::uint32_t gait = 0;
        float height = 1.0F;
        bool isGone = false;
        // A clip that a rule lets it play, as the clip column counts.
        int order = -1;
        bool isOrderLooped = false;
        bool isOrderOwn = false; ///< of sitting down, not of a rule: it ends by itself
        double orderPlace = 0.0;
        float facing = 0.0F; ///< what it turns to while it stands
        bool isTurning = false;
        int base = -1;                       ///< clip while it stands or sits; -1: the scene's
        std::uint32_t style = 0;             ///< gait to move with; 0: any
        model::SeatId seat = model::kNoSeat; ///< sits there, or goes there to sit
        Sitting sitting = Sitting::No;
        float blockedSeconds = 0.0F;
        bool hasLast = false;       ///< the bearing tells what it did in the last step
        ClipPlace from;             ///< what it did before it changed over, where it is by now
        std::uint32_t lastGait = 0; ///< of the bearing's clip; 0: none, it has a pace of its own
        std::uint32_t fromGait = 0; ///< of `from`
        double fadeBegin = -1.0;    ///< seconds
        bool isPut = false;         ///< stands where it was put, whatever the crowd says
        // Of its own clip, where rules have set it; else as the scene says.
        std::optional<float> rate;
        std::optional<double> phase; ///< at time 0
    };
    /// What somebody stands on; one per row of the population.
    struct Standing
    {
        Footing footing;
        bool isSettled = true; ///< at the ground's height, or where the scene has put him
    };
    /// The clip that somebody shows.
    struct Showing
    {
        ClipPlace clip;
        bool isGait = false;  ///< it is that of his gait
        bool isClock = false; ///< its place is that at time 0: it goes by the clock
    };
    static constexpr float kGoneHeight = -1e5F; ///< a level of their own for those who have left
    struct ClipFacts
    {
        float seconds = 0.0F;
        bool isLooped = true;
        bool isMover = false;
    };

    // RuleHost
    [[nodiscard]] std::size_t agents() const override { return m_shown.size(); }
    [[nodiscard]] glm::vec3 position(std::uint32_t agent) const override;
    [[nodiscard]] model::IndividualId id(std::uint32_t agent) const override;
    [[nodiscard]] model::TemplateId templateOf(std::uint32_t agent) const override;
    [[nodiscard]] std::uint32_t group(std::uint32_t agent) const override;
    [[nodiscard]] bool isSeated(std::uint32_t agent) const override;
    [[nodiscard]] bool isGone(std::uint32_t agent) const override;
    [[nodiscard]] model::PathId pathOf(std::uint32_t agent) const override;
    [[nodiscard]] std::span<const std::uint8_t> travelEvents() const override;
    [[nodiscard]] model::PlaceId reachedPlace(std::uint32_t agent) const override;
    float play(std::uint32_t agent, const std::string& clip, bool isLooped) override;
    void endClip(std::uint32_t agent) override;
    bool follow(std::uint32_t agent, model::PathId path) override;
    [[nodiscard]] glm::vec3 reached(const glm::vec3& from, const glm::vec3& point) const override;
    [[nodiscard]] float wayMetres(const glm::vec3& from, const glm::vec3& to,
                                  float within) const override;
    void sendTo(std::uint32_t agent, const glm::vec3& point, float atLeast) override;
    void stop(std::uint32_t agent) override;
    void goOn(std::uint32_t agent) override;
    void setPace(std::uint32_t agent, float metresPerSecond) override;
    void turnTo(std::uint32_t agent, const glm::vec3& point) override;
    void leave(std::uint32_t agent) override;
    void appear(std::uint32_t agent, const glm::vec3& point) override;
    [[nodiscard]] float speed(std::uint32_t agent) const override;
    [[nodiscard]] glm::vec2 wantedVelocity(std::uint32_t agent) const override;
    bool sit(std::uint32_t agent, float metres) override;
    [[nodiscard]] bool hasSeats() override;
    [[nodiscard]] bool isSittingDown(std::uint32_t agent) const override;
    float standUp(std::uint32_t agent) override;
    void leaveSeat(std::uint32_t agent) override;
    [[nodiscard]] float property(std::uint32_t agent,
                                 model::ComparedProperty property) const override;
    [[nodiscard]] bool showsClip(std::uint32_t agent, const std::string& clip) const override;
    void setProperty(std::uint32_t agent, const model::Action& action,
                     const std::string& clip) override;
    void noteTags(std::uint32_t agent, std::uint64_t tags) override;

    [[nodiscard]] SetLook& lookOf(std::uint32_t agent);
    void setTint(std::uint32_t agent, const model::Action& action);
    void setBase(std::uint32_t agent, int clip);
    void setOwnClip(std::uint32_t agent, const std::string& clip);
    void setOwnPhase(std::uint32_t agent, double place);
    void setOwnRate(std::uint32_t agent, float rate);
    void publishLooks();
    [[nodiscard]] std::uint16_t ownClip(std::uint32_t agent) const;
    [[nodiscard]] float ownRate(std::uint32_t agent) const;
    [[nodiscard]] double ownPhase(std::uint32_t agent) const;
    /// Where it is in its own clip; loops 0..1 and on.
    [[nodiscard]] double ownPlace(std::uint32_t agent) const;
    /// The scene's value of a column counts again for somebody.
    void forgetLook(std::uint32_t agent, model::ColumnId column);

    [[nodiscard]] float turnedTo(float heading, float target) const;
    /// Of a share that is covered in 1/30 s: that which is in a step.
    [[nodiscard]] float shareInStep(float share) const;
    void readSeats();
    void settle(std::uint32_t agent);
    void takeSeat(std::uint32_t agent);
    [[nodiscard]] const model::Seat* seatOf(model::SeatId id) const;
    [[nodiscard]] int clipNamed(const Shown& shown, const char* name) const;
    [[nodiscard]] const model::TemplateEntry* entryOf(const Shown& shown) const;
    void readTemplates(const model::Scene& scene);
    void adoptTemplates(const model::Scene& scene);
    void adoptTemplate(std::uint32_t agent, const std::vector<model::TemplateEntry>& former);
    void countGroups(const model::Population& people);
    void addPeople(const SessionPlan& plan);
    void addBodies(const model::Population& people);
    void turnLongBodies();
    [[nodiscard]] const model::Footprint& footprintOf(std::size_t agent) const;
    void setWalls(const std::vector<model::Place>& places);
    void warnOfWays();
    void warnOfWay(const Problem& problem);
    void warnOfPlaces();
    void warnOfPaths();
    void warnOfPeople();
    void warnOfLeg(const model::Path& path, const model::Place& from, const model::Place& to);
    void warnOfCrowding();
    void warn(Problem problem);
    void leaveOutWhoIsNowhere();
    void adoptRows(const model::Scene& scene);
    void adoptValues(const model::Scene& scene, bool arePosesKept, bool areTemplatesNew);
    void adoptLooks(const model::Population& now);
    void adoptPaths(const model::Scene& scene);
    void actPlaces();
    void goAroundParked();
    void brake();
    /// Something happens to somebody: the next step looks at him.
    Shown& markDirty(std::uint32_t agent);
    /// He has moved or acted: the scene's values count no more.
    Shown& activate(std::uint32_t agent);
    [[nodiscard]] bool isLive(std::uint32_t agent) const;
    void showAll();
    void follow(std::size_t begin, std::size_t end);
    void stand(std::uint32_t agent);
    [[nodiscard]] float groundAhead(const Body& body, float height, float surfaceHeight) const;
    void look(std::uint32_t agent);
    bool placeBody(std::uint32_t agent);
    void turn(std::uint32_t agent, float speed);
    void goOnWithOrder(Shown& shown) const;
    void goOnFading(std::uint32_t agent);
    void followGait(std::uint32_t agent, float speed, bool wantsOn);
    void noteClip(std::uint32_t agent);
    void setUpdateMode(std::uint32_t agent);
    [[nodiscard]] Showing showingOf(std::uint32_t agent) const;
    [[nodiscard]] std::uint8_t flagsOf(const Shown& shown, const Showing& showing,
                                       std::uint8_t before) const;
    [[nodiscard]] std::uint32_t styleOf(const model::Population& people, std::size_t row,
                                        std::uint32_t table) const;
    [[nodiscard]] std::uint32_t tableOf(const model::Population& people, std::size_t row) const;
    [[nodiscard]] Shown shownFrom(const model::Population& people, std::size_t row) const;
    void setMotion(const model::Population& people, std::uint32_t row);
    [[nodiscard]] float paceOf(const model::Population& people, std::size_t row) const;
    [[nodiscard]] PathFollower::Assignment walkOf(const model::Population& people,
                                                  std::size_t row) const;
    void addTo(SessionPose& pose, std::span<const std::uint32_t> agents) const;
    [[nodiscard]] const ClipFacts* clipFacts(const Shown& shown, int clip) const;

    model::Population m_population; ///< as the scene has it
    std::shared_ptr<const std::vector<model::TemplateEntry>> m_templates;
    /// What a session knows of a template beside its clips.
    struct TemplateFacts
    {
        model::Footprint footprint;
        float usualSpeed = model::kUsualWalkingSpeed; ///< at height 1, m/s
    };
    std::vector<GaitTable> m_gaits;              ///< one per template
    std::vector<TemplateFacts> m_facts;          ///< one per template
    std::vector<std::vector<ClipFacts>> m_clips; ///< per template, as the clip column counts
    std::vector<Shown> m_shown;
    std::vector<Standing> m_standing;
    MotionState m_motion;
    CrowdSimulation m_crowd;
    ParkedBodies m_parked;
    PathFollower m_follower;
    RuleEngine m_rules;
    std::shared_ptr<const WalkSurface> m_surface;
    std::vector<Wall> m_plannedWalls;
    std::vector<model::Place> m_places;
    std::vector<model::Path> m_paths;
    std::vector<model::StageEntry> m_stages;
    std::vector<model::WorldSeat> m_seats; ///< ascending; read when somebody first wants one
    std::vector<bool> m_isSeatTaken;       ///< one per seat
    std::map<std::uint32_t, std::uint32_t> m_groupSizes;
    std::vector<std::uint32_t> m_sitters;           ///< agents on their way to a seat; ascending
    std::map<model::IndividualId, SetLook> m_looks; ///< what rules have set
    std::shared_ptr<const std::vector<SetLook>> m_shownLooks; ///< as of the last step
    bool m_areLooksStale = false;
    std::shared_ptr<const std::vector<OwnNumber>> m_ownNumbers; ///< as of the last step
    bool m_hasSat = false; ///< somebody's seat is not the scene's
    std::vector<Problem> m_warnings;
    std::vector<Problem> m_saidOfWays; ///< those of them that another surface may change
    std::uint32_t m_seed = 1;
    std::uint64_t m_steps = 0;
    std::uint32_t m_stepsPerSecond = 30;
    float m_stepSeconds = 1.0F / 30.0F;
    float m_smoothing = 0.0F; ///< of speeds, a step
    float m_rampShare = 0.0F; ///< of the way to the ground's height, a step
    double m_start = 0.0;
};

} // namespace crowd::behavior
