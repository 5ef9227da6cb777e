// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <QtCore/QObject>

#include "model/brush/BrushContext.h"
#include "model/brush/Stroke.h"
#include "model/document/SceneDocument.h"

namespace crowd::model {

/// The last strokes of a document, which can be laid anew with other settings: those that the
/// latest undo steps are, without another edit between them. Each stays one undo step. Undone ones
/// come back when they are redone. So many are kept as fit into kMostBytes and a quarter of the
/// memory for undo, which includes them. Main thread; the
/// document outlives it.
class LastStrokes : public QObject
{
    Q_OBJECT

public:
    /// What strokes are laid through; of its view nothing is asked.
    using ContextSource = std::function<BrushContext()>;

    static constexpr std::size_t kMostBytes = std::size_t{32} << 20U;

    struct Entry
    {
        RecordedStroke stroke;
        std::optional<int> step; ///< index in the undo stack; none: it finds nobody as it is now
        int affected = 0;
        bool isBarrier = false; ///< an edit of another kind: `stroke` means nothing
    };

    explicit LastStrokes(SceneDocument& document);

    /// Empty: nothing can be laid anew.
    void setContext(ContextSource source) { m_context = std::move(source); }

    /// Those that can be laid anew, oldest first. Good until the next edit.
    [[nodiscard]] std::span<const Entry> tail() const;
    /// Whether a stroke that was just committed, replayed with whom it selected, comes to the same
    /// on the scene as it was before, wherever people were on screen. Takes as long as the stroke.
    [[nodiscard]] bool comesToTheSame(const StepCommitted& step) const;
    /// Lays one of tail() anew, and those after it again. Whom it selected is kept where its area
    /// is the same, so that it is right also for people who were elsewhere in a session; another
    /// area selects in the recorded view. Where nobody is changed, all stays as it was; of those
    /// after it, who finds nobody any more waits without a step, for when it does again.
    StrokeOutcome layAnew(std::size_t index, const BrushSettings& settings, std::uint64_t seed);

Q_SIGNALS:
    void changed();

private:
    void note(const StepCommitted& step);
    void keepWithinBytes();
    void forgetAll();
    [[nodiscard]] std::size_t tailBegin() const;
    [[nodiscard]] std::size_t tailEnd() const;
    [[nodiscard]] int stepOf(std::size_t entry) const;
    StrokeOutcome lay(Entry& entry, const BrushContext& context);
    StrokeOutcome replace(std::size_t index, Entry fresh);

    SceneDocument& m_document;
    ContextSource m_context;
    std::vector<Entry> m_entries; ///< in the order of the undo stack
    bool m_isLaying = false;
};

/// Whether strokes with these settings select the same, laid in the same view on the same people.
[[nodiscard]] bool selectAlike(const BrushSettings& a, const BrushSettings& b);

} // namespace crowd::model
