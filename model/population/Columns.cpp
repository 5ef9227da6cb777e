// SPDX-License-Identifier: MIT
#include "model/population/Columns.h"

namespace crowd::model {

namespace {

constexpr std::array<ColumnInfo, kColumnCount> kColumns{{
    {"template", ColumnType::UInt16, sizeof(TemplateId)},
    {"position", ColumnType::Vec3, sizeof(glm::vec3)},
    {"heading", ColumnType::Float, sizeof(float)},
    {"height", ColumnType::Float, sizeof(float)},
    {"girth", ColumnType::Float, sizeof(float)},
    {"tint0", ColumnType::Tint, sizeof(Tint)},
    {"tint1", ColumnType::Tint, sizeof(Tint)},
    {"tint2", ColumnType::Tint, sizeof(Tint)},
    {"tint3", ColumnType::Tint, sizeof(Tint)},
    {"tint4", ColumnType::Tint, sizeof(Tint)},
    {"tint5", ColumnType::Tint, sizeof(Tint)},
    {"tint6", ColumnType::Tint, sizeof(Tint)},
    {"tint7", ColumnType::Tint, sizeof(Tint)},
    {"choices", ColumnType::Bytes8, sizeof(MaterialChoices)},
    {"parts", ColumnType::UInt32, sizeof(std::uint32_t)},
    {"clip", ColumnType::UInt16, sizeof(std::uint16_t)},
    {"phase", ColumnType::Float, sizeof(float)},
    {"speed", ColumnType::Float, sizeof(float)},
    {"seat", ColumnType::UInt32, sizeof(SeatId)},
    {"tags", ColumnType::UInt64, sizeof(std::uint64_t)},
    {"group", ColumnType::UInt32, sizeof(std::uint32_t)},
    {"seed", ColumnType::UInt32, sizeof(std::uint32_t)},
    {"path", ColumnType::UInt32, sizeof(std::uint32_t)},
    {"walkSpeed", ColumnType::Float, sizeof(float)},
    {"walkStyle", ColumnType::UInt16, sizeof(std::uint16_t)},
    {"tintReplaces", ColumnType::UInt16, sizeof(std::uint16_t)},
}};

} // namespace

const ColumnInfo& columnInfo(ColumnId column)
{
    return kColumns[static_cast<std::size_t>(column)];
}

} // namespace crowd::model
