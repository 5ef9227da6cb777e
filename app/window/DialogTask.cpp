// SPDX-License-Identifier: MIT
#include "app/window/DialogTask.h"

#include <limits>

#include <QtWidgets/QApplication>

namespace crowd::app {

namespace {

constexpr int kProgressSteps = 1000;
constexpr int kPatienceMs = 400;
constexpr int kBusyLookMs = 30;
constexpr int kDialogWidth = 380;

} // namespace

DialogTask::DialogTask(QWidget* window, std::function<bool()> isFree)
    : QObject(window), m_window(window), m_isFree(std::move(isFree)), m_task(m_isFree)
{
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this, &DialogTask::showWhenFree);
    connect(&m_task, &widgets::BackgroundTask::progressed, this, &DialogTask::follow);
    connect(&m_task, &widgets::BackgroundTask::ended, this, &DialogTask::end);
}

DialogTask::~DialogTask() = default;

void DialogTask::showSoon(const QString& title)
{
    m_dialog = new QProgressDialog(title, tr("Cancel"), 0, kProgressSteps, m_window);
    m_dialog->setWindowModality(Qt::WindowModal);
    m_dialog->setMinimumDuration(std::numeric_limits<int>::max()); // showWhenFree() shows it
    m_dialog->setMinimumWidth(kDialogWidth); // the text changes while it works
    m_dialog->setAutoReset(false);
    m_dialog->setAutoClose(false);
    m_dialog->setValue(0);
    connect(m_dialog, &QProgressDialog::canceled, &m_task, &widgets::BackgroundTask::cancel);
    m_patience.start(kPatienceMs);
}

/// It takes the mouse from the picture: the release of a stroke's button would never come.
void DialogTask::showWhenFree()
{
    if (m_dialog == nullptr) {
        return;
    }
    if (m_isFree() && QGuiApplication::mouseButtons() == Qt::NoButton) {
        m_dialog->show();
        m_hasKeys = true;
    } else {
        m_patience.start(kBusyLookMs);
    }
}

void DialogTask::follow(const QString& what, float fraction)
{
    if (m_dialog != nullptr) {
        m_dialog->setLabelText(what);
        m_dialog->setValue(static_cast<int>(fraction * kProgressSteps));
    }
}

void DialogTask::end()
{
    if (!m_task.isRunning()) { // who got the result may have started the next piece
        close();
    }
    if (std::exchange(m_hasKeys, false)) {
        giveKeysBack();
    }
    Q_EMIT ended();
}

void DialogTask::close()
{
    if (m_dialog == nullptr) {
        return;
    }
    m_patience.stop();
    // Its setValue() handles events, so this may be called from within it.
    m_dialog->hide();
    m_dialog->deleteLater();
    m_dialog = nullptr;
}

/// After the progress dialog nobody has the keyboard; a dialog that was opened since comes first.
void DialogTask::giveKeysBack()
{
    for (QWidget* each : QApplication::topLevelWidgets()) {
        if (each->isModal() && each->isVisible() && each->parentWidget() == m_window) {
            each->activateWindow();
            return;
        }
    }
    if (m_window->isVisible()) {
        m_window->activateWindow();
    }
}

} // namespace crowd::app
