// SPDX-License-Identifier: MIT
#pragma once

#include <list>
#include <optional>

#include "model/base/Result.h"
#include "model/document/SceneDelta.h"
#include "model/document/SpillFile.h"
#include "model/document/UndoMemory.h"

namespace crowd::model {

/// A delta that may lie on disk. Dies before its memory.
class StoredDelta
{
public:
    StoredDelta(UndoMemory& memory, SceneDelta delta);
    ~StoredDelta();
    StoredDelta(const StoredDelta&) = delete;
    StoredDelta& operator=(const StoredDelta&) = delete;

    /// The whole delta, read back where needed; valid until another delta is used. Fails when it
    /// cannot be read back, and may be tried again.
    [[nodiscard]] Result<const SceneDelta*> use();
    /// Of the whole delta, wherever it lies.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }
    [[nodiscard]] bool isInMemory() const { return m_isInMemory; }

private:
    friend class UndoMemory;

    [[nodiscard]] Result<void> leaveMemory();
    void setInMemory(bool isInMemory);

    UndoMemory& m_memory;
    SceneDelta m_delta;
    std::size_t m_bytes;
    std::size_t m_bulkBytes; ///< of them, the part that can leave
    bool m_isInMemory = false;
    std::optional<SpillFile::Extent> m_extent; ///< stays valid when the delta is in memory again
    std::list<StoredDelta*>::iterator m_place;
};

} // namespace crowd::model
