// SPDX-License-Identifier: MIT
#include "widgets/dialogs/ClipTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtCore/QLocale>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QHeaderView>

namespace crowd::widgets {

namespace {

constexpr double kFastestClip = 100.0; ///< metres a second
constexpr double kSameSpeed = 0.001;

} // namespace

ClipTable::ClipTable(const model::Template& asset, QWidget* parent)
    : QTableWidget(static_cast<int>(asset.clips.size()), 3, parent), m_fromFile(asset.clips.size())
{
    setHorizontalHeaderLabels({tr("Clip"), tr("Length"), tr("Ground speed")});
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setColumnWidth(1, fontMetrics().horizontalAdvance(QStringLiteral("0000.00 s")) + 12);
    setColumnWidth(2, fontMetrics().horizontalAdvance(QStringLiteral("000.00 m/s")) + 44);
    for (int row = 0; row < rowCount(); ++row) {
        addRow(row, asset.clips[static_cast<std::size_t>(row)], row == asset.defaultClip);
    }
    selectRow(asset.defaultClip);
    follow(asset);
}

void ClipTable::addRow(int row, const model::Clip& clip, bool isDefault)
{
    const QString name = QString::fromStdString(clip.name);
    auto* nameItem = new QTableWidgetItem(isDefault ? tr("%1 (when standing)").arg(name) : name);
    auto* length = new QTableWidgetItem(
        tr("%1 s").arg(QLocale().toString(static_cast<double>(clip.seconds), 'f', 2)));
    length->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QTableWidgetItem* item : {nameItem, length}) {
        item->setFlags(item->flags() & ~Qt::ItemIsEditable);
    }
    auto* speed = new QDoubleSpinBox(this);
    speed->setRange(0.0, kFastestClip);
    speed->setSingleStep(0.05);
    speed->setSuffix(tr(" m/s"));
    speed->setFrame(false);
    speed->setToolTip(tr("How far the character gets in a second of this clip"));
    setItem(row, 0, nameItem);
    setItem(row, 1, length);
    setCellWidget(row, 2, speed);
}

QDoubleSpinBox* ClipTable::speedBox(int row) const
{
    return static_cast<QDoubleSpinBox*>(cellWidget(row, 2));
}

void ClipTable::follow(const model::Template& asset)
{
    for (int row = 0; row < rowCount(); ++row) {
        QDoubleSpinBox* box = speedBox(row);
        double& fromFile = m_fromFile[static_cast<std::size_t>(row)];
        const auto speed = static_cast<double>(asset.clips[static_cast<std::size_t>(row)].speed);
        if (std::abs(box->value() - fromFile) > kSameSpeed) {
            fromFile = speed; // edited by hand
            continue;
        }
        box->setValue(speed);
        fromFile = box->value();
    }
}

std::vector<float> ClipTable::editedSpeeds() const
{
    std::vector<float> speeds;
    bool isAnyEdited = false;
    for (int row = 0; row < rowCount(); ++row) {
        const double value = speedBox(row)->value();
        const bool isEdited =
            std::abs(value - m_fromFile[static_cast<std::size_t>(row)]) > kSameSpeed;
        isAnyEdited = isAnyEdited || isEdited;
        speeds.push_back(isEdited ? static_cast<float>(value)
                                  : std::numeric_limits<float>::quiet_NaN());
    }
    return isAnyEdited ? speeds : std::vector<float>{};
}

} // namespace crowd::widgets
