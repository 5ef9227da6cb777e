// SPDX-License-Identifier: MIT
#include "widgets/docks/IndividualWriter.h"

#include "model/brush/IndividualEdits.h"
#include "model/document/SceneEdit.h"
#include "model/population/PropertyValues.h"
#include "widgets/forms/NumberList.h"

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

bool IndividualWriter::mayWrite() const
{
    return !m_state.selection().isEmpty();
}

void IndividualWriter::writeSame(model::ColumnId column, std::span<const std::byte> value,
                                 const QString& undoText)
{
    if (!mayWrite()) {
        return;
    }
    const auto ids = people().ids();
    m_state.document().edit(undoText,
                            [&](model::SceneEdit& edit) { edit.setColumn(column, ids, value); });
}

void IndividualWriter::changeGroups(const QString& undoText, const GroupChange& change)
{
    if (!mayWrite()) {
        return;
    }
    const SelectedPeople selected = people();
    m_state.document().edit(undoText, [&](model::SceneEdit& edit) {
        for (const SelectedPeople::Group& group : selected.groups()) {
            change(edit, selected, group);
        }
    });
}

void IndividualWriter::setTemplate(model::TemplateId id)
{
    if (mayWrite()) {
        const auto ids = people().ids();
        m_state.document().edit(tr("Change template"), [&](model::SceneEdit& edit) {
            model::changeTemplate(edit, ids, id);
        });
    }
}

void IndividualWriter::setPosition(int axis, double value)
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
    m_state.document().edit(tr("Move"), [&](model::SceneEdit& edit) {
        edit.setColumn(model::columns::position, ids, std::span<const glm::vec3>(positions));
    });
}

void IndividualWriter::setNumber(const model::PropertyInfo& property, double shown)
{
    writeSame(property.id,
              model::scalarBytes(property.column.type, shown / property.meta.shownScale),
              QCoreApplication::translate("Fields", property.traits.change));
}

void IndividualWriter::setTags(const QString& text)
{
    const std::uint64_t tags = tagListOf(m_state.scene().tags, text);
    writeSame(model::ColumnId::Tags, std::as_bytes(std::span(&tags, 1)), tr("Change tags"));
}

void IndividualWriter::setClip(const QString& name)
{
    changeGroups(tr("Change clip"), [&](model::SceneEdit& edit, const SelectedPeople& selected,
                                        const SelectedPeople::Group& group) {
        // Who lacks the clip keeps his own.
        if (const int index = group.clipIndex(name.toStdString()); index >= 0) {
            const auto clip = static_cast<std::uint16_t>(index);
            edit.setColumn(model::columns::clip, selected.ids(group),
                           std::span<const std::uint16_t>(&clip, 1));
        }
    });
}

void IndividualWriter::setSeat(double number)
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
    model::SitResult result = model::SitResult::Done;
    m_state.document().edit(
        tr("Sit down"), [&](model::SceneEdit& edit) { result = model::sitDown(edit, id, seat); });
    switch (result) {
    case model::SitResult::Done:
        break;
    case model::SitResult::NoSuchSeat:
        m_state.showStatus(tr("There is no seat %1.").arg(number, 0, 'f', 0));
        break;
    case model::SitResult::SeatIsTaken:
        m_state.showStatus(tr("Somebody else sits on seat %1.").arg(number, 0, 'f', 0));
        break;
    }
}

void IndividualWriter::standUp()
{
    if (mayWrite()) {
        const auto ids = people().ids();
        m_state.document().edit(tr("Stand up"),
                                [&](model::SceneEdit& edit) { model::standUp(edit, ids); });
    }
}

void IndividualWriter::setTint(const std::string& slot, const model::Tint& tint)
{
    changeGroups(tr("Change tint"), [&](model::SceneEdit& edit, const SelectedPeople& selected,
                                        const SelectedPeople::Group& group) {
        if (const int index = group.slotIndex(slot); index >= 0) {
            edit.setColumn(model::columns::tint(index), selected.ids(group),
                           std::span<const model::Tint>(&tint, 1));
        }
    });
}

void IndividualWriter::setTintMode(const std::string& slot, bool isReplacing)
{
    changeGroups(tr("Change the mode of a tint"), [&](model::SceneEdit& edit,
                                                      const SelectedPeople& selected,
                                                      const SelectedPeople::Group& group) {
        const int index = group.slotIndex(slot);
        if (index < 0) {
            return;
        }
        const auto bit = static_cast<std::uint16_t>(1U << static_cast<unsigned>(index));
        rewrite(edit, selected, group, model::columns::tintReplaces, [&](std::uint16_t old) {
            return static_cast<std::uint16_t>(isReplacing ? old | bit : old & ~bit);
        });
    });
}

void IndividualWriter::setChoice(const std::string& slot, const QString& choice)
{
    changeGroups(tr("Change outfit"), [&](model::SceneEdit& edit, const SelectedPeople& selected,
                                          const SelectedPeople::Group& group) {
        const int index = group.slotIndex(slot);
        const int wanted = index >= 0 ? group.choiceIndex(index, choice.toStdString()) : -1;
        if (wanted < 0) {
            return;
        }
        rewrite(edit, selected, group, model::columns::materialChoices,
                [&](model::MaterialChoices choices) {
                    choices[static_cast<std::size_t>(index)] = static_cast<std::uint8_t>(wanted);
                    return choices;
                });
    });
}

void IndividualWriter::setPart(const std::string& part, bool isShown)
{
    changeGroups(isShown ? tr("Show part") : tr("Hide part"),
                 [&](model::SceneEdit& edit, const SelectedPeople& selected,
                     const SelectedPeople::Group& group) {
                     const int index = group.partIndex(part);
                     if (index < 0) {
                         return;
                     }
                     const std::uint32_t bit = 1U << static_cast<unsigned>(index);
                     rewrite(edit, selected, group, model::columns::parts,
                             [&](std::uint32_t old) { return isShown ? old | bit : old & ~bit; });
                 });
}

} // namespace crowd::widgets
