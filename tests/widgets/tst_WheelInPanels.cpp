// SPDX-License-Identifier: MIT
#include <QtGui/QWheelEvent>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QSlider>
#include <QtWidgets/QSpinBox>

#include "model/document/SceneEdit.h"
#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/docks/RulesDock.h"
#include "widgets/theme/Theme.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Desk;

namespace {

/// One notch towards the hand, over the middle of a field, as the window system reports it.
void turnWheelOver(QWidget& field)
{
    const QPoint middle = field.rect().center();
    QWidget* inner = field.childAt(middle);
    QWidget& under = inner == nullptr ? field : *inner;
    const QPointF at = under.mapFrom(&field, middle);
    QWheelEvent event(at, under.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(&under, &event);
}

/// A panel that is higher than its window, with fields at the top.
struct Panel
{
    Panel()
    {
        auto* content = new QWidget;
        content->setFixedSize(200, 2000);
        number = new QDoubleSpinBox(content);
        number->setValue(5.0);
        whole = new QSpinBox(content);
        whole->setValue(5);
        choice = new QComboBox(content);
        choice->addItems({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")});
        choice->setCurrentIndex(1);
        typed = new QComboBox(content);
        typed->setEditable(true);
        typed->addItems({QStringLiteral("a"), QStringLiteral("b"), QStringLiteral("c")});
        typed->setCurrentIndex(1);
        slider = new QSlider(Qt::Horizontal, content);
        slider->setValue(50);
        int top = 0;
        for (QWidget* field : {static_cast<QWidget*>(number), static_cast<QWidget*>(whole),
                               static_cast<QWidget*>(choice), static_cast<QWidget*>(typed),
                               static_cast<QWidget*>(slider)}) {
            field->setGeometry(0, top, 150, 28);
            top += 30;
        }
        area.setWidget(content);
        area.resize(240, 300);
        area.show();
    }
    [[nodiscard]] int scrolled() const { return area.verticalScrollBar()->value(); }
    [[nodiscard]] QWidget* field(const QString& name) const
    {
        return name == QStringLiteral("number")   ? static_cast<QWidget*>(number)
               : name == QStringLiteral("whole")  ? static_cast<QWidget*>(whole)
               : name == QStringLiteral("choice") ? static_cast<QWidget*>(choice)
               : name == QStringLiteral("typed")  ? static_cast<QWidget*>(typed)
                                                  : static_cast<QWidget*>(slider);
    }
    [[nodiscard]] double sum() const
    {
        return number->value() + whole->value() + choice->currentIndex() + typed->currentIndex() +
               slider->value();
    }

    QScrollArea area;
    QDoubleSpinBox* number;
    QSpinBox* whole;
    QComboBox* choice;
    QComboBox* typed;
    QSlider* slider;
};

} // namespace

class TestWheelInPanels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void theWheelOverAFieldScrollsThePanel_data();
    void theWheelOverAFieldScrollsThePanel();
    void aFieldWithTheKeyboardTakesTheWheel_data();
    void aFieldWithTheKeyboardTakesTheWheel();
    void aListWithTheKeyboardDoesNot();
    void itHoldsAfterAnotherThemeWasChosen();
    void scrollingTheRulesChangesNone();
};

void TestWheelInPanels::initTestCase()
{
    applyTheme(Theme::Light);
}

void TestWheelInPanels::theWheelOverAFieldScrollsThePanel_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"number", "whole", "choice", "typed", "slider"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

void TestWheelInPanels::theWheelOverAFieldScrollsThePanel()
{
    QFETCH(const QString, name);
    Panel panel;
    QVERIFY(QTest::qWaitForWindowExposed(&panel.area));
    panel.area.widget()->setFocus();
    const double before = panel.sum();
    turnWheelOver(*panel.field(name));
    QCOMPARE(panel.sum(), before);
    QVERIFY(panel.scrolled() > 0);
    QVERIFY(!panel.field(name)->hasFocus()); // or the next notch would change it
}

void TestWheelInPanels::aFieldWithTheKeyboardTakesTheWheel_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"number", "whole", "slider"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

/// One has just chosen from it, and goes on reading the panel.
void TestWheelInPanels::aListWithTheKeyboardDoesNot()
{
    for (const char* name : {"choice", "typed"}) {
        Panel panel;
        panel.area.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&panel.area));
        QWidget* field = panel.field(QLatin1String(name));
        field->setFocus();
        QTRY_VERIFY(field->hasFocus());
        const double before = panel.sum();
        turnWheelOver(*field);
        QCOMPARE(panel.sum(), before);
        QVERIFY(panel.scrolled() > 0);
    }
}

void TestWheelInPanels::aFieldWithTheKeyboardTakesTheWheel()
{
    QFETCH(const QString, name);
    Panel panel;
    panel.area.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel.area));
    QWidget* field = panel.field(name);
    field->setFocus();
    QTRY_VERIFY(field->hasFocus());
    const double before = panel.sum();
    turnWheelOver(*field);
    QVERIFY(panel.sum() != before);
    QCOMPARE(panel.scrolled(), 0);
}

void TestWheelInPanels::itHoldsAfterAnotherThemeWasChosen()
{
    Panel panel;
    QVERIFY(QTest::qWaitForWindowExposed(&panel.area));
    applyTheme(Theme::Dark);
    panel.area.widget()->setFocus();
    const double before = panel.sum();
    turnWheelOver(*panel.number);
    QCOMPARE(panel.sum(), before);
    QVERIFY(panel.scrolled() > 0);
    applyTheme(Theme::Light);
}

/// Over each of the fields that a rule is made of.
void TestWheelInPanels::scrollingTheRulesChangesNone()
{
    Desk<RulesDock> desk;
    QVERIFY(desk.isReady());
    desk.window.resize(300, 300);
    model::Rule rule;
    rule.id = 1;
    rule.trigger = model::triggers::Event{"go"};
    rule.actions = {model::actions::Wait{0.3F}};
    rule.conditions.emplace_back(model::conditions::Chance());
    auto edit = desk.document.beginEdit().value();
    edit->setRules({rule});
    edit->commit(QStringLiteral("Rule"));
    auto* list = desk.dock->findChild<QListWidget*>();
    QTRY_COMPARE(list->count(), 1);
    list->setCurrentRow(0);
    QTRY_VERIFY(desk.all<QDoubleSpinBox>().size() > 2);
    auto* area = desk.dock->findChild<QScrollArea*>();
    QTRY_VERIFY(area->verticalScrollBar()->maximum() > 0);
    QList<QWidget*> fields;
    for (QWidget* field : desk.all<QComboBox>()) {
        fields << field;
    }
    for (QWidget* field : desk.all<QDoubleSpinBox>()) {
        fields << field;
    }
    for (QWidget* field : fields) {
        area->verticalScrollBar()->setValue(0);
        turnWheelOver(*field);
        QVERIFY(area->verticalScrollBar()->value() > 0);
    }
    QCOMPARE(desk.document.undoStack().count(), 1);
    QVERIFY(desk.document.scene().rules.front() == rule);
}

CROWD_WINDOW_TEST(TestWheelInPanels)
#include "tst_WheelInPanels.moc"
