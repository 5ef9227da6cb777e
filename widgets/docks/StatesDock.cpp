// SPDX-License-Identifier: MIT
#include "widgets/docks/StatesDock.h"

#include <algorithm>

#include <QtCore/QCoreApplication>
#include <QtCore/QSettings>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/states/StateKeeping.h"
#include "widgets/commands/StateCommands.h"
#include "widgets/docks/FieldForm.h"
#include "widgets/docks/WrapRow.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kStateIcon = 20; ///< logical pixels
constexpr int kKeyedStates = 9;
constexpr int kMostRows = 9;   ///< seen at once
constexpr int kRoomBelow = 6;  ///< logical pixels
constexpr int kShortReach = 8; ///< letters
constexpr int kStatesRebuildMs = 30;

QString settingOf(const model::PropertyAspectInfo& aspect)
{
    return QStringLiteral("states/holds-%1").arg(QLatin1String(aspect.key));
}

constexpr auto kSecondsSetting = "states/recall-seconds";
constexpr auto kStaggerSetting = "states/recall-stagger";
constexpr auto kOrderSetting = "states/recall-order";
constexpr auto kForRunSetting = "states/recall-for-run";

/// As it was the last time; the point is of another scene.
void restoreRecall(RecallSettings& recall)
{
    const QSettings settings;
    const auto seconds = [&settings](const char* key) {
        const double value = settings.value(key, 0.0).toDouble();
        return value >= 0.0 && value <= model::kLongestRecall ? static_cast<float>(value) : 0.0F;
    };
    recall.timing.seconds = seconds(kSecondsSetting);
    recall.timing.stagger.seconds = seconds(kStaggerSetting);
    const int order = settings.value(kOrderSetting, 0).toInt();
    if (order >= 0 && order < std::ssize(model::Stagger::kOrders)) {
        recall.timing.stagger.order = static_cast<model::StaggerOrder>(order);
    }
    recall.isForRunAlone = settings.value(kForRunSetting, false).toBool();
}

} // namespace

StatesDock::StatesDock(EditorState& state, QWidget* parent)
    : DockBase(tr("States"), "states", parent), m_state(state), m_list(new QListWidget(this)),
      m_note(new QLabel(this)), m_reach(new QComboBox(this))
{
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
    layout->addWidget(recalling());
    layout->addWidget(holding());
    layout->addStretch(1);
    setScrolledContent(content);
    connectParts();
    fill();
}

QWidget* StatesDock::buttons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](QWidget* parent, const char* icon, const QString& tip, const char* name,
                         auto act) {
        auto* button = new QToolButton(parent);
        button->setObjectName(QLatin1String(name));
        button->setIcon(iconNamed(icon));
        button->setIconSize({kStateIcon, kStateIcon});
        button->setToolTip(tip);
        button->setAutoRaise(true);
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

/// How states are given back.
QWidget* StatesDock::recalling()
{
    auto* box = new QWidget(this);
    auto* rows = new QVBoxLayout(box);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    RecallSettings recall = m_state.recall();
    restoreRecall(recall);
    m_state.setRecall(recall);
    const FormTarget target{[this] { return &m_state.recall().timing; },
                            [this](const std::function<void(void*)>& change) {
                                RecallSettings now = m_state.recall();
                                change(&now.timing);
                                keepRecall(now);
                            },
                            [this] { return model::FieldContext{&m_state.scene()}; }};
    m_timing = new FieldForm(target, QStringLiteral("recall"), &m_state, box);
    m_timing->setObjectName(QStringLiteral("recallTiming"));
    m_timing->layout()->setContentsMargins(0, 0, 0, 0);
    m_timing->addFields(model::fieldsOf<model::RecallTiming>());
    m_timing->finish();
    m_timing->refresh();
    rows->addWidget(new QLabel(tr("When one is recalled"), box));
    rows->addWidget(m_timing);
    m_isForRun = new QCheckBox(tr("Only in this run"), box);
    m_isForRun->setObjectName(QStringLiteral("recallInRun"));
    m_isForRun->setToolTip(tr("While it plays the scene stays as it is, and Stop gives it back. "
                              "The keys always do so."));
    m_isForRun->setChecked(recall.isForRunAlone);
    connect(&m_state, &EditorState::recallChanged, this, [this] {
        m_timing->refresh();
        m_isForRun->setChecked(m_state.recall().isForRunAlone);
    });
    connect(m_isForRun, &QCheckBox::toggled, this, [this](bool isOn) {
        RecallSettings now = m_state.recall();
        now.isForRunAlone = isOn;
        keepRecall(now);
    });
    rows->addWidget(m_isForRun);
    return box;
}

void StatesDock::keepRecall(const RecallSettings& recall)
{
    QSettings settings;
    settings.setValue(kSecondsSetting, static_cast<double>(recall.timing.seconds));
    settings.setValue(kStaggerSetting, static_cast<double>(recall.timing.stagger.seconds));
    settings.setValue(kOrderSetting, static_cast<int>(recall.timing.stagger.order));
    settings.setValue(kForRunSetting, recall.isForRunAlone);
    m_state.setRecall(recall);
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
    m_reach->addItems({tr("the whole crowd"), tr("who is selected")});
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

void StatesDock::connectParts()
{
    m_rebuild.setSingleShot(true);
    m_rebuild.setInterval(kStatesRebuildMs);
    connect(&m_rebuild, &QTimer::timeout, this, &StatesDock::fill);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::StatesChanged, model::SceneReplaced>(change)) {
                    m_rebuild.start();
                }
            });
    connect(&m_state.document(), &model::SceneDocument::editRefused, &m_rebuild,
            qOverload<>(&QTimer::start));
    connect(m_list, &QListWidget::itemDoubleClicked, this, [this] { recallChosen(); });
    connect(m_list, &QListWidget::currentRowChanged, this, [this] { refreshNotes(); });
    connect(m_list, &QListWidget::customContextMenuRequested, this, &StatesDock::showMenu);
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!m_isFilling) {
            (void)renameState(m_state, item->data(kIdRole).toUInt(), item->text());
            m_rebuild.start(); // what was refused gets its old name back
        }
    });
}

void StatesDock::fill()
{
    if (m_list->viewport()->findChild<QLineEdit*>() != nullptr) {
        m_rebuild.start(); // not under the hands of who renames
        return;
    }
    const model::StateId before = chosen();
    m_isFilling = true;
    m_list->clear();
    int number = 0;
    for (const model::State& each : m_state.scene().states) {
        auto* item =
            new QListWidgetItem(iconNamed("state"), QString::fromStdString(each.name), m_list);
        item->setData(kIdRole, each.id);
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        const QString people =
            tr("%n characters", nullptr, static_cast<int>(each.people->ids.size()));
        ++number;
        item->setToolTip(
            number <= kKeyedStates
                ? tr("%1. Double click or Shift+F%2: recall. F2: rename.").arg(people).arg(number)
                : tr("%1. Double click: recall. F2: rename.").arg(people));
        if (each.id == before) {
            m_list->setCurrentItem(item);
        }
    }
    if (m_list->currentRow() < 0 && m_list->count() > 0) {
        m_list->setCurrentRow(0);
    }
    m_isFilling = false;
    const int rows = std::min(m_list->count(), kMostRows);
    m_list->setFixedHeight(rows * m_list->sizeHintForRow(0) + kRoomBelow);
    refreshNotes();
}

void StatesDock::refreshNotes()
{
    m_note->setText(tr("A state keeps how the crowd is now, and gives it back later: calm, "
                       "cheering, disappointed. + keeps one."));
    m_note->setVisible(m_list->count() == 0);
    m_list->setVisible(m_list->count() > 0);
    m_chosenButtons->setEnabled(chosen() != 0);
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
    const auto reach = m_reach->currentIndex() == 1 ? StateReach::Selected : StateReach::Everybody;
    if (keepStateAs(m_state, name, ticked(), reach)) {
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
            return;
        }
    }
}

void StatesDock::recallChosen()
{
    recallStateOf(m_state, chosen(), m_isForRun->isChecked() ? RecallInto::Run : RecallInto::Scene);
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
