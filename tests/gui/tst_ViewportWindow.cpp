// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>
#include <utility>

#include <QtCore/QRegularExpression>
#include <QtCore/QScopeGuard>
#include <QtCore/QSettings>
#include <QtGui/QCursor>
#include <QtGui/QImage>
#include <QtGui/QPointingDevice>
#include <QtGui/QScreen>
#include <QtGui/QTabletEvent>
#include <QtGui/QWindow>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeWidget>
#include <QtWidgets/QVBoxLayout>

#include "model/project/PresetFolder.h"
#include "render/gl/CardMemory.h"
#include "tests/gui/Studio.h"
#include "tests/program/WindowTest.h"
#include "widgets/state/PresetUse.h"
#include "widgets/state/StoredColours.h"
#include "widgets/viewport/BrushPopup.h"
#include "widgets/viewport/ViewportWidget.h"
#include "widgets/viewport/WorkBar.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Studio;

namespace {

constexpr QPoint kCenter(160, 120);

bool isOneColour(const QImage& image)
{
    const QRgb first = image.pixel(0, 0);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixel(x, y) != first) {
                return false;
            }
        }
    }
    return true;
}

} // namespace

class TestViewportWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { PictureSurface::useKind(PictureSurface::Kind::Automatic); }
    void drawsTheScene_data() { addKinds(); }
    void drawsTheScene();
    void drawsNothingWhileNothingChanges_data() { addKinds(); }
    void drawsNothingWhileNothingChanges();
    void aPictureAtRestRipens();
    void aPictureOfAnotherSizeRipensAnew();
    void farPeopleAreCardsWhileTheyMove();
    void drawsWhilePlayingAndStops();
    void paintsAndTakesBack();
    void quickClicksAllPaint();
    void paintsAtOnceAfterTypingElsewhere();
    void keysAreTheBrushsOverThePicture();
    void spacePlaysOverThePictureWhateverListHasTheFocus();
    void penPressureReachesTheBrush();
    void survivesANewContext_data() { addKinds(); }
    void survivesANewContext();
    void aPictureOfNoSizeDoesNoHarm();
    void edgesAreAsSmoothAsChosen();
    void aSmallGraphicsCardSaysSo();
    void rightButtonOpensThePaletteAndItChoosesTools();
    void thePaletteOpensAtTheToolInHand();
    void thePaletteIsSmallAndHasWhatWasUsedLately();
    void escapeWhileTheButtonIsDownTakesBack();
    void statisticsAreTold_data() { addKinds(); }
    void statisticsAreTold();
    void theHandIsOverIt_data() { addKinds(); }
    void theHandIsOverIt();

private:
    static void addKinds();
    static void useKind();
};

/// A graphics card's way and a processor's, on any machine.
void TestViewportWindow::addKinds()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("composed") << static_cast<int>(PictureSurface::Kind::Composed);
    QTest::newRow("painted") << static_cast<int>(PictureSurface::Kind::Painted);
}

void TestViewportWindow::useKind()
{
    QFETCH(const int, kind);
    PictureSurface::useKind(static_cast<PictureSurface::Kind>(kind));
}

/// As the window system sends what it does.
void TestViewportWindow::theHandIsOverIt()
{
    useKind();
    Studio studio;
    QVERIFY(studio.isReady());
    QWindow* window = studio.window.windowHandle();
    const QPoint at = studio.view->mapTo(&studio.window, QPoint(160, 160));
    QTest::mousePress(window, Qt::LeftButton, {}, at);
    QTest::mouseMove(window, at + QPoint(20, 0));
    QTest::mouseRelease(window, Qt::LeftButton, {}, at + QPoint(20, 0));
    QTRY_VERIFY(studio.people() > 0);
}

void TestViewportWindow::drawsTheScene()
{
    useKind();
    Studio studio;
    QVERIFY(studio.isReady());
    QCOMPARE(studio.view->problem(), QString());
    const QImage picture = studio.picture();
    QCOMPARE(picture.size(), studio.view->size() * studio.view->devicePixelRatio());
    QVERIFY(!isOneColour(picture));
}

void TestViewportWindow::drawsNothingWhileNothingChanges()
{
    useKind();
    Studio studio;
    QVERIFY(studio.isReady());
    studio.state.setTool(ToolId::Select);
    studio.settle();
    const int before = studio.frames->frames();
    // The cursor over empty ground moves only what lies over the picture.
    for (int x = 20; x < 300; x += 20) {
        QTest::mouseMove(studio.view, {x, 200});
        QTest::qWait(10);
    }
    QTest::qWait(100);
    QCOMPARE(studio.frames->frames(), before);
    testing::addPeople(studio.document, 1);
    QTRY_VERIFY(studio.frames->frames() > before);
}

void TestViewportWindow::aPictureAtRestRipens()
{
    Studio studio;
    QVERIFY(studio.isReady());
    studio.settle();
    QCOMPARE(studio.view->ripeness(), 1); // what has to be quick does not
    studio.setQuality(PictureQuality::Automatic);
    QTRY_COMPARE(studio.view->ripeness(), 8);
    studio.settle();
    QCOMPARE(studio.view->ripeness(), 8); // and that is all
    QVERIFY(studio.view->isAtRest());
    int before = studio.frames->frames();
    testing::addPeople(studio.document, 1);
    QTRY_VERIFY(studio.frames->frames() >= before + 8); // anew
    QTRY_COMPARE(studio.view->ripeness(), 8);
    before = studio.frames->frames();
    studio.state.transport().setPlaying(true);
    QTRY_VERIFY(studio.frames->frames() > before + 3);
    QCOMPARE(studio.view->ripeness(), 1); // nothing ripens while it plays
    studio.state.transport().setPlaying(false);
    studio.setQuality(PictureQuality::Best);
    QTRY_COMPARE(studio.view->ripeness(), 16);
}

/// And triangles as soon as they rest, or always where the best is wanted.
void TestViewportWindow::farPeopleAreCardsWhileTheyMove()
{
    Studio studio;
    QVERIFY(studio.isReady());
    testing::addPeople(studio.document, 3);
    studio.state.setCamera(model::Camera::lookingAt({0.0F, 95.0F, 95.0F}, {0.0F, 0.0F, 0.0F}));
    const auto cards = [&studio] {
        return studio.view->statistics().render.byLevel[render::kImpostorLevel];
    };
    studio.settle();
    QCOMPARE(cards(), 0);
    studio.state.transport().setPlaying(true);
    QTRY_COMPARE(cards(), 3);
    studio.setQuality(PictureQuality::Best);
    QTRY_COMPARE(cards(), 0);
    studio.setQuality(PictureQuality::Fast);
    QTRY_COMPARE(cards(), 3);
    studio.state.transport().setPlaying(false);
    QTRY_COMPARE(cards(), 0);
}

/// A panel that opens while one ripens, and closes while the next does.
void TestViewportWindow::aPictureOfAnotherSizeRipensAnew()
{
    Studio studio;
    QVERIFY(studio.isReady());
    testing::addPeople(studio.document, 2);
    studio.setQuality(PictureQuality::Automatic);
    QTRY_COMPARE(studio.view->ripeness(), 8);
    // As it is on the screen: what is asked for it would draw it anew.
    const auto shown = [&studio] {
        return studio.view->screen()->grabWindow(studio.view->window()->winId()).toImage();
    };
    QImage ripe;
    const auto isStill = [&shown, &ripe] {
        const QImage before = std::exchange(ripe, shown());
        return before == ripe;
    };
    QTRY_VERIFY(isStill());
    const QSize large = studio.view->size();
    for (int round = 0; round < 3; ++round) {
        for (const QSize& size : {large - QSize(0, 100), large}) {
            studio.view->setFixedSize(size);
            QTRY_COMPARE(studio.view->size(), size);
            QTRY_VERIFY(studio.view->ripeness() > 1); // and is not done
        }
    }
    QTRY_COMPARE(studio.view->ripeness(), 8);
    QTRY_VERIFY(shown() == ripe);
}

void TestViewportWindow::drawsWhilePlayingAndStops()
{
    Studio studio;
    QVERIFY(studio.isReady());
    testing::addPeople(studio.document, 2);
    studio.settle();
    const int before = studio.frames->frames();
    studio.view->setFocus();
    QTest::keyClick(studio.view, Qt::Key_Space);
    QVERIFY(studio.state.transport().isPlaying());
    QTRY_VERIFY(studio.frames->frames() > before + 5);
    QVERIFY(studio.state.transport().seconds() > 0.0);
    QTest::keyClick(studio.view, Qt::Key_Space);
    studio.settle();
    const int after = studio.frames->frames();
    QTest::qWait(100);
    QCOMPARE(studio.frames->frames(), after);
}

void TestViewportWindow::paintsAndTakesBack()
{
    Studio studio;
    QVERIFY(studio.isReady());
    const QImage empty = studio.picture();
    studio.drag({60, 120}, {260, 120});
    QVERIFY(studio.people() > 3);
    QCOMPARE(studio.document.undoStack().count(), 1);
    const QImage painted = studio.picture();
    QVERIFY(painted != empty);
    studio.document.undoStack().undo();
    QVERIFY(studio.picture() == empty);
    studio.document.undoStack().redo();
    QVERIFY(studio.picture() == painted);
}

void TestViewportWindow::quickClicksAllPaint()
{
    Studio studio;
    QVERIFY(studio.isReady());
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Create);
    brush.selection = model::BrushSelection::Point;
    studio.state.setBrush(brush);
    QTest::mouseClick(studio.view, Qt::LeftButton, {}, {100, 120});
    QTest::mouseDClick(studio.view, Qt::LeftButton, {}, {220, 120});
    QTest::mouseRelease(studio.view, Qt::LeftButton, {}, {220, 120});
    QVERIFY(studio.people() >= 2);
    QVERIFY(!studio.document.isEditOpen());
}

void TestViewportWindow::paintsAtOnceAfterTypingElsewhere()
{
    Studio studio;
    QVERIFY(studio.isReady());
    studio.edit->setFocus();
    QTest::keyClicks(studio.edit, QStringLiteral("vxb ["));
    QCOMPARE(studio.edit->text(), QStringLiteral("vxb ["));
    QCOMPARE(studio.state.tool(), ToolId::BrushCreate);
    QVERIFY(!studio.state.transport().isPlaying());
    QTest::mouseClick(studio.view, Qt::LeftButton, {}, kCenter);
    QVERIFY(studio.people() > 0);
    QVERIFY(studio.view->hasFocus());
    QTest::keyClick(studio.view, Qt::Key_X);
    QCOMPARE(studio.state.tool(), ToolId::BrushDelete);
    QCOMPARE(studio.edit->text(), QStringLiteral("vxb ["));
}

/// A list that something was chosen from keeps no keys; a text that is being typed does.
void TestViewportWindow::keysAreTheBrushsOverThePicture()
{
    Studio studio;
    QVERIFY(studio.isReady());
    auto* list = new QComboBox(&studio.window);
    list->addItems({QStringLiteral("One"), QStringLiteral("Two")});
    studio.layout->addWidget(list);
    list->show();
    list->setFocus();
    QVERIFY(list->hasFocus());
    QEnterEvent enter(kCenter, kCenter, studio.view->mapToGlobal(kCenter));
    QApplication::sendEvent(studio.view, &enter);
    QVERIFY(studio.view->hasFocus());
    studio.edit->setFocus();
    QApplication::sendEvent(studio.view, &enter);
    QVERIFY(studio.edit->hasFocus());
}

/// Of a list that was opened over the picture, or of a tree of names: nobody moves the pointer to
/// the picture, it is there.
void TestViewportWindow::spacePlaysOverThePictureWhateverListHasTheFocus()
{
    Studio studio;
    QVERIFY(studio.isReady());
    auto* list = new QComboBox(&studio.window);
    list->addItems({QStringLiteral("One"), QStringLiteral("Two")});
    studio.layout->addWidget(list);
    list->show();
    const auto& transport = studio.state.transport();
    QCursor::setPos(studio.view->mapToGlobal(kCenter));
    QTRY_COMPARE(QCursor::pos(), studio.view->mapToGlobal(kCenter));
    list->setFocus();
    QTest::keyClick(studio.window.windowHandle(), Qt::Key_Space);
    QVERIFY(studio.view->hasFocus());
    QVERIFY(transport.isPlaying());
    // Away from the picture it is the list's.
    QCursor::setPos(list->mapToGlobal(list->rect().center()));
    QTRY_COMPARE(QCursor::pos(), list->mapToGlobal(list->rect().center()));
    list->setFocus();
    QTest::keyClick(studio.window.windowHandle(), Qt::Key_Space);
    QVERIFY(transport.isPlaying());
    list->hidePopup();
    // Names that can be edited take texts only while they are.
    auto* names = new QTreeWidget(&studio.window);
    studio.layout->addWidget(names);
    auto* item = new QTreeWidgetItem(names, {QStringLiteral("Path 1")});
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    names->show();
    names->setFocus();
    names->setCurrentItem(item);
    // Space plays from there, too, unless it ticks what is chosen.
    QTest::keyClick(names, Qt::Key_Space);
    QVERIFY(!transport.isPlaying());
    item->setCheckState(0, Qt::Unchecked);
    item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
    item->setSelected(false);
    QTest::keyClick(names, Qt::Key_Space);
    QVERIFY(transport.isPlaying());
    QCOMPARE(item->checkState(0), Qt::Unchecked);
    item->setSelected(true);
    QTest::keyClick(names, Qt::Key_Space);
    QVERIFY(transport.isPlaying());
    QCOMPARE(item->checkState(0), Qt::Checked);
    QEnterEvent enter(kCenter, kCenter, studio.view->mapToGlobal(kCenter));
    QApplication::sendEvent(studio.view, &enter);
    QVERIFY(studio.view->hasFocus());
}

void TestViewportWindow::penPressureReachesTheBrush()
{
    Studio studio;
    QVERIFY(studio.isReady());
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Create);
    brush.pressureSize = true;
    studio.state.setBrush(brush);
    const QPointingDevice pen(
        QStringLiteral("pen"), 77, QInputDevice::DeviceType::Stylus,
        QPointingDevice::PointerType::Pen,
        QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 2);
    const auto send = [&](QEvent::Type type, qreal pressure, Qt::MouseButton button,
                          Qt::MouseButtons buttons) {
        QTabletEvent event(type, &pen, QPointF(kCenter), studio.view->mapToGlobal(QPointF(kCenter)),
                           pressure, 0.0F, 0.0F, 0.0F, 0.0, 0.0F, Qt::NoModifier, button, buttons);
        QApplication::sendEvent(studio.view, &event);
    };
    const auto radius = [&] { return studio.view->tools().picture().circle->radius; };
    send(QEvent::TabletPress, 0.5, Qt::LeftButton, Qt::LeftButton); // and it rests
    QTRY_VERIFY(studio.view->tools().isDragging());
    QVERIFY(studio.view->tools().picture().circle.has_value());
    QCOMPARE(radius(), brush.radiusPixels * 0.5);
    send(QEvent::TabletRelease, 0.0, Qt::LeftButton, Qt::NoButton);
    QVERIFY(!studio.view->tools().isDragging());
    // The first sample of a pen that comes down says little.
    send(QEvent::TabletPress, 0.02, Qt::LeftButton, Qt::LeftButton);
    QVERIFY(!studio.view->tools().isDragging());
    send(QEvent::TabletMove, 0.75, Qt::NoButton, Qt::LeftButton);
    QVERIFY(studio.view->tools().isDragging());
    QCOMPARE(radius(), brush.radiusPixels * 0.75);
    send(QEvent::TabletRelease, 0.0, Qt::LeftButton, Qt::NoButton);
    // A tap is a dab.
    const std::size_t people = studio.people();
    send(QEvent::TabletPress, 0.6, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::TabletRelease, 0.0, Qt::LeftButton, Qt::NoButton);
    QVERIFY(!studio.view->tools().isDragging());
    QVERIFY(studio.people() >= people);
}

/// As when all room is given to panels.
void TestViewportWindow::aPictureOfNoSizeDoesNoHarm()
{
    Studio studio;
    QVERIFY(studio.isReady());
    studio.drag({60, 120}, {260, 120});
    const QImage before = studio.picture();
    const QSize whole = studio.view->size();
    const int steps = studio.document.undoStack().index();
    for (const QSize& size : {QSize(0, 0), QSize(1, 1), QSize(whole.width(), 0), QSize(0, 240)}) {
        studio.view->setFixedSize(size);
        QTRY_COMPARE(studio.view->size(), size);
        studio.drag({0, 0}, {1, 1});
        studio.document.undoStack().setIndex(steps);
        studio.settle();
        QCOMPARE(studio.view->problem(), QString());
    }
    studio.view->setFixedSize(whole);
    QTRY_COMPARE(studio.view->size(), whole);
    QVERIFY(studio.picture() == before);
}

/// Each sample of a pixel has its place on the card.
void TestViewportWindow::edgesAreAsSmoothAsChosen()
{
    Studio studio;
    QVERIFY(studio.isReady());
    studio.setQuality(PictureQuality::Best);
    studio.settle();
    const auto bytesWith = [&studio](int samples) {
        ViewOptions options = studio.state.viewOptions();
        options.samples = samples;
        studio.state.setViewOptions(options);
        studio.settle();
        return studio.view->statistics().render.cardBytes;
    };
    const std::int64_t pixels = std::int64_t{studio.view->width()} * studio.view->height();
    QVERIFY(bytesWith(4) >= bytesWith(0) + 16 * pixels);
    QCOMPARE(bytesWith(4), bytesWith(4));
}

/// And the picture goes on.
void TestViewportWindow::aSmallGraphicsCardSaysSo()
{
    Studio studio;
    QVERIFY(studio.isReady());
    studio.setQuality(PictureQuality::Best);
    studio.drag({60, 120}, {260, 120});
    studio.settle();
    const QRegularExpression said(QStringLiteral("memory of the graphics card"));
    const auto* bar = studio.view->findChild<WorkBar*>();
    QVERIFY(!bar->status().text.contains(said));
    const auto noLimit =
        qScopeGuard([] { render::card_memory::limitTo(render::card_memory::kNoLimit); });
    render::card_memory::limitTo(render::card_memory::bytes() - 100'000);
    studio.drag({60, 160}, {260, 160});
    QTRY_VERIFY(bar->status().text.contains(said));
    QCOMPARE(studio.view->problem(), QString());
    QVERIFY(!isOneColour(studio.picture()));
    // Another scene may have room.
    render::card_memory::limitTo(render::card_memory::kNoLimit);
    studio.document.replaceScene(testing::smallTheatre(), {});
    QTRY_VERIFY(!bar->status().text.contains(said));
}

void TestViewportWindow::survivesANewContext()
{
    useKind();
    Studio studio;
    QVERIFY(studio.isReady());
    studio.drag({60, 120}, {260, 120});
    const QImage before = studio.picture();
    // A window of its own and back again, as a dock does.
    QWidget other;
    auto* otherLayout = new QVBoxLayout(&other);
    otherLayout->addWidget(studio.view);
    other.show();
    QVERIFY(QTest::qWaitForWindowExposed(&other));
    studio.settle();
    QCOMPARE(studio.view->problem(), QString());
    QVERIFY(!isOneColour(studio.view->grabPicture()));
    studio.layout->addWidget(studio.view);
    QVERIFY(QTest::qWaitForWindowExposed(&studio.window));
    QVERIFY(studio.picture() == before);
}

void TestViewportWindow::rightButtonOpensThePaletteAndItChoosesTools()
{
    Studio studio;
    QVERIFY(studio.isReady());
    QTest::mouseClick(studio.view, Qt::RightButton, {}, kCenter);
    auto* popup = studio.view->findChild<BrushPopup*>();
    QVERIFY(popup != nullptr);
    QTRY_VERIFY(popup->isVisible());
    auto* button = popup->findChild<QWidget*>(QStringLiteral("brush-colour"));
    QVERIFY(button != nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(studio.state.tool(), ToolId::BrushColour);
    QTRY_VERIFY(!popup->isVisible());
    QCOMPARE(studio.people(), std::size_t{0});
}

/// A second click on the same spot does nothing; rows that a brush has no use for are not there.
void TestViewportWindow::thePaletteOpensAtTheToolInHand()
{
    Studio studio;
    QVERIFY(studio.isReady());
    studio.state.setTool(ToolId::BrushDelete);
    QTest::mouseClick(studio.view, Qt::RightButton, {}, kCenter);
    auto* popup = studio.view->findChild<BrushPopup*>();
    QTRY_VERIFY(popup->isVisible());
    const auto isThere = [popup](const char* name) {
        const auto* part = popup->findChild<QWidget*>(QLatin1String(name));
        return part != nullptr && part->isVisible();
    };
    const auto* button = popup->findChild<QToolButton*>(QStringLiteral("brush-delete"));
    const QPoint pointer = button->mapFromGlobal(studio.view->mapToGlobal(kCenter));
    QVERIFY(button->rect().contains(pointer));
    QVERIFY(isThere("area"));
    popup->close();
    model::BrushSettings all = studio.state.brush(model::BrushKind::Delete);
    all.selection = model::BrushSelection::Lasso;
    studio.state.setBrush(all);
    QTest::mouseClick(studio.view, Qt::RightButton, {}, kCenter);
    QTRY_VERIFY(isThere("area"));
    QVERIFY(!isThere("size"));
    popup->close();
    studio.state.setTool(ToolId::BrushEnvironment);
    QTest::mouseClick(studio.view, Qt::RightButton, {}, kCenter);
    QTRY_VERIFY(isThere("mainNumber"));
    QVERIFY(!isThere("area") && !isThere("size"));
    QCOMPARE(popup->height(), popup->sizeHint().height()); // no room of rows that are gone
}

/// Not one row as wide as the picture.
void TestViewportWindow::thePaletteIsSmallAndHasWhatWasUsedLately()
{
    model::BrushSettings red(model::BrushKind::Colour);
    red.as<model::ColourSettings>().colors = {{200, 20, 30}};
    model::PresetFolder folder(model::presetFolder());
    QVERIFY(folder.save(QStringLiteral("Red"), red).isOk());
    QSettings().remove(QStringLiteral("presets/latest"));
    Studio studio;
    QVERIFY(studio.isReady());
    usePreset(studio.state, *folder.find(QStringLiteral("Red")));
    studio.state.setTool(ToolId::Select);
    QTest::mouseClick(studio.view, Qt::RightButton, {}, kCenter);
    auto* popup = studio.view->findChild<BrushPopup*>();
    QTRY_VERIFY(popup->isVisible());
    QVERIFY2(popup->width() < 420, qPrintable(QString::number(popup->width())));
    auto* presets = popup->findChild<QWidget*>(QStringLiteral("latestPresets"));
    const auto buttons = presets->findChildren<QToolButton*>();
    QCOMPARE(buttons.size(), 1);
    const QImage shown = buttons.front()->icon().pixmap(32, 32).toImage();
    QCOMPARE(shown.pixelColor(shown.width() / 2, shown.height() - 4), QColor(200, 20, 30));
    QTest::mouseClick(buttons.front(), Qt::LeftButton);
    QCOMPARE(studio.state.tool(), ToolId::BrushColour);
    QTRY_VERIFY(!popup->isVisible());
    QCOMPARE(latestPresets(), QStringList{QStringLiteral("Red")});
    // Of the colour brush, the colours of late.
    storeColours(kRecentColours, {QColor(10, 200, 30)});
    QTest::mouseClick(studio.view, Qt::RightButton, {}, kCenter);
    QTRY_VERIFY(popup->isVisible());
    auto* colours = popup->findChild<QWidget*>(QStringLiteral("latestColours"));
    QTRY_VERIFY(colours->isVisible());
    QTest::mouseClick(colours->findChild<QToolButton*>(), Qt::LeftButton);
    const auto& painted =
        studio.state.brush(model::BrushKind::Colour).as<model::ColourSettings>().colors.front();
    QVERIFY((painted == model::PaintColor{10, 200, 30}));
    QVERIFY(folder.remove(QStringLiteral("Red")).isOk());
    QSettings().remove(QStringLiteral("presets/latest"));
}

void TestViewportWindow::escapeWhileTheButtonIsDownTakesBack()
{
    Studio studio;
    QVERIFY(studio.isReady());
    const QImage empty = studio.picture();
    QTest::mousePress(studio.view, Qt::LeftButton, {}, kCenter);
    QTRY_VERIFY(studio.people() > 4); // the resting button sprays
    QTest::keyClick(studio.view, Qt::Key_Escape);
    QCOMPARE(studio.people(), std::size_t{0});
    QTest::mouseRelease(studio.view, Qt::LeftButton, {}, kCenter);
    QCOMPARE(studio.document.undoStack().count(), 0);
    QVERIFY(studio.picture() == empty);
}

void TestViewportWindow::statisticsAreTold()
{
    useKind();
    Studio studio;
    QVERIFY(studio.isReady());
    QSignalSpy told(studio.view, &ViewportWidget::statisticsChanged);
    testing::addPeople(studio.document, 5);
    QTRY_VERIFY(told.count() > 0);
    studio.settle();
    QCOMPARE(studio.view->statistics().render.individuals, 5);
    QVERIFY(studio.view->statistics().frameMs > 0.0);
}

CROWD_WINDOW_TEST(TestViewportWindow)
#include "tst_ViewportWindow.moc"
