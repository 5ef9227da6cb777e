// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include <QtCore/QCoreApplication>

#include "app/python/ScriptScene.h"
#include "behavior/session/SceneMotion.h"

namespace crowd::app {

// What the files that make up ScriptScene share.

/// Of an undo step. A context of its own: scripts run without any window.
inline QString stepText(const char* text)
{
    return QCoreApplication::translate("Script", text);
}

/// What moves in pictures of a later time.
struct ScriptScene::Motion
{
    Motion(const Snapshot& now, const std::atomic<bool>& isCancelled)
        : scene(now.scene), revision(now.revision), motion(*scene, &isCancelled)
    {
    }

    std::shared_ptr<const model::Scene> scene;
    std::uint64_t revision;
    behavior::SceneMotion motion;
};

/// The result of the work, done on the thread that the document belongs to.
template<class Action>
auto ScriptScene::onDocument(const Action& work) const
{
    std::optional<std::invoke_result_t<Action>> result;
    m_host.run([&] { result.emplace(work()); });
    return std::move(*result);
}

} // namespace crowd::app
