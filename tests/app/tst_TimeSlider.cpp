// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <span>

#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QSlider>

#include "app/window/StatusPanel.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"
#include "widgets/actions/ActionRegistry.h"
#include "widgets/state/SessionControl.h"

using namespace crowd;

/// What has been played is seen again by a drag in the tool bar.
class TestTimeSlider : public QObject, crowd::testing::SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("tst_TimeSlider"); }
    void init() { begin(); }
    void aDragShowsEarlierMoments();
    void stepsGoBackAndForth();
    void whatIsDoneHappensAtTheMomentShown();
    void itIsTakenFromThere();
    void whatIsDoneWhileNothingPlaysIsSeen();
    void whatIsDoneBeforeStepsAreThereIsSeen();
    void clipsAloneAreSeenAgain();

private:
    [[nodiscard]] QSlider* slider() const
    {
        return m_window->findChild<QSlider*>(QStringLiteral("timeSlider"));
    }
    [[nodiscard]] widgets::Transport& transport() const { return m_window->state().transport(); }
    [[nodiscard]] widgets::SessionControl& session() const { return m_window->state().session(); }
    [[nodiscard]] bool isComputed() const
    {
        return QTest::qWaitFor([this] { return session().takenShare() < 0.0; },
                               crowd::testing::kPatienceMs);
    }
    [[nodiscard]] float xAt(double seconds) const
    {
        transport().setSeconds(seconds);
        return shownX();
    }
    [[nodiscard]] float shownX() const
    {
        return m_window->state().frame()->population.column(model::columns::position).front().x;
    }
    void trigger(const char* id) const { m_window->actions().action(id)->trigger(); }
    /// Somebody walks from the left to the right, and has done so for two seconds.
    void play();
};

void TestTimeSlider::play()
{
    model::Scene scene = crowd::testing::plainScene(1);
    scene.places = {{1, "here", {0.0F, 0.0F, 0.0F}, 1.0F}, {2, "there", {60.0F, 0.0F, 0.0F}, 1.0F}};
    scene.paths = {{1, "way", model::PathKind::Simple, {1, 2}}};
    const model::PathId path = 1;
    const auto ids = scene.population.ids();
    scene.population.setValues<model::PathId>(
        model::columns::path, std::vector(ids.begin(), ids.end()), std::vector{path});
    openScene(scene, QStringLiteral("walk.crowd"));
    session().stop();
    QVERIFY(!slider()->isEnabled());
    transport().setSpeed(4.0);
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(session().isRunning() && transport().seconds() > 2.0,
                             crowd::testing::kPatienceMs);
    transport().setPlaying(false);
    QVERIFY(slider()->isEnabled());
}

void TestTimeSlider::aDragShowsEarlierMoments()
{
    play();
    const double live = transport().seconds();
    QCOMPARE(session().liveSeconds(), live);
    const float there = shownX();
    const QPoint middle = slider()->rect().center();
    QTest::mousePress(slider(), Qt::LeftButton, {}, middle);
    QVERIFY(std::abs(transport().seconds() - live / 2.0) < 0.1 * live);
    const float halfWay = shownX();
    QVERIFY2(halfWay < there - 0.5F, qPrintable(QString::number(halfWay)));
    QTest::mouseMove(slider(), QPoint(2, middle.y()));
    QTRY_VERIFY(transport().seconds() < 0.1 * live);
    QVERIFY(shownX() < halfWay - 0.5F);
    QTest::mouseRelease(slider(), Qt::LeftButton, {}, QPoint(2, middle.y()));
    QVERIFY(!transport().isPlaying());
    QVERIFY(slider()->value() < slider()->maximum() / 5);
    // Played on it comes to where it was, and further.
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(transport().seconds() > live, crowd::testing::kPatienceMs);
    QVERIFY(shownX() > there);
    // Held while it plays, it stands; let go, it plays on.
    QTest::mousePress(slider(), Qt::LeftButton, {}, middle);
    QVERIFY(!transport().isPlaying());
    QTest::mouseRelease(slider(), Qt::LeftButton, {}, middle);
    QVERIFY(transport().isPlaying());
    session().stop();
    QVERIFY(!slider()->isEnabled());
    QCOMPARE(slider()->value(), 0);
}

void TestTimeSlider::stepsGoBackAndForth()
{
    play();
    const double step = 1.0 / document().scene().stepsPerSecond;
    trigger("step-back");
    const double before = transport().seconds();
    const float place = shownX();
    trigger("step-back");
    QVERIFY(std::abs(before - transport().seconds() - step) < 1e-9);
    QVERIFY(shownX() < place);
    trigger("step");
    QVERIFY(std::abs(before - transport().seconds()) < 1e-9);
    QCOMPARE(shownX(), place);
    for (int i = 0; i < 200; ++i) {
        trigger("step-back");
    }
    QCOMPARE(transport().seconds(), session().firstSeconds());
    trigger("catch-up");
    QCOMPARE(transport().seconds(), session().liveSeconds());
}

/// What was before it stays, what came after it is played anew.
void TestTimeSlider::whatIsDoneHappensAtTheMomentShown()
{
    play();
    const double live = session().liveSeconds();
    const double middle = live / 2.0;
    const float early = xAt(live / 4.0);
    const float late = xAt(middle);
    document().edit(QStringLiteral("Height"), [&](model::SceneEdit& edit) {
        edit.setColumn(model::columns::height, document().scene().population.ids(),
                       std::span<const float>(std::array{1.5F}));
    });
    QCOMPARE(transport().seconds(), middle);
    QCOMPARE(session().liveSeconds(), live); // it is seen at all times
    session().send({"wave", 0.0F}, document().scene().population.ids());
    // At the step before it.
    const double step = 1.0 / document().scene().stepsPerSecond;
    const double taken = session().liveSeconds();
    QVERIFY(taken <= middle && taken > middle - step);
    QCOMPARE(transport().seconds(), taken);
    QVERIFY(isComputed());
    QCOMPARE(xAt(live / 4.0), early);
    QVERIFY(std::abs(xAt(taken) - late) < 0.1F);
    crowd::testing::moveEverybody(document(), -20.0F);
    QCOMPARE(transport().seconds(), taken);
    QVERIFY(isComputed());
    QTRY_VERIFY_WITH_TIMEOUT(shownX() < late - 10.0F, crowd::testing::kPatienceMs);
    QCOMPARE(xAt(live / 4.0), early);
    // Kept as they were a while ago: it goes on from there.
    QVERIFY(session().keepPose());
    QCOMPARE(document().scene().population.column(model::columns::position).front().x, early);
    QVERIFY(session().liveSeconds() <= live / 4.0);
    QVERIFY(isComputed());
    QVERIFY(std::abs(shownX() - early) < 0.1F);
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(transport().seconds() > middle, crowd::testing::kPatienceMs);
    QVERIFY(shownX() > early);
}

void TestTimeSlider::itIsTakenFromThere()
{
    play();
    const double live = session().liveSeconds();
    QAction* take = m_window->actions().action("take-from-here");
    QVERIFY(!take->isEnabled());
    const float there = xAt(live / 2.0);
    QVERIFY(take->isEnabled());
    take->trigger();
    QCOMPARE(session().liveSeconds(), transport().seconds());
    QVERIFY(std::abs(session().liveSeconds() - live / 2.0) < 0.05);
    QTRY_VERIFY_WITH_TIMEOUT(!take->isEnabled(), crowd::testing::kPatienceMs);
    QVERIFY(isComputed());
    QCOMPARE(slider()->value(), slider()->maximum());
    QVERIFY(std::abs(shownX() - there) < 0.1F);
    auto* status = m_window->findChild<app::StatusPanel*>();
    QVERIFY(status->currentMessage().contains(QStringLiteral("played anew")));
}

void TestTimeSlider::whatIsDoneWhileNothingPlaysIsSeen()
{
    play();
    const double live = session().liveSeconds();
    const float there = shownX();
    crowd::testing::moveEverybody(document(), -30.0F);
    QTRY_VERIFY_WITH_TIMEOUT(shownX() < there - 20.0F, crowd::testing::kPatienceMs);
    QVERIFY(std::abs(transport().seconds() - live) < 0.5);
    document().undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(shownX() > -1.0F, crowd::testing::kPatienceMs);
    QVERIFY(!transport().isPlaying());
}

/// Paused while steps are wanted that are not done: it happens at the last that is shown.
void TestTimeSlider::whatIsDoneBeforeStepsAreThereIsSeen()
{
    play();
    const float there = shownX();
    transport().setPlaying(true);
    session().advance(0.9);
    transport().setPlaying(false);
    const double shown = transport().seconds();
    crowd::testing::moveEverybody(document(), -30.0F);
    QTRY_VERIFY_WITH_TIMEOUT(shownX() < there - 20.0F, crowd::testing::kPatienceMs);
    QVERIFY(std::abs(transport().seconds() - shown) < 0.1);
}

/// Where nobody goes anywhere there is no run; the clock is the same.
void TestTimeSlider::clipsAloneAreSeenAgain()
{
    openScene(crowd::testing::plainScene(1), QStringLiteral("plain.crowd"));
    session().stop();
    transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(transport().seconds() > 0.5, crowd::testing::kPatienceMs);
    transport().setPlaying(false);
    const double live = transport().seconds();
    QVERIFY(!session().isRunning() && slider()->isEnabled());
    QTest::mouseClick(slider(), Qt::LeftButton, {}, slider()->rect().center());
    QVERIFY(std::abs(transport().seconds() - live / 2.0) < 0.1 * live);
    trigger("step-back");
    QVERIFY(transport().seconds() < live / 2.0);
    trigger("catch-up");
    QCOMPARE(transport().seconds(), live);
}

CROWD_WINDOW_TEST(TestTimeSlider)
#include "tst_TimeSlider.moc"
