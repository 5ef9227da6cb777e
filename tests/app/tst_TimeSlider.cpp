// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <span>

#include <QtGui/QAction>
#include <QtTest/QTest>
#include <QtWidgets/QLabel>
#include <QtWidgets/QSlider>

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
    void whatIsDoneHappensAtTheLatestMoment();
    void clipsAloneAreSeenAgain();

private:
    [[nodiscard]] QSlider* slider() const
    {
        return m_window->findChild<QSlider*>(QStringLiteral("timeSlider"));
    }
    [[nodiscard]] widgets::Transport& transport() const { return m_window->state().transport(); }
    [[nodiscard]] widgets::SessionControl& session() const { return m_window->state().session(); }
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

void TestTimeSlider::whatIsDoneHappensAtTheLatestMoment()
{
    play();
    const double live = session().liveSeconds();
    transport().setSeconds(live / 2.0);
    document().edit(QStringLiteral("Height"), [&](model::SceneEdit& edit) {
        edit.setColumn(model::columns::height, document().scene().population.ids(),
                       std::span<const float>(std::array{1.5F}));
    });
    QCOMPARE(transport().seconds(), live / 2.0); // it is seen then, too
    session().send({"wave", 0.0F}, document().scene().population.ids());
    QCOMPARE(transport().seconds(), live);
    transport().setSeconds(live / 2.0);
    crowd::testing::moveEverybody(document(), -20.0F);
    QCOMPARE(transport().seconds(), live);
    transport().setSeconds(live / 2.0);
    const float kept = shownX();
    QVERIFY(session().keepPose());
    QCOMPARE(document().scene().population.column(model::columns::position).front().x, kept);
    QCOMPARE(transport().seconds(), live);
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
