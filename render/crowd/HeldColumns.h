// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "model/population/Population.h"
#include "render/crowd/StaticRecords.h"

/// What the GPU holds of each property as it is: the columns that the records of individuals are
/// filled from, byte for byte. What is computed from columns (where somebody stands and which way
/// he faces, the radius of his shadow) and what a plan of a picture decides by (template, clip,
/// phase, speed, seat) is code of its own; all other properties are not drawn.
namespace crowd::render {

/// A column and where its values stand in a record.
struct HeldColumn
{
    model::ColumnId column;
    std::size_t offset;
    std::size_t bytes;
};

template<class T>
constexpr HeldColumn held(model::ColumnKey<T> key, std::size_t offset)
{
    return {key.id, offset, sizeof(T)};
}
constexpr HeldColumn heldTint(int slot)
{
    return held(model::columns::tint(slot),
                offsetof(AppearanceRecord, tints) +
                    static_cast<std::size_t>(slot) * sizeof(model::Tint));
}

inline constexpr std::array kHeldInPlacement{
    held(model::columns::height, offsetof(PlacementRecord, height)),
    held(model::columns::girth, offsetof(PlacementRecord, girth)),
};
inline constexpr std::array kHeldInAppearance{
    heldTint(0),
    heldTint(1),
    heldTint(2),
    heldTint(3),
    heldTint(4),
    heldTint(5),
    heldTint(6),
    heldTint(7),
    held(model::columns::materialChoices, offsetof(AppearanceRecord, choices)),
    held(model::columns::parts, offsetof(AppearanceRecord, parts)),
};

/// The columns of such a table in one population, which outlives this.
template<const auto& kTable>
class HeldValues
{
public:
    explicit HeldValues(const model::Population& people)
    {
        for (std::size_t i = 0; i < kTable.size(); ++i) {
            m_columns[i] = people.columnBytes(kTable[i].column).data();
        }
    }
    template<class Record>
    void copyTo(Record& record, std::size_t row) const
    {
        // Sizes and places are known where this is compiled: no call for each value.
        [&]<std::size_t... I>(std::index_sequence<I...>)
        {
            auto* bytes = reinterpret_cast<std::byte*>(&record);
            (std::memcpy(bytes + kTable[I].offset, m_columns[I] + row * kTable[I].bytes,
                         kTable[I].bytes),
             ...);
        }
        (std::make_index_sequence<kTable.size()>());
    }

private:
    std::array<const std::byte*, kTable.size()> m_columns{};
};

} // namespace crowd::render
