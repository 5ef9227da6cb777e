// SPDX-License-Identifier: MIT
#include "app/window/BackgroundTask.h"

#include <limits>

#include <QtWidgets/QApplication>

namespace crowd::app {

namespace {

constexpr int kProgressSteps = 1000;
constexpr int kPatienceMs = 400;
constexpr int kBusyLookMs = 30;
constexpr int kDialogWidth = 380;

} // namespace

BackgroundTask::BackgroundTask(QWidget* window, std::function<bool()> isFree)
    : QObject(window), m_window(window), m_isFree(std::move(isFree))
{
    m_patience.setSingleShot(true);
    m_look.setSingleShot(true);
    m_look.setInterval(kBusyLookMs);
    connect(&m_patience, &QTimer::timeout, this, &BackgroundTask::showProgress);
    connect(&m_look, &QTimer::timeout, this, &BackgroundTask::handOver);
}

BackgroundTask::~BackgroundTask()
{
    m_isCancelled = true;
    if (m_thread.joinable()) {
        m_thread.join();
    }
}

void BackgroundTask::begin(const QString& title)
{
    Q_ASSERT(!isRunning());
    m_isCancelled = false;
    m_dialog = new QProgressDialog(title, tr("Cancel"), 0, kProgressSteps, m_window);
    m_dialog->setWindowModality(Qt::WindowModal);
    m_dialog->setMinimumDuration(std::numeric_limits<int>::max()); // showProgress() shows it
    m_dialog->setMinimumWidth(kDialogWidth); // the text changes while it works
    m_dialog->setAutoReset(false);
    m_dialog->setAutoClose(false);
    m_dialog->setValue(0);
    connect(m_dialog, &QProgressDialog::canceled, this, [this] { m_isCancelled = true; });
    m_patience.start(kPatienceMs);
}

/// It takes the mouse from the picture: the release of a stroke's button would never come.
void BackgroundTask::showProgress()
{
    if (m_dialog == nullptr) {
        return;
    }
    if (m_isFree() && QGuiApplication::mouseButtons() == Qt::NoButton) {
        m_dialog->show();
    } else {
        m_patience.start(kBusyLookMs);
    }
}

void BackgroundTask::handOver()
{
    if (!m_isFree()) {
        m_look.start();
        return;
    }
    const std::function<void()> hand = std::exchange(m_handOver, {});
    const bool hadKeys = m_dialog->isVisible();
    if (end()) {
        hand();
    }
    if (hadKeys) {
        giveKeysBack();
    }
    Q_EMIT ended();
}

bool BackgroundTask::end()
{
    m_thread.join();
    m_patience.stop();
    // Its setValue() handles events, so this may be called from within it.
    m_dialog->hide();
    m_dialog->deleteLater();
    m_dialog = nullptr;
    return !m_isCancelled;
}

/// After the progress dialog nobody has the keyboard; a dialog that was opened since comes first.
void BackgroundTask::giveKeysBack()
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

bool BackgroundTask::report(const QString& what, float fraction)
{
    QMetaObject::invokeMethod(
        this,
        [this, what, fraction] {
            if (m_dialog != nullptr) {
                m_dialog->setLabelText(what);
                m_dialog->setValue(static_cast<int>(fraction * kProgressSteps));
            }
        },
        Qt::QueuedConnection);
    return !m_isCancelled;
}

} // namespace crowd::app
