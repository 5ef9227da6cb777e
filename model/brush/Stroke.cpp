// SPDX-License-Identifier: MIT
#include "model/brush/Stroke.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

#include "model/base/Random.h"
#include "model/brush/CreationEffect.h"
#include "model/brush/NewPeople.h"
#include "model/brush/Operator.h"
#include "model/brush/SelectionEffect.h"
#include "model/brush/StrokeText.h"

namespace crowd::model {

namespace {

/// Spacing of dabs: a share of the circle, so that it leaves no gaps; points are tried often
/// enough not to step over anybody.
constexpr double kCircleSpacing = 0.25;
constexpr double kPointSpacing = 3.0;
/// The way is measured over at least so many pixels before it has a direction.
constexpr double kDirectionPixels = 8.0;

bool dependsOnThePast(const BrushSettings& settings)
{
    const auto* restore = settings.find<RestoreSettings>();
    return restore != nullptr && restore->source != RestoreSource::Template &&
           restore->source != RestoreSource::State;
}

Sampler samplerFor(const BrushSettings& settings)
{
    if (settings.selection == BrushSelection::Spray) {
        return Sampler::spray(settings.ratePerSecond, settings.pressureRate);
    }
    return Sampler::alongWay(dabSpacing(settings));
}

bool needsDirection(const BrushSettings& settings)
{
    if (const auto* push = settings.find<PushSettings>()) {
        return !settings.isReevaluated() &&
               (push->mode == PushMode::Push || push->mode == PushMode::Comb);
    }
    const auto* turns = settings.find<OrientationSettings>();
    return turns != nullptr && !settings.isReevaluated() &&
           turns->heading.mode == HeadingMode::AlongStroke;
}

} // namespace

double dabSpacing(const BrushSettings& settings)
{
    return settings.selection == BrushSelection::AllInCircle
               ? std::max(1.0, settings.radiusPixels * kCircleSpacing)
               : kPointSpacing;
}

double dabRadius(const BrushSettings& settings, const Dab& dab)
{
    return settings.pressureSize ? settings.radiusPixels * static_cast<double>(dab.pressure)
                                 : settings.radiusPixels;
}

glm::dvec2 sprayPoint(const BrushSettings& settings, std::uint64_t seed, const Dab& dab, int k)
{
    const std::uint64_t key = hashKeys(seed, dab.index, k);
    const double angle = 2.0 * std::numbers::pi * randomUnit(key, DrawPurpose::PointAngle);
    const double radius =
        dabRadius(settings, dab) * std::sqrt(randomUnit(key, DrawPurpose::PointRadius));
    return dab.pixels() + glm::dvec2(std::cos(angle), std::sin(angle)) * radius;
}

void extendWay(std::vector<glm::ivec2>& way, glm::ivec2 point)
{
    if (!way.empty() && way.back() == point) {
        return;
    }
    if (way.size() >= 2) {
        using Wide = glm::i64vec2;
        const Wide before = Wide(way.back()) - Wide(way[way.size() - 2]);
        const Wide next = Wide(point) - Wide(way.back());
        if (before.x * next.y == before.y * next.x && before.x * next.x + before.y * next.y > 0) {
            way.back() = point;
            return;
        }
    }
    way.push_back(point);
}

ScreenArea wholeArea(const StrokeContext& ground, const StrokeLine& line)
{
    if (ground.settings.selection != BrushSelection::Lasso) {
        return ScreenArea::rectangle(line.from, line.to);
    }
    std::vector<glm::dvec2> corners;
    corners.reserve(ground.way.size());
    for (const glm::ivec2& point : ground.way) {
        corners.push_back(pixelsOf(point));
    }
    return ScreenArea::polygon(std::move(corners));
}

struct Stroke::Private
{
    Private(StrokeContext strokeGround, const PointerInput& press);
    void endRecording();

    StrokeContext ground;
    Sampler sampler;
    std::unique_ptr<StrokeEffect> work;
    RecordedStroke recording;
    // The direction of the way, measured from dab to dab.
    glm::dvec2 trail{0.0};
    std::optional<float> heading;
    std::vector<StrokeDab> waiting; ///< dabs that came before there was a direction
    std::uint64_t bakedBefore = 0;
    bool isSettled = false;
    bool isOver = false;

    [[nodiscard]] bool seesStandIns() const;
    void add(const PointerInput& input, bool isEvaluated = true);
    void follow(const Dab& dab, double atLeastPixels);
    void applyDabs(std::span<const Dab> dabs);
    void applyWaiting();
    [[nodiscard]] StrokeLine line() const
    {
        return {recording.inputs.front().pixels(), recording.inputs.back().pixels()};
    }
};

Stroke::Private::Private(StrokeContext strokeGround, const PointerInput& press)
    : ground(std::move(strokeGround)), sampler(samplerFor(ground.settings)), trail(press.pixels())
{
    recording.settings = ground.settings;
    recording.seed = ground.seed;
    recording.camera = ground.context.view.camera();
    recording.viewSize = ground.context.view.size();
    ground.seats = ground.document.scene().worldSeats();
    if (ground.settings.kind() == BrushKind::Create) {
        work = std::make_unique<CreationEffect>(ground);
    } else {
        work = std::make_unique<SelectionEffect>(ground);
    }
    bakedBefore = ground.context.keyframes.version();
    recording.isExact = !seesStandIns();
    add(press);
}

void Stroke::Private::endRecording()
{
    recording.affected = work->affected();
    recording.isExact =
        ground.before != nullptr ? ground.before->isExact : recording.isExact && !seesStandIns();
    recording.selected = std::move(ground.selected);
}

/// Whether it does something that the scene before it does not say: people are given back what they
/// had, there may be clips on screen that are not all there, or people elsewhere.
bool Stroke::Private::seesStandIns() const
{
    const KeyframeStore& keyframes = ground.context.keyframes;
    const KeyframeStore::Progress progress = keyframes.progress();
    if (ground.settings.kind() == BrushKind::Create) {
        return false; // it asks where the scene has people, and nothing of their clips
    }
    return dependsOnThePast(ground.settings) || ground.context.pose || progress.pendingClips > 0 ||
           progress.isBudgetReached || progress.isPaused || keyframes.version() != bakedBefore;
}

void Stroke::Private::follow(const Dab& dab, double atLeastPixels)
{
    if (glm::distance(trail, dab.pixels()) < atLeastPixels || trail == dab.pixels()) {
        return;
    }
    const auto found =
        headingOfLine(ground.context.view, ground.context.stage, {trail, dab.pixels()});
    if (found) {
        heading = found;
    }
    trail = dab.pixels();
}

void Stroke::Private::applyDabs(std::span<const Dab> dabs)
{
    std::vector<StrokeDab> ready;
    for (const Dab& dab : dabs) {
        follow(dab, kDirectionPixels);
        if (needsDirection(ground.settings) && !heading) {
            waiting.push_back({dab, std::nullopt});
            continue;
        }
        for (StrokeDab& early : waiting) {
            ready.push_back({early.dab, heading});
        }
        waiting.clear();
        ready.push_back({dab, heading});
    }
    work->apply(ready);
}

void Stroke::Private::applyWaiting()
{
    if (waiting.empty()) {
        return;
    }
    follow(waiting.back().dab, 0.0);
    for (StrokeDab& dab : waiting) {
        dab.heading = heading;
    }
    work->apply(waiting);
    waiting.clear();
}

void Stroke::Private::add(const PointerInput& input, bool isEvaluated)
{
    recording.inputs.push_back(input);
    extendWay(ground.way, input.grid);
    const std::vector<Dab> dabs = sampler.add(input);
    if (!ground.settings.hasWholeArea()) {
        applyDabs(dabs);
    }
    if (ground.settings.isReevaluated() && isEvaluated) {
        work->reevaluate(line(), input.shownSeconds);
    }
}

Stroke::Stroke(std::unique_ptr<Private> data) : m_private(std::move(data)) {}
Stroke::~Stroke() = default;

std::unique_ptr<Stroke> Stroke::begin(SceneDocument& document, const BrushContext& context,
                                      const BrushSettings& settings, std::uint64_t seed,
                                      const PointerInput& press, const RecordedStroke* before)
{
    auto edit = document.beginEdit();
    if (!edit) {
        return nullptr;
    }
    StrokeContext ground{document, context, settings, seed, nullptr, {}};
    ground.edit = std::move(edit).value();
    ground.before = before != nullptr && !before->selected.empty() ? before : nullptr;
    return std::unique_ptr<Stroke>(new Stroke(std::make_unique<Private>(std::move(ground), press)));
}

void Stroke::move(const PointerInput& input)
{
    if (!m_private->isOver) {
        m_private->add(input);
    }
}

void Stroke::pass(const PointerInput& input)
{
    if (!m_private->isOver) {
        m_private->add(input, !m_private->ground.settings.hasWholeArea());
    }
}

void Stroke::settle()
{
    Private& d = *m_private;
    if (d.isOver || d.isSettled) {
        return;
    }
    d.isSettled = true;
    d.applyWaiting();
    d.work->end(d.line());
}

StrokeOutcome Stroke::finish()
{
    Private& d = *m_private;
    StrokeOutcome outcome;
    if (d.isOver) {
        outcome.reason = StrokeReason::Cancelled;
        return outcome;
    }
    settle();
    d.isOver = true;
    outcome.affected = affected();
    d.endRecording();
    outcome.isCommitted =
        d.ground.edit->commit(strokeText(d.ground.settings, outcome.affected), &d.recording);
    d.ground.edit.reset();
    const BrushKind kind = d.ground.settings.kind();
    outcome.isSent =
        (kind == BrushKind::Event || kind == BrushKind::Retake) && outcome.affected > 0;
    outcome.reason = outcome.isCommitted || outcome.isSent ? StrokeReason::None : d.work->reason();
    if (!outcome.isCommitted && !outcome.isSent && outcome.reason == StrokeReason::None) {
        outcome.reason = StrokeReason::ScriptChangedNothing;
    }
    if (outcome.reason == StrokeReason::SourcesChosen && !d.recording.selected.empty()) {
        outcome.chosen = d.recording.selected.back();
    }
    outcome.message = reasonText(outcome.reason, kind);
    return outcome;
}

void Stroke::cancel()
{
    m_private->isOver = true;
    m_private->ground.edit.reset();
}

int Stroke::affected() const
{
    return m_private->work->affected();
}

std::span<const IndividualId> Stroke::gathered() const
{
    return m_private->ground.gathered;
}

const BrushSettings& Stroke::settings() const
{
    return m_private->ground.settings;
}

const PointerInput& Stroke::current() const
{
    return m_private->recording.inputs.back();
}

StrokeOutcome replay(SceneDocument& document, KeyframeStore& keyframes, const StageRays& stage,
                     const RecordedStroke& recording, WalkableGroundSource ground,
                     ScriptChange* script)
{
    if (recording.inputs.empty()) {
        return {};
    }
    BrushContext context{View(recording.camera, recording.viewSize), keyframes, stage};
    context.ground = std::move(ground);
    context.script = script;
    const auto stroke = Stroke::begin(document, context, recording.settings, recording.seed,
                                      recording.inputs.front(), &recording);
    if (!stroke) {
        StrokeOutcome refused;
        refused.reason = StrokeReason::Cancelled;
        return refused;
    }
    for (std::size_t i = 1; i < recording.inputs.size(); ++i) {
        i + 1 < recording.inputs.size() ? stroke->pass(recording.inputs[i])
                                        : stroke->move(recording.inputs[i]);
    }
    return stroke->finish();
}

IndividualRows previewGhosts(const SceneDocument& document, const BrushContext& context,
                             const BrushSettings& settings, std::uint64_t seed,
                             const PointerInput& at)
{
    if (settings.kind() != BrushKind::Create) {
        return IndividualRows::withDefaults({});
    }
    CreationSite site(document.scene(), context, settings, seed);
    Sampler sampler = samplerFor(settings);
    IndividualRows rows =
        peopleFor(document.scene(), context.view, settings,
                  spotsOfDab(site, settings, seed, sampler.add(at).front()), std::nullopt)
            .rows;
    std::iota(rows.ids.begin(), rows.ids.end(), IndividualId{1});
    return rows;
}

} // namespace crowd::model
