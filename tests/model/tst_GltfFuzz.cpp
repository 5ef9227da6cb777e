// SPDX-License-Identifier: MIT
#include "model/gltf/GltfImport.h"

#include <sys/resource.h>

#include <cmath>

#include <QtCore/QDir>
#include <QtCore/QDirIterator>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/bake/ClipBaker.h"
#include "model/gltf/ImportProposal.h"
#include "tests/model/GltfMutator.h"
#include "tests/model/GltfSamples.h"
#include "tests/program/FileContent.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::contentOf;

/// Damaged files, some thousands of them, the same at every run: none may crash, hang or take the
/// memory. For a longer hunt: CROWD_FUZZ_ROUNDS mutants of each file under CROWD_FUZZ_FOLDER, from
/// CROWD_FUZZ_SEED on, each left in CROWD_FUZZ_KEEP while it is read.
class tst_GltfFuzz : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void survivesDamage_data();
    void survivesDamage();
    void tookLittleMemory();

private:
    void tryMutant(const QString& path);

    QTemporaryDir m_temporary;
    QTemporaryDir m_made; ///< files with a little of everything
    QString m_folder;
    QString m_scratch;
    int m_rounds = 60;
    quint64 m_seed = 1;
};

namespace {

/// No more may come of a byte than so many numbers: what small files can ask for is bounded.
constexpr std::size_t kMostOfAByte = 16;

qint64 bytesIn(const QString& folder)
{
    qint64 bytes = 0;
    for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files)) {
        bytes += file.size();
    }
    return bytes;
}

/// What an import has made, in vertices, indices, keys, bones and nodes.
std::size_t amountOf(const Template& asset)
{
    std::size_t amount = asset.nodes.size() + asset.bones.size();
    for (const Mesh& level : asset.levels) {
        amount += level.positions.size() + level.indices.size() + level.submeshes.size();
    }
    for (const Clip& clip : asset.clips) {
        for (const Channel& channel : clip.channels) {
            amount += channel.times.size() + channel.values.size();
        }
    }
    return amount;
}

std::size_t amountOf(const StageAsset& stage)
{
    std::size_t amount = stage.seats.size();
    for (const StageMesh& mesh : stage.meshes) {
        amount += mesh.positions.size() + mesh.indices.size();
    }
    return amount;
}

std::string fileNameOf(const QString& path)
{
    return QFileInfo(path).fileName().toStdString();
}

} // namespace

void tst_GltfFuzz::initTestCase()
{
    m_folder = qEnvironmentVariable("CROWD_FUZZ_FOLDER", QStringLiteral(CROWD_RESOURCES));
    m_rounds = qEnvironmentVariable("CROWD_FUZZ_ROUNDS", QStringLiteral("60")).toInt();
    m_seed = qEnvironmentVariable("CROWD_FUZZ_SEED", QStringLiteral("1")).toULongLong();
    m_scratch = qEnvironmentVariable("CROWD_FUZZ_KEEP", m_temporary.path());
    const GltfBuilder everything = gltf_samples::everything();
    writeFile(m_made.filePath(QStringLiteral("everything.glb")), everything.glb());
    writeFile(m_made.filePath(QStringLiteral("everything.gltf")), everything.embedded());
    for (const char* name : {"everything.glb", "everything.gltf"}) {
        const auto whole = importTemplate(m_made.filePath(QLatin1String(name)).toStdString());
        QVERIFY2(whole.isOk(), whole ? "" : whole.error().message.c_str());
        QCOMPARE(whole.value()->levels.size(), std::size_t{2});
    }
}

void tst_GltfFuzz::survivesDamage_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<int>("rounds");
    for (const char* name : {"everything.glb", "everything.gltf"}) {
        QTest::newRow(name) << m_made.filePath(QLatin1String(name)) << 10 * m_rounds;
    }
    const QDir folder(m_folder);
    QDirIterator files(m_folder, {QStringLiteral("*.glb"), QStringLiteral("*.gltf")}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString file = files.next();
        QTest::newRow(folder.relativeFilePath(file).toUtf8().constData()) << file << m_rounds;
    }
}

void tst_GltfFuzz::survivesDamage()
{
    QFETCH(const QString, file);
    QFETCH(const int, rounds);
    const QByteArray whole = contentOf(file);
    const QString suffix = QFileInfo(file).suffix();
    const QDir beside = QFileInfo(file).dir();
    const bool hasFiles = suffix == QStringLiteral("gltf");
    for (const QFileInfo& other : beside.entryInfoList(QDir::Files)) {
        if (hasFiles && other.size() < 20'000'000) {
            QFile::copy(other.filePath(), m_scratch + u'/' + other.fileName());
        }
    }
    const QString path = m_scratch + QStringLiteral("/mutant.") + suffix;
    for (int round = 0; round < rounds; ++round) {
        GltfMutator mutator(m_seed + static_cast<quint64>(round));
        writeFile(path, mutator.mutate(whole));
        tryMutant(path);
        if (QTest::currentTestFailed()) {
            QFile::copy(path, m_scratch + QStringLiteral("/failed_%1.%2").arg(round).arg(suffix));
            return;
        }
    }
}

void tst_GltfFuzz::tryMutant(const QString& path)
{
    const auto most = kMostOfAByte * static_cast<std::size_t>(bytesIn(m_scratch));
    const Result<TemplatePtr> asset = importTemplate(path.toStdString());
    if (asset) {
        QVERIFY(std::isfinite(asset.value()->height));
        QVERIFY2(amountOf(*asset.value()) < most, qPrintable(path));
        (void)proposeImport(*asset.value());
        (void)bakeClip(*asset.value(), asset.value()->defaultClip, 1);
    } else {
        const std::string& message = asset.error().message;
        QVERIFY2(message.starts_with(fileNameOf(path) + ": "), message.c_str());
        QVERIFY2(message.size() < 2000, message.c_str());
    }
    const Result<StagePtr> stage = importStage(path.toStdString());
    QVERIFY(stage.isOk() || !asset.isOk()); // what nobody would see is refused as a character alone
    QVERIFY2(!stage || amountOf(*stage.value()) < most, qPrintable(path));
}

void tst_GltfFuzz::tookLittleMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const long megabytes = usage.ru_maxrss / 1024;
    QVERIFY2(megabytes < 2048, qPrintable(QStringLiteral("took %1 MiB").arg(megabytes)));
}

CROWD_TEST(tst_GltfFuzz)
#include "tst_GltfFuzz.moc"
