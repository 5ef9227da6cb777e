// SPDX-License-Identifier: MIT
#pragma once

#include <list>
#include <optional>

#include <QtCore/QString>

#include "model/base/Message.h"
#include "model/document/SpillFile.h"

namespace crowd::model {

/// How much memory undo may take, and where what exceeds it goes.
struct UndoLimits
{
    std::size_t bytes = std::size_t{256} << 20U;
    QString folder; ///< of the temporary file; empty: see SpillFile
    /// Of the disk, kept free for work to be saved on.
    std::uint64_t diskReserve = std::uint64_t{512} << 20U;
};

class StoredDelta;

/// Keeps the deltas of all undo steps within a budget of memory: those used longest ago are written
/// to a temporary file and read back when they are needed. Scene-level entries stay in memory and
/// are counted; so does the delta used last. When the file cannot be written, deltas stay in memory
/// beyond the budget and problem() says why. Main thread only.
class UndoMemory
{
public:
    explicit UndoMemory(UndoLimits limits = {});

    /// What exceeds it now goes to disk at once.
    void setBudget(std::size_t bytes);
    [[nodiscard]] std::size_t budget() const { return m_limits.bytes; }
    /// Held by others for the sake of undo steps: counted, and never put to disk.
    void setHeldBeside(std::size_t bytes);
    /// Held in memory by all deltas and beside them, without assets (they are shared).
    [[nodiscard]] std::size_t bytes() const { return m_bytes + m_beside; }
    [[nodiscard]] std::uint64_t bytesOnDisk() const { return m_file.bytes(); }
    /// Why the budget is exceeded; empty while it is kept.
    [[nodiscard]] const Message& problem() const { return m_problem; }

private:
    friend class StoredDelta;

    void keepWithinBudget();

    UndoLimits m_limits;
    SpillFile m_file;
    std::list<StoredDelta*> m_recent; ///< in memory and able to leave it; used last at the end
    std::size_t m_bytes = 0;
    std::size_t m_beside = 0;
    Message m_problem;
};

} // namespace crowd::model
