// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include <QtCore/QTimer>
#include <QtWidgets/QWidget>

#include "widgets/state/EditorState.h"

class QToolButton;
class QVBoxLayout;

namespace crowd::widgets {

/// Tags with their names and colours, and the artist's own numbers with what people begin with;
/// folded away until they are wanted. Every change is one undo step.
class NamesForm : public QWidget
{
    Q_OBJECT

public:
    NamesForm(EditorState& state, QWidget* parent);

private:
    void rebuild();
    void addTagRow(QVBoxLayout* layout, const model::TagName& tag);
    void addNumberRow(QVBoxLayout* layout, const model::NumberName& number);
    void addTag();
    void addNumber();
    void changeTag(std::uint8_t bit, const std::function<void(model::TagName&)>& change);
    void changeNumber(model::NumberId id, const std::function<void(model::NumberName&)>& change);
    void setTags(std::vector<model::TagName> tags, const QString& undoText);
    void setNumbers(std::vector<model::NumberName> numbers, const QString& undoText);

    EditorState& m_state;
    QTimer m_rebuild;
    // Children of this widget.
    QToolButton* m_fold;
    QWidget* m_rows = nullptr;
};

} // namespace crowd::widgets
