// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include <QtCore/QFile>
#include <QtCore/QSettings>
#include <QtCore/QStandardPaths>
#include <QtCore/QTemporaryDir>
#include <QtGui/QImage>
#include <QtGui/QMouseEvent>
#include <QtTest/QSignalSpy>
#include <QtTest/QTest>
#include <QtWidgets/QApplication>

#include "app/window/MainWindow.h"
#include "model/project/ProjectWriter.h"

using namespace crowd;
using namespace crowd::widgets;

namespace {

/// The whole editor with a scene file, and a hand with a mouse over its picture.
class Editor
{
public:
    Editor()
    {
        for (QDockWidget* dock : window.docks()) {
            dock->hide(); // a small picture is a quick one
        }
        window.viewport().setFixedSize(540, 360); // whatever size the window had before
        window.resize(560, 460);
        window.show();
        window.activateWindow();
        (void)QTest::qWaitForWindowActive(&window); // shortcuts go to the active one
        state().transport().setPlaying(false);
    }
    [[nodiscard]] bool open(const QString& path)
    {
        QSignalSpy opened(&window.files(), &app::FileController::sceneOpened);
        window.files().openPath(path);
        if (opened.isEmpty() && !opened.wait(60000)) {
            return false;
        }
        state().transport().setPlaying(false);
        state().transport().rewind();
        return QTest::qWaitFor([this] { return isLoaded() && view().drawnFrames() > 0; }, 60000);
    }
    [[nodiscard]] bool isLoaded()
    {
        const model::Scene& scene = window.document().scene();
        const auto has = [](const auto& entry) { return entry.asset != nullptr; };
        return std::all_of(scene.templates.begin(), scene.templates.end(), has) &&
               std::all_of(scene.stages.begin(), scene.stages.end(), has);
    }
    [[nodiscard]] EditorState& state() { return window.state(); }
    [[nodiscard]] ViewportWidget& view() { return window.viewport(); }
    [[nodiscard]] std::size_t people() { return window.document().scene().population.size(); }
    [[nodiscard]] std::string bytes()
    {
        const auto text = model::projectToText(window.document().scene());
        return text ? text.value() : text.error().message;
    }
    /// Of the scene at rest, everything baked, without any brush in it.
    [[nodiscard]] QImage picture()
    {
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&view(), &leave);
        int still = 0;
        for (int tries = 0; still < 2 && tries < 300; ++tries) {
            const int before = view().drawnFrames();
            QTest::qWait(50);
            const bool isAtRest = view().isAtRest() && view().drawnFrames() == before &&
                                  state().keyframes().progress().pendingClips == 0;
            still = isAtRest ? still + 1 : 0;
        }
        return view().grabFramebuffer();
    }
    void drag(QPoint from, QPoint to)
    {
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int step = 1; step <= 24; ++step) {
            send(QEvent::MouseMove, from + (to - from) * step / 24, Qt::NoButton, Qt::LeftButton);
        }
        send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
    }

    app::MainWindow window;

private:
    void send(QEvent::Type type, QPoint at, Qt::MouseButton button, Qt::MouseButtons buttons)
    {
        QMouseEvent event(type, at, view().mapToGlobal(at), button, buttons, Qt::NoModifier);
        event.setTimestamp(m_milliseconds += 25);
        QApplication::sendEvent(&view(), &event);
    }

    quint64 m_milliseconds = 1;
};

QString copyOfTheatre(const QTemporaryDir& folder)
{
    const QString path = folder.filePath(QStringLiteral("audience.crowd"));
    QFile::copy(QStringLiteral(CROWD_RESOURCES "/scenes/theatre.crowd"), path);
    QFile::setPermissions(path, QFile::ReadOwner | QFile::WriteOwner);
    return path;
}

} // namespace

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

int main(int argc, char** argv)
{
    QStandardPaths::setTestModeEnabled(true); // the artist's own settings stay out of it
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("CrowdbrushTests"));
    QApplication::setApplicationName(QStringLiteral("tst_EditorAudience"));
    QSettings().clear();
    TestEditorAudience test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_EditorAudience.moc"
