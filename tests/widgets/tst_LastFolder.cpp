// SPDX-License-Identifier: MIT
#include "widgets/forms/LastFolder.h"

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "tests/program/Test.h"

using namespace crowd::widgets;

class TestLastFolder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWhereTheSceneIsUntilAnotherIsChosen();
};

void TestLastFolder::isWhereTheSceneIsUntilAnotherIsChosen()
{
    const QTemporaryDir folder;
    QCoreApplication::setOrganizationName(QStringLiteral("CrowdbrushTests"));
    QCoreApplication::setApplicationName(QStringLiteral("LastFolder"));
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, folder.path());
    QSettings().clear();
    const QString kind = QStringLiteral("beards/folder");
    const QString scene = QStringLiteral("/shows/hall.crowd");
    QCOMPARE(inLastFolder(kind, scene, QStringLiteral("a.beard")),
             QStringLiteral("/shows/a.beard"));
    QVERIFY(inLastFolder(kind, {}, QStringLiteral("a.beard")).endsWith(QLatin1String("/a.beard")));
    rememberFolder(kind, QStringLiteral("/shared/beards/b.beard"));
    QCOMPARE(inLastFolder(kind, scene, QStringLiteral("a.beard")),
             QStringLiteral("/shared/beards/a.beard"));
    QCOMPARE(inLastFolder(QStringLiteral("hats/folder"), scene, QStringLiteral("a.hat")),
             QStringLiteral("/shows/a.hat"));
}

CROWD_TEST(TestLastFolder)
#include "tst_LastFolder.moc"
