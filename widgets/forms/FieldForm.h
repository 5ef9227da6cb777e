// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QVBoxLayout>
#include <QtWidgets/QWidget>

#include "model/describe/Field.h"
#include "widgets/forms/ValueSlider.h"

class QToolButton;

namespace crowd::widgets {

class EditorState;

/// Where a form reads and writes: an object that is described by fields, and all it may depend on.
struct FormTarget
{
    /// The object as it is now; valid until the next change.
    std::function<const void*()> read;
    /// Lets a function change a copy of the object, and keeps that.
    std::function<void(const std::function<void(void*)>&)> edit;
    /// What decides which fields are shown, and what references can refer to.
    std::function<model::FieldContext()> context;
};

/// The way from a form's object to a struct inside it.
using FieldPath = std::function<void*(void*)>;

/// Controls for described values, one below the other, made from their descriptions. Every control
/// reads its value when the form is refreshed and writes through the target. A row is shown only
/// where its field's condition holds; sections fold, and stay folded in later sessions.
class FieldForm : public QWidget
{
    Q_OBJECT

public:
    using Condition = std::function<bool()>;

    /// `key` names the form in the preferences; `state` is where points of the picture are chosen;
    /// null: nowhere.
    FieldForm(FormTarget target, QString key, EditorState* state, QWidget* parent);

    /// Controls of all fields that have a label, with those of structs inside.
    void addFields(std::span<const model::FieldInfo> fields, const FieldPath& path = {},
                   const Condition& isShown = {});
    void addField(const model::FieldInfo& field, const FieldPath& path, const Condition& isShown);
    /// What is added from here on folds under the title. `key` names it in the preferences.
    void beginSection(const QString& title, const QString& key);
    void addNote(const QString& text, const Condition& isShown = {});
    /// Of what is added from here on: else what they say is in tool tips alone.
    void setNotesShown(bool areShown) { m_areNotesShown = areShown; }
    /// Whether a list has another length than when its controls were made: the form must be made
    /// anew. refresh() does nothing then.
    [[nodiscard]] bool isOutdated() const;
    void finish();
    void refresh();

    /// A control whose condition holds, folded away or not.
    struct Setting
    {
        QString name;
        QString section; ///< empty: none
        QString tip;
        QWidget* row; ///< child; goes when the form is made anew
    };
    [[nodiscard]] std::vector<Setting> settings() const;
    /// Whether what is set while something is held() becomes one change: somebody sees to it.
    [[nodiscard]] bool isHeldTogether() const;
    /// Unfolds and scrolls to a control, marks it for a moment and gives it the keyboard.
    void reveal(QWidget& row);

Q_SIGNALS:
    void
    held(bool isHeld); ///< a slider is dragged, and no longer: what is set meanwhile is one change

public:
    // For the controls, which have files of their own.

    /// A field in a form: where its object is, and when it is shown.
    struct Bound
    {
        const model::FieldInfo* field; ///< lives as long as the form
        FieldPath path;
        Condition isShown;
    };
    [[nodiscard]] model::FieldValue value(const Bound& bound) const;
    template<class T>
    [[nodiscard]] T valueOf(const Bound& bound) const
    {
        return std::get<T>(value(bound));
    }
    /// Writes what the artist chose; nothing while the form is refreshed.
    void setValue(const Bound& bound, model::FieldValue value);
    /// Another change of the struct that the field is in.
    void change(const Bound& bound, const std::function<void(void*)>& apply);
    [[nodiscard]] const void* object(const Bound& bound) const;
    [[nodiscard]] model::FieldContext context() const { return m_target.context(); }
    [[nodiscard]] EditorState* state() const { return m_state; }
    /// Adds a control; `refresh` shows the value of that moment.
    void bind(QWidget* row, std::function<void()> refresh, Condition isShown);
    void addLabelled(const QString& label, QWidget* control, std::function<void()> refresh,
                     Condition isShown);
    void addChoice(const QString& label, const QStringList& names, std::function<int()> get,
                   std::function<void(int)> set, Condition isShown, const QStringList& tips = {});
    void addSlider(const QString& label, const ValueSlider::Range& range,
                   std::function<double()> get, std::function<void(double)> set, Condition isShown);
    /// What is added until endRow() stands side by side.
    void beginRow();
    void endRow() { m_row = nullptr; }

private:
    bool m_areNotesShown = true;
    struct Section
    {
        QToolButton* header;
        QString key;
        bool isOpen = true;
    };
    struct Row
    {
        QWidget* widget;
        std::function<void()> refresh;
        Condition isShown;
        int section; ///< -1: none
    };

    void addGroup(const Bound& bound);
    void addList(const Bound& bound);
    void addItem(const Bound& list, std::size_t index);
    void addRemoval(const Bound& list, std::size_t index, const Condition& isShown);
    void fold(int section, bool isOpen);
    void foldByHand(int section, bool isOpen);
    void refreshVisibility();

    FormTarget m_target;
    QString m_key;
    EditorState* m_state;
    QVBoxLayout* m_layout;
    QHBoxLayout* m_row = nullptr;   ///< being filled
    std::vector<QWidget*> m_groups; ///< rows of several controls
    std::vector<Section> m_sections;
    std::vector<Row> m_rows;
    struct List
    {
        Bound bound;
        std::size_t items;
    };
    std::vector<List> m_lists; ///< those inside an item come after the list that it is of
    int m_inside = 0;          ///< lists whose items are being added
    bool m_isRefreshing = false;
};

} // namespace crowd::widgets
