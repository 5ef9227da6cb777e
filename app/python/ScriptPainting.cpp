// SPDX-License-Identifier: MIT
#include "app/python/ScriptPainting.h"

#include <algorithm>
#include <chrono>
#include <set>

#include "app/python/BrushRules.h"
#include "app/python/ScriptPictures.h"

namespace crowd::app {

using namespace model;

namespace {

/// Whether all clips that are shown are there: where they had to be baked and `mayWait` is false,
/// they are not.
bool bakeAllShown(const Scene& scene, KeyframeStore& keyframes, bool mayWait)
{
    const auto templates = scene.population.column(columns::templateId);
    const auto clips = scene.population.column(columns::clip);
    std::set<std::pair<TemplateId, std::uint16_t>> shown;
    for (std::size_t row = 0; row < templates.size(); ++row) {
        const bool isLikeBefore =
            row > 0 && templates[row] == templates[row - 1] && clips[row] == clips[row - 1];
        if (!isLikeBefore) {
            shown.emplace(templates[row], clips[row]);
        }
    }
    bool areComplete = true;
    for (const auto& [id, clip] : shown) {
        const TemplateEntry* entry = scene.findTemplate(id);
        if (entry != nullptr && entry->asset && clip < entry->asset->clips.size()) {
            areComplete = keyframes.clip(entry->asset, clip).isComplete && areComplete;
        }
    }
    if (mayWait) {
        keyframes.waitForAll();
    }
    return areComplete || mayWait;
}

Result<void> checkSelected(const Population& people,
                           const std::vector<std::vector<IndividualId>>& selected)
{
    for (const std::vector<IndividualId>& dab : selected) {
        const auto unknown = std::ranges::find_if(
            dab, [&people](IndividualId id) { return people.rowOf(id) == Population::npos; });
        if (unknown != dab.end()) {
            return Error{"selected: there is no individual " + std::to_string(*unknown) + '.'};
        }
    }
    return {};
}

Error takenBack()
{
    return Error{"The stroke was taken back."};
}

/// A stroke as its scene holds it, input by input: a host has its own to do in between, and whoever
/// wants it to end is asked.
class HeldStroke
{
public:
    HeldStroke(ScriptScene& script, const RecordedStroke& recording, const KeepGoing& keepGoing)
        : m_script(script), m_recording(recording), m_keepGoing(keepGoing)
    {
    }

    /// All inputs. Taken back where it fails.
    [[nodiscard]] Result<void> paint(ScriptChange* change);
    void settle(); ///< script brushes get all their dabs
    [[nodiscard]] Result<StrokeOutcome> finish();

private:
    [[nodiscard]] Result<void> begin(ScriptChange* change);
    [[nodiscard]] bool movePiece();
    [[nodiscard]] bool goesOn(double shareOfMove);
    [[nodiscard]] bool isOver() const { return m_next >= m_recording.inputs.size(); }

    ScriptScene& m_script;
    const RecordedStroke& m_recording;
    const KeepGoing& m_keepGoing;
    std::size_t m_next = 0; ///< input
    bool m_isStopped = false;
};

bool HeldStroke::goesOn(double shareOfMove)
{
    constexpr double kBeforeTheEnd = 0.999; // it is done when it is committed
    const double share = (static_cast<double>(m_next) + shareOfMove) /
                         static_cast<double>(m_recording.inputs.size());
    m_isStopped = m_isStopped || !m_script.ask(m_keepGoing, std::min(share, kBeforeTheEnd));
    return !m_isStopped;
}

Result<void> HeldStroke::begin(ScriptChange* change)
{
    if (auto allowed = m_script.refuseDuringStroke(); !allowed) {
        return allowed;
    }
    m_script.stage().setStages(m_script.document().scene().stages);
    BrushContext context{View(m_recording.camera, m_recording.viewSize), m_script.keyframes(),
                         m_script.stage()};
    context.script = change;
    context.ground = [&script = m_script] { return script.ground().of(script.document().scene()); };
    if (m_script.isOwn()) { // a host's thread cannot ask
        context.keepGoing = [this](double share) { return goesOn(share); };
    }
    auto stroke = Stroke::begin(m_script.document(), context, m_recording.settings,
                                m_recording.seed, m_recording.inputs.front(), &m_recording);
    if (!stroke) {
        return Error{"Something else is being edited: try again when that has ended."};
    }
    m_script.holdStroke(std::move(stroke));
    m_next = 1;
    return {};
}

/// The next inputs, for a moment. False: somebody took the stroke back.
bool HeldStroke::movePiece()
{
    constexpr std::chrono::milliseconds kMoment{50};
    const auto deadline = std::chrono::steady_clock::now() + kMoment;
    Stroke* stroke = m_script.heldStroke();
    while (stroke != nullptr && !isOver() && !m_isStopped &&
           std::chrono::steady_clock::now() < deadline) {
        const PointerInput& input = m_recording.inputs[m_next];
        m_next + 1 < m_recording.inputs.size() ? stroke->pass(input) : stroke->move(input);
        ++m_next;
    }
    return stroke != nullptr;
}

Result<void> HeldStroke::paint(ScriptChange* change)
{
    if (auto begun = m_script.onDocument([&] { return begin(change); }); !begun) {
        return begun;
    }
    while (goesOn(0.0) && !isOver()) {
        if (!m_script.onDocument([this] { return movePiece(); })) {
            return takenBack();
        }
    }
    if (m_isStopped) {
        m_script.dropStroke();
        return takenBack();
    }
    return {};
}

void HeldStroke::settle()
{
    (void)m_script.onDocument([this] {
        if (Stroke* stroke = m_script.heldStroke()) {
            stroke->settle();
        }
        return true;
    });
}

Result<StrokeOutcome> HeldStroke::finish()
{
    settle();
    m_isStopped = m_isStopped || !m_script.ask(m_keepGoing, 1.0);
    if (m_isStopped) {
        m_script.dropStroke();
        return takenBack();
    }
    return m_script.onDocument([this]() -> Result<StrokeOutcome> {
        const auto stroke = m_script.takeStroke();
        if (!stroke) {
            return takenBack();
        }
        return stroke->finish();
    });
}

Result<StrokeOutcome> scriptStroke(ScriptScene& script, const RecordedStroke& recording,
                                   const PaintWork& paint, const KeepGoing& keepGoing)
{
    const auto link = std::make_shared<ScriptStrokeLink>();
    HeldStroke stroke(script, recording, keepGoing);
    if (auto selected = stroke.paint(link.get()); !selected) {
        return selected.error();
    }
    stroke.settle();
    link->close();
    script.joinStroke(link);
    try {
        paint(*link);
    } catch (...) {
        script.leaveStroke();
        script.dropStroke(); // takes back what was painted
        throw;
    }
    script.leaveStroke();
    return stroke.finish();
}

} // namespace

Result<StrokeOutcome> paintStroke(ScriptScene& script, const ScriptStroke& stroke,
                                  const PaintWork& paint, const KeepGoing& keepGoing)
{
    if (auto allowed = script.onDocument([&script] { return script.refuseDuringEdit("A stroke"); });
        !allowed) {
        return allowed.error();
    }
    const auto now = script.scene();
    const auto camera = cameraOrFirst(*now, stroke.camera);
    if (!camera) {
        return camera.error();
    }
    auto valid = checkBrush(stroke.settings);
    if (valid) {
        valid = checkSelected(now->population, stroke.selected);
    }
    if (valid && !stroke.allowsMissing) {
        valid = checkReferences(*now, stroke.settings);
    }
    if (!valid) {
        return valid.error();
    }
    // A stroke sees people as they are, not as they stand in until they are baked.
    if (!bakeAllShown(*now, script.keyframes(), script.isOfThisProcess())) {
        return Error{
            "Characters cannot be painted on in a process that was forked from the one that "
            "has the scene: what bakes their clips is not there. Open the scene in the "
            "new process, or start that with multiprocessing's \"spawn\"."};
    }
    RecordedStroke recording;
    recording.settings = stroke.settings;
    recording.seed = stroke.seed;
    recording.camera = camera.value();
    recording.viewSize = stroke.viewSize;
    recording.inputs = stroke.inputs;
    recording.selected = stroke.selected;
    recording.isExact = stroke.selected.empty();
    if (stroke.settings.kind() == BrushKind::Script) {
        return scriptStroke(script, recording, paint, keepGoing);
    }
    if (stroke.settings.kind() == BrushKind::Create &&
        !stroke.settings.as<CreateSettings>().anywhere) {
        (void)script.ground().of(*now); // takes long: not while a host waits
    }
    HeldStroke held(script, recording, keepGoing);
    if (auto painted = held.paint(nullptr); !painted) {
        return painted.error();
    }
    return held.finish();
}

} // namespace crowd::app
