// SPDX-License-Identifier: MIT
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>

#include "tests/gui/Editor.h"
#include "tests/program/WindowTest.h"

using namespace crowd;
using namespace crowd::widgets;
using crowd::testing::copyOfTheatre;
using crowd::testing::Editor;

class TestEditorAudience : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void paintRecolourUndoRedoSaveReopen();
};

void TestEditorAudience::paintRecolourUndoRedoSaveReopen()
{
    const QTemporaryDir folder;
    const QString path = copyOfTheatre(folder);
    std::string paintedBytes;
    QImage paintedPicture;
    {
        Editor editor;
        QVERIFY(editor.open(path));
        QCOMPARE(editor.view().problem(), QString());
        const std::string openedBytes = editor.bytes();
        editor.state().setTool(ToolId::BrushCreate);
        const QImage openedPicture = editor.picture();
        editor.state().selection().selectAll();
        QTest::keyClick(&editor.view(), Qt::Key_Delete);
        QCOMPARE(editor.people(), std::size_t{0});

        model::BrushSettings create = editor.state().brush(model::BrushKind::Create);
        create.selection = model::BrushSelection::AllInCircle;
        create.through = true;
        create.radiusPixels = 26.0F;
        editor.state().setBrush(create);
        editor.state().setTool(ToolId::BrushCreate);
        const QSize size = editor.view().size();
        for (int y = 20; y < size.height() - 20 && editor.people() < 200; y += 24) {
            editor.drag({10, y}, {size.width() - 10, y});
        }
        QVERIFY2(editor.people() >= 200, qPrintable(QString::number(editor.people())));
        const auto seats = editor.window.document().scene().population.column(model::columns::seat);
        QVERIFY(std::none_of(seats.begin(), seats.end(),
                             [](model::SeatId seat) { return seat == model::kNoSeat; }));

        const QImage seated = editor.picture();
        model::BrushSettings colour = editor.state().brush(model::BrushKind::Colour);
        colour.selection = model::BrushSelection::Rectangle;
        colour.through = true;
        editor.state().setBrush(colour);
        editor.state().setTool(ToolId::BrushColour);
        editor.drag({size.width() / 4, size.height() / 5},
                    {size.width() * 3 / 4, size.height() * 4 / 5});
        editor.state().setTool(ToolId::BrushCreate);
        paintedBytes = editor.bytes();
        paintedPicture = editor.picture();
        QVERIFY(paintedPicture != seated);

        QUndoStack& undo = editor.window.document().undoStack();
        const int steps = undo.count();
        while (undo.canUndo()) {
            undo.undo();
        }
        QCOMPARE(editor.bytes(), openedBytes);
        QCOMPARE(editor.state().selection().size(), editor.people()); // again, as they were deleted
        editor.state().selection().clear();
        QVERIFY(editor.picture() == openedPicture);
        while (undo.canRedo()) {
            undo.redo();
        }
        QCOMPARE(undo.count(), steps);
        QCOMPARE(editor.bytes(), paintedBytes);
        QVERIFY(editor.picture() == paintedPicture);
        QVERIFY(editor.window.files().save());
        QVERIFY(!editor.window.document().isModified());
    }
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll().toStdString(), paintedBytes);
    Editor reopened;
    QVERIFY(reopened.open(path));
    reopened.state().setTool(ToolId::BrushCreate);
    QCOMPARE(reopened.bytes(), paintedBytes);
    QVERIFY(reopened.picture() == paintedPicture);
}

CROWD_WINDOW_TEST(TestEditorAudience)
#include "tst_EditorAudience.moc"
