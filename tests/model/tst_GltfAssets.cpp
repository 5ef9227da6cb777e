// SPDX-License-Identifier: MIT
#include "model/gltf/GltfImport.h"
#include "tests/program/Test.h"

#include <cmath>
#include <set>

#include <QtCore/QDir>
#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QJsonArray>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QProcess>
#include <QtTest/QTest>

using namespace crowd::model;

/// Every file of the third-party collection, where that is there, against a reader of glTF that
/// shares no code with the importer.
class tst_GltfAssets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void agreesWithTheIndependentReader_data();
    void agreesWithTheIndependentReader();
    void refusesOnlyWithReason();

private:
    static TemplatePtr import(const QString& file);

    QDir m_folder{QStringLiteral(CROWD_THIRD_PARTY_ASSETS)};
    QJsonObject m_refusals;
    QJsonObject m_facts;
    QStringList m_files;
};

TemplatePtr tst_GltfAssets::import(const QString& file)
{
    const Result<TemplatePtr> asset = importTemplate(file.toStdString());
    return asset ? asset.value() : nullptr;
}

void tst_GltfAssets::initTestCase()
{
    if (!m_folder.exists()) {
        QSKIP("The third-party collection is not here; see CROWD_THIRD_PARTY_ASSETS.");
    }
    QFile refusals(QStringLiteral(CROWD_TEST_DATA "/gltf/expected_refusals.json"));
    QVERIFY(refusals.open(QIODevice::ReadOnly));
    m_refusals = QJsonDocument::fromJson(refusals.readAll()).object();
    QDirIterator files(m_folder.path(), {QStringLiteral("*.glb"), QStringLiteral("*.gltf")},
                       QDir::Files, QDirIterator::Subdirectories);
    QByteArray input;
    while (files.hasNext()) {
        const QString file = files.next();
        if (m_refusals.contains(m_folder.relativeFilePath(file))) {
            continue;
        }
        const TemplatePtr asset = import(file);
        const QByteArray clip =
            asset ? QByteArray::fromStdString(
                        asset->clips[static_cast<std::size_t>(asset->defaultClip)].name)
                  : QByteArray();
        input += file.toUtf8() + '\t' + clip + '\n';
        m_files.append(file);
    }
    m_files.sort();
    QProcess reader;
    reader.start(QStringLiteral("/usr/bin/python3"),
                 {QStringLiteral(CROWD_TEST_DATA "/../tools/gltf_facts.py")});
    QVERIFY(reader.waitForStarted());
    reader.write(input);
    reader.closeWriteChannel();
    QVERIFY2(reader.waitForFinished(240'000), "the independent reader takes too long");
    QVERIFY2(reader.exitCode() == 0, reader.readAllStandardError().constData());
    m_facts = QJsonDocument::fromJson(reader.readAllStandardOutput()).object();
}

void tst_GltfAssets::agreesWithTheIndependentReader_data()
{
    QTest::addColumn<QString>("file");
    for (const QString& file : m_files) {
        QTest::newRow(m_folder.relativeFilePath(file).toUtf8().constData()) << file;
    }
}

void tst_GltfAssets::agreesWithTheIndependentReader()
{
    QFETCH(const QString, file);
    const Result<TemplatePtr> imported = importTemplate(file.toStdString());
    QVERIFY2(imported.isOk(), imported ? "" : imported.error().message.c_str());
    const Template& asset = *imported.value();
    const QJsonObject facts = m_facts[file].toObject();

    QCOMPARE(static_cast<int>(asset.levels.front().triangleCount()),
             facts[QStringLiteral("triangles")].toInt());

    QStringList slotNames;
    for (const Slot& slot : asset.slots) {
        slotNames.append(QString::fromStdString(slot.name));
    }
    const QStringList expectedSlots = facts[QStringLiteral("slots")].toVariant().toStringList();
    if (!expectedSlots.isEmpty()) {
        QCOMPARE(slotNames, expectedSlots);
    }

    const QJsonArray clips = facts[QStringLiteral("clips")].toArray();
    QCOMPARE(asset.clips.front().isMadeUp, clips.isEmpty());
    for (int i = 0; i < clips.size(); ++i) {
        const Clip& clip = asset.clips.at(static_cast<std::size_t>(i));
        const QJsonObject expected = clips[i].toObject();
        QCOMPARE(QString::fromStdString(clip.name), expected[QStringLiteral("name")].toString());
        QVERIFY(std::abs(static_cast<double>(clip.seconds) -
                         expected[QStringLiteral("seconds")].toDouble()) < 1e-5);
    }

    QJsonValue known = facts[QStringLiteral("height")];
    if (known.isNull()) { // compressed: the independent reader knows the plain form beside it
        QString plain = file;
        plain.replace(QStringLiteral("/glTF-Draco/"), QStringLiteral("/glTF/"));
        known = m_facts[plain].toObject()[QStringLiteral("height")];
    }
    QVERIFY(known.isDouble());
    const double height = known.toDouble();
    QVERIFY2(std::abs(static_cast<double>(asset.height) - height) < 1e-4 * std::max(1.0, height),
             qPrintable(QStringLiteral("height %1, expected %2").arg(asset.height).arg(height)));
}

void tst_GltfAssets::refusesOnlyWithReason()
{
    for (const QString& file : m_refusals.keys()) {
        const QString path = m_folder.filePath(file);
        const Result<TemplatePtr> asset = importTemplate(path.toStdString());
        QVERIFY2(!asset.isOk(), qPrintable(file + QStringLiteral(" is not refused any more")));
        const QString message = QString::fromStdString(asset.error().message);
        const QJsonObject expected = m_refusals[file].toObject();
        QVERIFY2(message.contains(expected[QStringLiteral("message")].toString()),
                 qPrintable(message));
        QVERIFY(!expected[QStringLiteral("reason")].toString().isEmpty());
    }
}

CROWD_TEST(tst_GltfAssets)
#include "tst_GltfAssets.moc"
