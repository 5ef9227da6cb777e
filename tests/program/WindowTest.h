// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtWidgets/QApplication>

#include "tests/program/Test.h"

namespace crowd::tests {

/// With windows, as in the program, and with settings of the test's own that begin empty, but for
/// pictures as quick as they can be.
template<class Test>
int runWindowTest(int argc, char** argv)
{
    qputenv("CROWDBRUSH_RESOURCES", CROWD_RESOURCES);
    QStandardPaths::setTestModeEnabled(true); // the artist's own files stay out of it
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    const QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("CrowdbrushTests"));
    QCoreApplication::setApplicationName(QLatin1String(Test::staticMetaObject.className()));
    QSettings().clear();
    QSettings().setValue(QStringLiteral("preferences/pictureQuality"), QStringLiteral("fast"));
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace crowd::tests

#define CROWD_WINDOW_TEST(Class) CROWD_ADD_TEST(Class, crowd::tests::runWindowTest)
