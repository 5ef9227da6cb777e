// SPDX-License-Identifier: MIT
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QListWidget>

#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/StatesDock.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

struct StatesDesk : crowd::testing::Desk<StatesDock>
{
    StatesDesk()
    {
        QObject::connect(&state, &EditorState::statusMessage,
                         [this](const QString& text) { said = text; });
    }
    [[nodiscard]] QListWidget* list()
    {
        return dock->findChild<QListWidget*>(QStringLiteral("states"));
    }
    void press(const char* button)
    {
        auto* found = dock->findChild<QAbstractButton*>(QLatin1String(button));
        QVERIFY2(found != nullptr && found->isEnabled(), button);
        QTest::mouseClick(found, Qt::LeftButton);
    }
    /// With + and the name typed where it is offered.
    void keepAs(const char* name)
    {
        press("keepState");
        QTRY_VERIFY(list()->findChild<QLineEdit*>() != nullptr);
        auto* field = list()->findChild<QLineEdit*>();
        QSignalSpy closed(field, &QObject::destroyed);
        QVERIFY2(!closed.wait(100), "the list was filled under the hands of who types");
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(name));
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(document.scene().states.back().name, std::string(name));
        QTRY_VERIFY(list()->findChild<QLineEdit*>() == nullptr);
    }
    void setPhase(float phase)
    {
        const auto all = document.scene().population.ids();
        const std::vector<model::IndividualId> ids(all.begin(), all.end());
        document.edit(QStringLiteral("Phase"), [&](model::SceneEdit& edit) {
            edit.setColumn(model::columns::phase, ids, std::span<const float>(&phase, 1));
        });
    }
    [[nodiscard]] float phase(std::size_t row)
    {
        return document.scene().population.column(model::columns::phase)[row];
    }
    [[nodiscard]] QStringList names()
    {
        QStringList all;
        for (int row = 0; row < list()->count(); ++row) {
            all << list()->item(row)->text();
        }
        return all;
    }
    void doubleClick(int row)
    {
        const QPoint at = list()->visualItemRect(list()->item(row)).center();
        QTest::mouseClick(list()->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(list()->viewport(), Qt::LeftButton, {}, at);
    }

    QString said;
};

} // namespace

class TestStatesDock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void keptAndRecalled();
    void ofThoseWhoAreSelected();
    void whatIsTickedIsHeld();
    void keptAnewRemovedAndUndone();
    void namesThatAreTakenAreRefused();
    void nobodyHasNoState();
};

void TestStatesDock::init()
{
    QSettings().clear();
}

void TestStatesDock::keptAndRecalled()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 4);
    desk.setPhase(0.25F);
    desk.keepAs("calm");
    QVERIFY2(desk.said.contains(QStringLiteral("keeps how 4 characters are")),
             qPrintable(desk.said));
    desk.setPhase(0.75F);
    desk.keepAs("wild");
    QCOMPARE(desk.names(), (QStringList{QStringLiteral("calm"), QStringLiteral("wild")}));
    const int steps = desk.document.undoStack().index();
    desk.doubleClick(0);
    QCOMPARE(desk.phase(2), 0.25F);
    QCOMPARE(desk.document.undoStack().index(), steps + 1);
    QVERIFY2(desk.said.contains(QStringLiteral("“calm” recalled: 4 characters changed")),
             qPrintable(desk.said));
    desk.press("recallState");
    QVERIFY2(desk.said.contains(QStringLiteral("like that already")), qPrintable(desk.said));
    QCOMPARE(desk.document.undoStack().index(), steps + 1);
    desk.document.undoStack().undo();
    QCOMPARE(desk.phase(2), 0.75F);
}

void TestStatesDock::ofThoseWhoAreSelected()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = crowd::testing::addPeople(desk.document, 4);
    desk.dock->findChild<QComboBox*>(QStringLiteral("stateReach"))->setCurrentIndex(1);
    desk.press("keepState");
    QVERIFY2(desk.said.contains(QStringLiteral("Nobody is selected")), qPrintable(desk.said));
    QVERIFY(desk.document.scene().states.empty());
    desk.state.selection().set(std::span(ids).first(2));
    desk.keepAs("two");
    QCOMPARE(desk.document.scene().states.front().people->ids.size(), std::size_t{2});
}

void TestStatesDock::whatIsTickedIsHeld()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 2);
    const auto tick = [&desk](const char* aspect) {
        return desk.dock->findChild<QCheckBox*>(QLatin1String(aspect));
    };
    QVERIFY(tick("animation")->isChecked() && tick("colours")->isChecked());
    QVERIFY(!tick("place")->isChecked() && !tick("template")->isChecked());
    for (const char* aspect : {"colours", "materials", "size", "walking", "tags", "animation"}) {
        tick(aspect)->setChecked(false);
    }
    desk.press("keepState");
    QVERIFY2(desk.said.contains(QStringLiteral("Tick what")), qPrintable(desk.said));
    tick("place")->setChecked(true);
    desk.keepAs("where");
    const model::ColumnSet held = desk.document.scene().states.front().columns;
    QVERIFY(held.contains(model::ColumnId::Seat) && held.contains(model::ColumnId::Heading));
    QVERIFY(!held.contains(model::ColumnId::Clip));
    StatesDesk later; // ticks are remembered
    auto* place = later.dock->findChild<QCheckBox*>(QStringLiteral("place"));
    QVERIFY(place != nullptr && place->isChecked());
}

void TestStatesDock::keptAnewRemovedAndUndone()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 3);
    desk.setPhase(0.25F);
    desk.keepAs("calm");
    desk.setPhase(0.75F);
    desk.press("keepStateAnew");
    desk.setPhase(0.5F);
    desk.press("recallState");
    QCOMPARE(desk.phase(0), 0.75F);
    desk.press("removeState");
    QTRY_COMPARE(desk.names(), QStringList());
    QVERIFY(desk.dock->findChild<QLabel*>(QStringLiteral("statesNote"))->isVisible());
    desk.document.undoStack().undo();
    QTRY_COMPARE(desk.names(), QStringList{QStringLiteral("calm")});
}

void TestStatesDock::namesThatAreTakenAreRefused()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 3);
    desk.keepAs("calm");
    desk.keepAs("wild");
    desk.list()->item(1)->setText(QStringLiteral("calm"));
    QVERIFY2(desk.said.contains(QStringLiteral("already")), qPrintable(desk.said));
    QTRY_COMPARE(desk.names(), (QStringList{QStringLiteral("calm"), QStringLiteral("wild")}));
    desk.list()->item(1)->setText(QStringLiteral("  "));
    QTRY_COMPARE(desk.names(), (QStringList{QStringLiteral("calm"), QStringLiteral("wild")}));
    const auto open = desk.document.beginEdit().value(); // a script's, say
    desk.list()->item(1)->setText(QStringLiteral("louder"));
    QTRY_COMPARE(desk.names(), (QStringList{QStringLiteral("calm"), QStringLiteral("wild")}));
}

void TestStatesDock::nobodyHasNoState()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    desk.press("keepState");
    QVERIFY2(desk.said.contains(QStringLiteral("Nobody is there yet")), qPrintable(desk.said));
    QVERIFY(desk.document.scene().states.empty());
}

CROWD_WINDOW_TEST(TestStatesDock)
#include "tst_StatesDock.moc"
