// SPDX-License-Identifier: MIT
#include "widgets/docks/EnvironmentDock.h"

#include <algorithm>

#include <QtCore/QLocale>
#include <QtGui/QStandardItemModel>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "model/document/SceneEdit.h"
#include "model/scene/PlaceShape.h"
#include "widgets/docks/BranchList.h"
#include "widgets/docks/EnvironmentTree.h"
#include "widgets/docks/SurfaceForm.h"
#include "widgets/forms/NumberField.h"
#include "widgets/state/BrushTexts.h"

namespace crowd::widgets {

namespace {

constexpr int kScrollMs = 30;
constexpr int kRowSpacing = 3;

} // namespace

EnvironmentDock::EnvironmentDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Environment"), "environment", parent), m_state(state),
      m_tree(new EnvironmentTree(state, this))
{
    buildContent();
    followTree();
    m_tree->rebuild();
}

/// The tree, what is said below it, and the form of what is chosen.
void EnvironmentDock::buildContent()
{
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_tree, 1);
    m_note =
        new QLabel(tr("No paths yet. Take the path brush (P) and click where characters are to "
                      "walk; then let characters walk along it with the walk brush (W)."),
                   content);
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    layout->addWidget(m_note);
    m_problem = new QLabel(content);
    m_problem->setObjectName(QStringLiteral("placeProblem"));
    m_problem->setWordWrap(true);
    m_problem->setStyleSheet(QStringLiteral("color: %1").arg(kTroubleColor.name()));
    m_problem->hide();
    connect(m_problem, &QLabel::linkActivated, this, &EnvironmentDock::selectTroubled);
    layout->addWidget(m_problem);
    m_form = new QFormLayout;
    m_form->setContentsMargins(4, 0, 4, 0);
    m_form->setVerticalSpacing(kRowSpacing);
    layout->addLayout(m_form);
    buildForm();
    layout->addWidget(new SurfaceForm(m_state, content));
    setScrolledContent(content);
}

void EnvironmentDock::followTree()
{
    connect(m_tree, &EnvironmentTree::rebuilt, this, [this] {
        const bool isEmpty = m_state.scene().places.empty() && m_state.scene().paths.empty();
        m_note->setVisible(isEmpty);
        m_tree->setVisible(!isEmpty); // else the note would stand below an empty list
    });
    connect(m_tree, &EnvironmentTree::chosen, this, [this] {
        refreshForm();
        showProblem();
        m_scroll.start();
    });
    connect(&m_state.document(), &model::SceneDocument::editRefused, this,
            &EnvironmentDock::refreshForm, Qt::QueuedConnection);
    connect(&m_state.session(), &SessionControl::problemsChanged, this, [this] {
        m_tree->showProblems();
        showProblem();
    });
    m_scroll.setSingleShot(true);
    m_scroll.setInterval(kScrollMs);
    connect(&m_scroll, &QTimer::timeout, m_tree, &EnvironmentTree::scrollToSelection);
    connect(this, &QDockWidget::visibilityChanged, &m_scroll, qOverload<>(&QTimer::start));
}

void EnvironmentDock::buildForm()
{
    buildNameRow();
    buildPlaceRows();
    buildPathRows();
}

void EnvironmentDock::buildNameRow()
{
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("placeName"));
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        const std::string name = m_name->text().toStdString();
        if (place() != nullptr) {
            changePlace(tr("Rename a place"), [&](model::Place& each) { each.name = name; });
        } else {
            changePath(tr("Rename a path"), [&](model::Path& each) { each.name = name; });
        }
    });
    m_color = new QToolButton(this);
    m_color->setObjectName(QStringLiteral("placeColour"));
    m_color->setToolTip(tr("Colour in the picture"));
    m_color->setAccessibleName(tr("Colour"));
    connect(m_color, &QToolButton::clicked, this, &EnvironmentDock::chooseColor);
    m_nameRow = new QHBoxLayout;
    m_nameRow->addWidget(m_name, 1);
    m_nameRow->addWidget(m_color);
    m_form->addRow(tr("Name"), m_nameRow);
}

void EnvironmentDock::buildPlaceRows()
{
    m_positionRow = new QHBoxLayout;
    for (int axis = 0; axis < 3; ++axis) {
        m_position[axis] = new NumberField(-1e5, 1e5, 2, this);
        m_positionRow->addWidget(m_position[axis]);
        connect(m_position[axis], &NumberField::valueEdited, this, [this, axis](double value) {
            changePlace(tr("Move a place"), [&](model::Place& each) {
                each.position[axis] = static_cast<float>(value);
            });
        });
    }
    m_form->addRow(tr("X, Y, Z, m"), m_positionRow);
    buildSizeRow();
    buildShapeRow();
    m_role = new QComboBox(this);
    m_role->setObjectName(QStringLiteral("placeRole"));
    m_role->addItems(placeRoleNames());
    for (int role = 0; role < m_role->count(); ++role) {
        m_role->setItemData(role, placeRoleTip(static_cast<model::PlaceRole>(role)),
                            Qt::ToolTipRole);
    }
    m_form->addRow(tr("Is"), m_role);
    connect(m_role, &QComboBox::activated, this, [this](int index) {
        changePlace(tr("Change what a place is"),
                    [&](model::Place& each) { each.role = static_cast<model::PlaceRole>(index); });
    });
    m_speedShare =
        new NumberField(static_cast<double>(model::kMinSpeedShare) * 100.0, 100.0, 0, this);
    m_speedShare->setObjectName(QStringLiteral("placeSpeed"));
    m_form->addRow(tr("Speed, %"), m_speedShare);
    connect(m_speedShare, &NumberField::valueEdited, this, [this](double value) {
        changePlace(tr("Change the speed on slow ground"), [&](model::Place& each) {
            each.speedShare = static_cast<float>(value / 100.0);
        });
    });
}

void EnvironmentDock::buildSizeRow()
{
    m_radius = new NumberField(model::kMinPlaceRadius, model::kMaxPlaceRadius, 2, this);
    m_radius->setObjectName(QStringLiteral("placeRadius"));
    connect(m_radius, &NumberField::valueEdited, this, [this](double value) {
        changePlace(tr("Resize a place"),
                    [&](model::Place& each) { each.radius = static_cast<float>(value); });
    });
    m_capacity = new NumberField(0.0, static_cast<double>(model::kMaxPlaceCapacity), 0, this);
    m_capacity->setObjectName(QStringLiteral("placeCapacity"));
    m_capacity->setZeroText(tr("all who fit"));
    m_capacity->setToolTip(tr("So many have room, for rules that ask whether it is full or free; "
                              "0: as many as can stand in it, two on a square metre, but one where "
                              "characters line up"));
    connect(m_capacity, &NumberField::valueEdited, this, [this](double value) {
        changePlace(tr("Change the room of a place"),
                    [&](model::Place& each) { each.capacity = static_cast<std::uint32_t>(value); });
    });
    m_sizeLabel = new QLabel(tr("Radius, m"), this);
    m_sizeLabel->setBuddy(m_radius);
    m_form->addRow(m_sizeLabel, m_radius);
    m_form->addRow(tr("Room for"), m_capacity);
}

void EnvironmentDock::buildShapeRow()
{
    m_shape = new QComboBox(this);
    m_shape->setObjectName(QStringLiteral("placeShape"));
    for (const model::FieldChoice& choice : model::kPlaceShapes) {
        m_shape->addItem(fieldText(choice.label));
        m_shape->setItemData(m_shape->count() - 1, fieldText(choice.tip), Qt::ToolTipRole);
    }
    m_shapeFacts = new QLabel(this);
    m_shapeFacts->setObjectName(QStringLiteral("placeShapeFacts"));
    m_shapeFacts->setMinimumWidth(1);
    m_shapeFacts->setEnabled(false);
    m_form->addRow(tr("Shape"), m_shape);
    m_form->addRow(QString(), m_shapeFacts);
    connect(m_shape, &QComboBox::activated, this, [this](int index) {
        changePlace(tr("Change the shape of a place"), [&](model::Place& each) {
            model::Place changed = each;
            changed.shape = static_cast<model::PlaceShape>(index);
            each = model::isWhole(changed) ? changed : each; // others may have fewer corners
        });
    });
}

/// A round one has no corners that it could be anything else over, unless it had some before.
void EnvironmentDock::showShape(const model::Place& place)
{
    m_form->setRowVisible(m_shape, !place.corners.empty());
    m_form->setRowVisible(m_shapeFacts, !place.corners.empty());
    m_shape->setCurrentIndex(static_cast<int>(place.shape));
    for (int i = 0; i < m_shape->count(); ++i) {
        model::Place other = place;
        other.shape = static_cast<model::PlaceShape>(i);
        qobject_cast<QStandardItemModel*>(m_shape->model())
            ->item(i)
            ->setEnabled(model::isWhole(other));
    }
    m_shapeFacts->setText(
        tr("%n corner(s), %1 m²", nullptr, static_cast<int>(place.corners.size()))
            .arg(QLocale().toString(static_cast<double>(model::areaOf(place)), 'f', 1)));
    m_shapeFacts->setToolTip(m_shapeFacts->text()); // a narrow panel cuts it
    const bool isLine = place.shape == model::PlaceShape::Line;
    m_sizeLabel->setText(isLine                                   ? tr("Half width, m")
                         : place.shape == model::PlaceShape::Area ? tr("Margin, m")
                                                                  : tr("Radius, m"));
}

void EnvironmentDock::buildPathRows()
{
    m_kind = new QComboBox(this);
    m_kind->setObjectName(QStringLiteral("pathKind"));
    m_kind->addItems({tr("Characters stop"), tr("On to the first place"), tr("Jump to the first")});
    m_form->addRow(tr("At the end"), m_kind);
    connect(m_kind, &QComboBox::activated, this, [this](int index) {
        changePath(tr("Change the end of a path"),
                   [&](model::Path& each) { each.kind = static_cast<model::PathKind>(index); });
    });
    m_branches = new BranchList(m_state, this);
    m_form->addRow(m_branches);
}

const model::Place* EnvironmentDock::place() const
{
    const auto& places = m_state.paths().places();
    return places.empty() ? nullptr : m_state.scene().findPlace(places.front());
}

const model::Path* EnvironmentDock::path() const
{
    return m_state.scene().findPath(m_state.paths().path());
}

/// Of all selected places at once.
void EnvironmentDock::changePlace(const QString& undoText,
                                  const std::function<void(model::Place&)>& change)
{
    if (m_isFilling) {
        return;
    }
    const std::vector<model::PlaceId> places = m_state.paths().places();
    m_state.document().edit(undoText, [&](model::SceneEdit& edit) {
        for (const model::PlaceId id : places) {
            model::Place changed = *m_state.scene().findPlace(id);
            change(changed);
            edit.changePlace(changed);
        }
    });
}

void EnvironmentDock::changePath(const QString& undoText,
                                 const std::function<void(model::Path&)>& change)
{
    if (m_isFilling || path() == nullptr) {
        return;
    }
    model::Path changed = *path();
    change(changed);
    m_state.document().edit(undoText, [&](model::SceneEdit& edit) { edit.changePath(changed); });
}

void EnvironmentDock::refreshForm()
{
    const model::Place* shownPlace = place();
    const model::Path* shownPath = shownPlace == nullptr ? path() : nullptr;
    const bool hasAny = shownPlace != nullptr || shownPath != nullptr;
    m_isFilling = true;
    m_form->setRowVisible(m_nameRow, hasAny);
    m_form->setRowVisible(m_positionRow, shownPlace != nullptr);
    m_form->setRowVisible(m_radius, shownPlace != nullptr);
    m_form->setRowVisible(m_capacity, shownPlace != nullptr);
    m_form->setRowVisible(m_shape, false);
    m_form->setRowVisible(m_shapeFacts, false);
    m_form->setRowVisible(m_role, shownPlace != nullptr);
    m_form->setRowVisible(m_speedShare,
                          shownPlace != nullptr && shownPlace->role == model::PlaceRole::Slow);
    m_form->setRowVisible(m_kind, shownPath != nullptr);
    m_form->setRowVisible(m_branches, shownPath != nullptr);
    m_branches->setPath(shownPath != nullptr ? shownPath->id : 0);
    if (shownPlace != nullptr) {
        m_name->setText(QString::fromStdString(shownPlace->name));
        m_color->setIcon(colorIcon(shownPlace->color));
        for (int axis = 0; axis < 3; ++axis) {
            m_position[axis]->setValue(static_cast<double>(shownPlace->position[axis]));
        }
        m_radius->setValue(static_cast<double>(shownPlace->radius));
        m_capacity->setValue(static_cast<double>(shownPlace->capacity));
        m_role->setCurrentIndex(static_cast<int>(shownPlace->role));
        showShape(*shownPlace);
        m_speedShare->setValue(static_cast<double>(shownPlace->speedShare) * 100.0);
    } else if (shownPath != nullptr) {
        m_name->setText(QString::fromStdString(shownPath->name));
        m_color->setIcon(colorIcon(shownPath->color));
        m_kind->setCurrentIndex(static_cast<int>(shownPath->kind));
    }
    m_isFilling = false;
}

void EnvironmentDock::chooseColor()
{
    const model::Place* shown = place();
    const auto now = shown != nullptr    ? shown->color
                     : path() != nullptr ? path()->color
                                         : std::array<std::uint8_t, 3>{};
    const QColor chosen = QColorDialog::getColor(QColor(now[0], now[1], now[2]), this);
    if (!chosen.isValid()) {
        return;
    }
    const std::array<std::uint8_t, 3> color{static_cast<std::uint8_t>(chosen.red()),
                                            static_cast<std::uint8_t>(chosen.green()),
                                            static_cast<std::uint8_t>(chosen.blue())};
    if (shown != nullptr) {
        changePlace(tr("Colour a place"), [&](model::Place& each) { each.color = color; });
    } else {
        changePath(tr("Colour a path"), [&](model::Path& each) { each.color = color; });
    }
}

/// Above the form: of what is chosen, or of people, whom a click selects.
void EnvironmentDock::showProblem()
{
    QString text = m_tree->problemOfChosen();
    const std::vector<behavior::Problem>& problems = m_state.session().problems();
    const auto ofPeople = std::ranges::find_if(
        problems, [](const behavior::Problem& problem) { return !problem.people.empty(); });
    if (text.isEmpty() && ofPeople != problems.end()) {
        text = tr("%1 <a href=\"people\">Select them</a>")
                   .arg(model::translated(ofPeople->text).toHtmlEscaped());
    }
    m_problem->setText(text);
    m_problem->setVisible(!text.isEmpty());
}

void EnvironmentDock::selectTroubled()
{
    for (const behavior::Problem& problem : m_state.session().problems()) {
        if (!problem.people.empty()) {
            m_state.selection().set(problem.people);
            return;
        }
    }
}

} // namespace crowd::widgets
