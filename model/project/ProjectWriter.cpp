// SPDX-License-Identifier: MIT
#include "model/project/ProjectWriter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

#include "model/project/LinkParser.h"
#include "model/project/ProjectHeader.h"
#include "model/project/StatesJson.h"

namespace crowd::model {

namespace {

constexpr char kHex[] = "0123456789abcdef";

void appendHex(std::string& text, std::span<const std::byte> bytes)
{
    for (const std::byte byte : bytes) {
        text += kHex[std::to_integer<unsigned>(byte) >> 4U];
        text += kHex[std::to_integer<unsigned>(byte) & 15U];
    }
}

template<class Number>
void appendNumber(std::string& text, Number value)
{
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
    text.append(buffer, end);
}

void appendFloat(std::string& text, float value)
{
    if (value == 0.0F && std::signbit(value)) {
        text += "-0.0"; // JSON readers take "-0" for the integer and lose its sign
        return;
    }
    appendNumber(text, value);
}

template<class Value>
Value valueAt(const std::byte* bytes)
{
    Value value;
    std::memcpy(&value, bytes, sizeof(value));
    return value;
}

void appendValue(std::string& text, ColumnId column, const std::byte* bytes)
{
    const ColumnInfo& info = columnInfo(column);
    switch (info.type) {
    case ColumnType::Float:
        appendFloat(text, valueAt<float>(bytes));
        break;
    case ColumnType::Vec3: {
        const auto v = valueAt<glm::vec3>(bytes);
        text += '[';
        appendFloat(text, v.x);
        text += ',';
        appendFloat(text, v.y);
        text += ',';
        appendFloat(text, v.z);
        text += ']';
        break;
    }
    case ColumnType::UInt16:
        appendNumber(text, valueAt<std::uint16_t>(bytes));
        break;
    case ColumnType::UInt32:
        appendNumber(text, valueAt<std::uint32_t>(bytes));
        break;
    case ColumnType::UInt64:
        appendNumber(text, valueAt<std::uint64_t>(bytes));
        break;
    case ColumnType::Tint:
    case ColumnType::Bytes8:
        text += info.type == ColumnType::Tint ? "\"#" : "\"";
        appendHex(text, {bytes, info.stride});
        text += '"';
        break;
    }
}

/// Ids apart, template and position always, others only when somebody differs from the default.
std::vector<ColumnId> columnsToWrite(const Population& population)
{
    const IndividualRows defaults = IndividualRows::withDefaults({1});
    std::vector<ColumnId> written;
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        const auto column = static_cast<ColumnId>(c);
        const std::size_t stride = columnInfo(column).stride;
        const std::span<const std::byte> bytes = population.columnBytes(column);
        bool isDefault = column != ColumnId::Template && column != ColumnId::Position;
        for (std::size_t i = 0; i < bytes.size() && isDefault; i += stride) {
            isDefault = std::memcmp(&bytes[i], defaults.bytes[c].data(), stride) == 0;
        }
        if (!isDefault) {
            written.push_back(column);
        }
    }
    return written;
}

Result<void> checkFinite(const Population& population)
{
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        const ColumnInfo& info = columnInfo(static_cast<ColumnId>(c));
        if (info.type != ColumnType::Float && info.type != ColumnType::Vec3) {
            continue;
        }
        const std::byte* bytes = population.columnBytes(static_cast<ColumnId>(c)).data();
        const std::size_t perRow = info.stride / sizeof(float);
        for (std::size_t i = 0; i < population.size() * perRow; ++i) {
            if (!std::isfinite(valueAt<float>(bytes + i * sizeof(float)))) {
                return Error{QT_TRANSLATE_NOOP("Messages",
                                               "Individual %1 has a %2 that is not a number; "
                                               "undo the last change or give it a new value."),
                             population.ids()[i / perRow], info.name};
            }
        }
    }
    return {};
}

Result<void> checkTemplates(const Scene& scene)
{
    const auto used = scene.population.column(columns::templateId);
    TemplateId known = 0; // 0 is nobody's
    for (std::size_t row = 0; row < used.size(); ++row) {
        if (used[row] != known && scene.findTemplate(used[row]) == nullptr) {
            return Error{QT_TRANSLATE_NOOP(
                             "Messages",
                             "Individual %1 uses the template %2, which the scene does not have; "
                             "undo the last change, or give the individual another template."),
                         scene.population.ids()[row], used[row]};
        }
        known = used[row];
    }
    return {};
}

/// What the reader would refuse must not be written: nobody could open it again.
Result<void> checkHeader(const nlohmann::json& header)
{
    if (const Result<Scene> read = headerFromJson(header); !read) {
        return Error{QT_TRANSLATE_NOOP("Messages", "There is a value that cannot be saved: %1. "
                                                   "Undo the last change or give it a new value."),
                     read.error().said};
    }
    return {};
}

/// As dump(), but bytes that are not UTF-8 are replaced rather than refused.
std::string dumped(const nlohmann::json& value)
{
    return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Members in a fixed order that a reader of the file would choose, one a line.
void appendHeader(std::string& text, nlohmann::json header)
{
    const auto append = [&](const std::string& key) {
        text += dumped(key) + ": ";
        const nlohmann::json& value = header[key];
        if (!value.is_array() || value.empty()) {
            text += dumped(value);
        } else {
            text += '[';
            for (std::size_t i = 0; i < value.size(); ++i) {
                text += (i == 0 ? "\n" : ",\n") + dumped(value[i]);
            }
            text += "\n]";
        }
        text += ",\n";
        header.erase(key);
    };
    for (const char* key : {"format", "version", "name", "seed", "nextId", "templates", "stages",
                            "cameras", "lighting"}) {
        append(key);
    }
    while (!header.empty()) {
        append(std::string(header.begin().key()));
    }
}

void appendUnknownTableMembers(std::string& text, const std::string& members)
{
    if (members.empty()) {
        return;
    }
    const nlohmann::json table = nlohmann::json::parse(members);
    for (const auto& [key, value] : table.items()) {
        text += dumped(key) + ": " + dumped(value) + ",\n";
    }
}

/// Bytes of a column: of each row, or one value for all.
struct WrittenColumn
{
    ColumnId column{};
    const std::byte* bytes = nullptr;
    std::size_t step = 0; ///< from row to row
};

/// Rows of a table, one a line.
class RowWriter
{
public:
    RowWriter(std::span<const IndividualId> ids, std::vector<WrittenColumn> columns,
              const std::vector<UnknownColumn>& unknown, bool areIdsWritten)
        : m_ids(ids), m_columns(std::move(columns)), m_unknown(unknown),
          m_unknownNext(unknown.size()), m_areIdsWritten(areIdsWritten)
    {
    }

    void appendColumnNames(std::string& text) const
    {
        text += m_areIdsWritten ? "[\"id\"," : "[";
        for (const WrittenColumn& column : m_columns) {
            text += '"' + std::string(columnInfo(column.column).name) + "\",";
        }
        for (const UnknownColumn& column : m_unknown) {
            text += nlohmann::json(column.name).dump() + ',';
        }
        endList(text);
    }

    void appendRows(std::string& text)
    {
        text += '[';
        for (std::size_t row = 0; row < m_ids.size(); ++row) {
            text += row == 0 ? "\n" : ",\n";
            appendRow(text, row);
        }
        text += "\n]";
    }

private:
    void appendRow(std::string& text, std::size_t row)
    {
        text += '[';
        if (m_areIdsWritten) {
            appendNumber(text, m_ids[row]);
            text += ',';
        }
        for (const WrittenColumn& column : m_columns) {
            appendValue(text, column.column, column.bytes + row * column.step);
            text += ',';
        }
        for (std::size_t i = 0; i < m_unknown.size(); ++i) {
            text += unknownValue(i, m_ids[row]) + ',';
        }
        endList(text);
    }

    /// In place of the last comma.
    static void endList(std::string& text)
    {
        if (text.back() == ',') {
            text.pop_back();
        }
        text += ']';
    }

    std::string unknownValue(std::size_t column, IndividualId id)
    {
        const auto& values = m_unknown[column].values;
        std::size_t& next = m_unknownNext[column];
        while (next < values.size() && values[next].first < id) {
            ++next;
        }
        return next < values.size() && values[next].first == id ? values[next].second : "null";
    }

    std::span<const IndividualId> m_ids;
    std::vector<WrittenColumn> m_columns;
    const std::vector<UnknownColumn>& m_unknown;
    std::vector<std::size_t> m_unknownNext;
    bool m_areIdsWritten;
};

RowWriter peopleOf(const Scene& scene)
{
    std::vector<WrittenColumn> columns;
    for (const ColumnId column : columnsToWrite(scene.population)) {
        columns.push_back(
            {column, scene.population.columnBytes(column).data(), columnInfo(column).stride});
    }
    return {scene.population.ids(), std::move(columns), scene.unknownColumns, true};
}

RowWriter peopleOf(const State& state)
{
    std::vector<WrittenColumn> columns;
    for (const StoredRows::Column& column : state.people->columns) {
        const std::size_t stride = columnInfo(column.column).stride;
        const bool isOne = column.bytes.size() == stride;
        columns.push_back({column.column, column.bytes.data(), isOne ? 0 : stride});
    }
    return {state.people->ids, std::move(columns), state.unknownColumns, false};
}

/// Each on a line, with its people below it.
void appendStates(std::string& text, const nlohmann::json& headers, const Scene& scene)
{
    text += "\"states\": [\n";
    for (std::size_t i = 0; i < scene.states.size(); ++i) {
        const State& state = scene.states[i];
        std::string object = dumped(headers[i]);
        object.pop_back();
        text += object + ",\"ids\":\"" + idsText(state.people->ids) + "\",\"columns\":";
        RowWriter rows = peopleOf(state);
        rows.appendColumnNames(text);
        text += ",\"rows\":";
        rows.appendRows(text);
        text += i + 1 < scene.states.size() ? "},\n" : "}\n";
    }
    text += "],\n";
}

/// Its head, with the rows below it.
void appendRelations(std::string& text, const nlohmann::json& head, const RelationTable& relations)
{
    std::string object = dumped(head);
    object.pop_back();
    text += "\"relations\": " + object + ",\"rows\": [";
    const char* separator = "\n";
    for (const Relation& each : relations.all()) {
        text += separator;
        separator = ",\n";
        text += '[';
        for (const std::uint32_t number :
             {each.from, each.to, static_cast<std::uint32_t>(each.kind)}) {
            appendNumber(text, number);
            text += ',';
        }
        appendFloat(text, each.strength);
        text += ']';
    }
    text += "\n]},\n";
}

} // namespace

Result<std::string> projectToText(const Scene& scene)
{
    if (const Result<void> finite = checkFinite(scene.population); !finite) {
        return finite.error();
    }
    if (const Result<void> templates = checkTemplates(scene); !templates) {
        return templates.error();
    }
    nlohmann::json header = headerToJson(scene);
    if (const Result<void> sound = checkHeader(header); !sound) {
        return sound.error();
    }
    std::string text = "{\n";
    const nlohmann::json states = header.value(members::States::key, nlohmann::json());
    const nlohmann::json relations = header.value(members::Relations::key, nlohmann::json());
    header.erase(members::States::key);
    header.erase(members::Relations::key);
    appendHeader(text, std::move(header));
    if (!scene.relations.isEmpty()) {
        appendRelations(text, relations, scene.relations);
    }
    if (!scene.states.empty()) {
        appendStates(text, states, scene);
    }
    RowWriter rows = peopleOf(scene);
    text += "\"individuals\": {\n";
    appendUnknownTableMembers(text, scene.unknownTableMembers);
    text += "\"columns\": ";
    rows.appendColumnNames(text);
    text += ",\n\"rows\": ";
    text.reserve(text.size() + scene.population.size() * 160);
    rows.appendRows(text);
    text += "}\n}\n";
    return text;
}

} // namespace crowd::model
