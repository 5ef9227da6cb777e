// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <QtCore/QCoreApplication>
#include <QtCore/QSize>
#include <QtGui/QRgb>

#include "model/scene/Timeline.h"

/// How a timeline is laid out: a ruler, a lane of marks for each kind, and a strip of what rules
/// did. Logical pixels.
namespace crowd::widgets {

struct TimelineLane
{
    model::MarkKind kind;
    const char* name; ///< as all texts in the translation context "Timeline"
    const char* add;
    QRgb color;
};

inline constexpr std::array kTimelineLanes{
    TimelineLane{model::MarkKind::Marker, QT_TRANSLATE_NOOP("Timeline", "Markers"),
                 QT_TRANSLATE_NOOP("Timeline", "Add a Marker Here"), 0xFFC9A227},
    TimelineLane{model::MarkKind::Cue, QT_TRANSLATE_NOOP("Timeline", "Cues"),
                 QT_TRANSLATE_NOOP("Timeline", "Call a Cue Here"), 0xFFD9703B},
    TimelineLane{model::MarkKind::State, QT_TRANSLATE_NOOP("Timeline", "States"),
                 QT_TRANSLATE_NOOP("Timeline", "Recall a State Here"), 0xFF4C86C6},
    TimelineLane{model::MarkKind::Event, QT_TRANSLATE_NOOP("Timeline", "Events"),
                 QT_TRANSLATE_NOOP("Timeline", "Send an Event Here"), 0xFF5AA469},
    TimelineLane{model::MarkKind::Camera, QT_TRANSLATE_NOOP("Timeline", "Camera"),
                 QT_TRANSLATE_NOOP("Timeline", "Look from Here On as Now"), 0xFF9C6ADE}};

struct TimelineText
{
    static QString tr(const char* text) { return QCoreApplication::translate("Timeline", text); }
};

/// Index into kTimelineLanes.
[[nodiscard]] inline std::size_t laneOf(model::MarkKind kind)
{
    return static_cast<std::size_t>(std::ranges::find(kTimelineLanes, kind, &TimelineLane::kind) -
                                    kTimelineLanes.begin());
}

struct TimelineLayout
{
    static constexpr int kRuler = 22;
    static constexpr int kNames = 84; ///< of lanes, at the left
    static constexpr int kLane = 24;  ///< at least
    static constexpr int kHighestLane = 44;
    static constexpr int kStrip = 20;
    static constexpr int kLeastWidth = kNames + 160;
    static constexpr int kLanes = static_cast<int>(kTimelineLanes.size());
    static constexpr int kLeastHeight = kRuler + kLanes * kLane + kStrip + 2;

    QSize size{kLeastWidth, kLeastHeight};

    [[nodiscard]] int laneHeight() const
    {
        return std::clamp((size.height() - kRuler - kStrip - 2) / kLanes, kLane, kHighestLane);
    }
    [[nodiscard]] int topOf(std::size_t lane) const
    {
        return kRuler + static_cast<int>(lane) * laneHeight();
    }
    /// Of what rules did.
    [[nodiscard]] int stripTop() const { return topOf(kTimelineLanes.size()); }
    [[nodiscard]] int bottom() const { return stripTop() + kStrip; }
    [[nodiscard]] bool isStrip(int y) const { return y >= stripTop() && y < bottom(); }
    [[nodiscard]] std::optional<model::MarkKind> laneAt(int y) const
    {
        const int lane = (y - kRuler) / laneHeight();
        if (y < kRuler || lane >= kLanes) {
            return std::nullopt;
        }
        return kTimelineLanes[static_cast<std::size_t>(lane)].kind;
    }
};

} // namespace crowd::widgets
