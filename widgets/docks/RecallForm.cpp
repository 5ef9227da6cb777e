// SPDX-License-Identifier: MIT
#include "widgets/docks/RecallForm.h"

#include <iterator>

#include <QtCore/QSettings>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QLabel>
#include <QtWidgets/QVBoxLayout>

#include "widgets/docks/FieldForm.h"
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

RecallForm::RecallForm(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_isForRun(new QCheckBox(tr("Only in this run"), this))
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
                    m_state.setRecall(now);
                }
            });
    connect(&m_state, &EditorState::recallChanged, this, [this] {
        m_timing->refresh();
        m_isForRun->setChecked(m_state.recall().isForRunAlone);
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
    m_isForRun->setObjectName(QStringLiteral("recallInRun"));
    m_isForRun->setToolTip(tr("While it plays the scene stays as it is, and Stop gives it back. "
                              "The keys always do so."));
    m_isForRun->setChecked(m_state.recall().isForRunAlone);
    connect(m_isForRun, &QCheckBox::toggled, this, [this](bool isOn) {
        RecallSettings now = m_state.recall();
        now.isForRunAlone = isOn;
        keep(now);
    });
    layout()->addWidget(m_isForRun);
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
