// SPDX-License-Identifier: MIT
#include "model/project/FeatureFile.h"

#include <algorithm>

#include "model/features/FeatureWriting.h"
#include "model/project/MemberJson.h"
#include "model/project/SharedFile.h"

namespace crowd::model {

namespace {

constexpr SharedFormat kFeatureFormat{
    "crowdbrush features", 1,
    QT_TRANSLATE_NOOP("Messages", "%1 holds no features. Choose a file that was saved from the "
                                  "panel Features.")};

/// What of a kind comes in, with ids of the scene.
Result<void> putKind(FeatureKind& target, const FeatureKind& coming, std::uint32_t& nextId)
{
    for (FeatureValue value : coming.values) {
        value.templates.clear();
        const auto same = std::ranges::find(target.values, value.name, &FeatureValue::name);
        if (same != target.values.end()) {
            value.id = same->id;
            *same = std::move(value);
            continue;
        }
        if (nextId == 0 || nextId > 0xFFFF) {
            return Error{QT_TRANSLATE_NOOP(
                "Messages", "There are as many values of features as there can be.")};
        }
        value.id = static_cast<FeatureId>(nextId++);
        target.values.push_back(std::move(value));
    }
    return {};
}

} // namespace

Result<void> writeFeatureFile(const FeatureKinds& kinds, const QString& path)
{
    Scene scene;
    scene.features = kinds;
    return writeSharedFile(path, kFeatureFormat, members::Features::key,
                           memberJson(members::Features(), scene));
}

Result<FeatureKinds> readFeatureFile(const QString& path)
{
    const auto content = readSharedFile(path, kFeatureFormat);
    if (!content) {
        return content.error();
    }
    Scene scene;
    scene.features.clear();
    Message problem;
    JsonFields top(content.value(), "", problem);
    readMember(members::Features(), top, scene, problem);
    if (!problem.empty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be used: %2"), path.toStdString(),
                     problem};
    }
    return std::move(scene.features);
}

Result<FeatureKinds> withKinds(const Scene& scene, const FeatureKinds& others)
{
    FeatureKinds all = scene.features;
    std::uint32_t nextId = freeFeatureId(scene);
    Scene counted; // whose kinds are those so far
    counted.population = scene.population;
    for (const FeatureKind& coming : others) {
        auto target = std::ranges::find(all, coming.name, &FeatureKind::name);
        if (target == all.end()) {
            counted.features = all;
            FeatureKind fresh;
            fresh.id = freeKindId(counted);
            fresh.name = coming.name;
            if (fresh.id == 0) {
                return Error{QT_TRANSLATE_NOOP("Messages", "A scene has at most %1 features. "
                                                           "Remove one first."),
                             kMostFeatureKinds};
            }
            target =
                all.insert(std::ranges::upper_bound(all, fresh.id, {}, &FeatureKind::id), fresh);
        }
        if (auto put = putKind(*target, coming, nextId); !put) {
            return put.error();
        }
    }
    return all;
}

} // namespace crowd::model
