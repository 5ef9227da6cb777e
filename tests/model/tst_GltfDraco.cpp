// SPDX-License-Identifier: MIT
#include "model/gltf/GltfImport.h"

#include <atomic>
#include <cmath>
#include <map>
#include <thread>

#include <QtCore/QProcess>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/gltf/ApartProcess.h"
#include "tests/model/DracoGround.h"
#include "tests/model/GltfBuilder.h"
#include "tests/model/GltfMutator.h"
#include "tests/program/Test.h"

using namespace crowd::model;

namespace {

using Json = GltfBuilder::Json;
using Bytes = std::vector<std::uint8_t>;

using draco_ground::kCorners;
using draco_ground::kPoints;

glm::vec3 ground(int x, int z)
{
    return {static_cast<float>(x), draco_ground::height(x, z), static_cast<float>(z)};
}

/// Positions and joints of the ground, compressed.
Bytes compressed(int method, int quantisation)
{
    static std::map<std::pair<int, int>, Bytes> known;
    Bytes& bytes = known[{method, quantisation}];
    if (bytes.empty()) {
        QProcess packer;
        packer.start(QStringLiteral(CROWD_PACK_GROUND),
                     {QString::number(method), QString::number(quantisation)});
        if (!packer.waitForFinished() || packer.exitCode() != 0) {
            qFatal("pack_ground does not work");
        }
        const QByteArray out = packer.readAllStandardOutput();
        bytes.assign(out.begin(), out.end());
    }
    return bytes;
}

GltfBuilder file(const Bytes& data)
{
    GltfBuilder builder;
    builder.root["extensionsUsed"] = {"KHR_draco_mesh_compression"};
    builder.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
    const int view = builder.view(data);
    const int positions = builder.accessorOf(-1, 5126, kPoints, "VEC3");
    const int joints = builder.accessorOf(-1, 5123, kPoints, "VEC4");
    const int indices = builder.accessorOf(-1, 5123, kCorners, "SCALAR");
    const int weights =
        builder.accessor(std::vector<float>(static_cast<std::size_t>(kPoints) * 4, 0.25F), "VEC4");
    const Json extension = {{"bufferView", view},
                            {"attributes", {{"POSITION", 0}, {"JOINTS_0", 1}}}};
    builder.add(
        "meshes",
        {{"primitives",
          {{{"attributes", {{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}}},
            {"indices", indices},
            {"extensions", {{"KHR_draco_mesh_compression", extension}}}}}}});
    builder.add("nodes", {{"mesh", 0}, {"skin", 0}});
    builder.add("nodes", Json::object());
    builder.add("nodes", {{"translation", {0, 4, 0}}});
    builder.add("skins", {{"joints", {1, 2}}});
    builder.add("scenes", {{"nodes", {0, 1, 2}}});
    return builder;
}

/// Every triangle corner lies on the ground.
bool liesOnGround(const Mesh& mesh, float tolerance)
{
    return std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const glm::vec3& p) {
        const glm::vec3 there =
            ground(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.z)));
        return glm::length(p - there) <= tolerance;
    });
}

} // namespace

class tst_GltfDraco : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unpacks_data();
    void unpacks();
    void sharesWhatIsUsedTwice();
    void prefersPlainData();
    void refusesWhatDoesNotFit_data();
    void refusesWhatDoesNotFit();
    void survivesDamage();
    void survivesTruncation();
    void decodesOnManyThreads();
    void bringsHomeWhatProgramsSay();
    void endsProgramsThatMisbehave_data();
    void endsProgramsThatMisbehave();

private:
    Result<TemplatePtr> load(const GltfBuilder& builder)
    {
        return importTemplate(
            writeFile(m_folder.filePath(QStringLiteral("packed.glb")), builder.glb()));
    }

    QTemporaryDir m_folder;
};

void tst_GltfDraco::unpacks_data()
{
    QTest::addColumn<int>("method");
    QTest::addColumn<int>("quantisation");
    QTest::newRow("edgebreaker, exact") << 1 << 0;
    QTest::newRow("edgebreaker, 12 bits") << 1 << 12;
    QTest::newRow("sequential, 12 bits") << 0 << 12;
}

void tst_GltfDraco::unpacks()
{
    QFETCH(const int, method);
    QFETCH(const int, quantisation);
    const Result<TemplatePtr> asset = load(file(compressed(method, quantisation)));
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    const Mesh& mesh = asset.value()->levels.front();
    QCOMPARE(mesh.fileVertexCount, std::size_t{kPoints});
    QCOMPARE(mesh.triangleCount(), std::size_t{kCorners / 3});
    QVERIFY(liesOnGround(mesh, quantisation == 0 ? 0.0F : 0.002F));
    for (std::size_t v = 0; v < kPoints; ++v) {
        const int joint = static_cast<int>(std::lround(mesh.positions[v].x)) % 2;
        QCOMPARE(asset.value()->bones[mesh.bones[v * 4]].node, 1 + joint);
    }
}

void tst_GltfDraco::sharesWhatIsUsedTwice()
{
    GltfBuilder builder = file(compressed(1, 12));
    Json& primitives = builder.root["meshes"][0]["primitives"];
    primitives.push_back(Json(primitives[0]));
    const Result<TemplatePtr> asset = load(builder);
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    QCOMPARE(asset.value()->levels.front().triangleCount(), std::size_t{2 * kCorners / 3});
}

void tst_GltfDraco::prefersPlainData()
{
    GltfBuilder builder = GltfBuilder::triangle();
    const int view = builder.view(Bytes{1, 2, 3});
    builder.root["meshes"][0]["primitives"][0]["extensions"] = {
        {"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}}}};
    const Result<TemplatePtr> asset = load(builder);
    QVERIFY2(asset.isOk(), asset ? "" : asset.error().message.c_str());
    QCOMPARE(asset.value()->levels.front().triangleCount(), std::size_t{1});
    // Not demanded, but the plain data is not there.
    GltfBuilder without = file(compressed(1, 12));
    without.root.erase("extensionsRequired");
    const Result<TemplatePtr> unpacked = load(without);
    QVERIFY2(unpacked.isOk(), unpacked ? "" : unpacked.error().message.c_str());
    QCOMPARE(unpacked.value()->levels.front().triangleCount(), std::size_t{kCorners / 3});
}

void tst_GltfDraco::refusesWhatDoesNotFit_data()
{
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<int>("value");
    QTest::addColumn<QString>("message");
    const QString extension =
        QStringLiteral("/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression");
    QTest::newRow("no such view") << extension + QStringLiteral("/bufferView") << 77
                                  << QStringLiteral("bufferView is not the index");
    QTest::newRow("no such attribute") << extension + QStringLiteral("/attributes/POSITION") << 9
                                       << QStringLiteral("it lacks an attribute");
    QTest::newRow("joints as positions") << extension + QStringLiteral("/attributes/POSITION") << 1
                                         << QStringLiteral("it lacks an attribute");
    QTest::newRow("no attribute's number")
        << extension + QStringLiteral("/attributes/JOINTS_0") << -3
        << QStringLiteral("attributes.JOINTS_0 is nothing");
    QTest::newRow("no list of attributes") << extension + QStringLiteral("/attributes") << 1
                                           << QStringLiteral("attributes has no POSITION");
    QTest::newRow("more vertices than it says")
        << QStringLiteral("/accessors/0/count") << 20
        << QStringLiteral("it has 49 vertices, but its accessors say 20");
    QTest::newRow("more triangles than it says")
        << QStringLiteral("/accessors/2/count") << 30
        << QStringLiteral("it has 216 indices, but its accessor says 30");
    QTest::newRow("other data") << extension + QStringLiteral("/bufferView") << 1
                                << QStringLiteral("cannot be read: it is damaged");
}

void tst_GltfDraco::refusesWhatDoesNotFit()
{
    QFETCH(const QString, pointer);
    QFETCH(const int, value);
    QFETCH(const QString, message);
    GltfBuilder builder = file(compressed(1, 12));
    builder.root[Json::json_pointer(pointer.toStdString())] = value;
    const Result<TemplatePtr> asset = load(builder);
    QVERIFY(!asset.isOk());
    const QString told = QString::fromStdString(asset.error().message);
    QVERIFY2(told.contains(message), qPrintable(told));
    QVERIFY2(told.startsWith(QStringLiteral("packed.glb: meshes[0].primitives[0]")),
             qPrintable(told));
}

void tst_GltfDraco::survivesDamage()
{
    int refused = 0;
    for (std::uint64_t round = 0; round < 300; ++round) {
        const Bytes whole = compressed(static_cast<int>(round % 2), round % 3 == 0 ? 0 : 12);
        const QByteArray broken = GltfMutator(round).damageBytes(QByteArray(
            reinterpret_cast<const char*>(whole.data()), static_cast<qsizetype>(whole.size())));
        const Result<TemplatePtr> asset = load(file(Bytes(broken.begin(), broken.end())));
        refused += asset ? 0 : 1;
        QVERIFY2(asset || asset.error().message.find("too long") == std::string::npos,
                 qPrintable(QString::number(round)));
        QVERIFY(!asset || std::isfinite(asset.value()->height));
    }
    QVERIFY2(refused > 100, qPrintable(QString::number(refused)));
}

void tst_GltfDraco::survivesTruncation()
{
    const Bytes whole = compressed(1, 12);
    for (std::size_t size = 0; size < whole.size(); size += 11) {
        const Result<TemplatePtr> asset =
            load(file(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size))));
        QVERIFY2(!asset.isOk(), qPrintable(QString::number(size)));
        QVERIFY(asset.error().message.find("Export it again") != std::string::npos);
    }
}

void tst_GltfDraco::decodesOnManyThreads()
{
    const std::string path =
        writeFile(m_folder.filePath(QStringLiteral("shared.glb")), file(compressed(1, 12)).glb());
    std::atomic<int> read = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) {
        threads.emplace_back([&] { read += importTemplate(path).isOk() ? 1 : 0; });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    QCOMPARE(read.load(), 8);
}

void tst_GltfDraco::bringsHomeWhatProgramsSay()
{
    const Bytes input(300'000, 7);
    const auto same = gltf::runApart("/bin/cat", input, {input.size(), 20'000});
    QVERIFY2(same.isOk(), same ? "" : same.error().message.c_str());
    QVERIFY(same.value() == input);
    QVERIFY(gltf::besideProgram("no such program").empty());
    QVERIFY(!gltf::besideProgram("crowdbrush-unpack").empty());
}

void tst_GltfDraco::endsProgramsThatMisbehave_data()
{
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QString>("message");
    QTest::newRow("crashes") << QByteArray("kill -SEGV $$") << QStringLiteral("damaged");
    QTest::newRow("fails") << QByteArray("exit 3") << QStringLiteral("damaged");
    // For longer than a test may take.
    QTest::newRow("hangs") << QByteArray("exec sleep 1000") << QStringLiteral("too long");
    QTest::newRow("says too much") << QByteArray("exec yes") << QStringLiteral("more than it says");
}

void tst_GltfDraco::endsProgramsThatMisbehave()
{
    QFETCH(const QByteArray, script);
    QFETCH(const QString, message);
    const auto done = gltf::runApart("/bin/sh", Bytes(script.begin(), script.end()), {1000, 1500});
    QVERIFY(!done.isOk());
    QVERIFY2(QString::fromStdString(done.error().message).contains(message),
             done.error().message.c_str());
    QVERIFY(!gltf::runApart("/no/such/program", {}, {1000, 1500}).isOk());
}

CROWD_TEST(tst_GltfDraco)
#include "tst_GltfDraco.moc"
