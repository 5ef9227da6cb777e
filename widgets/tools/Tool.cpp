// SPDX-License-Identifier: MIT
#include "widgets/tools/Tool.h"

namespace crowd::widgets {

void DragSession::tick(const ToolInput& /*resting*/, double /*elapsedSeconds*/) {}

bool DragSession::key(const KeyInput& /*input*/, bool /*isDown*/)
{
    return false;
}

bool DragSession::wheel(const WheelInput& /*input*/)
{
    return false;
}

void DragSession::place(const ToolInput& /*input*/) {}

void Tool::preview(const ToolInput& /*input*/, ToolPicture& /*picture*/) const {}

} // namespace crowd::widgets
