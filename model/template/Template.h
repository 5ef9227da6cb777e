// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "model/base/Bounds.h"
#include "model/base/Message.h"
#include "model/template/ClipRole.h"

/// The template as imported: immutable once loaded, shared by pointer between threads.
/// Frame: right-handed, metres, Y up, the character faces +Z (any correction proposed by the import
/// dialog is already applied through Template::rootCorrection). Times in seconds.
namespace crowd::model {

/// Slots that can be tinted; further ones are drawn but not tinted.
inline constexpr int kMaxTintSlots = 8;
/// Levels of detail, 0 the finest.
inline constexpr int kMaxLevels = 4;
/// Keyframes a second.
inline constexpr int kKeyframeRate = 32;

/// A picture, decoded to straight-alpha RGBA8, sRGB, rows from the top (glTF's UV origin).
struct Image
{
    std::string name;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< width × height × 4
};

enum class AlphaMode : std::uint8_t { Opaque, Mask, Blend };
enum class Wrap : std::uint8_t { Repeat, Mirror, Clamp };

/// One appearance a slot can have; choice 0 is the default, the others come from
/// KHR_materials_variants.
struct MaterialChoice
{
    std::string name;          ///< name of the variant; of the material for choice 0
    glm::vec4 baseColor{1.0F}; ///< linear factor, alpha in w
    int image = -1;            ///< index into Template::images, -1 none
    int tintMask = -1;         ///< index into Template::images (red channel), -1: all
    Wrap wrapU = Wrap::Repeat;
    Wrap wrapV = Wrap::Repeat;
    bool nearest = false; ///< magnification filter NEAREST; these three of the emissive picture
                          ///< where it is the only one
    AlphaMode alphaMode = AlphaMode::Opaque;
    float alphaCutoff = 0.5F;
    bool doubleSided = false;
    bool unlit = false;
    /// KHR_texture_transform of the base colour: uv' = uvTransform * (u, v, 1), rows of a 2×3.
    std::array<float, 6> uvTransform{1, 0, 0, 0, 1, 0};
    glm::vec3 emissive{0.0F}; ///< linear; times the picture, where there is one
    int emissiveImage = -1;   ///< index into Template::images, -1 none; lies by the same uv
    std::array<float, 6> emissiveUvTransform{1, 0, 0, 0, 1, 0};
    float roughness = 1.0F;   ///< 0 a mirror, 1 without highlights
    float metallic = 0.0F;    ///< 1: mirrors in its own colour
    int normalImage = -1;     ///< tangent space, glTF's; index into the images, -1 none
    float normalScale = 1.0F; ///< of its x and y
    std::array<float, 6> normalUvTransform{1, 0, 0, 0, 1, 0};
};

/// A named material of the template that each individual may tint and re-texture on its own.
struct Slot
{
    std::string name;
    bool tintable = true;
    /// Whether new people get one of the palette's tints there; else only who asks for a tint.
    /// Files that know nothing of tints look as they were painted.
    bool takesPalette = true;
    std::vector<MaterialChoice> choices; ///< never empty
};

/// A piece that can be shown or hidden per individual (hat, bag): bit i of the parts column.
struct Part
{
    std::string name;
    bool shownByDefault = true;
};

/// A transform that vertices follow: matrix = world(node) * inverseBind. Skin joints become bones;
/// a mesh without skin becomes one bone of its own node with identity inverse bind.
struct Bone
{
    int node = 0;
    glm::mat4 inverseBind{1.0F};
};

/// Triangles of one slot and one part within a level.
struct Submesh
{
    int slot = 0;
    int part = -1; ///< index into Template::parts, -1: always shown
    std::uint32_t firstIndex = 0;
    std::uint32_t indexCount = 0; ///< multiple of 3
};

/// One level of detail. Arrays are V long (influences V × influencesPerVertex), in file order:
/// nodes depth first, primitives in order, vertices as in the file before any welding.
struct Mesh
{
    std::vector<glm::vec3> positions; ///< bind pose, in the space of the mesh
    std::vector<glm::vec3> normals;   ///< unit, same space
    std::vector<glm::vec2> uv;        ///< base-colour set; zeros where the file has none
    std::vector<glm::u8vec4> colors;  ///< linear vertex colour, 255 = 1
    /// The first so many vertices are the file's; behind them are copies made for flat normals.
    std::size_t fileVertexCount = 0;
    int influencesPerVertex = 1;
    std::vector<std::uint16_t> bones; ///< indices into Template::bones
    std::vector<float> weights;       ///< sum 1 for each vertex
    std::vector<std::uint32_t> indices;
    std::vector<Submesh> submeshes;

    [[nodiscard]] std::size_t triangleCount() const { return indices.size() / 3; }
};

/// A node of the file, kept for animation. Parents come before their children.
struct Node
{
    std::string name;
    int parent = -1;
    glm::vec3 translation{0.0F};
    glm::quat rotation{1.0F, 0.0F, 0.0F, 0.0F};
    glm::vec3 scale{1.0F};
    std::optional<glm::mat4> matrix; ///< where the file gives a matrix instead
};

enum class ChannelPath : std::uint8_t { Translation, Rotation, Scale };
enum class Interpolation : std::uint8_t { Step, Linear, CubicSpline };

/// One animated component of one node. values: K × (3 or 4) floats (quaternion x y z w); three
/// times as many for CubicSpline (in-tangent, value, out-tangent). Times strictly increase.
struct Channel
{
    int node = 0;
    ChannelPath path = ChannelPath::Translation;
    Interpolation interpolation = Interpolation::Linear;
    std::vector<float> times;
    std::vector<float> values;
};

struct Clip
{
    std::string name;
    float startSeconds = 0.0F; ///< of the first key of any channel
    float seconds = 0.0F;      ///< from the first to the last key; 0 for a pose
    bool loop = true;
    std::optional<float> seatHeight; ///< height of the seat plane: the clip sits
    /// Ground speed at playback speed 1, m/s: from root motion, the extras or foot contact.
    float speed = 0.0F;
    /// Net horizontal displacement over the clip that the baker removes linearly, template frame.
    glm::vec3 rootMotion{0.0F};
    int rootMotionNode = -1;    ///< the node, with all below it, that it is taken from; -1 none
    bool hasSpeedExtra = false; ///< the file itself gave the speed
    ClipRole role = ClipRole::Other;
    bool hasRoleExtra = false; ///< the file itself gave the role
    /// Which way the body goes, horizontal unit vector, template frame; zero where it is not known.
    glm::vec3 way{0.0F};
    bool isAloft = false;  ///< a gait in which the body never touches the ground
    bool isMadeUp = false; ///< the resting pose of a file without animations
    std::vector<Channel> channels;

    /// Keyframes baked: one each 1/32 s plus the extra one at the end of the loop.
    [[nodiscard]] int keyframeCount() const;
    /// When keyframe k is sampled, seconds after the start: k / 32, the last one at the very end.
    /// Where the duration is no multiple of 1/32 s the last interval is therefore between half and
    /// one and a half times as long as the others.
    [[nodiscard]] float keyframeSeconds(int keyframe) const;
    /// The inverse: which keyframe (with the fraction towards the next) a moment falls on.
    [[nodiscard]] float keyframeAt(float secondsAfterStart) const;
};

/// How much room a body takes, seen from above: a disc of that radius, moved from the origin so far
/// to the front and so far to the back. Metres, template frame.
struct Footprint
{
    float radius = 0.25F;
    float front = 0.0F; ///< 0: it is as long as it is wide
    float back = 0.0F;

    [[nodiscard]] float reach() const { return radius + (front > back ? front : back); }
};

struct Template
{
    std::string name;
    std::vector<Node> nodes;
    std::vector<Bone> bones;
    int jointCount = 0;       ///< nodes that are joints of a skin in use
    std::vector<Mesh> levels; ///< 1..kMaxLevels, finest first
    std::vector<Slot> slots;
    std::vector<Part> parts; ///< at most 32
    std::vector<Image> images;
    std::vector<Clip> clips;        ///< never empty: a file without any gets a "static" pose
    int defaultClip = 0;            ///< standing
    int seatedClip = -1;            ///< first clip with a seat height, -1 none
    glm::mat4 rootCorrection{1.0F}; ///< applied left of every node's world matrix
    Bounds bounds;                  ///< of the default clip's first keyframe, corrected
    float height = 0.0F;            ///< metres, of the same keyframe
    Footprint footprint;            ///< of the same keyframe
    std::vector<Message> warnings;  ///< for the artist

    [[nodiscard]] int clipIndex(const std::string& clipName) const; ///< -1 if there is none
    [[nodiscard]] int slotIndex(const std::string& slotName) const; ///< -1 if there is none
};

using TemplatePtr = std::shared_ptr<const Template>;

} // namespace crowd::model
