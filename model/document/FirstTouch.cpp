// SPDX-License-Identifier: MIT
#include "model/document/FirstTouch.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "model/population/StoredRows.h"
#include "model/population/Strides.h"

namespace crowd::model {

namespace {

using Ids = std::vector<IndividualId>;

Ids united(std::span<const IndividualId> a, std::span<const IndividualId> b)
{
    Ids all;
    std::ranges::set_union(a, b, std::back_inserter(all));
    return all;
}

} // namespace

void FirstTouch::remember(std::span<const IndividualId> ids, std::span<const std::byte> values,
                          std::size_t stride)
{
    if (m_ids.empty()) {
        m_ids.assign(ids.begin(), ids.end());
        m_bytes.assign(values.begin(), values.end());
        return;
    }
    const Ids merged = united(m_ids, ids);
    std::vector<std::byte> bytes(merged.size() * stride);
    std::size_t known = 0;
    std::size_t fresh = 0;
    for (std::size_t i = 0; i < merged.size(); ++i) {
        const bool isKnown = known < m_ids.size() && m_ids[known] == merged[i];
        const std::byte* from = isKnown ? &m_bytes[known * stride] : &values[fresh * stride];
        std::memcpy(&bytes[i * stride], from, stride);
        known += isKnown ? 1 : 0;
        fresh += fresh < ids.size() && ids[fresh] == merged[i] ? 1 : 0;
    }
    m_ids = merged;
    m_bytes = std::move(bytes);
}

void FirstTouch::moveInto(std::span<const IndividualId> ids, std::span<std::byte> rows,
                          std::size_t stride)
{
    Ids keptIds;
    std::vector<std::byte> keptBytes;
    std::size_t row = 0;
    for (std::size_t i = 0; i < m_ids.size(); ++i) {
        const auto from = m_bytes.begin() + static_cast<std::ptrdiff_t>(i * stride);
        while (row < ids.size() && ids[row] < m_ids[i]) {
            ++row;
        }
        if (row < ids.size() && ids[row] == m_ids[i]) {
            std::copy_n(from, stride, rows.begin() + static_cast<std::ptrdiff_t>(row * stride));
        } else {
            keptIds.push_back(m_ids[i]);
            keptBytes.insert(keptBytes.end(), from, from + static_cast<std::ptrdiff_t>(stride));
        }
    }
    m_ids = std::move(keptIds);
    m_bytes = std::move(keptBytes);
}

ColumnDelta FirstTouch::changes(ColumnId column, const Population& population) const
{
    const std::size_t stride = columnInfo(column).stride;
    const std::vector<std::byte> now = population.values(column, m_ids);
    std::vector<std::size_t> changed;
    changed.reserve(m_ids.size());
    withStride(stride, [&](auto width) {
        for (std::size_t i = 0; i < m_ids.size(); ++i) {
            if (std::memcmp(&m_bytes[i * width], &now[i * width], width) != 0) {
                changed.push_back(i);
            }
        }
    });
    ColumnDelta delta;
    delta.column = column;
    delta.ids.resize(changed.size());
    delta.before.resize(changed.size() * stride);
    delta.after.resize(changed.size() * stride);
    withStride(stride, [&](auto width) {
        for (std::size_t i = 0; i < changed.size(); ++i) {
            delta.ids[i] = m_ids[changed[i]];
            std::memcpy(&delta.before[i * width], &m_bytes[changed[i] * width], width);
            std::memcpy(&delta.after[i * width], &now[changed[i] * width], width);
        }
    });
    keepOnceIfUniform(delta.before, stride);
    keepOnceIfUniform(delta.after, stride);
    return delta;
}

} // namespace crowd::model
