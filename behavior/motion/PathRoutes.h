// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "behavior/base/Problem.h"
#include "model/scene/Path.h"

namespace crowd::behavior {

/// A place on a path, seen from above; metres.
struct RouteStop
{
    struct Branch
    {
        model::PathId path = 0;
        float weight = 0.0F;
    };
    model::PlaceId place = 0;
    glm::vec2 position{0.0F};
    float height = 0.0F;
    float radius = 0.0F;
    std::vector<Branch> branches{};
};

/// A path that can be walked: it has at least one stop.
struct Route
{
    model::PathId id = 0;
    model::PathKind kind = model::PathKind::Simple;
    std::vector<RouteStop> stops;

    /// Where somebody at `from` goes first: the end of the leg that passes nearest.
    [[nodiscard]] std::uint32_t nextStop(const glm::vec3& from) const;
    /// Metres by which somebody at `at` is beside the leg that ends at a stop, as the vector back
    /// to its edge; zero on it. A leg is as wide as the places at its ends.
    [[nodiscard]] glm::vec2 backToLeg(std::uint32_t stop, const glm::vec2& at) const;
    /// Whether who comes to that stop goes no further.
    [[nodiscard]] bool isEnd(std::uint32_t stop) const
    {
        return stop + 1 == stops.size() && (kind == model::PathKind::Simple || stops.size() == 1);
    }
};

/// Paths as routes, in the order of the scene.
class PathRoutes
{
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

    /// Sentences for the artist about what cannot be walked; that is left out.
    [[nodiscard]] std::vector<Problem> set(std::span<const model::Place> places,
                                           std::span<const model::Path> paths);
    /// Index of a path's route, or kNone.
    [[nodiscard]] std::uint32_t indexOf(model::PathId path) const;
    [[nodiscard]] const Route& operator[](std::uint32_t index) const { return m_routes[index]; }

private:
    [[nodiscard]] static Route routeOf(const model::Path& path,
                                       std::span<const model::Place> places,
                                       std::vector<Problem>& problems);

    std::vector<Route> m_routes;
};

} // namespace crowd::behavior
