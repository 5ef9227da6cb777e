// SPDX-License-Identifier: MIT
#include "widgets/state/Invalidation.h"

#include <QtTest/QTest>

#include "tests/program/WindowTest.h"

using namespace crowd;

/// Which edits make another of what has been played after them.
class TestInvalidation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void editsOfMotion_data();
    void editsOfMotion();
    void editsOfKinds();
};

namespace {

enum Matters { Never, WithRules, Always };

model::Scene sceneWithRule()
{
    model::Scene scene;
    scene.rules.emplace_back();
    return scene;
}

bool isChanged(const model::SceneChange& change, const model::Scene& scene = {})
{
    return widgets::changesMotion(change, scene);
}

} // namespace

void TestInvalidation::editsOfMotion_data()
{
    QTest::addColumn<int>("column");
    QTest::addColumn<int>("matters");
    const auto row = [](const char* name, model::ColumnId column, Matters matters) {
        QTest::newRow(name) << static_cast<int>(column) << static_cast<int>(matters);
    };
    row("colours", model::columns::tint(0).id, Never);
    row("place", model::columns::position.id, Always);
    row("path", model::columns::path.id, Always);
    row("clip", model::columns::clip.id, Always);
    row("girth", model::columns::girth.id, Never);
    row("group", model::columns::group.id, Always);
    row("tags", model::columns::tags.id, WithRules);
    row("feature", model::columns::feature(1).id, WithRules);
}

void TestInvalidation::editsOfMotion()
{
    QFETCH(const int, column);
    QFETCH(const int, matters);
    const model::ColumnsChanged change{{1}, {static_cast<model::ColumnId>(column)}};
    QCOMPARE(isChanged(change), matters == Always);
    QCOMPARE(isChanged(change, sceneWithRule()), matters != Never);
}

void TestInvalidation::editsOfKinds()
{
    QVERIFY(isChanged(model::GroupsChanged()) && isChanged(model::RelationKindsChanged()));
    QVERIFY(!isChanged(model::LightingChanged()) && !isChanged(model::CamerasChanged()));
    QVERIFY(!isChanged(model::StatesChanged()) && !isChanged(model::FeaturesChanged()));
    QVERIFY(isChanged(model::StatesChanged(), sceneWithRule()));
    QVERIFY(isChanged(model::FeaturesChanged(), sceneWithRule()));
    model::Scene scene;
    scene.timeline.emplace_back(); // which may recall one
    QVERIFY(isChanged(model::StatesChanged(), scene));
}

CROWD_WINDOW_TEST(TestInvalidation)
#include "tst_Invalidation.moc"
