// SPDX-License-Identifier: MIT
#pragma once

#include <bitset>
#include <tuple>
#include <type_traits>
#include <utility>

#include "model/scene/Scene.h"
#include "model/scene/SceneChange.h"

/// What a scene holds beside its people, each member described once. Undo, deltas, comparison,
/// project files, scripts' environment and recordings are functions over SceneMembers; the compiler
/// asks for what a new member lacks where its type is not described by fields: isSame() and
/// bytesOf() (model/document/MemberEntries.h), memberJson() and readMember()
/// (model/project/MemberJson.h).
namespace crowd::model {

enum class MemberKind : std::uint8_t {
    Entries, ///< a list by ascending `id`; deltas hold the entries that changed
    Value,   ///< deltas hold the whole
    Table    ///< deltas are of a type of its own
};

template<auto Pointer, class Change, MemberKind Kind>
struct SceneMember
{
    static constexpr auto pointer = Pointer;
    static constexpr MemberKind kind = Kind;
    using Type = std::remove_cvref_t<decltype(std::declval<Scene&>().*Pointer)>;
    using Changed = Change; ///< what is announced
    /// Whether scripts read and set it with the environment (see EnvironmentText.h).
    static constexpr bool isEnvironment =
        std::is_same_v<Change, PathsChanged> || std::is_same_v<Change, RulesChanged> ||
        std::is_same_v<Change, GroupsChanged> || std::is_same_v<Change, FeaturesChanged> ||
        std::is_same_v<Change, RelationKindsChanged> || std::is_same_v<Change, LightsChanged> ||
        std::is_same_v<Change, LooksChanged> || std::is_same_v<Change, TimelineChanged>;
    /// Whether files are without it where there is nothing of it.
    static constexpr bool isOptional = isEnvironment || std::is_same_v<Change, StatesChanged> ||
                                       std::is_same_v<Change, RelationsChanged> ||
                                       std::is_same_v<Change, TakesChanged>;
    [[nodiscard]] static const Type& of(const Scene& scene) { return scene.*Pointer; }
    [[nodiscard]] static Type& of(Scene& scene) { return scene.*Pointer; }
};

/// `key`: the member's name in project files.
namespace members {

struct Templates : SceneMember<&Scene::templates, TemplatesChanged, MemberKind::Entries>
{
    static constexpr const char* key = "templates";
};
struct Stages : SceneMember<&Scene::stages, StagesChanged, MemberKind::Entries>
{
    static constexpr const char* key = "stages";
};
struct Places : SceneMember<&Scene::places, PathsChanged, MemberKind::Entries>
{
    static constexpr const char* key = "places";
};
struct Paths : SceneMember<&Scene::paths, PathsChanged, MemberKind::Entries>
{
    static constexpr const char* key = "paths";
};
struct Groups : SceneMember<&Scene::groups, GroupsChanged, MemberKind::Value>
{
    static constexpr const char* key = "groups";
};
struct Cameras : SceneMember<&Scene::cameras, CamerasChanged, MemberKind::Value>
{
    static constexpr const char* key = "cameras";
};
struct Light : SceneMember<&Scene::lighting, LightingChanged, MemberKind::Value>
{
    static constexpr const char* key = "lighting";
};
struct Lights : SceneMember<&Scene::lights, LightsChanged, MemberKind::Value>
{
    static constexpr const char* key = "lights";
};
struct Looks : SceneMember<&Scene::looks, LooksChanged, MemberKind::Value>
{
    static constexpr const char* key = "looks";
};
struct Tags : SceneMember<&Scene::tags, RulesChanged, MemberKind::Value>
{
    static constexpr const char* key = "tags";
};
struct Rules : SceneMember<&Scene::rules, RulesChanged, MemberKind::Value>
{
    static constexpr const char* key = "rules";
};
struct Numbers : SceneMember<&Scene::numbers, RulesChanged, MemberKind::Value>
{
    static constexpr const char* key = "numbers";
};
struct Cues : SceneMember<&Scene::cues, RulesChanged, MemberKind::Value>
{
    static constexpr const char* key = "cues";
};
struct Steps : SceneMember<&Scene::stepsPerSecond, RulesChanged, MemberKind::Value>
{
    static constexpr const char* key = "stepsPerSecond";
};
struct Surface : SceneMember<&Scene::surface, PathsChanged, MemberKind::Value>
{
    static constexpr const char* key = "surface";
};

struct Features : SceneMember<&Scene::features, FeaturesChanged, MemberKind::Value>
{
    static constexpr const char* key = "features";
};
struct RelationKinds : SceneMember<&Scene::relationKinds, RelationKindsChanged, MemberKind::Value>
{
    static constexpr const char* key = "relationKinds";
};
struct Relations : SceneMember<&Scene::relations, RelationsChanged, MemberKind::Table>
{
    static constexpr const char* key = "relations";
};
struct States : SceneMember<&Scene::states, StatesChanged, MemberKind::Value>
{
    static constexpr const char* key = "states";
};
struct Timeline : SceneMember<&Scene::timeline, TimelineChanged, MemberKind::Value>
{
    static constexpr const char* key = "timeline";
};
struct Range : SceneMember<&Scene::playRange, TimelineChanged, MemberKind::Value>
{
    static constexpr const char* key = "playRange";
};
struct Takes : SceneMember<&Scene::takes, TakesChanged, MemberKind::Value>
{
    static constexpr const char* key = "takes";
};

} // namespace members

/// The one list. A member comes after those that it refers to: undo takes it back before them.
using SceneMembers =
    std::tuple<members::Templates, members::Stages, members::Places, members::Paths,
               members::Groups, members::Cameras, members::Light, members::Lights, members::Looks,
               members::Tags, members::Rules, members::Numbers, members::Cues, members::Steps,
               members::Surface, members::Features, members::RelationKinds, members::Relations,
               members::States, members::Timeline, members::Range, members::Takes>;

inline constexpr std::size_t kMemberCount = std::tuple_size_v<SceneMembers>;

namespace detail {

template<class M, class... All>
constexpr std::size_t memberIndex(const std::tuple<All...>*)
{
    constexpr bool kIsIt[] = {std::is_same_v<M, All>...};
    std::size_t index = 0;
    while (!kIsIt[index]) {
        ++index;
    }
    return index;
}

} // namespace detail

/// Some of the members.
class MemberSet
{
public:
    template<class M>
    void add()
    {
        m_bits.set(detail::memberIndex<M>(static_cast<const SceneMembers*>(nullptr)));
    }
    template<class M>
    [[nodiscard]] bool contains() const
    {
        return m_bits.test(detail::memberIndex<M>(static_cast<const SceneMembers*>(nullptr)));
    }
    [[nodiscard]] bool isEmpty() const { return m_bits.none(); }
    [[nodiscard]] bool intersects(const MemberSet& other) const
    {
        return (m_bits & other.m_bits).any();
    }

private:
    std::bitset<kMemberCount> m_bits;
};

/// Calls act(member) for each of them, in the list's order; member is an object without data.
template<class Act>
constexpr void forEachMember(const Act& act)
{
    std::apply([&act](const auto&... member) { (act(member), ...); }, SceneMembers());
}

} // namespace crowd::model
