// SPDX-License-Identifier: MIT
#pragma once

#include <set>

#include "widgets/tools/Tool.h"

namespace crowd::widgets {

/// Flying: the pointer looks around, W A S D go, Q and E sink and rise, Shift hurries, Control goes
/// slowly, the wheel changes the speed. While a button is held, or hands free until a click.
/// Escape goes back to where it began.
class FlySession : public DragSession
{
public:
    enum class Hold : unsigned char { Button, HandsFree };

    FlySession(const ToolContext& context, Hold hold, const ToolInput& start);

    void update(const ToolInput& input) override;
    void tick(const ToolInput& resting, double elapsedSeconds) override;
    void release(const ToolInput& input) override;
    void cancel() override;
    bool key(const KeyInput& input, bool isDown) override;
    bool wheel(const WheelInput& input) override;
    void place(const ToolInput& input) override { m_last = input.position(); }
    void show(ToolPicture& picture) const override;
    [[nodiscard]] bool isHandsFree() const override { return m_hold == Hold::HandsFree; }

    [[nodiscard]] double metresPerSecond() const { return m_metresPerSecond; }

private:
    [[nodiscard]] glm::vec3 direction() const;

    ToolContext m_context;
    Hold m_hold;
    ViewCamera m_before;
    QPointF m_last;
    std::set<int> m_keys;
    Qt::KeyboardModifiers m_modifiers;
    double m_metresPerSecond = 5.0;
};

} // namespace crowd::widgets
