// SPDX-License-Identifier: MIT
#include "behavior/takes/EditedTime.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crowd::behavior {

namespace {

constexpr double kRampSeconds = 0.5; ///< in which the pace becomes another one
constexpr double kHeldPace = 1e-3;   ///< and less is none
constexpr double kNever = std::numeric_limits<double>::infinity();

} // namespace

double EditedTime::Stretch::paceAt(double shown) const
{
    const double in = std::clamp((shown - begin) / ramp, 0.0, 1.0);
    const double out = std::clamp((end - shown) / ramp, 0.0, 1.0);
    return 1.0 + (pace - 1.0) * std::min(in, out);
}

bool EditedTime::Stretch::holdsAt(double shown) const
{
    return pace < kHeldPace && shown >= begin + ramp && shown <= end - ramp;
}

EditedTime::EditedTime(std::span<const model::HandEdit> edits, double first, double last)
    : m_first(first), m_last(last)
{
    for (const model::HandEdit& edit : edits) {
        if (edit.kind == model::HandEditKind::Shift) {
            m_later += edit.later;
            continue;
        }
        const double end = edit.end > edit.begin ? edit.end : kNever;
        const double ramp = std::min(kRampSeconds, 0.5 * (end - edit.begin));
        m_stretches.push_back({edit.begin, end, static_cast<double>(edit.pace), ramp});
        m_bends.insert(m_bends.end(), {edit.begin, edit.begin + ramp});
        if (end < kNever) {
            m_bends.insert(m_bends.end(), {end - ramp, end});
        }
    }
    std::ranges::sort(m_bends);
    m_owns.reserve(m_bends.size());
    for (std::size_t i = 0; i < m_bends.size(); ++i) {
        m_owns.push_back(i == 0 ? m_bends[i]
                                : m_owns.back() + ownBetween(m_bends[i - 1], m_bends[i]));
    }
}

double EditedTime::paceAt(double shown) const
{
    double pace = 1.0;
    for (const Stretch& stretch : m_stretches) {
        pace *= stretch.paceAt(shown);
    }
    return pace;
}

/// Own seconds, where the pace does not bend in between: exact for five that change at once
/// (Gauss and Legendre's three points, Abramowitz and Stegun, Handbook of Mathematical Functions,
/// table 25.4).
double EditedTime::ownBetween(double from, double to) const
{
    constexpr double kPlace = 0.774596669241483377;
    constexpr std::array<double, 3> kPlaces{-kPlace, 0.0, kPlace};
    constexpr std::array<double, 3> kWeights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    const double half = 0.5 * (to - from);
    double sum = 0.0;
    for (std::size_t i = 0; i < kPlaces.size(); ++i) {
        sum += kWeights[i] * paceAt(from + half * (1.0 + kPlaces[i]));
    }
    return sum * half;
}

void EditedTime::findHeld(double shown, OwnMoment& moment) const
{
    bool isHeld = false;
    for (const Stretch& stretch : m_stretches) {
        if (stretch.holdsAt(shown)) {
            moment.heldFor =
                std::max(isHeld ? moment.heldFor : 0.0, shown - stretch.begin - stretch.ramp);
            isHeld = true;
        } else if (stretch.pace < kHeldPace && shown > stretch.end - stretch.ramp) {
            moment.letGoFor = std::min(moment.letGoFor, shown - (stretch.end - stretch.ramp));
        }
    }
    moment.pace = isHeld ? 0.0 : moment.pace;
}

OwnMoment EditedTime::at(double shown) const
{
    OwnMoment moment;
    moment.pace = paceAt(shown);
    const auto next = std::ranges::upper_bound(m_bends, shown);
    moment.seconds = shown;
    if (next != m_bends.begin()) {
        const auto bend = static_cast<std::size_t>(next - m_bends.begin()) - 1;
        moment.seconds = m_owns[bend] + ownBetween(m_bends[bend], shown);
    }
    moment.seconds -= m_later;
    findHeld(shown, moment);
    const double sinceFirst = moment.seconds - m_first;
    const double sinceLast = moment.seconds - m_last;
    if (moment.pace > 0.0 && (sinceFirst < 0.0 || sinceLast > 0.0)) {
        moment.heldFor = (sinceFirst < 0.0 ? sinceFirst : sinceLast) / moment.pace;
        moment.pace = 0.0;
    } else if (moment.pace > 0.0 && m_later > 0.0) {
        moment.letGoFor = std::min(moment.letGoFor, sinceFirst / moment.pace);
    }
    moment.seconds = std::clamp(moment.seconds, m_first, m_last);
    return moment;
}

} // namespace crowd::behavior
