// SPDX-License-Identifier: MIT
#include "widgets/docks/TimelineDock.h"

#include <array>
#include <utility>

#include <QtCore/QSettings>
#include <QtCore/QStringList>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QScrollArea>
#include <QtWidgets/QSplitter>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/base/Translated.h"
#include "model/rules/MarkFlaws.h"
#include "widgets/commands/TimelineCommands.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/timeline/TimelineView.h"

namespace crowd::widgets {

using model::Mark;

namespace {

constexpr int kSideWidth = 240; ///< at first, logical pixels
constexpr int kLeastSide = 200; ///< nothing in it is cut
constexpr int kGroupGap = 4;    ///< logical pixels
constexpr int kMostFlaws = 4;
constexpr std::array kFrameRates{0, 24, 25, 30, 60};
const QString kUnitKey = QStringLiteral("timeline/frameRate");
const QString kSideKey = QStringLiteral("timeline/side");

} // namespace

TimelineDock::TimelineDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Timeline"), "timeline", parent), m_state(state), m_edit(state.document(), this),
      m_view(new TimelineView(state, this)), m_units(new QComboBox(this)), m_note(new QLabel(this))
{
    auto* content = new QWidget(this);
    auto* layout = new QHBoxLayout(content);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(makeHalves());
    setWidget(content);
    connect(m_view, &TimelineView::chosenChanged, this, &TimelineDock::followChosen);
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::RulesChanged, model::StatesChanged, model::CamerasChanged,
                            model::PathsChanged, model::SceneReplaced>(change)) {
                    makeForm();
                    followChosen();
                } else if (isOneOf<model::TimelineChanged, model::IndividualsAdded,
                                   model::IndividualsRemoved>(change)) {
                    followChosen();
                }
                followLoop();
                if (isOneOf<model::SceneReplaced>(change)) {
                    m_view->showAll();
                }
            });
    followChosen();
}

/// The timeline, and at its side what is said of a mark: where that stands empty, the artist draws
/// the border between them to the edge.
QWidget* TimelineDock::makeHalves()
{
    auto* main = new QWidget(this);
    auto* layout = new QVBoxLayout(main);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(makeButtons());
    layout->addWidget(m_view, 1);
    auto* halves = new QSplitter(this);
    halves->addWidget(main);
    halves->addWidget(makeSide());
    halves->setCollapsible(0, false);
    halves->setStretchFactor(0, 1);
    halves->setStretchFactor(1, 0);
    halves->handle(1)->setToolTip(tr("Drag the side away, or back from the edge"));
    halves->setSizes({width(), kSideWidth});
    halves->restoreState(QSettings().value(kSideKey).toByteArray());
    connect(halves, &QSplitter::splitterMoved, this,
            [halves] { QSettings().setValue(kSideKey, halves->saveState()); });
    return halves;
}

QWidget* TimelineDock::makeButtons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(1);
    const auto add = [row, layout](const char* icon, const QString& tip, const char* name) {
        QToolButton* button = panelButton(row, icon, tip, name);
        layout->addWidget(button);
        return button;
    };
    m_record = add("record",
                   tr("Record: cues, states and events become marks of the timeline as they are "
                      "performed while it plays"),
                   "timelineRecord");
    m_record->setCheckable(true);
    m_record->setChecked(m_state.session().recorder().isOn());
    MarkRecorder& recorder = m_state.session().recorder();
    connect(m_record, &QToolButton::toggled, &recorder, &MarkRecorder::setOn);
    connect(&recorder, &MarkRecorder::changed, m_record, &QToolButton::setChecked);
    connect(add("mark-back", tr("The mark before this moment"), "markBack"), &QToolButton::clicked,
            this, [this] { showNextMark(m_state, false); });
    connect(add("mark-next", tr("The mark after this moment"), "markNext"), &QToolButton::clicked,
            this, [this] { showNextMark(m_state, true); });
    connect(add("mark", tr("A marker at this moment"), "markAdd"), &QToolButton::clicked, this,
            [this] { addMarkerNow(m_state); });
    connect(add("camera-mark", tr("From this moment on the camera looks as the view does now"),
                "cameraMark"),
            &QToolButton::clicked, this, [this] { addCameraNow(m_state); });
    m_remove = add("delete", tr("Remove the chosen marks"), "markRemove");
    connect(m_remove, &QToolButton::clicked, this,
            [this] { removeMarks(m_state, MarkIds(m_view->chosen())); });
    layout->addSpacing(kGroupGap);
    addRangeButtons(add);
    layout->addSpacing(kGroupGap);
    addFollow(*add("camera-follow",
                   tr("The view looks through the timeline's camera, where there is one"),
                   "cameraFollow"));
    layout->addStretch(1);
    connect(add("frame-all", tr("Show all marks, and all that has been played"), "timelineAll"),
            &QToolButton::clicked, m_view, &TimelineView::showAll);
    makeUnits();
    layout->addWidget(m_units);
    return row;
}

/// Which part of time is played.
void TimelineDock::addRangeButtons(const AddButton& add)
{
    connect(add("range-begin", tr("What is played begins at this moment"), "rangeBegin"),
            &QToolButton::clicked, this,
            [this] { beginPlayRange(m_state, m_state.transport().seconds()); });
    connect(add("range-end", tr("What is played ends at this moment"), "rangeEnd"),
            &QToolButton::clicked, this,
            [this] { endPlayRange(m_state, m_state.transport().seconds()); });
    m_loop = add("loop", tr("Play over and over"), "playLoop");
    m_loop->setCheckable(true);
    connect(m_loop, &QToolButton::clicked, this, [this](bool isOn) {
        setPlayLoop(m_state, isOn);
        followLoop(); // also where it was refused
    });
    followLoop();
}

void TimelineDock::addFollow(QToolButton& button)
{
    CameraDirector& director = m_state.director();
    button.setCheckable(true);
    button.setChecked(director.isOn());
    connect(&button, &QToolButton::clicked, &director, &CameraDirector::setOn);
    connect(&director, &CameraDirector::changed, &button, &QToolButton::setChecked);
}

void TimelineDock::makeUnits()
{
    m_units->setObjectName(QStringLiteral("timelineUnits"));
    m_units->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_units->setMinimumContentsLength(8); // "Sekunden"
    m_units->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_units->setToolTip(tr("What times are shown in, and caught by when marks are dragged"));
    const int before = QSettings().value(kUnitKey).toInt();
    for (const int rate : kFrameRates) {
        m_units->addItem(rate == 0 ? tr("Seconds") : tr("%1 frames/s").arg(rate), rate);
        if (rate == before) {
            m_units->setCurrentIndex(m_units->count() - 1);
            m_view->setFrameRate(rate);
        }
    }
    connect(m_units, &QComboBox::currentIndexChanged, this, [this] {
        m_view->setFrameRate(m_units->currentData().toInt());
        QSettings().setValue(kUnitKey, m_view->frameRate());
    });
}

QWidget* TimelineDock::makeSide()
{
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(6, 0, 0, 0);
    m_note->setObjectName(QStringLiteral("markNote"));
    m_note->setWordWrap(true);
    layout->addWidget(m_note);
    layout->addStretch(1);
    m_side = content;
    makeForm();
    auto* area = new QScrollArea(this);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setWidget(content);
    area->setMinimumWidth(kLeastSide);
    return area;
}

/// Anew where what it offers has changed: cues, states, events.
void TimelineDock::makeForm()
{
    if (m_form != nullptr) {
        m_edit.hold(false);
        delete m_form; // it changes marks alone: what it offers is changed elsewhere
    }
    const FormTarget target{[this]() -> const void* { return &shown(); },
                            [this](const auto& apply) { change(apply); },
                            [this] {
                                return model::FieldContext{&m_state.scene(), nullptr};
                            }};
    m_form = new FieldForm(target, QStringLiteral("mark"), &m_state, m_side);
    m_form->setObjectName(QStringLiteral("markForm"));
    m_form->setNotesShown(false); // there is little room, and more than one has to be seen
    m_form->addFields(model::fieldsOf<Mark>());
    m_form->finish();
    connect(m_form, &FieldForm::held, &m_edit, &HeldEdit::hold);
    static_cast<QVBoxLayout*>(m_side->layout())->insertWidget(0, m_form);
}

void TimelineDock::followChosen()
{
    const bool isOne = m_view->chosen().size() == 1;
    m_remove->setEnabled(!m_view->chosen().empty());
    m_form->setVisible(isOne);
    if (isOne) {
        m_form->refresh();
    }
    describe();
}

void TimelineDock::followLoop()
{
    m_loop->setChecked(m_state.scene().playRange.isLoop);
}

/// What is wrong with the chosen marks, or where none is chosen with any.
QString TimelineDock::flaws() const
{
    const MarkIds& chosen = m_view->chosen();
    QStringList all;
    const auto flawed = model::flawsOfMarks(m_state.scene());
    for (const Mark& mark : model::inOrder(m_state.scene().timeline)) {
        const bool isMeant = chosen.empty() || chosen.contains(mark.id);
        const auto flaw = flawed.find(mark.id);
        if (isMeant && flaw != flawed.end()) {
            all << tr("⚠ %1").arg(model::translated(flaw->second));
        }
    }
    if (all.size() > kMostFlaws) {
        const auto more = static_cast<int>(all.size()) - kMostFlaws;
        all = all.mid(0, kMostFlaws);
        all << tr("And %n more.", nullptr, more);
    }
    return all.join(QStringLiteral("\n\n"));
}

void TimelineDock::describe()
{
    const auto count = static_cast<int>(m_view->chosen().size());
    const Mark& mark = shown();
    QString text = tr("Choose a mark to see what happens there.");
    if (count > 1) {
        text = tr("%n marks are chosen: drag them, or remove them.", nullptr, count);
    } else if (count == 1 && !mark.people.empty()) {
        text = tr("For %n characters, as it was recorded.", nullptr,
                  static_cast<int>(mark.people.size()));
    } else if (count == 1) {
        text.clear();
    }
    if (const QString wrong = flaws(); !wrong.isEmpty()) {
        text = text.isEmpty() ? wrong : wrong + QStringLiteral("\n\n") + text;
    }
    m_note->setText(text);
    m_note->setVisible(!text.isEmpty());
}

const Mark& TimelineDock::shown() const
{
    static const Mark kNone;
    const MarkIds& chosen = m_view->chosen();
    const Mark* mark =
        chosen.size() == 1 ? model::findMark(m_state.scene().timeline, *chosen.begin()) : nullptr;
    return mark != nullptr ? *mark : kNone;
}

void TimelineDock::change(const std::function<void(void*)>& apply)
{
    model::Timeline timeline =
        withMark(m_state.scene().timeline, shown().id, [&apply](Mark& mark) { apply(&mark); });
    if (!m_edit.put(tr("Change a mark"), [&timeline](model::SceneEdit& edit) {
            edit.set<model::members::Timeline>(std::move(timeline));
        })) {
        m_form->refresh();
    }
}

void TimelineDock::takeOver(DockBase& before)
{
    DockBase::takeOver(before);
    if (const auto* view = before.findChild<TimelineView*>()) {
        m_view->choose(MarkIds(view->chosen()));
    }
}

} // namespace crowd::widgets
