// SPDX-License-Identifier: MIT
#include <QtCore/QElapsedTimer>
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QPlainTextEdit>
#include <QtWidgets/QToolButton>

#include "app/console/ConsoleDock.h"
#include "tests/gui/Editor.h"
#include "tests/gui/Patience.h"
#include "tests/program/WindowTest.h"
#include "widgets/docks/BrushPaletteDock.h"
#include "widgets/docks/BrushSettingsDock.h"
#include "widgets/forms/ValueSlider.h"
#include "widgets/viewport/WorkBar.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::copyOfTheatre;
using crowd::testing::Editor;
using crowd::testing::kScriptPatienceMs;

namespace {

constexpr const char* kBrushes = R"(
import time
from typing import Annotated, Literal
import numpy as np
from crowdbrush import Range, Selection, register_brush

@register_brush
class TurnBrush:
    """Turns people round."""
    selection = Selection.RECTANGLE
    through = True
    angle: Annotated[float, Range(0, 6)] = 0.5
    random: bool = False
    side: Literal["left", "right"] = "right"
    times: int = 1

    def apply(self, selection):
        sign = 1 if self.side == "right" else -1
        selection.change(heading=self.angle * self.times * sign)

@register_brush
class SlowBrush:
    """Takes its time."""
    radius = 60
    through = True
    started = []

    def apply(self, selection):
        selection.change(phase=0.125)
        SlowBrush.started.append(1)
        for i in range(600):
            time.sleep(0.1)
            selection.progress(i / 600)

@register_brush
class BrokenBrush:
    through = True
    selection = Selection.RECTANGLE

    def apply(self, selection):
        selection.change(phase=0.25)
        raise ValueError("out of paint")

@register_brush
class BusyBrush:
    through = True
    selection = Selection.RECTANGLE

    def apply(self, selection):
        while True:
            pass
)";

} // namespace

/// Brushes that scripts bring along, used with the mouse. One window for all: Python starts once.
class TestScriptBrush : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanupTestCase();

    void eachHasItsPlaceAndItsSettings();
    void aStrokeIsOneStepAndFollowsTheSettings();
    void anExceptionTakesTheStrokeBack();
    void escapeTakesASlowOneBack();
    void theBarOverThePictureTakesItBack();
    void endlessOnesAreCancelled();
    void escapeWhileTheButtonIsHeld();
    void recordedAsWhatCameOfIt();

private:
    [[nodiscard]] bool run(const QString& source)
    {
        QSignalSpy finished(&m_editor->window.interpreter(), &app::Interpreter::finished);
        m_editor->window.interpreter().run(source);
        return QTest::qWaitFor([&finished] { return finished.count() == 1; }, kScriptPatienceMs);
    }
    void choose(const char* brush)
    {
        auto* palette = m_editor->window.findChild<BrushPaletteDock*>();
        auto* button = palette->findChild<QToolButton*>(
            QStringLiteral("script-brush/%1").arg(QLatin1String(brush)));
        QVERIFY2(button != nullptr, brush);
        button->click();
        QCOMPARE(m_editor->state().tool(), ToolId::BrushScript);
    }
    void paint()
    {
        const QSize size = m_editor->view().size();
        m_editor->drag({10, 10}, {size.width() - 10, size.height() - 10});
    }
    [[nodiscard]] bool isDone()
    {
        return QTest::qWaitFor([this] { return !m_editor->window.interpreter().isRunning(); },
                               kScriptPatienceMs);
    }
    [[nodiscard]] std::string bytes() { return m_editor->bytes(); }
    [[nodiscard]] int steps() { return m_editor->window.document().undoStack().count(); }

    QTemporaryDir m_folder;
    std::unique_ptr<Editor> m_editor;
    QString m_said;
    std::string m_before;
    int m_stepsBefore = 0;
};

void TestScriptBrush::initTestCase()
{
    m_editor = std::make_unique<Editor>();
    QVERIFY(m_editor->open(copyOfTheatre(m_folder)));
    (void)m_editor->picture();
    connect(&m_editor->state(), &EditorState::statusMessage, this,
            [this](const QString& text) { m_said = text; });
    QVERIFY(run(QString::fromUtf8(kBrushes)));
    QTRY_COMPARE_WITH_TIMEOUT(m_editor->state().scriptBrushes().size(), std::size_t{4},
                              kScriptPatienceMs);
}

void TestScriptBrush::init()
{
    m_said.clear();
    m_before = bytes();
    m_stepsBefore = steps();
}

void TestScriptBrush::cleanupTestCase()
{
    m_editor.reset();
}

void TestScriptBrush::eachHasItsPlaceAndItsSettings()
{
    choose("Turn");
    auto* dock = m_editor->window.findChild<BrushSettingsDock*>();
    dock->show();
    QTRY_VERIFY(dock->windowTitle().contains(QStringLiteral("Turn")));
    QTRY_VERIFY(!dock->findChildren<QCheckBox*>().isEmpty());
    const auto hasText = [dock](const char* text) {
        const auto boxes = dock->findChildren<QCheckBox*>();
        return std::any_of(boxes.begin(), boxes.end(), [text](const QCheckBox* box) {
            return box->text() == QLatin1String(text);
        });
    };
    QVERIFY(hasText("Random"));
    const auto choices = dock->findChildren<QComboBox*>();
    const auto side = std::find_if(choices.begin(), choices.end(), [](const QComboBox* box) {
        return box->findText(QStringLiteral("left")) >= 0;
    });
    QVERIFY(side != choices.end());
    QCOMPARE((*side)->currentText(), QStringLiteral("right"));
    Q_EMIT(*side)->activated(0);
    const auto& values =
        m_editor->state().brush(model::BrushKind::Script).as<crowd::model::ScriptSettings>().values;
    QCOMPARE(std::get<std::string>(values[2].value), std::string("left"));
    choose("Slow");
    choose("Turn");
    QCOMPARE(std::get<std::string>(m_editor->state()
                                       .brush(model::BrushKind::Script)
                                       .as<crowd::model::ScriptSettings>()
                                       .values[2]
                                       .value),
             std::string("left")); // each keeps its own
    dock->hide();
}

void TestScriptBrush::aStrokeIsOneStepAndFollowsTheSettings()
{
    choose("Turn");
    model::BrushSettings settings = m_editor->state().brush(model::BrushKind::Script);
    settings.as<crowd::model::ScriptSettings>().values[0].value = 1.5;
    settings.as<crowd::model::ScriptSettings>().values[2].value = std::string("right");
    m_editor->state().setBrush(settings);
    paint();
    QVERIFY(isDone());
    QCOMPARE(steps(), m_stepsBefore + 1);
    const auto headings =
        m_editor->window.document().scene().population.column(model::columns::heading);
    const auto turned = std::count(headings.begin(), headings.end(), 1.5F);
    QVERIFY2(turned > 20, qPrintable(QString::number(turned)));
    QVERIFY2(m_said.contains(QStringLiteral("changed")), qPrintable(m_said));
    const std::string painted = bytes();
    m_editor->window.actions().action("undo")->trigger();
    QVERIFY(bytes() == m_before);
    m_editor->window.actions().action("redo")->trigger();
    QVERIFY(bytes() == painted);
}

void TestScriptBrush::anExceptionTakesTheStrokeBack()
{
    choose("Broken");
    paint();
    QVERIFY(isDone());
    QVERIFY(bytes() == m_before);
    QCOMPARE(steps(), m_stepsBefore);
    QVERIFY2(m_said.contains(QStringLiteral("out of paint")), qPrintable(m_said));
    auto* output =
        m_editor->window.console().findChild<QPlainTextEdit*>(QStringLiteral("consoleOutput"));
    QTRY_VERIFY(output->toPlainText().contains(QStringLiteral("Traceback")));
    QVERIFY(output->toPlainText().contains(QStringLiteral("ValueError: out of paint")));
    QVERIFY2(!output->toPlainText().contains(QStringLiteral("console.py")),
             qPrintable(output->toPlainText()));
    choose("Turn"); // and on with another one
    paint();
    QVERIFY(isDone());
    m_editor->window.document().undoStack().setIndex(m_stepsBefore);
}

void TestScriptBrush::escapeTakesASlowOneBack()
{
    choose("Slow");
    paint();
    auto* bar = m_editor->window.findChild<WorkBar*>();
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && bar->status().done >= 0.0, kScriptPatienceMs);
    QVERIFY(bar->status().text.contains(QStringLiteral("Slow")));
    QVERIFY(m_editor->window.document().isEditOpen());
    QElapsedTimer clock;
    clock.start();
    QTest::keyClick(&m_editor->view(), Qt::Key_Escape);
    QVERIFY2(bytes() == m_before, "taken back at once");
    QVERIFY(isDone());
    QVERIFY2(clock.elapsed() < 5000, qPrintable(QString::number(clock.elapsed())));
    QCOMPARE(steps(), m_stepsBefore);
    QVERIFY(!m_editor->window.document().isEditOpen());
    QVERIFY2(m_said.contains(QStringLiteral("taken back")), qPrintable(m_said));
    QTRY_VERIFY(!bar->isVisible());
}

void TestScriptBrush::theBarOverThePictureTakesItBack()
{
    choose("Slow");
    paint();
    auto* bar = m_editor->window.findChild<WorkBar*>();
    auto* button = bar->findChild<QToolButton*>();
    QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible() && button->isVisible(), kScriptPatienceMs);
    QTest::mouseClick(button, Qt::LeftButton);
    QVERIFY(isDone());
    QVERIFY(bytes() == m_before);
}

void TestScriptBrush::endlessOnesAreCancelled()
{
    choose("Busy");
    paint();
    QTest::qWait(300);
    QVERIFY(m_editor->window.interpreter().isRunning());
    QElapsedTimer clock;
    clock.start();
    m_editor->window.actions().action("script-cancel")->trigger();
    QVERIFY(isDone());
    QVERIFY2(clock.elapsed() < 5000, qPrintable(QString::number(clock.elapsed())));
    QVERIFY(bytes() == m_before);
    QCOMPARE(steps(), m_stepsBefore);
}

void TestScriptBrush::escapeWhileTheButtonIsHeld()
{
    choose("Slow");
    model::BrushSettings wide = m_editor->state().brush(model::BrushKind::Script);
    wide.radiusPixels = 300.0F; // wherever they sit
    m_editor->state().setBrush(wide);
    const QSize size = m_editor->view().size();
    m_editor->press({size.width() / 2, size.height() / 2});
    QTRY_VERIFY_WITH_TIMEOUT(bytes() != m_before, kScriptPatienceMs); // seen at once
    QTest::keyClick(&m_editor->view(), Qt::Key_Escape);
    m_editor->release({size.width() / 2, size.height() / 2});
    QVERIFY(isDone());
    QVERIFY(bytes() == m_before);
    QCOMPARE(steps(), m_stepsBefore);
}

void TestScriptBrush::recordedAsWhatCameOfIt()
{
    m_editor->window.recorder().setRecording(true);
    choose("Turn");
    model::BrushSettings settings = m_editor->state().brush(model::BrushKind::Script);
    settings.as<crowd::model::ScriptSettings>().values[0].value = 0.75;
    m_editor->state().setBrush(settings);
    paint();
    QVERIFY(isDone());
    m_editor->window.recorder().setRecording(false);
    const std::string script = m_editor->window.recorder().script();
    QVERIFY(script.find("scene.change(") != std::string::npos);
    const std::string painted = bytes();
    m_editor->window.document().undoStack().setIndex(m_stepsBefore);
    QVERIFY(run(QString::fromStdString(script))); // in the console, on the open scene
    QVERIFY(bytes() == painted);
}

CROWD_WINDOW_TEST(TestScriptBrush)
#include "tst_ScriptBrush.moc"
