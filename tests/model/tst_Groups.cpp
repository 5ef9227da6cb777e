// SPDX-License-Identifier: MIT
#include <functional>

#include "model/document/GroupEdits.h"
#include "model/project/ProjectReader.h"
#include "tests/model/BrushScene.h"
#include "tests/model/ProjectText.h"
#include "tests/program/Test.h"

using namespace crowd::test;

namespace {

GroupId madeGroup(BrushScene& scene, const std::string& name, const Ids& members)
{
    const auto edit = scene.document.beginEdit().value();
    Group group;
    group.name = name;
    const GroupId id = addGroup(*edit, group);
    putInGroup(*edit, members, id);
    edit->commit(QStringLiteral("Group"));
    return id;
}

void setGroup(BrushScene& scene, GroupId id, const std::function<void(Group&)>& apply)
{
    const auto edit = scene.document.beginEdit().value();
    Group group = *scene.document.scene().findGroup(id);
    apply(group);
    changeGroup(*edit, group);
    edit->commit(QStringLiteral("Group"));
}

QString problemOfGroups(const QString& groups)
{
    const std::string text =
        R"({"format": "crowdbrush-scene", "version": 1, "groups": )" + groups.toStdString() +
        R"(, "individuals": {"columns": ["id","template","position"], "rows": []}})";
    const auto read = projectFromText(text);
    return read ? QString() : QString::fromStdString(read.error().message);
}

/// Everything on screen.
StrokeOutcome paintAll(BrushScene& scene, BrushSettings settings)
{
    settings.selection = BrushSelection::Rectangle;
    settings.through = true;
    return scene.paint(fromAbove(), settings, {{0, 0}, {1279, 767}});
}

bool isColoured(const BrushScene& scene, IndividualId id)
{
    return !(tintOf(scene, id, 1) == Tint{});
}

} // namespace

class tst_Groups : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void idsAreAboveAllThatPeopleHave();
    void deletingLeavesThePeople();
    void onlyOneIsShownAlone();
    void lockedAndHiddenAreTouchedByNoBrush_data();
    void lockedAndHiddenAreTouchedByNoBrush();
    void hiddenAreNotInTheWay();
    void creationComesIntoTheActiveGroup();
    void theGroupBrushTakesIn();
    void masksMeanWhoFulfilsThemAll();
    void masksAreSaidWhenTheyLeaveAllOut();
    void filesKeepThem();
    void wrongFilesAreRefused_data();
    void wrongFilesAreRefused();
};

void tst_Groups::idsAreAboveAllThatPeopleHave()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    const GroupId first = madeGroup(scene, "left", {ids[0], ids[1]});
    QCOMPARE(first, 1U);
    {
        const auto edit = scene.document.beginEdit().value();
        putInGroup(*edit, Ids{ids[2]}, 40);
        edit->commit(QStringLiteral("Old number"));
    }
    QCOMPARE(madeGroup(scene, "right", {}), 41U);
    QCOMPARE(peopleWith(scene.people(), columns::group, first), (Ids{ids[0], ids[1]}));
    scene.document.undoStack().setIndex(1);
    QVERIFY(scene.document.scene().groups.empty());
    QVERIFY(peopleWith(scene.people(), columns::group, first).empty());
    QCOMPARE(freeGroupName(scene.document.scene(), "left"), std::string("left"));
    scene.document.undoStack().setIndex(2);
    QCOMPARE(freeGroupName(scene.document.scene(), "left"), std::string("left 2"));
}

void tst_Groups::deletingLeavesThePeople()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    const GroupId group = madeGroup(scene, "left", {ids[0], ids[1]});
    const Population before = scene.people();
    const auto edit = scene.document.beginEdit().value();
    removeGroup(*edit, group);
    QVERIFY(edit->commit(QStringLiteral("Delete")));
    QCOMPARE(scene.people().size(), before.size());
    QVERIFY(peopleWith(scene.people(), columns::group, group).empty());
    scene.document.undoStack().undo();
    QVERIFY(scene.people() == before);
    QCOMPARE(scene.document.scene().groups.front().name, std::string("left"));
}

void tst_Groups::onlyOneIsShownAlone()
{
    BrushScene scene;
    const GroupId left = madeGroup(scene, "left", {});
    const GroupId right = madeGroup(scene, "right", {});
    const auto solo = [&scene](GroupId id) {
        const auto edit = scene.document.beginEdit().value();
        soloGroup(*edit, id);
        edit->commit(QStringLiteral("Solo"));
        return groupsThat(scene.document.scene().groups, &Group::isHidden);
    };
    QCOMPARE(solo(left), std::vector<GroupId>{right});
    QCOMPARE(solo(right), std::vector<GroupId>{left});
    QCOMPARE(solo(right), std::vector<GroupId>{});
}

void tst_Groups::lockedAndHiddenAreTouchedByNoBrush_data()
{
    QTest::addColumn<int>("kind");
    for (const BrushKind kind : shownBrushes()) {
        if (brushType(kind).info.family == StrokeFamily::People && kind != BrushKind::Script) {
            QTest::newRow(brushType(kind).info.id) << static_cast<int>(kind);
        }
    }
}

void tst_Groups::lockedAndHiddenAreTouchedByNoBrush()
{
    QFETCH(int, kind);
    for (bool Group::*member : {&Group::isLocked, &Group::isHidden}) {
        BrushScene scene;
        const Ids ids = scene.addPeople(crowdGrid());
        const GroupId group = madeGroup(scene, "kept", {ids[3], ids[20], ids[41]});
        setGroup(scene, group, [member](Group& each) { each.*member = true; });
        const Population before = scene.people();
        BrushSettings settings = initialBrush(static_cast<BrushKind>(kind));
        settings.through = true;
        for (const auto selection : {BrushSelection::Point, BrushSelection::Spray,
                                     BrushSelection::AllInCircle, BrushSelection::Rectangle}) {
            settings.selection = selection;
            settings.radiusPixels = 300.0F;
            (void)scene.paint(fromAbove(), settings, {{300, 200}, {900, 500}, {980, 560}});
        }
        for (const IndividualId id : {ids[3], ids[20], ids[41]}) {
            const std::size_t was = before.rowOf(id);
            const std::size_t now = scene.people().rowOf(id);
            QVERIFY(now != Population::npos);
            for (std::size_t c = 0; c < kColumnCount; ++c) {
                const auto column = static_cast<ColumnId>(c);
                QCOMPARE(scene.people().values(column, std::array{id}),
                         before.values(column, std::array{id}));
            }
            QVERIFY(was != Population::npos);
        }
    }
}

void tst_Groups::hiddenAreNotInTheWay()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {0, 0, 2}});
    const View front = fromFront();
    const BrushSettings settings = colourBrush(BrushSelection::Point);
    const glm::dvec2 pixel = pixelOf(front, {0, 1, 2});
    const GroupId group = madeGroup(scene, "in front", {ids[1]});
    setGroup(scene, group, [](Group& each) { each.isLocked = true; });
    QCOMPARE(scene.paint(front, settings, {pixel}).reason, StrokeReason::GroupLocked);
    setGroup(scene, group, [](Group& each) { each.isHidden = true; });
    QCOMPARE(scene.paint(front, settings, {pixel}).affected, 1);
    QVERIFY(isColoured(scene, ids[0]) && !isColoured(scene, ids[1]));
}

void tst_Groups::creationComesIntoTheActiveGroup()
{
    BrushScene scene;
    const GroupId group = madeGroup(scene, "new ones", {});
    BrushSettings create = brush(BrushKind::Create, BrushSelection::Point);
    create.as<CreateSettings>().group = group;
    QCOMPARE(scene.paint(fromAbove(), create, {{640, 384}}).affected, 1);
    QCOMPARE(scene.people().column(columns::group)[0], group);
    setGroup(scene, group, [](Group& each) { each.isLocked = true; });
    const StrokeOutcome refused = scene.paint(fromAbove(), create, {{900, 384}});
    QCOMPARE(refused.reason, StrokeReason::GroupLocked);
    QVERIFY(refused.message.contains(QStringLiteral("locked")));
    QCOMPARE(scene.people().size(), std::size_t{1});
}

void tst_Groups::theGroupBrushTakesIn()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{-2, 0, 0}, {2, 0, 0}});
    const GroupId group = madeGroup(scene, "left", {});
    BrushSettings settings(GroupSettings{group});
    settings.selection = BrushSelection::Point;
    const View view = fromAbove();
    QCOMPARE(scene.paint(view, settings, {pixelOf(view, {-2, 0, 0})}).affected, 1);
    QCOMPARE(peopleWith(scene.people(), columns::group, group), Ids{ids[0]});
    QCOMPARE(scene.paint(view, settings, {pixelOf(view, {-2, 0, 0})}).reason,
             StrokeReason::Unchanged);
    scene.document.undoStack().undo();
    QVERIFY(peopleWith(scene.people(), columns::group, group).empty());
}

void tst_Groups::masksMeanWhoFulfilsThemAll()
{
    const auto painted = [](const std::function<void(MaskSettings&, const Ids&)>& mask) {
        BrushScene scene;
        const Ids ids = scene.addPeople({{-3, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {3, 0, 0}});
        madeGroup(scene, "pair", {ids[1], ids[2]});
        const auto edit = scene.document.beginEdit().value();
        const std::uint64_t worn = 1U << 5U;
        edit->setColumn(columns::tags, Ids{ids[2], ids[3]},
                        std::span<const std::uint64_t>(&worn, 1));
        edit->commit(QStringLiteral("Tag"));
        BrushSettings settings = colourBrush(BrushSelection::Rectangle);
        mask(settings.mask, ids);
        (void)paintAll(scene, settings);
        QString who;
        for (const IndividualId id : ids) {
            who += isColoured(scene, id) ? QLatin1Char('x') : QLatin1Char('.');
        }
        return who;
    };
    using M = MaskSettings;
    QCOMPARE(painted([](M&, const Ids&) {}), QStringLiteral("xxxx"));
    QCOMPARE(painted([](M& m, const Ids&) { m.groups = {1}; }), QStringLiteral(".xx."));
    QCOMPARE(painted([](M& m, const Ids&) { m.groups = {0}; }), QStringLiteral("x..x"));
    QCOMPARE(painted([](M& m, const Ids&) { m.tags = {5}; }), QStringLiteral("..xx"));
    QCOMPARE(painted([](M& m, const Ids&) {
                 m.tags = {5};
                 m.groups = {1};
             }),
             QStringLiteral("..x."));
    QCOMPARE(painted([](M& m, const Ids&) {
                 m.tags = {5};
                 m.groups = {1};
                 m.isInverted = true;
             }),
             QStringLiteral("xx.x"));
    QCOMPARE(painted([](M& m, const Ids& ids) {
                 m.onlySelected = true;
                 m.selected = {static_cast<int>(ids[3]), static_cast<int>(ids[0])};
             }),
             QStringLiteral("x..x"));
    QCOMPARE(painted([](M& m, const Ids&) { m.onlySelected = true; }), QStringLiteral("...."));
    QCOMPARE(painted([](M& m, const Ids&) { m.templates = {2, 1}; }), QStringLiteral("xxxx"));
    QCOMPARE(painted([](M& m, const Ids&) { m.templates = {2}; }), QStringLiteral("...."));
}

void tst_Groups::masksAreSaidWhenTheyLeaveAllOut()
{
    BrushScene scene;
    scene.addPeople(crowdGrid());
    BrushSettings settings = colourBrush(BrushSelection::Rectangle);
    settings.mask.tags = {3};
    const StrokeOutcome outcome = paintAll(scene, settings);
    QCOMPARE(outcome.reason, StrokeReason::Masked);
    QVERIFY(outcome.message.contains(QStringLiteral("mask")));
}

void tst_Groups::filesKeepThem()
{
    BrushScene scene;
    scene.document.replaceScene({}, {}); // a template without a file is not written
    const GroupId group = madeGroup(scene, "left stand", {});
    setGroup(scene, group, [](Group& each) {
        each.isLocked = true;
        each.isParty = true;
        each.color = {1, 2, 3};
        each.unknownMembers = R"({"later":5})";
    });
    const std::string text = crowd::testing::projectText(scene.document.scene());
    const auto read = projectFromText(text);
    QVERIFY2(read, read ? "" : read.error().message.c_str());
    QVERIFY(read.value().groups == scene.document.scene().groups);
    QCOMPARE(crowd::testing::projectText(read.value()), text);
}

void tst_Groups::wrongFilesAreRefused_data()
{
    QTest::addColumn<QString>("groups");
    QTest::addColumn<QString>("named");
    QTest::newRow("no list") << QStringLiteral("5") << QStringLiteral("groups");
    QTest::newRow("no id") << QStringLiteral("[{\"name\":\"a\"}]") << QStringLiteral("groups");
    QTest::newRow("the same id twice")
        << QStringLiteral("[{\"id\":3},{\"id\":3}]") << QStringLiteral("groups");
    QTest::newRow("a number for a name")
        << QStringLiteral("[{\"id\":3,\"name\":4}]") << QStringLiteral("groups[0].name");
    QTest::newRow("hidden is no flag")
        << QStringLiteral("[{\"id\":3,\"hidden\":\"yes\"}]") << QStringLiteral("groups[0].hidden");
}

void tst_Groups::wrongFilesAreRefused()
{
    QFETCH(QString, groups);
    QFETCH(QString, named);
    const QString said = problemOfGroups(groups);
    QVERIFY2(said.contains(named), qPrintable(said));
}

CROWD_TEST(tst_Groups)
#include "tst_Groups.moc"
