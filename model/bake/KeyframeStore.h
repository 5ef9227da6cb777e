// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "model/base/Bounds.h"
#include "model/template/Template.h"

namespace crowd::model {

/// One vertex of one keyframe, 8 bytes, one RGBA16UI texel: position quantised to the clip's box,
/// normal octahedral (Cigolle et al. 2014), x in the low byte.
struct PackedVertex
{
    std::uint16_t x, y, z;
    std::uint16_t normal;
};
static_assert(sizeof(PackedVertex) == 8);

/// A clip sampled 32 times a second for all levels of a template. Immutable, shared.
struct BakedClip
{
    int keyframes = 1; ///< including the extra one at the end of the loop
    Bounds bounds;     ///< of all keyframes; the quantisation box; template frame, metres
    /// Per level: keyframes × V, keyframe by keyframe, vertices in the mesh's order.
    std::vector<std::vector<PackedVertex>> levels;
    /// Smaller box per keyframe, for culling and picking.
    std::vector<Bounds> keyframeBounds;

    [[nodiscard]] std::size_t bytes() const;
    [[nodiscard]] glm::vec3 position(int level, int keyframe, std::size_t vertex) const;
    [[nodiscard]] glm::vec3 normal(int level, int keyframe, std::size_t vertex) const;
};

using BakedClipPtr = std::shared_ptr<const BakedClip>;

struct ImpostorSet; // Impostor.h
using ImpostorSetPtr = std::shared_ptr<const ImpostorSet>;

/// Bakes clips when first used, in the background, and keeps them under a memory budget.
/// Thread-safe. Until a clip is ready its first keyframe (baked at once, on the calling thread)
/// stands in, so nobody waits. When the budget is reached, a clip stays at its first keyframe and
/// the store says so.
class KeyframeStore
{
public:
    explicit KeyframeStore(std::size_t budgetBytes = std::size_t{512} << 20U);
    ~KeyframeStore();
    KeyframeStore(const KeyframeStore&) = delete;
    KeyframeStore& operator=(const KeyframeStore&) = delete;

    /// Never null. isComplete tells a full clip from its first keyframe standing in.
    struct Entry
    {
        BakedClipPtr clip;
        bool isComplete = false;
    };
    [[nodiscard]] Entry clip(const TemplatePtr& asset, int clipIndex);
    /// The cards of a complete clip in a band, or null while they are baked; for the budget, they
    /// are clips like others.
    [[nodiscard]] ImpostorSetPtr impostors(const TemplatePtr& asset, int clipIndex,
                                           const BakedClipPtr& clip, int band);
    /// Blocks until everything asked for so far is baked (pictures without a window).
    void waitForAll();

    /// Forgets every clip, so that there is room for others. Waits for what is being baked.
    void clear();
    /// Frees the clips of templates that nobody holds any more.
    void releaseUnused();

    struct Progress
    {
        int pendingClips = 0; ///< without impostors, for whom nobody waits
        int finishedClips = 0;
        std::size_t bytes = 0;
        std::size_t budgetBytes = 0;
        bool isBudgetReached = false;
        bool isPaused = false;
    };
    [[nodiscard]] Progress progress() const;
    /// Takes effect with the clips that are asked for from now on; what is baked stays.
    void setBudget(std::size_t bytes);
    /// While paused nothing is baked: what waits or is under way is given up and stays at its first
    /// keyframe. Afterwards it is baked when it is asked for again.
    void setPaused(bool isPaused);
    /// Called on a worker thread after each finished clip; must be cheap (post an event).
    void setFinishedCallback(std::function<void()> callback);
    /// Grows with each finished clip.
    [[nodiscard]] std::uint64_t version() const;

private:
    struct Private;
    std::unique_ptr<Private> m_private;
};

} // namespace crowd::model
