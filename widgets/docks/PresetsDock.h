// SPDX-License-Identifier: MIT
#pragma once

#include "model/base/Result.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/BrushPresets.h"
#include "widgets/state/EditorState.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QMenu;

namespace crowd::widgets {

/// Brushes kept under names: a click sets the brush as one is kept. Main thread.
class PresetsDock : public DockBase
{
    Q_OBJECT

public:
    PresetsDock(EditorState& state, QWidget* parent);

    [[nodiscard]] BrushPresets& presets() { return m_presets; }

private:
    [[nodiscard]] QWidget* buttons();
    void connectParts();
    void rename(const QString& former, const QString& name);
    void fill();
    void filter();
    void use(const QString& name);
    void add();
    void showMenu(const QPoint& position);
    void importFiles();
    void exportTo(const QString& name);
    void say(const model::Result<void>& result);
    void edit(const QString& name);

    EditorState& m_state;
    BrushPresets m_presets;
    QLineEdit* m_search; ///< child
    QListWidget* m_list; ///< child
    QLabel* m_note;      ///< child
    bool m_isFilling = false;
};

} // namespace crowd::widgets
