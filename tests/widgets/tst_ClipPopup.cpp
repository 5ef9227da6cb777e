// SPDX-License-Identifier: MIT
#include "widgets/forms/ClipPopup.h"

#include <QtTest/QTest>
#include <QtWidgets/QCheckBox>

#include "tests/program/WindowTest.h"
#include "tests/widgets/Desk.h"
#include "widgets/dialogs/TemplatePreview.h"
#include "widgets/docks/BrushSettingsDock.h"
#include "widgets/forms/ClipMix.h"

using namespace crowd;
using namespace crowd::testing;
using namespace crowd::widgets;

/// The clips of the animation brush, and what the mouse shows of them.
class TestClipPopup : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void clipsStandByHowABodyIs();
    void theMouseShowsOneThatMoves();
    void whatNobodyHasShowsNothing();
};

namespace {

QList<QCheckBox*> ticksOf(const Desk<BrushSettingsDock>& desk)
{
    const auto mixes = desk.all<ClipMix>();
    return mixes.isEmpty() ? QList<QCheckBox*>() : mixes.front()->findChildren<QCheckBox*>();
}

void pointAt(QWidget& widget, QEvent::Type type)
{
    if (type == QEvent::Enter) {
        QEnterEvent event(QPointF(3, 3), QPointF(3, 3), QPointF(3, 3));
        QApplication::sendEvent(&widget, &event);
    } else {
        QEvent event(type);
        QApplication::sendEvent(&widget, &event);
    }
}

ClipPopup* popupOf(const Desk<BrushSettingsDock>& desk)
{
    return desk.all<ClipMix>().front()->findChild<ClipPopup*>();
}

/// The small theatre, whose man can also walk.
model::Scene theatreOfAWalker()
{
    model::Scene scene = smallTheatre();
    auto walker = makeBoxMan();
    walker->seatedClip = 2;
    walker->clips[1].name = "walk";
    walker->clips[1].loop = true;
    walker->clips[1].speed = 1.3F;
    scene.templates.front() = entryFor(walker);
    return scene;
}

QString shownName(const ClipPopup& popup)
{
    return popup.findChild<QLabel*>()->text();
}

} // namespace

void TestClipPopup::clipsStandByHowABodyIs()
{
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    desk.document.replaceScene(theatreOfAWalker(), {});
    desk.state.setTool(ToolId::BrushAnimation);
    QTRY_COMPARE(desk.dock->windowTitle(), QStringLiteral("Animation Brush"));
    QCOMPARE(ticksOf(desk).size(), qsizetype{3});
    const auto titles =
        desk.all<ClipMix>().front()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly);
    QCOMPARE(titles.size(), qsizetype{3});
    QCOMPARE(titles[0]->text(), QStringLiteral("Standing"));
    QCOMPARE(titles[1]->text(), QStringLiteral("Walking"));
    QCOMPARE(titles[2]->text(), QStringLiteral("Sitting"));
    const auto topOf = [&](const char* clip) {
        for (const QCheckBox* tick : ticksOf(desk)) {
            if (tick->accessibleName() == QLatin1String(clip)) {
                return tick->y();
            }
        }
        return -1;
    };
    QVERIFY(topOf("walk") > titles[1]->y() && topOf("walk") < titles[2]->y());
    QVERIFY(topOf("sit") > titles[2]->y());
    QVERIFY(topOf("stand") > titles[0]->y() && topOf("stand") < titles[1]->y());
}

void TestClipPopup::theMouseShowsOneThatMoves()
{
    Desk<BrushSettingsDock> desk;
    QVERIFY(desk.isReady());
    desk.document.replaceScene(theatreOfAWalker(), {});
    desk.state.setTool(ToolId::BrushAnimation);
    QTRY_COMPARE(desk.dock->windowTitle(), QStringLiteral("Animation Brush"));
    QCOMPARE(ticksOf(desk).size(), qsizetype{3});
    const QList<QCheckBox*> ticks = ticksOf(desk);
    QVERIFY(popupOf(desk) != nullptr && !popupOf(desk)->isVisible());
    pointAt(*ticks[1], QEvent::Enter);
    QTRY_VERIFY(popupOf(desk)->isVisible());
    QCOMPARE(shownName(*popupOf(desk)), ticks[1]->accessibleName());
    // Beside the list, so that all names can be read.
    const ClipMix* mix = desk.all<ClipMix>().front();
    const QRect list(mix->mapToGlobal(QPoint()), mix->size());
    QVERIFY(!popupOf(desk)->geometry().intersects(list));
    auto* preview = popupOf(desk)->findChild<TemplatePreview*>();
    const QImage first = preview->grab().toImage();
    QTRY_VERIFY(preview->grab().toImage() != first);
    // On to the next name: at once, without going away.
    pointAt(*ticks[1], QEvent::Leave);
    pointAt(*ticks[2], QEvent::Enter);
    QVERIFY(popupOf(desk)->isVisible());
    QCOMPARE(shownName(*popupOf(desk)), ticks[2]->accessibleName());
    pointAt(*ticks[2], QEvent::Leave);
    QTRY_VERIFY(!popupOf(desk)->isVisible());
}

/// A template that went while its clips were still listed.
void TestClipPopup::whatNobodyHasShowsNothing()
{
    Desk<BrushSettingsDock> desk;
    auto* mix = new ClipMix(std::vector<std::string>{"juggle", "stand"}, desk.dock);
    ClipPopup::attach(*mix, desk.state);
    mix->show();
    QVERIFY(desk.isReady());
    const auto ticks = mix->findChildren<QCheckBox*>();
    pointAt(*ticks[1], QEvent::Enter);
    QTRY_VERIFY(mix->findChild<ClipPopup*>()->isVisible());
    pointAt(*ticks[0], QEvent::Enter);
    QVERIFY(!mix->findChild<ClipPopup*>()->isVisible());
}

CROWD_WINDOW_TEST(TestClipPopup)
#include "tst_ClipPopup.moc"
