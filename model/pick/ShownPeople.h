// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>

#include "model/bake/KeyframeStore.h"
#include "model/scene/CrowdFrame.h"
#include "model/scene/Scene.h"

namespace crowd::model {

/// Index of the asset's clip that a value of the clip column names: by name, the default clip where
/// the asset has no clip of that name, the last name for values beyond the list (as it is drawn).
[[nodiscard]] int assetClip(const TemplateEntry& entry, std::uint16_t clipColumn);

/// A clip as picking needs it: the baked mesh and a cylinder around all its keyframes.
struct ShownClip
{
    const Template* asset = nullptr;
    int clip = 0;
    BakedClipPtr baked;
    float radius = 0.0F; ///< metres from the template's vertical axis
    float low = 0.0F;    ///< metres above the foot point
    float high = 0.0F;
};

/// One individual as it stands on screen.
struct ShownIndividual
{
    const ShownClip* clip = nullptr; ///< null: not shown (no asset, or a hidden group's)
    glm::vec3 position{0.0F};        ///< of the drawn mesh, lifted onto its seat
    float headingRadians = 0.0F;
    float height = 1.0F;
    float girth = 1.0F;
    int keyframe = 0; ///< nearest to the shown time
    std::uint32_t parts = 0;

    [[nodiscard]] glm::mat4 worldFromTemplate() const
    {
        return individualMatrix(position, headingRadians, height, girth);
    }
};

/// Reads a frame the way it is drawn: which clip, which keyframe, how high. Holds the frame.
class ShownPeople
{
public:
    /// Asks the store for every clip in use. Main thread.
    void update(CrowdFramePtr frame, std::span<const WorldSeat> seats, KeyframeStore& keyframes);

    /// Another time of the same people.
    void setTime(CrowdFramePtr frame) { m_frame = std::move(frame); }

    [[nodiscard]] std::size_t size() const { return m_frame ? m_frame->population.size() : 0; }
    [[nodiscard]] const CrowdFramePtr& frame() const { return m_frame; }
    [[nodiscard]] ShownIndividual at(std::size_t row) const;
    /// The clip of a row, null when it is not shown: what of at() does not depend on the time.
    [[nodiscard]] const ShownClip* clipAt(std::size_t row) const;
    /// How far above its foot point a row is drawn.
    [[nodiscard]] float liftAt(std::size_t row, const ShownClip& clip) const;

private:
    struct Entry
    {
        std::vector<ShownClip> byColumn; ///< by value of the clip column; empty: no asset
        std::vector<bool> isKnown;
    };
    void resolveClips(KeyframeStore& keyframes);
    void resolve(Entry& entry, const TemplateEntry& source, std::size_t column,
                 KeyframeStore& keyframes) const;

    CrowdFramePtr m_frame;
    std::vector<std::pair<SeatId, float>> m_seatHeights; ///< ascending
    std::vector<std::int32_t> m_entryOfId;               ///< by template id, -1 none
    std::vector<Entry> m_entries;
};

} // namespace crowd::model
