// SPDX-License-Identifier: MIT
#include "app/window/CameraBookmarks.h"

#include "widgets/commands/ViewCommands.h"

namespace crowd::app {

namespace {

constexpr NumberedKeys kBookmarks{{
    {"camera-1", QT_TRANSLATE_NOOP("Actions", "Go to Camera &1"), "1", "camera-keep-1",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &1"), "Ctrl+1"},
    {"camera-2", QT_TRANSLATE_NOOP("Actions", "Go to Camera &2"), "2", "camera-keep-2",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &2"), "Ctrl+2"},
    {"camera-3", QT_TRANSLATE_NOOP("Actions", "Go to Camera &3"), "3", "camera-keep-3",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &3"), "Ctrl+3"},
    {"camera-4", QT_TRANSLATE_NOOP("Actions", "Go to Camera &4"), "4", "camera-keep-4",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &4"), "Ctrl+4"},
    {"camera-5", QT_TRANSLATE_NOOP("Actions", "Go to Camera &5"), "5", "camera-keep-5",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &5"), "Ctrl+5"},
    {"camera-6", QT_TRANSLATE_NOOP("Actions", "Go to Camera &6"), "6", "camera-keep-6",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &6"), "Ctrl+6"},
    {"camera-7", QT_TRANSLATE_NOOP("Actions", "Go to Camera &7"), "7", "camera-keep-7",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &7"), "Ctrl+7"},
    {"camera-8", QT_TRANSLATE_NOOP("Actions", "Go to Camera &8"), "8", "camera-keep-8",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &8"), "Ctrl+8"},
    {"camera-9", QT_TRANSLATE_NOOP("Actions", "Go to Camera &9"), "9", "camera-keep-9",
     QT_TRANSLATE_NOOP("Actions", "Keep View as Camera &9"), "Ctrl+9"},
}};

constexpr const char* kGoToTip =
    QT_TRANSLATE_NOOP("Actions", "Look through the scene's camera of this number");
constexpr const char* kKeepTip =
    QT_TRANSLATE_NOOP("Actions", "Keep the present view as the scene's camera of this number");

} // namespace

CameraBookmarks::CameraBookmarks(widgets::EditorState& state, widgets::ActionRegistry& actions,
                                 QObject* parent)
    : QObject(parent), m_state(state),
      m_numbered(actions, kBookmarks,
                 {"camera", kGoToTip, "camera-add", kKeepTip, [this] { return names(); },
                  [this](std::size_t index) { goTo(index); },
                  [this](std::size_t index) { keepAs(index); },
                  [] { return tr("The scene has no cameras"); }, [] { return tr("New Camera"); }},
                 nullptr)
{
}

QStringList CameraBookmarks::names() const
{
    QStringList names;
    for (const model::NamedCamera& each : m_state.scene().cameras) {
        names << QString::fromStdString(each.name);
    }
    return names;
}

void CameraBookmarks::goTo(std::size_t index)
{
    const auto& cameras = m_state.scene().cameras;
    if (index < cameras.size()) {
        widgets::goToCamera(m_state, QString::fromStdString(cameras[index].name));
        return;
    }
    m_state.showStatus(tr("The scene has no camera %1. %2 keeps this view as one.")
                           .arg(index + 1)
                           .arg(m_numbered.keepShortcut(index)));
}

void CameraBookmarks::keepAs(std::size_t index)
{
    const auto& cameras = m_state.scene().cameras;
    std::size_t number = index;
    if (index < cameras.size()) {
        widgets::updateCamera(m_state, QString::fromStdString(cameras[index].name));
    } else {
        number = cameras.size(); // the next free one
        (void)widgets::addCamera(m_state);
    }
    const auto& kept = m_state.scene().cameras;
    if (number < kept.size()) {
        m_state.showStatus(tr("Camera %1, “%2”, shows this view.")
                               .arg(number + 1)
                               .arg(QString::fromStdString(kept[number].name)));
    }
}

const NumberedKeys& cameraKeyTable()
{
    return kBookmarks;
}

} // namespace crowd::app
