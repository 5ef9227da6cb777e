// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <QtCore/QTimer>

#include "model/scene/Feature.h"
#include "widgets/docks/DockBase.h"
#include "widgets/state/EditorState.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QListWidget;
class QListWidgetItem;
class QMenu;
class QToolButton;
class QVBoxLayout;

namespace crowd::widgets {

class FeaturePreview;
class FieldForm;

/// Kinds of features and their values: what people can be like, and what each does to those who
/// bear it, tried on six of them. What is set comes to the scene when the hand rests for a moment,
/// as one undo step. Main thread.
class FeaturesDock : public DockBase
{
    Q_OBJECT

public:
    FeaturesDock(EditorState& state, QWidget* parent);
    ~FeaturesDock() override;

private:
    [[nodiscard]] QWidget* kindRow();
    [[nodiscard]] QWidget* valueButtons();
    void connectParts();
    void connectList();
    void followBrush();
    void leadBrush();
    void follow(const model::SceneChange& change);
    void fill();
    void fillValues();
    void addRow(const model::FeatureValue& value);
    void showValue();
    void rebuildForm();
    void refreshBearers();
    void fillKindMenu();
    void showMenu(const QPoint& position);
    void fillMenu(QMenu& menu, model::FeatureId id);
    void edit(model::FeatureId id);
    void duplicate(model::FeatureId id);
    void showKind(std::uint8_t kind);
    void addNamedKind();
    [[nodiscard]] std::optional<QString> nameAsked(const QString& title, const QString& proposal);
    void renameShownKind();
    void exportShown();
    void importFile();
    /// Another working copy, to come to the scene soon.
    void change(const std::function<void(void*)>& apply);
    void keepChange(); ///< now
    [[nodiscard]] const model::FeatureKind* kind() const;
    [[nodiscard]] const model::FeatureValue* chosen() const; ///< null: none
    [[nodiscard]] model::FeatureId chosenId() const;

    EditorState& m_state;
    std::optional<model::FeatureValue> m_edited; ///< not in the scene yet
    QTimer m_rebuild;
    QTimer m_keep;
    QTimer m_count;
    bool m_isFilling = false;
    bool m_isFormOld = false; ///< it was made for other templates
    // Children of this widget.
    QComboBox* m_kinds;
    QListWidget* m_values;
    FeaturePreview* m_preview;
    QCheckBox* m_isWorn;
    QLabel* m_note;
    QMenu* m_kindMenu;
    QWidget* m_valueButtons = nullptr;
    QVBoxLayout* m_formPlace;
    FieldForm* m_form = nullptr; ///< null: no value is chosen
};

} // namespace crowd::widgets
