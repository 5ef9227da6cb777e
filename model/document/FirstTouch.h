// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/document/SceneDelta.h"

namespace crowd::model {

/// Values of one column before an edit, kept at first touch.
class FirstTouch
{
public:
    /// `values` in the order of `ids` (ascending); ids already known are left alone.
    void remember(std::span<const IndividualId> ids, std::span<const std::byte> values,
                  std::size_t stride);
    /// Takes the values of those of `ids` that are known out of here and into `rows`.
    void moveInto(std::span<const IndividualId> ids, std::span<std::byte> rows, std::size_t stride);
    /// What differs between the remembered values and today's.
    [[nodiscard]] ColumnDelta changes(ColumnId column, const Population& population) const;

private:
    std::vector<IndividualId> m_ids; ///< ascending
    std::vector<std::byte> m_bytes;
};

} // namespace crowd::model
