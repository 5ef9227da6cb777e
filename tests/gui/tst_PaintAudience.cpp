// SPDX-License-Identifier: MIT
#include <string>

#include <QtCore/QTemporaryDir>
#include <QtTest/QTest>

#include "model/project/ProjectFile.h"
#include "tests/gui/Studio.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::Studio;

namespace {

/// Sweeps over the rows with the mouse until so many people sit.
void paintSeats(Studio& studio, std::size_t wanted)
{
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Create);
    brush.selection = model::BrushSelection::AllInCircle;
    brush.radiusPixels = 18.0F;
    studio.state.setBrush(brush);
    studio.state.setTool(ToolId::BrushCreate);
    for (int y = 70; y < 200 && studio.people() < wanted; y += 14) {
        studio.drag({12, y}, {308, y});
    }
}

void recolourRectangle(Studio& studio)
{
    model::BrushSettings brush = studio.state.brush(model::BrushKind::Colour);
    brush.selection = model::BrushSelection::Rectangle;
    brush.through = true;
    studio.state.setBrush(brush);
    studio.state.setTool(ToolId::BrushColour);
    studio.drag({90, 80}, {230, 150});
}

} // namespace

class TestPaintAudience : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void paintRecolourUndoRedoSaveReopen();
};

void TestPaintAudience::paintRecolourUndoRedoSaveReopen()
{
    Studio studio;
    QVERIFY(studio.isReady());
    QCOMPARE(studio.view->problem(), QString());
    const std::string emptyBytes = studio.bytes();
    const QImage emptyPicture = studio.picture();

    paintSeats(studio, 200);
    QVERIFY2(studio.people() >= 200, qPrintable(QString::number(studio.people())));
    const auto seats = studio.document.scene().population.column(model::columns::seat);
    QVERIFY(std::none_of(seats.begin(), seats.end(),
                         [](model::SeatId seat) { return seat == model::kNoSeat; }));
    const QImage seated = studio.picture();
    QVERIFY(seated != emptyPicture);

    recolourRectangle(studio);
    const std::string paintedBytes = studio.bytes();
    studio.state.setTool(ToolId::BrushCreate);
    const QImage paintedPicture = studio.picture();
    QVERIFY(paintedPicture != seated);

    QUndoStack& undo = studio.document.undoStack();
    const int steps = undo.count();
    QVERIFY(steps >= 2);
    while (undo.canUndo()) {
        undo.undo();
    }
    QCOMPARE(studio.bytes(), emptyBytes);
    QVERIFY(studio.picture() == emptyPicture);
    while (undo.canRedo()) {
        undo.redo();
    }
    QCOMPARE(undo.count(), steps);
    QCOMPARE(studio.bytes(), paintedBytes);
    QVERIFY(studio.picture() == paintedPicture);

    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("audience.crowd"));
    QVERIFY(model::saveProject(studio.document.scene(), path).isOk());
    auto read = model::readProject(path);
    QVERIFY(read.isOk());
    model::Scene scene = std::move(read.value());
    // The assets of this scene were made in code; all else comes from the file.
    const model::Scene made = testing::smallTheatre();
    scene.templates.front().asset = made.templates.front().asset;
    scene.stages.front().asset = made.stages.front().asset;
    Studio reopened(scene);
    QVERIFY(reopened.isReady());
    QCOMPARE(reopened.bytes(), paintedBytes);
    QVERIFY(reopened.picture() == paintedPicture);
}

CROWD_WINDOW_TEST(TestPaintAudience)
#include "tst_PaintAudience.moc"
