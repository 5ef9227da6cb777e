// SPDX-License-Identifier: MIT
#include "app/console/ScriptGate.h"

#include <QtCore/QCoreApplication>
#include <QtCore/QEvent>

namespace crowd::app {

namespace {

QEvent::Type workEvent()
{
    static const int type = QEvent::registerEventType();
    return static_cast<QEvent::Type>(type);
}

} // namespace

ScriptGate::ScriptGate(QObject* parent) : QObject(parent) {}

bool ScriptGate::run(const std::function<void()>& work)
{
    const std::lock_guard one(m_entrance);
    std::unique_lock lock(m_mutex);
    if (m_isClosed) {
        return false;
    }
    m_work = &work;
    QCoreApplication::postEvent(this, new QEvent(workEvent()));
    m_done.wait(lock, [this] { return m_work == nullptr || m_isClosed; });
    const bool isDone = m_work == nullptr;
    m_work = nullptr;
    return isDone;
}

void ScriptGate::close()
{
    const std::lock_guard lock(m_mutex);
    m_isClosed = true;
    m_done.notify_all();
}

bool ScriptGate::event(QEvent* event)
{
    if (event->type() != workEvent()) {
        return QObject::event(event);
    }
    const std::lock_guard lock(m_mutex);
    if (m_work != nullptr && !m_isClosed) {
        (*m_work)();
        m_work = nullptr;
        m_done.notify_all();
    }
    return true;
}

} // namespace crowd::app
