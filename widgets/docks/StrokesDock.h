// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <QtCore/QTimer>

#include "model/brush/LastStrokes.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QLabel;
class QListWidget;
class QScrollArea;
class QToolButton;

namespace crowd::widgets {

class FieldForm;

/// The last strokes, newest first: the settings of the chosen one can be changed, and it is laid
/// anew. Main thread.
class StrokesDock : public DockBase
{
    Q_OBJECT

public:
    StrokesDock(EditorState& state, QWidget* parent);

protected:
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QWidget* buttons();
    void connectParts();
    void refresh();
    void fillList();
    void choose(int row);
    void rebuildForm();
    void set(const model::BrushSettings& settings, std::uint64_t seed);
    void lay();

    EditorState& m_state;
    QListWidget* m_list;                 ///< child
    QScrollArea* m_area;                 ///< child; holds the form
    QLabel* m_note;                      ///< child
    QList<QToolButton*> m_buttons;       ///< children
    FieldForm* m_form = nullptr;         ///< null: nothing is chosen
    std::optional<std::size_t> m_chosen; ///< index in the tail
    model::BrushSettings m_settings;     ///< as wanted for it
    std::uint64_t m_seed = 0;
    QTimer m_refresh;
    QTimer m_lay;
    bool m_isFilling = false;
};

} // namespace crowd::widgets
