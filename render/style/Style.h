// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/RenderInput.h"
#include "render/style/LinearLight.h"
#include "render/style/PlacedLight.h"

namespace crowd::render {

/// What becomes of light on its way from a surface to the picture.
struct Tone
{
    glm::vec3 gain{1.0F};      ///< exposure and white balance
    bool isFilmic = false;     ///< else what is too bright is white
    float hazePerMetre = 0.0F; ///< as exp(-haze * metres); towards the colour of the horizon
    float hazeHeight = 0.0F;   ///< metres up to where it is thinner by e; 0: everywhere alike
    /// Whether it leaves colours as they are.
    [[nodiscard]] bool isNeutral() const { return gain == glm::vec3(1.0F) && !isFilmic; }
    [[nodiscard]] glm::vec3 of(const glm::vec3& linear) const; ///< as the shaders do it
    [[nodiscard]] std::string defines() const;                 ///< of shaders, but for the haze
    [[nodiscard]] std::string hazeDefines() const;
    [[nodiscard]] static Tone from(const model::Lighting& lighting);
};

/// What a look comes to in one picture: passes read this, not the look. Colours linear unless said
/// otherwise.
struct Style
{
    std::string surfaceDefines; ///< that shaders of people, stages and the ground are compiled with
    LinearLight light;
    std::vector<PlacedLight> lights; ///< that stand in the scene; none where the look has no light
    LightCasters casters;            ///< which of them cast shadows
    glm::vec3 clearColor{0.0F};      ///< where nothing is drawn
    Tone tone;
    /// One colour for all people and one for all stages, instead of their materials.
    struct Paint
    {
        glm::vec3 people{0.5F};
        glm::vec3 stage{0.5F};
    };
    std::optional<Paint> paint;
    bool isWire = false;    ///< edges of triangles
    bool hasCards = true;   ///< people may be impostors
    bool hasRelief = false; ///< normal maps are seen
    bool hasSky = true;
    bool hasGround = true;
    bool hasGrid = true;
    glm::vec3 groundColor{0.5F}; ///< of the plane as it is drawn
    float blobStrength = 0.42F;  ///< of the soft dark under people; 0: none
    glm::vec3 inkColor{0.012F, 0.011F, 0.016F};
    float inkPixels = 0.0F;      ///< width of lines around things, logical; 0: none
    float highlights = 0.0F;     ///< strength of what smooth surfaces mirror; 0: none
    float occlusion = 0.0F;      ///< where little of the sky is seen; 0: none
    float shadowStrength = 0.0F; ///< of what the sun casts; 0: nothing
    float shadowSoftness = 0.0F; ///< radians that the sun takes in the sky
    glm::vec3 selectionColor{1.0F, 0.62F, 0.10F}; ///< sRGB, of outlines
    glm::vec3 hoverColor{1.0F};                   ///< likewise
    float outlinePixels = 2.0F;                   ///< logical

    /// Of what has materials: people and stages.
    [[nodiscard]] std::string materialDefines() const;
    [[nodiscard]] bool castsShadows() const { return shadowStrength > 0.0F; }
    /// The hue of what the sky alone lights against that of what the sun lights too.
    [[nodiscard]] glm::vec3 shadowTint() const;
    [[nodiscard]] static Style of(const RenderInput& input);
    /// Of what is drawn for its places: without light, but with all that hides something.
    [[nodiscard]] static Style ofAovs(const RenderInput& input);
};

} // namespace crowd::render
