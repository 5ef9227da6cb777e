// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "widgets/docks/DockBase.h"
#include "widgets/forms/HeldEdit.h"
#include "widgets/state/EditorState.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QVBoxLayout;

namespace crowd::widgets {

class FieldForm;

/// The scene's lights: sun and sky, and those that stand in it; of the chosen one all that is
/// described. A drag of a slider is one undo step, and seen while it lasts. Main thread.
class LightDock : public DockBase
{
    Q_OBJECT

public:
    LightDock(EditorState& state, QWidget* parent);
    ~LightDock() override;

private:
    [[nodiscard]] QWidget* makeButtons();
    [[nodiscard]] QWidget* makeReady();
    void makeSunForm();
    void makeLightForm(); ///< anew where there is one
    [[nodiscard]] const model::Light& shownLight() const;
    void connectParts();
    void fill();
    [[nodiscard]] std::optional<model::LightId> newLight();
    void addRow(const QString& name, model::LightId id, const model::Light* light);
    void choose();     ///< as the list says
    void markChosen(); ///< in the list
    void showChosen();
    void takeItem(const QListWidgetItem& item);
    void changeLighting(const std::function<void(void*)>& apply);
    void changeLight(const std::function<void(void*)>& apply);
    void put(const model::Lighting& light);
    void put(const model::Lights& lights, const QString& undoText);

    EditorState& m_state;
    HeldEdit m_edit;
    QListWidget* m_list = nullptr; ///< children, as all below
    QLabel* m_note = nullptr;
    QWidget* m_remove = nullptr;
    QWidget* m_frame = nullptr;
    QWidget* m_ready = nullptr;
    FieldForm* m_sunForm = nullptr;
    FieldForm* m_lightForm = nullptr;
    QVBoxLayout* m_lightPlace = nullptr;
    bool m_isFilling = false;
    std::vector<model::LightId> m_known; ///< when the list was filled last
};

} // namespace crowd::widgets
