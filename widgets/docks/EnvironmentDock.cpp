// SPDX-License-Identifier: MIT
#include "widgets/docks/EnvironmentDock.h"

#include <algorithm>

#include <QtCore/QLocale>
#include <QtGui/QPainter>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QHeaderView>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QTreeWidget>
#include <QtWidgets/QVBoxLayout>

#include "model/document/SceneEdit.h"
#include "widgets/docks/BranchList.h"
#include "widgets/docks/NumberField.h"
#include "widgets/docks/SurfaceForm.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kRedrawMs = 30;
constexpr QColor kTroubleColor(208, 80, 64);

QIcon swatch(const std::array<std::uint8_t, 3>& color)
{
    QPixmap pixmap(14, 14);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(QColor(color[0], color[1], color[2]));
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(1, 1, 12, 12);
    return pixmap;
}

int peopleOn(const model::Scene& scene, model::PathId path)
{
    const auto followed = scene.population.column(model::columns::path);
    return static_cast<int>(std::count(followed.begin(), followed.end(), path));
}

} // namespace

EnvironmentDock::EnvironmentDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Environment"), "environment", parent), m_state(state),
      m_tree(new QTreeWidget(this))
{
    m_tree->setObjectName(QStringLiteral("environmentTree"));
    setUpOutline(*m_tree);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(m_tree, 1);
    m_note = new QLabel(tr("No paths yet. Take the path brush (P) and click where people are to "
                           "walk; then let people walk along it with the walk brush (W)."),
                        content);
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    layout->addWidget(m_note);
    m_problem = new QLabel(content);
    m_problem->setObjectName(QStringLiteral("placeProblem"));
    m_problem->setWordWrap(true);
    m_problem->setStyleSheet(QStringLiteral("color: %1").arg(kTroubleColor.name()));
    m_problem->hide();
    layout->addWidget(m_problem);
    m_form = new QFormLayout;
    m_form->setContentsMargins(4, 0, 4, 0);
    layout->addLayout(m_form);
    buildForm(m_form);
    m_tree->setMinimumHeight(110);
    layout->addWidget(new SurfaceForm(m_state, content));
    setScrolledContent(content);

    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kRedrawMs);
    connect(&m_rebuild, &QTimer::timeout, this, &EnvironmentDock::rebuild);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                const auto* columns = std::get_if<model::ColumnsChanged>(&change);
                const bool isWalk =
                    columns != nullptr &&
                    (columns->columns & (1U << static_cast<unsigned>(model::ColumnId::Path))) != 0;
                const bool isOther = columns == nullptr &&
                                     !std::holds_alternative<model::LightingChanged>(change) &&
                                     !std::holds_alternative<model::CamerasChanged>(change);
                if ((isWalk || isOther) && !m_rebuild.isActive()) {
                    m_rebuild.start();
                }
            });
    connect(&m_state.paths(), &PathFocus::changed, this, &EnvironmentDock::showSelection);
    connect(&m_state.session(), &SessionControl::problemsChanged, this,
            &EnvironmentDock::showProblems);
    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, &EnvironmentDock::takeSelection);
    connect(m_tree, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
        if (!m_isFilling) {
            rename(item);
        }
    });
    connect(m_tree, &QTreeWidget::customContextMenuRequested, this, &EnvironmentDock::showMenu);
    rebuild();
}

void EnvironmentDock::buildForm(QFormLayout* form)
{
    m_name = new QLineEdit(this);
    m_name->setObjectName(QStringLiteral("placeName"));
    form->addRow(tr("Name"), m_name);
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        const std::string name = m_name->text().toStdString();
        if (place() != nullptr) {
            changePlace(tr("Rename a place"), [&](model::Place& each) { each.name = name; });
        } else {
            changePath(tr("Rename a path"), [&](model::Path& each) { each.name = name; });
        }
    });
    auto* row = new QHBoxLayout;
    for (int axis = 0; axis < 3; ++axis) {
        m_position[axis] = new NumberField(-1e5, 1e5, 2, this);
        row->addWidget(m_position[axis]);
        connect(m_position[axis], &NumberField::valueEdited, this, [this, axis](double value) {
            changePlace(tr("Move a place"), [&](model::Place& each) {
                each.position[axis] = static_cast<float>(value);
            });
        });
    }
    form->addRow(tr("X, Y, Z, m"), row);
    m_radius = new NumberField(model::kMinPlaceRadius, model::kMaxPlaceRadius, 2, this);
    m_radius->setObjectName(QStringLiteral("placeRadius"));
    form->addRow(tr("Radius, m"), m_radius);
    connect(m_radius, &NumberField::valueEdited, this, [this](double value) {
        changePlace(tr("Resize a place"),
                    [&](model::Place& each) { each.radius = static_cast<float>(value); });
    });
    m_capacity = new NumberField(0.0, static_cast<double>(model::kMaxPlaceCapacity), 0, this);
    m_capacity->setObjectName(QStringLiteral("placeCapacity"));
    m_capacity->setToolTip(tr("So many have room, for rules that ask whether it is full or free; "
                              "0: as many as can stand in it, two on a square metre, but one where "
                              "people line up"));
    form->addRow(tr("Room for"), m_capacity);
    connect(m_capacity, &NumberField::valueEdited, this, [this](double value) {
        changePlace(tr("Change the room of a place"),
                    [&](model::Place& each) { each.capacity = static_cast<std::uint32_t>(value); });
    });
    m_role = new QComboBox(this);
    m_role->setObjectName(QStringLiteral("placeRole"));
    m_role->addItems({tr("A place to go to"), tr("Obstacle"), tr("Attracts people"),
                      tr("Repels people"), tr("Exit: people leave"), tr("Slow ground"),
                      tr("Nobody walks there"), tr("Liked ground")});
    form->addRow(tr("Is"), m_role);
    connect(m_role, &QComboBox::activated, this, [this](int index) {
        changePlace(tr("Change what a place is"),
                    [&](model::Place& each) { each.role = static_cast<model::PlaceRole>(index); });
    });
    m_speedShare =
        new NumberField(static_cast<double>(model::kMinSpeedShare) * 100.0, 100.0, 0, this);
    m_speedShare->setObjectName(QStringLiteral("placeSpeed"));
    form->addRow(tr("Speed, %"), m_speedShare);
    connect(m_speedShare, &NumberField::valueEdited, this, [this](double value) {
        changePlace(tr("Change the speed on slow ground"), [&](model::Place& each) {
            each.speedShare = static_cast<float>(value / 100.0);
        });
    });
    m_kind = new QComboBox(this);
    m_kind->setObjectName(QStringLiteral("pathKind"));
    m_kind->addItems({tr("People stop"), tr("On to the first place"), tr("Jump to the first")});
    form->addRow(tr("At the end"), m_kind);
    connect(m_kind, &QComboBox::activated, this, [this](int index) {
        changePath(tr("Change the end of a path"),
                   [&](model::Path& each) { each.kind = static_cast<model::PathKind>(index); });
    });
    m_color = new QToolButton(this);
    m_color->setToolTip(tr("Colour in the picture"));
    form->addRow(tr("Colour"), m_color);
    connect(m_color, &QToolButton::clicked, this, &EnvironmentDock::chooseColor);
    m_people = new QLabel(this);
    form->addRow(tr("People"), m_people);
    m_branches = new BranchList(m_state, this);
    form->addRow(m_branches);
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
    if (m_isFilling || m_state.document().isEditOpen()) {
        return;
    }
    const std::vector<model::PlaceId> places = m_state.paths().places();
    auto edit = m_state.document().beginEdit();
    for (const model::PlaceId id : places) {
        model::Place changed = *m_state.scene().findPlace(id);
        change(changed);
        edit->changePlace(changed);
    }
    edit->commit(undoText);
}

void EnvironmentDock::changePath(const QString& undoText,
                                 const std::function<void(model::Path&)>& change)
{
    if (m_isFilling || path() == nullptr || m_state.document().isEditOpen()) {
        return;
    }
    model::Path changed = *path();
    change(changed);
    auto edit = m_state.document().beginEdit();
    edit->changePath(changed);
    edit->commit(undoText);
}

void EnvironmentDock::rebuild()
{
    if (m_tree->viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    m_isFilling = true;
    m_tree->clear();
    addPaths();
    addPlaces();
    m_isFilling = false;
    const bool isEmpty = m_state.scene().places.empty() && m_state.scene().paths.empty();
    m_note->setVisible(isEmpty);
    m_tree->setVisible(!isEmpty); // else the note would stand below an empty list
    showSelection();
    showProblems();
}

void EnvironmentDock::addPaths()
{
    const model::Scene& scene = m_state.scene();
    for (const model::Path& each : scene.paths) {
        auto* item = new QTreeWidgetItem(m_tree, {QString::fromStdString(each.name)}, PathItem);
        item->setData(0, kIdRole, each.id);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setIcon(0, swatch(each.color));
        item->setText(1, tr("%n people", nullptr, peopleOn(scene, each.id)));
        int index = 0;
        for (const model::PlaceId id : each.places) {
            const model::Place* stop = scene.findPlace(id);
            if (stop != nullptr) {
                auto* child =
                    new QTreeWidgetItem(item, {QString::fromStdString(stop->name)}, PlaceItem);
                child->setData(0, kIdRole, id);
                child->setData(0, kIndexRole, index);
                child->setFlags(child->flags() | Qt::ItemIsEditable);
                child->setText(1, tr("%1 m").arg(QLocale().toString(
                                      static_cast<double>(stop->radius), 'f', 2)));
            }
            ++index;
        }
        item->setExpanded(each.places.size() <= 8);
    }
}

/// Those that no path leads over.
void EnvironmentDock::addPlaces()
{
    const model::Scene& scene = m_state.scene();
    QTreeWidgetItem* heading = nullptr;
    for (const model::Place& each : scene.places) {
        const bool isUsed = std::ranges::any_of(scene.paths, [&each](const model::Path& path) {
            return std::ranges::find(path.places, each.id) != path.places.end();
        });
        if (isUsed) {
            continue;
        }
        if (heading == nullptr) {
            heading = new QTreeWidgetItem(m_tree, {tr("Places")}, KindItem);
            heading->setExpanded(true);
        }
        auto* item = new QTreeWidgetItem(heading, {QString::fromStdString(each.name)}, PlaceItem);
        item->setData(0, kIdRole, each.id);
        item->setIcon(0, swatch(each.color));
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setText(1,
                      tr("%1 m").arg(QLocale().toString(static_cast<double>(each.radius), 'f', 2)));
    }
}

void EnvironmentDock::showSelection()
{
    m_isFilling = true;
    for (QTreeWidgetItemIterator it(m_tree); *it != nullptr; ++it) {
        const auto id = (*it)->data(0, kIdRole).toUInt();
        const bool isPlace = (*it)->type() == PlaceItem;
        const bool isPath = (*it)->type() == PathItem && m_state.paths().places().empty();
        (*it)->setSelected((isPlace && m_state.paths().isSelected(id)) ||
                           (isPath && id != 0 && id == m_state.paths().path()));
    }
    if (const auto chosen = m_tree->selectedItems(); !chosen.isEmpty()) {
        m_tree->scrollToItem(chosen.front());
    }
    m_isFilling = false;
    refreshForm();
    showProblems();
}

void EnvironmentDock::takeSelection()
{
    if (m_isFilling) {
        return;
    }
    std::vector<model::PlaceId> places;
    model::PathId chosen = m_state.paths().path();
    for (QTreeWidgetItem* item : m_tree->selectedItems()) {
        const auto id = item->data(0, kIdRole).toUInt();
        if (item->type() == PathItem) {
            chosen = id;
        } else if (item->type() == PlaceItem && std::ranges::find(places, id) == places.end()) {
            places.push_back(id);
            chosen = item->parent()->type() == PathItem ? item->parent()->data(0, kIdRole).toUInt()
                                                        : chosen;
        }
    }
    m_state.paths().select(places);
    m_state.paths().look(chosen);
    showSelection();
}

/// What a session has to say about a path or a place; empty: nothing.
QString EnvironmentDock::problemOf(const QTreeWidgetItem& item) const
{
    const auto id = item.data(0, kIdRole).toUInt();
    const bool isPath = item.type() == PathItem;
    for (const behavior::Problem& problem : m_state.session().problems()) {
        if (id != 0 && item.type() != KindItem && (isPath ? problem.path : problem.place) == id) {
            return QString::fromStdString(problem.text);
        }
    }
    return {};
}

/// At the paths and places, and above the form for the one that is chosen.
void EnvironmentDock::showProblems()
{
    m_isFilling = true;
    QString chosen;
    for (QTreeWidgetItemIterator it(m_tree); *it != nullptr; ++it) {
        const QString problem = problemOf(**it);
        (*it)->setData(0, Qt::ForegroundRole,
                       problem.isEmpty() ? QVariant() : QVariant(QBrush(kTroubleColor)));
        (*it)->setToolTip(0, problem);
        chosen = chosen.isEmpty() && (*it)->isSelected() ? problem : chosen;
    }
    m_isFilling = false;
    m_problem->setText(chosen);
    m_problem->setVisible(!chosen.isEmpty());
}

void EnvironmentDock::refreshForm()
{
    const model::Place* shownPlace = place();
    const model::Path* shownPath = shownPlace == nullptr ? path() : nullptr;
    const bool hasAny = shownPlace != nullptr || shownPath != nullptr;
    const auto show = [this](QWidget* field, bool isShown) {
        field->setVisible(isShown);
        if (QWidget* label = m_form->labelForField(field)) {
            label->setVisible(isShown);
        }
    };
    m_isFilling = true;
    show(m_name, hasAny);
    show(m_color, hasAny);
    show(m_radius, shownPlace != nullptr);
    show(m_capacity, shownPlace != nullptr);
    show(m_role, shownPlace != nullptr);
    show(m_speedShare, shownPlace != nullptr && shownPlace->role == model::PlaceRole::Slow);
    m_branches->setPath(shownPath != nullptr ? shownPath->id : 0);
    show(m_kind, shownPath != nullptr);
    show(m_people, shownPath != nullptr);
    for (int axis = 0; axis < 3; ++axis) {
        m_position[axis]->setVisible(shownPlace != nullptr);
    }
    m_form->itemAt(1, QFormLayout::LabelRole)->widget()->setVisible(shownPlace != nullptr);
    if (shownPlace != nullptr) {
        m_name->setText(QString::fromStdString(shownPlace->name));
        m_color->setIcon(swatch(shownPlace->color));
        for (int axis = 0; axis < 3; ++axis) {
            m_position[axis]->setValue(static_cast<double>(shownPlace->position[axis]));
        }
        m_radius->setValue(static_cast<double>(shownPlace->radius));
        m_capacity->setValue(static_cast<double>(shownPlace->capacity));
        m_role->setCurrentIndex(static_cast<int>(shownPlace->role));
        m_speedShare->setValue(static_cast<double>(shownPlace->speedShare) * 100.0);
    } else if (shownPath != nullptr) {
        m_name->setText(QString::fromStdString(shownPath->name));
        m_color->setIcon(swatch(shownPath->color));
        m_kind->setCurrentIndex(static_cast<int>(shownPath->kind));
        m_people->setText(QLocale().toString(peopleOn(m_state.scene(), shownPath->id)));
    }
    m_isFilling = false;
}

void EnvironmentDock::rename(QTreeWidgetItem* item)
{
    if (m_state.document().isEditOpen()) {
        return;
    }
    const std::string name = item->text(0).toStdString();
    const auto id = item->data(0, kIdRole).toUInt();
    auto edit = m_state.document().beginEdit();
    if (item->type() == PathItem) {
        model::Path renamed = *m_state.scene().findPath(id);
        renamed.name = name;
        edit->changePath(renamed);
        edit->commit(tr("Rename a path"));
    } else if (item->type() == PlaceItem) {
        model::Place renamed = *m_state.scene().findPlace(id);
        renamed.name = name;
        edit->changePlace(renamed);
        edit->commit(tr("Rename a place"));
    }
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

} // namespace crowd::widgets
