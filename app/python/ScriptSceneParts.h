// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include <QtCore/QCoreApplication>

#include "app/python/ScriptScene.h"

namespace crowd::app {

// What the files that make up ScriptScene share.

/// Of an undo step. A context of its own: scripts run without any window.
inline QString stepText(const char* text)
{
    return QCoreApplication::translate("Script", text);
}

/// The result of the work, done on the thread that the document belongs to.
template<class Action>
auto ScriptScene::onDocument(const Action& work) const
{
    std::optional<std::invoke_result_t<Action>> result;
    m_host.run([&] { result.emplace(work()); });
    return std::move(*result);
}

} // namespace crowd::app
