// SPDX-License-Identifier: MIT
#include "app/window/CameraBookmarks.h"

#include <algorithm>
#include <array>

#include <QtWidgets/QMenu>

#include "widgets/commands/ViewCommands.h"

namespace crowd::app {

namespace {

constexpr std::size_t kNumbers = 9;

struct Bookmark
{
    const char* goTo;
    const char* goToText;
    const char* goToKeys;
    const char* keep;
    const char* keepText;
    const char* keepKeys;
};

constexpr std::array<Bookmark, kNumbers> kBookmarks{{
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

QString numbered(std::size_t index, QString name)
{
    return QStringLiteral("&%1  %2").arg(index + 1).arg(
        name.replace(QLatin1Char('&'), QLatin1String("&&")));
}

} // namespace

CameraBookmarks::CameraBookmarks(widgets::EditorState& state, widgets::ActionRegistry& actions,
                                 QObject* parent)
    : QObject(parent), m_state(state), m_actions(actions)
{
    addActions();
}

void CameraBookmarks::addActions()
{
    for (std::size_t i = 0; i < kNumbers; ++i) {
        const Bookmark& item = kBookmarks[i];
        m_actions.add({item.goTo, item.goToText, "camera", item.goToKeys, kGoToTip},
                      [this, i](bool) { goTo(i); });
        m_actions.add({item.keep, item.keepText, "camera-add", item.keepKeys, kKeepTip},
                      [this, i](bool) { keepAs(i); });
    }
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
                           .arg(m_actions.action(kBookmarks[index].keep)
                                    ->shortcut()
                                    .toString(QKeySequence::NativeText)));
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

void CameraBookmarks::attach(QMenu* goTo, QMenu* keep)
{
    connect(goTo, &QMenu::aboutToShow, this, [this, goTo] { fillGoTo(goTo); });
    connect(keep, &QMenu::aboutToShow, this, [this, keep] { fillKeep(keep); });
    fillGoTo(goTo);
    fillKeep(keep);
}

void CameraBookmarks::fillGoTo(QMenu* menu)
{
    menu->clear();
    const auto& cameras = m_state.scene().cameras;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const QString name = QString::fromStdString(cameras[i].name);
        if (i < kNumbers) {
            QAction* action = m_actions.action(kBookmarks[i].goTo);
            action->setText(numbered(i, name));
            menu->addAction(action);
        } else {
            connect(menu->addAction(name), &QAction::triggered, this,
                    [this, name] { widgets::goToCamera(m_state, name); });
        }
    }
    if (cameras.empty()) {
        menu->addAction(tr("The scene has no cameras"))->setEnabled(false);
    }
}

void CameraBookmarks::fillKeep(QMenu* menu)
{
    menu->clear();
    const auto& cameras = m_state.scene().cameras;
    for (std::size_t i = 0; i < std::min(cameras.size() + 1, kNumbers); ++i) {
        QAction* action = m_actions.action(kBookmarks[i].keep);
        const bool isNew = i == cameras.size();
        action->setText(
            numbered(i, isNew ? tr("New Camera") : QString::fromStdString(cameras[i].name)));
        menu->addAction(action);
    }
}

} // namespace crowd::app
