// SPDX-License-Identifier: MIT
#include "model/project/CollectAssets.h"

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/project/LocateAssets.h"
#include "model/project/SceneAssets.h"
#include "tests/model/GltfBuilder.h"
#include "tests/program/FileContent.h"
#include "tests/program/Test.h"

using namespace crowd::model;
using crowd::testing::contentOf;

/// Copies of assets beside the scene, and finding assets that have moved.
class tst_CollectAssets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void copiesAModelWithAllItsFiles();
    void copiesWhatABinaryModelNames();
    void keepsModelsOfTheSameNameApart();
    void leavesAloneWhatIsThere();
    void copiesOnceWhatTwoEntriesUse();
    void tellsWhatIsMissing();
    void copiesNothingFromOutsideTheModelsFolder();
    void failsWithoutHarmWhereItCannotWrite();
    void collectedModelsLoad();
    void findsWhatMovedAlong();

private:
    [[nodiscard]] QString at(const char* name) const
    {
        return m_folder->filePath(QString::fromUtf8(name));
    }
    void put(const char* name, const QByteArray& content) const;
    void addTemplate(const char* path);
    [[nodiscard]] std::string collectedPath(std::size_t entry);

    std::unique_ptr<QTemporaryDir> m_folder;
    Scene m_scene;
};

void tst_CollectAssets::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    m_scene = Scene{};
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("scene")));
}

void tst_CollectAssets::put(const char* name, const QByteArray& content) const
{
    QVERIFY(QDir().mkpath(QFileInfo(at(name)).absolutePath()));
    QFile file(at(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
}

void tst_CollectAssets::addTemplate(const char* path)
{
    TemplateEntry entry;
    entry.id = static_cast<TemplateId>(m_scene.templates.size() + 1);
    entry.path = at(path).toStdString();
    m_scene.templates.push_back(entry);
}

/// Collects and takes the new paths over; the path of an entry below the scene's folder.
std::string tst_CollectAssets::collectedPath(std::size_t entry)
{
    const Result<CollectedEntries> collected = collectAssets(m_scene, at("scene"));
    if (!collected) {
        return collected.error().message;
    }
    for (const TemplateEntry& changed : collected.value().templates) {
        *m_scene.findTemplate(changed.id) = changed;
    }
    return QDir(at("scene"))
        .relativeFilePath(QString::fromStdString(m_scene.templates[entry].path))
        .toStdString();
}

void tst_CollectAssets::copiesAModelWithAllItsFiles()
{
    put("models/füchse/fox.gltf",
        R"({"buffers": [{"uri": "fox%20data.bin"}, {"uri": "data:;base64,AA=="}],
            "images": [{"uri": "maps/fell.png"}, {"bufferView": 0}]})");
    put("models/füchse/fox data.bin", "bytes");
    put("models/füchse/maps/fell.png", "picture");
    addTemplate("models/füchse/fox.gltf");
    QCOMPARE(collectedPath(0), std::string("assets/fox/fox.gltf"));
    QCOMPARE(contentOf(at("scene/assets/fox/fox data.bin")), QByteArray("bytes"));
    QCOMPARE(contentOf(at("scene/assets/fox/maps/fell.png")), QByteArray("picture"));
}

void tst_CollectAssets::copiesWhatABinaryModelNames()
{
    const QByteArray text = R"({"name": "BIN", "images": [{"uri": "BIN.png"}]})";
    QByteArray file("glTF\x02\0\0\0\0\0\0\0", 12);
    const auto length = static_cast<quint32>(text.size());
    file.append(reinterpret_cast<const char*>(&length), sizeof(length));
    file += "JSON" + text + QByteArray("\4\0\0\0BIN\0abcd", 12);
    put("m/a.glb", file);
    put("m/BIN.png", "picture");
    addTemplate("m/a.glb");
    QCOMPARE(collectedPath(0), std::string("assets/a/a.glb"));
    QCOMPARE(contentOf(at("scene/assets/a/BIN.png")), QByteArray("picture"));
}

void tst_CollectAssets::keepsModelsOfTheSameNameApart()
{
    put("a/man.gltf", R"({"buffers": [{"uri": "man.bin"}]})");
    put("a/man.bin", "first");
    put("b/man.gltf", R"({"buffers": [{"uri": "man.bin"}]})");
    put("b/man.bin", "second");
    addTemplate("a/man.gltf");
    addTemplate("b/man.gltf");
    QCOMPARE(collectedPath(0), std::string("assets/man/man.gltf"));
    QCOMPARE(collectedPath(1), std::string("assets/man-2/man.gltf"));
    QCOMPARE(contentOf(at("scene/assets/man/man.bin")), QByteArray("first"));
    QCOMPARE(contentOf(at("scene/assets/man-2/man.bin")), QByteArray("second"));
}

void tst_CollectAssets::leavesAloneWhatIsThere()
{
    put("a/man.gltf", "{}");
    put("scene/assets/man/man.gltf", "{\"other\": 1}"); // somebody else's
    addTemplate("a/man.gltf");
    TemplateEntry builtin;
    builtin.id = 2;
    builtin.path = "builtin:templates/man.glb";
    m_scene.templates.push_back(builtin);
    QCOMPARE(collectedPath(0), std::string("assets/man-2/man.gltf"));
    QCOMPARE(m_scene.templates[1].path, builtin.path);
    QCOMPARE(contentOf(at("scene/assets/man/man.gltf")), QByteArray("{\"other\": 1}"));
    const Result<CollectedEntries> again = collectAssets(m_scene, at("scene"));
    QVERIFY(again.isOk());
    QVERIFY(again.value().templates.empty());
}

void tst_CollectAssets::copiesOnceWhatTwoEntriesUse()
{
    put("a/man.gltf", "{}");
    addTemplate("a/man.gltf");
    addTemplate("a/man.gltf");
    QCOMPARE(collectedPath(0), std::string("assets/man/man.gltf"));
    QCOMPARE(m_scene.templates[0].path, m_scene.templates[1].path);
    QCOMPARE(QDir(at("scene/assets")).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(), 1);
}

void tst_CollectAssets::tellsWhatIsMissing()
{
    put("a/man.gltf", R"({"images": [{"uri": "gone.png"}]})");
    addTemplate("a/man.gltf");
    addTemplate("a/nobody.glb");
    const Result<CollectedEntries> collected = collectAssets(m_scene, at("scene"));
    QVERIFY(collected.isOk());
    QCOMPARE(collected.value().templates.size(), std::size_t{1});
    QCOMPARE(collected.value().leftBehind, QStringList({at("a/gone.png"), at("a/nobody.glb")}));
}

void tst_CollectAssets::copiesNothingFromOutsideTheModelsFolder()
{
    put("secret.txt", "secret");
    put("a/man.gltf", QStringLiteral(R"({"images": [{"uri": "../secret.txt"}, {"uri": "%1"},
                                                    {"uri": "..%2Fsecret.txt"}, {"uri": 5}]})")
                          .arg(at("secret.txt"), QStringLiteral("%2"))
                          .toUtf8());
    addTemplate("a/man.gltf");
    QCOMPARE(collectedPath(0), std::string("assets/man/man.gltf"));
    QCOMPARE(QDir(at("scene/assets/man")).entryList(QDir::Files),
             QStringList{QStringLiteral("man.gltf")});
    QVERIFY(!QFile::exists(at("scene/assets/secret.txt")));
}

void tst_CollectAssets::failsWithoutHarmWhereItCannotWrite()
{
    put("a/man.gltf", "{}");
    put("scene/assets", "a file where the folder should be");
    addTemplate("a/man.gltf");
    const Result<CollectedEntries> collected = collectAssets(m_scene, at("scene"));
    QVERIFY(!collected.isOk());
    QVERIFY2(collected.error().message.find("a/man.gltf") != std::string::npos,
             collected.error().message.c_str());
}

void tst_CollectAssets::collectedModelsLoad()
{
    GltfBuilder builder = GltfBuilder::triangle();
    builder.root["buffers"][0] = {{"byteLength", builder.bytes.size()}, {"uri", "tri.bin"}};
    put("a/tri.gltf", QByteArray::fromStdString(builder.root.dump()));
    put("a/tri.bin", QByteArray(reinterpret_cast<const char*>(builder.bytes.data()),
                                static_cast<qsizetype>(builder.bytes.size())));
    addTemplate("a/tri.gltf");
    QCOMPARE(collectedPath(0), std::string("assets/tri/tri.gltf"));
    QVERIFY(QDir(at("a")).removeRecursively());
    const Result<TemplatePtr> loaded = loadTemplateAsset(m_scene.templates.front());
    QVERIFY2(loaded.isOk(), loaded ? "" : loaded.error().message.c_str());
}

void tst_CollectAssets::findsWhatMovedAlong()
{
    put("new/models/man.glb", "");
    put("new/stages/hall.glb", "");
    put("new/models/dog.glb", "");
    const auto pathOf = [this](const char* name) { return at(name).toStdString(); };
    const auto moved = [&](const char* missing) {
        return movedAlong(pathOf(missing), pathOf("old/models/man.glb"),
                          pathOf("new/models/man.glb"));
    };
    QCOMPARE(moved("old/models/dog.glb"), pathOf("new/models/dog.glb"));
    QCOMPARE(moved("elsewhere/dog.glb"), pathOf("new/models/dog.glb"));
    QCOMPARE(moved("old/stages/hall.glb"), pathOf("new/stages/hall.glb"));
    QCOMPARE(moved("old/stages/none.glb"), std::string());
    QCOMPARE(movedAlong("builtin:templates/man.glb", pathOf("a.glb"), pathOf("new/models/a.glb")),
             std::string());
}

CROWD_TEST(tst_CollectAssets)
#include "tst_CollectAssets.moc"
