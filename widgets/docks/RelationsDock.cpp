// SPDX-License-Identifier: MIT
#include "widgets/docks/RelationsDock.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include <QtCore/QLocale>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "widgets/commands/RelationCommands.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/state/RelationTexts.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kRelationRows = 8; ///< seen at once
constexpr int kRelationsRebuildMs = 30;
constexpr int kRelationsCountMs = 300;
constexpr int kRelationIdRole = Qt::UserRole;

/// All but the name, which the list lets edit.
std::span<const model::FieldInfo> relationFields()
{
    static const std::vector<model::FieldInfo> kShown = [] {
        std::vector<model::FieldInfo> shown;
        for (const model::FieldInfo& field : model::fieldsOf<model::RelationKind>()) {
            if (std::string_view(field.meta.key) != "name") {
                shown.push_back(field);
            }
        }
        return shown;
    }();
    return kShown;
}

QIcon relationSwatch(const model::PaintColor& color)
{
    return swatchIcon(QColor(color[0], color[1], color[2]));
}

} // namespace

RelationsDock::RelationsDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Relations"), "relations", parent), m_state(state), m_shows(new QCheckBox(this)),
      m_kinds(new QListWidget(this)), m_note(new QLabel(this)), m_formPlace(new QVBoxLayout)
{
    m_shows->setObjectName(QStringLiteral("showRelations"));
    m_shows->setText(tr("Show in the picture"));
    m_shows->setToolTip(tr("Arcs to whom the selected are related; of all where nobody is "
                           "selected"));
    m_kinds->setObjectName(QStringLiteral("relationKinds"));
    m_kinds->setFrameShape(QFrame::NoFrame);
    m_kinds->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_kinds->setContextMenuPolicy(Qt::CustomContextMenu);
    m_kinds->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_note->setObjectName(QStringLiteral("relationsNote"));
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_shows);
    layout->addWidget(buttons());
    layout->addWidget(m_kinds);
    layout->addWidget(m_note);
    layout->addLayout(m_formPlace);
    layout->addStretch(1);
    setScrolledContent(content);
    connectParts();
    connectList();
    makeForm();
    fill();
}

QWidget* RelationsDock::buttons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    m_chosenButtons = new QWidget(row);
    auto* chosenRow = new QHBoxLayout(m_chosenButtons);
    chosenRow->setContentsMargins(0, 0, 0, 0);
    const auto addButton = [this](QBoxLayout* to, const char* icon, const QString& tip,
                                  const char* name, auto act) {
        QToolButton* button = panelButton(to->parentWidget(), icon, tip, name);
        connect(button, &QToolButton::clicked, this, act);
        to->addWidget(button);
    };
    addButton(layout, "add", tr("Add a kind of relation"), "addRelation", [this] {
        const model::RelationKindId made = addRelationKind(m_state);
        fill();
        edit(made);
    });
    addButton(chosenRow, "to-brush", tr("Paint the chosen relation"), "paintRelation",
              [this] { paintChosen(); });
    addButton(chosenRow, "relate", tr("Relate each of the selected to each"), "relateSelected",
              [this] { relateSelected(m_state, chosenId()); });
    addButton(chosenRow, "remove", tr("Take the relation away from the selected"),
              "unrelateSelected", [this] { unrelateSelected(m_state, chosenId()); });
    addButton(chosenRow, "select-all", tr("Select who has such a relation"), "selectRelated",
              [this] { selectThoseRelated(m_state, chosenId()); });
    addButton(chosenRow, "larger", tr("Select also who is related so to the selected"),
              "growRelated", [this] { growSelectionToRelated(m_state, chosenId()); });
    chosenRow->addStretch(1);
    addButton(chosenRow, "delete", tr("Remove the chosen kind with its relations"),
              "removeRelation", [this] { removeRelationKind(m_state, chosenId()); });
    layout->addWidget(m_chosenButtons, 1);
    return row;
}

void RelationsDock::connectParts()
{
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kRelationsRebuildMs);
    connect(&m_rebuild, &QTimer::timeout, this, &RelationsDock::fill);
    m_count.setSingleShot(true);
    m_count.setInterval(kRelationsCountMs);
    connect(&m_count, &QTimer::timeout, this, &RelationsDock::count);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::RelationKindsChanged, model::SceneReplaced>(change)) {
                    m_rebuild.start();
                }
                if (isOneOf<model::RelationsChanged, model::SceneReplaced>(change)) {
                    m_count.start();
                }
            });
    connect(&m_state.document(), &model::SceneDocument::editRefused, &m_rebuild,
            qOverload<>(&QTimer::start));
    connect(this, &QDockWidget::visibilityChanged, &m_count, qOverload<>(&QTimer::start));
    connect(m_shows, &QCheckBox::clicked, this, [this](bool isOn) {
        ViewOptions options = m_state.viewOptions();
        options.showRelations = isOn;
        m_state.setViewOptions(options);
    });
    // With the brush in hand they are always shown.
    const auto refresh = [this] {
        m_shows->setChecked(m_state.showsRelations());
        m_shows->setEnabled(m_state.tool() != ToolId::BrushRelation);
    };
    connect(&m_state, &EditorState::viewOptionsChanged, this, refresh);
    connect(&m_state, &EditorState::toolChanged, this, refresh);
    connect(&m_state, &EditorState::brushChanged, this, &RelationsDock::followBrush);
    refresh();
}

void RelationsDock::connectList()
{
    connect(m_kinds, &QListWidget::currentRowChanged, this, [this] {
        if (!m_isFilling) {
            showKind();
            chooseForBrush();
        }
    });
    connect(m_kinds, &QListWidget::customContextMenuRequested, this, &RelationsDock::showMenu);
    removeByKey(*m_kinds, [this] { removeRelationKind(m_state, chosenId()); });
    connect(m_kinds, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!m_isFilling) {
            const auto id =
                static_cast<model::RelationKindId>(item->data(kRelationIdRole).toUInt());
            (void)renameRelationKind(m_state, id, item->text());
            m_rebuild.start(); // what was refused gets its old name back
        }
    });
}

model::RelationKindId RelationsDock::chosenId() const
{
    const QListWidgetItem* item = m_kinds->currentItem();
    return item != nullptr
               ? static_cast<model::RelationKindId>(item->data(kRelationIdRole).toUInt())
               : model::RelationKindId{0};
}

const model::RelationKind* RelationsDock::chosen() const
{
    return findRelation(m_state.scene().relationKinds, chosenId());
}

QString RelationsDock::tipFor(int number)
{
    return tr("%n relations of this kind", nullptr, number) + QLatin1Char('\n') +
           tr("Double click or F2: rename");
}

void RelationsDock::addRow(const model::RelationKind& kind)
{
    auto* item = new QListWidgetItem(relationSwatch(kind.color), relationText(kind.name), m_kinds);
    item->setData(kRelationIdRole, kind.id);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setToolTip(tipFor(0)); // until they are counted
}

void RelationsDock::fill()
{
    if (m_kinds->viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    const model::RelationKindId before = chosenId();
    const model::RelationKinds& kinds = m_state.scene().relationKinds;
    m_isFilling = true;
    m_kinds->clear();
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        addRow(kinds[i]);
        if (kinds[i].id == before) {
            m_kinds->setCurrentRow(static_cast<int>(i));
        }
    }
    if (m_kinds->currentRow() < 0 && m_kinds->count() > 0) {
        m_kinds->setCurrentRow(std::max(rowOfBrush(), 0));
    }
    m_isFilling = false;
    if (rowOfBrush() < 0) {
        chooseForBrush(); // what it painted is of another scene, or has gone
    }
    const int rows = std::min(m_kinds->count(), kRelationRows);
    m_kinds->setFixedHeight(rows * m_kinds->sizeHintForRow(0) + 2 * m_kinds->frameWidth() + 4);
    m_kinds->setVisible(m_kinds->count() > 0);
    showKind();
    m_count.start();
}

/// How many there are of the chosen kind, below the list.
void RelationsDock::count()
{
    if (!isVisible()) {
        return;
    }
    std::array<int, model::kMostRelationKinds + 1> counts{};
    for (const model::Relation& each : m_state.scene().relations.all()) {
        ++counts[each.kind];
    }
    m_isFilling = true;
    for (int row = 0; row < m_kinds->count(); ++row) {
        QListWidgetItem* item = m_kinds->item(row);
        const int number = counts[item->data(kRelationIdRole).toUInt()];
        item->setToolTip(tipFor(number));
    }
    m_isFilling = false;
    const int number = counts[chosenId()];
    m_note->setText(chosen() == nullptr
                        ? tr("A relation is who belongs to whom. The button above adds a kind.")
                    : number == 0 ? tr("Nobody is related so yet: drag with the relation brush.")
                                  : tr("%n relations of this kind", nullptr, number));
}

/// The brush paints the kind that is chosen here, and the one it is told is chosen here.
void RelationsDock::chooseForBrush()
{
    if (const model::RelationKind* kind = chosen()) {
        model::BrushSettings brush = m_state.brush(model::BrushKind::Relation);
        brush.as<model::RelationSettings>().relation = kind->name;
        m_state.setBrush(brush);
    }
}

void RelationsDock::paintChosen()
{
    chooseForBrush();
    m_state.setTool(ToolId::BrushRelation);
}

void RelationsDock::followBrush()
{
    const int row = rowOfBrush();
    if (row >= 0 && row < m_kinds->count()) {
        m_kinds->setCurrentRow(row);
    }
}

/// Of the kind that the brush paints; -1: the scene has none of that name.
int RelationsDock::rowOfBrush() const
{
    const model::BrushSettings& brush = m_state.brush(model::BrushKind::Relation);
    const std::string& name = brush.as<model::RelationSettings>().relation;
    const auto& kinds = m_state.scene().relationKinds;
    const auto found = std::ranges::find(kinds, name, &model::RelationKind::name);
    return found != kinds.end() ? static_cast<int>(found - kinds.begin()) : -1;
}

void RelationsDock::showKind()
{
    m_chosenButtons->setEnabled(chosen() != nullptr);
    m_form->setVisible(chosen() != nullptr);
    m_form->refresh();
    m_count.start();
}

void RelationsDock::makeForm()
{
    static const model::RelationKind kNone;
    const FormTarget target{[this]() -> const void* {
                                const model::RelationKind* shown = chosen();
                                return shown != nullptr ? shown : &kNone;
                            },
                            [this](const std::function<void(void*)>& apply) { change(apply); },
                            [this] {
                                return model::FieldContext{&m_state.scene(), nullptr};
                            }};
    m_form = new FieldForm(target, QStringLiteral("relation"), &m_state, this);
    m_form->setObjectName(QStringLiteral("relationForm"));
    m_form->addFields(relationFields());
    m_form->finish();
    m_formPlace->addWidget(m_form);
}

void RelationsDock::change(const std::function<void(void*)>& apply)
{
    if (const model::RelationKind* before = chosen()) {
        model::RelationKind edited = *before;
        apply(&edited);
        changeRelationKind(m_state, edited);
    }
}

void RelationsDock::edit(model::RelationKindId id)
{
    for (int row = 0; row < m_kinds->count(); ++row) {
        if (m_kinds->item(row)->data(kRelationIdRole).toUInt() == id) {
            m_kinds->setCurrentRow(row);
            m_kinds->editItem(m_kinds->item(row));
            showRenaming(*m_kinds);
        }
    }
}

void RelationsDock::showMenu(const QPoint& position)
{
    const QListWidgetItem* item = m_kinds->itemAt(position);
    if (item == nullptr) {
        return;
    }
    QMenu menu(this);
    fillMenu(menu, static_cast<model::RelationKindId>(item->data(kRelationIdRole).toUInt()));
    menu.exec(m_kinds->viewport()->mapToGlobal(position));
}

void RelationsDock::fillMenu(QMenu& menu, model::RelationKindId id)
{
    menu.addAction(iconNamed("to-brush"), tr("Paint It"), this, &RelationsDock::paintChosen);
    menu.addAction(iconNamed("relate"), tr("Relate Each of the Selected to Each"), this,
                   [this, id] { relateSelected(m_state, id); });
    menu.addAction(tr("Take It Away from the Selected"), this,
                   [this, id] { unrelateSelected(m_state, id); });
    menu.addSeparator();
    menu.addAction(tr("Select Who Has It"), this, [this, id] { selectThoseRelated(m_state, id); });
    menu.addAction(tr("Grow Selection to Those Related So"), this,
                   [this, id] { growSelectionToRelated(m_state, id); });
    menu.addSeparator();
    menu.addAction(tr("Rename"), this, [this, id] { edit(id); });
    menu.addAction(iconNamed("delete"), tr("Remove"), this,
                   [this, id] { removeRelationKind(m_state, id); });
}

} // namespace crowd::widgets
