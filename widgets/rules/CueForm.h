// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <QtWidgets/QWidget>

#include "model/scene/Scene.h"

class QHBoxLayout;
class QVBoxLayout;

namespace crowd::widgets {

class EditorState;

/// One cue's name, event, number, whom it speaks to and key, to change in place. Shows what it was
/// made with; whoever owns it makes another one when the cue has changed. The state outlives it.
class CueForm : public QWidget
{
    Q_OBJECT

public:
    using Change = std::function<void(model::Cue&)>;
    /// `apply` is called with each change that the artist makes, one undo step each.
    CueForm(EditorState& state, const model::Cue& cue, std::function<void(const Change&)> apply,
            QWidget* parent);

Q_SIGNALS:
    void closed();

private:
    [[nodiscard]] QHBoxLayout* labelledRow(QVBoxLayout* layout, const QString& label);
    void addEvent(QVBoxLayout* layout);
    void addState(QVBoxLayout* layout);
    void addOrder(QVBoxLayout* layout);
    void addReach(QVBoxLayout* layout);
    void addKeys(QHBoxLayout* row);

    EditorState& m_state;
    const model::Scene& m_scene;
    const model::Cue m_cue;
    std::function<void(const Change&)> m_apply;
};

} // namespace crowd::widgets
