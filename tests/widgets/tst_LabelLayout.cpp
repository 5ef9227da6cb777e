// SPDX-License-Identifier: MIT
#include <QtTest/QTest>

#include "tests/program/Test.h"
#include "widgets/viewport/LabelLayout.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

constexpr QRectF kLabelArea(0.0, 0.0, 800.0, 600.0);

LabelWish labelAt(double x, double y, bool isImportant = false)
{
    return {{x, y}, {80.0, 24.0}, isImportant};
}

bool coverEachOther(const std::vector<std::optional<QRectF>>& plates)
{
    for (std::size_t i = 0; i < plates.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (plates[i] && plates[j] && plates[i]->intersects(*plates[j])) {
                return true;
            }
        }
    }
    return false;
}

} // namespace

class TestLabelLayout : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aloneALabelStandsAboveItsPoint();
    void labelsOfOnePointAreStacked();
    void whatHasNoRoomIsLeftOut();
    void importantLabelsAreNeverLeftOut();
    void labelsStayBetweenTheSides();
    void labelsKeepClearOfWhatIsThere();
};

/// What is said at the cursor.
void TestLabelLayout::labelsKeepClearOfWhatIsThere()
{
    const std::vector<LabelWish> wishes{labelAt(400, 300, true), labelAt(600, 300)};
    const QRectF atTheCursor(380.0, 265.0, 60.0, 24.0);
    const auto plates = layOutLabels(wishes, kLabelArea, {atTheCursor});
    QVERIFY(plates[0] && !plates[0]->intersects(atTheCursor));
    QCOMPARE(plates[1]->center(), QPointF(600, 278));
}

void TestLabelLayout::aloneALabelStandsAboveItsPoint()
{
    const std::vector<LabelWish> wishes{labelAt(400, 300), labelAt(600, 300)};
    const auto plates = layOutLabels(wishes, kLabelArea);
    QCOMPARE(plates[0]->center(), QPointF(400, 278));
    QCOMPARE(plates[1]->center(), QPointF(600, 278));
    const std::vector<LabelWish> outside{labelAt(400, 900), labelAt(-900, 300)};
    const auto none = layOutLabels(outside, kLabelArea);
    QVERIFY(!none[0] && !none[1]);
}

void TestLabelLayout::labelsOfOnePointAreStacked()
{
    const std::vector<LabelWish> wishes{labelAt(400, 300), labelAt(400, 300), labelAt(410, 300)};
    const auto plates = layOutLabels(wishes, kLabelArea);
    QVERIFY(plates[0] && plates[1] && plates[2]);
    QVERIFY(!coverEachOther(plates));
    QVERIFY(plates[1]->bottom() <= plates[0]->top() && plates[2]->bottom() <= plates[1]->top());
}

void TestLabelLayout::whatHasNoRoomIsLeftOut()
{
    const std::vector<LabelWish> wishes(40, labelAt(400, 300));
    const auto plates = layOutLabels(wishes, kLabelArea);
    QVERIFY(!coverEachOther(plates));
    const auto shown = std::ranges::count_if(plates, [](const auto& plate) { return !!plate; });
    QVERIFY(shown >= 5 && shown < 10);
}

void TestLabelLayout::importantLabelsAreNeverLeftOut()
{
    std::vector<LabelWish> wishes(40, labelAt(400, 300));
    wishes.back().isImportant = true;
    const auto plates = layOutLabels(wishes, kLabelArea);
    QCOMPARE(plates.back()->center(), QPointF(400, 278));
    QVERIFY(!coverEachOther(plates));
}

void TestLabelLayout::labelsStayBetweenTheSides()
{
    const std::vector<LabelWish> wishes{labelAt(2, 300), labelAt(799, 400)};
    const auto plates = layOutLabels(wishes, kLabelArea);
    QVERIFY(plates[0]->left() >= 0.0 && plates[1]->right() <= 800.0);
}

CROWD_TEST(TestLabelLayout)
#include "tst_LabelLayout.moc"
