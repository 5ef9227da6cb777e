// SPDX-License-Identifier: MIT
#pragma once

#include "model/states/StateKeeping.h"
#include "tests/behavior/RuleScenes.h"

/// A blue crowd with a state in which it is red, tall and seated, for tests of sessions.
namespace crowd::testing {

using namespace crowd::model;

inline constexpr std::uint16_t kIdle = 0;
inline constexpr std::uint16_t kClap = 3;
inline constexpr std::uint16_t kSit = 4;
inline constexpr Tint kRed{200, 0, 0, 255};
inline constexpr Tint kBlue{0, 0, 100, 255};
inline constexpr int kStepsPerSecond = 30;

template<class T>
void putAll(Scene& scene, ColumnKey<T> key, T value)
{
    const std::vector<IndividualId> ids(scene.population.ids().begin(),
                                        scene.population.ids().end());
    scene.population.setValues(key, std::span<const IndividualId>(ids),
                               std::span<const T>(std::vector<T>(ids.size(), value)));
}

/// A blue crowd that idles, and a state of it: red, tall and seated.
inline Scene sceneWithState(std::size_t people = 5)
{
    Scene scene = rowOf(people);
    putAll(scene, columns::tint(0), kBlue);
    Scene other = scene;
    putAll(other, columns::tint(0), kRed);
    putAll(other, columns::height, 2.0F);
    putAll(other, columns::clip, kSit);
    State state = keepState(other, "red", usualStateColumns(), other.population.ids());
    state.id = 1;
    scene.states.push_back(std::move(state));
    return scene;
}

inline ChangeOver changeOver(const Scene& scene, float seconds, Stagger stagger = {})
{
    const State& state = scene.states.front();
    return {state.id, peopleOf(scene, state), state.columns, {seconds, stagger}};
}

inline Scene recalled(const Scene& scene)
{
    Scene now = scene;
    (void)recallState(now, scene.states.front(), scene.states.front().columns);
    return now;
}

inline Tint tintOf(const Session& session, std::size_t row)
{
    return session.frame()->population.column(columns::tint(0))[row];
}

inline float heightOf(const Session& session, std::size_t row)
{
    return session.frame()->population.column(columns::height)[row];
}

} // namespace crowd::testing
