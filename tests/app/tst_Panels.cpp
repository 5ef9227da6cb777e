// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <QtCore/QSettings>
#include <QtCore/QTranslator>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QMenuBar>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QStatusBar>
#include <QtWidgets/QStyleOptionComboBox>
#include <QtWidgets/QToolBar>
#include <QtWidgets/QToolButton>

#include "app/window/MainWindow.h"
#include "app/window/Mnemonics.h"
#include "model/pick/StageRays.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"
#include "widgets/rules/CueBar.h"
#include "widgets/rules/RuleEditor.h"

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

/// Once nothing moves any more.
Layout settledLayout(const app::MainWindow& window)
{
    Layout before;
    Layout now = layoutOf(window);
    (void)QTest::qWaitFor([&] {
        QTest::qWait(200);
        before = std::exchange(now, layoutOf(window));
        return before == now;
    });
    return now;
}

/// Those that two entries of the same menu have, in the menus below too.
QStringList sharedMnemonics(const QList<QAction*>& actions)
{
    QStringList shared;
    std::map<QChar, QString> owners;
    for (const QAction* action : actions) {
        const QKeySequence mnemonic = QKeySequence::mnemonic(action->text());
        if (!mnemonic.isEmpty()) {
            const QChar key = mnemonic.toString().back();
            const auto [owner, isFirst] = owners.emplace(key, action->text());
            if (!isFirst) {
                shared << owner->second + QStringLiteral(" / ") + action->text();
            }
        }
        if (action->menu() != nullptr) {
            Q_EMIT action->menu()->aboutToShow(); // some are filled then
            shared += sharedMnemonics(action->menu()->actions());
        }
    }
    return shared;
}

/// A rule with one of everything that can be chosen.
model::Rule ruleOfEverything()
{
    model::Rule rule;
    rule.id = 1;
    rule.trigger = model::triggers::TagNear();
    for (std::size_t kind = 0; kind < model::kindsOf<model::ConditionData>().size(); ++kind) {
        model::Condition& condition = rule.conditions.emplace_back();
        condition.begin(kind);
        condition.isNot = true;
        std::visit(
            [](auto& each) {
                if constexpr (requires { each.value; }) {
                    each.value = -12.5F;
                }
            },
            condition.data);
    }
    for (std::size_t kind = 0; kind < model::kindsOf<model::ActionData>().size(); ++kind) {
        model::Action& action = rule.actions.emplace_back();
        action.begin(kind);
        std::visit(
            [](auto& each) {
                if constexpr (requires { each.choice; }) {
                    each.choice = model::PlaceChoice::NearestFree;
                }
                if constexpr (requires { each.aim; }) {
                    each.aim = model::ActionAim::Tagged;
                }
            },
            action.data);
    }
    return rule;
}

int roomFor(const QComboBox& box)
{
    QStyleOptionComboBox option;
    option.initFrom(&box);
    return box.style()
        ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box)
        .width();
}

/// What of a widget's words cannot be read; empty: nothing.
QString cutText(QWidget& widget)
{
    const auto beyond = [&widget](const QString& text, int room) {
        return widget.fontMetrics().horizontalAdvance(text) > room ? text : QString();
    };
    if (const auto* box = qobject_cast<QComboBox*>(&widget)) {
        return beyond(box->currentText(), roomFor(*box));
    }
    if (const auto* line = qobject_cast<QLineEdit*>(&widget)) {
        return beyond(line->text(), line->contentsRect().width());
    }
    if (const auto* label = qobject_cast<QLabel*>(&widget)) {
        return label->wordWrap() ? QString() : beyond(label->text(), label->width());
    }
    const auto* button = qobject_cast<QAbstractButton*>(&widget);
    const bool isCut = button != nullptr && button->width() < button->sizeHint().width();
    return isCut ? button->text() : QString();
}

QStringList cutTexts(const QDockWidget& dock)
{
    QStringList cut;
    for (QWidget* each : dock.findChildren<QWidget*>()) {
        if (each->isVisible() && !cutText(*each).isEmpty()) {
            cut << cutText(*each);
        }
    }
    if (const QString folder = qEnvironmentVariable("CROWD_PICTURES"); !folder.isEmpty()) {
        dock.findChild<QScrollArea*>()->widget()->grab().save(
            QStringLiteral("%1/%2_%3.png")
                .arg(folder, dock.objectName(), QLatin1String(QTest::currentDataTag())));
    }
    return cut;
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
        m_translator.reset();
    }

    void cueKeysActThoughTheWindowIsNotTheActiveOne();
    void cueKeysWorkThoughTheRulesWereNeverShown();
    void endedTypingGivesTheKeysBack_data();
    void endedTypingGivesTheKeysBack();
    void typingIntoAListGivesTheKeysBack();
    void aFieldThatVanishesGivesTheKeysBack();
    void whatIsTypedAtAFieldThatIsOffGoesNowhere();
    void whoRenamesGoesOnInTheList();
    void returnIsTheFieldsEvenWhileAPathIsPainted();
    void nothingTellsHowToBringBackWhatIsBack();
    void brushesAreRemembered();
    void damagedMemoryOfBrushesDoesNoHarm();
    void viewIsRememberedUntilTheLayoutIsReset();
    void mnemonicsOfAMenuAreUnique_data();
    void mnemonicsOfAMenuAreUnique();
    void mnemonicsThatAreTakenGoToFreeLetters();
    void rulesFitANarrowPanel_data();
    void rulesFitANarrowPanel();
    void rulesOpenWide();
    void placesFitANarrowPanel_data();
    void placesFitANarrowPanel();
    void smallWindowCutsNothingOff_data();
    void smallWindowCutsNothingOff();
    void charactersFitANarrowPanel_data();
    void charactersFitANarrowPanel();
    void takesHaveRoomWhileTheyAreInFront();
    void resetLayoutIsThatOfTheFirstStart();
    void opensWithinTheScreen();
    void everythingOfAnEmptyTheatreShowsItsSeats();

private:
    [[nodiscard]] QLineEdit* eventField();
    /// The window in a language; with it, its panels speak it.
    void openWindowIn(const QString& language);

    std::unique_ptr<QTranslator> m_translator;
};

/// Of the event brush: the name of the event.
QLineEdit* PanelsTest::eventField()
{
    m_window->state().setTool(widgets::ToolId::BrushEvent);
    QLineEdit* found = nullptr;
    (void)QTest::qWaitFor([&] {
        for (auto* line :
             m_window->dockLayout().dock(app::DockId::BrushSettings)->findChildren<QLineEdit*>()) {
            found = line->isVisible() && line->text() == QLatin1String("cheer") ? line : found;
        }
        return found != nullptr;
    });
    return found;
}

void PanelsTest::openWindowIn(const QString& language)
{
    m_window.reset();
    m_translator = std::make_unique<QTranslator>();
    QVERIFY(m_translator->load(QStringLiteral(":/translations/crowdbrush_%1.qm").arg(language)));
    QCoreApplication::installTranslator(m_translator.get());
    openWindow();
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

void PanelsTest::cueKeysWorkThoughTheRulesWereNeverShown()
{
    model::Scene scene = plainScene(1);
    scene.cues.push_back({1, {}, "clap", 0.0F, "F3"});
    model::Rule rule;
    rule.id = 1;
    rule.trigger = model::triggers::Event{"clap"};
    rule.actions.emplace_back(model::actions::AddTag());
    scene.rules = {rule};
    openScene(scene, QStringLiteral("a.crowd"));
    QVERIFY(m_window->dockLayout().dock(app::DockId::Rules)->visibleRegion().isEmpty());
    m_window->state().transport().setPlaying(true);
    QTRY_VERIFY(m_window->state().session().isRunning());
    QTest::keyClick(m_window->windowHandle(), Qt::Key_F3);
    QVERIFY2(m_window->statusBar()->currentMessage().contains(QStringLiteral("clap")),
             qPrintable(m_window->statusBar()->currentMessage()));
    QTRY_COMPARE(m_window->state().session().firedCount(1), std::uint64_t{1});
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
    QCOMPARE(
        m_window->state().brush(model::BrushKind::Event).as<crowd::model::EventSettings>().name,
        name.toStdString());
    QTest::keyClick(m_window->windowHandle(), Qt::Key_B);
    QCOMPARE(m_window->state().tool(), widgets::ToolId::BrushColour);
}

/// Ctrl+Z afterwards is the document's.
void PanelsTest::typingIntoAListGivesTheKeysBack()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    QDockWidget* panel = m_window->dockLayout().dock(app::DockId::Features);
    panel->show();
    panel->raise();
    auto* values = panel->findChild<QListWidget*>(QStringLiteral("features"));
    values->setCurrentItem(values->findItems(QStringLiteral("sad"), Qt::MatchExactly).front());
    QComboBox* clip = nullptr;
    QTRY_VERIFY([&] {
        for (QComboBox* each : panel->findChildren<QComboBox*>()) {
            clip = each->isEditable() && each->isVisible() && clip == nullptr ? each : clip;
        }
        return clip != nullptr;
    }());
    const int steps = document().undoStack().index();
    clip->setFocus();
    clip->lineEdit()->selectAll();
    QTest::keyClicks(clip, QStringLiteral("weep"));
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Return);
    QTRY_VERIFY(m_window->viewport().hasFocus());
    QTRY_COMPARE(document().undoStack().index(), steps + 1);
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(document().undoStack().index(), steps);
    QVERIFY2(m_window->statusBar()->currentMessage().contains(QStringLiteral("Undone")),
             qPrintable(m_window->statusBar()->currentMessage()));
}

void PanelsTest::aFieldThatVanishesGivesTheKeysBack()
{
    QDockWidget* panel = m_window->dockLayout().dock(app::DockId::Presets);
    panel->show();
    panel->raise();
    auto* search = panel->findChild<QLineEdit*>();
    QTRY_VERIFY(search->isVisible());
    QTest::mouseClick(search, Qt::LeftButton);
    QTRY_VERIFY(search->hasFocus());
    QTest::keyClicks(search, QStringLiteral("red"));
    const QList<QDockWidget*> beside = m_window->tabifiedDockWidgets(panel);
    QVERIFY(!beside.isEmpty());
    beside.front()->raise();
    QTRY_VERIFY(search->visibleRegion().isEmpty());
    QTRY_VERIFY(m_window->viewport().hasFocus());
    QTest::keyClick(m_window->windowHandle(), Qt::Key_B);
    QCOMPARE(m_window->state().tool(), widgets::ToolId::BrushColour);
}

void PanelsTest::whatIsTypedAtAFieldThatIsOffGoesNowhere()
{
    openScene(plainScene(3), QStringLiteral("a.crowd"));
    QLineEdit* field = eventField();
    QVERIFY(field != nullptr);
    const widgets::ToolId tool = m_window->state().tool();
    field->setEnabled(false);
    m_window->dockLayout()
        .dock(app::DockId::BrushSettings)
        ->findChild<QScrollArea*>()
        ->ensureWidgetVisible(field);
    const auto clickAt = [this](const QWidget& widget) {
        const QPoint at = widget.mapTo(m_window.get(), widget.rect().center());
        QTest::mouseClick(m_window->windowHandle(), Qt::LeftButton, {}, at);
    };
    clickAt(*field);
    QTest::keyClick(m_window->windowHandle(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(m_window->windowHandle(), Qt::Key_B);
    QVERIFY(m_window->state().selection().isEmpty());
    QCOMPARE(m_window->state().tool(), tool);
    QVERIFY2(m_window->statusBar()->currentMessage().contains(QStringLiteral("cannot be changed")),
             qPrintable(m_window->statusBar()->currentMessage()));
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Escape); // he gives up
    QTest::keyClick(m_window->windowHandle(), Qt::Key_A, Qt::ControlModifier);
    QTRY_COMPARE(m_window->state().selection().size(), std::size_t{3});
    clickAt(*field);
    QTest::keyClick(m_window->windowHandle(), Qt::Key_B);
    QCOMPARE(m_window->state().tool(), tool);
    const QPointF over(9.0, 9.0);
    QEnterEvent back(over, over, over); // the hand comes back over the picture
    QApplication::sendEvent(&m_window->viewport(), &back);
    QTest::keyClick(m_window->windowHandle(), Qt::Key_B);
    QTRY_COMPARE(m_window->state().tool(), widgets::ToolId::BrushColour);
}

void PanelsTest::whoRenamesGoesOnInTheList()
{
    openScene(plainScene(3), QStringLiteral("a.crowd"));
    QDockWidget* panel = m_window->dockLayout().dock(app::DockId::Relations);
    panel->show();
    panel->raise();
    auto* kinds = panel->findChild<QListWidget*>(QStringLiteral("relationKinds"));
    QTRY_VERIFY(kinds->isVisible());
    kinds->setCurrentRow(1);
    kinds->setFocus();
    QTest::keyClick(m_window->windowHandle(), Qt::Key_F2);
    QLineEdit* field = nullptr;
    QTRY_VERIFY((field = kinds->findChild<QLineEdit*>()) != nullptr);
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("pals"));
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Return);
    QTRY_COMPARE(document().scene().relationKinds[1].name, std::string("pals"));
    QTRY_VERIFY(kinds->hasFocus());
    QTRY_VERIFY(kinds->findChild<QLineEdit*>() == nullptr);
    QTest::keyClick(m_window->windowHandle(), Qt::Key_F2); // once more
    QTRY_VERIFY(kinds->findChild<QLineEdit*>() != nullptr);
    QTest::keyClick(m_window->windowHandle(), Qt::Key_Escape);
    QTRY_VERIFY(kinds->hasFocus());
    QTest::keyClick(m_window->windowHandle(), Qt::Key_B); // brushes have their keys all the same
    QCOMPARE(m_window->state().tool(), widgets::ToolId::BrushColour);
}

void PanelsTest::returnIsTheFieldsEvenWhileAPathIsPainted()
{
    openScene(plainScene(1), QStringLiteral("a.crowd"));
    {
        const auto edit = document().beginEdit().value();
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
    QCOMPARE(
        m_window->state().brush(model::BrushKind::Event).as<crowd::model::EventSettings>().name,
        std::string("wave"));
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
    create.as<crowd::model::CreateSettings>().height = {0.75F, 1.25F};
    create.as<crowd::model::CreateSettings>().palette = {{1, 2, 3}, {200, 100, 50}};
    create.as<crowd::model::CreateSettings>().clips = {{"idle", 0.5F}};
    create.as<crowd::model::CreateSettings>().mix = {{9, 1.0F}};
    create.distribution.weights[3] = 0.25F;
    state.setBrush(create);
    model::BrushSettings walk = state.brush(BrushKind::Walk);
    walk.as<crowd::model::WalkSettings>().speed = {2.0F, 3.5F};
    walk.as<crowd::model::WalkSettings>().path = 7;
    state.setBrush(walk);
    model::BrushSettings exits = state.brush(BrushKind::Environment);
    exits.place()->anywhere = true;
    exits.as<crowd::model::EnvironmentSettings>().role = model::PlaceRole::Exit;
    state.setBrush(exits);
    const model::BrushSettings untouched = state.brush(BrushKind::Orientation);
    QVERIFY(m_window->close());
    openWindow();
    const model::BrushSettings& after = m_window->state().brush(BrushKind::Create);
    QVERIFY2(after.as<crowd::model::CreateSettings>().mix !=
                 create.as<crowd::model::CreateSettings>().mix,
             "templates are of a scene");
    create.as<crowd::model::CreateSettings>().mix = after.as<crowd::model::CreateSettings>().mix;
    QVERIFY(after == create);
    const model::WalkSettings& walking =
        m_window->state().brush(BrushKind::Walk).as<crowd::model::WalkSettings>();
    QCOMPARE(walking.speed, (model::ValueRange{2.0F, 3.5F}));
    QVERIFY2(walking.path != 7, "paths are of a scene");
    QVERIFY(m_window->state().brush(BrushKind::Environment).place()->anywhere);
    QVERIFY(!m_window->state().brush(BrushKind::Path).place()->anywhere);
    QVERIFY(m_window->state().brush(BrushKind::Orientation) == untouched);
    m_window->actions().action("brush-reset")->trigger();
    QCOMPARE(m_window->state().brush(BrushKind::Create).radiusPixels,
             model::initialBrush(BrushKind::Create).radiusPixels);
}

void PanelsTest::damagedMemoryOfBrushesDoesNoHarm()
{
    const model::BrushSettings before = m_window->state().brush(model::BrushKind::Colour);
    QVERIFY(m_window->close());
    QSettings settings;
    settings.setValue(QStringLiteral("brushes/brush-create"), QByteArray("{\"radius\": 1e30, "));
    settings.setValue(QStringLiteral("brushes/brush-colour"),
                      QByteArray(R"({"radius": 1e30, "rate": "many", "selection": 99,
                                     "colors": [], "operator": -4})"));
    settings.sync();
    openWindow();
    model::BrushSettings colour = m_window->state().brush(model::BrushKind::Colour);
    QCOMPARE(colour.radiusPixels, before.radiusPixels); // what is wrong is as if it were not there
    QVERIFY(!colour.as<crowd::model::ColourSettings>().colors.empty());
    colour.as<crowd::model::ColourSettings>() = before.as<crowd::model::ColourSettings>();
    QVERIFY(colour == before);
}

void PanelsTest::viewIsRememberedUntilTheLayoutIsReset()
{
    const widgets::ViewOptions fresh = m_window->state().viewOptions();
    for (const char* id : {"ground-grid", "shadows", "paths", "tags", "walkable", "look-lit"}) {
        m_window->actions().action(id)->trigger();
    }
    const widgets::ViewOptions chosen = m_window->state().viewOptions();
    QVERIFY(chosen.showTags && !chosen.showGroundGrid && !chosen.showShadows && !chosen.showPaths);
    QVERIFY(chosen.showWalkable && chosen.look == render::Look::Plain);
    QVERIFY(m_window->close());
    openWindow();
    QVERIFY(m_window->state().viewOptions() == chosen);
    QVERIFY(!m_window->actions().action("paths")->isChecked());
    m_window->actions().action("reset-layout")->trigger();
    QVERIFY(m_window->state().viewOptions() == fresh);
    QVERIFY(m_window->actions().action("paths")->isChecked());
    QVERIFY(m_window->close());
    openWindow();
    QVERIFY(m_window->state().viewOptions() == fresh);
}

void PanelsTest::mnemonicsOfAMenuAreUnique_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << QStringLiteral("en");
    QTest::newRow("German") << QStringLiteral("de");
}

void PanelsTest::mnemonicsOfAMenuAreUnique()
{
    QFETCH(QString, language);
    openWindowIn(language);
    const QStringList shared = sharedMnemonics(m_window->menuBar()->actions());
    QVERIFY2(shared.isEmpty(), qPrintable(shared.join(QStringLiteral("; "))));
}

void PanelsTest::mnemonicsThatAreTakenGoToFreeLetters()
{
    QMenu menu;
    const auto* first = menu.addAction(QStringLiteral("&Group"));
    const auto* second = menu.addAction(QStringLiteral("&Grow && Go"));
    const auto* third = menu.addAction(QStringLiteral("&G"));
    QMenu* inside = menu.addMenu(QStringLiteral("&More"));
    const auto* fourth = inside->addAction(QStringLiteral("&Grow"));
    app::setMnemonicsApart(menu.actions());
    QCOMPARE(first->text(), QStringLiteral("&Group"));
    QCOMPARE(second->text(), QStringLiteral("G&row && Go"));
    QCOMPARE(third->text(), QStringLiteral("G"));
    QCOMPARE(fourth->text(), QStringLiteral("&Grow")); // another menu
}

void PanelsTest::rulesFitANarrowPanel_data()
{
    mnemonicsOfAMenuAreUnique_data();
}

void PanelsTest::rulesFitANarrowPanel()
{
    QFETCH(QString, language);
    openWindowIn(language);
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    {
        const auto edit = document().beginEdit().value();
        model::Place place;
        place.name = "Place 3";
        place.id = edit->addPlace(place);
        edit->changePlace(place);
        edit->setRules({ruleOfEverything()});
        edit->setNumbers({{1, "patience"}});
        edit->setCues({{1, {}, "clap", 0.0F, "F3"}});
        edit->commit(QStringLiteral("Rules"));
    }
    QDockWidget* dock = m_window->dockLayout().dock(app::DockId::Rules);
    QCOMPARE(dock->objectName(), QStringLiteral("rules"));
    m_window->addDockWidget(Qt::RightDockWidgetArea, dock);
    dock->show();
    m_window->resizeDocks({dock}, {10}, Qt::Horizontal); // as narrow as it goes
    auto* list = dock->findChild<QListWidget*>(QStringLiteral("ruleList"));
    QTRY_COMPARE(list->count(), 1);
    list->setCurrentRow(0);
    QTRY_VERIFY(dock->findChild<widgets::RuleEditor*>() != nullptr);
    QTest::qWait(100);
    QStringList widths; // whose fault it is
    for (const QDockWidget* each : m_window->docks()) {
        widths
            << QStringLiteral("%1 %2").arg(each->objectName()).arg(each->minimumSizeHint().width());
    }
    QVERIFY2(dock->width() <= 290, qPrintable(widths.join(QStringLiteral(", "))));
    const QStringList cut = cutTexts(*dock);
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QStringLiteral(" | "))));
}

/// Where they come: below the picture, with list, chosen rule and log side by side.
void PanelsTest::rulesOpenWide()
{
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    {
        const auto edit = document().beginEdit().value();
        edit->setRules({ruleOfEverything()});
        edit->commit(QStringLiteral("Rules"));
    }
    m_window->resize(1600, 900);
    QAction* action = m_window->actions().action("rules");
    QVERIFY(!action->isChecked());
    action->trigger();
    QVERIFY(action->isChecked());
    QDockWidget* dock = m_window->dockLayout().dock(app::DockId::Rules);
    auto* list = dock->findChild<QListWidget*>(QStringLiteral("ruleList"));
    auto* log = dock->findChild<QWidget*>(QStringLiteral("ruleLog"));
    QTRY_COMPARE(list->count(), 1);
    list->setCurrentRow(0);
    QTRY_VERIFY(dock->findChild<widgets::RuleEditor*>() != nullptr);
    const auto* editor = dock->findChild<widgets::RuleEditor*>();
    const auto placeOf = [dock](const QWidget* widget) {
        return QRect(widget->mapTo(dock, QPoint()), widget->size());
    };
    QVERIFY2(dock->width() >= 640, qPrintable(QString::number(dock->width())));
    QTRY_VERIFY(placeOf(editor).left() > placeOf(list).right());
    QVERIFY(placeOf(log).left() > placeOf(editor).right());
    // A list of cues would leave a low panel's list of rules no room.
    const auto* cues = dock->findChild<widgets::CueBar*>();
    QVERIFY(placeOf(cues).left() > placeOf(editor).right());
    m_window->addDockWidget(Qt::RightDockWidgetArea, dock);
    QTRY_VERIFY(placeOf(cues).bottom() < placeOf(list).top());
    m_window->addDockWidget(Qt::BottomDockWidgetArea, dock);
    QTRY_VERIFY(placeOf(cues).left() > placeOf(editor).right());
    QStringList cut;
    QVERIFY2(QTest::qWaitFor([&] { return (cut = cutTexts(*dock)).isEmpty(); }),
             qPrintable(cut.join(QStringLiteral(" | "))));
    dock->close();
    QTRY_VERIFY(!action->isChecked());
}

void PanelsTest::placesFitANarrowPanel_data()
{
    mnemonicsOfAMenuAreUnique_data();
}

void PanelsTest::placesFitANarrowPanel()
{
    QFETCH(QString, language);
    openWindowIn(language);
    openScene(plainScene(2), QStringLiteral("a.crowd"));
    model::PathId path = 0;
    model::PlaceId slow = 0;
    {
        const auto edit = document().beginEdit().value();
        model::Place place;
        place.name = "Place 3";
        place.position = {-12.25F, 0.0F, 105.5F};
        place.role = model::PlaceRole::Slow;
        slow = edit->addPlace(place);
        model::Path way;
        way.name = "Path 1";
        way.places = {slow};
        path = edit->addPath(way);
        edit->commit(QStringLiteral("Path"));
    }
    QDockWidget* dock = m_window->dockLayout().dock(app::DockId::Environment);
    QCOMPARE(dock->objectName(), QStringLiteral("environment"));
    dock->raise();
    m_window->resizeDocks({dock}, {10}, Qt::Horizontal);
    for (QAbstractButton* fold : dock->findChildren<QAbstractButton*>()) {
        if (fold->objectName() == QLatin1String("foldSurface")) {
            fold->click();
        }
    }
    for (const bool isPlace : {true, false}) {
        m_window->state().paths().look(path);
        m_window->state().paths().select(isPlace ? std::vector{slow}
                                                 : std::vector<model::PlaceId>());
        QTest::qWait(100);
        const QStringList cut = cutTexts(*dock);
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QStringLiteral(" | "))));
    }
}

void PanelsTest::smallWindowCutsNothingOff_data()
{
    mnemonicsOfAMenuAreUnique_data();
}

void PanelsTest::smallWindowCutsNothingOff()
{
    QFETCH(QString, language);
    openWindowIn(language);
    auto* bar = m_window->findChild<QToolBar*>(QStringLiteral("toolBar"));
    m_window->resize(1600, 700);
    QTRY_COMPARE(m_window->width(), 1600);
    const int icons = bar->iconSize().width();
    m_window->resize(1024, 700);
    QTRY_COMPARE(m_window->width(), 1024);
    QTest::qWait(100);
    const auto* speed = bar->findChild<QWidget*>(QStringLiteral("playSpeed"));
    QVERIFY(speed->isVisible());
    QVERIFY(bar->rect().contains(speed->geometry()));
    const auto* palette = m_window->dockLayout().dock(app::DockId::Brushes);
    for (const QToolButton* button : palette->findChildren<QToolButton*>()) {
        const QRect place(button->mapTo(palette, QPoint()), button->size());
        const bool isElsewhere = button->objectName().isEmpty() || // of the title
                                 button->objectName() == QLatin1String("brush-script") ||
                                 button->objectName().startsWith(QLatin1String("qt_"));
        QVERIFY2(isElsewhere || (button->isVisible() && palette->rect().contains(place)),
                 qPrintable(button->objectName()));
    }
    const auto* hint = m_window->viewport().findChild<QWidget*>(QStringLiteral("welcomeHint"));
    QVERIFY2(m_window->viewport().rect().contains(hint->geometry()),
             qPrintable(QString::number(m_window->viewport().width())));
    QVERIFY2(hint->y() > m_window->viewport().height() / 2, "legends are above");
    const auto* work = m_window->viewport().findChild<QWidget*>(QStringLiteral("workBar"));
    QVERIFY(!work->geometry().intersects(hint->geometry()));
    m_window->state().setTool(widgets::ToolId::BrushColour);
    QVERIFY(!hint->isVisible()); // it tells of another brush
    m_window->state().setTool(widgets::ToolId::BrushCreate);
    QVERIFY(hint->isVisible());
    const auto* text = hint->findChild<QLabel*>();
    QVERIFY(text->height() >= text->heightForWidth(text->width()));
    m_window->resize(1600, 700);
    QTRY_COMPARE(bar->iconSize().width(), icons);
    m_window->state().showStatus(QString(400, QLatin1Char('x'))); // drawn shortened
    QCOMPARE(m_window->statusBar()->toolTip().size(), 400);
}

void PanelsTest::charactersFitANarrowPanel_data()
{
    mnemonicsOfAMenuAreUnique_data();
}

void PanelsTest::charactersFitANarrowPanel()
{
    QFETCH(QString, language);
    openWindowIn(language);
    const QStringList examples = app::FileController::examples();
    const auto city = std::ranges::find_if(
        examples, [](const QString& each) { return each.endsWith(QLatin1String("city.crowd")); });
    QVERIFY(city != examples.end());
    QSignalSpy opened(&m_window->files(), &app::FileController::sceneOpened);
    m_window->files().openPath(*city);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 6 * kPatienceMs);
    QDockWidget* dock = m_window->dockLayout().dock(app::DockId::Individual);
    QCOMPARE(dock->objectName(), QStringLiteral("individual"));
    dock->raise();
    const auto ids = document().scene().population.ids();
    const std::vector<model::IndividualId> all(ids.begin(), ids.end());
    for (const std::vector<model::IndividualId>& who : {std::vector{all.front()}, all}) {
        m_window->state().selection().set(who);
        QTest::qWait(200);
        for (const int width : {0, 290}) { // that of the first start, and as narrow as it goes
            if (width > 0) {
                m_window->resizeDocks({dock}, {10}, Qt::Horizontal);
                QTest::qWait(100);
                QVERIFY2(dock->width() <= width, qPrintable(QString::number(dock->width())));
            }
            const auto* area = dock->findChild<QScrollArea*>();
            QTRY_VERIFY(area->widget()->width() <= area->viewport()->width());
            QStringList cut; // until it is laid out, all are
            (void)QTest::qWaitFor([&] { return (cut = cutTexts(*dock)).isEmpty(); });
            QVERIFY2(cut.isEmpty(), qPrintable(cut.join(QStringLiteral(" | "))));
        }
    }
}

/// Lists, and what is set below them, want more room than the panels that they are behind.
void PanelsTest::takesHaveRoomWhileTheyAreInFront()
{
    const auto& layout = m_window->dockLayout();
    m_window->resize(1280, 1000);
    const Layout before = settledLayout(*m_window);
    const int others = before.at(layout.dock(app::DockId::Colour)->objectName()).height();
    QDockWidget* takes = layout.dock(app::DockId::Takes);
    takes->show();
    takes->raise();
    QTRY_VERIFY2(takes->height() > others + 60, qPrintable(QString::number(takes->height())));
    layout.dock(app::DockId::Colour)->raise();
    QTRY_VERIFY2(layout.dock(app::DockId::Colour)->height() < others + 30,
                 qPrintable(QString::number(layout.dock(app::DockId::Colour)->height())));
}

void PanelsTest::resetLayoutIsThatOfTheFirstStart()
{
    const Layout first = settledLayout(*m_window);
    const app::DockLayout& layout = m_window->dockLayout();
    layout.dock(app::DockId::Brushes)->hide();
    layout.dock(app::DockId::BrushSettings)->setFloating(true);
    m_window->addDockWidget(Qt::LeftDockWidgetArea, layout.dock(app::DockId::Colour));
    layout.dock(app::DockId::Rules)->show();
    m_window->resizeDocks({layout.dock(app::DockId::Templates)}, {420}, Qt::Horizontal);
    QTest::qWait(200);
    QVERIFY(layoutOf(*m_window) != first);
    m_window->actions().action("reset-layout")->trigger();
    const Layout after = settledLayout(*m_window);
    for (const auto& [name, place] : first) {
        QCOMPARE(std::pair(name, after.at(name)), std::pair(name, place));
    }
}

/// Also a moment later, when the panels have been laid out, and the next time.
void PanelsTest::opensWithinTheScreen()
{
    for (int start = 0; start < 2; ++start) {
        m_window->close(); // which remembers where it was
        if (start == 0) {
            QSettings().clear(); // the very first time
        }
        m_window = std::make_unique<app::MainWindow>();
        m_window->show();
        m_window->files().openPath(QStringLiteral(CROWD_RESOURCES "/scenes/theatre.crowd"));
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        QTRY_VERIFY_WITH_TIMEOUT(document().scene().population.size() > 0, 3 * kPatienceMs);
        QTest::qWait(500); // what would enlarge it comes late
        const QRect screen = m_window->screen()->availableGeometry();
        QVERIFY2(
            screen.contains(m_window->geometry()),
            qPrintable(QStringLiteral("%1 × %2").arg(m_window->width()).arg(m_window->height())));
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
