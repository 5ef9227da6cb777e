// SPDX-License-Identifier: MIT
#include "widgets/docks/LightDock.h"

#include <utility>

#include <QtWidgets/QMenu>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/scene/ReadyLight.h"
#include "widgets/docks/FieldForm.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/SceneChanges.h"
#include "widgets/theme/Icons.h"

namespace crowd::widgets {

LightDock::LightDock(EditorState& state, QWidget* parent)
    : DockBase(tr("Light"), "light", parent), m_state(state)
{
    auto* content = new QWidget(this);
    auto* layout = new QVBoxLayout(content);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(makeReady());
    makeForm();
    layout->addWidget(m_form);
    setScrolledContent(content);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::LightingChanged, model::SceneReplaced>(change)) {
                    m_form->refresh();
                }
            });
    connect(&m_state.document(), &model::SceneDocument::editInterrupted, this,
            [this] { m_edit.reset(); });
}

LightDock::~LightDock() = default;

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

void LightDock::makeForm()
{
    const FormTarget target{[this]() -> const void* { return &m_state.scene().lighting; },
                            [this](const std::function<void(void*)>& apply) { change(apply); },
                            [this] {
                                return model::FieldContext{&m_state.scene(), nullptr};
                            }};
    m_form = new FieldForm(target, QStringLiteral("light"), &m_state, this);
    m_form->setObjectName(QStringLiteral("lightForm"));
    m_form->addFields(model::fieldsOf<model::Lighting>());
    m_form->finish();
    connect(m_form, &FieldForm::held, this, &LightDock::hold);
}

void LightDock::change(const std::function<void(void*)>& apply)
{
    model::Lighting light = m_state.scene().lighting;
    apply(&light);
    put(light);
}

void LightDock::put(const model::Lighting& light)
{
    if (m_edit) {
        m_edit->setLighting(light);
        return;
    }
    const auto outcome = m_state.document().edit(
        tr("Change light"), [&](model::SceneEdit& edit) { edit.setLighting(light); });
    if (outcome == model::EditOutcome::Refused) {
        m_form->refresh();
    }
}

void LightDock::hold(bool isHeld)
{
    if (isHeld && !m_edit) {
        if (auto edit = m_state.document().beginEdit()) {
            m_edit = std::move(edit).value();
        }
    } else if (!isHeld && m_edit) {
        const std::unique_ptr<model::SceneEdit> edit = std::move(m_edit);
        edit->commit(tr("Change light"));
    }
}

} // namespace crowd::widgets
