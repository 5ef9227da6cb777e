// SPDX-License-Identifier: MIT
#include <QtTest/QtTest>

#include <algorithm>
#include <cstring>

#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>

#include "model/bake/ClipBaker.h"
#include "model/bake/KeyframeStore.h"
#include "model/gltf/GltfImport.h"
#include "tests/program/Test.h"

using namespace crowd::model;

/// Our keyframes against the meshes that Blender's importer and armature modifier make of the same
/// files: an independent calculation, kept in tests/data/skinning.
class TestBakeAgainstBlender : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keyframesAgree_data();
    void keyframesAgree();
};

void TestBakeAgainstBlender::keyframesAgree_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("man") << QStringLiteral("man");
    QTest::newRow("woman") << QStringLiteral("woman");
}

void TestBakeAgainstBlender::keyframesAgree()
{
    QFETCH(QString, name);
    const QString folder = QStringLiteral(CROWD_TEST_DATA "/skinning/");
    QFile description(folder + name + QStringLiteral(".json"));
    QVERIFY(description.open(QIODevice::ReadOnly));
    const QJsonObject reference = QJsonDocument::fromJson(description.readAll()).object();
    QFile binary(folder + reference[QStringLiteral("binary")].toString());
    QVERIFY(binary.open(QIODevice::ReadOnly));
    const QByteArray bytes = binary.readAll();

    const QString file = reference[QStringLiteral("template")].toString().replace(
        QStringLiteral("builtin:"), QStringLiteral(CROWD_RESOURCES "/"));
    const auto asset = importTemplate(file.toStdString());
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    int vertices = 0;
    for (const QJsonValue count : reference[QStringLiteral("primitiveVertexCounts")].toArray()) {
        vertices += count.toInt();
    }
    const auto count = static_cast<std::size_t>(vertices);
    const QJsonArray samples = reference[QStringLiteral("samples")].toArray();
    QVERIFY(samples.size() >= 6);
    for (const QJsonValue item : samples) {
        const QJsonObject sample = item.toObject();
        const QString clipName = sample[QStringLiteral("clip")].toString();
        const int keyframe = sample[QStringLiteral("keyframe")].toInt();
        const int clip = asset.value()->clipIndex(clipName.toStdString());
        QVERIFY2(clip >= 0, qPrintable(clipName));
        const std::vector<glm::vec3> ours = exactKeyframe(*asset.value(), clip, keyframe).positions;
        QVERIFY(ours.size() >= count); // what they carry follows the body
        const qsizetype offset = sample[QStringLiteral("byteOffset")].toInt();
        QVERIFY(offset + static_cast<qsizetype>(count * sizeof(glm::vec3)) <= bytes.size());
        std::vector<glm::vec3> theirs(count);
        std::memcpy(theirs.data(), bytes.constData() + offset, count * sizeof(glm::vec3));
        const BakedClipPtr packed = bakeClip(*asset.value(), clip, keyframe + 1);
        float worst = 0.0F;
        float worstPacked = 0.0F;
        for (std::size_t v = 0; v < count; ++v) {
            worst = std::max(worst, glm::length(ours[v] - theirs[v]));
            worstPacked =
                std::max(worstPacked, glm::length(packed->position(0, keyframe, v) - ours[v]));
        }
        const QString place = QStringLiteral("%1 at keyframe %2: %3 mm, packed %4 mm")
                                  .arg(clipName)
                                  .arg(keyframe)
                                  .arg(static_cast<double>(worst) * 1000.0)
                                  .arg(static_cast<double>(worstPacked) * 1000.0);
        QVERIFY2(worst <= 0.0001F, qPrintable(place));
        QVERIFY2(worstPacked <= 0.0001F, qPrintable(place));
    }
}

CROWD_TEST(TestBakeAgainstBlender)
#include "tst_BakeAgainstBlender.moc"
