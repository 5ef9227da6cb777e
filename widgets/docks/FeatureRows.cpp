// SPDX-License-Identifier: MIT
#include "widgets/docks/FeatureRows.h"

#include <algorithm>

#include <QtWidgets/QComboBox>
#include <QtWidgets/QFormLayout>

#include "widgets/commands/FeatureCommands.h"
#include "widgets/state/FeatureTexts.h"

namespace crowd::widgets {

FeatureRows::FeatureRows(EditorState& state, QWidget* parent)
    : QWidget(parent), m_state(state), m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setVerticalSpacing(3);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void FeatureRows::rebuild()
{
    m_builtFor = m_state.scene().features;
    while (m_form->rowCount() > 0) {
        m_form->removeRow(0);
    }
    m_rows.clear();
    for (const model::FeatureKind& kind : m_builtFor) {
        auto* box = new QComboBox(this);
        box->setObjectName(QStringLiteral("feature%1").arg(kind.id));
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setPlaceholderText(tr("mixed"));
        box->addItem(tr("none"), 0U);
        for (const model::FeatureValue& value : kind.values) {
            box->addItem(featureText(value.name), uint{value.id});
        }
        connect(box, &QComboBox::activated, this, [this, box, id = kind.id] {
            const auto chosen = static_cast<model::FeatureId>(box->currentData().toUInt());
            chosen != 0 ? giveFeature(m_state, chosen) : takeFeatureOff(m_state, id);
        });
        m_form->addRow(featureText(kind.name), box);
        m_rows.push_back({kind.id, box});
    }
}

void FeatureRows::refresh(const SelectedPeople& selected)
{
    if (m_builtFor != m_state.scene().features) {
        rebuild();
    }
    for (const Row& row : m_rows) {
        const auto borne = m_state.scene().population.column(model::columns::feature(row.kind));
        const auto shared = selected.common<model::FeatureId>(
            [borne](std::size_t person) { return borne[person]; });
        row.box->setCurrentIndex(shared ? row.box->findData(uint{*shared}) : -1);
    }
}

} // namespace crowd::widgets
