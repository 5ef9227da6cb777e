// SPDX-License-Identifier: MIT
#include "app/window/ViewMemory.h"

#include <array>

#include <QtCore/QSettings>

namespace crowd::app {

namespace {

using widgets::ViewOptions;

struct Switch
{
    const char* key;
    bool ViewOptions::*member;
};

constexpr std::array kSwitches{Switch{"view/showGroundGrid", &ViewOptions::showGroundGrid},
                               Switch{"view/showShadows", &ViewOptions::showShadows},
                               Switch{"view/showPaths", &ViewOptions::showPaths},
                               Switch{"view/showTags", &ViewOptions::showTags},
                               Switch{"view/showRelations", &ViewOptions::showRelations},
                               Switch{"view/showWalkable", &ViewOptions::showWalkable},
                               Switch{"select/byLasso", &ViewOptions::selectsByLasso}};
constexpr const char* kLookKey = "view/look";
constexpr const char* kPropertyKey = "view/property";
constexpr const char* kLitKey = "view/lit"; ///< before there were more looks than two

void restore(ViewOptions& options)
{
    const QSettings settings;
    for (const Switch& each : kSwitches) {
        bool& value = options.*each.member;
        value = settings.value(QLatin1String(each.key), value).toBool();
    }
    const bool isLit = settings.value(QLatin1String(kLitKey), true).toBool();
    const QString key =
        settings.value(QLatin1String(kLookKey), QLatin1String(isLit ? "lit" : "plain")).toString();
    options.look = render::lookOfKey(key.toStdString()).value_or(options.look);
    options.property =
        settings.value(QLatin1String(kPropertyKey), QString::fromStdString(options.property))
            .toString()
            .toStdString();
}

void save(const ViewOptions& options)
{
    QSettings settings;
    for (const Switch& each : kSwitches) {
        settings.setValue(QLatin1String(each.key), options.*each.member);
    }
    if (options.ownLook != 0) {
        return; // how that is drawn is the scene's
    }
    settings.setValue(QLatin1String(kLookKey), QLatin1String(render::lookInfo(options.look).key));
    settings.setValue(QLatin1String(kPropertyKey), QString::fromStdString(options.property));
}

} // namespace

void rememberView(widgets::EditorState& state)
{
    ViewOptions options = state.viewOptions();
    restore(options);
    state.setViewOptions(options);
    QObject::connect(&state, &widgets::EditorState::viewOptionsChanged, &state, &save);
}

void resetView(widgets::EditorState& state)
{
    const ViewOptions fresh;
    ViewOptions options = state.viewOptions();
    for (const Switch& each : kSwitches) {
        options.*each.member = fresh.*each.member;
    }
    options.look = fresh.look;
    options.ownLook = 0;
    options.property = fresh.property;
    state.setViewOptions(options);
}

} // namespace crowd::app
