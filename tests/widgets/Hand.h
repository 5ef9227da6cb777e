// SPDX-License-Identifier: MIT
#pragma once

#include "tests/widgets/SmallTheatre.h"
#include "widgets/state/EditorState.h"
#include "widgets/tools/ToolController.h"

namespace crowd::testing {

/// Of the view that the hand works in, pixels.
inline constexpr QPointF kCenter(320.0, 240.0);

/// A hand with a mouse over the small theatre, without any window.
class Hand
{
public:
    Hand() : state(document), tools(state)
    {
        document.replaceScene(smallTheatre(), {});
        state.setViewSize({640.0F, 480.0F});
        state.transport().setPlaying(false);
    }

    [[nodiscard]] widgets::ToolInput at(QPointF position, Qt::MouseButton button = Qt::NoButton)
    {
        m_time += 0.01;
        widgets::ToolInput input;
        input.pointer = model::PointerInput::at({position.x(), position.y()}, m_time);
        input.button = button;
        input.modifiers = modifiers;
        return input;
    }
    void press(QPointF position, Qt::MouseButton button = Qt::LeftButton)
    {
        tools.press(at(position, button));
    }
    void click(QPointF position)
    {
        press(position);
        release(position);
    }
    /// The second click of a double click.
    void clickAgain(QPointF position)
    {
        widgets::ToolInput second = at(position, Qt::LeftButton);
        second.isSecond = true;
        tools.press(second);
        release(position);
    }
    void move(QPointF position) { tools.move(at(position)); }
    void release(QPointF position, Qt::MouseButton button = Qt::LeftButton)
    {
        tools.release(at(position, button));
    }
    void drag(QPointF from, QPointF to, Qt::MouseButton button = Qt::LeftButton)
    {
        press(from, button);
        for (int step = 1; step <= 8; ++step) {
            move(from + (to - from) * (step / 8.0));
        }
        release(to, button);
    }
    void rest(double seconds)
    {
        for (double passed = 0.0; passed < seconds; passed += 1.0 / 60.0) {
            m_time += 1.0 / 60.0 - 0.01;
            tools.tick(at(m_last), 1.0 / 60.0);
        }
    }
    void hover(QPointF position)
    {
        m_last = position;
        move(position);
        tools.tick(at(position), 1.0 / 60.0);
    }
    bool key(int key, Qt::KeyboardModifiers with = Qt::NoModifier)
    {
        const bool isUsed = tools.keyDown({key, with, false, m_time});
        tools.keyUp({key, with, false, m_time + 0.05});
        return isUsed;
    }
    void letTimePass(double seconds) { m_time += seconds; }
    [[nodiscard]] double now() const { return m_time; }
    [[nodiscard]] QPointF pixelOf(const glm::vec3& point) const
    {
        const auto pixel = model::View(state.camera(), state.viewSize()).project(point);
        return {pixel.value_or(glm::vec3(-1.0F)).x, pixel.value_or(glm::vec3(-1.0F)).y};
    }
    /// Chest of an individual.
    [[nodiscard]] QPointF pixelOf(model::IndividualId id) const
    {
        const model::Population& people = document.scene().population;
        return pixelOf(people.column(model::columns::position)[people.rowOf(id)] +
                       glm::vec3(0.0F, 1.1F, 0.0F));
    }

    model::SceneDocument document;
    widgets::EditorState state;
    widgets::ToolController tools;
    Qt::KeyboardModifiers modifiers;

private:
    double m_time = 100.0;
    QPointF m_last = kCenter;
};

} // namespace crowd::testing
