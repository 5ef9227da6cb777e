// SPDX-License-Identifier: MIT
#include "model/document/MemberEntries.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace crowd::model {

namespace {

bool isSame(float a, float b)
{
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

bool isSame(const glm::vec3& a, const glm::vec3& b)
{
    return isSame(a.x, b.x) && isSame(a.y, b.y) && isSame(a.z, b.z);
}

bool isSame(const glm::quat& a, const glm::quat& b)
{
    return isSame(a.x, b.x) && isSame(a.y, b.y) && isSame(a.z, b.z) && isSame(a.w, b.w);
}

bool isSame(const ImportSettings& a, const ImportSettings& b)
{
    return isSame(a.scale, b.scale) && isSame(a.rotation, b.rotation) &&
           isSame(a.groundOffset, b.groundOffset) && a.removeRootMotion == b.removeRootMotion &&
           a.unknownMembers == b.unknownMembers;
}

bool isSame(const Camera& a, const Camera& b)
{
    return isSame(a.position, b.position) && isSame(a.orientation, b.orientation) &&
           a.projection == b.projection && isSame(a.fovYRadians, b.fovYRadians) &&
           isSame(a.orthographicHeight, b.orthographicHeight) &&
           isSame(a.pivotDistance, b.pivotDistance);
}

} // namespace

bool isSame(const TemplateEntry& a, const TemplateEntry& b)
{
    return a.name == b.name && a.path == b.path && isSame(a.import, b.import) &&
           a.clipNames == b.clipNames && a.clipRoles == b.clipRoles &&
           std::ranges::equal(a.clipSpeeds, b.clipSpeeds,
                              [](float left, float right) { return isSame(left, right); }) &&
           a.asset == b.asset && a.problem == b.problem && a.unknownMembers == b.unknownMembers;
}

bool isSame(const StageEntry& a, const StageEntry& b)
{
    return a.name == b.name && a.path == b.path && isSame(a.position, b.position) &&
           isSame(a.headingRadians, b.headingRadians) && isSame(a.scale, b.scale) &&
           a.asset == b.asset && a.problem == b.problem && a.unknownMembers == b.unknownMembers;
}

bool isSame(const NamedCamera& a, const NamedCamera& b)
{
    return a.name == b.name && isSame(a.camera, b.camera) && a.look == b.look &&
           a.unknownMembers == b.unknownMembers;
}

bool isSame(const Place& a, const Place& b)
{
    return a.name == b.name && isSame(a.position, b.position) && isSame(a.radius, b.radius) &&
           a.color == b.color && a.role == b.role && a.capacity == b.capacity &&
           isSame(a.speedShare, b.speedShare) && a.shape == b.shape &&
           std::ranges::equal(
               a.corners, b.corners,
               [](const glm::vec3& x, const glm::vec3& y) { return isSame(x, y); }) &&
           a.unknownMembers == b.unknownMembers;
}

bool isSame(const Path& a, const Path& b)
{
    return a == b;
}

bool isSame(const SurfaceSettings& a, const SurfaceSettings& b)
{
    return a == b;
}

bool isSame(const State& a, const State& b)
{
    return a == b; // of columns, the bytes
}

bool isSame(const TagName& a, const TagName& b)
{
    return a == b;
}

bool isSame(const NumberName& a, const NumberName& b)
{
    return a == b && isSame(a.low, b.low) && isSame(a.high, b.high) &&
           std::ranges::equal(a.values, b.values, [](const auto& x, const auto& y) {
               return isSame(x.second, y.second);
           });
}

bool isSame(const Cue& a, const Cue& b)
{
    return a == b && isSame(a.payload, b.payload);
}

namespace {

/// Of values that may hold numbers; all others are the same where they are equal.
template<class Value>
bool hasSameBits(const Value&, const Value&)
{
    return true;
}
bool hasSameBits(float a, float b)
{
    return isSame(a, b);
}
bool hasSameBits(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool hasSameBits(const glm::vec3& a, const glm::vec3& b)
{
    return isSame(a, b);
}
bool hasSameBits(const ValueRange& a, const ValueRange& b)
{
    return isSame(a.low, b.low) && isSame(a.high, b.high);
}
bool hasSameBits(const std::vector<ClipWeight>& a, const std::vector<ClipWeight>& b)
{
    return std::ranges::equal(
        a, b, [](const ClipWeight& x, const ClipWeight& y) { return isSame(x.weight, y.weight); });
}

/// A number that is none equals nothing; else numbers of the same bits are equal.
template<class Value>
bool areEqual(const Value& a, const Value& b)
{
    if constexpr (std::is_floating_point_v<Value> || std::is_same_v<Value, glm::vec3>) {
        return true; // the bits decide
    } else {
        return a == b;
    }
}

bool isSame(const FieldValue& a, const FieldValue& b)
{
    return std::visit(
        [&b](const auto& value) {
            const auto& other = std::get<std::remove_cvref_t<decltype(value)>>(b);
            return areEqual(value, other) && hasSameBits(value, other);
        },
        a);
}

template<class Part>
bool isSamePart(const Part& a, const Part& b)
{
    return a.data.index() == b.data.index() && a.unknownMembers == b.unknownMembers &&
           areFieldsSame(a.kind().fields, a.object(), b.object());
}

template<class Part>
bool areSame(const std::vector<Part>& a, const std::vector<Part>& b)
{
    return std::ranges::equal(a, b, [](const Part& x, const Part& y) { return isSamePart(x, y); });
}

/// Of a field, what lies outside its struct.
std::size_t bytesOutside(const FieldValue& value)
{
    if (const auto* text = std::get_if<std::string>(&value)) {
        return text->size();
    }
    const auto* clips = std::get_if<std::vector<ClipWeight>>(&value);
    return clips != nullptr ? clips->size() * sizeof(ClipWeight) : 0;
}

} // namespace

namespace {

bool areItemsSame(const FieldInfo& list, void* a, void* b)
{
    const std::size_t count = list.count(a);
    bool isSame = count == list.count(b);
    for (std::size_t i = 0; i < count && isSame; ++i) {
        void* left = list.itemOf(a, i);
        void* right = list.itemOf(b, i);
        isSame = areFieldsSame(list.children, left, right) &&
                 *list.unknownOf(left) == *list.unknownOf(right);
    }
    return isSame;
}

bool areGroupsSame(const FieldInfo& group, void* a, void* b)
{
    return areFieldsSame(group.children, a, b) &&
           (!group.unknownOf || *group.unknownOf(a) == *group.unknownOf(b));
}

} // namespace

bool areFieldsSame(std::span<const FieldInfo> fields, const void* a, const void* b)
{
    return std::ranges::all_of(fields, [a, b](const FieldInfo& field) {
        void* left = const_cast<void*>(a); // only read
        void* right = const_cast<void*>(b);
        if (field.isList()) {
            return areItemsSame(field, left, right);
        }
        return field.isGroup() ? areGroupsSame(field, field.childOf(left), field.childOf(right))
                               : isSame(field.get(a), field.get(b));
    });
}

bool isSame(const Rule& a, const Rule& b)
{
    return a == b && isSame(a.cooldownSeconds, b.cooldownSeconds) &&
           isSamePart(a.trigger, b.trigger) && areSame(a.conditions, b.conditions) &&
           areSame(a.actions, b.actions);
}

namespace {

std::size_t bytesOfItems(const FieldInfo& list, void* object)
{
    std::size_t total = list.count(object) * list.itemBytes;
    for (std::size_t i = 0; i < list.count(object); ++i) {
        void* item = list.itemOf(object, i);
        total += bytesOfFields(list.children, item) + list.unknownOf(item)->size();
    }
    return total;
}

std::size_t bytesOfGroup(const FieldInfo& group, void* object)
{
    void* inside = group.childOf(object);
    const std::size_t unknown = group.unknownOf ? group.unknownOf(inside)->size() : 0;
    return bytesOfFields(group.children, inside) + unknown;
}

} // namespace

std::size_t bytesOfFields(std::span<const FieldInfo> fields, const void* object)
{
    std::size_t total = 0;
    for (const FieldInfo& field : fields) {
        void* read = const_cast<void*>(object); // only that
        if (field.isList()) {
            total += bytesOfItems(field, read);
        } else {
            total += field.isGroup() ? bytesOfGroup(field, read) : bytesOutside(field.get(object));
        }
    }
    return total;
}

std::size_t bytesOf(const TemplateEntry& entry)
{
    std::size_t total = sizeof(entry) + entry.name.size() + entry.path.size() +
                        entry.problem.english().size() + entry.unknownMembers.size() +
                        entry.import.unknownMembers.size() +
                        entry.clipSpeeds.size() * sizeof(float) +
                        entry.clipRoles.size() * sizeof(std::optional<ClipRole>);
    for (const std::string& name : entry.clipNames) {
        total += sizeof(std::string) + name.size();
    }
    return total;
}

std::size_t bytesOf(const StageEntry& entry)
{
    return sizeof(entry) + entry.name.size() + entry.path.size() + entry.problem.english().size() +
           entry.unknownMembers.size();
}

std::size_t bytesOf(const NamedCamera& camera)
{
    return sizeof(camera) + camera.name.size() + camera.unknownMembers.size();
}

std::size_t bytesOf(const Place& place)
{
    return sizeof(place) + place.name.size() + place.unknownMembers.size() +
           place.corners.size() * sizeof(glm::vec3);
}

std::size_t bytesOf(const Path& path)
{
    return sizeof(path) + path.name.size() + path.unknownMembers.size() +
           path.places.size() * sizeof(PlaceId) + path.branches.size() * sizeof(PathBranch);
}

std::size_t bytesOf(const Rule& rule)
{
    std::size_t total = sizeof(rule) + rule.name.size() + rule.unknownMembers.size() +
                        rule.conditions.size() * sizeof(Condition) +
                        rule.actions.size() * sizeof(Action);
    forEachPart(rule, [&total](const RuleKind& kind, const void* object) {
        total += bytesOfFields(kind.fields, object);
    });
    return total;
}

std::size_t bytesOf(const TagName& tag)
{
    return sizeof(tag) + tag.name.size() + tag.unknownMembers.size();
}

std::size_t bytesOf(const NumberName& named)
{
    return sizeof(named) + named.name.size() + named.unknownMembers.size() +
           named.values.size() * sizeof(named.values.front());
}

std::size_t bytesOf(const Cue& cue)
{
    return sizeof(cue) + cue.name.size() + cue.event.size() + cue.key.size() +
           cue.unknownMembers.size();
}

std::size_t bytesOf(const State& state)
{
    std::size_t total = sizeof(state) + state.name.size() + state.unknownMembers.size() +
                        state.people->bytes() + state.templates.size() * sizeof(StateTemplate);
    for (const StateTemplate& each : state.templates) {
        for (const auto* names : {&each.clips, &each.slots, &each.parts}) {
            for (const std::string& name : *names) {
                total += sizeof(std::string) + name.size();
            }
        }
    }
    return total;
}

std::size_t bytesOf(const SurfaceSettings& surface)
{
    return sizeof(surface) + surface.unknownMembers.size();
}

} // namespace crowd::model
