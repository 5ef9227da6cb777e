// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>

#include <QtCore/QSettings>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QStatusBar>

#include "app/window/MainWindow.h"
#include "model/pick/StageRays.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// Where a panel is; empty: not to be seen.
using Layout = std::map<QString, QRect>;

Layout layoutOf(const app::MainWindow& window)
{
    Layout layout;
    for (const QDockWidget* dock : window.docks()) {
        const bool isSeen = dock->isVisible() && !dock->visibleRegion().isEmpty();
        layout[dock->objectName()] = isSeen ? dock->geometry() : QRect();
    }
    return layout;
}

} // namespace

/// What lies around the picture, and whose the keys are.
class PanelsTest : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("PanelsTest"); }
    void init() { begin(); }
    void cleanup()
    {
        document().undoStack().setClean();
        m_window.reset();
    }

    void cueKeysActThoughTheWindowIsNotTheActiveOne();
    void endedTypingGivesTheKeysBack_data();
    void endedTypingGivesTheKeysBack();
    void returnIsTheFieldsEvenWhileAPathIsPainted();
    void nothingTellsHowToBringBackWhatIsBack();
    void brushesAreRemembered();
    void damagedMemoryOfBrushesDoesNoHarm();
    void resetLayoutIsThatOfTheFirstStart();
    void everythingOfAnEmptyTheatreShowsItsSeats();

private:
    [[nodiscard]] QLineEdit* eventField();
};

/// Of the event brush: the name of the event.
QLineEdit* PanelsTest::eventField()
{
    m_window->state().setTool(widgets::ToolId::BrushEvent);
    QLineEdit* found = nullptr;
    (void)QTest::qWaitFor([&] {
        for (auto* line : m_window->docks()[1]->findChildren<QLineEdit*>()) {
            found = line->isVisible() && line->text() == QLatin1String("cheer") ? line : found;
        }
        return found != nullptr;
    });
    return found;
}

void PanelsTest::cueKeysActThoughTheWindowIsNotTheActiveOne()
{
    model::Scene scene = plainScene(1);
    scene.cues.push_back({1, {}, "clap", 0.0F, "F3"});
    openScene(scene, QStringLiteral("a.crowd"));
    m_window->statusBar()->clearMessage();
    QKeyEvent press(QEvent::KeyPress, Qt::Key_F3, Qt::NoModifier); // past the shortcuts
    QApplication::sendEvent(&m_window->viewport(), &press);
    QVERIFY2(m_window->statusBar()->currentMessage().contains(QStringLiteral("Play")),
             qPrintable(m_window->statusBar()->currentMessage()));
}

void PanelsTest::endedTypingGivesTheKeysBack_data()
{
    QTest::addColumn<Qt::Key>("key");
    QTest::addColumn<QString>("name");
    QTest::newRow("Return takes it") << Qt::Key_Return << QStringLiteral("wave");
    QTest::newRow("Enter takes it") << Qt::Key_Enter << QStringLiteral("wave");
    QTest::newRow("Escape does not") << Qt::Key_Escape << QStringLiteral("cheer");
}

void PanelsTest::endedTypingGivesTheKeysBack()
{
    QFETCH(Qt::Key, key);
    QFETCH(QString, name);
    QLineEdit* field = eventField();
    QVERIFY(field != nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("wave"));
    QTest::keyClick(m_window->windowHandle(), key);
    QTRY_VERIFY(m_window->viewport().hasFocus());
    QCOMPARE(m_window->state().brush(model::BrushKind::Event).event.name, name.toStdString());
    QTest::keyClick(m_window->windowHandle(), Qt::Key_B);
    QCOMPARE(m_window->state().tool(), widgets::ToolId::BrushColour);
}

void PanelsTest::returnIsTheFieldsEvenWhileAPathIsPainted()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    {
        const auto edit = document().beginEdit();
        model::Path path;
        path.places = {edit->addPlace({})};
        const model::PathId id = edit->addPath(path);
        edit->commit(QStringLiteral("Path"));
        m_window->state().paths().paint(id);
    }
    QVERIFY(m_window->state().paths().isPainting());
    QLineEdit* field = eventField();
    QVERIFY(field != nullptr);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("wave"));
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Return);
    QCOMPARE(m_window->state().brush(model::BrushKind::Event).event.name, std::string("wave"));
}

void PanelsTest::nothingTellsHowToBringBackWhatIsBack()
{
    m_window->dockLayout().setHidden(true);
    QVERIFY(!m_window->statusBar()->currentMessage().isEmpty());
    m_window->dockLayout().setHidden(false);
    QVERIFY2(m_window->statusBar()->currentMessage().isEmpty(),
             qPrintable(m_window->statusBar()->currentMessage()));
}

void PanelsTest::brushesAreRemembered()
{
    using model::BrushKind;
    auto& state = m_window->state();
    model::BrushSettings create = state.brush(BrushKind::Create);
    create.radiusPixels = 77.0F;
    create.selection = model::BrushSelection::AllInCircle;
    create.create.height = {0.75F, 1.25F};
    create.create.palette = {{1, 2, 3}, {200, 100, 50}};
    create.create.clips = {{"idle", 0.5F}};
    create.create.mix = {{9, 1.0F}};
    create.distribution.weights[3] = 0.25F;
    state.setBrush(create);
    model::BrushSettings walk = state.brush(BrushKind::Walk);
    walk.walk.speed = {2.0F, 3.5F};
    walk.walk.path = 7;
    state.setBrush(walk);
    const model::BrushSettings untouched = state.brush(BrushKind::Orientation);
    QVERIFY(m_window->close());
    openWindow();
    const model::BrushSettings& after = m_window->state().brush(BrushKind::Create);
    QVERIFY2(after.create.mix != create.create.mix, "templates are of a scene");
    create.create.mix = after.create.mix;
    QVERIFY(after == create);
    const model::WalkSettings& walking = m_window->state().brush(BrushKind::Walk).walk;
    QCOMPARE(walking.speed, (model::ValueRange{2.0F, 3.5F}));
    QVERIFY2(walking.path != 7, "paths are of a scene");
    QVERIFY(m_window->state().brush(BrushKind::Orientation) == untouched);
    m_window->actions().action("brush-reset")->trigger();
    QCOMPARE(m_window->state().brush(BrushKind::Create).radiusPixels,
             widgets::initialBrush(BrushKind::Create).radiusPixels);
}

void PanelsTest::damagedMemoryOfBrushesDoesNoHarm()
{
    const model::BrushSettings before = m_window->state().brush(model::BrushKind::Colour);
    QVERIFY(m_window->close());
    QSettings settings;
    settings.setValue(QStringLiteral("brushes/brush-create"), QByteArray("{\"radius\": 1e30, "));
    settings.setValue(QStringLiteral("brushes/brush-colour"),
                      QByteArray(R"({"radius": 1e30, "rate": "many", "selection": 99,
                                     "colours": [], "operator": -4})"));
    settings.sync();
    openWindow();
    model::BrushSettings colour = m_window->state().brush(model::BrushKind::Colour);
    QCOMPARE(colour.radiusPixels, model::kMaxRadiusPixels);
    QVERIFY(!colour.colour.colors.empty());
    colour.radiusPixels = before.radiusPixels;
    colour.colour = before.colour;
    QVERIFY(colour == before);
}

void PanelsTest::resetLayoutIsThatOfTheFirstStart()
{
    QTest::qWait(200);
    const Layout first = layoutOf(*m_window);
    const auto& docks = m_window->docks();
    docks[0]->hide();
    docks[1]->setFloating(true);
    m_window->addDockWidget(Qt::LeftDockWidgetArea, docks[3]);
    docks[7]->raise();
    m_window->resizeDocks({docks[2]}, {420}, Qt::Horizontal);
    QTest::qWait(200);
    QVERIFY(layoutOf(*m_window) != first);
    m_window->actions().action("reset-layout")->trigger();
    QTest::qWait(400);
    const Layout after = layoutOf(*m_window);
    for (const auto& [name, place] : first) {
        QCOMPARE(std::pair(name, after.at(name)), std::pair(name, place));
    }
}

void PanelsTest::everythingOfAnEmptyTheatreShowsItsSeats()
{
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().newTheatre();
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 3 * kPatienceMs);
    m_window->actions().action("frame-all")->trigger();
    model::StageRays stage;
    stage.setStages(document().scene().stages);
    const glm::vec3 eye = m_window->state().cameraTarget().position;
    const std::vector<model::WorldSeat> seats = document().scene().worldSeats();
    const auto hidden = std::ranges::count_if(seats, [&](const model::WorldSeat& seat) {
        return stage.isBlocked(eye, seat.seat.position + glm::vec3(0.0F, 0.5F, 0.0F));
    });
    QVERIFY(!seats.empty());
    const std::string text = std::to_string(hidden) + " of " + std::to_string(seats.size());
    QVERIFY2(static_cast<std::size_t>(hidden) < seats.size() / 4, text.c_str());
}

CROWD_WINDOW_TEST(PanelsTest)

#include "tst_Panels.moc"
