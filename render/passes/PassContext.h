// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "render/RenderInput.h"
#include "render/style/Style.h"

namespace crowd::render {

class EarlierRows;
class ShaderProgram;

/// Shadows that surfaces receive: what they need to look at the sun's map.
struct ReceivedShadows
{
    glm::mat4 mapFromWorld{1.0F};
    glm::vec2 spread{0.0F}; ///< half the width of soft edges, on the map
    float offset = 0.0F;    ///< metres along the normal at which they look
};

/// What surfaces need to look at the map of the lights that cast shadows, in their order.
struct LightShadows
{
    std::vector<glm::mat4> mapsFromWorld; ///< of each view (viewsOf); perspective: to be divided
    std::vector<float> offsets;           ///< of each light: metres along the normal a metre away
    float spread = 0.0F;                  ///< half the width of edges, on the map
};

inline constexpr int kShadowUnit = 12;      ///< texture unit of the sun's map
inline constexpr int kLightShadowUnit = 13; ///< and of the lights'

/// What every pass of a picture shares; lives for one draw().
struct PassContext
{
    const RenderInput& input;
    glm::mat4 viewProjection;
    Style style;
    glm::ivec2 pixelSize;
    int reduction = 0;       ///< of Passes
    bool isSoftware = false; ///< llvmpipe: work is handed over in small pieces
    RenderStatistics& statistics;
    ReceivedShadows shadows{};            ///< where style.castsShadows()
    LightShadows lightShadows{};          ///< where style.casters.all > 0
    const EarlierRows* earlier = nullptr; ///< of the people, where motion is drawn

    /// Camera and light of a program in use.
    void setCommon(ShaderProgram& program) const;
    void countDraw(std::int64_t triangles) const;
    /// Of what this picture is a part of; else its own size.
    [[nodiscard]] glm::ivec2 wholePixels() const;

private:
    void setLights(ShaderProgram& program) const;
    void setEarlier(ShaderProgram& program) const;
    void setHighlights(ShaderProgram& program) const;
};

} // namespace crowd::render
