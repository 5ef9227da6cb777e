// SPDX-License-Identifier: MIT
#include "widgets/docks/LightDock.h"

#include <algorithm>
#include <string>
#include <utility>

#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QListWidget>
#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/scene/DayLight.h"
#include "model/scene/ReadyLight.h"
#include "widgets/commands/LightCommands.h"
#include "widgets/commands/ViewCommands.h"
#include "widgets/forms/FieldForm.h"
#include "widgets/forms/PanelButton.h"
#include "widgets/forms/PointPicking.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

using model::Light;
using model::LightId;

namespace {

constexpr int kLightIdRole = Qt::UserRole;
constexpr int kLightRows = 6;
constexpr int kButtonGap = 1; ///< pixels: the panel is to be narrow

std::string iconOf(std::size_t kind)
{
    return std::string("light-") + model::kLightKinds[kind].key;
}

} // namespace

LightDock::LightDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Light"), "light", parent), m_state(state), m_edit(state.document(), this),
      m_list(new QListWidget(this)), m_note(new QLabel(this))
{
    m_list->setObjectName(QStringLiteral("lights"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_note->setObjectName(QStringLiteral("lightNote"));
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(makeButtons());
    layout->addWidget(m_list);
    layout->addWidget(m_note);
    makeSunForm();
    layout->addWidget(m_sunForm);
    m_lightPlace = new QVBoxLayout;
    layout->addLayout(m_lightPlace);
    makeLightForm();
    m_frame->hide(); // the sun's buttons want its room
    setScrolledContent(content);
    connectParts();
    fill();
}

LightDock::~LightDock() = default;

QWidget* LightDock::makeButtons()
{
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(kButtonGap);
    const auto add = [&](const char* icon, const QString& tip, const char* name, auto act) {
        QToolButton* button = panelButton(row, icon, tip, name);
        connect(button, &QToolButton::clicked, this, act);
        layout->addWidget(button);
        return button;
    };
    for (std::size_t kind = 0; kind < model::kLightKinds.size(); ++kind) {
        const model::FieldChoice& choice = model::kLightKinds[kind];
        auto* button =
            add(iconOf(kind).c_str(),
                tr("Add: %1. Then click what it is to shine on").arg(fieldText(choice.label)),
                (std::string("add-") + choice.key).c_str(), [this](bool isPressed) {
                    if (isPressed) {
                        m_state.showStatus(tr("Click what it is to shine on."));
                    }
                });
        makePointButton(*button, m_state, [this, kind](const glm::vec3& metres) {
            addLight(m_state, static_cast<model::LightKind>(kind), metres);
            m_state.showStatus(tr("It can be dragged in the picture with the tool Select."));
        });
    }
    QToolButton* follow =
        add("light-follow", tr("Add: a spotlight that goes with somebody. Then click him"),
            "add-follow", [this](bool isPressed) {
                if (isPressed) {
                    m_state.showStatus(tr("Click whom it is to follow."));
                }
            });
    makePersonButton(*follow, m_state,
                     [this](model::IndividualId id) { addFollowSpot(m_state, id); });
    m_ready = makeReady();
    layout->addWidget(m_ready);
    layout->addStretch(1);
    m_frame = add("frame", tr("Show the chosen lamp in the picture"), "frameLight",
                  [this](bool) { frameLight(m_state); });
    m_remove = add("delete", tr("Remove the chosen light"), "removeLight",
                   [this](bool) { removeLight(m_state, m_state.chosenLight()); });
    removeByKey(*m_list, [this] {
        if (m_remove->isEnabled()) {
            removeLight(m_state, m_state.chosenLight());
        }
    });
    return row;
}

QWidget* LightDock::makeReady()
{
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("readyLight"));
    button->setText(tr("Ready-Made"));
    button->setIcon(iconNamed("light"));
    button->setToolTip(tr("Sun, sky and colours of a time of day; the ground stays"));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    for (const model::ReadyLight& ready : model::readyLights()) {
        menu->addAction(fieldText(ready.label), this,
                        [this, &ready] { put(model::litAs(ready, m_state.scene().lighting)); });
    }
    button->setMenu(menu);
    return button;
}

void LightDock::makeSunForm()
{
    const FormTarget target{[this]() -> const void* { return &m_state.scene().lighting; },
                            [this](const auto& apply) { changeLighting(apply); },
                            [this] {
                                return model::FieldContext{&m_state.scene(), nullptr};
                            }};
    m_sunForm = new FieldForm(target, QStringLiteral("light"), &m_state, this);
    m_sunForm->setObjectName(QStringLiteral("lightForm"));
    m_sunForm->addFields(model::fieldsOf<model::Lighting>());
    m_sunForm->finish();
    connect(m_sunForm, &FieldForm::held, &m_edit, &HeldEdit::hold);
}

void LightDock::makeLightForm()
{
    delete m_lightForm;
    const FormTarget target{[this]() -> const void* { return &shownLight(); },
                            [this](const auto& apply) { changeLight(apply); },
                            [this] {
                                return model::FieldContext{&m_state.scene(), nullptr};
                            }};
    m_lightForm = new FieldForm(target, QStringLiteral("lamp"), &m_state, this);
    m_lightForm->setObjectName(QStringLiteral("lampForm"));
    m_lightForm->addFields(model::fieldsOf<Light>());
    m_lightForm->addNote(tr("In the picture, while Select is chosen: drag the lamp, with Shift up "
                            "and down, the edge of its cone, or what it shines on; with Ctrl onto "
                            "somebody, and it goes with him."),
                         [this] { return isAimed(shownLight()); });
    m_lightForm->addNote(tr("In the picture, while Select is chosen: drag the lamp, with Shift up "
                            "and down."),
                         [this] { return !isAimed(shownLight()); });
    m_lightForm->finish();
    connect(m_lightForm, &FieldForm::held, &m_edit, &HeldEdit::hold);
    m_lightPlace->addWidget(m_lightForm);
}

const Light& LightDock::shownLight() const
{
    static const Light kNone;
    const Light* chosen = model::findLight(m_state.scene().lights, m_state.chosenLight());
    return chosen != nullptr ? *chosen : kNone;
}

void LightDock::connectParts()
{
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::GroupsChanged, model::SceneReplaced>(change)) {
                    makeLightForm(); // its lists are those of now
                }
                if (isOneOf<model::LightsChanged, model::SceneReplaced>(change)) {
                    const auto fresh = newLight();
                    fill();
                    if (fresh && isOneOf<model::LightsChanged>(change)) {
                        m_state.chooseLight(*fresh);
                    }
                } else if (isOneOf<model::LightingChanged, model::GroupsChanged,
                                   model::IndividualsRemoved>(change)) {
                    showChosen();
                }
            });
    connect(&m_state, &EditorState::lightChosen, this, &LightDock::markChosen);
    connect(m_list, &QListWidget::currentRowChanged, this, &LightDock::choose);
    connect(m_list, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!m_isFilling) {
            takeItem(*item);
        }
    });
}

void LightDock::addRow(const QString& name, LightId id, const Light* light)
{
    const std::string icon =
        light == nullptr ? "light" : iconOf(static_cast<std::size_t>(light->kind));
    auto* item = new QListWidgetItem(iconNamed(icon.c_str()), name, m_list);
    item->setData(kLightIdRole, id);
    if (light != nullptr) {
        item->setFlags(item->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
        item->setCheckState(light->isOn ? Qt::Checked : Qt::Unchecked);
        item->setToolTip(tr("Ticked: it is on. Double click or F2: rename"));
    }
}

/// One that has come, or come back by undo, is what is to be worked on.
std::optional<LightId> LightDock::newLight()
{
    const model::Lights& lights = m_state.scene().lights;
    std::vector<LightId> now(lights.size());
    std::ranges::transform(lights, now.begin(), &Light::id);
    const std::vector<LightId> before = std::exchange(m_known, now);
    if (now.size() != before.size() + 1) {
        return std::nullopt;
    }
    const auto fresh = std::ranges::find_if(
        now, [&before](LightId id) { return std::ranges::find(before, id) == before.end(); });
    return fresh != now.end() ? std::optional(*fresh) : std::nullopt;
}

void LightDock::fill()
{
    if (m_list->viewport()->findChild<QLineEdit*>() != nullptr) {
        return; // not under the hands of who renames
    }
    m_isFilling = true;
    m_list->clear();
    addRow(tr("Sun and sky"), 0, nullptr);
    const model::Lights& lights = m_state.scene().lights;
    for (const Light& light : lights) {
        addRow(QString::fromStdString(light.name), light.id, &light);
    }
    m_isFilling = false;
    const int rows = std::min(m_list->count(), kLightRows);
    m_list->setFixedHeight(rows * m_list->sizeHintForRow(0) + 2 * m_list->frameWidth() + 4);
    const auto on = static_cast<std::size_t>(std::ranges::count_if(lights, &Light::isOn));
    m_note->setVisible(on > model::kMostLightsDrawn);
    m_note->setText(
        tr("%n lights are on; the strongest %1 of them shine.", nullptr, static_cast<int>(on))
            .arg(model::kMostLightsDrawn));
    markChosen();
}

/// The rows stay: somebody may be about to rename one.
void LightDock::markChosen()
{
    const model::Lights& lights = m_state.scene().lights;
    const auto chosen = std::ranges::find(lights, m_state.chosenLight(), &Light::id);
    const int row = chosen == lights.end() ? 0 : static_cast<int>(chosen - lights.begin()) + 1;
    m_isFilling = true;
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
    m_isFilling = false;
    showChosen();
}

void LightDock::choose()
{
    const QListWidgetItem* item = m_list->currentItem();
    if (!m_isFilling && item != nullptr) {
        m_state.chooseLight(static_cast<LightId>(item->data(kLightIdRole).toUInt()));
    }
}

void LightDock::showChosen()
{
    const bool isSun = m_state.chosenLight() == 0;
    m_ready->setVisible(isSun);
    m_remove->setEnabled(!isSun);
    m_frame->setVisible(!isSun);
    m_sunForm->setVisible(isSun);
    m_lightForm->setVisible(!isSun);
    (isSun ? m_sunForm : m_lightForm)->refresh();
}

/// Renamed, or switched on or off.
void LightDock::takeItem(const QListWidgetItem& item)
{
    const auto id = static_cast<LightId>(item.data(kLightIdRole).toUInt());
    const Light* light = model::findLight(m_state.scene().lights, id);
    if (light == nullptr) {
        return;
    }
    const bool isOn = item.checkState() == Qt::Checked;
    const std::string name = item.text().simplified().toStdString();
    const QString text = isOn == light->isOn ? tr("Rename a light")
                         : isOn              ? tr("Switch a light on")
                                             : tr("Switch a light off");
    widgets::changeLight(m_state, id, text, [&](Light& each) {
        each.isOn = isOn;
        each.name = name.empty() ? each.name : name;
    });
    // After the list has closed its line: what was refused gets its old name back.
    QMetaObject::invokeMethod(this, &LightDock::fill, Qt::QueuedConnection);
}

void LightDock::changeLighting(const std::function<void(void*)>& apply)
{
    const model::Lighting& before = m_state.scene().lighting;
    model::Lighting light = before;
    apply(&light);
    followHaze(light, before);
    put(light);
}

void LightDock::changeLight(const std::function<void(void*)>& apply)
{
    put(withLight(m_state.scene().lights, m_state.chosenLight(),
                  [&apply](Light& light) { apply(&light); }),
        tr("Change a light"));
}

void LightDock::put(const model::Lighting& light)
{
    if (!m_edit.put(tr("Change sun, sky or air"),
                    [&](model::SceneEdit& edit) { edit.setLighting(light); })) {
        m_sunForm->refresh();
    }
}

void LightDock::put(const model::Lights& lights, const QString& undoText)
{
    if (!m_edit.put(undoText, [&](model::SceneEdit& edit) { edit.setLights(lights); })) {
        m_lightForm->refresh();
    }
}

} // namespace crowd::widgets
