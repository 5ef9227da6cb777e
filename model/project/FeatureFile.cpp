// SPDX-License-Identifier: MIT
#include "model/project/FeatureFile.h"

#include <algorithm>

#include <QtCore/QFile>
#include <nlohmann/json.hpp>

#include "model/features/FeatureWriting.h"
#include "model/project/MemberJson.h"
#include "model/project/WholeFile.h"

namespace crowd::model {

using nlohmann::json;

namespace {

constexpr const char* kFeatureFormat = "crowdbrush features";
constexpr int kFeatureVersion = 1;
constexpr int kDeepestFeature = 64;            ///< as project files
constexpr qint64 kMostFeatureBytes = 16 << 20; ///< no file of features is larger

Result<FeatureKinds> kindsIn(const json& content, const std::string& path)
{
    const bool isOne = content.is_object() && content.contains("format") &&
                       content["format"].is_string() && content["format"] == kFeatureFormat;
    if (!isOne) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 holds no features. Choose a file that was "
                                                   "saved from the panel Features."),
                     path};
    }
    if (content.contains("version") && content["version"].is_number_integer() &&
        content["version"] > kFeatureVersion) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "%1 was written by a newer version; update to use it."),
            path};
    }
    Scene scene;
    scene.features.clear();
    Message problem;
    JsonFields top(content, "", problem);
    readMember(members::Features(), top, scene, problem);
    if (!problem.empty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be used: %2"), path, problem};
    }
    return std::move(scene.features);
}

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
    const json content = {{"format", kFeatureFormat},
                          {"version", kFeatureVersion},
                          {members::Features::key, memberJson(members::Features(), scene)}};
    return writeWholeFile(path, content.dump(2, ' ', false, json::error_handler_t::replace));
}

Result<FeatureKinds> readFeatureFile(const QString& path)
{
    const std::string name = path.toStdString();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be read: %2"), name,
                     file.errorString().toStdString()};
    }
    if (file.size() > kMostFeatureBytes) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 holds no features. Choose a file that was "
                                                   "saved from the panel Features."),
                     name};
    }
    const QByteArray bytes = file.read(kMostFeatureBytes);
    bool isTooDeep = false; // writing what is not known goes down as deep
    const auto notTooDeep = [&isTooDeep](int depth, json::parse_event_t, const json&) {
        isTooDeep = isTooDeep || depth > kDeepestFeature;
        return !isTooDeep;
    };
    const json content = json::parse(bytes.begin(), bytes.end(), notTooDeep, false);
    return kindsIn(isTooDeep ? json() : content, name);
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
