// SPDX-License-Identifier: MIT
#include "widgets/rules/CueForm.h"

#include <algorithm>
#include <utility>

#include <QtWidgets/QCompleter>
#include <QtWidgets/QHBoxLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <QtWidgets/QVBoxLayout>

#include "model/rules/RuleSets.h"
#include "widgets/forms/PointPicking.h"
#include "widgets/forms/WrapRow.h"
#include "widgets/rules/RuleFields.h"
#include "widgets/rules/RuleNames.h"
#include "widgets/state/BrushTexts.h"
#include "widgets/state/Cues.h"

namespace crowd::widgets {

using model::Cue;

namespace {

QWidget* lastIn(QHBoxLayout* row)
{
    return row->itemAt(row->count() - 1)->widget();
}

} // namespace

CueForm::CueForm(EditorState& state, const Cue& cue, std::function<void(const Change&)> apply,
                 QWidget* parent)
    : QWidget(parent), m_state(state), m_scene(state.scene()), m_cue(cue), m_apply(std::move(apply))
{
    setObjectName(QStringLiteral("cueForm"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 2, 0, 6);
    layout->setSpacing(3);
    QHBoxLayout* row = labelledRow(layout, tr("Cue"));
    addTextField(row, QString::fromStdString(cue.name), tr("named as its event"),
                 [this](const QString& text) {
                     m_apply([&](Cue& each) { each.name = text.toStdString(); });
                 });
    lastIn(row)->setObjectName(QStringLiteral("cueName"));
    auto* done = new QToolButton(this);
    done->setObjectName(QStringLiteral("cueDone"));
    done->setText(tr("Done"));
    row->addWidget(done);
    connect(done, &QToolButton::clicked, this, &CueForm::closed);
    addEvent(layout);
    addState(layout);
    addReach(layout);
    addKeys(labelledRow(layout, tr("key")));
}

QHBoxLayout* CueForm::labelledRow(QVBoxLayout* layout, const QString& label)
{
    auto* row = new WrapRow;
    row->setSpacing(4);
    auto* text = new QLabel(label, this);
    text->setMinimumWidth(fontMetrics().horizontalAdvance(tr("sends")) + 4);
    row->addWidget(text);
    layout->addLayout(row);
    return row;
}

void CueForm::addEvent(QVBoxLayout* layout)
{
    QHBoxLayout* row = labelledRow(layout, tr("sends"));
    addTextField(row, QString::fromStdString(m_cue.event), tr("event"),
                 [this](const QString& text) {
                     if (!text.isEmpty() || m_cue.state != 0) { // else it would say nothing
                         m_apply([&](Cue& each) { each.event = text.toStdString(); });
                     }
                 });
    QStringList events;
    for (const std::string& event : model::eventsOf(m_scene)) {
        events << QString::fromStdString(event);
    }
    auto* line = qobject_cast<QLineEdit*>(lastIn(row));
    line->setObjectName(QStringLiteral("cueEvent"));
    line->setCompleter(new QCompleter(events, line));
    row->addWidget(new QLabel(tr("with number"), this));
    addNumberField(row, static_cast<double>(m_cue.payload), -1e6, 1e6, {}, [this](double payload) {
        m_apply([&](Cue& each) { each.payload = static_cast<float>(payload); });
    });
    lastIn(row)->setObjectName(QStringLiteral("cuePayload"));
    lastIn(row)->setToolTip(tr("The event’s number, a walking speed for example"));
}

/// What they take on, and how.
void CueForm::addState(QVBoxLayout* layout)
{
    QHBoxLayout* row = labelledRow(layout, tr("recalls"));
    addReferenceField(row, m_scene, model::FieldRole::State, m_cue.state, tr("no state"),
                      [this](std::uint32_t id) { m_apply([&](Cue& each) { each.state = id; }); });
    lastIn(row)->setObjectName(QStringLiteral("cueState"));
    if (m_cue.state == 0) {
        return;
    }
    const auto addSeconds = [&](const QString& label, const char* name, float Cue::*member) {
        row->addWidget(new QLabel(label, this));
        addNumberField(row, static_cast<double>(m_cue.*member), 0.0, model::kLongestRecall,
                       tr(" s"), [this, member](double seconds) {
                           m_apply([&](Cue& each) { each.*member = static_cast<float>(seconds); });
                       });
        lastIn(row)->setObjectName(QLatin1String(name));
    };
    addSeconds(tr("over"), "cueSeconds", &Cue::seconds);
    addSeconds(tr("the last after"), "cueSpread", &Cue::spread);
    if (m_cue.spread > 0.0F) {
        addOrder(layout);
    }
}

void CueForm::addOrder(QVBoxLayout* layout)
{
    QHBoxLayout* row = labelledRow(layout, {});
    QStringList names;
    for (const model::FieldChoice& order : model::Stagger::kOrders) {
        names << fieldText(order.label);
    }
    addChoiceField(row, names, static_cast<int>(m_cue.order), [this](int order) {
        m_apply([&](Cue& each) { each.order = static_cast<model::StaggerOrder>(order); });
    });
    lastIn(row)->setObjectName(QStringLiteral("cueOrder"));
    if (m_cue.order != model::StaggerOrder::Distance) {
        return;
    }
    auto* choose = new QToolButton(this);
    choose->setObjectName(QStringLiteral("cuePoint"));
    choose->setText(tr("Choose"));
    choose->setToolTip(tr("Then click in the picture where it begins"));
    makePointButton(*choose, m_state, [this](const glm::vec3& point) {
        m_apply([&](Cue& each) { each.point = point; });
    });
    new PointMark(*choose, m_state, [this] { return m_cue.point; });
    row->addWidget(choose);
}

void CueForm::addReach(QVBoxLayout* layout)
{
    QHBoxLayout* row = labelledRow(layout, tr("to"));
    addChoiceField(row, cueReachNames(), static_cast<int>(m_cue.reach), [this](int reach) {
        m_apply([&](Cue& each) { each.reach = static_cast<model::CueReach>(reach); });
    });
    lastIn(row)->setObjectName(QStringLiteral("cueReach"));
    if (m_cue.reach == model::CueReach::Tagged) {
        addTagField(row, m_scene, m_cue.tag,
                    [this](std::uint8_t tag) { m_apply([&](Cue& each) { each.tag = tag; }); });
    }
}

/// Those that no other cue has.
void CueForm::addKeys(QHBoxLayout* row)
{
    std::vector<std::string> keys{{}};
    QStringList names{tr("none")};
    for (const std::string_view each : model::kCueKeys) {
        const std::string key(each);
        const bool isTaken = std::ranges::any_of(m_scene.cues, [&](const Cue& other) {
            return other.id != m_cue.id && other.key == key;
        });
        if (!isTaken) {
            keys.push_back(key);
            names << QString::fromStdString(key);
        }
    }
    const auto found = std::ranges::find(keys, m_cue.key);
    const auto index = found == keys.end() ? 0 : found - keys.begin();
    addChoiceField(row, names, static_cast<int>(index), [this, keys](int choice) {
        m_apply([&](Cue& each) { each.key = keys[static_cast<std::size_t>(choice)]; });
    });
    lastIn(row)->setObjectName(QStringLiteral("cueKey"));
}

} // namespace crowd::widgets
