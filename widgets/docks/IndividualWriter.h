// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <string>

#include <QtCore/QCoreApplication>

#include "model/population/Properties.h"
#include "widgets/docks/SelectedPeople.h"
#include "widgets/state/EditorState.h"

namespace crowd::widgets {

/// What the individual panel writes, on all who are selected: each function is one undo step.
/// Nothing is written while nobody is selected or an edit is open. Clips, slots and parts are
/// named, and changed where a template has one of that name. The state outlives it. Main thread
/// only.
class IndividualWriter
{
    Q_DECLARE_TR_FUNCTIONS(IndividualWriter)

public:
    explicit IndividualWriter(EditorState& state) : m_state(state) {}

    void setTemplate(model::TemplateId id);
    /// In metres, along X, Y or Z (0 to 2).
    void setPosition(int axis, double value);
    /// As it is shown: in the unit of the property's label.
    void setNumber(const model::PropertyInfo& property, double shown);
    void setClip(const QString& name);
    /// Names or numbers, as tagListOf() reads them.
    void setTags(const QString& text);
    /// Seats whoever is selected alone on the seat of that number, from 1, of his stage; says in
    /// the status bar where that cannot be.
    void setSeat(double number);
    void standUp();
    void setTint(const std::string& slot, const model::Tint& tint);
    void setTintMode(const std::string& slot, bool isReplacing);
    void setChoice(const std::string& slot, const QString& choice);
    void setPart(const std::string& part, bool isShown);

private:
    using GroupChange =
        std::function<void(model::SceneEdit&, const SelectedPeople&, const SelectedPeople::Group&)>;

    [[nodiscard]] SelectedPeople people() const { return {m_state.scene(), m_state.selection()}; }
    [[nodiscard]] bool mayWrite() const;
    /// One row of the column, for all of them.
    void writeSame(model::ColumnId column, std::span<const std::byte> value,
                   const QString& undoText);
    /// Another change for those of each template.
    void changeGroups(const QString& undoText, const GroupChange& change);

    EditorState& m_state;
};

} // namespace crowd::widgets
