// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include <QtCore/QTimer>

#include "model/population/Properties.h"
#include "widgets/docks/DockBase.h"
#include "widgets/docks/IndividualWriter.h"
#include "widgets/docks/SelectedPeople.h"
#include "widgets/forms/NumberField.h"
#include "widgets/state/EditorState.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QToolButton;

namespace crowd::widgets {

class FeatureRows;

/// The properties of whoever is selected, several at once ("mixed" where they differ): those that
/// the table of properties lets the panel write, numbers with a row generated from it. Clips,
/// slots, outfits and parts of several templates are matched by name. Every edit is one undo step
/// over all of them.
class IndividualDock : public DockBase
{
    Q_OBJECT

public:
    IndividualDock(EditorState& state, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct SlotRow
    {
        std::string slot;
        QToolButton* color;
        QComboBox* mode; ///< multiplies, or replaces
        QComboBox* choice;
    };
    struct PartRow
    {
        std::string part;
        QCheckBox* box;
    };
    struct NumberRow
    {
        NumberField* field;
        const model::PropertyInfo* property;
    };

    void connectState();
    void buildForm(QFormLayout* form);
    /// The control of its own that a property has, or a row for its number.
    void addProperty(QFormLayout* form, const model::PropertyInfo& property);
    void addPosition(QFormLayout* form, const model::PropertyInfo& property);
    void addNumber(QFormLayout* form, const model::PropertyInfo& property);
    void addSeat(QFormLayout* form, const model::PropertyInfo& property);
    /// The form of what these people have: their clips, slots and parts.
    void rebuild(const SelectedPeople& people);
    void addSlot(QFormLayout* form, const SelectedPeople& people, const std::string& slot);
    void addPart(QFormLayout* form, const std::string& part, bool isFirst);

    void refresh();
    void refreshTitle(const SelectedPeople& people);
    void refreshNumbers(const SelectedPeople& people);
    void refreshSeat(const SelectedPeople& people);
    void refreshSlots(const SelectedPeople& people);
    void refreshParts(const SelectedPeople& people);

    [[nodiscard]] SelectedPeople people() const { return {m_state.scene(), m_state.selection()}; }
    void chooseTint(const std::string& slot);

    EditorState& m_state;
    IndividualWriter m_write;
    QLabel* m_title;
    QWidget* m_content;
    QComboBox* m_template;
    std::array<NumberField*, 3> m_position{};
    std::vector<NumberRow> m_numbers;
    QComboBox* m_clip;
    QLineEdit* m_tags;
    NumberField* m_seat;
    QLabel* m_seatPlace;
    QToolButton* m_standUp;
    FeatureRows* m_features;
    QWidget* m_slotArea;
    std::vector<SlotRow> m_slots;
    std::vector<PartRow> m_parts;
    /// Whose clips, slots and parts are shown.
    std::vector<std::weak_ptr<const model::Template>> m_builtFor;
    QTimer m_refresh; ///< many changes in a stroke make few refreshes
};

} // namespace crowd::widgets
