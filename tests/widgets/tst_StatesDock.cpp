// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <set>

#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QToolButton>

#include "model/document/SceneEdit.h"
#include "model/states/StateKeeping.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/commands/StateCommands.h"
#include "widgets/docks/StatePictures.h"
#include "widgets/docks/StatesDock.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/PointPicking.h"

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
    void setHeight(float height)
    {
        const auto all = document.scene().population.ids();
        const std::vector<model::IndividualId> ids(all.begin(), all.end());
        document.edit(QStringLiteral("Height"), [&](model::SceneEdit& edit) {
            edit.setColumn(model::columns::height, ids, std::span<const float>(&height, 1));
        });
    }
    [[nodiscard]] float shownHeight(std::size_t row)
    {
        return state.frame()->population.column(model::columns::height)[row];
    }
    /// Four people who were small when a state was kept, and are tall.
    void keepSmallThenGrow()
    {
        (void)crowd::testing::addPeople(document, 4);
        setHeight(1.0F);
        keepAs("small");
        setHeight(2.0F);
    }
    [[nodiscard]] std::vector<model::IndividualId> everybody() const
    {
        const auto all = document.scene().population.ids();
        return {all.begin(), all.end()};
    }
    void setClip(std::uint16_t clip)
    {
        document.edit(QStringLiteral("Clip"), [&](model::SceneEdit& edit) {
            edit.setColumn(model::columns::clip, everybody(),
                           std::span<const std::uint16_t>(&clip, 1));
        });
    }
    [[nodiscard]] std::uint16_t shownClip(std::size_t row)
    {
        return state.frame()->population.column(model::columns::clip)[row];
    }
    /// A rule: whoever hears "sit" plays the third clip of the template.
    void letThemSitAtTheWord()
    {
        model::actions::PlayClip sit;
        sit.clips = {{document.scene().templates.front().asset->clips[2].name, 1.0F}};
        sit.isLooped = true;
        sit.seconds = 0.0F; // until something else comes
        model::Rule rule;
        rule.id = 1;
        rule.name = "sit";
        rule.trigger = model::triggers::Event{"sit"};
        rule.actions = {sit};
        document.edit(QStringLiteral("Rules"),
                      [&](model::SceneEdit& edit) { edit.setRules({rule}); });
    }
    /// So much real time passes.
    void play(double seconds)
    {
        state.advance(seconds);
        QTest::qWait(1);
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
    void orderedAndRemovedInTheList();
    void keptAnewRemovedAndUndone();
    void theNameOfANewOneIsSeen();
    void namesThatAreTakenAreRefused();
    void nobodyHasNoState();
    void ofAGroup();
    void whatIsHeldCanBeChanged();
    void whatDiffersIsCountedAndOutlined();
    void theListFollowsTheKeys();
    void whatDiffersIsOfTheRun();
    void theRestoreBrushTakesWhatIsChosen();
    void eachHasAPicture();
    void takesItsTimeWhileItPlays();
    void whatIsPaintedNextIsSeenAtOnce();
    void whileNothingPlaysItIsAtOnce();
    void whilePausedItEndsWhatRulesPlay_data();
    void whilePausedItEndsWhatRulesPlay();
    void onlyForWhoIsSelected();
    void onlyInThisRun();
    void howItComesIsRemembered();
    void theWaveBeginsWhereOneClicks();
    void theButtonIsPressedWhileAPointIsChosen();
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
    auto* difference = desk.dock->findChild<QLabel*>(QStringLiteral("stateDifference"));
    QTRY_VERIFY2(difference->text().contains(QStringLiteral("2 out of 4")),
                 qPrintable(difference->text()));
    desk.document.replaceScene(crowd::testing::smallTheatre(), {});
    QCOMPARE(desk.dock->findChild<QComboBox*>(QStringLiteral("stateReach"))->currentIndex(), 0);
}

void TestStatesDock::orderedAndRemovedInTheList()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 2);
    for (const char* name : {"a", "b", "c", "d", "e", "f", "g"}) {
        desk.keepAs(name);
    }
    const auto order = [&desk] { return desk.names().join(QString()); };
    // As a drag does it.
    QVERIFY(desk.list()->model()->moveRow({}, 5, {}, 1));
    QTRY_COMPARE(desk.document.scene().states[1].name, std::string("f"));
    QVERIFY(desk.list()->model()->moveRow({}, 0, {}, 3));
    QTRY_COMPARE(desk.document.scene().states[2].name, std::string("a"));
    QTRY_COMPARE(order(), QStringLiteral("fbacdeg"));
    // What is kept anew stays where it is in the list.
    desk.list()->setCurrentRow(6);
    QScrollBar* bar = desk.list()->verticalScrollBar();
    QTRY_VERIFY(bar->maximum() > 0);
    bar->setValue(bar->maximum());
    const int scrolled = bar->value();
    desk.setHeight(2.0F);
    desk.press("keepStateAnew");
    QTRY_VERIFY(desk.document.undoStack().undoText().contains(QStringLiteral("anew")));
    crowd::testing::addPeople(desk.document, 1);
    QTRY_COMPARE(bar->value(), scrolled);
    desk.list()->setFocus();
    QTest::keyClick(desk.list(), Qt::Key_Delete);
    QTRY_COMPARE(order(), QStringLiteral("fbacde"));
    desk.document.undoStack().undo();
    QTRY_COMPARE(order(), QStringLiteral("fbacdeg"));
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
    for (const char* aspect :
         {"colours", "materials", "size", "walking", "features", "tags", "animation"}) {
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

/// However many there are, in a panel of little height.
void TestStatesDock::theNameOfANewOneIsSeen()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 3);
    for (const char* name : {"one", "two", "three", "four", "five", "six"}) {
        const model::ColumnSet columns = model::usualStateColumns();
        QVERIFY(keepStateAs(desk.state, QLatin1String(name), columns, StateReach::Everybody, 0));
    }
    desk.window.resize(desk.window.width(), 260);
    QTRY_COMPARE(desk.list()->count(), 6);
    desk.press("keepState");
    QLineEdit* field = nullptr;
    QTRY_VERIFY((field = desk.list()->findChild<QLineEdit*>()) != nullptr);
    QTRY_COMPARE(field->visibleRegion().boundingRect(), field->rect());
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

void TestStatesDock::ofAGroup()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = crowd::testing::addPeople(desk.document, 4);
    const std::vector<model::IndividualId> two{ids[1], ids[3]};
    const std::uint32_t group = 5;
    desk.document.edit(QStringLiteral("Group"), [&](model::SceneEdit& edit) {
        edit.setGroups({{group, "choir"}});
        edit.setColumn(model::columns::group, two, std::span<const std::uint32_t>(&group, 1));
    });
    auto* reach = desk.dock->findChild<QComboBox*>(QStringLiteral("stateReach"));
    QCOMPARE(reach->count(), 3);
    QVERIFY(reach->itemText(2).contains(QStringLiteral("choir")));
    reach->setCurrentIndex(2);
    desk.keepAs("choir calm");
    QCOMPARE(desk.document.scene().states[0].people->ids, two);
    desk.document.undoStack().undo();
    desk.document.undoStack().undo(); // the name, the state
    desk.document.undoStack().undo(); // the group
    QCOMPARE(reach->count(), 2);
    QCOMPARE(reach->currentIndex(), 0);
}

void TestStatesDock::whatIsHeldCanBeChanged()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 4);
    desk.setHeight(1.25F);
    desk.setPhase(0.25F);
    desk.keepAs("calm");
    const model::StateId id = desk.document.scene().states[0].id;
    const auto state = [&desk]() -> const model::State& { return desk.document.scene().states[0]; };
    setHeld(desk.state, id, model::PropertyAspect::Size, false);
    QVERIFY(!state().columns.contains(model::ColumnId::Height));
    QVERIFY(state().columns.contains(model::ColumnId::Phase));
    desk.setHeight(2.0F);
    desk.setPhase(0.75F);
    desk.press("recallState");
    QCOMPARE(desk.shownHeight(0), 2.0F);
    QCOMPARE(desk.phase(0), 0.25F);
    desk.setPhase(0.5F);
    setHeld(desk.state, id, model::PropertyAspect::Size, true); // as they are now
    desk.setHeight(3.0F);
    desk.press("recallState");
    QCOMPARE(desk.shownHeight(0), 2.0F);
    QCOMPARE(desk.phase(0), 0.25F); // what it held is as it was
    for (const model::PropertyAspectInfo& aspect : model::propertyAspects()) {
        setHeld(desk.state, id, aspect.aspect, false);
    }
    QVERIFY(!state().columns.isEmpty());
    QVERIFY2(desk.said.contains(QStringLiteral("at least one")), qPrintable(desk.said));
}

void TestStatesDock::whatDiffersIsCountedAndOutlined()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    const auto ids = crowd::testing::addPeople(desk.document, 4);
    desk.setHeight(1.0F);
    desk.keepAs("calm");
    auto* text = desk.dock->findChild<QLabel*>(QStringLiteral("stateDifference"));
    QTRY_COMPARE(text->text(), QStringLiteral("They are like that now."));
    const std::vector<model::IndividualId> two{ids[0], ids[2]};
    const float tall = 1.5F;
    const float late = 0.5F;
    desk.document.edit(QStringLiteral("Two"), [&](model::SceneEdit& edit) {
        edit.setColumn(model::columns::height, two, std::span<const float>(&tall, 1));
        edit.setColumn(model::columns::phase, std::span(two).first(1),
                       std::span<const float>(&late, 1));
    });
    QTRY_VERIFY(text->text().startsWith(QStringLiteral("Different:")));
    QVERIFY2(text->text().contains(QStringLiteral("Animation 1")), qPrintable(text->text()));
    QVERIFY2(text->text().contains(QStringLiteral("Size 2")), qPrintable(text->text()));
    QVERIFY(desk.state.washed().empty());
    desk.press("washDifferent");
    QCOMPARE(desk.state.washed(), two);
    desk.press("recallState");
    QTRY_VERIFY(desk.state.washed().empty());
    desk.document.undoStack().undo();
    QTRY_COMPARE(desk.state.washed(), two);
    desk.dock->hide(); // nobody would know where it comes from
    QTRY_VERIFY(desk.state.washed().empty());
}

/// Whatever recalls or keeps a state: what is said of it is of that one.
void TestStatesDock::theListFollowsTheKeys()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 4);
    desk.keepAs("calm");
    desk.setPhase(0.75F);
    desk.keepAs("wild");
    const auto& states = desk.document.scene().states;
    QCOMPARE(desk.list()->currentRow(), 1);
    recallStateOf(desk.state, states[0].id, RecallInto::Scene);
    QCOMPARE(desk.list()->currentRow(), 0);
    keepStateAnew(desk.state, states[1].id);
    QCOMPARE(desk.list()->currentRow(), 1);
    QVERIFY(
        keepStateAs(desk.state, QStringLiteral("sad"), states[0].columns, StateReach::Everybody));
    QTRY_COMPARE(desk.list()->currentRow(), 2);
    desk.press("removeState");
    QTRY_COMPARE(desk.list()->count(), 2);
    QCOMPARE(desk.state.chosenState(), states[0].id);
    desk.list()->setCurrentRow(1);
    QCOMPARE(desk.state.chosenState(), states[1].id);
}

void TestStatesDock::whatDiffersIsOfTheRun()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    desk.keepSmallThenGrow();
    auto* text = desk.dock->findChild<QLabel*>(QStringLiteral("stateDifference"));
    QTRY_VERIFY2(text->text().contains(QStringLiteral("Size 4")), qPrintable(text->text()));
    desk.state.transport().setPlaying(true);
    QTRY_VERIFY((recallStateOf(desk.state, desk.document.scene().states[0].id, RecallInto::Run),
                 desk.state.session().isRunning()));
    QTRY_COMPARE((desk.play(0.02), text->text()), QStringLiteral("They are like that now."));
    QCOMPARE(desk.document.scene().population.column(model::columns::height)[0], 2.0F);
}

void TestStatesDock::theRestoreBrushTakesWhatIsChosen()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 4);
    desk.keepAs("calm");
    desk.keepAs("wild");
    desk.list()->setCurrentRow(0);
    const auto settings = [&desk] {
        return desk.state.brush(model::BrushKind::Restore).as<model::RestoreSettings>();
    };
    desk.state.setTool(ToolId::BrushRestore);
    QCOMPARE(settings().source, model::RestoreSource::State);
    QCOMPARE(settings().state, desk.document.scene().states[0].id);
    desk.list()->setCurrentRow(1);
    QCOMPARE(settings().state, desk.document.scene().states[1].id);
}

void TestStatesDock::eachHasAPicture()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 4);
    desk.setHeight(1.0F);
    desk.keepAs("calm");
    StatePictures pictures(desk.state, &desk.window);
    QSignalSpy drawn(&pictures, &StatePictures::drawn);
    const auto key = [&] { return pictures.of(desk.document.scene().states[0]).cacheKey(); };
    const qint64 plain = key();
    QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), 30000);
    const qint64 first = key();
    QVERIFY(first != plain);
    QCOMPARE(key(), first);
    const QImage picture =
        pictures.of(desk.document.scene().states[0]).pixmap(StatePictures::kSize).toImage();
    std::set<QRgb> colours;
    for (int x = 0; x < picture.width(); ++x) {
        colours.insert(picture.pixel(x, picture.height() / 2));
    }
    QVERIFY2(colours.size() > 3, "it shows something");
    desk.press("keepStateAnew");
    drawn.clear();
    QCOMPARE(key(), first); // until that of the state it is now is drawn
    QTRY_VERIFY_WITH_TIMEOUT(!drawn.isEmpty(), 30000);
    QVERIFY(key() != first);
}

void TestStatesDock::takesItsTimeWhileItPlays()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    desk.keepSmallThenGrow();
    desk.state.transport().setPlaying(true);
    desk.state.setRecall({{2.0F, {}}});
    desk.press("recallState");
    QCOMPARE(desk.document.scene().population.column(model::columns::height)[3], 1.0F);
    std::vector<float> seen{desk.shownHeight(3)};
    QCOMPARE(seen.front(), 2.0F); // as before, at first
    QTRY_VERIFY_WITH_TIMEOUT(
        (desk.play(0.02), seen.push_back(desk.shownHeight(3)), seen.back() == 1.0F), 20000);
    QVERIFY2(std::ranges::is_sorted(seen, std::greater<>()), "it jumped");
    QVERIFY2(std::ranges::any_of(seen, [](float each) { return each > 1.2F && each < 1.8F; }),
             "it was seen in between");
    // What began for that alone is over, and the clock goes on.
    QTRY_VERIFY((desk.play(0.02), !desk.state.session().isRunning()));
    QVERIFY(desk.state.transport().isPlaying());
    QCOMPARE(desk.shownHeight(3), 1.0F);
    desk.document.undoStack().undo();
    QCOMPARE(desk.shownHeight(3), 2.0F);
}

void TestStatesDock::whatIsPaintedNextIsSeenAtOnce()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 4);
    desk.setHeight(1.0F);
    desk.keepAs("small");
    desk.state.transport().setPlaying(true);
    desk.state.setRecall({{60.0F, {}}});
    desk.press("recallState"); // they are like that already
    desk.play(0.02);
    desk.setHeight(2.0F);
    QTRY_VERIFY((desk.play(0.02), desk.shownHeight(3) == 2.0F));
}

void TestStatesDock::whileNothingPlaysItIsAtOnce()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    desk.keepSmallThenGrow();
    desk.state.transport().setPlaying(false);
    RecallSettings recall{{2.0F, {}}};
    recall.isForRunAlone = true;
    desk.state.setRecall(recall);
    desk.dock->findChild<QCheckBox*>(QStringLiteral("recallInRun"))->setChecked(true);
    desk.press("recallState");
    QCOMPARE(desk.shownHeight(0), 1.0F);
    QCOMPARE(desk.document.scene().population.column(model::columns::height)[0], 1.0F);
    QVERIFY(!desk.state.session().isRunning());
}

void TestStatesDock::whilePausedItEndsWhatRulesPlay_data()
{
    QTest::addColumn<bool>("isChangedInScene");
    QTest::newRow("the scene is like that already") << false;
    QTest::newRow("the scene is not") << true;
}

/// What is shown is as the state is, whatever a rule lets people play.
void TestStatesDock::whilePausedItEndsWhatRulesPlay()
{
    QFETCH(bool, isChangedInScene);
    StatesDesk desk;
    QVERIFY(desk.isReady());
    (void)crowd::testing::addPeople(desk.document, 4);
    desk.keepAs("calm");
    desk.letThemSitAtTheWord();
    if (isChangedInScene) {
        desk.setClip(1);
    }
    desk.state.transport().setPlaying(true);
    QTRY_VERIFY((desk.play(0.02), desk.state.session().isRunning()));
    desk.state.session().send({"sit", 0.0F}, desk.everybody());
    QTRY_COMPARE((desk.play(0.02), desk.shownClip(0)), std::uint16_t{2});
    desk.state.transport().setPlaying(false);
    desk.doubleClick(0);
    QTRY_COMPARE(desk.shownClip(0), std::uint16_t{0});
    QCOMPARE(desk.said,
             isChangedInScene
                 ? QStringLiteral("“calm” recalled: 4 characters changed")
                 : QStringLiteral("“calm” recalled in the run; the scene itself was like "
                                  "that already"));
    auto* text = desk.dock->findChild<QLabel*>(QStringLiteral("stateDifference"));
    QTRY_COMPARE(text->text(), QStringLiteral("They are like that now."));
}

/// Also by keys, in the run.
void TestStatesDock::onlyForWhoIsSelected()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    desk.keepSmallThenGrow();
    desk.dock->findChild<QCheckBox*>(QStringLiteral("recallSelected"))->setChecked(true);
    desk.press("recallState");
    QVERIFY2(desk.said.contains(QStringLiteral("Nobody is selected")), qPrintable(desk.said));
    QCOMPARE(desk.document.scene().population.column(model::columns::height)[1], 2.0F);
    const std::vector<model::IndividualId> one{desk.document.scene().population.ids()[1]};
    desk.state.selection().set(one);
    desk.press("recallState");
    const auto heights = desk.document.scene().population.column(model::columns::height);
    QCOMPARE(heights[1], 1.0F);
    QCOMPARE(heights[0], 2.0F);
    desk.document.undoStack().undo();
    desk.state.transport().setPlaying(true);
    recallStateOf(desk.state, desk.document.scene().states.front().id, RecallInto::Run);
    QTRY_VERIFY((desk.play(0.02), desk.shownHeight(1) == 1.0F));
    QCOMPARE(desk.shownHeight(0), 2.0F);
}

void TestStatesDock::onlyInThisRun()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    desk.keepSmallThenGrow();
    const int steps = desk.document.undoStack().index();
    desk.state.transport().setPlaying(true);
    desk.dock->findChild<QCheckBox*>(QStringLiteral("recallInRun"))->setChecked(true);
    desk.press("recallState");
    QVERIFY2(desk.said.contains(QStringLiteral("in this run alone")), qPrintable(desk.said));
    QTRY_VERIFY((desk.play(0.02), desk.shownHeight(2) == 1.0F));
    QVERIFY(desk.state.session().hasRecalled());
    QCOMPARE(desk.document.scene().population.column(model::columns::height)[2], 2.0F);
    QCOMPARE(desk.document.undoStack().index(), steps);
    // What is painted meanwhile is seen.
    const std::vector<model::IndividualId> one{desk.document.scene().population.ids()[1]};
    const float painted = 1.5F;
    desk.document.edit(QStringLiteral("Paint"), [&](model::SceneEdit& edit) {
        edit.setColumn(model::columns::height, one, std::span<const float>(&painted, 1));
    });
    QTRY_VERIFY((desk.play(0.02), desk.shownHeight(1) == painted));
    QCOMPARE(desk.shownHeight(2), 1.0F);
    // A state that is kept now keeps what is seen.
    desk.keepAs("seen");
    desk.state.session().stop();
    QVERIFY(!desk.state.session().hasRecalled());
    QCOMPARE(desk.shownHeight(2), 2.0F);
    desk.press("recallState");
    QCOMPARE(desk.shownHeight(2), 1.0F);
    QCOMPARE(desk.shownHeight(1), painted);
}

void TestStatesDock::howItComesIsRemembered()
{
    RecallSettings recall{{3.0F, {5.0F, model::StaggerOrder::Row}}};
    {
        StatesDesk desk;
        QVERIFY(desk.isReady());
        auto* seconds = desk.dock->findChild<FieldForm*>(QStringLiteral("recallTiming"))
                            ->findChild<ValueSlider*>();
        QVERIFY(seconds != nullptr);
        seconds->setValue(3.0);
        Q_EMIT seconds->valueEdited(3.0);
        QCOMPARE(desk.state.recall().timing.seconds, 3.0F);
        QSettings().setValue("states/recall-stagger", 5.0);
        QSettings().setValue("states/recall-order", 2);
    }
    {
        StatesDesk desk;
        QCOMPARE(desk.state.recall(), recall);
    }
    QSettings().setValue("states/recall-seconds", -4.0);
    QSettings().setValue("states/recall-stagger", QStringLiteral("nonsense"));
    QSettings().setValue("states/recall-order", 99);
    StatesDesk desk;
    QCOMPARE(desk.state.recall(), RecallSettings());
}

void TestStatesDock::theWaveBeginsWhereOneClicks()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    const auto choose = [&desk]() -> QPushButton* {
        for (QPushButton* button : desk.all<QPushButton>()) {
            if (button->text() == QLatin1String("Choose in the Picture")) {
                return button;
            }
        }
        return nullptr;
    };
    QVERIFY2(choose() == nullptr, "all together: there is no order");
    desk.state.setRecall({{1.0F, {2.0F, model::StaggerOrder::Distance}}});
    QTRY_VERIFY(choose() != nullptr);
    QVERIFY2(!choose()->isEnabled() && !desk.state.markedPoint(), "nothing could begin there");
    desk.keepSmallThenGrow();
    QTRY_VERIFY(choose()->isEnabled() && desk.state.markedPoint());
    QTest::mouseClick(choose(), Qt::LeftButton);
    QVERIFY(desk.state.picking() == Picking::Place);
    desk.state.offerPoint({1.0F, 0.0F, 4.0F});
    QCOMPARE(desk.state.recall().timing.stagger.point, glm::vec3(1.0F, 0.0F, 4.0F));
    QVERIFY(desk.state.picking() == Picking::None);
    QCOMPARE(desk.state.markedPoint(), std::optional(glm::vec3(1.0F, 0.0F, 4.0F)));
    desk.dock->hide(); // nobody would know what it marks
    QTRY_VERIFY(!desk.state.markedPoint());
}

void TestStatesDock::theButtonIsPressedWhileAPointIsChosen()
{
    StatesDesk desk;
    QVERIFY(desk.isReady());
    QToolButton one(&desk.window);
    QToolButton other(&desk.window);
    std::vector<int> taken;
    makePointButton(one, desk.state, [&taken](const glm::vec3&) { taken.push_back(1); });
    makePointButton(other, desk.state, [&taken](const glm::vec3&) { taken.push_back(2); });
    one.click();
    QVERIFY(one.isChecked() && desk.state.picking() == Picking::Place);
    other.click(); // instead of that one
    QVERIFY(!one.isChecked() && other.isChecked());
    desk.state.offerPoint({1.0F, 0.0F, 4.0F});
    QVERIFY(!other.isChecked());
    QCOMPARE(taken, std::vector<int>{2});
    one.click();
    one.click(); // not after all
    QVERIFY(!one.isChecked() && desk.state.picking() == Picking::None);
    one.click();
    desk.state.setTool(ToolId::Select); // ends it
    QVERIFY(!one.isChecked());
    QCOMPARE(taken, std::vector<int>{2});
}

CROWD_WINDOW_TEST(TestStatesDock)
#include "tst_StatesDock.moc"
