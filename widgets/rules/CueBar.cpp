// SPDX-License-Identifier: MIT
#include "widgets/rules/CueBar.h"

#include <algorithm>

#include <QtWidgets/QApplication>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/document/SceneEdit.h"
#include "model/rules/RuleSets.h"
#include "widgets/rules/CueForm.h"
#include "widgets/rules/RuleNames.h"
#include "widgets/rules/RuleTexts.h"
#include "widgets/state/Cues.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

namespace {

constexpr int kMostInARow = 2;

QString cueTip(const model::Scene& scene, const model::Cue& cue)
{
    const QString who = cue.reach == model::CueReach::Tagged
                            ? CueBar::tr("those tagged %1").arg(tagText(scene, cue.tag))
                            : cueReachNames()[static_cast<int>(cue.reach)];
    const auto kept = std::ranges::find(scene.states, cue.state, &model::State::id);
    const QString recalls =
        kept == scene.states.end()
            ? QString()
            : CueBar::tr("“%1” is recalled for %2.").arg(QString::fromStdString(kept->name), who);
    const QString sends =
        cue.event.empty()
            ? QString()
            : CueBar::tr("Sends “%1” to %2.").arg(QString::fromStdString(cue.event), who);
    return QStringList{sends, recalls, CueBar::tr("The arrow changes or deletes it.")}
        .join(QLatin1Char(' '))
        .trimmed();
}

} // namespace

CueBar::CueBar(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_grid(new QGridLayout)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    layout->addLayout(m_grid);
    m_grid->setSpacing(3);
    connect(
        &state.document(), &model::SceneDocument::changed, this,
        [this](const model::SceneChange& change) {
            if (isOneOf<model::RulesChanged, model::StatesChanged, model::SceneReplaced>(change)) {
                rebuild();
            }
        });
    rebuild();
}

void CueBar::rebuild()
{
    while (QLayoutItem* item = m_grid->takeAt(0)) {
        if (item->widget() != nullptr) {
            item->widget()->hide();
            item->widget()->deleteLater(); // it may be what was clicked
        }
        delete item;
    }
    m_buttons.clear();
    for (const model::Cue& cue : m_state.scene().cues) {
        m_buttons.push_back(buttonOf(cue));
    }
    auto* add = new QToolButton(this);
    add->setObjectName(QStringLiteral("addCue"));
    add->setText(tr("+ Cue"));
    add->setToolTip(
        tr("A button, with a key if you like, that lets an event happen to characters"));
    add->setAutoRaise(true);
    connect(add, &QToolButton::clicked, this, &CueBar::addCue);
    m_add = add;
    m_inARow = 0;
    arrange();
    showForm();
}

/// As many in a row as their names have room beside each other.
void CueBar::arrange()
{
    int widest = 0;
    for (const QWidget* button : m_buttons) {
        widest = std::max(widest, button->sizeHint().width());
    }
    const int room = (width() - m_grid->spacing() * (kMostInARow - 1)) / kMostInARow;
    const int inARow = widest <= room ? kMostInARow : 1;
    if (inARow == m_inARow) {
        return;
    }
    m_inARow = inARow;
    int index = 0;
    for (QWidget* button : m_buttons) {
        m_grid->addWidget(button, index / inARow, index % inARow); // taken from where it was
        ++index;
    }
    m_grid->addWidget(m_add, index / inARow, index % inARow, Qt::AlignLeft);
    for (int column = 0; column < kMostInARow; ++column) {
        // One alone is no wider than one of several.
        m_grid->setColumnStretch(column, column < inARow ? 1 : 0);
    }
}

void CueBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    arrange();
}

QWidget* CueBar::buttonOf(const model::Cue& cue)
{
    auto* button = new QToolButton(this);
    const QString title = cueTitle(m_state.scene(), cue);
    const QString name =
        cue.reach == model::CueReach::Selected ? tr("%1 (selected)").arg(title) : title;
    button->setText(cue.key.empty() ? name
                                    : tr("%1 · %2").arg(QString::fromStdString(cue.key), name));
    button->setToolTip(cueTip(m_state.scene(), cue));
    button->setObjectName(QStringLiteral("cue%1").arg(cue.id));
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    button->setPopupMode(QToolButton::MenuButtonPopup);
    button->setMenu(menuOf(cue.id, button));
    button->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(button, &QToolButton::clicked, this, [this, cue] { sendCue(m_state, cue); });
    connect(button, &QToolButton::customContextMenuRequested, button, &QToolButton::showMenu);
    return button;
}

QMenu* CueBar::menuOf(model::CueId id, QWidget* parent)
{
    auto* menu = new QMenu(parent);
    connect(menu->addAction(tr("Change")), &QAction::triggered, this, [this, id] { editCue(id); });
    connect(menu->addAction(tr("Delete")), &QAction::triggered, this,
            [this, id] { removeCue(id); });
    return menu;
}

/// Of the cue that is being changed, as it is now.
void CueBar::showForm()
{
    QString focused; // the field that the artist has gone on to
    if (m_form != nullptr) {
        const QWidget* field = QApplication::focusWidget();
        focused = field != nullptr && m_form->isAncestorOf(field) ? field->objectName() : QString();
        m_form->hide();
        m_form->deleteLater(); // one of its fields may have asked for it
        m_form = nullptr;
    }
    const auto& cues = m_state.scene().cues;
    const auto found = std::ranges::find(cues, m_edited, &model::Cue::id);
    if (found == cues.end()) {
        m_edited = 0;
        return;
    }
    auto* form = new CueForm(
        m_state, *found, [this](const auto& apply) { change(apply); }, this);
    connect(form, &CueForm::closed, this, [this] { editCue(0); });
    layout()->addWidget(form);
    m_form = form;
    if (auto* field = focused.isEmpty() ? nullptr : form->findChild<QWidget*>(focused)) {
        field->setFocus(Qt::TabFocusReason);
    }
}

void CueBar::change(const std::function<void(model::Cue&)>& apply)
{
    std::vector<model::Cue> cues = m_state.scene().cues;
    const auto found = std::ranges::find(cues, m_edited, &model::Cue::id);
    if (found != cues.end()) {
        apply(*found);
        setCues(std::move(cues), tr("Change a cue"));
    }
}

void CueBar::setCues(std::vector<model::Cue> cues, const QString& undoText)
{
    m_state.document().edit(undoText,
                            [&](model::SceneEdit& edit) { edit.setCues(std::move(cues)); });
}

void CueBar::addCue()
{
    std::vector<model::Cue> cues = m_state.scene().cues;
    if (cues.size() >= model::kMaxNamed) {
        m_state.showStatus(
            tr("There are %1 cues already, as many as can be.").arg(model::kMaxNamed));
        return;
    }
    cues.push_back(model::nextCue(m_state.scene()));
    m_edited = cues.back().id;
    setCues(std::move(cues), tr("Add a cue"));
}

void CueBar::editCue(model::CueId id)
{
    m_edited = id;
    showForm();
}

void CueBar::removeCue(model::CueId id)
{
    std::vector<model::Cue> cues = m_state.scene().cues;
    std::erase_if(cues, [id](const model::Cue& cue) { return cue.id == id; });
    setCues(std::move(cues), tr("Delete a cue"));
}

} // namespace crowd::widgets
