// SPDX-License-Identifier: MIT
#include "widgets/dialogs/CueDialog.h"

#include <algorithm>

#include <QtWidgets/QComboBox>
#include <QtWidgets/QDialogButtonBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QFormLayout>
#include <QtWidgets/QLabel>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QPushButton>

#include "model/scene/RuleSets.h"
#include "widgets/docks/RuleTexts.h"
#include "widgets/state/Cues.h"

namespace crowd::widgets {

CueDialog::CueDialog(const model::Scene& scene, const model::Cue& cue, QWidget* parent)
    : QDialog(parent), m_cue(cue), m_form(new QFormLayout(this)), m_name(new QLineEdit(this)),
      m_event(new QComboBox(this)), m_payload(new QDoubleSpinBox(this)), m_key(new QComboBox(this)),
      m_reach(new QComboBox(this)), m_tag(new QComboBox(this))
{
    setWindowTitle(tr("Cue"));
    m_name->setText(QString::fromStdString(cue.name));
    m_name->setPlaceholderText(tr("as the event"));
    m_form->addRow(tr("Name"), m_name);
    m_event->setEditable(true);
    m_event->setObjectName(QStringLiteral("cueEvent"));
    for (const std::string& event : model::eventsOf(scene)) {
        m_event->addItem(QString::fromStdString(event));
    }
    m_event->setCurrentText(QString::fromStdString(cue.event));
    m_form->addRow(tr("Sends the event"), m_event);
    m_payload->setRange(-1e6, 1e6);
    m_payload->setValue(static_cast<double>(cue.payload));
    m_form->addRow(tr("With the number"), m_payload);
    m_reach->addItems(cueReachNames());
    m_reach->setCurrentIndex(static_cast<int>(cue.reach));
    m_form->addRow(tr("To"), m_reach);
    for (int bit = 0; bit < model::kTagCount; ++bit) {
        m_tag->addItem(tagText(scene, static_cast<std::uint8_t>(bit)));
    }
    m_tag->setCurrentIndex(cue.tag);
    m_form->addRow(tr("Tag"), m_tag);
    fillKeys(scene);
    m_form->addRow(tr("Key"), m_key);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_reach, &QComboBox::currentIndexChanged, this, &CueDialog::showReach);
    const auto check = [this, buttons] {
        buttons->button(QDialogButtonBox::Ok)->setEnabled(!m_event->currentText().isEmpty());
    };
    connect(m_event, &QComboBox::editTextChanged, this, check);
    check();
    showReach();
}

/// Those that no other cue has.
void CueDialog::fillKeys(const model::Scene& scene)
{
    m_key->addItem(tr("none"), QString());
    for (const std::string key : kCueKeys) {
        const bool isTaken = std::ranges::any_of(scene.cues, [&](const model::Cue& other) {
            return other.id != m_cue.id && other.key == key;
        });
        if (!isTaken) {
            m_key->addItem(QString::fromStdString(key), QString::fromStdString(key));
        }
    }
    m_key->setCurrentIndex(std::max(0, m_key->findData(QString::fromStdString(m_cue.key))));
}

void CueDialog::showReach()
{
    const bool isTagged = m_reach->currentIndex() == static_cast<int>(model::CueReach::Tagged);
    m_tag->setVisible(isTagged);
    m_form->labelForField(m_tag)->setVisible(isTagged);
}

model::Cue CueDialog::cue() const
{
    model::Cue edited = m_cue;
    edited.name = m_name->text().toStdString();
    edited.event = m_event->currentText().toStdString();
    edited.payload = static_cast<float>(m_payload->value());
    edited.key = m_key->currentData().toString().toStdString();
    edited.reach = static_cast<model::CueReach>(m_reach->currentIndex());
    edited.tag = static_cast<std::uint8_t>(m_tag->currentIndex());
    return edited;
}

} // namespace crowd::widgets
