// SPDX-License-Identifier: MIT
#include "widgets/dialogs/ClipTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QtCore/QCoreApplication>
#include <QtCore/QLocale>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QDoubleSpinBox>
#include <QtWidgets/QHeaderView>

#include "widgets/forms/NumberBox.h"

namespace crowd::widgets {

namespace {

constexpr double kFastestClip = 100.0; ///< metres a second
constexpr double kSameSpeed = 0.001;

QString labelOf(const model::ClipRoleInfo& role)
{
    return QCoreApplication::translate("ClipRole", role.label);
}

} // namespace

ClipTable::ClipTable(const model::Template& asset, QWidget* parent)
    : QTableWidget(static_cast<int>(asset.clips.size()), 4, parent), m_fromFile(asset.clips.size()),
      m_proposed(asset.clips.size(), model::ClipRole::Other)
{
    setHorizontalHeaderLabels({tr("Clip"), tr("Length"), tr("Ground speed"), tr("Role")});
    horizontalHeaderItem(3)->setToolTip(tr(
        "What characters stand, walk and sit with. Clips of other roles play only where a brush or "
        "a rule asks for them."));
    verticalHeader()->hide();
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setColumnWidth(1, fontMetrics().horizontalAdvance(QStringLiteral("0000.00 s")) + 12);
    setColumnWidth(2, std::max(fontMetrics().horizontalAdvance(QStringLiteral("000.00 m/s")) + 44,
                               horizontalHeader()->sectionSizeHint(2)));
    int widest = 0;
    for (const model::ClipRoleInfo& role : model::clipRoles()) {
        widest = std::max(widest, fontMetrics().horizontalAdvance(labelOf(role)));
    }
    setColumnWidth(3, widest + 56);
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
    auto* speed = new NumberBox(this);
    speed->setRange(0.0, kFastestClip);
    speed->setSingleStep(0.05);
    speed->setSuffix(tr(" m/s"));
    speed->setFrame(false);
    speed->setToolTip(tr("How far the character gets in a second of this clip"));
    setItem(row, 0, nameItem);
    setItem(row, 1, length);
    setCellWidget(row, 2, speed);
    auto* role = new QComboBox(this);
    role->setFrame(false);
    role->setFocusPolicy(Qt::StrongFocus);
    role->setAccessibleName(tr("Role of %1").arg(name));
    for (const model::ClipRoleInfo& info : model::clipRoles()) {
        role->addItem(labelOf(info), static_cast<int>(info.role));
        role->setItemData(role->count() - 1, QCoreApplication::translate("ClipRole", info.tip),
                          Qt::ToolTipRole);
    }
    setCellWidget(row, 3, role);
}

QComboBox* ClipTable::roleBox(int row) const
{
    return static_cast<QComboBox*>(cellWidget(row, 3));
}

void ClipTable::setRole(int row, model::ClipRole role)
{
    roleBox(row)->setCurrentIndex(roleBox(row)->findData(static_cast<int>(role)));
}

model::ClipRole ClipTable::roleIn(int row) const
{
    return static_cast<model::ClipRole>(roleBox(row)->currentData().toInt());
}

void ClipTable::setEdited(const std::vector<float>& speeds,
                          const std::vector<std::optional<model::ClipRole>>& roles)
{
    for (int row = 0; row < rowCount(); ++row) {
        const auto clip = static_cast<std::size_t>(row);
        if (clip < speeds.size() && !std::isnan(speeds[clip])) {
            speedBox(row)->setValue(static_cast<double>(speeds[clip]));
        }
        if (clip < roles.size() && roles[clip]) {
            setRole(row, *roles[clip]);
        }
    }
}

QDoubleSpinBox* ClipTable::speedBox(int row) const
{
    return static_cast<QDoubleSpinBox*>(cellWidget(row, 2));
}

void ClipTable::follow(const model::Template& asset)
{
    for (int row = 0; row < rowCount(); ++row) {
        const model::ClipRole proposed = asset.clips[static_cast<std::size_t>(row)].role;
        model::ClipRole& before = m_proposed[static_cast<std::size_t>(row)];
        if (m_isNew || roleIn(row) == before) { // not chosen by hand
            setRole(row, proposed);
        }
        before = proposed;
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
    m_isNew = false;
}

std::vector<std::optional<model::ClipRole>> ClipTable::editedRoles() const
{
    std::vector<std::optional<model::ClipRole>> roles;
    bool isAnyEdited = false;
    for (int row = 0; row < rowCount(); ++row) {
        const model::ClipRole role = roleIn(row);
        const bool isEdited = role != m_proposed[static_cast<std::size_t>(row)];
        isAnyEdited = isAnyEdited || isEdited;
        roles.push_back(isEdited ? std::optional(role) : std::nullopt);
    }
    return isAnyEdited ? roles : std::vector<std::optional<model::ClipRole>>{};
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
