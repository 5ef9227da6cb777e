// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <QtWidgets/QFrame>

#include "model/view/PropertyPaint.h"
#include "widgets/state/EditorState.h"

class QComboBox;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace crowd::widgets {

/// People of a frame in the colours of a property, as the look "property" draws them. Sorted anew
/// only when they or the scene are others than before.
class PropertyColours
{
public:
    /// Before the scene is shown again otherwise.
    void forget() { m_version = 0; }
    [[nodiscard]] model::CrowdFramePtr painted(const EditorState& state,
                                               const model::CrowdFramePtr& frame);
    [[nodiscard]] const model::PropertyPaint& paint() const { return m_paint; }
    [[nodiscard]] const model::Population& people() const { return m_people; }

private:
    std::string m_key;
    std::uint64_t m_version = 0; ///< of the people that it is of; 0: none
    model::PropertyPaint m_paint;
    model::Population m_people; ///< painted
};

/// A plate in the lower left corner of the picture: what people are coloured by, to be chosen, and
/// what the colours mean. A click on one selects those who have it, with Shift as well. A child of
/// the viewport. Main thread.
class PropertyLegend : public QFrame
{
    Q_OBJECT

public:
    PropertyLegend(EditorState& state, PropertyColours& colours, QWidget* parent);

    /// After a picture.
    void refresh();
    void place();
    /// In another language.
    void renewTexts();

private:
    void fillChoice();
    void choose(int index);
    void fillRows();
    void select(std::size_t each);
    [[nodiscard]] QString textOf(const model::PropertyClass& each) const;

    EditorState& m_state;
    PropertyColours& m_colours;
    std::vector<std::string> m_keys; ///< in the list
    QString m_shown;                 ///< what the rows say
    // Children of this widget.
    QComboBox* m_choice;
    QVBoxLayout* m_rows;
    std::vector<QToolButton*> m_buttons;
    QLabel* m_more;
};

} // namespace crowd::widgets
