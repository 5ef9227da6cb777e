// SPDX-License-Identifier: MIT
#include "model/brush/CreationSite.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/base/Parallel.h"
#include "model/base/Random.h"
#include "model/brush/NewPeople.h"
#include "model/brush/Operator.h"
#include "model/scene/PlaceShape.h"

namespace crowd::model {

namespace {

constexpr float kSteepestCosine = 0.64278764F; ///< 50°
constexpr float kReachMetres = 300.0F;         ///< areas are filled so far from the eye
constexpr std::size_t kMostCells = 250000;
constexpr int kProbes = 24;  ///< rays each way that find out what an area covers
constexpr int kAttempts = 4; ///< places tried in a cell
constexpr int kDraws = 8;    ///< of the mix, for a place that is too narrow for some
constexpr std::size_t kCellsPerChunk = 128;
constexpr float kAboveSurface = 0.05F;

constexpr float kStoreyMetres = 2.0F;  ///< what is higher above a place is not on it
constexpr float kPersonRadius = 0.25F; ///< of those whom the minimal distance is meant for, metres
constexpr float kMuchWider = 0.25F;    ///< metres: horses, trucks; the stoutest people are not
constexpr float kDiscSpacing = 1.0F;   ///< radii, along a long body

float widerThanPerson(float radius)
{
    return std::max(radius - kPersonRadius, 0.0F);
}

/// Smaller bodies, as of insects, are in nobody's way.
constexpr float kInTheWay = 0.1F;

/// Where people stand already: discs along those who are longer than wide.
std::vector<GroundDisc> discsOf(const Scene& scene)
{
    const auto positions = scene.population.column(columns::position);
    const auto headings = scene.population.column(columns::heading);
    const auto girths = scene.population.column(columns::girth);
    const auto templates = scene.population.column(columns::templateId);
    std::vector<GroundDisc> discs;
    discs.reserve(positions.size());
    for (std::size_t row = 0; row < positions.size(); ++row) {
        const TemplateEntry* entry = scene.findTemplate(templates[row]);
        const Footprint body =
            entry != nullptr && entry->asset ? entry->asset->footprint : Footprint{};
        const float radius = body.radius * girths[row];
        if (radius < kInTheWay) {
            continue;
        }
        const glm::vec3 way(std::sin(headings[row]), 0.0F, std::cos(headings[row]));
        discs.push_back({positions[row], widerThanPerson(radius)});
        for (const float side : {1.0F, -1.0F}) {
            const float length = (side > 0.0F ? body.front : body.back) * girths[row];
            const int count =
                std::min(static_cast<int>(std::ceil(length / (kDiscSpacing * radius))), 32);
            for (int i = 1; i <= count && std::isfinite(length); ++i) {
                const float along =
                    side * length * static_cast<float>(i) / static_cast<float>(count);
                discs.push_back({positions[row] + along * way, widerThanPerson(radius)});
            }
        }
    }
    return discs;
}

} // namespace

CreationSite::CreationSite(const Scene& scene, const BrushContext& context,
                           const BrushSettings& settings, std::uint64_t seed)
    : m_scene(scene), m_context(context), m_settings(settings), m_seed(seed),
      m_seats(scene, context.view, context.stage, settings.as<CreateSettings>().seats,
              settings.through),
      m_usesSeats(settings.as<CreateSettings>().seats.isOn && m_seats.hasSeats()),
      m_ground(m_usesSeats || settings.as<CreateSettings>().anywhere || !context.ground
                   ? nullptr
                   : context.ground()),
      // Seats keep people apart by themselves.
      m_neighbours(m_usesSeats ? std::vector<GroundDisc>() : discsOf(scene),
                   settings.as<CreateSettings>().minimalDistance),
      m_present(m_neighbours.size())
{
}

/// The room of whoever comes there: a circle, since it is not yet known how he will be turned.
GroundDisc CreationSite::discAt(const glm::vec3& position, std::uint64_t key) const
{
    const TemplateEntry* entry = templateAt(m_scene, m_settings.as<CreateSettings>(), key);
    const Footprint body = entry != nullptr && entry->asset ? entry->asset->footprint : Footprint{};
    return {position, widerThanPerson(body.reach() * m_settings.as<CreateSettings>().girth.high)};
}

std::optional<std::uint64_t> CreationSite::fittingKey(const glm::vec3& position,
                                                      std::uint64_t key) const
{
    for (int draw = 0; draw < kDraws; ++draw) {
        const std::uint64_t drawn = draw == 0 ? key : hashKeys(key, draw);
        const GroundDisc body = discAt(position, drawn);
        if (m_neighbours.isFree(body)) {
            return drawn;
        }
        if (body.wider < kMuchWider) {
            return std::nullopt; // others take hardly less
        }
    }
    return std::nullopt;
}

void CreationSite::take(const Spot& spot)
{
    m_neighbours.add(discAt(spot.position, spot.key));
    ++m_given;
    if (spot.seat != kNoSeat) {
        m_seats.take(spot.seat);
        m_takenSeats.push_back(spot.seat);
    }
}

void CreationSite::reset()
{
    for (const SeatId seat : m_takenSeats) {
        m_seats.release(seat);
    }
    m_takenSeats.clear();
    m_tried.clear();
    m_neighbours.truncate(m_present);
    m_given = 0;
    m_reason = StrokeReason::None;
}

std::optional<Spot> CreationSite::at(glm::dvec2 pixel, const std::optional<ScreenArea>& area)
{
    auto spot = m_usesSeats ? onSeat(pixel, area) : onSurface(pixel);
    if (spot) {
        take(*spot);
    }
    return spot;
}

std::optional<Spot> CreationSite::onSeat(glm::dvec2 pixel, const std::optional<ScreenArea>& area)
{
    const auto seat = m_seats.nearestFree(pixel, area);
    if (!seat) {
        m_reason = m_settings.as<CreateSettings>().seats.isLimited() ? StrokeReason::NoChosenSeat
                                                                     : StrokeReason::NoFreeSeat;
        return std::nullopt;
    }
    // A point that is dragged along seats leaves its share of them free; a click always seats.
    const double share = std::clamp(m_settings.as<CreateSettings>().seatPercent / 100.0, 0.0, 1.0);
    if (m_settings.selection == BrushSelection::Point && m_given > 0 &&
        randomUnit(hashKeys(m_seed, seat->id), DrawPurpose::SeatShare) >= share) {
        return std::nullopt;
    }
    return Spot{seat->seat.position, seat->id, seat->seat.headingRadians,
                hashKeys(m_seed, m_given)};
}

StrokeReason CreationSite::reasonAgainst(const SurfaceHit& surface) const
{
    if (surface.normal.y < kSteepestCosine) {
        return StrokeReason::TooSteep;
    }
    if (!m_settings.as<CreateSettings>().anywhere && isKeptOutOf(surface.point)) {
        return StrokeReason::ForbiddenGround;
    }
    return m_ground ? reasonOf(m_ground->refusal(surface.point)) : StrokeReason::None;
}

/// Whoever began there would first of all walk out of it.
bool CreationSite::isKeptOutOf(const glm::vec3& point) const
{
    return std::ranges::any_of(m_scene.places, [&point](const Place& place) {
        const bool isOne = place.role == PlaceRole::Forbidden || place.role == PlaceRole::Obstacle;
        return isOne && std::abs(point.y - place.position.y) < kStoreyMetres &&
               isWithin(place, point);
    });
}

std::optional<Spot> CreationSite::onSurface(glm::dvec2 pixel)
{
    const auto surface = m_context.stage.hit(m_context.view.rayThrough(glm::vec2(pixel)));
    if (!surface) {
        m_reason = StrokeReason::NothingUnderBrush;
    } else if (const StrokeReason against = reasonAgainst(*surface);
               against != StrokeReason::None) {
        m_reason = against;
    } else if (const auto key = fittingKey(surface->point, hashKeys(m_seed, m_given))) {
        return Spot{surface->point, kNoSeat, 0.0F, *key};
    } else {
        m_reason = StrokeReason::TooNearToOthers;
    }
    return std::nullopt;
}

std::vector<Spot> CreationSite::fill(const ScreenArea& area, bool isWhole)
{
    std::vector<Spot> spots = m_usesSeats ? fillSeats(area, isWhole) : fillSurface(area);
    return spots;
}

std::vector<Spot> CreationSite::fillSeats(const ScreenArea& area, bool isWhole)
{
    const double share = std::clamp(m_settings.as<CreateSettings>().seatPercent / 100.0, 0.0, 1.0);
    std::vector<Spot> spots;
    for (const WorldSeat& seat : m_seats.freeIn(area)) {
        const bool isFirst = m_tried.insert(seat.id).second;
        const std::uint64_t key = hashKeys(m_seed, seat.id);
        if (isWhole || (isFirst && randomUnit(key, DrawPurpose::SeatShare) < share)) {
            spots.push_back({seat.seat.position, seat.id, seat.seat.headingRadians, key});
        }
    }
    if (spots.empty()) {
        m_reason = m_settings.as<CreateSettings>().seats.isLimited() ? StrokeReason::NoChosenSeat
                                                                     : StrokeReason::NoFreeSeat;
    }
    if (isWhole) {
        // The first so many in an order of their own: growing the area keeps most of them.
        const auto kept =
            static_cast<std::size_t>(std::floor(share * static_cast<double>(spots.size()) + 0.5));
        std::ranges::sort(spots, [](const Spot& a, const Spot& b) {
            return a.key != b.key ? a.key < b.key : a.seat < b.seat;
        });
        spots.resize(kept);
        std::ranges::sort(spots, {}, &Spot::seat);
    }
    for (const Spot& spot : spots) {
        take(spot);
    }
    return spots;
}

std::uint64_t CreationSite::keyOf(Cell cell) const
{
    return hashKeys(m_seed, cell.x, cell.z);
}

std::vector<CreationSite::Cell> CreationSite::cellsUnder(const ScreenArea& area)
{
    const View& view = m_context.view;
    const float step = 1.0F / std::sqrt(std::max(m_settings.as<CreateSettings>().density, 0.001F));
    const float reach = view.camera().projection == Projection::Perspective
                            ? kReachMetres
                            : std::numeric_limits<float>::infinity();
    Bounds covered;
    const glm::dvec2 low = glm::max(area.low(), glm::dvec2(0.0));
    const glm::dvec2 high = glm::min(area.high(), glm::dvec2(view.size()));
    for (int y = 0; y <= kProbes; ++y) {
        for (int x = 0; x <= kProbes; ++x) {
            const glm::dvec2 pixel = low + (high - low) * (glm::dvec2(x, y) / double{kProbes});
            if (const auto surface =
                    m_context.stage.hit(view.rayThrough(glm::vec2(pixel)), reach)) {
                covered.add(surface->point);
            }
        }
    }
    if (covered.isEmpty()) {
        m_reason = StrokeReason::NothingUnderBrush;
        return {};
    }
    const auto cellOf = [step](float metres) {
        return static_cast<int>(std::floor(metres / step));
    };
    const int x0 = cellOf(covered.low.x) - 1;
    const int x1 = cellOf(covered.high.x) + 1;
    const int z0 = cellOf(covered.low.z) - 1;
    const int z1 = cellOf(covered.high.z) + 1;
    if (static_cast<double>(x1 - x0 + 1) * (z1 - z0 + 1) > static_cast<double>(kMostCells)) {
        m_reason = StrokeReason::AreaTooFar;
        return {};
    }
    std::vector<Cell> cells;
    for (int z = z0; z <= z1; ++z) {
        for (int x = x0; x <= x1; ++x) {
            if (!m_tried.contains(keyOf({x, z}))) {
                cells.push_back({x, z});
            }
        }
    }
    return cells;
}

std::optional<glm::vec3> CreationSite::candidate(const ScreenArea& area, Cell cell, int attempt,
                                                 StrokeReason& against) const
{
    const float step = 1.0F / std::sqrt(std::max(m_settings.as<CreateSettings>().density, 0.001F));
    const std::uint64_t key = keyOf(cell);
    const auto tried = static_cast<std::uint64_t>(attempt);
    const auto place = [&](int index, DrawPurpose purpose) {
        return static_cast<float>((index + randomUnit(key, purpose, tried)) * step);
    };
    const Bounds& stage = m_context.stage.bounds();
    const float top = stage.isEmpty() ? 1.0F : std::max(stage.high.y, 0.0F) + 1.0F;
    const glm::vec3 from(place(cell.x, DrawPurpose::CellX), top, place(cell.z, DrawPurpose::CellZ));
    for (const SurfaceHit& surface : m_context.stage.below(from)) {
        const auto pixel = m_context.view.project(surface.point);
        if (!pixel || !area.contains({pixel->x, pixel->y})) {
            continue;
        }
        const Ray ray = m_context.view.rayThrough(glm::vec2(*pixel));
        const glm::vec3 above = surface.point + glm::vec3(0.0F, kAboveSurface, 0.0F);
        if (!m_settings.through && m_context.stage.isBlocked(ray.origin, above)) {
            continue;
        }
        const StrokeReason reason = reasonAgainst(surface);
        if (reason == StrokeReason::None) {
            return surface.point;
        }
        against = reason;
    }
    return std::nullopt;
}

std::vector<Spot> CreationSite::fillSurface(const ScreenArea& area)
{
    m_reason = StrokeReason::None;
    std::vector<Cell> open = cellsUnder(area);
    std::vector<Spot> spots;
    StrokeReason against = StrokeReason::TooFewInArea;
    bool hasCrowded = false;
    for (int attempt = 0; attempt < kAttempts && !open.empty(); ++attempt) {
        std::vector<std::optional<glm::vec3>> places(open.size());
        std::vector<StrokeReason> reasons(open.size(), StrokeReason::None);
        parallelFor(open.size(), kCellsPerChunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                places[i] = candidate(area, open[i], attempt, reasons[i]);
            }
        });
        std::vector<Cell> crowded;
        for (std::size_t i = 0; i < open.size(); ++i) {
            against = reasons[i] != StrokeReason::None ? reasons[i] : against;
            const auto key = places[i] ? fittingKey(*places[i], keyOf(open[i])) : std::nullopt;
            if (key) {
                spots.push_back({*places[i], kNoSeat, 0.0F, *key});
                m_tried.insert(keyOf(open[i]));
                take(spots.back());
            } else if (places[i]) {
                crowded.push_back(open[i]);
                hasCrowded = true;
            }
        }
        // Only those whose first place lies inside go on: the area's edge keeps its density.
        open = std::move(crowded);
    }
    if (spots.empty() && m_reason == StrokeReason::None) {
        m_reason = hasCrowded ? StrokeReason::TooNearToOthers : against;
    }
    return spots;
}

} // namespace crowd::model
