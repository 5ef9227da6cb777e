// SPDX-License-Identifier: MIT
#include "model/population/Population.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstring>

#include "model/population/Properties.h"
#include "model/population/Strides.h"

namespace crowd::model {

namespace {

std::uint64_t nextVersion()
{
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

/// `count` times the same value.
std::vector<std::byte> repeated(std::span<const std::byte> value, std::size_t count)
{
    std::vector<std::byte> bytes(count * value.size());
    for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&bytes[i * value.size()], value.data(), value.size());
    }
    return bytes;
}

} // namespace

IndividualRows IndividualRows::withDefaults(std::vector<IndividualId> rowIds)
{
    IndividualRows rows;
    rows.ids = std::move(rowIds);
    for (const PropertyInfo& property : properties()) {
        rows.bytes[static_cast<std::size_t>(property.id)] =
            repeated(std::span(property.initial).first(property.column.stride), rows.ids.size());
    }
    return rows;
}

Population::Population() = default;

std::size_t Population::rowOf(IndividualId id) const
{
    const auto found = std::ranges::lower_bound(*m_ids, id);
    if (found == m_ids->end() || *found != id) {
        return npos;
    }
    return static_cast<std::size_t>(found - m_ids->begin());
}

std::span<const std::byte> Population::columnBytes(ColumnId column) const
{
    return *m_columns[static_cast<std::size_t>(column)];
}

std::vector<std::size_t> Population::rowsOf(std::span<const IndividualId> ids) const
{
    std::vector<std::size_t> found;
    found.reserve(ids.size());
    auto from = m_ids->begin();
    for (const IndividualId id : ids) {
        // Ids ascend, and a stroke touches runs of neighbours: try the next row before searching.
        if (from == m_ids->end() || *from != id) {
            from = std::lower_bound(from, m_ids->end(), id);
        }
        assert(from != m_ids->end() && *from == id);
        found.push_back(static_cast<std::size_t>(from - m_ids->begin()));
        ++from;
    }
    return found;
}

void Population::add(const IndividualRows& rows)
{
    if (rows.ids.empty()) {
        return;
    }
    assert(std::ranges::is_sorted(rows.ids));
    if (isEmpty() || m_ids->back() < rows.ids.front()) {
        append(rows);
        return;
    }
    const std::size_t total = size() + rows.ids.size();
    std::vector<IndividualId> ids(total);
    std::ranges::merge(*m_ids, rows.ids, ids.begin());
    assert(std::ranges::adjacent_find(ids) == ids.end());

    // fromNew[row]: whether the merged row comes from `rows`.
    std::vector<bool> fromNew(total);
    const auto firstNew =
        static_cast<std::size_t>(std::ranges::lower_bound(ids, rows.ids.front()) - ids.begin());
    for (std::size_t row = 0, next = 0; row < total; ++row) {
        fromNew[row] = next < rows.ids.size() && ids[row] == rows.ids[next];
        next += fromNew[row] ? 1 : 0;
    }
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        const std::size_t stride = columnInfo(static_cast<ColumnId>(c)).stride;
        std::vector<std::byte> merged(total * stride);
        const std::byte* oldFrom = m_columns[c]->data();
        const std::byte* newFrom = rows.bytes[c].data();
        std::byte* to = merged.data();
        for (std::size_t row = 0; row < total; ++row, to += stride) {
            const std::byte*& from = fromNew[row] ? newFrom : oldFrom;
            std::memcpy(to, from, stride);
            from += stride;
        }
        m_columns[c] = SharedVector(std::move(merged));
    }
    m_ids = SharedVector(std::move(ids));
    stampFrom(firstNew);
}

void Population::append(const IndividualRows& rows)
{
    std::vector<IndividualId>& ids = m_ids.writable();
    ids.insert(ids.end(), rows.ids.begin(), rows.ids.end());
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        std::vector<std::byte>& column = m_columns[c].writable();
        column.insert(column.end(), rows.bytes[c].begin(), rows.bytes[c].end());
    }
    stampFrom(ids.size() - rows.ids.size());
}

IndividualRows Population::remove(std::span<const IndividualId> ids)
{
    IndividualRows removed = rows(ids);
    if (ids.empty()) {
        return removed;
    }
    const std::vector<std::size_t> gone = rowsOf(ids);
    const auto compacted = [&](const auto& source, std::size_t stride) {
        std::remove_cvref_t<decltype(source)> kept;
        kept.reserve(source.size() - gone.size() * stride);
        std::size_t from = 0;
        for (const std::size_t row : gone) {
            kept.insert(kept.end(), source.begin() + static_cast<std::ptrdiff_t>(from * stride),
                        source.begin() + static_cast<std::ptrdiff_t>(row * stride));
            from = row + 1;
        }
        kept.insert(kept.end(), source.begin() + static_cast<std::ptrdiff_t>(from * stride),
                    source.end());
        return SharedVector(std::move(kept));
    };
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        m_columns[c] = compacted(*m_columns[c], columnInfo(static_cast<ColumnId>(c)).stride);
    }
    m_ids = compacted(*m_ids, 1);
    stampFrom(gone.front());
    return removed;
}

IndividualRows Population::rows(std::span<const IndividualId> ids) const
{
    IndividualRows copied;
    copied.ids.assign(ids.begin(), ids.end());
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        copied.bytes[c] = values(static_cast<ColumnId>(c), ids);
    }
    return copied;
}

std::vector<std::byte> Population::values(ColumnId column, std::span<const IndividualId> ids) const
{
    const std::size_t stride = columnInfo(column).stride;
    const std::span<const std::byte> source = columnBytes(column);
    if (ids.size() == size()) { // all of them
        assert(std::ranges::equal(ids, *m_ids));
        return {source.begin(), source.end()};
    }
    std::vector<std::byte> copied(ids.size() * stride);
    withStride(stride, [&](auto width) {
        std::byte* to = copied.data();
        for (const std::size_t row : rowsOf(ids)) {
            std::memcpy(to, source.data() + row * width, width);
            to += width;
        }
    });
    return copied;
}

void Population::setValues(ColumnId column, std::span<const IndividualId> ids,
                           std::span<const std::byte> bytes)
{
    const std::size_t stride = columnInfo(column).stride;
    const bool isUniform = bytes.size() == stride;
    assert(isUniform || bytes.size() == ids.size() * stride);
    if (ids.size() == size() && bytes.size() > stride) { // all of them
        assert(std::ranges::equal(ids, *m_ids));
        std::ranges::copy(bytes, writable(column).begin());
        stampBlocks();
        return;
    }
    const std::vector<std::size_t> touched = rowsOf(ids);
    withStride(stride, [&](auto width) {
        std::byte* target = writable(column).data();
        const std::byte* from = bytes.data();
        for (const std::size_t row : touched) {
            std::memcpy(target + row * width, from, width);
            from += isUniform ? std::size_t{0} : std::size_t{width};
        }
    });
    stampRows(std::span<const std::size_t>(touched));
}

std::vector<std::byte>& Population::writable(ColumnId column)
{
    return m_columns[static_cast<std::size_t>(column)].writable();
}

template<class Row>
void Population::stampRows(std::span<const Row> rows)
{
    if (rows.empty()) {
        return;
    }
    if (rows.size() >= size()) {
        return stampBlocks();
    }
    m_version = nextVersion();
    std::vector<std::uint64_t>& versions = m_blockVersions.writable();
    std::size_t from = 0; // rows of the block that is stamped already
    std::size_t to = 0;
    for (const std::size_t row : rows) {
        if ((row < from || row >= to) && row < size()) {
            versions[row / kBlockRows] = m_version;
            from = row / kBlockRows * kBlockRows;
            to = from + kBlockRows;
        }
    }
}

template void Population::stampRows(std::span<const std::uint32_t> rows);

void Population::stampBlocks()
{
    m_version = nextVersion();
    std::ranges::fill(m_blockVersions.writable(), m_version);
}

/// Rows from this one on are others than before; those of earlier blocks are not.
void Population::stampFrom(std::size_t row)
{
    m_version = nextVersion();
    m_rowsVersion = m_version;
    std::vector<std::uint64_t>& versions = m_blockVersions.writable();
    versions.resize((size() + kBlockRows - 1) / kBlockRows);
    const std::size_t first = std::min(row / kBlockRows, versions.size());
    std::fill(versions.begin() + static_cast<std::ptrdiff_t>(first), versions.end(), m_version);
}

bool operator==(const Population& a, const Population& b)
{
    if (*a.m_ids != *b.m_ids) {
        return false;
    }
    for (std::size_t c = 0; c < kColumnCount; ++c) {
        if (*a.m_columns[c] != *b.m_columns[c]) {
            return false;
        }
    }
    return true;
}

} // namespace crowd::model
