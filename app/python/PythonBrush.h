// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "app/python/ScriptScene.h"
#include "model/brush/BrushSettings.h"

namespace crowd::app {

/// Settings of creation as scripts hold them: they name templates by number, and these are the
/// scenes of those that were given by a handle.
struct PythonCreateSettings : model::CreateSettings
{
    std::vector<std::weak_ptr<ScriptScene>> owners;
};

/// What scripts hold of a kind's settings.
template<class Settings>
using PythonSettings = std::conditional_t<std::is_same_v<Settings, model::CreateSettings>,
                                          PythonCreateSettings, Settings>;

namespace detail {
template<class Variant>
struct PythonParts;
template<class... Settings>
struct PythonParts<std::variant<Settings...>>
{
    using type = std::tuple<PythonSettings<Settings>...>;
};
} // namespace detail

/// crowdbrush.Brush. It has the settings of every kind at once, each at its own address as long as
/// it lives, so that what scripts keep of it stays valid when its kind changes.
struct PythonBrush
{
    model::BrushKind kind = model::BrushKind::Create; ///< Python makes one of any number
    model::BrushSettings area;                        ///< what all kinds have; its own part unused
    detail::PythonParts<model::BrushChange>::type parts;

    template<class Settings>
    [[nodiscard]] PythonSettings<Settings>& part()
    {
        return std::get<PythonSettings<Settings>>(parts);
    }
    template<class Settings>
    [[nodiscard]] const PythonSettings<Settings>& part() const
    {
        return std::get<PythonSettings<Settings>>(parts);
    }

    [[nodiscard]] bool isKnownKind() const
    {
        return static_cast<std::size_t>(kind) < model::kBrushCount;
    }
    /// Of its kind, which is known.
    [[nodiscard]] model::BrushSettings settings() const;
    /// The other way.
    [[nodiscard]] static PythonBrush of(const model::BrushSettings& settings);
    friend bool operator==(const PythonBrush& a, const PythonBrush& b);
};

/// The first kind whose settings are attributes of the brush itself and have this key: what
/// scripts set for all of those kinds.
[[nodiscard]] void* sharedAttribute(PythonBrush& brush, std::string_view key,
                                    const model::FieldInfo*& field);

} // namespace crowd::app
