// SPDX-License-Identifier: MIT
#include "widgets/docks/TakesDock.h"

#include <algorithm>

#include <QtCore/QLocale>
#include <QtCore/QMetaObject>
#include <QtGui/QPixmap>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "widgets/commands/TakeCommands.h"
#include "widgets/docks/HandEditsPanel.h"
#include "widgets/docks/TakeFigures.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

namespace {

constexpr int kTakeIdRole = Qt::UserRole;
constexpr int kTakeRows = 8;
constexpr int kTakeFollowMs = 200;
constexpr int kTakesRoom = 6;        ///< logical pixels
constexpr double kNamedBegin = 0.05; ///< seconds: begins that are later are told

/// As wide as the others, so that names stand below each other.
QIcon noIcon()
{
    QPixmap pixmap(kPanelIcon, kPanelIcon);
    pixmap.fill(Qt::transparent);
    return pixmap;
}

/// Also from when it is, where that is not the beginning of time.
QString keptText(const model::Takes& all, const QString& name)
{
    const auto take = std::ranges::find(all, name.toStdString(), &model::Take::name);
    const double begin = take == all.end() ? 0.0 : take->begin;
    return begin > kNamedBegin
               ? TakesDock::tr("\"%1\" is kept. It begins at %2 s, where the run did.")
                     .arg(name, QLocale().toString(begin, 'f', 1))
               : TakesDock::tr("\"%1\" is kept.").arg(name);
}

} // namespace

TakesDock::TakesDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Takes"), "takes", parent), m_state(state), m_list(new QListWidget(this)),
      m_note(new QLabel(this)), m_difference(new QLabel(this)),
      m_figures(new TakeFigures(state, this)), m_edits(new HandEditsPanel(state, this))
{
    m_list->setObjectName(QStringLiteral("takesList"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // long names are cut off
    for (QLabel* label : {m_note, m_difference}) {
        label->setWordWrap(true);
    }
    m_note->setObjectName(QStringLiteral("takesNote"));
    m_difference->setObjectName(QStringLiteral("takesDifference"));
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(kTakesRoom, kTakesRoom, kTakesRoom, kTakesRoom);
    layout->addWidget(buttons());
    layout->addWidget(m_list);
    layout->addWidget(m_note);
    layout->addWidget(m_difference);
    layout->addWidget(m_figures);
    layout->addWidget(m_edits);
    layout->addStretch(1);
    setScrolledContent(content);
    connectParts();
    fill();
}

QWidget* TakesDock::buttons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    const auto add = [row, layout](const char* icon, const QString& tip, const char* name) {
        QToolButton* button = panelButton(row, icon, tip, name);
        layout->addWidget(button);
        return button;
    };
    m_keep = add("take-add", tr("Keep what has been played as a take"), "keepTake");
    connect(m_keep, &QToolButton::clicked, this, [this] { keepTake(m_state); });
    m_show = add("eye", tr("Show the chosen one"), "showTake");
    connect(m_show, &QToolButton::clicked, this, &TakesDock::showChosen);
    m_ghost = add("ghost",
                  tr("See the chosen take as ghosts beside what is shown, with how far apart "
                     "everybody is"),
                  "ghostTake");
    m_ghost->setCheckable(true);
    connect(m_ghost, &QToolButton::clicked, this,
            [this](bool on) { m_state.takes().setGhost(on ? chosen() : 0); });
    m_goOn = add("take-from-here",
                 tr("Play on from the moment shown, as a run that can be told what to do; the take "
                    "stays as it is"),
                 "goOnOutOfTake");
    connect(m_goOn, &QToolButton::clicked, this, [this] { m_state.session().takeFromHere(); });
    m_retake = add("retake",
                   tr("Take the selected characters again, in the play range or else from the "
                      "moment shown on: everybody else does what he did"),
                   "retake");
    connect(m_retake, &QToolButton::clicked, this, [this] { retakeSelected(m_state); });
    layout->addStretch(1);
    m_remove = add("delete", tr("Delete the chosen take"), "removeTake");
    connect(m_remove, &QToolButton::clicked, this, &TakesDock::removeChosen);
    removeByKey(*m_list, [this] { removeChosen(); });
    removeByKey(*m_edits->list(), [this] { m_edits->removeChosen(); });
    return row;
}

void TakesDock::connectParts()
{
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::TakesChanged, model::SceneReplaced>(change)) {
                    fill();
                }
            });
    SessionControl& session = m_state.session();
    connect(&session, &SessionControl::stateChanged, this, &TakesDock::fill);
    connect(&session, &SessionControl::stepped, this, &TakesDock::refreshButtons);
    TakeShelf& takes = m_state.takes();
    connect(&takes, &TakeShelf::keeping, this, [this] {
        refreshButtons();
        refreshNote();
    });
    connect(&takes, &TakeShelf::ghostChanged, this, &TakesDock::fill);
    connect(&takes, &TakeShelf::failed, &m_state, &EditorState::showStatus);
    connect(&takes, &TakeShelf::kept, this, [this](const QString& name) {
        m_state.showStatus(keptText(m_state.scene().takes, name));
        show(); // here it can be shown again
        raise();
    });
    connect(&takes, &TakeShelf::retaken, this, &TakesDock::sayRetaken);
    connect(&m_state.selection(), &Selection::changed, this, &TakesDock::refreshButtons);
    connect(m_list, &QListWidget::currentRowChanged, this, &TakesDock::refreshButtons);
    connect(m_list, &QListWidget::itemActivated, this, &TakesDock::showChosen);
    connect(m_list, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        if (m_isFilling) {
            return;
        }
        // After the list has done with its field: it is filled anew.
        QMetaObject::invokeMethod(
            this,
            [this, id = item->data(kTakeIdRole).toUInt(), name = item->text()] {
                m_state.takes().rename(id, name);
                fill();
            },
            Qt::QueuedConnection);
    });
    connect(m_list, &QListWidget::customContextMenuRequested, this, &TakesDock::showMenu);
    m_follow.setSingleShot(true);
    m_follow.setInterval(kTakeFollowMs);
    connect(&m_follow, &QTimer::timeout, this, &TakesDock::refreshDifference);
    connect(&m_state.transport(), &Transport::timeChanged, this, [this] {
        if (m_state.takes().ghost() != 0 && isVisible() && !m_follow.isActive()) {
            m_follow.start();
        }
    });
}

void TakesDock::addRow(const QString& text, const QString& tip, model::TakeId id, bool isShown)
{
    auto* item = new QListWidgetItem(text, m_list);
    item->setData(kTakeIdRole, id);
    item->setToolTip(tip);
    QFont font = item->font();
    font.setBold(isShown);
    item->setFont(font);
    const bool isGhost = id != 0 && id == m_state.takes().ghost();
    item->setIcon(isShown ? iconNamed("eye") : isGhost ? iconNamed("ghost") : noIcon());
    if (id != 0) {
        item->setFlags(item->flags() | Qt::ItemIsEditable);
    }
}

void TakesDock::addTake(const model::Take& take)
{
    const bool isShown = m_state.session().take() == take.id;
    const QString span = tr("%1 to %2").arg(takeClockText(take.begin), takeClockText(take.end));
    const QString people = tr("%n character(s)", nullptr, take.people);
    const bool isThere = take.motion != nullptr;
    const QString tip = isThere ? tr("%1, %2. Enter shows it, F2 renames it.").arg(span, people)
                                : model::translated(take.problem);
    addRow(QString::fromStdString(take.name), tip, take.id, isShown);
    if (!isThere) {
        m_list->item(m_list->count() - 1)
            ->setForeground(palette().brush(QPalette::Disabled, QPalette::Text));
    }
}

void TakesDock::fill()
{
    const model::TakeId before = chosen();
    const bool wasLive = m_list->currentRow() == 0;
    const std::size_t known = static_cast<std::size_t>(std::max(0, m_list->count() - 1));
    const model::TakeId shown = m_state.session().take();
    const bool isOther = shown != m_shown;
    m_shown = shown;
    const model::Takes& takes = m_state.scene().takes;
    m_isFilling = true;
    m_list->clear();
    addRow(tr("The scene as it plays"), tr("Enter shows it."), 0, m_state.session().take() == 0);
    int current = wasLive ? 0 : -1;
    for (const model::Take& take : takes) {
        addTake(take);
        if (take.id == before) {
            current = m_list->count() - 1;
        }
    }
    if (isOther) {
        current = rowOf(m_shown); // what is seen is what is worked on
    } else if (takes.size() > known && known > 0) {
        current = m_list->count() - 1; // a new one is chosen
    }
    m_list->setCurrentRow(current >= 0 ? current : m_list->count() - 1);
    int height = 2 * m_list->frameWidth() + kTakesRoom;
    for (int row = 0; row < std::min(m_list->count(), kTakeRows); ++row) {
        height += m_list->sizeHintForRow(row);
    }
    m_list->setFixedHeight(height);
    m_isFilling = false;
    refreshButtons();
    refreshNote();
    refreshDifference();
    m_figures->refresh();
    m_edits->refresh();
}

/// -1: none.
int TakesDock::rowOf(model::TakeId id) const
{
    for (int row = 0; row < m_list->count(); ++row) {
        if (m_list->item(row)->data(kTakeIdRole).toUInt() == id) {
            return row;
        }
    }
    return -1;
}

model::TakeId TakesDock::chosen() const
{
    const QListWidgetItem* item = m_list->currentItem();
    return item != nullptr ? item->data(kTakeIdRole).toUInt() : 0;
}

void TakesDock::refreshButtons()
{
    const model::Take* take = model::findTake(m_state.scene().takes, chosen());
    m_show->setEnabled(chosen() != m_state.session().take());
    m_ghost->setEnabled(take != nullptr && take->motion);
    m_ghost->setChecked(take != nullptr && m_state.takes().ghost() == take->id);
    m_goOn->setEnabled(m_state.session().take() != 0);
    m_retake->setEnabled(canRetake(m_state));
    m_remove->setEnabled(take != nullptr);
}

void TakesDock::refreshNote()
{
    const float share = m_state.takes().keptShare();
    const QString problem = m_state.session().takeProblem();
    QString text = problem;
    if (share >= 0.0F) {
        text = tr("The take is being kept: %1 %").arg(static_cast<int>(100.0F * share));
    } else if (problem.isEmpty() && m_state.scene().takes.empty()) {
        text =
            m_state.scene().hasBehaviour()
                ? tr("Play, then keep what was played. A take can be seen again whatever becomes "
                     "of paths, rules and marks.")
                : tr("Nobody walks or follows rules here: there is nothing to keep yet.");
    } else if (problem.isEmpty() && m_state.session().take() != 0) {
        text = tr("People move as in the take: what they are told and where they are to go counts "
                  "for the scene as it plays.");
    }
    m_note->setText(text);
    m_note->setEnabled(!problem.isEmpty());
    m_note->setVisible(!text.isEmpty());
}

/// At the moment that is shown.
void TakesDock::refreshDifference()
{
    const double seconds = m_state.transport().seconds();
    const model::Take* ghost = model::findTake(m_state.scene().takes, m_state.takes().ghost());
    const auto other = m_state.takes().ghostFrame(seconds);
    m_difference->setVisible(ghost != nullptr && other);
    if (ghost == nullptr || !other) {
        return;
    }
    const TakeDifference found = differenceOf(*m_state.session().frame(seconds), *other);
    const QString name = QString::fromStdString(ghost->name);
    const auto count = static_cast<int>(found.absent.size() + found.extra);
    const QString missing =
        count == 0 ? QString()
                   : QLatin1Char(' ') +
                         tr("%n character(s) are there in one of them only.", nullptr, count);
    if (found.rows.empty()) {
        m_difference->setText(
            tr("At %1 everybody is as in \"%2\".").arg(takeClockText(seconds), name) + missing);
        return;
    }
    const QLocale locale;
    m_difference->setText(
        tr("At %1, %2 of %3 are elsewhere than in \"%4\": %5 m on average, %6 m at most.")
            .arg(takeClockText(seconds))
            .arg(found.rows.size())
            .arg(found.people)
            .arg(name, locale.toString(static_cast<double>(found.mean), 'f', 2),
                 locale.toString(static_cast<double>(found.most), 'f', 2)) +
        missing);
}

/// What could be seen of a way home that was too long for the stretch is said.
void TakesDock::sayRetaken(const QString& name, int people, double furthestMetres)
{
    constexpr double kSeenMetres = 0.5;
    const QString text = tr("%n character(s) taken again: \"%1\".", nullptr, people).arg(name);
    m_state.showStatus(
        furthestMetres < kSeenMetres
            ? text
            : text + QLatin1Char(' ') +
                  tr("At the end somebody is brought back over %1 m: choose a longer stretch.")
                      .arg(QLocale().toString(furthestMetres, 'f', 1)));
}

void TakesDock::showMenu(const QPoint& position)
{
    QListWidgetItem* item = m_list->itemAt(position);
    if (item == nullptr) {
        return;
    }
    m_list->setCurrentItem(item);
    QMenu menu(this);
    menu.addAction(tr("Show"), this, &TakesDock::showChosen)->setEnabled(m_show->isEnabled());
    if (chosen() != 0) {
        menu.addAction(m_ghost->isChecked() ? tr("Hide Ghosts") : tr("See as Ghosts"), m_ghost,
                       &QToolButton::click)
            ->setEnabled(m_ghost->isEnabled());
        menu.addSeparator();
        menu.addAction(tr("Rename"), this, [this, item] { m_list->editItem(item); });
        menu.addAction(tr("Delete"), this, &TakesDock::removeChosen);
    }
    menu.exec(m_list->viewport()->mapToGlobal(position));
}

void TakesDock::showChosen()
{
    showTake(m_state, chosen());
}

void TakesDock::removeChosen()
{
    if (chosen() != 0) {
        m_state.takes().remove(chosen());
    }
}

} // namespace crowd::widgets
