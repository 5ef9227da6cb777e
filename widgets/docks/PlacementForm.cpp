// SPDX-License-Identifier: MIT
#include "widgets/docks/PlacementForm.h"

#include <algorithm>

#include <QtWidgets/QLabel>
#include <QtWidgets/QVBoxLayout>

#include "model/base/ShownText.h"
#include "widgets/commands/StageCommands.h"
#include "widgets/forms/FieldForm.h"

namespace crowd::widgets {

namespace {

constexpr int kViewRefreshMs = 100;

QString shortName(const std::string& name)
{
    return QString::fromStdString(model::shortened(name));
}

} // namespace

PlacementForm::PlacementForm(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_edit(state.document(), this), m_title(new QLabel(this))
{
    m_title->setObjectName(QStringLiteral("placementTitle"));
    m_title->setMinimumWidth(1); // a name of any length
    m_stageForm = makeStageForm();
    m_cameraForm = makeCameraForm();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 2, 2, 2);
    layout->setSpacing(2);
    layout->addWidget(m_title);
    layout->addWidget(m_stageForm);
    layout->addWidget(m_cameraForm);
    m_soon.setSingleShot(true);
    m_soon.setInterval(kViewRefreshMs);
    connect(&m_soon, &QTimer::timeout, this, &PlacementForm::refresh);
    connect(&m_state, &EditorState::viewCameraChanged, this, [this] {
        if (stage() == nullptr && isVisible() && !m_soon.isActive()) {
            m_soon.start();
        }
    });
    refresh();
}

FieldForm* PlacementForm::makeStageForm()
{
    static const model::StageEntry kNone;
    const FormTarget target{
        [this]() -> const void* { return stage() != nullptr ? stage() : &kNone; },
        [this](const auto& apply) { changeStage(apply); },
        [this] {
            return model::FieldContext{&m_state.scene(), nullptr};
        }};
    auto* form = new FieldForm(target, QStringLiteral("stagePlacement"), &m_state, this);
    form->setObjectName(QStringLiteral("stagePlacement"));
    form->addFields(model::fieldsOf<model::StageEntry>());
    form->addNote(tr("Who sits in its seats goes with it."));
    form->finish();
    connect(form, &FieldForm::held, &m_edit, &HeldEdit::hold);
    return form;
}

FieldForm* PlacementForm::makeCameraForm()
{
    const FormTarget target{
        [this]() -> const void* { return camera() != nullptr ? camera() : &m_state.camera(); },
        [this](const auto& apply) { changeCamera(apply); },
        [this] {
            return model::FieldContext{&m_state.scene(), nullptr};
        }};
    auto* form = new FieldForm(target, QStringLiteral("cameraForm"), &m_state, this);
    form->setObjectName(QStringLiteral("cameraForm"));
    form->addFields(model::fieldsOf<model::Camera>());
    form->finish();
    connect(form, &FieldForm::held, this, [this](bool isHeld) {
        if (camera() != nullptr || !isHeld) {
            m_edit.hold(isHeld);
        }
    });
    return form;
}

const model::StageEntry* PlacementForm::stage() const
{
    return m_stageId ? m_state.scene().findStage(*m_stageId) : nullptr;
}

const model::Camera* PlacementForm::camera() const
{
    const auto& all = m_state.scene().cameras;
    const auto found =
        std::ranges::find(all, m_cameraName.toStdString(), &model::NamedCamera::name);
    return m_cameraName.isEmpty() || found == all.end() ? nullptr : &found->camera;
}

void PlacementForm::changeStage(const std::function<void(void*)>& apply)
{
    if (stage() == nullptr) {
        return;
    }
    model::StageEntry placed = *stage();
    apply(&placed);
    (void)m_edit.put(tr("Place stage"),
                     [&](model::SceneEdit& edit) { placeStage(edit, m_state.scene(), placed); });
}

/// The view goes with the camera that it is at.
void PlacementForm::changeCamera(const std::function<void(void*)>& apply)
{
    if (camera() == nullptr) {
        model::Camera changed = m_state.camera();
        apply(&changed);
        m_state.setCamera(changed);
        return;
    }
    const bool isThere = m_state.viewCamera().name == m_cameraName;
    std::vector<model::NamedCamera> all = m_state.scene().cameras;
    const auto found =
        std::ranges::find(all, m_cameraName.toStdString(), &model::NamedCamera::name);
    apply(&found->camera);
    const model::Camera changed = found->camera;
    if (m_edit.put(tr("Change camera"),
                   [&](model::SceneEdit& edit) { edit.setCameras(std::move(all)); }) &&
        isThere) {
        m_put = changed;
        m_state.setCamera(changed, m_cameraName);
    }
}

void PlacementForm::followCameras()
{
    const model::Camera* now = camera();
    const bool wentAlong =
        m_put && m_state.viewCamera().name == m_cameraName && m_state.camera() == *m_put;
    if (now != nullptr && wentAlong && !(*now == *m_put)) {
        m_put = *now;
        m_state.setCamera(m_put.value(), m_cameraName);
    }
    refresh();
}

void PlacementForm::showStage(std::uint8_t id)
{
    m_stageId = id;
    m_cameraName.clear();
    refresh();
}

void PlacementForm::showCamera(const QString& name)
{
    m_stageId.reset();
    m_cameraName = name;
    refresh();
}

void PlacementForm::showView()
{
    m_stageId.reset();
    m_cameraName.clear();
    refresh();
}

void PlacementForm::refresh()
{
    const bool hasStage = stage() != nullptr;
    m_title->setText(hasStage ? tr("Stage: %1").arg(shortName(stage()->name))
                     : camera() != nullptr
                         ? tr("Camera: %1").arg(shortName(m_cameraName.toStdString()))
                         : tr("This view"));
    m_stageForm->setVisible(hasStage);
    m_cameraForm->setVisible(!hasStage);
    (hasStage ? m_stageForm : m_cameraForm)->refresh();
}

} // namespace crowd::widgets
