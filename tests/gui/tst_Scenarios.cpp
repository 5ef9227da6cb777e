// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

#include <QtWidgets/QAbstractItemView>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDockWidget>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QTabBar>
#include <QtWidgets/QToolButton>

#include "model/rules/RuleSets.h"
#include "model/scene/NearestPath.h"
#include "tests/gui/Editor.h"
#include "tests/program/WindowTest.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/ValueSlider.h"
#include "widgets/rules/RuleNames.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Editor;

namespace {

constexpr std::size_t kWalkers = 500;
constexpr float kSeconds = 1.0F; ///< over which speeds are measured

/// An artist's hand: says where in the world it clicks.
class Artist
{
public:
    Artist() { QApplication::setActiveWindow(&editor.window); }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&editor.view(), which, modifiers);
    }
    [[nodiscard]] QPoint pixel(const glm::vec3& place)
    {
        const auto at = editor.view().tools().queries().view().project(place);
        return at ? QPoint(qRound(at->x), qRound(at->y)) : QPoint(-1, -1);
    }
    void click(const glm::vec3& place)
    {
        const QPoint at = pixel(place);
        editor.press(at);
        editor.release(at);
    }
    void drag(const glm::vec3& from, const glm::vec3& to) { editor.drag(pixel(from), pixel(to)); }
    void look(const glm::vec3& from, const glm::vec3& to)
    {
        editor.state().setCamera(model::Camera::lookingAt(from, to));
        QTest::qWait(100);
    }
    void change(model::BrushKind kind, const std::function<void(model::BrushSettings&)>& how)
    {
        model::BrushSettings brush = editor.state().brush(kind);
        how(brush);
        editor.state().setBrush(brush);
    }
    /// Adds a ready-made set of rules with the panel's menu.
    [[nodiscard]] bool addRules(model::RuleSet set)
    {
        const auto* add = editor.window.findChild<QToolButton*>(QStringLiteral("addRule"));
        for (QAction* action : add->menu()->actions()) {
            if (action->text() == ruleSetName(set)) {
                action->trigger();
                return true;
            }
        }
        return false;
    }
    [[nodiscard]] std::vector<glm::vec3> places()
    {
        const auto frame = editor.state().frame();
        const auto shown = frame->population.column(model::columns::position);
        return {shown.begin(), shown.end()};
    }
    /// Everybody's speed over some time of the session, m/s.
    [[nodiscard]] std::vector<float> speeds()
    {
        const double start = editor.state().transport().seconds();
        const std::vector<glm::vec3> before = places();
        (void)QTest::qWaitFor(
            [&] { return editor.state().transport().seconds() > start + double{kSeconds}; }, 60000);
        const auto took = static_cast<float>(editor.state().transport().seconds() - start);
        const std::vector<glm::vec3> after = places();
        std::vector<float> all;
        for (std::size_t row = 0; row < std::min(before.size(), after.size()); ++row) {
            all.push_back(glm::distance(before[row], after[row]) / took);
        }
        return all;
    }

    Editor editor;
};

std::ptrdiff_t fasterThan(const std::vector<float>& speeds, float limit)
{
    return std::ranges::count_if(speeds, [limit](float speed) { return speed > limit; });
}

QString copyOf(const QTemporaryDir& folder, const QString& scene)
{
    const QString path = folder.filePath(scene);
    QFile::copy(QStringLiteral(CROWD_RESOURCES "/scenes/") + scene, path);
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
    return path;
}

/// Round the square, along both avenues to it and over it: a network that shares places.
void paintNetwork(Artist& artist)
{
    constexpr float kStreet = 26.0F;
    artist.key(Qt::Key_P);
    artist.change(model::BrushKind::Path,
                  [](model::BrushSettings& brush) { brush.place()->radiusMetres = 2.0F; });
    const std::array<glm::vec3, 4> corners = {{{-kStreet, 0.0F, -kStreet},
                                               {kStreet, 0.0F, -kStreet},
                                               {kStreet, 0.0F, kStreet},
                                               {-kStreet, 0.0F, kStreet}}};
    for (const glm::vec3& corner : corners) {
        artist.click(corner);
    }
    artist.click(corners.front()); // closes it
    for (const glm::vec3& place : {glm::vec3(-62.0F, 0.0F, 0.0F), glm::vec3(-26.0F, 0.0F, 0.0F),
                                   glm::vec3(-10.0F, 0.0F, -10.0F), glm::vec3(26.0F, 0.0F, 0.0F)}) {
        artist.click(place);
    }
    artist.key(Qt::Key_Return);
    for (const glm::vec3& place : {glm::vec3(0.0F, 0.0F, 62.0F), glm::vec3(0.0F, 0.0F, 26.0F),
                                   glm::vec3(10.0F, 0.0F, 10.0F), glm::vec3(0.0F, 0.0F, -26.0F)}) {
        artist.click(place);
    }
    artist.key(Qt::Key_Return);
}

/// Rectangles of people on the square and on the streets, until there are enough.
void paintWalkers(Artist& artist)
{
    artist.key(Qt::Key_C);
    artist.change(model::BrushKind::Create, [](model::BrushSettings& brush) {
        brush.selection = model::BrushSelection::Rectangle;
        brush.as<crowd::model::CreateSettings>().density = 0.5F;
    });
    artist.drag({-20.0F, 0.0F, -20.0F}, {20.0F, 0.0F, -6.0F});
    artist.drag({-20.0F, 0.0F, 7.0F}, {20.0F, 0.0F, 20.0F});
    for (float x = -58.0F; x < -34.0F && artist.editor.people() < kWalkers; x += 12.0F) {
        artist.drag({x, 0.0F, -6.0F}, {x + 11.0F, 0.0F, 6.0F});
    }
}

constexpr int kMostActions = 25;
constexpr double kWaveSeconds = 3.0;

/// An artist with all panels, each of whose actions counts: a click, a drag, a key, a typed value.
class CountedArtist
{
public:
    CountedArtist()
    {
        QApplication::setActiveWindow(&editor.window);
        for (QDockWidget* dock : editor.window.docks()) {
            dock->setVisible(dock->toggleViewAction()->isEnabled());
        }
        editor.view().setMinimumSize(200, 200);
        editor.view().setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
        editor.window.resize(1440, 1000);
        QTest::qWait(200);
    }

    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {})
    {
        ++actions;
        QTest::keyClick(&editor.view(), which, modifiers);
    }
    void dragOverEverything()
    {
        ++actions;
        editor.drag({3, 3}, {editor.view().width() - 4, editor.view().height() - 4});
    }
    void click(QWidget* widget, QPoint at = {})
    {
        ++actions;
        QVERIFY(widget != nullptr && widget->isVisible() && widget->isEnabled());
        QTest::mouseClick(widget, Qt::LeftButton, {}, at.isNull() ? widget->rect().center() : at);
    }
    /// The tab of a panel that lies behind another one.
    void raise(const QString& title)
    {
        for (auto* tabs : editor.window.findChildren<QTabBar*>()) {
            for (int i = 0; i < tabs->count(); ++i) {
                if (tabs->isVisible() && tabs->tabText(i) == title) {
                    click(tabs, tabs->tabRect(i).center());
                    return;
                }
            }
        }
        QFAIL(qPrintable(title));
    }
    void choose(QComboBox* box, const QString& text)
    {
        QVERIFY(box != nullptr && box->isVisible());
        const int index = box->findText(text);
        QVERIFY2(index >= 0, qPrintable(text));
        ++actions;
        box->showPopup();
        const QModelIndex item = box->model()->index(index, 0);
        box->view()->scrollTo(item);
        click(box->view()->viewport(), box->view()->visualRect(item).center());
    }
    void typeInto(ValueSlider* slider, const QString& text)
    {
        QVERIFY(slider != nullptr && slider->isVisible());
        ++actions;
        QTest::mouseDClick(slider, Qt::LeftButton, {}, slider->rect().center());
        auto* line = slider->findChild<QLineEdit*>();
        QVERIFY(line != nullptr);
        line->selectAll();
        QTest::keyClicks(line, text);
        QTest::keyClick(line, Qt::Key_Return);
    }
    void chooseRow(const char* list, const QString& text)
    {
        auto* rows = editor.window.findChild<QListWidget*>(QLatin1String(list));
        QVERIFY(rows != nullptr && rows->isVisible());
        const auto items = rows->findItems(text, Qt::MatchExactly);
        QVERIFY2(items.size() == 1, qPrintable(text));
        rows->scrollToItem(items.front());
        click(rows->viewport(), rows->visualItemRect(items.front()).center());
    }
    void press(const char* button)
    {
        click(editor.window.findChild<QAbstractButton*>(QLatin1String(button)));
    }
    /// How many are shown with each value of the first feature.
    [[nodiscard]] std::map<model::FeatureId, int> moods()
    {
        std::map<model::FeatureId, int> counts;
        const auto frame = editor.state().frame();
        for (const model::FeatureId mood : frame->population.column(model::columns::feature(1))) {
            ++counts[mood];
        }
        return counts;
    }

    Editor editor;
    int actions = 0;
};

} // namespace

/// What the manual's page of scenarios tells the artist to do, done.
class TestScenarios : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void pedestriansFromTheBareCity();
    void clappingSpreadsFromWhereItWasSprayed();
    void anAudienceWithThreePreparedReactions();
};

void TestScenarios::pedestriansFromTheBareCity()
{
    const QTemporaryDir folder;
    Artist artist;
    Editor& editor = artist.editor;
    QVERIFY(editor.open(copyOf(folder, QStringLiteral("city.crowd"))));
    artist.key(Qt::Key_A, Qt::ControlModifier);
    artist.key(Qt::Key_Delete);
    QCOMPARE(editor.people(), std::size_t{0});
    artist.look({0.0F, 150.0F, 0.1F}, {0.0F, 0.0F, 0.0F});
    const model::Scene& scene = editor.window.document().scene();

    paintNetwork(artist);
    QCOMPARE(scene.paths.size(), std::size_t{3});
    QCOMPARE(scene.paths.front().kind, model::PathKind::Cyclic);
    paintWalkers(artist);
    QVERIFY2(editor.people() >= kWalkers, qPrintable(QString::number(editor.people())));
    artist.key(Qt::Key_W);
    artist.change(model::BrushKind::Walk, [](model::BrushSettings& brush) {
        brush.selection = model::BrushSelection::Rectangle;
        brush.through = true;
        brush.as<crowd::model::WalkSettings>().path = model::kNearestPath;
    });
    editor.drag({2, 2}, {537, 357});
    const auto paths = scene.population.column(model::columns::path);
    for (const model::Path& path : scene.paths) {
        QVERIFY2(std::ranges::count(paths, path.id) > 20, path.name.c_str());
    }
    QVERIFY(artist.addRules(model::RuleSet::Pedestrians));

    editor.state().transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(editor.state().session().isRunning(), 60000);
    QTRY_VERIFY_WITH_TIMEOUT(editor.state().transport().seconds() > 2.0, 60000);
    const std::vector<float> walking = artist.speeds();
    QCOMPARE(walking.size(), editor.people());
    QVERIFY2(fasterThan(walking, 0.5F) > std::ptrdiff_t{kWalkers * 7 / 10},
             qPrintable(QString::number(fasterThan(walking, 0.5F))));
    QCOMPARE(fasterThan(walking, 2.0F), std::ptrdiff_t{0});

    artist.key(Qt::Key_E);
    artist.change(model::BrushKind::Event, [](model::BrushSettings& brush) {
        brush.selection = model::BrushSelection::AllInCircle;
        brush.radiusPixels = 14.0F;
        brush.through = true;
        brush.as<crowd::model::EventSettings>() = {"run", 3.0F};
    });
    artist.drag({-20.0F, 0.0F, -14.0F}, {20.0F, 0.0F, -14.0F});
    QTRY_VERIFY(editor.state().session().firedCount(scene.rules.front().id) > 20);
    QTest::qWait(500);
    const std::vector<float> running = artist.speeds();
    QVERIFY2(fasterThan(running, 2.0F) > 15,
             qPrintable(QString::number(fasterThan(running, 2.0F))));
    QVERIFY(fasterThan(running, 2.0F) < std::ptrdiff_t{kWalkers} / 2); // the others walk on
    for (const glm::vec3& place : artist.places()) {
        QVERIFY(std::isfinite(place.x) && std::abs(place.y) < 8.0F);
    }
}

/// From a few to many more.
void TestScenarios::clappingSpreadsFromWhereItWasSprayed()
{
    const QTemporaryDir folder;
    Artist artist;
    Editor& editor = artist.editor;
    QVERIFY(editor.open(copyOf(folder, QStringLiteral("theatre.crowd"))));
    QVERIFY(artist.addRules(model::RuleSet::Audience));
    artist.look({0.0F, 14.0F, 12.0F}, {0.0F, 2.0F, -8.0F});
    const model::Scene& scene = editor.window.document().scene();
    // Step by step: playing computes ahead, on a busy machine for longer than claps need to spread.
    auto& session = editor.state().session();
    const auto step = [&] {
        session.stepOnce();
        const double wanted = editor.state().transport().seconds() - 1e-6;
        return QTest::qWaitFor([&] { return session.availableSeconds() >= wanted; }, 60000);
    };
    QTRY_VERIFY_WITH_TIMEOUT((session.stepOnce(), session.isRunning()), 60000);

    artist.key(Qt::Key_E);
    artist.change(model::BrushKind::Event, [](model::BrushSettings& brush) {
        brush.selection = model::BrushSelection::AllInCircle;
        brush.radiusPixels = 12.0F;
        brush.as<crowd::model::EventSettings>() = {"clap", 1.0F};
    });
    const auto seats = scene.population.column(model::columns::position);
    const glm::vec3 first = *std::ranges::min_element(seats, {}, [](const glm::vec3& seat) {
        return glm::distance(seat, glm::vec3(-9.0F, 2.0F, -9.0F));
    });
    artist.click(first + glm::vec3(0.0F, 0.8F, 0.0F));
    const auto clapping = [&] {
        std::uint64_t fired = 0;
        for (const model::Rule& rule : scene.rules) {
            const auto* event = rule.trigger.as<model::triggers::Event>();
            const bool isClap = event != nullptr && event->event == "clap";
            fired += isClap ? editor.state().session().firedCount(rule.id) : 0;
        }
        return fired;
    };
    for (int i = 0; i < 30 && clapping() == 0; ++i) {
        QVERIFY(step());
    }
    QVERIFY(clapping() > 0);
    const std::uint64_t sprayed = clapping();
    QVERIFY2(sprayed < 40, qPrintable(QString::number(sprayed)));
    editor.state().transport().setPlaying(true);
    QTRY_VERIFY_WITH_TIMEOUT(clapping() > sprayed + 60, 60000);
}

/// The audience of the paper: filled, three reactions prepared, and replayed as waves.
void TestScenarios::anAudienceWithThreePreparedReactions()
{
    CountedArtist artist;
    Editor& editor = artist.editor;
    const model::Scene& scene = editor.window.document().scene();
    artist.key(Qt::Key_N, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(scene.templates.size() == 5 && editor.isLoaded(), 60000);
    QCOMPARE(editor.state().tool(), ToolId::BrushCreate); // as the editor starts
    artist.key(Qt::Key_2);                                // the overview
    QTRY_VERIFY(!editor.state().isAnimating() && editor.view().isAtRest());
    auto* settings = editor.window.findChild<QDockWidget*>(QStringLiteral("brushSettings"));
    QVERIFY(settings != nullptr);
    QComboBox* area = nullptr;
    QTRY_VERIFY((area = settings->findChild<QComboBox*>()) != nullptr && area->isVisible());
    artist.choose(area, QStringLiteral("Rectangle"));
    artist.dragOverEverything();
    QVERIFY2(editor.people() >= 700, qPrintable(QString::number(editor.people())));
    std::set<model::TemplateId> cast;
    for (const model::TemplateId each : scene.population.column(model::columns::templateId)) {
        cast.insert(each);
    }
    QCOMPARE(cast.size(), std::size_t{5});

    artist.raise(QStringLiteral("Features"));
    constexpr std::array kReactions{"attentive", "excited", "sad"};
    for (std::size_t i = 0; i < kReactions.size(); ++i) {
        artist.chooseRow("features", QLatin1String(kReactions[i]));
        artist.press("giveFeature");
        artist.key(static_cast<Qt::Key>(Qt::Key_F1 + static_cast<int>(i)),
                   Qt::ControlModifier | Qt::ShiftModifier);
    }
    QCOMPARE(scene.states.size(), kReactions.size());

    artist.raise(QStringLiteral("States"));
    auto* timing = editor.window.findChild<FieldForm*>(QStringLiteral("recallTiming"));
    const QList<ValueSlider*> seconds = timing->findChildren<ValueSlider*>();
    artist.typeInto(seconds.at(0), QStringLiteral("0.5"));
    artist.typeInto(seconds.at(1), QString::number(kWaveSeconds));
    artist.choose(timing->findChild<QComboBox*>(), QStringLiteral("row by row"));
    if (!editor.state().transport().isPlaying()) {
        artist.key(Qt::Key_Space);
    }
    const model::FeatureKind& emotion = scene.features.front();
    for (std::size_t i = 0; i < kReactions.size(); ++i) {
        const model::FeatureId wanted = emotion.find(kReactions[i])->id;
        const double begun = editor.state().transport().seconds();
        artist.key(static_cast<Qt::Key>(Qt::Key_F1 + static_cast<int>(i)), Qt::ShiftModifier);
        // A wave: some are there and others are not yet, before all have begun.
        if (i > 0) {
            QTRY_VERIFY_WITH_TIMEOUT(artist.moods()[wanted] > 0, 60000);
            const bool areSome = artist.moods().size() == 2;
            QVERIFY(areSome || editor.state().transport().seconds() > begun + kWaveSeconds);
        }
        QTRY_VERIFY_WITH_TIMEOUT(artist.moods()[wanted] == static_cast<int>(editor.people()),
                                 60000);
    }
    QVERIFY2(artist.actions <= kMostActions, qPrintable(QString::number(artist.actions)));
}

CROWD_WINDOW_TEST(TestScenarios)
#include "tst_Scenarios.moc"
