// SPDX-License-Identifier: MIT
#include "widgets/docks/StatesDock.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtCore/QElapsedTimer>
#include <QtCore/QSettings>
#include <QtGui/QAction>
#include <QtGui/QPainter>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QScrollBar>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/states/StateDifference.h"
#include "model/states/StateKeeping.h"
#include "widgets/commands/StateCommands.h"
#include "widgets/docks/RecallForm.h"
#include "widgets/docks/StatePictures.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/forms/WrapRow.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kKeyedStates = 9;
constexpr int kMostRows = 5;   ///< seen at once
constexpr int kRoomBelow = 6;  ///< logical pixels
constexpr int kShortReach = 8; ///< letters
constexpr int kStatesRebuildMs = 30;
constexpr int kCompareMs = 200;
constexpr qint64 kFollowMs = 500;
constexpr qint64 kFollowShare = 20; ///< of the time that one comparison takes

QString settingOf(const model::PropertyAspectInfo& aspect)
{
    return QStringLiteral("states/holds-%1").arg(QLatin1String(aspect.key));
}

/// With the number of its keys in a corner; those without keys as they are.
QIcon numbered(const QIcon& picture, int number, const QListWidget& list)
{
    if (number > kKeyedStates) {
        return picture;
    }
    QPixmap drawn = picture.pixmap(list.iconSize(), list.devicePixelRatioF());
    if (drawn.isNull()) {
        return picture;
    }
    QPainter painter(&drawn);
    painter.setRenderHint(QPainter::Antialiasing);
    const int side = list.fontMetrics().height();
    const QRect badge(0, 0, side, side);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRoundedRect(badge, 3.0, 3.0);
    painter.setPen(Qt::white);
    painter.drawText(badge, Qt::AlignCenter, QString::number(number));
    painter.end();
    return drawn;
}

} // namespace

StatesDock::StatesDock(EditorState& state, QWidget* parent)
    : DockBase(tr("States"), "states", parent), m_state(state), m_list(new QListWidget(this)),
      m_note(new QLabel(this)), m_difference(new QLabel(this)), m_reach(new QComboBox(this)),
      m_pictures(new StatePictures(state, this))
{
    m_list->setDragDropMode(QAbstractItemView::InternalMove);
    m_list->setDefaultDropAction(Qt::MoveAction);
    m_list->setIconSize(StatePictures::kSize);
    m_list->setObjectName(QStringLiteral("states"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_note->setObjectName(QStringLiteral("statesNote"));
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->addWidget(buttons());
    layout->addWidget(m_note);
    layout->addWidget(m_list);
    layout->addWidget(difference());
    m_recall = new RecallForm(state, content);
    layout->addWidget(m_recall);
    layout->addWidget(holding());
    layout->addStretch(1);
    setScrolledContent(content);
    connectParts();
    fill();
    enableRecall();
}

QWidget* StatesDock::buttons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](QWidget* parent, const char* icon, const QString& tip, const char* name,
                         auto act) {
        QToolButton* button = panelButton(parent, icon, tip, name);
        connect(button, &QToolButton::clicked, this, act);
        return button;
    };
    layout->addWidget(add(row, "add", tr("Keep how they are now as a new state"), "keepState",
                          [this] { keep(); }));
    m_chosenButtons = new QWidget(row);
    auto* chosenRow = new QHBoxLayout(m_chosenButtons);
    chosenRow->setContentsMargins(0, 0, 0, 0);
    chosenRow->addWidget(add(m_chosenButtons, "state", tr("Recall the chosen state"), "recallState",
                             [this] { recallChosen(); }));
    chosenRow->addWidget(add(m_chosenButtons, "state-add",
                             tr("Keep how they are now as the chosen state"), "keepStateAnew",
                             [this] { keepStateAnew(m_state, chosen()); }));
    chosenRow->addStretch(1);
    chosenRow->addWidget(add(m_chosenButtons, "delete", tr("Remove the chosen state"),
                             "removeState", [this] { removeState(m_state, chosen()); }));
    layout->addWidget(m_chosenButtons, 1);
    return row;
}

/// In what the crowd differs from the chosen state, and who.
QWidget* StatesDock::difference()
{
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    m_difference->setObjectName(QStringLiteral("stateDifference"));
    m_difference->setWordWrap(true);
    row->addWidget(m_difference, 1);
    m_wash = new QToolButton(box);
    m_wash->setObjectName(QStringLiteral("washDifferent"));
    m_wash->setIcon(iconNamed("locate"));
    m_wash->setIconSize({kPanelIcon, kPanelIcon});
    m_wash->setCheckable(true);
    m_wash->setAutoRaise(true);
    m_wash->setToolTip(tr("Outline in the picture who differs from the chosen state"));
    connect(m_wash, &QToolButton::toggled, this, &StatesDock::refreshDifference);
    row->addWidget(m_wash);
    m_compare.setSingleShot(true);
    m_compare.setInterval(kCompareMs);
    connect(&m_compare, &QTimer::timeout, this, &StatesDock::refreshDifference);
    m_follow.setSingleShot(true);
    connect(&m_follow, &QTimer::timeout, this, &StatesDock::refreshDifference);
    connect(&m_state.transport(), &Transport::timeChanged, this, [this] {
        if (isVisible() && !m_follow.isActive()) {
            m_follow.start();
        }
    });
    return box;
}

/// Only while the panel is seen; while it plays, in the run.
void StatesDock::refreshDifference()
{
    QElapsedTimer began;
    began.start();
    const auto& states = m_state.scene().states;
    const auto found = std::ranges::find(states, chosen(), &model::State::id);
    const bool isSeen = found != states.end() && isVisible();
    model::StateDifference difference;
    if (isSeen) {
        // How far somebody is in his clip is no property of his while clips run.
        const model::ColumnSet running = m_state.session().isPosed()
                                             ? model::ColumnSet{model::ColumnId::Phase}
                                             : model::ColumnSet{};
        difference = differenceFrom(*found, m_state.session().shownScene(), running);
    }
    QStringList parts;
    for (const auto& each : difference.aspects) {
        const char* label = model::propertyAspects()[static_cast<std::size_t>(each.aspect)].label;
        parts << tr("%1 %2").arg(fieldText(label)).arg(each.people);
    }
    const bool isSomebodyThere =
        found != states.end() &&
        std::ranges::any_of(found->people->ids, [this](model::IndividualId id) {
            return m_state.scene().population.rowOf(id) != model::Population::npos;
        });
    const QString text = !isSomebodyThere  ? tr("Nobody whom it keeps is there any more.")
                         : parts.isEmpty() ? tr("They are like that now.")
                                           : tr("Different: %1").arg(parts.join(tr(", ")));
    // Else a state of a few would be taken for one of everybody.
    const std::size_t kept = isSeen ? found->people->ids.size() : 0;
    const std::size_t all = m_state.scene().population.size();
    m_difference->setText(kept < all && isSomebodyThere
                              ? tr("Of %1 out of %2 characters. %3").arg(kept).arg(all).arg(text)
                              : text);
    m_difference->parentWidget()->setVisible(isSeen);
    m_state.setWashed(isSeen && m_wash->isChecked() ? difference.ids
                                                    : std::vector<model::IndividualId>());
    m_compare.stop();
    // A large crowd is compared less often: it is to play on meanwhile.
    m_follow.setInterval(static_cast<int>(std::max(kFollowMs, kFollowShare * began.elapsed())));
}

/// What a new state holds, and of whom it is.
QWidget* StatesDock::holding()
{
    auto* box = new QWidget(this);
    auto* rows = new QVBoxLayout(box);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addWidget(new QLabel(tr("A new state is of"), box));
    m_reach->setObjectName(QStringLiteral("stateReach"));
    fillReach();
    m_reach->setAccessibleName(tr("Of whom a new state is"));
    m_reach->setMinimumContentsLength(kShortReach);
    m_reach->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    rows->addWidget(m_reach);
    rows->addWidget(new QLabel(tr("and holds"), box));
    auto* ticks = new WrapRow;
    for (const model::PropertyAspectInfo& aspect : model::propertyAspects()) {
        auto* tick = new QCheckBox(fieldText(aspect.label), box);
        tick->setObjectName(QLatin1String(aspect.key));
        tick->setChecked(QSettings().value(settingOf(aspect), !aspect.isWhoOrWhere).toBool());
        connect(tick, &QCheckBox::toggled, this,
                [&aspect](bool isOn) { QSettings().setValue(settingOf(aspect), isOn); });
        ticks->addWidget(tick);
        m_aspects.push_back(tick);
    }
    rows->addLayout(ticks);
    return box;
}

/// The whole crowd, who is selected, and each group.
void StatesDock::fillReach()
{
    const QVariant before = m_reach->currentData();
    const int index = m_reach->currentIndex();
    m_reach->clear();
    m_reach->addItem(tr("the whole crowd"), 0U);
    m_reach->addItem(tr("who is selected"), 0U);
    for (const model::Group& group : m_state.scene().groups) {
        m_reach->addItem(tr("group “%1”").arg(QString::fromStdString(group.name)), group.id);
    }
    const int same = index <= 1 ? std::max(index, 0) : m_reach->findData(before);
    m_reach->setCurrentIndex(std::max(same, 0));
}

void StatesDock::connectParts()
{
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kStatesRebuildMs);
    connect(&m_rebuild, &QTimer::timeout, this, &StatesDock::fill);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::SceneReplaced>(change)) {
                    m_pictures->forget();
                    m_reach->setCurrentIndex(0); // nobody is selected there
                    m_wash->setChecked(false);
                }
                if (isOneOf<model::StatesChanged, model::SceneReplaced>(change)) {
                    enableRecall();
                    m_rebuild.start();
                }
                if (isOneOf<model::GroupsChanged, model::SceneReplaced>(change)) {
                    fillReach();
                }
                m_compare.start();
            });
    connect(&m_state.document(), &model::SceneDocument::editRefused, &m_rebuild,
            qOverload<>(&QTimer::start));
    connectKeys();
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // long names end in an ellipsis
    connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { recallChosen(); });
    connect(m_list, &QListWidget::currentRowChanged, this, [this] {
        refreshNotes();
        if (!m_isFilling) {
            m_state.chooseState(chosen());
            chooseForBrush();
        }
    });
    connect(&m_state, &EditorState::stateChosen, this, &StatesDock::showChosen);
    connect(m_pictures, &StatePictures::drawn, this, [this] { m_rebuild.start(); });
    connect(this, &QDockWidget::visibilityChanged, &m_compare, qOverload<>(&QTimer::start));
    connect(m_list, &QListWidget::customContextMenuRequested, this, &StatesDock::showMenu);
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!m_isFilling) {
            (void)renameState(m_state, item->data(kIdRole).toUInt(), item->text());
            m_rebuild.start(); // what was refused gets its old name back
        }
    });
}

/// The list in order by hand, and what is deleted from it.
void StatesDock::connectKeys()
{
    connect(m_list->model(), &QAbstractItemModel::rowsMoved, this,
            [this](const QModelIndex&, int from, int, const QModelIndex&, int to) {
                const int place = to > from ? to - 1 : to;
                const auto& states = m_state.scene().states;
                if (!m_isFilling && from < std::ssize(states)) {
                    moveState(m_state, states[static_cast<std::size_t>(from)].id, place - from);
                }
            });
    removeByKey(*m_list, [this] {
        if (chosen() != 0) {
            removeState(m_state, chosen());
        }
    });
}

/// Without a state nothing of it is shown in the picture either.
void StatesDock::enableRecall()
{
    m_recall->setEnabled(!m_state.scene().states.empty());
}

void StatesDock::fill()
{
    if (m_list->viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    const int scrolled = m_list->verticalScrollBar()->value();
    const auto& states = m_state.scene().states;
    m_isFilling = true;
    // Those that are there become the new ones: an emptied list would be seen empty.
    while (m_list->count() > std::ssize(states)) {
        delete m_list->takeItem(m_list->count() - 1);
    }
    bool isChosenThere = false;
    for (int row = 0; row < static_cast<int>(states.size()); ++row) {
        if (row >= m_list->count()) {
            m_list->addItem(new QListWidgetItem);
        }
        const model::State& each = states[static_cast<std::size_t>(row)];
        showRow(each, row);
        if (each.id == m_state.chosenState()) {
            m_list->setCurrentRow(row);
            isChosenThere = true;
        }
    }
    if (!isChosenThere && m_list->count() > 0) {
        m_list->setCurrentRow(0);
    }
    m_isFilling = false;
    m_state.chooseState(chosen());
    const int rows = std::min(m_list->count(), kMostRows);
    m_list->setFixedHeight(rows * m_list->sizeHintForRow(0) + kRoomBelow);
    m_list->verticalScrollBar()->setValue(scrolled); // a click finds what it was aimed at
    refreshNotes();
}

void StatesDock::showRow(const model::State& kept, int row)
{
    QListWidgetItem* item = m_list->item(row);
    const int number = row + 1;
    item->setIcon(numbered(m_pictures->of(kept), number, *m_list));
    item->setText(QString::fromStdString(kept.name));
    item->setData(kIdRole, kept.id);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    const QString people = tr("%n characters", nullptr, static_cast<int>(kept.people->ids.size()));
    item->setToolTip(
        number <= kKeyedStates
            ? tr("%1. Double click or Shift+F%2: recall. F2: rename.").arg(people).arg(number)
            : tr("%1. Double click: recall. F2: rename.").arg(people));
}

void StatesDock::refreshNotes()
{
    m_note->setText(tr("A state keeps how the crowd is now, and gives it back later: calm, "
                       "cheering, disappointed. + keeps one."));
    m_note->setVisible(m_list->count() == 0);
    m_list->setVisible(m_list->count() > 0);
    m_chosenButtons->setEnabled(chosen() != 0);
    m_compare.start();
}

/// Whatever key or panel has chosen it.
void StatesDock::showChosen(model::StateId id)
{
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->data(kIdRole).toUInt() == id) {
            m_list->setCurrentRow(row);
        }
    }
    m_compare.start();
}

/// Who has the restore brush in hand and chooses a state means to paint it.
void StatesDock::chooseForBrush()
{
    if (m_state.tool() == ToolId::BrushRestore && chosen() != 0) {
        model::BrushSettings brush = *m_state.activeBrush();
        auto& settings = brush.as<model::RestoreSettings>();
        settings.source = model::RestoreSource::State;
        settings.state = chosen();
        m_state.setBrush(brush);
    }
}

model::StateId StatesDock::chosen() const
{
    const QListWidgetItem* item = m_list->currentItem();
    return item != nullptr ? item->data(kIdRole).toUInt() : 0;
}

model::ColumnSet StatesDock::ticked() const
{
    model::ColumnSet columns;
    for (std::size_t i = 0; i < m_aspects.size(); ++i) {
        if (m_aspects[i]->isChecked()) {
            model::columnsOf(model::propertyAspects()[i].aspect)
                .forEach([&columns](model::ColumnId column) { columns.insert(column); });
        }
    }
    return columns;
}

void StatesDock::keep()
{
    const QString name = freeStateName(m_state.scene());
    const int index = m_reach->currentIndex();
    const auto reach = index > 1    ? StateReach::Group
                       : index == 1 ? StateReach::Selected
                                    : StateReach::Everybody;
    if (keepStateAs(m_state, name, ticked(), reach, m_reach->currentData().toUInt())) {
        fill();
        edit(m_state.scene().states.back().id);
    }
}

/// Its name, to be typed.
void StatesDock::edit(model::StateId id)
{
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->data(kIdRole).toUInt() == id) {
            m_list->setCurrentRow(row);
            m_list->editItem(m_list->item(row));
            showRenaming(*m_list);
            return;
        }
    }
}

void StatesDock::recallChosen()
{
    recallStateOf(m_state, chosen(),
                  m_state.recall().isForRunAlone ? RecallInto::Run : RecallInto::Scene);
}

/// What it holds, to be ticked: what is added is as people are now.
void StatesDock::addHolds(QMenu& menu, model::StateId id)
{
    const auto& states = m_state.scene().states;
    const auto found = std::ranges::find(states, id, &model::State::id);
    for (const model::PropertyAspectInfo& aspect : model::propertyAspects()) {
        bool isHeld = false;
        model::columnsOf(aspect.aspect).forEach([&](model::ColumnId column) {
            isHeld |= found->columns.contains(column);
        });
        QAction* action = menu.addAction(fieldText(aspect.label));
        action->setCheckable(true);
        action->setChecked(isHeld);
        connect(action, &QAction::triggered, this,
                [this, id, &aspect](bool isOn) { setHeld(m_state, id, aspect.aspect, isOn); });
    }
}

void StatesDock::showMenu(const QPoint& position)
{
    const QListWidgetItem* item = m_list->itemAt(position);
    if (item == nullptr) {
        return;
    }
    const model::StateId id = item->data(kIdRole).toUInt();
    const int row = m_list->row(item);
    QMenu menu(this);
    menu.addAction(iconNamed("state"), tr("Recall"), this,
                   [this, id] { recallStateOf(m_state, id, RecallInto::Scene); });
    menu.addAction(tr("Recall only in this run"), this,
                   [this, id] { recallStateOf(m_state, id, RecallInto::Run); })
        ->setEnabled(m_state.transport().isPlaying());
    menu.addAction(iconNamed("state-add"), tr("Keep anew"), this,
                   [this, id] { keepStateAnew(m_state, id); });
    menu.addAction(tr("Select its characters"), this, [this, id] { selectPeopleOf(m_state, id); });
    addHolds(*menu.addMenu(tr("Holds")), id);
    menu.addSeparator();
    menu.addAction(tr("Rename"), this, [this, id] { edit(id); });
    menu.addAction(tr("Up"), this, [this, id] { moveState(m_state, id, -1); })->setEnabled(row > 0);
    menu.addAction(tr("Down"), this, [this, id] { moveState(m_state, id, 1); })
        ->setEnabled(row + 1 < m_list->count());
    menu.addSeparator();
    menu.addAction(iconNamed("delete"), tr("Remove"), this,
                   [this, id] { removeState(m_state, id); });
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

} // namespace crowd::widgets
