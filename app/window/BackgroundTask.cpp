// SPDX-License-Identifier: MIT
#include "app/window/BackgroundTask.h"

namespace crowd::app {

namespace {

constexpr int kProgressSteps = 1000;
constexpr int kPatienceMs = 400;
constexpr int kDialogWidth = 380;

} // namespace

BackgroundTask::BackgroundTask(QWidget* window) : QObject(window), m_window(window) {}

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
    m_dialog->setMinimumDuration(kPatienceMs);
    m_dialog->setMinimumWidth(kDialogWidth); // the text changes while it works
    m_dialog->setAutoReset(false);
    m_dialog->setAutoClose(false);
    m_dialog->setValue(0);
    connect(m_dialog, &QProgressDialog::canceled, this, [this] { m_isCancelled = true; });
}

bool BackgroundTask::end()
{
    m_thread.join();
    // Its setValue() handles events, so this may be called from within it.
    const bool wasVisible = m_dialog->isVisible();
    m_dialog->hide();
    if (wasVisible) {
        m_window->activateWindow(); // or nobody has the keyboard
    }
    m_dialog->deleteLater();
    m_dialog = nullptr;
    return !m_isCancelled;
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
