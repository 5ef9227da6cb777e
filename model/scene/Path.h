// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace crowd::model {

/// Stable names within a scene; 0 is none.
using PlaceId = std::uint32_t;
using PathId = std::uint32_t;

/// What a place does to those who walk. All but spots are parts of the environment that act
/// without anybody being sent to them.
enum class PlaceRole : std::uint8_t {
    Spot,      ///< somewhere to go; does nothing by itself
    Obstacle,  ///< nobody walks into it
    Attractor, ///< people near it are drawn to it
    Repeller,  ///< people near it keep away
    Exit,      ///< who reaches it leaves the scene
    Slow,      ///< people walk slower
    Forbidden, ///< ways lead around it; who is in it walks out
    Preferred  ///< ways lead over it where that is not much longer
};

/// What all of a place lies around, no farther off than its radius.
enum class PlaceShape : std::uint8_t {
    Round, ///< its position
    Line,  ///< the way along its corners: walls, fences, kerbs
    Area   ///< what its corners enclose
};

/// A spot with a size on the ground. World frame, metres.
struct Place
{
    PlaceId id = 0;
    std::string name;
    glm::vec3 position{0.0F};
    float radius = 1.0F;
    std::array<std::uint8_t, 3> color{240, 150, 40}; ///< sRGB
    PlaceRole role = PlaceRole::Spot;
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    /// So many have room; 0: as many as can stand in it, two on a square metre, or one where
    /// people line up (PlaceChoice::FirstFree and Ahead).
    std::uint32_t capacity = 0;
    float speedShare = 0.5F; ///< Slow: of the speed that people would walk with
    PlaceShape shape = PlaceShape::Round;
    std::vector<glm::vec3> corners{}; ///< of a line or an area, in order, from `position`
    friend bool operator==(const Place&, const Place&) = default;
};

inline constexpr float kMinPlaceRadius = 0.05F;
inline constexpr float kMaxPlaceRadius = 200.0F;
inline constexpr std::uint32_t kMaxPlaceCapacity = 100'000;
inline constexpr std::size_t kMostCorners = 1000;
inline constexpr float kFarthestCorner = 10'000.0F; ///< metres from the position, along each axis
inline constexpr float kMinSpeedShare = 0.05F;

/// Whether it changes which ways people take, beside what they meet on them.
[[nodiscard]] constexpr bool changesWays(PlaceRole role)
{
    return role == PlaceRole::Slow || role == PlaceRole::Forbidden || role == PlaceRole::Preferred;
}

/// Bodies that walk, and what they can climb: what the walkable surface is made for. Metres,
/// degrees.
struct SurfaceSettings
{
    float radius = 0.35F;
    float height = 1.8F;
    float climb = 0.45F; ///< steps
    float slopeDegrees = 40.0F;
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const SurfaceSettings&, const SurfaceSettings&) = default;
};

/// What happens at the last place: stop; go on to the first; jump to the first.
enum class PathKind : std::uint8_t { Simple, Cyclic, Teleport };

/// Where some leave a path for the beginning of another one.
struct PathBranch
{
    PlaceId place = 0;
    PathId path = 0;
    float weight = 1.0F;          ///< against 1 for going on
    std::string unknownMembers{}; ///< see Scene::unknownMembers
    friend bool operator==(const PathBranch&, const PathBranch&) = default;
};

/// An ordered list of places to walk along.
struct Path
{
    PathId id = 0;
    std::string name;
    PathKind kind = PathKind::Simple;
    std::vector<PlaceId> places;
    std::vector<PathBranch> branches{};
    std::array<std::uint8_t, 3> color{240, 150, 40}; ///< sRGB
    std::string unknownMembers{};                    ///< see Scene::unknownMembers
    friend bool operator==(const Path&, const Path&) = default;
};

/// Walking speed of those who were given none, m/s.
inline constexpr float kUsualWalkingSpeed = 1.3F;
inline constexpr float kMaxWalkingSpeed = 10.0F;

} // namespace crowd::model
