// SPDX-License-Identifier: MIT
#include "model/population/Neighbours.h"
#include "tests/model/BrushScene.h"
#include "tests/program/Test.h"

using namespace crowd::test;

class tst_Neighbours : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void alikeIsWhoLooksTheSame();
    void growingTakesTheNextOnes();
    void shrinkingLeavesTheInside();
    void levelsAreApart();
};

void tst_Neighbours::alikeIsWhoLooksTheSame()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    const auto edit = scene.document.beginEdit().value();
    const Tint red{255, 0, 0, 255};
    edit->setColumn(columns::tint(1), Ids{ids[1], ids[3]}, std::span<const Tint>(&red, 1));
    const float tall = 1.2F;
    edit->setColumn(columns::height, Ids{ids[3]}, std::span<const float>(&tall, 1));
    edit->commit(QStringLiteral("Paint"));
    QCOMPARE(lookAlikes(scene.people(), Ids{ids[1]}), (Ids{ids[1], ids[3]}));
    QCOMPARE(lookAlikes(scene.people(), Ids{ids[0]}), (Ids{ids[0], ids[2]}));
    QCOMPARE(lookAlikes(scene.people(), Ids{ids[0], ids[1]}), ids);
    QVERIFY(lookAlikes(scene.people(), Ids{}).empty());
}

void tst_Neighbours::growingTakesTheNextOnes()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid()); // 10 × 6, a metre apart
    QCOMPARE(withNeighbours(scene.people(), Ids{ids[0]}, 1.1F), (Ids{ids[0], ids[1], ids[10]}));
    QCOMPARE(withNeighbours(scene.people(), Ids{ids[22]}, 1.5F).size(), std::size_t{9});
    QVERIFY(withNeighbours(scene.people(), Ids{}, 1.5F).empty());
}

void tst_Neighbours::shrinkingLeavesTheInside()
{
    BrushScene scene;
    const Ids ids = scene.addPeople(crowdGrid());
    const Ids nine = withNeighbours(scene.people(), Ids{ids[22]}, 1.5F);
    QCOMPARE(withoutRim(scene.people(), nine, 1.5F), Ids{ids[22]});
    QCOMPARE(withoutRim(scene.people(), ids, 1.5F), ids);
}

void tst_Neighbours::levelsAreApart()
{
    BrushScene scene;
    const Ids ids = scene.addPeople({{0, 0, 0}, {0, 4, 0}, {-0.6F, 0, -0.6F}});
    QCOMPARE(withNeighbours(scene.people(), Ids{ids[0]}, 1.5F), (Ids{ids[0], ids[2]}));
}

CROWD_TEST(tst_Neighbours)
#include "tst_Neighbours.moc"
