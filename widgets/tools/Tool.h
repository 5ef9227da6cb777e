// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <QtCore/QString>

#include "widgets/state/EditorState.h"
#include "widgets/tools/SceneQueries.h"
#include "widgets/tools/ToolInput.h"
#include "widgets/tools/ToolPicture.h"

namespace crowd::widgets {

/// What every tool works with; both outlive tools and sessions.
struct ToolContext
{
    EditorState& state;
    SceneQueries& queries;
};

/// Everything between a press and its release. Made by the tool that accepts the press, owned by
/// the controller, gone with the drag; destruction without release takes back what it did.
class DragSession
{
public:
    DragSession() = default;
    virtual ~DragSession() = default;
    DragSession(const DragSession&) = delete;
    DragSession& operator=(const DragSession&) = delete;

    virtual void update(const ToolInput& input) = 0;
    /// Time goes on: each frame while the button is held. `resting` is the last input, later.
    virtual void tick(const ToolInput& resting, double elapsedSeconds);
    virtual void release(const ToolInput& input) = 0;
    virtual void cancel() = 0;
    /// Keys while dragging; true when used.
    virtual bool key(const KeyInput& input, bool isDown);
    virtual bool wheel(const WheelInput& input);
    /// The pointer jumped without the hand (it was put back into the picture).
    virtual void place(const ToolInput& input);
    virtual void show(ToolPicture& picture) const = 0;
    /// Goes on without a button held until it is ended by a click.
    [[nodiscard]] virtual bool isHandsFree() const { return false; }
};

using DragSessionPtr = std::unique_ptr<DragSession>;

/// A way to use the picture. Tools live as long as the controller and hold no drag state.
class Tool
{
public:
    Tool() = default;
    virtual ~Tool() = default;
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;

    /// What buttons and keys do, for the status bar.
    [[nodiscard]] virtual QString hint() const = 0;
    /// A button goes down; null: not for this tool.
    [[nodiscard]] virtual DragSessionPtr press(const ToolInput& input) = 0;
    /// The pointer rests over the picture with no button down. Cheap: called for every move.
    virtual void hover(const ToolInput& input, ToolPicture& picture) const = 0;
    /// Adds what takes longer (ghosts, who is under the cursor): called once a frame at most.
    virtual void preview(const ToolInput& input, ToolPicture& picture) const;
};

} // namespace crowd::widgets
