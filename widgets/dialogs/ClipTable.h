// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtWidgets/QTableWidget>

#include "model/template/Template.h"

class QDoubleSpinBox;

namespace crowd::widgets {

/// The clips of a character that is being imported: name, length, and the ground speed, which can
/// be edited. The current row is the clip to be shown. Main thread only.
class ClipTable : public QTableWidget
{
    Q_OBJECT

public:
    ClipTable(const model::Template& asset, QWidget* parent);

    /// The speeds of the same clips after another import; those edited by hand stay.
    void follow(const model::Template& asset);
    /// One per clip, metres a second, NaN where the file's own speed stands; empty when none was
    /// edited.
    [[nodiscard]] std::vector<float> editedSpeeds() const;
    [[nodiscard]] int shownClip() const { return std::max(currentRow(), 0); }

private:
    void addRow(int row, const model::Clip& clip, bool isDefault);
    [[nodiscard]] QDoubleSpinBox* speedBox(int row) const;

    std::vector<double> m_fromFile; ///< as the boxes show them, rounded
};

} // namespace crowd::widgets
