// SPDX-License-Identifier: MIT
#include <QtCore/QCoreApplication>
#include <QtWidgets/QColorDialog>
#include <QtWidgets/QComboBox>

#include "model/brush/IndividualEdits.h"
#include "model/document/SceneEdit.h"
#include "model/population/PropertyValues.h"
#include "widgets/docks/IndividualDock.h"
#include "widgets/docks/NumberList.h"

/// What the individual panel writes: each function is one undo step.
namespace crowd::widgets {

namespace {

constexpr unsigned kStageShift = 24U; ///< of a seat id: stage above, number below

/// Each one's value becomes another, made from the one that is there.
template<class T, class Change>
void rewrite(model::SceneEdit& edit, const SelectedPeople& selected,
             const SelectedPeople::Group& group, model::ColumnKey<T> key, const Change& change)
{
    const auto column = edit.scene().population.column(key);
    std::vector<T> values;
    values.reserve(group.rows.size());
    for (const std::size_t row : group.rows) {
        values.push_back(change(column[row]));
    }
    edit.setColumn(key, selected.ids(group), std::span<const T>(values));
}

} // namespace

bool IndividualDock::mayWrite() const
{
    return !m_isFilling && !m_state.document().isEditOpen() && !m_state.selection().isEmpty();
}

void IndividualDock::writeSame(model::ColumnId column, std::span<const std::byte> value,
                               const QString& undoText)
{
    if (!mayWrite()) {
        return;
    }
    const auto ids = people().ids();
    const auto edit = m_state.document().beginEdit();
    edit->setColumn(column, ids, value);
    edit->commit(undoText);
}

void IndividualDock::setTemplate(int index)
{
    const auto id = static_cast<model::TemplateId>(m_template->itemData(index).toUInt());
    if (mayWrite()) {
        const auto ids = people().ids();
        const auto edit = m_state.document().beginEdit();
        model::changeTemplate(*edit, ids, id);
        edit->commit(tr("Change template"));
    }
}

void IndividualDock::setPosition(int axis, double value)
{
    if (!mayWrite()) {
        return;
    }
    const SelectedPeople selected = people();
    std::vector<glm::vec3> positions;
    for (const std::size_t row : selected.rows()) {
        positions.push_back(m_state.scene().population.column(model::columns::position)[row]);
        positions.back()[axis] = static_cast<float>(value);
    }
    const auto ids = selected.ids();
    const auto edit = m_state.document().beginEdit();
    edit->setColumn(model::columns::position, ids, std::span<const glm::vec3>(positions));
    edit->commit(tr("Move"));
}

void IndividualDock::setNumber(const model::PropertyInfo& property, double shown)
{
    writeSame(property.id,
              model::scalarBytes(property.column.type, shown / property.meta.shownScale),
              QCoreApplication::translate("Fields", property.traits.change));
}

void IndividualDock::setTags(const QString& text)
{
    const std::uint64_t tags = tagListOf(m_state.scene().tags, text);
    writeSame(model::ColumnId::Tags, std::as_bytes(std::span(&tags, 1)), tr("Change tags"));
}

void IndividualDock::setClip(const QString& name)
{
    if (!mayWrite()) {
        return;
    }
    const SelectedPeople selected = people();
    const auto edit = m_state.document().beginEdit();
    for (const SelectedPeople::Group& group : selected.groups()) {
        // Who lacks the clip keeps his own.
        if (const int index = group.clipIndex(name.toStdString()); index >= 0) {
            const auto clip = static_cast<std::uint16_t>(index);
            edit->setColumn(model::columns::clip, selected.ids(group),
                            std::span<const std::uint16_t>(&clip, 1));
        }
    }
    edit->commit(tr("Change clip"));
}

void IndividualDock::setSeat(double number)
{
    if (!mayWrite() || m_state.selection().size() != 1) {
        return;
    }
    const model::IndividualId id = m_state.selection().ids().front();
    const model::Population& all = m_state.scene().population;
    model::SeatId base = all.column(model::columns::seat)[all.rowOf(id)];
    for (const model::StageEntry& stage : m_state.scene().stages) {
        if (base == model::kNoSeat && stage.asset && !stage.asset->seats.empty()) {
            base = static_cast<model::SeatId>(stage.id) << kStageShift;
        }
    }
    const model::SeatId seat = (base >> kStageShift << kStageShift) |
                               (static_cast<model::SeatId>(number - 1.0) & 0xFFFFFFU);
    const auto edit = m_state.document().beginEdit();
    switch (model::sitDown(*edit, id, seat)) {
    case model::SitResult::Done:
        edit->commit(tr("Sit down"));
        break;
    case model::SitResult::NoSuchSeat:
        m_state.showStatus(tr("There is no seat %1.").arg(number, 0, 'f', 0));
        break;
    case model::SitResult::SeatIsTaken:
        m_state.showStatus(tr("Somebody else sits on seat %1.").arg(number, 0, 'f', 0));
        break;
    }
    m_refresh.start(); // what was refused goes out of the field
}

void IndividualDock::standUp()
{
    if (mayWrite()) {
        const auto ids = people().ids();
        const auto edit = m_state.document().beginEdit();
        model::standUp(*edit, ids);
        edit->commit(tr("Stand up"));
    }
}

void IndividualDock::chooseTint(const std::string& slot)
{
    QColor before(Qt::white);
    const SelectedPeople selected = people();
    const model::Population& all = m_state.scene().population;
    const auto tint = selected.commonOf<model::Tint>(
        [&](const SelectedPeople::Group& group) { return group.slotIndex(slot); },
        [&](std::size_t row, int index) { return all.column(model::columns::tint(index))[row]; });
    if (tint && tint->strength > 0) {
        before = QColor(tint->red, tint->green, tint->blue);
    }
    const QColor color =
        QColorDialog::getColor(before, this, tr("Tint of %1").arg(QString::fromStdString(slot)),
                               QColorDialog::DontUseNativeDialog);
    if (color.isValid()) {
        setTint(slot,
                {static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
                 static_cast<std::uint8_t>(color.blue()), 255});
    }
}

void IndividualDock::setTint(const std::string& slot, const model::Tint& tint)
{
    if (!mayWrite()) {
        return;
    }
    const SelectedPeople selected = people();
    const auto edit = m_state.document().beginEdit();
    for (const SelectedPeople::Group& group : selected.groups()) {
        if (const int index = group.slotIndex(slot); index >= 0) {
            edit->setColumn(model::columns::tint(index), selected.ids(group),
                            std::span<const model::Tint>(&tint, 1));
        }
    }
    edit->commit(tr("Change tint"));
}

void IndividualDock::setTintMode(const std::string& slot, bool isReplacing)
{
    if (!mayWrite()) {
        return;
    }
    const SelectedPeople selected = people();
    const auto edit = m_state.document().beginEdit();
    for (const SelectedPeople::Group& group : selected.groups()) {
        const int index = group.slotIndex(slot);
        if (index < 0) {
            continue;
        }
        const auto bit = static_cast<std::uint16_t>(1U << static_cast<unsigned>(index));
        rewrite(*edit, selected, group, model::columns::tintReplaces, [&](std::uint16_t old) {
            return static_cast<std::uint16_t>(isReplacing ? old | bit : old & ~bit);
        });
    }
    edit->commit(tr("Change the mode of a tint"));
}

void IndividualDock::setChoice(const std::string& slot, const QString& choice)
{
    if (!mayWrite()) {
        return;
    }
    const SelectedPeople selected = people();
    const auto edit = m_state.document().beginEdit();
    for (const SelectedPeople::Group& group : selected.groups()) {
        const int index = group.slotIndex(slot);
        const int wanted = index >= 0 ? group.choiceIndex(index, choice.toStdString()) : -1;
        if (wanted < 0) {
            continue;
        }
        rewrite(*edit, selected, group, model::columns::materialChoices,
                [&](model::MaterialChoices choices) {
                    choices[static_cast<std::size_t>(index)] = static_cast<std::uint8_t>(wanted);
                    return choices;
                });
    }
    edit->commit(tr("Change outfit"));
}

void IndividualDock::setPart(const std::string& part, bool isShown)
{
    if (!mayWrite()) {
        return;
    }
    const SelectedPeople selected = people();
    const auto edit = m_state.document().beginEdit();
    for (const SelectedPeople::Group& group : selected.groups()) {
        const int index = group.partIndex(part);
        if (index < 0) {
            continue;
        }
        const std::uint32_t bit = 1U << static_cast<unsigned>(index);
        rewrite(*edit, selected, group, model::columns::parts,
                [&](std::uint32_t old) { return isShown ? old | bit : old & ~bit; });
    }
    edit->commit(isShown ? tr("Show part") : tr("Hide part"));
}

} // namespace crowd::widgets
