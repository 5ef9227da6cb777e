// SPDX-License-Identifier: MIT
#include "model/document/DeltaBytes.h"

#include <cstring>

namespace crowd::model {

namespace {

void put(std::vector<std::byte>& bytes, const void* from, std::size_t size)
{
    const auto* first = static_cast<const std::byte*>(from);
    bytes.insert(bytes.end(), first, first + size);
}

void putNumber(std::vector<std::byte>& bytes, std::uint64_t number)
{
    put(bytes, &number, sizeof(number));
}

/// Items with their number before them.
template<class Item>
void putList(std::vector<std::byte>& bytes, const std::vector<Item>& items)
{
    putNumber(bytes, items.size());
    put(bytes, items.data(), items.size() * sizeof(Item));
}

void putRows(std::vector<std::byte>& bytes, const StoredRows& rows)
{
    putList(bytes, rows.ids);
    putNumber(bytes, rows.columns.size());
    for (const StoredRows::Column& stored : rows.columns) {
        putNumber(bytes, static_cast<std::uint64_t>(stored.column));
        putList(bytes, stored.bytes);
    }
}

/// Takes what was put, in the same order; once something does not fit, everything fails.
class Source
{
public:
    explicit Source(std::span<const std::byte> bytes) : m_rest(bytes) {}

    std::uint64_t number()
    {
        std::uint64_t value = 0;
        take(&value, sizeof(value));
        return value;
    }
    template<class Item>
    void list(std::vector<Item>& items)
    {
        const std::uint64_t count = number();
        if (count > m_rest.size() / sizeof(Item)) {
            m_isWhole = false;
            return;
        }
        items.resize(count);
        take(items.data(), items.size() * sizeof(Item));
    }
    void rows(StoredRows& target)
    {
        list(target.ids);
        const std::uint64_t columns = number();
        for (std::uint64_t i = 0; i < columns && m_isWhole; ++i) {
            StoredRows::Column stored{columnId(), {}};
            list(stored.bytes);
            const std::size_t stride = m_isWhole ? columnInfo(stored.column).stride : 0;
            m_isWhole = m_isWhole && (stored.bytes.size() == target.ids.size() * stride ||
                                      stored.bytes.size() == stride);
            target.columns.push_back(std::move(stored));
        }
    }
    void column(ColumnDelta& target)
    {
        target.column = columnId();
        list(target.ids);
        list(target.before);
        list(target.after);
    }
    [[nodiscard]] bool isWhole() const { return m_isWhole; }
    [[nodiscard]] bool isAtEnd() const { return m_rest.empty(); }

private:
    ColumnId columnId()
    {
        const std::uint64_t id = number();
        m_isWhole = m_isWhole && id < kColumnCount;
        return m_isWhole ? static_cast<ColumnId>(id) : ColumnId::Template;
    }
    void take(void* to, std::size_t size)
    {
        if (!m_isWhole || size > m_rest.size()) {
            m_isWhole = false;
            return;
        }
        if (size > 0) {
            std::memcpy(to, m_rest.data(), size);
        }
        m_rest = m_rest.subspan(size);
    }

    std::span<const std::byte> m_rest;
    bool m_isWhole = true;
};

} // namespace

std::vector<std::byte> bulkBytesOf(const SceneDelta& delta)
{
    std::vector<std::byte> bytes;
    bytes.reserve(delta.bulkBytes() + 1024);
    putRows(bytes, delta.added);
    putRows(bytes, delta.removed);
    putNumber(bytes, delta.columns.size());
    for (const ColumnDelta& change : delta.columns) {
        putNumber(bytes, static_cast<std::uint64_t>(change.column));
        putList(bytes, change.ids);
        putList(bytes, change.before);
        putList(bytes, change.after);
    }
    putList(bytes, delta.of<members::Relations>().removed);
    putList(bytes, delta.of<members::Relations>().added);
    return bytes;
}

Result<void> readBulk(std::span<const std::byte> bytes, SceneDelta& delta)
{
    Source source(bytes);
    source.rows(delta.added);
    source.rows(delta.removed);
    const std::uint64_t columns = source.number();
    for (std::uint64_t i = 0; i < columns && source.isWhole(); ++i) {
        source.column(delta.columns.emplace_back());
    }
    source.list(delta.of<members::Relations>().removed);
    source.list(delta.of<members::Relations>().added);
    if (!source.isWhole() || !source.isAtEnd()) {
        dropBulk(delta);
        return Error{QT_TRANSLATE_NOOP(
            "Messages", "the temporary file holds something else than an undo step")};
    }
    return {};
}

void dropBulk(SceneDelta& delta)
{
    delta.added = {};
    delta.removed = {};
    delta.columns = {};
    delta.columns.shrink_to_fit();
    delta.of<members::Relations>() = {};
}

} // namespace crowd::model
