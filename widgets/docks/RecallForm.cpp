// SPDX-License-Identifier: MIT
#include "widgets/docks/RecallForm.h"

#include <iterator>

#include <QtCore/QSettings>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QVBoxLayout>

#include "widgets/forms/FieldForm.h"
#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

namespace {

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

RecallForm::RecallForm(EditorState& state, QWidget* parent) : QWidget(parent), m_state(state)
{
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(2);
    rows->addWidget(new QLabel(tr("When one is recalled"), this));
    RecallSettings recall = m_state.recall();
    restoreRecall(recall);
    m_state.setRecall(recall);
    addTiming();
    addReach();
    connect(&m_state.document(), &model::SceneDocument::changed, this,
            [this](const model::SceneChange& change) {
                if (isOneOf<model::SceneReplaced>(change)) {
                    RecallSettings now = m_state.recall();
                    now.timing.stagger.point = {}; // it was of another scene
                    now.isForSelected = false;     // nobody is there
                    m_state.setRecall(now);
                }
            });
    connect(&m_state, &EditorState::recallChanged, this, [this] {
        m_timing->refresh();
        m_isForRun->setChecked(m_state.recall().isForRunAlone);
        m_isForSelected->setChecked(m_state.recall().isForSelected);
    });
}

void RecallForm::addTiming()
{
    const FormTarget target{[this] { return &m_state.recall().timing; },
                            [this](const std::function<void(void*)>& change) {
                                RecallSettings now = m_state.recall();
                                change(&now.timing);
                                keep(now);
                            },
                            [this] { return model::FieldContext{&m_state.scene()}; }};
    m_timing = new FieldForm(target, QStringLiteral("recall"), &m_state, this);
    m_timing->setObjectName(QStringLiteral("recallTiming"));
    m_timing->layout()->setContentsMargins(0, 0, 0, 0);
    m_timing->addFields(model::fieldsOf<model::RecallTiming>());
    m_timing->finish();
    m_timing->refresh();
    layout()->addWidget(m_timing);
}

void RecallForm::addReach()
{
    m_isForSelected = addTick("recallSelected", &RecallSettings::isForSelected);
    m_isForSelected->setText(tr("Only who is selected"));
    m_isForSelected->setToolTip(tr("Others of the state stay as they are, also when keys recall."));
    m_isForRun = addTick("recallInRun", &RecallSettings::isForRunAlone);
    m_isForRun->setText(tr("Only in this run"));
    m_isForRun->setToolTip(tr("While it plays the scene stays as it is, and Stop gives it back. "
                              "The keys always do so."));
}

QCheckBox* RecallForm::addTick(const char* name, bool RecallSettings::*member)
{
    auto* tick = new QCheckBox(this);
    tick->setObjectName(QLatin1String(name));
    tick->setChecked(m_state.recall().*member);
    connect(tick, &QCheckBox::toggled, this, [this, member](bool isOn) {
        RecallSettings now = m_state.recall();
        now.*member = isOn;
        keep(now);
    });
    layout()->addWidget(tick);
    return tick;
}

void RecallForm::keep(const RecallSettings& recall)
{
    QSettings settings;
    settings.setValue(kSecondsSetting, static_cast<double>(recall.timing.seconds));
    settings.setValue(kStaggerSetting, static_cast<double>(recall.timing.stagger.seconds));
    settings.setValue(kOrderSetting, static_cast<int>(recall.timing.stagger.order));
    settings.setValue(kForRunSetting, recall.isForRunAlone);
    m_state.setRecall(recall);
}

} // namespace crowd::widgets
