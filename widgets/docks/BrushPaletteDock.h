// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QGridLayout;
class QScrollArea;
class QToolButton;

namespace crowd::widgets {

/// The tools as large buttons, as many in a row as there is room for; no higher than they need.
class BrushPaletteDock : public DockBase
{
    Q_OBJECT

public:
    BrushPaletteDock(EditorState& state, QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void refreshIcons();
    void arrange(int width);
    void rebuildScriptBrushes();
    [[nodiscard]] QToolButton* addButton(const QString& name, const QString& tip);
    [[nodiscard]] std::vector<QToolButton*> shownButtons() const;

    EditorState& m_state;
    QScrollArea* m_area;
    QWidget* m_content;
    QGridLayout* m_grid;
    int m_columns = 0;
    std::array<QToolButton*, static_cast<std::size_t>(ToolId::Count)> m_buttons{};
    std::vector<QToolButton*> m_scriptButtons; ///< one for each script brush; children
};

} // namespace crowd::widgets
