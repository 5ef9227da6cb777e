// SPDX-License-Identifier: MIT
#include "model/project/LookFile.h"

#include <algorithm>
#include <string>
#include <utility>

#include "model/project/MemberJson.h"
#include "model/project/SharedFile.h"

namespace crowd::model {

namespace {

constexpr SharedFormat kLookFormat{
    "crowdbrush looks", 1,
    QT_TRANSLATE_NOOP("Messages", "%1 holds no looks. Choose a file that was saved from the panel "
                                  "Looks.")};

} // namespace

Result<void> writeLookFile(const Looks& looks, const QString& path)
{
    Scene scene;
    scene.looks = looks;
    return writeSharedFile(path, kLookFormat, members::Looks::key,
                           memberJson(members::Looks(), scene));
}

Result<Looks> readLookFile(const QString& path)
{
    const auto content = readSharedFile(path, kLookFormat);
    if (!content) {
        return content.error();
    }
    Scene scene;
    Message problem;
    JsonFields top(content.value(), "", problem);
    readMember(members::Looks(), top, scene, problem);
    if (!problem.empty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be used: %2"), path.toStdString(),
                     problem};
    }
    return std::move(scene.looks);
}

Result<Looks> withLooks(Scene scene, const Looks& others)
{
    Looks& all = scene.looks;
    for (LookPreset coming : others) {
        const auto same = std::ranges::find(all, coming.name, &LookPreset::name);
        if (same != all.end()) {
            coming.id = same->id;
            *same = std::move(coming);
            continue;
        }
        coming.id = scene.freeLookId();
        if (coming.id == 0) {
            return Error{
                QT_TRANSLATE_NOOP("Messages", "A scene has at most %1 looks: remove one first."),
                kMostLooks};
        }
        all.push_back(std::move(coming));
    }
    return std::move(all);
}

} // namespace crowd::model
