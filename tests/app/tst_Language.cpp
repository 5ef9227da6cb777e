// SPDX-License-Identifier: MIT
#include "app/window/Language.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <QtCore/QMetaProperty>
#include <QtTest/QTest>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QPushButton>
#include <QtWidgets/QStatusBar>
#include <QtWidgets/QTabBar>
#include <QtWidgets/QToolButton>

#include "app/console/ConsoleDock.h"
#include "app/window/MainWindow.h"
#include "app/window/PreferencesDialog.h"
#include "app/window/ReadyNames.h"
#include "model/project/ProjectFile.h"
#include "model/project/ProjectWriter.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

/// Of these, texts depend on the moment and the room there is: time of a picture, a remark that
/// passes, how much of some work is done, a text that is cut (its tip has all). Qt keeps tab bars
/// for later, with their arrows.
bool isPassing(const QObject& object)
{
    return object.inherits("QProgressBar") ||
           object.objectName() == QStringLiteral("statusFrame") || object.inherits("QStatusBar") ||
           object.objectName().startsWith(QStringLiteral("Scroll"));
}

bool isOfWords(const QObject& object, const QMetaProperty& property)
{
    const bool isCut =
        object.inherits("crowd::app::ElidedLabel") && property.name() == QByteArrayView("text");
    return property.typeId() == QMetaType::QString && !isCut &&
           property.name() != QByteArrayView("html"); // colours too
}

void addRows(QStringList& texts, const QAbstractItemModel& rows, const QModelIndex& parent)
{
    for (int row = 0; row < rows.rowCount(parent); ++row) {
        for (int column = 0; column < rows.columnCount(parent); ++column) {
            const QModelIndex cell = rows.index(row, column, parent);
            texts << QStringLiteral("row: ") + cell.data().toString()
                  << QStringLiteral("row's tip: ") + cell.data(Qt::ToolTipRole).toString();
        }
        addRows(texts, rows, rows.index(row, 0, parent));
    }
}

/// Whatever of it is text, by its properties; and its keys.
void addProperties(QStringList& texts, const QObject& object)
{
    const QMetaObject& type = *object.metaObject();
    for (int i = 0; i < type.propertyCount(); ++i) {
        const QMetaProperty property = type.property(i);
        const QString text =
            isOfWords(object, property) ? property.read(&object).toString() : QString();
        if (!text.isEmpty()) {
            texts << QStringLiteral("%1 %2 %3: %4")
                         .arg(QLatin1String(type.className()), object.objectName(),
                              QLatin1String(property.name()), text);
        }
    }
    if (const auto* action = qobject_cast<const QAction*>(&object)) {
        texts << QStringLiteral("keys: ") + action->shortcut().toString(QKeySequence::NativeText);
    }
}

void addEntries(QStringList& texts, const QObject& object)
{
    if (const auto* box = qobject_cast<const QComboBox*>(&object)) {
        addRows(texts, *box->model(), {});
    } else if (const auto* view = qobject_cast<const QAbstractItemView*>(&object)) {
        addRows(texts, *view->model(), {});
    } else if (const auto* tabs = qobject_cast<const QTabBar*>(&object)) {
        for (int i = 0; i < tabs->count(); ++i) {
            texts << QStringLiteral("tab: ") + tabs->tabText(i);
        }
    }
}

/// Everything that the window says or would say, hidden or not, sorted.
QStringList textsOf(app::MainWindow& window)
{
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    for (QMenu* menu : window.findChildren<QMenu*>()) {
        Q_EMIT menu->aboutToShow(); // some are filled then
    }
    QStringList texts;
    addProperties(texts, window);
    for (const QObject* object : window.findChildren<QObject*>()) {
        if (!isPassing(*object)) {
            addProperties(texts, *object);
            addEntries(texts, *object);
        }
    }
    texts.sort();
    return texts;
}

/// What only one of them has.
QStringList differences(const QStringList& one, const QStringList& other)
{
    QStringList only;
    std::ranges::set_symmetric_difference(one, other, std::back_inserter(only));
    return only;
}

QByteArray firstOf(const QStringList& texts)
{
    return texts.mid(0, 12).join(QLatin1Char('\n')).toUtf8();
}

struct PanelPlace
{
    bool isHidden = false;
    bool isFloating = false;
    QRect seen; ///< empty: behind another one
    friend bool operator==(const PanelPlace&, const PanelPlace&) = default;
};
using PanelPlaces = std::map<QString, PanelPlace>;

PanelPlaces placesOf(const app::MainWindow& window)
{
    PanelPlaces places;
    for (const QDockWidget* dock : window.docks()) {
        const bool isSeen = !dock->visibleRegion().isEmpty();
        places[dock->objectName()] = {dock->isHidden(), dock->isFloating(),
                                      isSeen ? dock->geometry() : QRect()};
    }
    return places;
}

/// Once they have found their places: they were there a moment ago, too.
PanelPlaces settledPlacesOf(const app::MainWindow& window)
{
    PanelPlaces places = placesOf(window);
    for (int rounds = 0; rounds < 50; ++rounds) {
        QTest::qWait(300);
        if (const PanelPlaces now = placesOf(window); now == std::exchange(places, now)) {
            break;
        }
    }
    return places;
}

/// Longer words may make a panel a little wider.
bool isAlike(const PanelPlace& one, const PanelPlace& other)
{
    constexpr int kSlack = 12;
    const QRect roomy = one.seen.adjusted(-kSlack, -kSlack, kSlack, kSlack);
    return one.isHidden == other.isHidden && one.isFloating == other.isFloating &&
           one.seen.isEmpty() == other.seen.isEmpty() &&
           (one.seen.isEmpty() ||
            (roomy.contains(other.seen) &&
             other.seen.adjusted(-kSlack, -kSlack, kSlack, kSlack).contains(one.seen)));
}

/// Panels that are elsewhere; empty: none.
QStringList moved(const PanelPlaces& before, const PanelPlaces& after)
{
    QStringList names;
    for (const auto& [name, place] : before) {
        if (!isAlike(place, after.at(name))) {
            names << name;
        }
    }
    return names;
}

/// Two places, a path, a cue, a rule that can run and one that cannot.
model::Scene busyScene()
{
    model::Scene scene = plainScene(6);
    scene.places = {{1, "gate", {2.0F, 0.0F, 1.0F}}, {2, "well", {-2.0F, 0.0F, 1.0F}}};
    scene.paths.push_back({1, "lane", model::PathKind::Cyclic, {1, 2}});
    scene.cues.push_back({1, {}, "clap", 0.0F, "F3"});
    model::Rule good;
    good.id = 1;
    good.trigger = model::triggers::Event{"clap"};
    good.actions.emplace_back(model::actions::AddTag());
    model::Rule bad = good;
    bad.id = 2;
    bad.actions.emplace_back(model::actions::FollowPath());
    scene.rules = {good, bad};
    return scene;
}

/// Of its cameras, lights and states.
std::vector<std::string> names(const model::Scene& scene)
{
    std::vector<std::string> all;
    const auto add = [&all](const auto& items) {
        for (const auto& item : items) {
            all.push_back(item.name);
        }
    };
    add(scene.cameras);
    add(scene.lights);
    add(scene.states);
    return all;
}

} // namespace

/// Another language takes effect at once, everywhere, and nothing is lost.
class LanguageTest : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("LanguageTest"); }
    void init();
    void cleanup() { m_window.reset(); }
    void everyTextIsAsInAWindowThatStartedInTheLanguage();
    void nothingIsLost();
    void aFloatingPanelStaysWhereItIs();
    void hiddenPanelsStayHidden();
    void thePanelsFitASmallScreen();
    void pythonKeepsItsNames();
    void aStrokeIsWaitedFor();
    void theMenuChoosesAndItIsRemembered();
    void preferencesChooseItToo();
    void qtSpeaksItToo();
    void readyMadeScenesSpeakItToo();

private:
    void workOn();
    void change(const QString& code);
    [[nodiscard]] QAction& entry(const QString& code) const;
    void waitForBaking();
    [[nodiscard]] std::string bytes() const
    {
        return model::projectToText(document().scene()).value();
    }
};

void LanguageTest::init()
{
    app::useLanguage(QStringLiteral("en"));
    begin();
}

void LanguageTest::waitForBaking()
{
    QTRY_COMPARE_WITH_TIMEOUT(m_window->state().keyframes().progress().pendingClips, 0,
                              kPatienceMs);
}

/// The project of everything, with selections, an edit and a session that has run.
void LanguageTest::workOn()
{
    openScene(busyScene(), QStringLiteral("busy.crowd"));
    widgets::EditorState& state = m_window->state();
    moveEverybody(document(), 1.0F);
    state.setTool(widgets::ToolId::BrushColour);
    const std::vector<model::IndividualId> people{1, 2};
    state.selection().set(people);
    state.paths().select({1});
    state.session().stepOnce();
    QTRY_VERIFY(state.session().isRunning());
    auto* rules = m_window->findChild<QListWidget*>(QStringLiteral("ruleList"));
    QTRY_COMPARE(rules->count(), 2);
    rules->setCurrentRow(1);
    waitForBaking();
    QTest::qWait(600); // panels that follow on a timer
}

void LanguageTest::change(const QString& code)
{
    m_window->chooseLanguage(code);
    QCoreApplication::processEvents();
    QCOMPARE(app::languageInUse(), code);
    QTest::qWait(600);
}

QAction& LanguageTest::entry(const QString& code) const
{
    return *m_window->menuBar()->findChild<QAction*>(QStringLiteral("language-") + code);
}

void LanguageTest::everyTextIsAsInAWindowThatStartedInTheLanguage()
{
    workOn();
    const QStringList english = textsOf(*m_window);
    change(QStringLiteral("de"));
    const QStringList german = textsOf(*m_window);
    QVERIFY(differences(english, german).size() > 1000);
    change(QStringLiteral("en"));
    const QStringList back = differences(english, textsOf(*m_window));
    QVERIFY2(back.isEmpty(), firstOf(back).constData());
    m_window.reset();
    app::useLanguage(QStringLiteral("de"));
    openWindow();
    workOn();
    const QStringList unlike = differences(german, textsOf(*m_window));
    QVERIFY2(unlike.isEmpty(), firstOf(unlike).constData());
    m_window->actions().action("open")->setToolTip(QStringLiteral("Open a scene"));
    QVERIFY(!differences(german, textsOf(*m_window)).isEmpty());
}

void LanguageTest::nothingIsLost()
{
    workOn();
    widgets::EditorState& state = m_window->state();
    document().undoStack().setClean();
    state.setCamera(model::Camera::lookingAt({3.0F, 4.0F, 5.0F}, {1.0F, 0.0F, 0.0F}));
    const std::string before = bytes();
    const std::vector<model::IndividualId> people(state.selection().ids().begin(),
                                                  state.selection().ids().end());
    const auto places = state.paths().places();
    const double seconds = state.transport().seconds();
    const model::BrushSettings brush = *state.activeBrush();
    const model::Camera camera = state.camera();
    const QRect frame = m_window->geometry();
    const auto panels = placesOf(*m_window);
    change(QStringLiteral("de"));
    QCOMPARE(bytes(), before);
    QVERIFY(!document().isModified());
    QVERIFY(!m_window->isWindowModified());
    QCOMPARE(document().undoStack().count(), 1);
    QVERIFY(std::ranges::equal(state.selection().ids(), people));
    QVERIFY(state.paths().places() == places);
    QVERIFY(state.session().isRunning());
    QCOMPARE(state.transport().seconds(), seconds);
    QVERIFY(*state.activeBrush() == brush);
    QVERIFY(state.camera() == camera);
    QCOMPARE(m_window->geometry(), frame);
    QTRY_COMPARE(moved(panels, placesOf(*m_window)), QStringList());
    QCOMPARE(m_window->findChild<QListWidget*>(QStringLiteral("ruleList"))->currentRow(), 1);
    QVERIFY(m_window->viewport().problem().isEmpty());
    m_window->actions().action("undo")->trigger();
    QVERIFY(bytes() != before);
    m_window->actions().action("redo")->trigger();
    QCOMPARE(bytes(), before);
}

void LanguageTest::aFloatingPanelStaysWhereItIs()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    m_window->dockLayout().dock(app::DockId::Colour)->setFloating(true);
    m_window->dockLayout().dock(app::DockId::Colour)->move(200, 200);
    m_window->dockLayout().dock(app::DockId::Scene)->hide();
    m_window->dockLayout().dock(app::DockId::Rules)->show();
    const auto before = settledPlacesOf(*m_window);
    change(QStringLiteral("de"));
    QTRY_COMPARE(moved(before, placesOf(*m_window)), QStringList());
}

void LanguageTest::hiddenPanelsStayHidden()
{
    const auto before = settledPlacesOf(*m_window);
    m_window->dockLayout().setHidden(true);
    change(QStringLiteral("de"));
    for (const QDockWidget* dock : m_window->docks()) {
        QVERIFY2(dock->isHidden(), qPrintable(dock->objectName()));
    }
    QVERIFY(m_window->actions().action("hide-panels")->isChecked());
    m_window->dockLayout().setHidden(false);
    QTRY_COMPARE(moved(before, placesOf(*m_window)), QStringList());
}

/// With all that can be open beside the picture and below it.
void LanguageTest::thePanelsFitASmallScreen()
{
    constexpr int kSmall = 1280;
    for (const QString& language : {QStringLiteral("en"), QStringLiteral("de")}) {
        change(language);
        for (const app::DockId below : {app::DockId::Timeline, app::DockId::Rules}) {
            m_window->dockLayout().dock(below)->show();
            m_window->dockLayout().dock(below)->raise();
            m_window->resize(kSmall, 700);
            QTRY_VERIFY(m_window->dockLayout().dock(below)->width() > 0);
            const int least = m_window->minimumSizeHint().width();
            QVERIFY2(least <= kSmall,
                     qPrintable(QStringLiteral("%1: %2").arg(language).arg(least)));
        }
    }
}

void LanguageTest::pythonKeepsItsNames()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    const auto run = [this](const QString& line) {
        m_window->interpreter().run(line);
        QTRY_VERIFY_WITH_TIMEOUT(!m_window->interpreter().isRunning(), kPatienceMs);
    };
    const auto printed = [this] {
        return m_window->findChild<QPlainTextEdit*>(QStringLiteral("consoleOutput"))->toPlainText();
    };
    run(QStringLiteral("answer = 40 + len(scene); print('first line')"));
    QTRY_VERIFY(printed().contains(QStringLiteral("first line")));
    m_window->findChild<QPlainTextEdit*>(QStringLiteral("consoleInput"))
        ->setPlainText(QStringLiteral("len(sc"));
    m_window->console().setRecording(true);
    change(QStringLiteral("de"));
    QVERIFY(printed().startsWith(QStringLiteral("Die offene Szene")));
    QVERIFY(printed().contains(QStringLiteral("first line")));
    QCOMPARE(m_window->findChild<QPlainTextEdit*>(QStringLiteral("consoleInput"))->toPlainText(),
             QStringLiteral("len(sc"));
    QVERIFY(m_window->recorder().isRecording());
    QVERIFY(m_window->findChild<QPlainTextEdit*>(QStringLiteral("recordedScript"))->isVisible());
    run(QStringLiteral("print(answer)"));
    QTRY_VERIFY(printed().contains(QStringLiteral("42")));
}

void LanguageTest::aStrokeIsWaitedFor()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    auto edit = document().beginEdit().value();
    m_window->chooseLanguage(QStringLiteral("de"));
    QVERIFY(m_window->statusBar()->currentMessage().contains(QStringLiteral("language")));
    QTest::qWait(300);
    QCOMPARE(m_window->menuBar()->actions().front()->text(), QStringLiteral("&File"));
    QVERIFY(document().isEditOpen());
    edit.reset();
    QTRY_COMPARE(m_window->menuBar()->actions().front()->text(), QStringLiteral("&Datei"));
}

void LanguageTest::theMenuChoosesAndItIsRemembered()
{
    QVERIFY(entry(QStringLiteral("en")).isChecked());
    QCOMPARE(entry(QStringLiteral("de")).text(), QStringLiteral("Deutsch"));
    entry(QStringLiteral("de")).trigger();
    QTRY_COMPARE(m_window->menuBar()->actions().front()->text(), QStringLiteral("&Datei"));
    QTest::qWait(100); // the old menus are gone
    QVERIFY(entry(QStringLiteral("de")).isChecked());
    QCOMPARE(m_window->findChild<QDoubleSpinBox*>(QStringLiteral("playSpeed"))->text().right(3),
             QStringLiteral("1,0"));
    m_window.reset();
    app::useLanguage(app::Preferences::load().language); // as the program starts
    openWindow();
    QCOMPARE(m_window->menuBar()->actions().front()->text(), QStringLiteral("&Datei"));
    entry(QStringLiteral("en")).trigger();
    QTRY_COMPARE(m_window->menuBar()->actions().front()->text(), QStringLiteral("&File"));
    QCOMPARE(app::Preferences::load().language, QStringLiteral("en"));
}

void LanguageTest::preferencesChooseItToo()
{
    m_window->showPreferences();
    auto* dialog = m_window->findChild<app::PreferencesDialog*>();
    for (QComboBox* box : dialog->findChildren<QComboBox*>()) {
        box->setCurrentIndex(std::max(box->currentIndex(), box->findData(QStringLiteral("de"))));
    }
    QCOMPARE(app::languageInUse(), QStringLiteral("en"));
    dialog->accept();
    QTRY_COMPARE(m_window->menuBar()->actions().front()->text(), QStringLiteral("&Datei"));
}

void LanguageTest::qtSpeaksItToo()
{
    change(QStringLiteral("de"));
    const QDialogButtonBox buttons(QDialogButtonBox::Cancel);
    QCOMPARE(buttons.button(QDialogButtonBox::Cancel)->text(), QStringLiteral("Abbrechen"));
    QCOMPARE(QKeySequence(Qt::CTRL | Qt::Key_S).toString(QKeySequence::NativeText),
             QStringLiteral("Strg+S"));
    QCOMPARE(QKeySequence(Qt::CTRL | Qt::Key_Return).toString(QKeySequence::NativeText),
             QStringLiteral("Strg+Eingabe"));
    QStringList tips;
    for (const QToolButton* button :
         m_window->dockLayout().dock(app::DockId::Brushes)->findChildren<QToolButton*>()) {
        tips << button->toolTip();
    }
    QVERIFY(tips.filter(QStringLiteral("(Umschalt+R)")).size() == 1);
    QVERIFY(tips.filter(QStringLiteral("Shift")).isEmpty());
}

void LanguageTest::readyMadeScenesSpeakItToo()
{
    for (const QString& example : app::FileController::examples()) {
        const model::Scene scene = model::readProject(example).value();
        for (const std::string& name : names(scene)) {
            QVERIFY2(app::isReadyName(name), name.c_str());
        }
    }
    change(QStringLiteral("de"));
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(app::FileController::examples().front());
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 3 * kPatienceMs);
    const std::vector<std::string> german = names(document().scene());
    QVERIFY(std::ranges::count(german, "Tribüne links") == 1);
    QVERIFY2(std::ranges::none_of(german, app::isReadyName), "one has no German");
    QVERIFY(document().undoStack().isClean());
    QVERIFY(m_window->windowTitle().startsWith(QStringLiteral("Theater")));
    QCOMPARE(app::translatedName("Street lamp 12"), QStringLiteral("Straßenlampe 12"));
    QCOMPARE(app::translatedName("Stand 2b"), QStringLiteral("Stand 2b"));
}

CROWD_WINDOW_TEST(LanguageTest)
#include "tst_Language.moc"
