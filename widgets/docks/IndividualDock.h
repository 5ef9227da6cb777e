// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QTimer>

#include "widgets/docks/DockBase.h"
#include "widgets/docks/NumberField.h"
#include "widgets/state/EditorState.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QToolButton;

namespace crowd::widgets {

/// The properties of whoever is selected, several at once ("mixed" where they differ). Every edit
/// is one undo step over all of them.
class IndividualDock : public DockBase
{
    Q_OBJECT

public:
    IndividualDock(EditorState& state, QWidget* parent);

private:
    struct SlotRow
    {
        QString slot;
        QToolButton* color;
        QComboBox* choice;
    };
    struct FloatRow
    {
        NumberField* field;
        model::ColumnKey<float> column;
        double scale; ///< shown = stored × scale
    };

    void buildNumbers(QFormLayout* form);
    void addFloat(QFormLayout* form, const QString& label, model::ColumnKey<float> column,
                  double low, double high, int decimals, double scale);
    void rebuildSlots();
    void refresh();
    void refreshSlots();
    void setPosition(int axis, double value);
    void setFloat(model::ColumnKey<float> column, float value);
    void setClip(const QString& name);
    void setTint(const QString& slot);
    void setChoice(const QString& slot, int choice);
    void setPart(int part, bool isShown);
    void setGroup(double group);
    template<class T>
    void write(model::ColumnKey<T> column, const std::vector<T>& values, const QString& undoText);
    [[nodiscard]] const model::TemplateEntry* entryOf(model::IndividualId id) const;
    [[nodiscard]] const model::TemplateEntry* firstEntry() const;

    EditorState& m_state;
    QLabel* m_title;
    QWidget* m_content;
    std::array<NumberField*, 3> m_position{};
    std::vector<FloatRow> m_floats;
    QComboBox* m_clip;
    NumberField* m_group;
    QLabel* m_seat;
    QWidget* m_slotArea;
    std::vector<SlotRow> m_slots;
    std::vector<QCheckBox*> m_parts;
    model::TemplatePtr m_slotsOf; ///< whose slots are shown
    QTimer m_refresh;             ///< many changes in a stroke make few refreshes
    bool m_isFilling = false;
};

} // namespace crowd::widgets
