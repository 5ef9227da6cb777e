// SPDX-License-Identifier: MIT
#include "widgets/docks/SurfaceForm.h"

#include <QtCore/QLocale>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/document/SceneEdit.h"
#include "widgets/forms/NumberField.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

SurfaceForm::SurfaceForm(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_fold(new QToolButton(this)), m_rows(new QWidget(this)),
      m_shown(new QCheckBox(tr("Show on the ground"), this)), m_note(new QLabel(this))
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(3);
    m_fold->setObjectName(QStringLiteral("foldSurface"));
    m_fold->setText(tr("Where characters can walk"));
    m_fold->setCheckable(true);
    m_fold->setAutoRaise(true);
    m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_fold->setArrowType(Qt::RightArrow);
    layout->addWidget(m_fold);
    layout->addWidget(m_rows);
    auto* form = new QFormLayout(m_rows);
    form->setContentsMargins(4, 0, 4, 0);
    addField(tr("Body radius, m"), tr("So far characters keep from walls"), "surfaceRadius",
             &model::SurfaceSettings::radius, 0.05, 5.0);
    addField(tr("Body height, m"), tr("Lower places are not walked under"), "surfaceHeight",
             &model::SurfaceSettings::height, 0.2, 20.0);
    addField(tr("Highest step, m"), {}, "surfaceClimb", &model::SurfaceSettings::climb, 0.0, 5.0);
    addField(tr("Steepest slope, °"), {}, "surfaceSlope", &model::SurfaceSettings::slopeDegrees,
             0.0, 85.0);
    setUpShown();
    form->addRow(m_shown);
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    form->addRow(m_note);
    m_rows->hide();
    connect(m_fold, &QToolButton::toggled, this, [this](bool isOpen) {
        m_fold->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        m_rows->setVisible(isOpen);
    });
    connect(&state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::PathsChanged, model::SceneReplaced>(change)) {
                    refresh();
                }
            });
    connect(&state.session(), &SessionControl::surfaceChanged, this, &SurfaceForm::showState);
    refresh();
    showState();
}

/// The same as the entry of the View menu.
void SurfaceForm::setUpShown()
{
    m_shown->setObjectName(QStringLiteral("surfaceShown"));
    m_shown->setToolTip(tr("Colours the ground of the stages where characters can walk"));
    connect(m_shown, &QCheckBox::toggled, this, [this](bool isOn) {
        ViewOptions options = m_state.viewOptions();
        options.showWalkable = isOn;
        m_state.setViewOptions(options);
    });
    connect(&m_state, &EditorState::viewOptionsChanged, this,
            [this] { m_shown->setChecked(m_state.viewOptions().showWalkable); });
    m_shown->setChecked(m_state.viewOptions().showWalkable);
}

void SurfaceForm::addField(const QString& label, const QString& tip, const char* name,
                           float model::SurfaceSettings::*member, double low, double high)
{
    auto* field = new NumberField(low, high, 2, m_rows);
    field->setObjectName(QLatin1String(name));
    field->setToolTip(tip);
    static_cast<QFormLayout*>(m_rows->layout())->addRow(label, field);
    connect(field, &NumberField::valueEdited, this, [this, member](double value) {
        model::SurfaceSettings changed = m_state.scene().surface;
        changed.*member = static_cast<float>(value);
        m_state.document().edit(tr("Change where characters can walk"),
                                [&](model::SceneEdit& edit) { edit.setSurface(changed); });
    });
    m_fields.push_back({field, member});
}

void SurfaceForm::refresh()
{
    for (const Field& field : m_fields) {
        field.widget->setValue(static_cast<double>(m_state.scene().surface.*field.member));
    }
}

void SurfaceForm::showState()
{
    const SessionControl& session = m_state.session();
    const double progress = session.surfaceProgress();
    if (progress >= 0.0) {
        m_note->setText(tr("Being found: %1 %").arg(qRound(progress * 100.0)));
    } else if (!session.surfaceProblem().isEmpty()) {
        m_note->setText(session.surfaceProblem());
    } else if (session.surfacePolygons() > 0) {
        m_note->setText(
            tr("Found: %n areas", nullptr, static_cast<int>(session.surfacePolygons())));
    } else {
        m_note->setText(tr("Open ground. It is looked at once somebody walks among a stage, "
                           "obstacles or painted ground."));
    }
}

} // namespace crowd::widgets
