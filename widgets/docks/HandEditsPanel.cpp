// SPDX-License-Identifier: MIT
#include "widgets/docks/HandEditsPanel.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QtCore/QMetaObject>
#include <QtCore/QSignalBlocker>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/commands/HandEditCommands.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/PanelButton.h"

namespace crowd::widgets {

using model::HandEdit;

namespace {

constexpr int kEditRows = 6;
constexpr int kEditsRoom = 4;   ///< logical pixels
constexpr int kEditHeight = 24; ///< room for what switches it off

} // namespace

HandEditsPanel::HandEditsPanel(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_edit(state.document(), this),
      m_areOn(new QCheckBox(tr("Edits by hand"), this)), m_list(new QListWidget(this))
{
    m_areOn->setObjectName(QStringLiteral("handEditsOn"));
    m_areOn->setToolTip(tr("Off: the take is seen as it was kept"));
    m_list->setObjectName(QStringLiteral("handEdits"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(buttons());
    layout->addWidget(m_list);
    makeForm();
    layout->addWidget(m_form);
    connectParts();
    refresh();
}

QWidget* HandEditsPanel::buttons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_areOn);
    layout->addStretch(1);
    const auto add = [row, layout](const char* icon, const QString& tip, const char* name) {
        QToolButton* button = panelButton(row, icon, tip, name);
        layout->addWidget(button);
        return button;
    };
    m_add = add("add", tr("Edit the selected characters of the take"), "addHandEdit");
    m_add->setPopupMode(QToolButton::InstantPopup);
    fillMenu();
    m_select = add("select", tr("Select those whom the chosen edit is for"), "selectEdited");
    connect(m_select, &QToolButton::clicked, this, [this] {
        selectPeopleOf(m_state, static_cast<std::size_t>(std::max(0, m_list->currentRow())));
    });
    m_remove = add("delete", tr("Delete the chosen edit"), "removeHandEdit");
    connect(m_remove, &QToolButton::clicked, this, &HandEditsPanel::removeChosen);
    return row;
}

void HandEditsPanel::removeChosen()
{
    if (m_list->currentRow() >= 0) {
        removeHandEdit(m_state, static_cast<std::size_t>(m_list->currentRow()));
    }
}

void HandEditsPanel::fillMenu()
{
    auto* menu = new QMenu(m_add);
    const std::array<std::pair<QString, HandEditWish>, 6> wishes{
        {{tr("Later or Earlier"), HandEditWish::Later},
         {tr("Slower or Faster"), HandEditWish::Slower},
         {tr("Stand Still"), HandEditWish::Still},
         {tr("Beside Their Way"), HandEditWish::Aside},
         {tr("Hidden"), HandEditWish::Hidden},
         {tr("Somebody Else"), HandEditWish::Swapped}}};
    for (const auto& [text, wish] : wishes) {
        menu->addAction(text, this, [this, wanted = wish] {
            if (addHandEdit(m_state, wanted)) {
                m_list->setCurrentRow(m_list->count() - 1);
            }
        });
    }
    m_add->setMenu(menu);
}

void HandEditsPanel::makeForm()
{
    const FormTarget target{[this]() -> const void* { return &shown(); },
                            [this](const auto& apply) { change(apply); },
                            [this] {
                                return model::FieldContext{&m_state.scene(), nullptr};
                            }};
    m_form = new FieldForm(target, QStringLiteral("handEdit"), &m_state, this);
    m_form->setObjectName(QStringLiteral("handEditForm"));
    m_form->setNotesShown(false);
    m_form->addFields(model::fieldsOf<HandEdit>());
    m_form->finish();
}

void HandEditsPanel::connectParts()
{
    connect(m_form, &FieldForm::held, &m_edit, &HeldEdit::hold);
    connect(m_areOn, &QCheckBox::clicked, this, [this](bool on) { setHandEditsOn(m_state, on); });
    connect(&m_state.selection(), &Selection::changed, this, &HandEditsPanel::refreshButtons);
    connect(m_list, &QListWidget::currentRowChanged, this, &HandEditsPanel::refreshButtons);
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        const auto row = static_cast<std::size_t>(m_list->row(item));
        const bool isOn = item->checkState() == Qt::Checked;
        if (!m_isFilling) { // after the list has done with its click: it is filled anew
            QMetaObject::invokeMethod(
                this, [this, row, isOn] { setHandEditOn(m_state, row, isOn); },
                Qt::QueuedConnection);
        }
    });
}

const std::vector<HandEdit>& HandEditsPanel::edits() const
{
    static const std::vector<HandEdit> kNone;
    const model::Take* take = model::findTake(m_state.scene().takes, m_state.session().take());
    return take != nullptr ? take->edits : kNone;
}

const HandEdit& HandEditsPanel::shown() const
{
    static const HandEdit kNone;
    const auto row = static_cast<std::size_t>(m_list->currentRow()); // none: beyond all
    return row < edits().size() ? edits()[row] : kNone;
}

void HandEditsPanel::change(const std::function<void(void*)>& apply)
{
    const auto row = static_cast<std::size_t>(m_list->currentRow());
    model::Takes takes = withEdits(m_state, [&apply, row](model::Take& take) {
        if (row < take.edits.size()) {
            apply(&take.edits[row]);
        }
    });
    if (!m_edit.put(tr("Change an edit"), [&takes](model::SceneEdit& edit) {
            edit.set<model::members::Takes>(std::move(takes));
        })) {
        m_form->refresh();
    }
}

void HandEditsPanel::refresh()
{
    const model::Take* take = model::findTake(m_state.scene().takes, m_state.session().take());
    setVisible(take != nullptr);
    {
        const QSignalBlocker blocker(m_areOn);
        m_areOn->setChecked(take == nullptr || take->areEditsOn);
    }
    fill(edits());
    refreshButtons();
}

void HandEditsPanel::fill(const std::vector<HandEdit>& edits)
{
    const int before = m_list->currentRow();
    m_isFilling = true;
    while (m_list->count() > static_cast<int>(edits.size())) {
        delete m_list->takeItem(m_list->count() - 1);
    }
    for (std::size_t i = 0; i < edits.size(); ++i) {
        const int row = static_cast<int>(i);
        QListWidgetItem* item =
            row < m_list->count() ? m_list->item(row) : new QListWidgetItem(m_list);
        const QString people =
            tr("%n character(s)", nullptr, static_cast<int>(edits[i].people.size()));
        const QString text = handEditText(edits[i], m_state.scene());
        item->setText(tr("%1 (%2)").arg(text).arg(edits[i].people.size()));
        item->setToolTip(tr("%1: %2").arg(people, text));
        item->setSizeHint({0, kEditHeight});
        item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
        item->setCheckState(edits[i].isOn ? Qt::Checked : Qt::Unchecked);
    }
    m_isFilling = false;
    const int last = m_list->count() - 1;
    m_list->setCurrentRow(before >= 0 ? std::min(before, last) : last);
    const int height = 2 * m_list->frameWidth() + kEditsRoom;
    m_list->setFixedHeight(height + kEditHeight * std::min(m_list->count(), kEditRows));
    m_list->setVisible(m_list->count() > 0);
}

void HandEditsPanel::refreshButtons()
{
    const bool isChosen = m_list->currentRow() >= 0 && !edits().empty();
    m_add->setEnabled(!m_state.selection().isEmpty());
    m_select->setEnabled(isChosen);
    m_remove->setEnabled(isChosen);
    m_areOn->setEnabled(!edits().empty());
    m_form->setVisible(isChosen);
    if (isChosen) {
        m_form->refresh();
    }
}

} // namespace crowd::widgets
