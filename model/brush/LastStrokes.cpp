// SPDX-License-Identifier: MIT
#include "model/brush/LastStrokes.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <variant>

#include "model/document/SceneDelta.h"

namespace crowd::model {

namespace {

constexpr std::size_t kMostStrokes = 50; ///< further back they are kept no longer

bool canBeLaidAgain(const RecordedStroke* stroke)
{
    return stroke != nullptr && stroke->settings.kind() != BrushKind::Script;
}

std::size_t bytesOf(const RecordedStroke& stroke)
{
    std::size_t bytes = sizeof(stroke) + stroke.inputs.size() * sizeof(PointerInput);
    for (const std::vector<IndividualId>& dab : stroke.selected) {
        bytes += sizeof(std::vector<IndividualId>) + dab.size() * sizeof(IndividualId);
    }
    return bytes;
}

auto areaOf(const BrushSettings& brush)
{
    return std::tie(brush.selection, brush.radiusPixels, brush.ratePerSecond, brush.through,
                    brush.pressureSize, brush.pressureRate);
}

} // namespace

bool selectAlike(const BrushSettings& a, const BrushSettings& b)
{
    // Who is removed makes room for those behind.
    return a.kind() == b.kind() && a.kind() != BrushKind::Delete && areaOf(a) == areaOf(b) &&
           a.isReevaluated() == b.isReevaluated();
}

LastStrokes::LastStrokes(SceneDocument& document) : m_document(document)
{
    connect(&document, &SceneDocument::stepCommitted, this, &LastStrokes::note);
    connect(&document, &SceneDocument::changed, this, [this](const SceneChange& change) {
        if (std::holds_alternative<SceneReplaced>(change)) {
            forgetAll();
            Q_EMIT changed();
        }
    });
    connect(&document, &SceneDocument::undoBudgetChanged, this, &LastStrokes::keepWithinBytes);
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this] {
        if (!m_isLaying) {
            Q_EMIT changed();
        }
    });
}

void LastStrokes::note(const StepCommitted& step)
{
    if (m_isLaying) {
        return;
    }
    const int index = m_document.undoStack().index();
    const auto gone = std::ranges::find_if(
        m_entries, [index](const Entry& entry) { return entry.step.value_or(-1) >= index; });
    m_entries.erase(gone, m_entries.end());
    Entry& entry = m_entries.emplace_back();
    entry.step = index;
    entry.isBarrier = !canBeLaidAgain(step.stroke);
    if (!entry.isBarrier) {
        entry.stroke = *step.stroke;
        entry.affected = step.stroke->affected;
    }
    if (m_entries.size() > kMostStrokes) {
        m_entries.erase(m_entries.begin());
    }
    keepWithinBytes();
}

/// Behind the last of the strokes that are done.
std::size_t LastStrokes::tailEnd() const
{
    const int index = m_document.undoStack().index();
    const auto undone = std::ranges::find_if(
        m_entries, [index](const Entry& entry) { return entry.step.value_or(-1) >= index; });
    return static_cast<std::size_t>(undone - m_entries.begin());
}

std::size_t LastStrokes::tailBegin() const
{
    std::size_t begin = tailEnd();
    while (begin > 0 && !m_entries[begin - 1].isBarrier) {
        --begin;
    }
    return begin;
}

std::span<const LastStrokes::Entry> LastStrokes::tail() const
{
    const std::size_t begin = tailBegin();
    return std::span(m_entries).subspan(begin, tailEnd() - begin);
}

/// The oldest are forgotten first; they stay undo steps.
void LastStrokes::keepWithinBytes()
{
    constexpr std::size_t kShareOfUndo = 4;
    const std::size_t most = std::min(kMostBytes, m_document.undoMemory().budget() / kShareOfUndo);
    std::size_t bytes = 0;
    const auto fits = [&bytes, most](const Entry& entry) {
        const std::size_t with = bytes + bytesOf(entry.stroke);
        bytes = with <= most ? with : bytes;
        return with <= most;
    };
    const auto first = std::find_if_not(m_entries.rbegin(), m_entries.rend(), fits).base();
    m_entries.erase(m_entries.begin(), first);
    m_document.countBesideUndo(bytes);
}

void LastStrokes::forgetAll()
{
    m_entries.clear();
    m_document.countBesideUndo(0);
}

/// The undo stack's index before an entry.
int LastStrokes::stepOf(std::size_t entry) const
{
    const auto later = std::find_if(m_entries.begin() + static_cast<std::ptrdiff_t>(entry),
                                    m_entries.end(), [](const Entry& each) { return each.step; });
    return later == m_entries.end() ? m_document.undoStack().index() : *later->step;
}

StrokeOutcome LastStrokes::lay(Entry& entry, const BrushContext& context)
{
    const int step = m_document.undoStack().index();
    const auto connection = connect(&m_document, &SceneDocument::stepCommitted, this,
                                    [&entry](const StepCommitted& committed) {
                                        if (committed.stroke != nullptr) {
                                            entry.stroke = *committed.stroke;
                                        }
                                    });
    StrokeOutcome outcome =
        replay(m_document, context.keyframes, context.stage, entry.stroke, context.ground, nullptr);
    disconnect(connection);
    entry.step = outcome.isCommitted ? std::optional(step) : std::nullopt;
    entry.affected = outcome.affected;
    return outcome;
}

bool LastStrokes::comesToTheSame(const StepCommitted& step) const
{
    if (!m_context || step.stroke->selected.empty()) {
        return false;
    }
    Scene before = m_document.scene();
    applyDelta(before, *step.delta, DeltaDirection::Undo, [](const SceneChange&) {});
    SceneDocument again;
    again.replaceScene(std::move(before), {});
    const BrushContext context = m_context();
    (void)replay(again, context.keyframes, context.stage, *step.stroke, context.ground);
    return again.scene().population == m_document.scene().population;
}

StrokeOutcome LastStrokes::layAnew(std::size_t index, const BrushSettings& settings,
                                   std::uint64_t seed)
{
    const std::size_t entry = tailBegin() + index;
    StrokeOutcome outcome;
    outcome.reason = StrokeReason::Cancelled;
    if (entry >= tailEnd() || !m_context || m_document.isEditOpen()) {
        return outcome;
    }
    Entry fresh = m_entries[entry];
    if (!selectAlike(fresh.stroke.settings, settings)) {
        fresh.stroke.selected.clear();
    }
    fresh.stroke.settings = settings;
    fresh.stroke.seed = seed;
    m_isLaying = true;
    outcome = replace(entry, std::move(fresh));
    m_isLaying = false;
    Q_EMIT changed();
    return outcome;
}

StrokeOutcome LastStrokes::replace(std::size_t index, Entry fresh)
{
    QUndoStack& stack = m_document.undoStack();
    const std::size_t end = tailEnd();
    const int before = stack.index();
    const int start = stepOf(index);
    stack.setIndex(start);
    if (stack.index() != start) { // a step was refused, and the document has said why
        stack.setIndex(before);
        return {false, false, 0, StrokeReason::Cancelled, {}};
    }
    const BrushContext context = m_context();
    StrokeOutcome outcome = lay(fresh, context);
    if (!outcome.isCommitted) {
        stack.setIndex(before);
        return outcome;
    }
    m_entries.erase(m_entries.begin() + static_cast<std::ptrdiff_t>(end), m_entries.end());
    m_entries[index] = std::move(fresh);
    for (std::size_t later = index + 1; later < end; ++later) {
        if (m_entries[later].stroke.isExact) {
            m_entries[later].stroke.selected.clear(); // on whom there is now
        }
        (void)lay(m_entries[later], context);
    }
    keepWithinBytes();
    return outcome;
}

} // namespace crowd::model
