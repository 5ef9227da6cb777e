// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "model/document/SceneEdit.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QMenu;

namespace crowd::widgets {

class FieldForm;

/// The scene's light, all that is described of it, and ready-made ones. A drag of a slider is one
/// undo step, and seen while it lasts. Main thread.
class LightDock : public DockBase
{
    Q_OBJECT

public:
    LightDock(EditorState& state, QWidget* parent);
    ~LightDock() override;

private:
    [[nodiscard]] QWidget* makeReady();
    void makeForm();
    void change(const std::function<void(void*)>& apply);
    void put(const model::Lighting& light);
    void hold(bool isHeld);

    EditorState& m_state;
    std::unique_ptr<model::SceneEdit> m_edit; ///< while a slider is held
    FieldForm* m_form = nullptr;              ///< child
};

} // namespace crowd::widgets
