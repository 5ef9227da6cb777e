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
                               Switch{"view/showTags", &ViewOptions::showTags}};
constexpr const char* kLitKey = "view/lit";

void restore(ViewOptions& options)
{
    const QSettings settings;
    for (const Switch& each : kSwitches) {
        bool& value = options.*each.member;
        value = settings.value(QLatin1String(each.key), value).toBool();
    }
    const bool isLit =
        settings.value(QLatin1String(kLitKey), options.look == render::Look::Lit).toBool();
    options.look = isLit ? render::Look::Lit : render::Look::Plain;
}

void save(const ViewOptions& options)
{
    QSettings settings;
    for (const Switch& each : kSwitches) {
        settings.setValue(QLatin1String(each.key), options.*each.member);
    }
    settings.setValue(QLatin1String(kLitKey), options.look == render::Look::Lit);
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
    state.setViewOptions(options);
}

} // namespace crowd::app
