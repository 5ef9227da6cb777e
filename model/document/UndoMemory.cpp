// SPDX-License-Identifier: MIT
#include "model/document/UndoMemory.h"

#include <utility>

#include "model/document/DeltaBytes.h"
#include "model/document/StoredDelta.h"

namespace crowd::model {

UndoMemory::UndoMemory(UndoLimits limits)
    : m_limits(std::move(limits)), m_file(m_limits.folder, m_limits.diskReserve)
{
}

void UndoMemory::setBudget(std::size_t bytes)
{
    m_limits.bytes = bytes;
    keepWithinBudget();
}

void UndoMemory::setHeldBeside(std::size_t bytes)
{
    m_beside = bytes;
    keepWithinBudget();
}

void UndoMemory::keepWithinBudget()
{
    m_problem = {};
    while (bytes() > m_limits.bytes && m_recent.size() > 1) {
        if (const Result<void> left = m_recent.front()->leaveMemory(); !left) {
            m_problem = left.error().said;
            return;
        }
    }
}

StoredDelta::StoredDelta(UndoMemory& memory, SceneDelta delta)
    : m_memory(memory), m_delta(std::move(delta)), m_bytes(m_delta.bytes()),
      m_bulkBytes(m_delta.bulkBytes())
{
    m_memory.m_bytes += m_bytes - m_bulkBytes;
    setInMemory(true);
    m_memory.keepWithinBudget();
}

StoredDelta::~StoredDelta()
{
    if (m_isInMemory) {
        setInMemory(false);
    }
    m_memory.m_bytes -= m_bytes - m_bulkBytes;
    if (m_extent) {
        m_memory.m_file.release(*m_extent);
    }
}

Result<const SceneDelta*> StoredDelta::use()
{
    if (m_isInMemory) {
        if (m_bulkBytes > 0) {
            m_memory.m_recent.splice(m_memory.m_recent.end(), m_memory.m_recent, m_place);
        }
        return &m_delta;
    }
    const Result<std::vector<std::byte>> bytes = m_memory.m_file.read(*m_extent);
    if (!bytes) {
        return bytes.error();
    }
    if (const Result<void> whole = readBulk(bytes.value(), m_delta); !whole) {
        return whole.error();
    }
    setInMemory(true);
    m_memory.keepWithinBudget();
    return &m_delta;
}

Result<void> StoredDelta::leaveMemory()
{
    if (!m_extent) { // a delta never changes: what was written once stays good
        const Result<SpillFile::Extent> extent = m_memory.m_file.write(bulkBytesOf(m_delta));
        if (!extent) {
            return extent.error();
        }
        m_extent = extent.value();
    }
    dropBulk(m_delta);
    setInMemory(false);
    return {};
}

void StoredDelta::setInMemory(bool isInMemory)
{
    m_isInMemory = isInMemory;
    if (m_bulkBytes == 0) {
        return;
    }
    if (isInMemory) {
        m_place = m_memory.m_recent.insert(m_memory.m_recent.end(), this);
        m_memory.m_bytes += m_bulkBytes;
    } else {
        m_memory.m_recent.erase(m_place);
        m_memory.m_bytes -= m_bulkBytes;
    }
}

} // namespace crowd::model
