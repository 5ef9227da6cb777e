// SPDX-License-Identifier: MIT
#include "model/project/ProjectReader.h"

#include <algorithm>
#include <memory>
#include <new>

#include <nlohmann/json.hpp>

#include "model/base/ShownText.h"
#include "model/project/LinkParser.h"
#include "model/project/ProjectHeader.h"
#include "model/project/RowParser.h"
#include "model/project/StateTables.h"
#include "model/project/TreeBuilder.h"
#include "model/scene/SceneMembers.h"

namespace crowd::model {

namespace {

using nlohmann::json;

constexpr std::size_t kMaxDepth = 64;
/// Of values outside of the rows; what a file of ours has is a few thousand.
constexpr std::size_t kMaxHeaderValues = 2'000'000;
constexpr std::size_t kMaxIndividuals = 4'000'000;
constexpr std::size_t kMaxRelations = 8'000'000;

constexpr std::size_t kMostReason = 200; ///< the parser quotes what it read
constexpr const char* kRowNoList = QT_TRANSLATE_NOOP("Messages", "row %1 of %2 must be a list");
constexpr const char* kThreeFinite =
    QT_TRANSLATE_NOOP("Messages", "a list of three finite numbers");

Error damaged(const Message& what)
{
    return Error{QT_TRANSLATE_NOOP("Messages",
                                   "The file is damaged or was edited wrongly: %1. Correct this "
                                   "place in a text editor, or restore an older copy."),
                 what};
}

/// "line 3, column 7" of a byte in the text.
Message placeIn(std::string_view text, std::size_t byte)
{
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const auto lines = std::ranges::count(before, '\n');
    const auto lineStart = before.rfind('\n');
    const std::size_t column =
        lineStart == std::string_view::npos ? before.size() : before.size() - lineStart - 1;
    return {QT_TRANSLATE_NOOP("Messages", "line %1, column %2"), lines + 1, column};
}

/// Events of the whole file. The header is built as a tree; the rows of the individuals' table go
/// straight into columns.
class ProjectHandler : public nlohmann::json_sax<json>
{
public:
    explicit ProjectHandler(std::string_view text) : m_text(text) {}

    bool null() override
    {
        return value({CellValue::Kind::Null, 0, {}}, [] { return json(nullptr); });
    }
    bool boolean(bool item) override
    {
        return value({CellValue::Kind::Other, 0, {}}, [&] { return json(item); });
    }
    bool number_integer(number_integer_t item) override
    {
        const std::string digits = std::to_string(item);
        return value({CellValue::Kind::Float, 0, digits}, [&] { return json(item); });
    }
    bool number_unsigned(number_unsigned_t item) override
    {
        return value({CellValue::Kind::Unsigned, item, {}}, [&] { return json(item); });
    }
    bool number_float(number_float_t item, const string_t& digits) override
    {
        return value({CellValue::Kind::Float, 0, digits}, [&] { return json(item); });
    }
    bool string(string_t& text) override
    {
        return value({CellValue::Kind::Text, 0, text}, [&] { return json(text); });
    }
    bool binary(binary_t&) override
    {
        return fail(QT_TRANSLATE_NOOP("Messages", "binary data is not allowed"));
    }

    bool start_object(std::size_t) override { return open(json::object()); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(json::array()); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override
    {
        if (m_where == Where::Cell) {
            return m_tree.key(name) || failTwice(name);
        }
        if (m_depth == 1) {
            m_isInIndividuals = name == "individuals";
            m_isInStates = name == members::States::key;
            m_isInRelations = name == members::Relations::key;
        }
        if (m_depth == tableDepth()) {
            m_tableKey = name;
        }
        return m_header.key(name) || failTwice(name);
    }

    bool parse_error(std::size_t byte, const std::string&, const json::exception& error) override
    {
        const std::string text = error.what();
        const Message place = placeIn(m_text, byte);
        if (text.find("unexpected end of input") != std::string::npos) {
            return fail({QT_TRANSLATE_NOOP("Messages", "it ends too early, at %1"), place});
        }
        if (text.find("number overflow") != std::string::npos) {
            return fail({QT_TRANSLATE_NOOP("Messages", "there is a number that is too large at %1"),
                         place});
        }
        const auto reason = text.find(": ");
        return reason == std::string::npos
                   ? fail({QT_TRANSLATE_NOOP("Messages", "it is not valid JSON at %1"), place})
                   : fail({QT_TRANSLATE_NOOP("Messages", "it is not valid JSON at %1: %2"), place,
                           shortened(text.substr(reason + 2), kMostReason)});
    }

    [[nodiscard]] Result<Scene> finish();
    [[nodiscard]] Error problem() const;

private:
    enum class Where : std::uint8_t { Header, Rows, Row, Vector, Cell, Links, Link };

    bool fail(Message what)
    {
        if (m_problem.empty()) {
            m_problem = std::move(what);
        }
        return false;
    }
    bool failTwice(const std::string& name)
    {
        return fail({QT_TRANSLATE_NOOP("Messages", "\"%1\" stands twice in the same object"),
                     shortened(name)});
    }
    /// `expected`: a message of what belongs there.
    bool failCell(const char* expected)
    {
        return fail({QT_TRANSLATE_NOOP("Messages", "row %1 of %2, column \"%3\": it must be %4"),
                     m_rows->rowCount() + 1, m_rows->place(), shortened(m_rows->nameOf(m_cell)),
                     Message(expected)});
    }
    bool failRow() { return fail({kRowNoList, m_rows->rowCount() + 1, m_rows->place()}); }

    template<class MakeJson>
    bool value(const CellValue& cell, const MakeJson& make)
    {
        switch (m_where) {
        case Where::Header:
            if (m_depth == 0) {
                return fail(QT_TRANSLATE_NOOP("Messages", "the file must hold a JSON object"));
            }
            m_header.value(make());
            return hasRoom();
        case Where::Rows:
            return failRow();
        case Where::Row:
            return rowValue(cell, make);
        case Where::Vector:
            if (const char* expected = m_rows->putComponent(m_cell, m_component++, cell)) {
                return failCell(expected);
            }
            return true;
        case Where::Cell:
            m_tree.value(make());
            return true;
        case Where::Links:
            return failLinks();
        case Where::Link:
            return linkValue(cell);
        }
        return false;
    }

    template<class MakeJson>
    bool rowValue(const CellValue& cell, const MakeJson& make)
    {
        if (m_cell >= m_rows->columnCount()) {
            return failLength();
        }
        if (!m_rows->isKnown(m_cell)) {
            m_rows->putUnknown(m_cell++, make().dump());
            return true;
        }
        if (const char* expected = m_rows->put(m_cell, cell)) {
            return failCell(expected);
        }
        ++m_cell;
        return true;
    }

    bool failLength()
    {
        return fail(
            {QT_TRANSLATE_NOOP("Messages", "row %1 of %2 must have %3 values, one for each column"),
             m_rows->rowCount() + 1, m_rows->place(), m_rows->columnCount() - firstCell()});
    }

    bool open(json container)
    {
        if (++m_depth > kMaxDepth) {
            return fail(
                {QT_TRANSLATE_NOOP("Messages", "it is nested more than %1 deep"), kMaxDepth});
        }
        const bool isArray = container.is_array();
        switch (m_where) {
        case Where::Header:
            if (m_depth == tableDepth() + 1 && m_tableKey == "rows" && isArray) {
                return m_isInStates      ? beginStateRows()
                       : m_isInRelations ? beginLinks()
                                         : beginRows();
            }
            m_header.open(std::move(container));
            return hasRoom();
        case Where::Rows:
            m_where = Where::Row;
            m_cell = firstCell();
            return (isArray || failRow()) && putKnownId();
        case Where::Row:
            return openInRow(std::move(container));
        case Where::Vector:
            return failCell(kThreeFinite);
        case Where::Cell:
            m_tree.open(std::move(container));
            return true;
        case Where::Links:
            m_where = Where::Link;
            return isArray || failLinks();
        case Where::Link:
            return failLink(m_links.put({}));
        }
        return false;
    }

    bool openInRow(json container)
    {
        if (m_cell >= m_rows->columnCount()) {
            return failLength();
        }
        if (!m_rows->isKnown(m_cell)) {
            m_where = Where::Cell;
            m_tree.open(std::move(container));
            return true;
        }
        if (!m_rows->isVector(m_cell) || !container.is_array()) {
            return failCell(QT_TRANSLATE_NOOP("Messages", "a single value of the right kind"));
        }
        m_where = Where::Vector;
        m_component = 0;
        return true;
    }

    bool close()
    {
        --m_depth;
        switch (m_where) {
        case Where::Header:
            m_header.close();
            return true;
        case Where::Rows:
            m_where = Where::Header;
            return haveAllRows();
        case Where::Row:
            if (m_cell != m_rows->columnCount()) {
                return failLength();
            }
            m_rows->endRow();
            m_where = Where::Rows;
            return m_rows->rowCount() <= kMaxIndividuals ||
                   fail({QT_TRANSLATE_NOOP("Messages", "it holds more than %1 individuals"),
                         kMaxIndividuals});
        case Where::Vector:
            if (m_component != 3) {
                return failCell(kThreeFinite);
            }
            ++m_cell;
            m_where = Where::Row;
            return true;
        case Where::Cell:
            m_tree.close();
            if (m_tree.isComplete()) {
                m_rows->putUnknown(m_cell++, m_tree.take().dump());
                m_where = Where::Row;
            }
            return true;
        case Where::Links:
            m_where = Where::Header;
            return true;
        case Where::Link:
            m_where = Where::Links;
            return endLink();
        }
        return false;
    }

    bool hasRoom()
    {
        return m_header.valueCount() <= kMaxHeaderValues ||
               fail({QT_TRANSLATE_NOOP("Messages",
                                       "it holds more than %1 values beside the individuals"),
                     kMaxHeaderValues});
    }

    /// A newer version may have another kind of table: say so rather than what is odd in it.
    bool isOurs()
    {
        if (m_header.root().contains("version")) {
            if (const Result<void> format = checkFormat(m_header.root()); !format) {
                m_isForeign = true;
                return fail(format.error().said);
            }
        }
        return true;
    }

    bool beginRows()
    {
        if (m_seenRows) {
            return fail(QT_TRANSLATE_NOOP("Messages", "individuals.rows stands there twice"));
        }
        m_seenRows = true;
        m_rows = &m_people;
        m_where = Where::Rows;
        if (!isOurs()) {
            return false;
        }
        const json* table = m_header.peek("individuals");
        const json names =
            table == nullptr || !table->is_object() ? json() : table->value("columns", json());
        if (!areColumnNames(names)) {
            return fail(QT_TRANSLATE_NOOP(
                "Messages",
                "individuals.columns must be a list of names and stand before the rows"));
        }
        const Result<void> columns = m_rows->setColumns(names.get<std::vector<std::string>>());
        return columns ? true : fail(columns.error().said);
    }

    bool beginStateRows()
    {
        Result<StateTable*> table = m_states.begin(m_header);
        if (!table) {
            return fail(table.error().said);
        }
        m_state = table.value();
        m_rows = &m_state->rows;
        m_where = Where::Rows;
        if (!isOurs()) {
            return false;
        }
        const Result<void> known = m_state->readHead(m_header.current(), kMaxIndividuals);
        return known ? true : fail(known.error().said);
    }
    bool beginLinks()
    {
        m_where = Where::Links;
        if (!isOurs()) {
            return false;
        }
        const json* table = m_header.peek(LinkParser::kPlace);
        const Result<void> begun = m_links.begin(
            table != nullptr && table->is_object() ? table->value("columns", json()) : json());
        return begun ? true : fail(begun.error().said);
    }
    bool linkValue(const CellValue& cell)
    {
        if (m_links.cell() >= kLinkColumns.size()) {
            return failLinkLength();
        }
        const char* expected = m_links.put(cell);
        return expected == nullptr || failLink(expected);
    }
    bool endLink()
    {
        if (!m_links.endRow()) {
            return failLinkLength();
        }
        return m_links.rowCount() <= kMaxRelations ||
               fail({QT_TRANSLATE_NOOP("Messages", "it holds more than %1 relations"),
                     kMaxRelations});
    }
    bool failLinks() { return fail({kRowNoList, m_links.rowCount() + 1, LinkParser::kPlace}); }
    bool failLink(const char* expected)
    {
        const std::size_t cell = std::clamp<std::size_t>(m_links.cell(), 1, kLinkColumns.size());
        return fail({QT_TRANSLATE_NOOP("Messages", "row %1 of %2, column \"%3\": it must be %4"),
                     m_links.rowCount() + 1, LinkParser::kPlace, kLinkColumns[cell - 1],
                     Message(expected)});
    }
    bool failLinkLength()
    {
        return fail(
            {QT_TRANSLATE_NOOP("Messages", "row %1 of %2 must have %3 values, one for each column"),
             m_links.rowCount() + 1, LinkParser::kPlace, kLinkColumns.size()});
    }
    /// Of the objects that have tables.
    [[nodiscard]] std::size_t tableDepth() const
    {
        return m_isInIndividuals || m_isInRelations ? 2 : m_isInStates ? 3 : kMaxDepth;
    }
    [[nodiscard]] bool isOfState() const { return m_rows != &m_people; }
    /// That stands in the rows.
    [[nodiscard]] std::size_t firstCell() const { return isOfState() ? 1 : 0; }
    bool putKnownId()
    {
        if (!isOfState()) {
            return true;
        }
        const std::vector<IndividualId>& ids = m_state->ids;
        if (m_rows->rowCount() >= ids.size()) {
            return failCount();
        }
        m_rows->putId(ids[m_rows->rowCount()]);
        return true;
    }
    bool haveAllRows()
    {
        return !isOfState() || m_rows->rowCount() == m_state->ids.size() || failCount();
    }
    bool failCount()
    {
        return fail({QT_TRANSLATE_NOOP("Messages", "%1 must have as many rows as ids: %2"),
                     m_rows->place(), m_state->ids.size()});
    }
    std::string_view m_text;
    TreeBuilder m_header;
    TreeBuilder m_tree;
    RowParser m_people{"individuals", {ColumnId::Template, ColumnId::Position}};
    StateTables m_states;
    LinkParser m_links;
    StateTable* m_state = nullptr; ///< whose rows come, or came last
    RowParser* m_rows = &m_people; ///< that come
    Where m_where = Where::Header;
    std::size_t m_depth = 0;
    std::size_t m_cell = 0;
    std::size_t m_component = 0;
    bool m_isInIndividuals = false;
    bool m_isInStates = false;
    bool m_isInRelations = false;
    bool m_seenRows = false;
    bool m_isForeign = false; ///< not damaged, but not for this program
    std::string m_tableKey;
    Message m_problem;
};

Error ProjectHandler::problem() const
{
    return m_isForeign ? Error{m_problem} : damaged(m_problem);
}

Result<Scene> ProjectHandler::finish()
{
    const json top = m_header.take();
    if (const Result<void> format = checkFormat(top); !format) {
        return format.error();
    }
    Result<Scene> scene = headerFromJson(top);
    if (!scene) {
        return damaged(scene.error().said);
    }
    if (!m_seenRows) {
        return damaged(QT_TRANSLATE_NOOP(
            "Messages", "\"individuals\" with \"columns\" and \"rows\" is missing"));
    }
    if (const Result<void> states = m_states.fill(scene.value()); !states) {
        return damaged(states.error().said);
    }
    if (const Result<void> rows = m_people.finish(scene.value()); !rows) {
        return damaged(rows.error().said);
    }
    m_links.fill(scene.value());
    return scene;
}

} // namespace

Result<Scene> projectFromText(std::string_view text)
{
    try {
        ProjectHandler handler(text);
        if (!json::sax_parse(text.begin(), text.end(), &handler)) {
            return handler.problem();
        }
        return handler.finish();
    } catch (const std::bad_alloc&) {
        return Error{QT_TRANSLATE_NOOP(
            "Messages", "It needs more memory than there is; close other programs and try again.")};
    } catch (const json::exception& error) {
        return damaged(std::string(error.what()));
    }
}

} // namespace crowd::model
