// SPDX-License-Identifier: MIT
#include <functional>

#include <QtTest/QTest>
#include <QtWidgets/QProgressBar>
#include <QtWidgets/QToolButton>

#include "tests/program/WindowTest.h"
#include "widgets/viewport/WorkBar.h"

using namespace crowd::widgets;

namespace {

/// Does something while it is painted, as the viewport does.
class Picture : public QWidget
{
public:
    std::function<void()> onPaint;

protected:
    void paintEvent(QPaintEvent*) override
    {
        if (onPaint) {
            std::exchange(onPaint, {})();
        }
    }
};

WorkStatus baking(double done)
{
    return {QStringLiteral("Baking"), done, QStringLiteral("Cancel"), {}};
}

} // namespace

class WorkBarTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aStatusThatComesWhileAnotherIsShownReplacesItWhole();
};

void WorkBarTest::aStatusThatComesWhileAnotherIsShownReplacesItWhole()
{
    Picture picture;
    picture.resize(600, 300);
    WorkBar bar(&picture);
    picture.show();
    QVERIFY(QTest::qWaitForWindowExposed(&picture));
    bar.setStatus(baking(0.1));
    QTest::qWait(100);
    QVERIFY(bar.isVisible());
    bool hasCome = false;
    picture.onPaint = [&] {
        hasCome = true;
        bar.setStatus({}); // the work has ended by the time the picture is drawn
    };
    bar.setStatus(baking(0.9));
    QTRY_VERIFY(hasCome);
    QVERIFY(bar.status() == WorkStatus());
    QVERIFY2(!bar.isVisible(), "nothing is going on");
    bar.setStatus(baking(0.2));
    QVERIFY(bar.isVisible() && bar.findChild<QProgressBar*>()->isVisible());
}

CROWD_WINDOW_TEST(WorkBarTest)

#include "tst_WorkBar.moc"
