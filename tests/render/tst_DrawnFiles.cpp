// SPDX-License-Identifier: MIT
#include <QtCore/QDir>
#include <QtCore/QDirIterator>
#include <QtCore/QFile>
#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <QtCore/QTemporaryDir>
#include <QtTest/QtTest>

#include "model/gltf/GltfImport.h"
#include "tests/program/Test.h"
#include "tests/render/FileDrawing.h"

using namespace crowd;
using namespace crowd::testing;

/// Every file of the third-party collection, where that is there: what is imported is also baked
/// and drawn, near and far, and can be seen.
class TestDrawnFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void fileIsSeen_data();
    void fileIsSeen();
    void fileWithoutNormalsIsSeen_data();
    void fileWithoutNormalsIsSeen();
    void cleanupTestCase();

private:
    void addRows(const QString& pattern);
    void importAndDraw(const std::string& path);

    QDir m_folder{QStringLiteral(CROWD_THIRD_PARTY_ASSETS)};
    QJsonObject m_refusals;
    std::unique_ptr<FileDrawing> m_drawing;
};

void TestDrawnFiles::initTestCase()
{
    if (!m_folder.exists()) {
        QSKIP("The third-party collection is not here; see CROWD_THIRD_PARTY_ASSETS.");
    }
    QFile refusals(QStringLiteral(CROWD_TEST_DATA "/gltf/expected_refusals.json"));
    QVERIFY(refusals.open(QIODevice::ReadOnly));
    m_refusals = QJsonDocument::fromJson(refusals.readAll()).object();
    m_drawing = std::make_unique<FileDrawing>();
    QVERIFY2(m_drawing->problem().empty(), m_drawing->problem().c_str());
}

void TestDrawnFiles::cleanupTestCase()
{
    m_drawing.reset();
}

void TestDrawnFiles::addRows(const QString& pattern)
{
    QTest::addColumn<QString>("file");
    QDirIterator files(m_folder.path(),
                       {pattern + QStringLiteral(".glb"), pattern + QStringLiteral(".gltf")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString file = files.next();
        const QString name = m_folder.relativeFilePath(file);
        if (!m_refusals.contains(name)) {
            QTest::newRow(name.toUtf8().constData()) << file;
        }
    }
}

void TestDrawnFiles::importAndDraw(const std::string& path)
{
    const auto asset = model::importTemplate(path);
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    for (const float share : {0.8F, 0.1F}) { // of the picture's height: the finest level, a coarse
        const DrawnFile drawn = m_drawing->draw(asset.value(), share);
        QVERIFY2(drawn.problem.empty(), drawn.problem.c_str());
        QVERIFY2(drawn.coveredPixels > 0, "nothing of it is seen");
    }
}

void TestDrawnFiles::fileIsSeen_data()
{
    addRows(QStringLiteral("*"));
}

void TestDrawnFiles::fileIsSeen()
{
    QFETCH(const QString, file);
    importAndDraw(file.toStdString());
}

void TestDrawnFiles::fileWithoutNormalsIsSeen_data()
{
    addRows(QStringLiteral("*"));
}

/// The same characters as a program would write them that leaves normals to the reader.
void TestDrawnFiles::fileWithoutNormalsIsSeen()
{
    QFETCH(const QString, file);
    QFile source(file);
    QVERIFY(source.open(QIODevice::ReadOnly));
    QByteArray bytes = source.readAll();
    const qsizetype before = bytes.size();
    bytes.replace("\"NORMAL\"", "\"_NORMA\""); // as long, so that the file's lengths stay true
    if (bytes.size() != before || !bytes.contains("\"_NORMA\"")) {
        QSKIP("It has no normals that could be taken away.");
    }
    const QTemporaryDir folder; // beside links to what the file names

    const QString name = folder.filePath(QFileInfo(file).fileName());
    const QDir neighbours(QFileInfo(file).path());
    for (const QFileInfo& entry :
         neighbours.entryInfoList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot)) {
        if (entry.fileName() != QFileInfo(file).fileName()) {
            QVERIFY(QFile::link(entry.absoluteFilePath(), folder.filePath(entry.fileName())));
        }
    }
    QFile changed(name);
    QVERIFY(changed.open(QIODevice::WriteOnly) && changed.write(bytes) == bytes.size());
    changed.close();
    importAndDraw(name.toStdString());
}

CROWD_TEST(TestDrawnFiles)
#include "tst_DrawnFiles.moc"
