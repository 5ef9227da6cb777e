// SPDX-License-Identifier: MIT
#include "widgets/docks/LightForm.h"

#include <cmath>

#include <QtWidgets/QFormLayout>
#include <QtWidgets/QSlider>

#include "model/document/SceneEdit.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

namespace {

constexpr float kDegree = 3.14159265F / 180.0F;
constexpr float kPerCent = 0.01F;

} // namespace

LightForm::LightForm(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 4, 0, 0);
    addSlider(tr("Sun from"), -180, 180, &model::Lighting::sunAzimuthRadians, kDegree);
    addSlider(tr("Sun height"), 2, 90, &model::Lighting::sunElevationRadians, kDegree);
    addSlider(tr("Sun"), 0, 200, &model::Lighting::sunStrength, kPerCent);
    addSlider(tr("Sky"), 0, 200, &model::Lighting::ambientStrength, kPerCent);
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::LightingChanged, model::SceneReplaced>(change)) {
                    refresh();
                }
            });
    connect(&m_state.document(), &model::SceneDocument::editInterrupted, this,
            [this] { m_edit.reset(); });
    refresh();
}

LightForm::~LightForm() = default;

QSlider* LightForm::addSlider(const QString& label, int low, int high,
                              float model::Lighting::*value, float scale)
{
    auto* slider = new QSlider(Qt::Horizontal, this);
    slider->setRange(low, high);
    static_cast<QFormLayout*>(layout())->addRow(label, slider);
    m_rows.push_back({slider, value, scale});
    connect(slider, &QSlider::sliderPressed, this, [this] {
        if (auto edit = m_state.document().beginEdit()) {
            m_edit = std::move(edit).value();
        }
    });
    connect(slider, &QSlider::sliderReleased, this, [this] {
        if (m_edit) {
            m_edit->commit(tr("Change light"));
            m_edit.reset();
        }
    });
    connect(slider, &QSlider::valueChanged, this, [this, value, scale](int steps) {
        if (m_isFilling) {
            return;
        }
        model::Lighting light = m_state.scene().lighting;
        light.*value = static_cast<float>(steps) * scale;
        if (m_edit) {
            m_edit->setLighting(light);
            return;
        }
        const auto outcome = m_state.document().edit(
            tr("Change light"), [&](model::SceneEdit& edit) { edit.setLighting(light); });
        if (outcome == model::EditOutcome::Refused) {
            refresh();
        }
    });
    return slider;
}

void LightForm::refresh()
{
    m_isFilling = true;
    for (const Row& row : m_rows) {
        row.slider->setValue(
            static_cast<int>(std::lround(m_state.scene().lighting.*row.value / row.scale)));
    }
    m_isFilling = false;
}

} // namespace crowd::widgets
