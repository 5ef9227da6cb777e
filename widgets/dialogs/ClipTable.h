// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <QtWidgets/QTableWidget>

#include "model/template/Template.h"

class QComboBox;
class QDoubleSpinBox;

namespace crowd::widgets {

/// The clips of a character: name, length, and what can be edited, the ground speed and the role:
/// what people stand, walk and sit with. The current row is the clip to be shown. Main thread only.
class ClipTable : public QTableWidget
{
    Q_OBJECT

public:
    ClipTable(const model::Template& asset, QWidget* parent);

    /// Shows what the artist has chosen before: one per clip or fewer, see TemplateEntry.
    void setEdited(const std::vector<float>& speeds,
                   const std::vector<std::optional<model::ClipRole>>& roles);
    /// The speeds of the same clips after another import; those edited by hand stay.
    void follow(const model::Template& asset);
    /// One per clip, metres a second, NaN where the file's own speed stands; empty when none was
    /// edited.
    [[nodiscard]] std::vector<float> editedSpeeds() const;
    /// One per clip, nothing where the proposed role stands; empty when none was chosen.
    [[nodiscard]] std::vector<std::optional<model::ClipRole>> editedRoles() const;
    [[nodiscard]] int shownClip() const { return std::max(currentRow(), 0); }

private:
    void addRow(int row, const model::Clip& clip, bool isDefault);
    [[nodiscard]] QDoubleSpinBox* speedBox(int row) const;
    [[nodiscard]] QComboBox* roleBox(int row) const;
    void setRole(int row, model::ClipRole role);
    [[nodiscard]] model::ClipRole roleIn(int row) const;

    std::vector<double> m_fromFile; ///< as the boxes show them, rounded
    std::vector<model::ClipRole> m_proposed;
    bool m_isNew = true; ///< no asset was followed yet
};

} // namespace crowd::widgets
