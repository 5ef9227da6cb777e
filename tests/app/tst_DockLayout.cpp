// SPDX-License-Identifier: MIT
#include <QtGui/QAction>
#include <QtGui/QCursor>
#include <QtTest/QTest>
#include <QtWidgets/QAbstractButton>
#include <QtWidgets/QDockWidget>

#include "app/window/DockLayout.h"
#include "app/window/DockTable.h"
#include "tests/app/PlainScene.h"
#include "tests/app/SceneWindow.h"
#include "tests/program/WindowTest.h"
#include "widgets/viewport/ViewportWidget.h"

using namespace crowd;
using namespace crowd::testing;

/// How wide panels are that nobody has moved.
class TestDockLayout : public QObject, SceneWindow
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { prepare("DockLayout"); }
    void init() { begin(); }
    void cleanup() { m_window.reset(); }
    void aWideWindowHasWidePanels();
    void theSidesAreAsBeforeWhenTheTimelineGoes();
    void oneThatIsPutBackIsInFront();
    void afloatItCoversNoOtherAndCanBeClosed();
    void theMenuTakesPanelsAway();
    void theSettingsOfTheToolComeInFront();
    void onASmallScreenItsTitleCanBeGrasped();

private:
    [[nodiscard]] QDockWidget* dock(app::DockId id) const
    {
        return m_window->dockLayout().dock(id);
    }
    [[nodiscard]] int width() const { return dock(app::DockId::BrushSettings)->width(); }
};

/// Long names of brushes are read in their tab.
void TestDockLayout::aWideWindowHasWidePanels()
{
    m_window->resize(1280, 700);
    QTRY_VERIFY2(width() < 290, qPrintable(QString::number(width())));
    m_window->resize(1860, 960);
    QTRY_VERIFY2(width() >= 305, qPrintable(QString::number(width())));
}

void TestDockLayout::theSidesAreAsBeforeWhenTheTimelineGoes()
{
    m_window->resize(1280, 700);
    QTRY_VERIFY(width() < 290);
    const int before = width();
    dock(app::DockId::Timeline)->show();
    QTRY_VERIFY(dock(app::DockId::Timeline)->width() > 0);
    m_window->resizeDocks({dock(app::DockId::BrushSettings)}, {10}, Qt::Horizontal);
    QTRY_VERIFY(width() < before); // pressed together
    dock(app::DockId::Timeline)->hide();
    QTRY_COMPARE(width(), before);
}

/// Among the tabs that it came from.
void TestDockLayout::oneThatIsPutBackIsInFront()
{
    QDockWidget* light = dock(app::DockId::Light);
    light->raise();
    QTRY_VERIFY(!light->visibleRegion().isEmpty());
    light->setFloating(true);
    dock(app::DockId::Groups)->raise();
    QTRY_VERIFY(!dock(app::DockId::Groups)->visibleRegion().isEmpty());
    light->setFloating(false);
    QTRY_VERIFY(!light->visibleRegion().isEmpty());
}

void TestDockLayout::afloatItCoversNoOtherAndCanBeClosed()
{
    m_window->resize(1280, 700);
    const auto button = [](const QDockWidget* dock, const char* name) {
        return dock->findChild<QAbstractButton*>(QLatin1String(name));
    };
    for (const app::DockId id : {app::DockId::Light, app::DockId::BrushSettings}) {
        QDockWidget* panel = dock(id);
        panel->raise();
        QTRY_VERIFY(!panel->visibleRegion().isEmpty());
        QTest::mouseClick(button(panel, "qt_dockwidget_floatbutton"), Qt::LeftButton);
        QTRY_VERIFY(panel->isFloating());
        const QWidget* picture = m_window->centralWidget();
        const QRect room(picture->mapToGlobal(QPoint()), picture->size());
        QTRY_VERIFY2(room.left() < panel->frameGeometry().left() &&
                         panel->frameGeometry().right() < room.right(),
                     qPrintable(panel->objectName()));
        QVERIFY2(panel->widget()->x() >= 4, "its edge can be grasped");
        QTRY_VERIFY(button(panel, "qt_dockwidget_closebutton")->isVisible());
        QTest::mouseClick(button(panel, "qt_dockwidget_closebutton"), Qt::LeftButton);
        QTRY_VERIFY(!panel->isVisible());
        panel->toggleViewAction()->trigger();
        QTRY_VERIFY(panel->isVisible());
    }
}

void TestDockLayout::theMenuTakesPanelsAway()
{
    QDockWidget* light = dock(app::DockId::Light);
    light->raise();
    QTRY_VERIFY(!light->visibleRegion().isEmpty());
    QVERIFY(light->toggleViewAction()->isEnabled());
    light->toggleViewAction()->trigger();
    QTRY_VERIFY(!light->isVisible());
    light->toggleViewAction()->trigger();
    QTRY_VERIFY(light->isVisible());
}

/// Of the panels that they are behind; not while the pointer is in one of those.
void TestDockLayout::theSettingsOfTheToolComeInFront()
{
    QDockWidget* settings = dock(app::DockId::BrushSettings);
    QDockWidget* looks = dock(app::DockId::Looks);
    const auto isInFront = [](const QDockWidget* panel) {
        return !panel->visibleRegion().isEmpty();
    };
    const QWidget* view = &m_window->viewport();
    QCursor::setPos(view->mapToGlobal(view->rect().center()));
    QTRY_VERIFY(view->rect().contains(view->mapFromGlobal(QCursor::pos())));
    looks->raise();
    QTRY_VERIFY(isInFront(looks));
    m_window->state().setTool(widgets::ToolId::BrushColour);
    QTRY_VERIFY(isInFront(settings));
    looks->raise();
    QTRY_VERIFY(isInFront(looks));
    QCursor::setPos(looks->mapToGlobal(looks->rect().center()));
    QTRY_VERIFY(looks->rect().contains(looks->mapFromGlobal(QCursor::pos())));
    m_window->state().setTool(widgets::ToolId::BrushWalk);
    QCoreApplication::processEvents();
    QVERIFY(isInFront(looks));
}

void TestDockLayout::onASmallScreenItsTitleCanBeGrasped()
{
    const QRect screen(100, 50, 1280, 720);
    const QRect place = app::DockLayout::placeOnSmallScreen(screen, {1150, 600});
    QVERIFY(place.top() >= screen.top() + 24);
    QVERIFY2(screen.contains(place), "all of it is on the screen");
    QVERIFY(place.width() >= 1150);
    const QRect large = app::DockLayout::placeOnSmallScreen(screen, {1300, 740});
    QCOMPARE(large.topLeft(), screen.topLeft()); // as much of it as there is room for
}

CROWD_WINDOW_TEST(TestDockLayout)
#include "tst_DockLayout.moc"
