// SPDX-License-Identifier: MIT
#include "app/window/DockTable.h"

#include <array>

#include "app/console/ConsoleDock.h"
#include "widgets/docks/Docks.h"

namespace crowd::app {

namespace {

template<class Dock>
QDockWidget* make(const DockParts& parts)
{
    return new Dock(parts.state, parts.parent);
}

QDockWidget* makeConsole(const DockParts& parts)
{
    return new ConsoleDock(parts.interpreter, parts.recorder, parts.parent);
}

constexpr auto kLeft = Qt::LeftDockWidgetArea;
constexpr auto kRight = Qt::RightDockWidgetArea;
constexpr auto kBottom = Qt::BottomDockWidgetArea;

// Groups of tabs, three at the right, so that their names fit the tabs of a small screen. Templates
// have room for two rows, with tabs, title and weight, and states for what is set below their list.
constexpr std::array<DockInfo, static_cast<std::size_t>(DockId::Count)> kDocks{{
    {DockId::Brushes, &make<widgets::BrushPaletteDock>, kLeft, 165},
    {DockId::BrushSettings, &make<widgets::BrushSettingsDock>, kLeft, 500, 280},
    {DockId::Templates, &make<widgets::TemplatesDock>, kRight, 400},
    {DockId::Colour, &make<widgets::ColourDock>, kRight, 296},
    {DockId::Individual, &make<widgets::IndividualDock>, kRight, 270},
    {DockId::Scene, &make<widgets::SceneDock>, kRight, 0, 0, DockId::Templates},
    {DockId::Environment, &make<widgets::EnvironmentDock>, kRight, 0, 0, DockId::Individual},
    // Sentences want room: wide, below the picture.
    {DockId::Rules, &make<widgets::RulesDock>, kBottom, 270, 0, std::nullopt, false, "rules"},
    {DockId::History, &make<widgets::HistoryDock>, kRight, 0, 0, DockId::Scene},
    {DockId::Strokes, &make<widgets::StrokesDock>, kLeft, 0, 0, DockId::BrushSettings},
    {DockId::Presets, &make<widgets::PresetsDock>, kLeft, 0, 0, DockId::BrushSettings},
    {DockId::Groups, &make<widgets::GroupsDock>, kRight, 0, 0, DockId::Individual},
    {DockId::States, &make<widgets::StatesDock>, kRight, 0, 0, DockId::Scene},
    {DockId::Features, &make<widgets::FeaturesDock>, kRight, 0, 0, DockId::Colour},
    {DockId::Relations, &make<widgets::RelationsDock>, kRight, 0, 0, DockId::Features},
    {DockId::Light, &make<widgets::LightDock>, kRight, 430, 0, DockId::Groups},
    {DockId::Looks, &make<widgets::LooksDock>, kLeft, 0, 0, DockId::Presets},
    {DockId::Timeline, &make<widgets::TimelineDock>, kBottom, 0, 0, DockId::Rules, false,
     "timeline"},
    // A list, what is said of it, another list and what is set below that.
    {DockId::Takes, &make<widgets::TakesDock>, kRight, 430, 0, DockId::Relations, false, "takes"},
    {DockId::Console, &makeConsole, kBottom, 0, 0, DockId::Rules, false},
}};

constexpr bool isEveryDockAtItsPlace()
{
    for (std::size_t i = 0; i < kDocks.size(); ++i) {
        const bool isAfterAnother = !kDocks[i].tabAfter || *kDocks[i].tabAfter < kDocks[i].id;
        if (kDocks[i].id != static_cast<DockId>(i) || !isAfterAnother) {
            return false;
        }
    }
    return true;
}
static_assert(isEveryDockAtItsPlace());

} // namespace

std::span<const DockInfo> dockTable()
{
    return kDocks;
}

} // namespace crowd::app
