// SPDX-License-Identifier: MIT
#include "widgets/forms/ClipMix.h"

#include <algorithm>

#include <QtCore/QEvent>
#include <QtCore/QRect>
#include <QtWidgets/QCheckBox>
#include <QtWidgets/QGridLayout>
#include <QtWidgets/QLabel>

#include "widgets/forms/ValueSlider.h"

namespace crowd::widgets {

namespace {

constexpr int kNameWidth = 110; ///< logical pixels; foreign files name clips at length

} // namespace

ClipMix::ClipMix(const std::vector<std::string>& names, QWidget* parent, const Texts& texts)
    : ClipMix(std::vector<Section>{{QString(), names}}, parent, texts)
{
}

ClipMix::ClipMix(const std::vector<Section>& sections, QWidget* parent, const Texts& texts)
    : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(1);
    grid->setColumnStretch(1, 1);
    for (const Section& section : sections) {
        if (sections.size() > 1) {
            auto* title = new QLabel(section.title, this);
            title->setEnabled(false);
            grid->addWidget(title, grid->rowCount(), 0, 1, 2);
        }
        for (const std::string& name : section.names) {
            addRow(*grid, name, texts ? texts(name) : QString::fromStdString(name));
        }
    }
}

void ClipMix::addRow(QGridLayout& grid, const std::string& name, const QString& text)
{
    auto* tick = new QCheckBox(fontMetrics().elidedText(text, Qt::ElideMiddle, kNameWidth), this);
    tick->setAccessibleName(text);
    tick->setToolTip(text);
    tick->installEventFilter(this);
    auto* weight = new ValueSlider({}, {1.0, 100.0, 5.0, 0, QStringLiteral(" %"), false}, this);
    weight->setToolTip(tr("How often it comes among those ticked"));
    QSizePolicy policy = weight->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    weight->setSizePolicy(policy);
    weight->setFixedHeight(fontMetrics().height() + 5);
    const int row = grid.rowCount();
    grid.addWidget(tick, row, 0);
    grid.addWidget(weight, row, 1);
    connect(tick, &QCheckBox::clicked, this, [this, name](bool on) {
        Q_EMIT edited({name, on ? 1.0F : 0.0F});
    });
    connect(weight, &ValueSlider::valueEdited, this, [this, name](double percent) {
        Q_EMIT edited({name, static_cast<float>(percent / 100.0)});
    });
    m_rows.push_back({name, tick, weight});
}

bool ClipMix::eventFilter(QObject* tick, QEvent* event)
{
    if (event->type() == QEvent::Enter) {
        const auto row = std::ranges::find_if(
            m_rows, [tick](const Row& candidate) { return candidate.tick == tick; });
        if (row != m_rows.end()) {
            Q_EMIT pointedAt(row->name, {row->tick->mapToGlobal(QPoint()), row->tick->size()});
        }
    } else if (event->type() == QEvent::Leave) {
        Q_EMIT left();
    }
    return QWidget::eventFilter(tick, event);
}

void ClipMix::setClips(const std::vector<model::ClipWeight>& clips, bool areWeighed)
{
    for (const Row& row : m_rows) {
        const auto found = std::ranges::find(clips, row.name, &model::ClipWeight::clip);
        const bool isIn = found != clips.end();
        row.tick->setChecked(isIn);
        row.weight->setVisible(isIn && areWeighed && clips.size() > 1);
        row.weight->setValue(isIn ? static_cast<double>(found->weight) * 100.0 : 100.0);
    }
}

} // namespace crowd::widgets
