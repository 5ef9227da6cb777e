// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <QtCore/QObject>
#include <QtCore/QPointF>
#include <QtCore/QTimer>

#include "widgets/tools/NavigateDrag.h"
#include "widgets/tools/SceneQueries.h"
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// Decides who gets an event: the session in progress, navigation, or the active tool. A state
/// machine without a window: idle, or one session that owns everything of its drag. Main thread.
class ToolController : public QObject
{
    Q_OBJECT

public:
    explicit ToolController(EditorState& state);
    ~ToolController() override;

    /// The window has shortcuts of its own, which can be changed: only keys that are no action of
    /// the window's stay here.
    void leaveShortcutsToWindow() { m_hasShortcuts = false; }

    [[nodiscard]] SceneQueries& queries() { return m_queries; }
    [[nodiscard]] const ToolPicture& picture() const { return m_picture; }
    [[nodiscard]] bool isDragging() const { return m_session != nullptr; }
    /// The session goes on without a button; the pointer should be kept in the picture.
    [[nodiscard]] bool isHandsFree() const { return m_session && m_session->isHandsFree(); }
    /// A frame is wanted: a session runs, or the preview under the cursor is out of date.
    [[nodiscard]] bool needsTick() const { return m_session || m_isPreviewStale; }
    /// Whether the viewport takes a key before any shortcut of the window does.
    [[nodiscard]] bool claimsKey(int key, Qt::KeyboardModifiers modifiers) const;

    void press(const ToolInput& input);
    void move(const ToolInput& input);
    void release(const ToolInput& input);
    void wheel(const WheelInput& input);
    bool keyDown(const KeyInput& input); ///< true when used
    bool keyUp(const KeyInput& input);
    void togglePlaying();
    /// Once a frame; `resting` is the last input at the present time.
    void tick(const ToolInput& resting, double elapsedSeconds);
    void leave();
    /// The keyboard belongs to somebody else now: keys held are up.
    void loseKeys();
    /// Takes back the drag in progress; what was done stays done.
    void cancel();
    /// All that is said here is said again, in another language.
    void renewTexts();
    /// The pointer was put elsewhere by the viewport: no movement of the hand.
    void pointerPlaced(const ToolInput& input);

Q_SIGNALS:
    /// What is drawn over the scene is another one.
    void pictureChanged();
    /// Ghosts or the hovered person are others: the scene is to be drawn again.
    void scenePreviewChanged();
    void paletteRequested(const QPointF& position);

private:
    [[nodiscard]] Tool& activeTool() const;
    [[nodiscard]] DragSessionPtr sessionFor(const ToolInput& input);
    bool takeWhatIsAskedFor(const ToolInput& input);
    void takePoint(const ToolInput& input);
    void takePerson(const ToolInput& input);
    [[nodiscard]] bool isNavigation(const ToolInput& input) const;
    void showModifiers(const KeyInput& input);
    bool spaceDown(const KeyInput& input);
    bool spaceUp(const KeyInput& input);
    [[nodiscard]] ToolInput monotonic(ToolInput input);
    bool runShortcut(const KeyInput& input);
    bool escape();
    void forgetSources();
    void finish();
    void refreshPicture();
    void replacePicture(ToolPicture picture);
    void refreshHint();
    void changeBrush(const model::BrushSettings& settings, bool saysNumber);
    void followRefusals();
    void addRefusal(ToolPicture& picture) const;

    EditorState& m_state;
    SceneQueries m_queries;
    std::array<std::unique_ptr<Tool>, static_cast<std::size_t>(ToolId::Count)> m_tools;
    DragSessionPtr m_session;
    double m_pressSeconds = 0.0;
    int m_pressIndex = 0; ///< of the undo stack, before it
    Qt::MouseButton m_sessionButton = Qt::NoButton;
    WheelDolly m_wheel;
    ToolPicture m_picture;
    QString m_refusal; ///< said at the cursor for a while
    QTimer m_refusalTime;
    std::optional<ToolInput> m_pointer; ///< last input; nothing while outside
    bool m_hasShortcuts = true;
    bool m_isPreviewStale = false;
    double m_lastSeconds = 0.0;
    bool m_isSpaceHeld = false;
    bool m_isSpaceUsed = false;
    double m_spaceSeconds = 0.0;
    double m_spaceUpSeconds = -1.0;
};

} // namespace crowd::widgets
