// SPDX-License-Identifier: MIT
#include "model/project/RowParser.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "model/base/ShownText.h"
#include "model/describe/FieldChecks.h"
#include "model/population/PropertyValues.h"
#include "model/project/ProjectHeader.h"

namespace crowd::model {

namespace {

constexpr const char* kWholeNumber =
    QT_TRANSLATE_NOOP("Messages", "a whole number that is not negative and not too large");
constexpr const char* kThreeNumbers =
    QT_TRANSLATE_NOOP("Messages", "a list of three finite numbers");
constexpr const char* kFiniteNumber = QT_TRANSLATE_NOOP("Messages", "a finite number");

bool toFloat(const CellValue& value, float& target)
{
    if (value.kind == CellValue::Kind::Unsigned) {
        target = static_cast<float>(value.integer);
        return true;
    }
    if (value.kind != CellValue::Kind::Float) {
        return false;
    }
    const char* end = value.text.data() + value.text.size();
    const auto result = std::from_chars(value.text.data(), end, target);
    if (result.ec == std::errc::result_out_of_range) {
        double wide = 0.0; // too small is zero, too large is wrong
        const auto wider = std::from_chars(value.text.data(), end, wide);
        target = 0.0F;
        return wider.ec == std::errc() && std::abs(wide) < 1.0;
    }
    return result.ec == std::errc() && std::isfinite(target);
}

int hexDigit(char c)
{
    if (c >= '0' && c <= '9') {
        return c - '0';
    }
    if (c >= 'a' && c <= 'f') {
        return c - 'a' + 10;
    }
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

bool fromHex(std::string_view text, std::byte* target, std::size_t count)
{
    if (text.size() != count * 2) {
        return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const int high = hexDigit(text[2 * i]);
        const int low = hexDigit(text[2 * i + 1]);
        if (high < 0 || low < 0) {
            return false;
        }
        target[i] = static_cast<std::byte>(high * 16 + low);
    }
    return true;
}

template<class Unsigned>
bool fits(const CellValue& value, Unsigned& target)
{
    if (value.kind != CellValue::Kind::Unsigned ||
        value.integer > std::numeric_limits<Unsigned>::max()) {
        return false;
    }
    target = static_cast<Unsigned>(value.integer);
    return true;
}

/// Writes the value into bytes of the column's stride; null, or what was expected.
const char* convert(const ColumnInfo& info, const CellValue& value, std::byte* bytes)
{
    const auto store = [bytes](const auto& item) { std::memcpy(bytes, &item, sizeof(item)); };
    switch (info.type) {
    case ColumnType::Float:
        if (float item = 0.0F; toFloat(value, item)) {
            store(item);
            return nullptr;
        }
        return kFiniteNumber;
    case ColumnType::UInt16:
        if (std::uint16_t item = 0; fits(value, item)) {
            store(item);
            return nullptr;
        }
        return kWholeNumber;
    case ColumnType::UInt32:
        if (std::uint32_t item = 0; fits(value, item)) {
            store(item);
            return nullptr;
        }
        return kWholeNumber;
    case ColumnType::UInt64:
        if (std::uint64_t item = 0; fits(value, item)) {
            store(item);
            return nullptr;
        }
        return kWholeNumber;
    case ColumnType::Tint:
        return value.kind == CellValue::Kind::Text && value.text.starts_with('#') &&
                       fromHex(value.text.substr(1), bytes, sizeof(Tint))
                   ? nullptr
                   : QT_TRANSLATE_NOOP("Messages",
                                       "a tint like \"#c04020ff\" (red, green, blue, strength)");
    case ColumnType::Bytes8:
        return value.kind == CellValue::Kind::Text && fromHex(value.text, bytes, info.stride)
                   ? nullptr
                   : QT_TRANSLATE_NOOP("Messages", "sixteen hexadecimal digits");
    case ColumnType::Vec3:
        break;
    }
    return kThreeNumbers;
}

/// Two on one seat happens when two people's work is merged: the seat stays with the lower id, the
/// other keeps his place without it.
void freeSharedSeats(IndividualRows& rows, std::vector<Message>& warnings)
{
    constexpr std::size_t kMaxWarnings = 10;
    const std::span<SeatId> seats = rows.column(columns::seat);
    std::unordered_map<SeatId, IndividualId> taken;
    std::size_t shared = 0;
    for (std::size_t i = 0; i < seats.size(); ++i) {
        if (seats[i] == kNoSeat) {
            continue;
        }
        const auto [owner, isFree] = taken.try_emplace(seats[i], rows.ids[i]);
        if (isFree) {
            continue;
        }
        seats[i] = kNoSeat;
        if (++shared <= kMaxWarnings) {
            warnings.emplace_back(
                QT_TRANSLATE_NOOP("Messages", "Individual %1 had the same seat as individual %2 "
                                              "and has none now; move one of them."),
                rows.ids[i], owner->second);
        }
    }
    if (shared > kMaxWarnings) {
        warnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages", "%1 more shared a seat and have none now."),
            shared - kMaxWarnings);
    }
}

/// Values that nobody could give today are kept, so that a file from elsewhere stays what it is.
void noteOddNumbers(const IndividualRows& rows, std::vector<Message>& warnings)
{
    for (const PropertyInfo& property : properties()) {
        const std::size_t odd =
            countIllegal(property, rows.bytes[static_cast<std::size_t>(property.id)]);
        if (odd > 0) {
            warnings.emplace_back(
                odd == 1
                    ? QT_TRANSLATE_NOOP("Messages",
                                        "%1 individual has a %2 outside %3 to %4; it is kept.")
                    : QT_TRANSLATE_NOOP("Messages",
                                        "%1 individuals have a %2 outside %3 to %4; it is kept."),
                odd, property.meta.key, shortNumber(property.meta.low),
                shortNumber(property.meta.high));
        }
    }
}

/// Who follows a path that is not there stands still; the file is sound otherwise.
void leaveMissingPaths(IndividualRows& rows, Scene& scene)
{
    std::size_t lost = 0;
    for (PathId& path : rows.column(columns::path)) {
        if (path != 0 && scene.findPath(path) == nullptr) {
            path = 0;
            ++lost;
        }
    }
    if (lost > 0) {
        scene.readWarnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages", "%1 individuals followed a path that the file does not "
                                          "list; they follow none now."),
            lost);
    }
}

} // namespace

Result<void> RowParser::setColumns(const std::vector<std::string>& names)
{
    if (names.empty() || names.front() != "id") {
        return Error{QT_TRANSLATE_NOOP(
                         "Messages", "%1.columns must be a list of names that begins with \"id\""),
                     m_place};
    }
    m_cells.assign(1, Cell{});
    for (std::size_t i = 1; i < names.size(); ++i) {
        if (std::ranges::count(names, names[i]) > 1) {
            return Error{QT_TRANSLATE_NOOP("Messages", "%1.columns names \"%2\" twice"), m_place,
                         shortened(names[i])};
        }
        const PropertyInfo* property = findProperty(names[i]);
        Cell cell{property != nullptr ? static_cast<int>(property->id) : -1, -1};
        if (property == nullptr) {
            cell.unknown = static_cast<int>(m_unknown.size());
            m_unknown.push_back({names[i], {}});
        }
        m_cells.push_back(cell);
    }
    m_unknownTexts.resize(m_unknown.size());
    for (const ColumnId needed : m_needed) {
        const std::string name(columnInfo(needed).name);
        if (std::ranges::find(names, name) == names.end()) {
            return Error{QT_TRANSLATE_NOOP("Messages", "%1.columns lacks \"%2\""), m_place, name};
        }
    }
    return {};
}

bool RowParser::isVector(std::size_t cell) const
{
    return m_cells[cell].column >= 0 &&
           columnInfo(static_cast<ColumnId>(m_cells[cell].column)).type == ColumnType::Vec3;
}

std::string RowParser::nameOf(std::size_t cell) const
{
    if (m_cells[cell].unknown >= 0) {
        return m_unknown[static_cast<std::size_t>(m_cells[cell].unknown)].name;
    }
    return m_cells[cell].column < 0
               ? "id"
               : std::string(columnInfo(static_cast<ColumnId>(m_cells[cell].column)).name);
}

void RowParser::putBytes(const Cell& cell, const void* value, std::size_t size)
{
    auto& bytes = m_bytes[static_cast<std::size_t>(cell.column)];
    const auto* from = static_cast<const std::byte*>(value);
    bytes.insert(bytes.end(), from, from + size);
}

const char* RowParser::put(std::size_t cell, const CellValue& value)
{
    const Cell& target = m_cells[cell];
    if (target.column < 0) {
        IndividualId id = 0;
        if (!fits(value, id) || id == 0 || id > kMaxIndividualId) {
            return QT_TRANSLATE_NOOP("Messages",
                                     "a whole number above zero and at most 4000000000");
        }
        m_ids.push_back(id);
        return nullptr;
    }
    const ColumnInfo& info = columnInfo(static_cast<ColumnId>(target.column));
    std::array<std::byte, 16> bytes{};
    if (const char* expected = convert(info, value, bytes.data())) {
        return expected;
    }
    putBytes(target, bytes.data(), info.stride);
    return nullptr;
}

const char* RowParser::putComponent(std::size_t cell, std::size_t component, const CellValue& value)
{
    float number = 0.0F;
    if (component >= 3 || !toFloat(value, number)) {
        return kThreeNumbers;
    }
    putBytes(m_cells[cell], &number, sizeof(number));
    return nullptr;
}

void RowParser::putUnknown(std::size_t cell, std::string text)
{
    m_unknownTexts[static_cast<std::size_t>(m_cells[cell].unknown)].push_back(std::move(text));
}

Result<IndividualRows> RowParser::sortedRows(std::vector<std::size_t>& order)
{
    order.resize(m_rows);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [this](std::size_t a, std::size_t b) { return m_ids[a] < m_ids[b]; });
    std::vector<IndividualId> ids(m_rows);
    for (std::size_t i = 0; i < m_rows; ++i) {
        ids[i] = m_ids[order[i]];
        if (i > 0 && ids[i] == ids[i - 1]) {
            return Error{
                QT_TRANSLATE_NOOP("Messages",
                                  "two individuals have the id %1; give one of them another"),
                ids[i]};
        }
    }
    IndividualRows rows = IndividualRows::withDefaults(std::move(ids));
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        const std::size_t stride = columnInfo(static_cast<ColumnId>(c)).stride;
        for (std::size_t i = 0; i < m_rows && !m_bytes[c].empty(); ++i) {
            std::memcpy(&rows.bytes[c][i * stride], &m_bytes[c][order[i] * stride], stride);
        }
    }
    return rows;
}

std::vector<UnknownColumn> RowParser::unknownOf(std::span<const IndividualId> ids,
                                                std::span<const std::size_t> order)
{
    for (std::size_t u = 0; u < m_unknown.size(); ++u) {
        for (std::size_t i = 0; i < m_rows; ++i) {
            std::string& text = m_unknownTexts[u][order[i]];
            if (text != "null") {
                m_unknown[u].values.emplace_back(ids[i], std::move(text));
            }
        }
    }
    return std::move(m_unknown);
}

Result<RowParser::Table> RowParser::take()
{
    std::vector<std::size_t> order;
    Result<IndividualRows> rows = sortedRows(order);
    if (!rows) {
        return rows.error();
    }
    Table table{std::move(rows).value(), {}};
    table.unknownColumns = unknownOf(table.rows.ids, order);
    return table;
}

Result<void> RowParser::finish(Scene& scene)
{
    Result<Table> taken = take();
    if (!taken) {
        return taken.error();
    }
    IndividualRows& table = taken.value().rows;
    for (std::size_t i = 0; i < table.ids.size(); ++i) {
        const TemplateId templateId = table.column(columns::templateId)[i];
        if (scene.findTemplate(templateId) == nullptr) {
            return Error{
                QT_TRANSLATE_NOOP(
                    "Messages", "individual %1 uses the template %2, which the file does not list"),
                table.ids[i], templateId};
        }
    }
    freeSharedSeats(table, scene.readWarnings);
    leaveMissingPaths(table, scene);
    noteOddNumbers(table, scene.readWarnings);
    scene.unknownColumns = std::move(taken.value().unknownColumns);
    if (!table.ids.empty()) {
        scene.nextId = std::max(scene.nextId, table.ids.back() + 1);
    }
    scene.population.add(table);
    return {};
}

} // namespace crowd::model
