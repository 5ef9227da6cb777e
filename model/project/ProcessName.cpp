// SPDX-License-Identifier: MIT
#include "model/project/ProcessName.h"

#include <QtCore/QByteArrayList>
#include <QtCore/QCoreApplication>
#include <QtCore/QFile>

namespace crowd::model {

namespace {

/// What proc(5) says of a process; no start: there is none.
struct ProcessState
{
    QString start; ///< in ticks since the machine was started
    bool isEnding = false;
};

ProcessState stateOf(const QString& processId)
{
    QFile stat(QStringLiteral("/proc/%1/stat").arg(processId));
    if (!stat.open(QIODevice::ReadOnly)) {
        return {};
    }
    // Counted after the name, which ends with the last ')': fields 3, 9 and 22.
    constexpr int kState = 0;
    constexpr int kFlags = 6;
    constexpr int kStart = 19;
    constexpr unsigned kIsExiting = 0x4; // PF_EXITING: its memory is being given back
    const QByteArray text = stat.readAll();
    const QByteArrayList fields = text.mid(text.lastIndexOf(')') + 2).split(' ');
    const QByteArray state = fields.value(kState);
    const bool isDead = state == "Z" || state == "X"; // its parent has not asked after it yet
    const bool isExiting = (fields.value(kFlags).toUInt() & kIsExiting) != 0;
    return {QString::fromLatin1(fields.value(kStart)), isDead || isExiting};
}

} // namespace

QString ownProcessName()
{
    const QString id = QString::number(QCoreApplication::applicationPid());
    return id + QLatin1Char('-') + stateOf(id).start;
}

bool isProcessAlive(const QString& name)
{
    const ProcessState state = stateOf(name.section(QLatin1Char('-'), 0, 0));
    return !state.start.isEmpty() && state.start == name.section(QLatin1Char('-'), 1, 1) &&
           !state.isEnding;
}

} // namespace crowd::model
