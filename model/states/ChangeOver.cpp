// SPDX-License-Identifier: MIT
#include "model/states/ChangeOver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/Random.h"

namespace crowd::model {

namespace {

constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN(); ///< begins at once

const Seat* seatOf(const Scene& scene, SeatId id)
{
    const StageEntry* stage =
        id == kNoSeat ? nullptr : scene.findStage(static_cast<std::uint8_t>(id >> 24U));
    const std::size_t index = id & 0xFFFFFFU;
    return stage != nullptr && stage->asset && index < stage->asset->seats.size()
               ? &stage->asset->seats[index]
               : nullptr;
}

/// Where somebody stands in the order; any unit.
class OrderOf
{
public:
    OrderOf(const ChangeOver& change, const Scene& scene, const Population& people)
        : m_change(change), m_scene(scene), m_positions(people.column(columns::position)),
          m_seats(people.column(columns::seat))
    {
    }
    [[nodiscard]] float operator()(IndividualId id, std::size_t row) const
    {
        const Stagger& stagger = m_change.timing.stagger;
        switch (stagger.order) {
        case StaggerOrder::Distance:
            return std::hypot(m_positions[row].x - stagger.point.x,
                              m_positions[row].z - stagger.point.z);
        case StaggerOrder::Heading:
            return m_positions[row].x * std::sin(stagger.headingRadians) +
                   m_positions[row].z * std::cos(stagger.headingRadians);
        case StaggerOrder::Row:
            return numberOf(row, &Seat::rank);
        case StaggerOrder::Wedge:
            return numberOf(row, &Seat::wedge);
        case StaggerOrder::Random:
            return unitFloat(hashKeys(hashText("recall"), m_change.state, id));
        }
        return kNowhere;
    }

private:
    [[nodiscard]] float numberOf(std::size_t row, int Seat::*number) const
    {
        const Seat* seat = seatOf(m_scene, m_seats[row]);
        return seat == nullptr ? kNowhere : static_cast<float>(seat->*number);
    }

    const ChangeOver& m_change;
    const Scene& m_scene;
    std::span<const glm::vec3> m_positions;
    std::span<const SeatId> m_seats;
};

} // namespace

std::vector<float> delaysOf(const ChangeOver& change, const Scene& scene, const Population& people)
{
    std::vector<float> delays(change.ids.size(), kNowhere);
    const OrderOf orderOf(change, scene, people);
    float first = std::numeric_limits<float>::infinity();
    float last = -first;
    for (std::size_t i = 0; i < delays.size(); ++i) {
        const std::size_t row = people.rowOf(change.ids[i]);
        const float order = row == Population::npos ? kNowhere : orderOf(change.ids[i], row);
        if (std::isfinite(order)) {
            delays[i] = order;
            first = std::min(first, order);
            last = std::max(last, order);
        }
    }
    const bool isRandom = change.timing.stagger.order == StaggerOrder::Random;
    first = isRandom ? 0.0F : first; // a few of them are spread as many would be
    const float width = isRandom ? 1.0F : last - first;
    for (float& delay : delays) {
        const bool isLater = std::isfinite(delay) && width > 0.0F;
        delay = isLater ? (delay - first) / width * change.timing.stagger.seconds : 0.0F;
    }
    return delays;
}

} // namespace crowd::model
