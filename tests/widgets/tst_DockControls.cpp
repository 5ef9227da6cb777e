// SPDX-License-Identifier: MIT
#include <QtCore/QLocale>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLineEdit>

#include "tests/program/WindowTest.h"
#include "widgets/docks/SwatchGrid.h"
#include "widgets/forms/ClipMix.h"
#include "widgets/forms/CurveEditor.h"
#include "widgets/forms/NumberBox.h"
#include "widgets/forms/NumberList.h"
#include "widgets/forms/RangeSlider.h"
#include "widgets/forms/ValueSlider.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

/// From 0 to 1 over 200 pixels, two decimals.
struct ShownRange
{
    ShownRange() : slider(QStringLiteral("Height"), {0.0, 1.0, 0.05, 2, {}, false}, nullptr)
    {
        slider.resize(200, 24);
        slider.setValue({0.25F, 0.75F});
        slider.show();
    }
    void drag(int from, int to)
    {
        QTest::mousePress(&slider, Qt::LeftButton, {}, {from, 10});
        QTest::mouseMove(&slider, {(from + to) / 2, 10});
        QTest::mouseMove(&slider, {to, 10});
        QTest::mouseRelease(&slider, Qt::LeftButton, {}, {to, 10});
    }

    RangeSlider slider;
};

} // namespace

class DockControlsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sliderStaysInItsRange();
    void rangeEndsAreDraggedApart();
    void theMiddleMovesBothEnds();
    void rangesAreTyped_data();
    void rangesAreTyped();
    void escapeGivesUpTyping();
    void aDoubleClickOnlyTypes_data();
    void aDoubleClickOnlyTypes();
    void aTypedNumberIsTakenOnce();
    void pointAndCommaAreBothUnderstood_data();
    void pointAndCommaAreBothUnderstood();
    void numberListsGoBothWays_data();
    void numberListsGoBothWays();
    void drawnCurveIsKept();
    void tickedClipsHaveWeights();
    void swatchesWrapIntoTheWidth();
};

void DockControlsTest::sliderStaysInItsRange()
{
    ValueSlider slider(QStringLiteral("Size"), {1.0, 10.0, 1.0, 0, {}, false}, nullptr);
    slider.resize(200, 24);
    slider.show();
    QVERIFY(QTest::qWaitForWindowExposed(&slider));
    slider.setValue(5.0);
    QSignalSpy edited(&slider, &ValueSlider::valueEdited);
    QTest::mousePress(&slider, Qt::LeftButton, {}, {100, 10});
    QTest::mouseMove(&slider, {900, 10});
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, {900, 10});
    QCOMPARE(slider.value(), 10.0);
    QVERIFY(edited.count() > 0);
}

void DockControlsTest::drawnCurveIsKept()
{
    CurveEditor editor(nullptr);
    editor.resize(160, 60);
    editor.show();
    QVERIFY(QTest::qWaitForWindowExposed(&editor));
    QSignalSpy edited(&editor, &CurveEditor::edited);
    QTest::mouseClick(&editor, Qt::LeftButton, {}, {5, 58});
    QVERIFY(edited.count() > 0);
    QVERIFY(editor.curve().weights.front() < 0.3F);
    QCOMPARE(editor.curve().weights.back(), 1.0F);
    QTest::mouseDClick(&editor, Qt::LeftButton, {}, {80, 30});
    QCOMPARE(editor.curve(), model::DistributionCurve());
}

void DockControlsTest::rangeEndsAreDraggedApart()
{
    ShownRange shown;
    QSignalSpy edited(&shown.slider, &RangeSlider::valueEdited);
    shown.drag(150, 180);
    QCOMPARE(shown.slider.value(), (model::ValueRange{0.25F, 0.9F}));
    shown.drag(50, 20);
    QCOMPARE(shown.slider.value(), (model::ValueRange{0.1F, 0.9F}));
    shown.drag(20, 500);
    QCOMPARE(shown.slider.value(), (model::ValueRange{1.0F, 1.0F})); // the low end takes the high
    shown.drag(190, -50);
    QCOMPARE(shown.slider.value(), (model::ValueRange{0.0F, 1.0F}));
    QVERIFY(edited.count() >= 4);
}

void DockControlsTest::aDoubleClickOnlyTypes_data()
{
    QTest::addColumn<QString>("text");
    QTest::newRow("nothing") << "";
    QTest::newRow("no number") << "tall";
    QTest::newRow("half a range") << "0.3 tall";
}

void DockControlsTest::aDoubleClickOnlyTypes()
{
    QFETCH(QString, text);
    ShownRange shown;
    const auto doubleClick = [](QWidget& slider) {
        QTest::mouseClick(&slider, Qt::LeftButton, {}, {190, 10}); // QTest leaves it out
        QTest::mouseDClick(&slider, Qt::LeftButton, {}, {190, 10});
    };
    doubleClick(shown.slider);
    QCOMPARE(shown.slider.value(), (model::ValueRange{0.25F, 0.75F}));
    auto* line = shown.slider.findChild<QLineEdit*>();
    QVERIFY(line != nullptr);
    line->setText(text);
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(shown.slider.value(), (model::ValueRange{0.25F, 0.75F}));

    ValueSlider single(QStringLiteral("Size"), {0.0, 1.0, 0.05, 2, {}, false}, nullptr);
    single.resize(200, 24);
    single.setValue(0.5);
    single.show();
    doubleClick(single);
    QCOMPARE(single.value(), 0.5);
    line = single.findChild<QLineEdit*>();
    QVERIFY(line != nullptr);
    line->setText(text);
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(single.value(), 0.5);
}

void DockControlsTest::theMiddleMovesBothEnds()
{
    ShownRange shown;
    shown.drag(100, 120);
    QCOMPARE(shown.slider.value(), (model::ValueRange{0.35F, 0.85F}));
    shown.drag(120, 400);
    QCOMPARE(shown.slider.value(), (model::ValueRange{0.5F, 1.0F}));
}

void DockControlsTest::rangesAreTyped_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<float>("low");
    QTest::addColumn<float>("high");
    QTest::newRow("two numbers") << "0.1 0.4" << 0.1F << 0.4F;
    QTest::newRow("with a hyphen") << "0.1-0.4" << 0.1F << 0.4F;
    QTest::newRow("the higher first") << "0.4 0.1" << 0.1F << 0.4F;
    QTest::newRow("one number for both") << "0.5" << 0.5F << 0.5F;
    QTest::newRow("beyond the range") << "0.5 7" << 0.5F << 1.0F;
    QTest::newRow("words change nothing") << "tall" << 0.25F << 0.75F;
    QTest::newRow("nothing changes nothing") << "" << 0.25F << 0.75F;
}

void DockControlsTest::rangesAreTyped()
{
    QFETCH(QString, text);
    QFETCH(float, low);
    QFETCH(float, high);
    ShownRange shown;
    QTest::keyClick(&shown.slider, Qt::Key_Return);
    auto* line = shown.slider.findChild<QLineEdit*>();
    QVERIFY(line != nullptr);
    line->setText(text);
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(shown.slider.value(), (model::ValueRange{low, high}));
    QTRY_VERIFY(shown.slider.findChild<QLineEdit*>() == nullptr);
}

void DockControlsTest::escapeGivesUpTyping()
{
    ShownRange shown;
    QTest::keyClick(&shown.slider, Qt::Key_Return);
    auto* line = shown.slider.findChild<QLineEdit*>();
    QVERIFY(line != nullptr);
    line->setText(QStringLiteral("0.1 0.4"));
    QTest::keyClick(line, Qt::Key_Escape);
    QTRY_VERIFY(shown.slider.findChild<QLineEdit*>() == nullptr);
    QCOMPARE(shown.slider.value(), (model::ValueRange{0.25F, 0.75F}));
}

void DockControlsTest::aTypedNumberIsTakenOnce()
{
    ValueSlider slider(QStringLiteral("Size"), {1.0, 10.0, 1.0, 0, {}, false}, nullptr);
    slider.show();
    QSignalSpy edited(&slider, &ValueSlider::valueEdited);
    QTest::keyClick(&slider, Qt::Key_Return);
    auto* line = slider.findChild<QLineEdit*>();
    QVERIFY(line != nullptr);
    line->setText(QStringLiteral("7"));
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(slider.value(), 7.0);
    QCOMPARE(edited.count(), 1);
    QTRY_VERIFY2(slider.findChild<QLineEdit*>() == nullptr, "the field closes");
}

void DockControlsTest::pointAndCommaAreBothUnderstood_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QLocale>("language");
    QTest::addColumn<double>("wanted");
    const QLocale english(QLocale::English);
    const QLocale german(QLocale::German);
    QTest::newRow("point, English") << QStringLiteral("0.5") << english << 0.5;
    QTest::newRow("comma, English") << QStringLiteral("0,5") << english << 0.5;
    QTest::newRow("point, German") << QStringLiteral("12.25") << german << 12.25;
    QTest::newRow("comma, German") << QStringLiteral("12,25") << german << 12.25;
}

/// In fields with arrows, and typed over a slider.
void DockControlsTest::pointAndCommaAreBothUnderstood()
{
    QFETCH(QString, typed);
    QFETCH(QLocale, language);
    QFETCH(double, wanted);
    NumberBox box;
    box.setLocale(language);
    box.setSuffix(QStringLiteral(" m/s"));
    box.selectAll();
    QTest::keyClicks(&box, typed);
    QCOMPARE(box.value(), wanted);
    const QLocale before;
    QLocale::setDefault(language);
    const auto number = typedNumber(typed);
    const auto thousand = typedNumber(QStringLiteral("1,000"));
    QLocale::setDefault(before);
    QCOMPARE(number.value_or(-1.0), wanted);
    QVERIFY(thousand != 1000.0);
}

void DockControlsTest::numberListsGoBothWays_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QList<int>>("numbers");
    QTest::addColumn<QString>("shown");
    QTest::newRow("nothing") << "" << QList<int>() << "";
    QTest::newRow("one") << "3" << QList<int>{2} << "3";
    QTest::newRow("a range") << "3-5" << QList<int>{2, 3, 4} << "3-5";
    QTest::newRow("two in a row are no range") << "3-4" << QList<int>{2, 3} << "3, 4";
    QTest::newRow("out of order, twice") << "7, 1, 7" << QList<int>{0, 6} << "1, 7";
    QTest::newRow("counted from one") << "0, 1" << QList<int>{0} << "1";
    QTest::newRow("words between") << "rows 2 and 4" << QList<int>{1, 3} << "2, 4";
    QTest::newRow("a range backwards") << "5-3" << QList<int>{2, 3, 4} << "3-5";
}

void DockControlsTest::numberListsGoBothWays()
{
    QFETCH(QString, typed);
    QFETCH(QList<int>, numbers);
    QFETCH(QString, shown);
    const std::vector<int> wanted(numbers.begin(), numbers.end());
    QCOMPARE(numberListOf(typed), wanted);
    QCOMPARE(numberListText(wanted), shown);
}

void DockControlsTest::tickedClipsHaveWeights()
{
    ClipMix mix(std::vector<std::string>{"sit", "cheer", "clap"}, nullptr);
    mix.show();
    QSignalSpy edited(&mix, &ClipMix::edited);
    const auto ticks = mix.findChildren<QCheckBox*>();
    const auto weights = mix.findChildren<ValueSlider*>();
    QCOMPARE(ticks.size(), qsizetype{3});
    mix.setClips({{"cheer", 1.0F}});
    QVERIFY(!ticks[0]->isChecked() && ticks[1]->isChecked());
    QVERIFY2(!weights[1]->isVisible(), "one alone needs no weight");
    mix.setClips({{"cheer", 0.3F}, {"sit", 1.0F}});
    QVERIFY(weights[0]->isVisible() && weights[1]->isVisible() && !weights[2]->isVisible());
    QCOMPARE(qRound(weights[1]->value()), 30);
    QCOMPARE(edited.count(), 0);
    ticks[2]->click();
    QCOMPARE(edited.takeLast().front().value<model::ClipWeight>(),
             (model::ClipWeight{"clap", 1.0F}));
    ticks[0]->click();
    QCOMPARE(edited.takeLast().front().value<model::ClipWeight>(),
             (model::ClipWeight{"sit", 0.0F}));
}

void DockControlsTest::swatchesWrapIntoTheWidth()
{
    SwatchGrid grid(20, nullptr);
    grid.setColors(std::vector<QColor>(10, QColor(Qt::red)));
    grid.resize(23 * 5, 100);
    QCOMPARE(grid.heightForWidth(grid.width()), 43);
    QCOMPARE(grid.cellRect(5).top(), 23);
    grid.setAddition(QStringLiteral("More"));
    QCOMPARE(grid.heightForWidth(grid.width()), 66);
    QSignalSpy chosen(&grid, &SwatchGrid::chosen);
    QSignalSpy removed(&grid, &SwatchGrid::removalRequested);
    QSignalSpy added(&grid, &SwatchGrid::additionRequested);
    QTest::mouseClick(&grid, Qt::LeftButton, {}, grid.cellRect(7).center());
    QTest::mouseClick(&grid, Qt::RightButton, {}, grid.cellRect(10).center());
    QTest::mouseClick(&grid, Qt::LeftButton, {}, grid.cellRect(10).center());
    QTest::mouseClick(&grid, Qt::LeftButton, {}, {21, 10}); // the gap
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.front().front().toInt(), 7);
    QCOMPARE(removed.count(), 0);
    QCOMPARE(added.count(), 1);
}

CROWD_WINDOW_TEST(DockControlsTest)
#include "tst_DockControls.moc"
