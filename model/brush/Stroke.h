// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <QtCore/QString>

#include "model/brush/BrushContext.h"
#include "model/brush/BrushSettings.h"
#include "model/brush/PointerInput.h"
#include "model/document/SceneDocument.h"
#include "model/view/View.h"

namespace crowd::model {

/// Why a stroke did nothing.
enum class StrokeReason : std::uint8_t {
    None, ///< it did something
    Cancelled,
    NobodyUnderBrush,
    NoFreeSeat,
    NoChosenSeat, ///< none of the ranks and wedges chosen
    NoTemplateChosen,
    TemplateNotLoaded,
    TooSteep,
    NotWalkable,    ///< no way leads there, and the brush creates where people can walk alone
    TooSteepToWalk, ///< as NotWalkable, for another reason: these three
    TooLowToWalk,
    TooNarrowToWalk,
    ForbiddenGround,   ///< within a place that people keep out of
    NothingUnderBrush, ///< the sky
    TooNearToOthers,
    AreaTooFar,
    TooFewInArea,
    ShareTooSmall, ///< thinning out so little came to nobody
    Unchanged,     ///< all of them were so already: BrushInfo::unchanged says it
    NoSuchSlot,
    NoSession, ///< an event that nobody could hear
    NoSuchClip,
    NothingChosen, ///< a brush that is set to change nothing
    ScriptChangedNothing,
    NoDirection,  ///< facing along a stroke that did not go anywhere
    Masked,       ///< the mask means none of them
    GroupLocked,  ///< their group, or the one that new ones come into, is locked or hidden
    NobodyChosen, ///< whom to clone or to face
    NoSuchPart,
    NoSuchFeature,
    NoSuchMaterial, ///< though they have the slot
    OnlySeated,     ///< who sits is not pushed about
    NoState,        ///< to give back: none is chosen, or it is gone
    NoSuchRelation,
    NobodyElse,     ///< it takes two to be related
    NothingToErase, ///< none of them has such a relation
    TooManyAtOnce,  ///< relations of one stroke
    SourcesChosen,  ///< and now those to whom they are to be related
    NoTake,         ///< none is shown of which people could do something again
    TakeBusy        ///< another one is being made
};

/// What a brush says of ground that nobody can walk on.
[[nodiscard]] StrokeReason reasonOf(WalkRefusal refusal);

/// The reason of a brush as a sentence for the status bar; empty for None and Cancelled.
[[nodiscard]] QString reasonText(StrokeReason reason, BrushKind kind = BrushKind::Create);

struct StrokeOutcome
{
    bool isCommitted = false; ///< one undo step was made
    bool isSent = false;      ///< an event reached a session, or people begin a take again
    int affected = 0;         ///< individuals created, removed or changed
    StrokeReason reason = StrokeReason::None;
    QString message;                    ///< reasonText()
    std::vector<IndividualId> chosen{}; ///< SourcesChosen: whom the area held; ascending
};

/// Everything that decides what a stroke does, besides the scene and its assets. Replayed on the
/// same scene it gives the same bytes, once the clips on screen are baked.
struct RecordedStroke
{
    BrushSettings settings;
    std::uint64_t seed = 0;
    Camera camera;
    glm::vec2 viewSize{1.0F};         ///< logical pixels
    std::vector<PointerInput> inputs; ///< press, moves and ticks
    /// False where it may have seen what the scene does not say: clips as they stood in while they
    /// were baked, people where a session has them.
    bool isExact = true;
    int affected = 0; ///< as it was painted
    /// Whom each dab selected, or the whole area in the end. A stroke that is replayed with them
    /// takes these, as far as they are still there; empty: it selects anew.
    std::vector<std::vector<IndividualId>> selected;
};

/// Everything between press and release: applied to the document dab by dab and seen at once.
/// Owned by the drag that makes it; destruction without finish() takes everything back. While it
/// lives the document has its edit open: make no other edits. Main thread.
class Stroke
{
public:
    /// Applies the first dab. `seed` keys all randomness of the stroke. `before`: a stroke of the
    /// same way whose selection it takes, where that has one. Null while something else is edited.
    [[nodiscard]] static std::unique_ptr<Stroke>
    begin(SceneDocument& document, const BrushContext& context, const BrushSettings& settings,
          std::uint64_t seed, const PointerInput& press, const RecordedStroke* before = nullptr);
    ~Stroke();
    Stroke(const Stroke&) = delete;
    Stroke& operator=(const Stroke&) = delete;

    /// The pointer moved, or rests while time goes on (a tick, about each 1/60 s, that keeps a
    /// spray going).
    void move(const PointerInput& input);
    /// The pointer passed here on its way: it is remembered, and nothing is evaluated before the
    /// next move(). For strokes whose area hasWholeArea(); of others it is a move().
    void pass(const PointerInput& input);
    /// The pointer has left: applies what waits for that. finish() does it too; a script that works
    /// on its own thread needs it earlier.
    void settle();
    /// Makes one undo step, or none with a reason.
    [[nodiscard]] StrokeOutcome finish();
    /// Takes everything back.
    void cancel();

    /// Individuals created, removed or changed so far.
    [[nodiscard]] int affected() const;
    /// Whom a brush that works at the release has gathered so far; ascending.
    [[nodiscard]] std::span<const IndividualId> gathered() const;
    [[nodiscard]] const BrushSettings& settings() const;
    [[nodiscard]] const PointerInput& current() const;

private:
    struct Private;
    explicit Stroke(std::unique_ptr<Private> data);
    std::unique_ptr<Private> m_private;
};

/// Paints a recorded stroke again. `ground`: for brushes that create where people can walk alone;
/// `script`: what a brush of kind Script does.
[[nodiscard]] StrokeOutcome replay(SceneDocument& document, KeyframeStore& keyframes,
                                   const StageRays& stage, const RecordedStroke& recording,
                                   WalkableGroundSource ground = {},
                                   ScriptChange* script = nullptr);

/// What a press at this place would create, with the same seed and so the same looks: the ghosts
/// under the cursor. Ids count from 1. Empty for other brushes and where nothing can be created.
[[nodiscard]] IndividualRows previewGhosts(const SceneDocument& document,
                                           const BrushContext& context,
                                           const BrushSettings& settings, std::uint64_t seed,
                                           const PointerInput& at);

} // namespace crowd::model
