// SPDX-License-Identifier: MIT
#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QRegularExpression>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QToolButton>

#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/PresetsDock.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Desk;

/// Brushes kept under names: as files, and in their panel.
class PresetsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyBrushComesBackAsItWasKept();
    void whatBelongsToOneSceneIsNotKept();
    void namesAreUnique();
    void badFilesAreNamedAndLeftAlone_data();
    void badFilesAreNamedAndLeftAlone();
    void presetsAreShared();
    void foldersThatCannotBeWrittenAreSaid();
    void whatOthersWriteIsShown();
    void thePanelKeepsFindsAndSets();
    void whatABadFileHoldsSizesNoWindow();
};

namespace {

void put(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

model::BrushSettings wideScale()
{
    model::BrushSettings brush = model::initialBrush(model::BrushKind::Scale);
    brush.radiusPixels = 123.0F;
    brush.as<model::ScaleSettings>().height = {0.5F, 3.0F};
    return brush;
}

} // namespace

void PresetsTest::everyBrushComesBackAsItWasKept()
{
    QTemporaryDir folder;
    for (const model::BrushKind kind : model::shownBrushes()) {
        model::BrushSettings brush = model::initialBrush(kind);
        brush.radiusPixels = 77.0F;
        brush.distribution.weights[3] = 4.0F;
        BrushPresets presets(folder.filePath(QStringLiteral("new/brushes")));
        QVERIFY(presets.save(QStringLiteral("a #tag"), brush));
        BrushPresets again(folder.filePath(QStringLiteral("new/brushes")));
        QCOMPARE(again.all().size(), 1U);
        QVERIFY2(again.problems().isEmpty(), qPrintable(again.problems().join(u' ')));
        QCOMPARE(again.all()[0].kind, kind);
        QVERIFY(model::applied(again.all()[0], model::initialBrush(kind)) == brush);
    }
}

void PresetsTest::whatBelongsToOneSceneIsNotKept()
{
    QTemporaryDir folder;
    BrushPresets presets(folder.path());
    model::BrushSettings brush = model::initialBrush(model::BrushKind::Material);
    brush.as<model::MaterialSettings>().slot = "top"; // a word: another scene may have it
    QVERIFY(presets.save(QStringLiteral("top"), brush));
    model::BrushSettings group = model::initialBrush(model::BrushKind::Group);
    group.as<model::GroupSettings>().group = 7;
    QVERIFY(presets.save(QStringLiteral("group"), group));
    const auto other = model::initialBrush(model::BrushKind::Material);
    QVERIFY(model::applied(*presets.find(QStringLiteral("top")), other) == brush);
    model::BrushSettings here = model::initialBrush(model::BrushKind::Group);
    here.as<model::GroupSettings>().group = 2;
    QVERIFY(model::applied(*presets.find(QStringLiteral("group")), here) == here);
}

void PresetsTest::namesAreUnique()
{
    QTemporaryDir folder;
    BrushPresets presets(folder.path());
    QVERIFY(presets.save(QStringLiteral("Red"), wideScale()));
    QVERIFY(presets.save(QStringLiteral("red!"), wideScale())); // another file, too
    QVERIFY(presets.save(QStringLiteral("Red"), model::initialBrush(model::BrushKind::Tag)));
    QCOMPARE(presets.all().size(), 2U);
    QCOMPARE(presets.find(QStringLiteral("Red"))->kind, model::BrushKind::Tag);
    QCOMPARE(presets.freeName(QStringLiteral("Red")), QStringLiteral("Red 2"));
    QVERIFY(!presets.rename(QStringLiteral("Red"), QStringLiteral("red!")));
    QVERIFY(!presets.rename(QStringLiteral("Red"), QStringLiteral("  ")));
    QVERIFY(presets.rename(QStringLiteral("Red"), QStringLiteral("Blue")));
    QVERIFY(presets.find(QStringLiteral("Blue")) != nullptr);
    QVERIFY(presets.remove(QStringLiteral("Blue")));
    QCOMPARE(presets.all().size(), 1U);
    QVERIFY(!presets.save(QStringLiteral(" "), wideScale()));
}

void PresetsTest::badFilesAreNamedAndLeftAlone_data()
{
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("broken") << QByteArray(R"({"format": "crowdbrush brush", "version")");
    QTest::newRow("another kind of file") << QByteArray("[1, 2, 3]");
    QTest::newRow("newer") << QByteArray(
        R"({"format": "crowdbrush brush", "version": 2, "name": "a", "brush": {"brush": "tag"}})");
    QTest::newRow("unknown brush") << QByteArray(
        R"({"format": "crowdbrush brush", "version": 1, "name": "a", "brush": {"brush": "mop"}})");
    QTest::newRow("no name") << QByteArray(
        R"({"format": "crowdbrush brush", "version": 1, "brush": {"brush": "tag"}})");
    QTest::newRow("wrong value") << QByteArray(
        R"({"format": "crowdbrush brush", "version": 1, "name": "a",
            "brush": {"brush": "scale", "radius": "wide"}})");
    QTest::newRow("out of range") << QByteArray(
        R"({"format": "crowdbrush brush", "version": 1, "name": "a",
            "brush": {"brush": "scale", "radius": 1e9}})");
    QTest::newRow("no version") << QByteArray(
        R"({"format": "crowdbrush brush", "name": "a", "brush": {"brush": "tag"}})");
    QTest::newRow("huge") << QByteArray(3 << 20, ' ');
}

void PresetsTest::badFilesAreNamedAndLeftAlone()
{
    QFETCH(QByteArray, bytes);
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("bad.brush"));
    put(path, bytes);
    BrushPresets presets(folder.path());
    QVERIFY(presets.save(QStringLiteral("bad"), wideScale())); // does not take its file
    QCOMPARE(presets.all().size(), 1U);
    QCOMPARE(presets.problems().size(), 1);
    QVERIFY2(presets.problems()[0].contains(path), qPrintable(presets.problems()[0]));
    QCOMPARE(bytesOf(path), bytes);
    QVERIFY(!presets.importFile(path));
}

void PresetsTest::presetsAreShared()
{
    QTemporaryDir mine;
    QTemporaryDir yours;
    BrushPresets presets(mine.path());
    QVERIFY(presets.save(QStringLiteral("Giants #tall"), wideScale()));
    const QString file = yours.filePath(QStringLiteral("giants.brush"));
    QVERIFY(presets.exportFile(QStringLiteral("Giants #tall"), file));
    BrushPresets others(yours.filePath(QStringLiteral("brushes")));
    QCOMPARE(others.importFile(file).value(), QStringLiteral("Giants #tall"));
    QCOMPARE(others.importFile(file).value(), QStringLiteral("Giants #tall")); // not twice
    QCOMPARE(others.all().size(), 1U);
    QVERIFY(
        others.save(QStringLiteral("Giants #tall"), model::initialBrush(model::BrushKind::Scale)));
    QCOMPARE(others.importFile(file).value(), QStringLiteral("Giants #tall 2"));
    QVERIFY(!others.importFile(yours.filePath(QStringLiteral("gone.brush"))));
}

void PresetsTest::foldersThatCannotBeWrittenAreSaid()
{
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("file"));
    put(file, "no folder");
    BrushPresets presets(file + QStringLiteral("/brushes"));
    const auto saved = presets.save(QStringLiteral("a"), wideScale());
    QVERIFY(!saved);
    QVERIFY(saved.error().message.find(file.toStdString()) != std::string::npos);
    QVERIFY(presets.all().empty());
}

void PresetsTest::whatOthersWriteIsShown()
{
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("brushes"));
    BrushPresets shown(path);
    int changes = 0;
    connect(&shown, &BrushPresets::changed, this, [&changes] { ++changes; });
    model::PresetFolder script(path);
    QVERIFY(script.save(QStringLiteral("Giants"), wideScale()));
    QTRY_COMPARE(shown.all().size(), 1U);
    QVERIFY(script.save(QStringLiteral("Giants"), model::initialBrush(model::BrushKind::Scale)));
    QTRY_VERIFY(shown.all()[0].json == script.all()[0].json);
    QVERIFY(script.remove(QStringLiteral("Giants")));
    QTRY_VERIFY(shown.all().empty());
    changes = 0;
    QVERIFY(shown.save(QStringLiteral("mine"), wideScale()));
    QTest::qWait(100);
    QCOMPARE(changes, 1); // a name that is being typed stays open
}

void PresetsTest::thePanelKeepsFindsAndSets()
{
    QTest::failOnWarning(QRegularExpression(QStringLiteral("closeEditor")));
    Desk<PresetsDock> desk;
    QVERIFY(desk.isReady());
    for (const BrushPreset& old : std::vector(desk.dock->presets().all())) {
        QVERIFY(desk.dock->presets().remove(old.name));
    }
    const auto& list = *desk.dock->findChild<QListWidget*>();
    const auto press = [&desk](const char* name) {
        QTest::mouseClick(desk.dock->findChild<QToolButton*>(QLatin1String(name)), Qt::LeftButton);
    };
    desk.state.setBrush(wideScale());
    desk.state.setTool(toolOf(model::BrushKind::Scale));
    press("keepPreset");
    QTRY_COMPARE(list.count(), 1);
    auto* editor = list.findChild<QLineEdit*>();
    QVERIFY2(editor != nullptr, "the new name can be typed at once");
    testing::type(*editor, QStringLiteral("Giants #tall"));
    QTRY_COMPARE(desk.dock->presets().all()[0].name, QStringLiteral("Giants #tall"));
    QCOMPARE(list.item(0)->text(), QStringLiteral("Giants #tall"));
    auto* search = desk.dock->findChild<QLineEdit*>();
    QTest::keyClicks(search, QStringLiteral("#TALL gi"));
    QVERIFY(!list.item(0)->isHidden());
    QTest::keyClicks(search, QStringLiteral("x"));
    QVERIFY(list.item(0)->isHidden());
    search->clear();
    desk.state.setBrush(model::initialBrush(model::BrushKind::Scale));
    desk.state.setTool(ToolId::Select);
    press("keepPreset"); // nothing to keep
    QCOMPARE(list.count(), 1);
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {},
                      list.visualItemRect(list.item(0)).center());
    QCOMPARE(desk.state.tool(), toolOf(model::BrushKind::Scale));
    QVERIFY(desk.state.brush(model::BrushKind::Scale) == wideScale());
    press("removePreset");
    QTRY_COMPARE(list.count(), 0);
}

void PresetsTest::whatABadFileHoldsSizesNoWindow()
{
    Desk<PresetsDock> desk;
    QVERIFY(desk.isReady());
    const int before = desk.dock->minimumSizeHint().width();
    QVERIFY(desk.dock->presets().save(QStringLiteral("good"), wideScale()));
    const QString good = desk.dock->presets().find(QStringLiteral("good"))->file;
    const QString bad =
        QFileInfo(good).dir().filePath(QString(200, u'x') + QStringLiteral(".brush"));
    put(bad, R"({"format": "crowdbrush brush", "version": 1, "name": "a",
                 "brush": {"brush": "scale", ")" +
                 QByteArray(5000, 'm') + R"(": 1}})");
    desk.dock->presets().reload();
    QCOMPARE(desk.dock->presets().problems().size(), 1);
    QVERIFY(desk.dock->presets().problems()[0].size() < bad.size() + 1000);
    QVERIFY2(desk.dock->minimumSizeHint().width() <= before + 20,
             qPrintable(QString::number(desk.dock->minimumSizeHint().width())));
    QVERIFY(QFile::remove(bad));
    QVERIFY(desk.dock->presets().remove(QStringLiteral("good")));
}

CROWD_WINDOW_TEST(PresetsTest)
#include "tst_Presets.moc"
