// SPDX-License-Identifier: MIT
#include <QtTest/QTest>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QToolButton>

#include "app/window/MainWindow.h"
#include "model/scene/Scene.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::testing;

namespace {

model::Scene sceneWithRuleAndLight()
{
    model::Scene scene = plainScene(3);
    model::Rule rule;
    rule.id = 1;
    scene.rules.push_back(rule);
    model::Light light;
    light.id = 1;
    scene.lights.push_back(light);
    return scene;
}

} // namespace

/// Keys that a list of a panel and the window both have actions for, while people are selected.
class TestOwnKeys : public QObject, private SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    static void initTestCase() { prepare("OwnKeys"); }
    void init() { begin(); }
    void cleanup();
    void deleteInAListIsTheLists();
    void duplicateInTheRulesIsTheirs();
    void elsewhereTheyAreTheWindows();

private:
    /// That list, in front and with the focus, and everybody selected.
    QListWidget* focused(const char* dock, const char* list);
    [[nodiscard]] std::size_t people() const { return document().scene().population.size(); }
};

void TestOwnKeys::cleanup()
{
    document().undoStack().setClean();
    m_window.reset();
}

QListWidget* TestOwnKeys::focused(const char* dock, const char* list)
{
    auto* panel = m_window->findChild<QDockWidget*>(QLatin1String(dock));
    auto* found = panel->findChild<QListWidget*>(QLatin1String(list));
    panel->show();
    panel->raise();
    m_window->state().selection().selectAll();
    // Panels fill their lists when they come to show themselves.
    if (!QTest::qWaitFor([found] { return found->count() > 0; })) {
        return found;
    }
    found->setCurrentRow(0);
    found->setFocus();
    return found;
}

void TestOwnKeys::deleteInAListIsTheLists()
{
    openScene(sceneWithRuleAndLight(), QStringLiteral("delete.crowd"));
    QListWidget* rules = focused("rules", "ruleList");
    QTRY_VERIFY(rules->hasFocus());
    QTest::keyClick(rules, Qt::Key_Delete);
    QTRY_VERIFY(document().scene().rules.empty());
    QCOMPARE(people(), std::size_t{3});
    // Nothing is left there to be removed: that is no order to remove the people.
    QTest::keyClick(rules, Qt::Key_Delete);
    QCOMPARE(people(), std::size_t{3});
    QListWidget* lights = focused("light", "lights");
    QTRY_VERIFY(lights->hasFocus());
    lights->setCurrentRow(1); // below the sun
    QTest::keyClick(lights, Qt::Key_Delete);
    QTRY_VERIFY(document().scene().lights.empty());
    QCOMPARE(people(), std::size_t{3});
}

void TestOwnKeys::duplicateInTheRulesIsTheirs()
{
    openScene(sceneWithRuleAndLight(), QStringLiteral("duplicate.crowd"));
    QListWidget* rules = focused("rules", "ruleList");
    QTRY_VERIFY(rules->hasFocus());
    QTest::keyClick(rules, Qt::Key_D, Qt::ControlModifier);
    QTRY_COMPARE(document().scene().rules.size(), std::size_t{2});
    QCOMPARE(people(), std::size_t{3});
}

void TestOwnKeys::elsewhereTheyAreTheWindows()
{
    openScene(sceneWithRuleAndLight(), QStringLiteral("elsewhere.crowd"));
    QListWidget* rules = focused("rules", "ruleList");
    QTRY_VERIFY(rules->hasFocus());
    QWidget* view = m_window->centralWidget();
    view->setFocus();
    QTRY_VERIFY(view->hasFocus());
    QTest::keyClick(view, Qt::Key_Delete);
    QTRY_COMPARE(people(), std::size_t{0});
    QCOMPARE(document().scene().rules.size(), std::size_t{1});
}

CROWD_WINDOW_TEST(TestOwnKeys)
#include "tst_OwnKeys.moc"
