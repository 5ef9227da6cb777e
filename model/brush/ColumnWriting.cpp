// SPDX-License-Identifier: MIT
#include "model/brush/ColumnWriting.h"

#include "model/base/Random.h"

namespace crowd::model {

std::span<const glm::vec3> OperatorShares::positions() const
{
    if (!m_positions.empty()) {
        return m_positions;
    }
    const Population& people = m_request.edit.scene().population;
    const Population& shown = m_request.shown != nullptr ? *m_request.shown : people;
    m_positions.reserve(m_request.ids.size());
    for (const IndividualId id : m_request.ids) {
        const std::size_t row = shown.rowOf(id);
        m_positions.push_back(row != Population::npos
                                  ? shown.column(columns::position)[row]
                                  : people.column(columns::position)[people.rowOf(id)]);
    }
    return m_positions;
}

OperatorResult OperatorShares::of(BrushOperator op, std::string_view purpose,
                                  std::uint64_t extra) const
{
    return of(op, hashText(purpose), extra);
}

OperatorResult OperatorShares::of(BrushOperator op, std::uint64_t purpose,
                                  std::uint64_t extra) const
{
    return evaluate(op,
                    {m_request.view, m_request.line, m_request.seed,
                     m_request.settings.distribution, purpose, extra, m_request.ids,
                     operatorInfo(op).followsLine ? positions() : std::span<const glm::vec3>()});
}

} // namespace crowd::model
