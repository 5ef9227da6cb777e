// SPDX-License-Identifier: MIT
#include "model/document/EntryCompare.h"

#include <algorithm>
#include <bit>
#include <cstdint>

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

bool isSame(const std::vector<NamedCamera>& a, const std::vector<NamedCamera>& b)
{
    return std::ranges::equal(a, b, [](const NamedCamera& left, const NamedCamera& right) {
        return left.name == right.name && isSame(left.camera, right.camera) &&
               left.unknownMembers == right.unknownMembers;
    });
}

bool isSame(const Lighting& a, const Lighting& b)
{
    return isSame(a.sunAzimuthRadians, b.sunAzimuthRadians) &&
           isSame(a.sunElevationRadians, b.sunElevationRadians) && isSame(a.sunColor, b.sunColor) &&
           isSame(a.sunStrength, b.sunStrength) && isSame(a.ambientColor, b.ambientColor) &&
           isSame(a.ambientStrength, b.ambientStrength) && isSame(a.skyZenith, b.skyZenith) &&
           isSame(a.skyHorizon, b.skyHorizon) && isSame(a.ground, b.ground) &&
           a.showGroundGrid == b.showGroundGrid && a.unknownMembers == b.unknownMembers;
}

bool isSame(const Place& a, const Place& b)
{
    return a.name == b.name && isSame(a.position, b.position) && isSame(a.radius, b.radius) &&
           a.color == b.color && a.role == b.role && a.capacity == b.capacity &&
           isSame(a.speedShare, b.speedShare) && a.unknownMembers == b.unknownMembers;
}

bool isSame(const Path& a, const Path& b)
{
    return a == b;
}

// What is equal and has the same numbers bit by bit.

namespace {

/// Of values that are equal.
bool isSame(const FieldValue& a, const FieldValue& b)
{
    if (const auto* number = std::get_if<float>(&a)) {
        return isSame(*number, std::get<float>(b));
    }
    if (const auto* number = std::get_if<double>(&a)) {
        return std::bit_cast<std::uint64_t>(*number) ==
               std::bit_cast<std::uint64_t>(std::get<double>(b));
    }
    if (const auto* clips = std::get_if<std::vector<ClipWeight>>(&a)) {
        return std::ranges::equal(
            *clips, std::get<std::vector<ClipWeight>>(b),
            [](const ClipWeight& x, const ClipWeight& y) { return isSame(x.weight, y.weight); });
    }
    return true;
}

/// Of parts of rules that are equal.
template<class Part>
bool isSamePart(const Part& a, const Part& b)
{
    return std::ranges::all_of(a.kind().fields, [&](const FieldInfo& field) {
        return isSame(field.get(a.object()), field.get(b.object()));
    });
}

template<class Part>
bool areSame(const std::vector<Part>& a, const std::vector<Part>& b)
{
    return std::ranges::equal(a, b, [](const Part& x, const Part& y) { return isSamePart(x, y); });
}

} // namespace

bool isSame(const std::vector<Rule>& a, const std::vector<Rule>& b)
{
    return a == b && std::ranges::equal(a, b, [](const Rule& x, const Rule& y) {
               return isSame(x.cooldownSeconds, y.cooldownSeconds) &&
                      isSamePart(x.trigger, y.trigger) && areSame(x.conditions, y.conditions) &&
                      areSame(x.actions, y.actions);
           });
}

bool isSame(const std::vector<NumberName>& a, const std::vector<NumberName>& b)
{
    return a == b && std::ranges::equal(a, b, [](const NumberName& x, const NumberName& y) {
               return isSame(x.low, y.low) && isSame(x.high, y.high) &&
                      std::ranges::equal(x.values, y.values, [](const auto& p, const auto& q) {
                          return isSame(p.second, q.second);
                      });
           });
}

bool isSame(const std::vector<Cue>& a, const std::vector<Cue>& b)
{
    return a == b && std::ranges::equal(a, b, [](const Cue& x, const Cue& y) {
               return isSame(x.payload, y.payload);
           });
}

} // namespace crowd::model
