// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtCore/QProcess>
#include <QtCore/QProcessEnvironment>
#include <QtCore/QStringList>

/// What tests of the program from outside share.
namespace crowd::testing {

struct Outcome
{
    int status = -1;
    QByteArray output;
    QByteArray errors;
};

inline QProcessEnvironment withoutDisplay()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        environment.remove(QLatin1String(name));
    }
    return environment;
}

inline constexpr int kPatienceMs = 200'000; ///< under the sanitizers, on a busy machine

/// `inProgram` is run in the new process, before the program.
inline Outcome run(const QStringList& arguments, const std::function<void()>& inProgram = {})
{
    QProcess program;
    program.setProcessEnvironment(withoutDisplay());
    if (inProgram) {
        program.setChildProcessModifier(inProgram);
    }
    program.start(QStringLiteral(CROWD_PROGRAM), arguments);
    if (!program.waitForFinished(kPatienceMs) || program.exitStatus() != QProcess::NormalExit) {
        return {};
    }
    return {program.exitCode(), program.readAllStandardOutput(), program.readAllStandardError()};
}

inline QString exampleScene()
{
    return QStringLiteral(CROWD_TEST_DATA "/project/version-1.crowd");
}

/// A call that must be refused, and what is said then.
struct BadUsage
{
    const char* name;
    const char* options; ///< %1: an empty folder
    int status;
    const char* message;
};

} // namespace crowd::testing
