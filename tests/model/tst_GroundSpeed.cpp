// SPDX-License-Identifier: MIT
#include "model/gltf/GroundSpeed.h"

#include <cmath>

#include <QtTest/QTest>

#include "model/gltf/GltfImport.h"
#include "tests/program/Test.h"

using namespace crowd::model;

/// Speed from foot contact alone, against clips whose speed their author has written down.
class tst_GroundSpeed : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithTheAuthor_data();
    void agreesWithTheAuthor();
};

void tst_GroundSpeed::agreesWithTheAuthor_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("clip");
    for (const char* file : {"man", "woman"}) {
        for (const char* clip : {"walk", "run", "idle", "cheer"}) {
            QTest::addRow("%s, %s", file, clip)
                << QString::fromUtf8(file) << QString::fromUtf8(clip);
        }
    }
}

void tst_GroundSpeed::agreesWithTheAuthor()
{
    QFETCH(const QString, file);
    QFETCH(const QString, clip);
    const Result<TemplatePtr> asset =
        importTemplate(QStringLiteral(CROWD_RESOURCES "/templates/%1.glb").arg(file).toStdString());
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    const int index = asset.value()->clipIndex(clip.toStdString());
    QVERIFY(index >= 0);
    const glm::vec3 ground = gltf::footVelocity(*asset.value(), index);
    const float expected = asset.value()->clips[static_cast<std::size_t>(index)].speed;
    QVERIFY2(std::abs(-ground.z - expected) <= 0.1F * expected && std::abs(ground.x) < 0.1F,
             qPrintable(QStringLiteral("%1 m/s, expected %2").arg(-ground.z).arg(expected)));
}

CROWD_TEST(tst_GroundSpeed)
#include "tst_GroundSpeed.moc"
