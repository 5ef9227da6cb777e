// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QtWidgets/QWidget>

#include "widgets/state/EditorState.h"

class QHBoxLayout;

namespace crowd::widgets {

/// Where people leave a path for another one, and how many of them. Every change is one undo step.
class BranchList : public QWidget
{
    Q_OBJECT

public:
    BranchList(EditorState& state, QWidget* parent);
    /// 0: none is shown.
    void setPath(model::PathId path);

private:
    void rebuild();
    void addRow(const model::Path& path, std::size_t index);
    void addPlaces(QHBoxLayout* row, const model::Path& path, std::size_t index);
    void addPaths(QHBoxLayout* row, const model::Path& path, std::size_t index);
    void addBranch();
    void change(const QString& undoText, const std::function<void(model::Path&)>& apply);
    [[nodiscard]] std::vector<const model::Path*> others() const;

    EditorState& m_state;
    model::PathId m_path = 0;
    QWidget* m_rows = nullptr; ///< child of this widget
};

} // namespace crowd::widgets
