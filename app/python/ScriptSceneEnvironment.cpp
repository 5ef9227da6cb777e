// SPDX-License-Identifier: MIT
#include <algorithm>

#include "app/python/ScriptSceneParts.h"
#include "model/project/EnvironmentText.h"

namespace crowd::app {

using namespace model;

namespace {

void putEnvironment(SceneEdit& edit, const Scene& wanted)
{
    edit.setPlacesAndPaths(wanted.places, wanted.paths);
    forEachMember([&]<class M>(const M&) {
        if constexpr (M::isEnvironment && M::kind == MemberKind::Value) {
            if (M::of(wanted) != M::of(edit.scene())) {
                edit.set<M>(M::of(wanted));
            }
        }
    });
}

} // namespace

Result<void> ScriptScene::setCamera(const std::string& name, const Camera& camera)
{
    return onDocument([&] {
        std::vector<NamedCamera> cameras = m_host.document->scene().cameras;
        const auto found = std::ranges::find(cameras, name, &NamedCamera::name);
        if (found == cameras.end()) {
            cameras.push_back({name, camera});
        } else {
            found->camera = camera;
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Set camera")),
                    [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> ScriptScene::removeCamera(const std::string& name)
{
    if (const auto known = camera(name); !known) {
        return known.error();
    }
    return onDocument([&] {
        std::vector<NamedCamera> cameras = m_host.document->scene().cameras;
        std::erase_if(cameras, [&name](const NamedCamera& each) { return each.name == name; });
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove camera")),
                    [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> ScriptScene::setCameras(std::vector<NamedCamera> cameras)
{
    return onDocument([&] {
        for (NamedCamera& each : cameras) {
            const auto& known = m_host.document->scene().cameras;
            const auto same = std::ranges::find(known, each.name, &NamedCamera::name);
            if (same != known.end()) {
                each.unknownMembers = same->unknownMembers;
            }
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Set cameras")),
                    [&](SceneEdit& open) { open.setCameras(cameras); });
    });
}

Result<void> ScriptScene::setLighting(Lighting lighting)
{
    return onDocument([&] {
        lighting.unknownMembers = m_host.document->scene().lighting.unknownMembers;
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Set lighting")),
                    [&](SceneEdit& open) { open.setLighting(lighting); });
    });
}

Result<void> ScriptScene::setEnvironment(const std::string& text, bool isStrict)
{
    return onDocument([&]() -> Result<void> {
        Scene wanted = m_host.document->scene();
        if (auto read = readEnvironmentText(text, wanted, isStrict); !read) {
            return read;
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Set environment")),
                    [&](SceneEdit& open) { putEnvironment(open, wanted); });
    });
}

Result<Camera> ScriptScene::camera(const std::string& name) const
{
    const auto now = scene();
    const auto found = std::ranges::find(now->cameras, name, &NamedCamera::name);
    if (found != now->cameras.end()) {
        return found->camera;
    }
    std::string names;
    for (const NamedCamera& each : now->cameras) {
        names += (names.empty() ? "" : ", ") + each.name;
    }
    return Error{"There is no camera named \"" + name + "\". " +
                 (names.empty() ? "The scene has none." : "The scene has: " + names + ".")};
}

} // namespace crowd::app
