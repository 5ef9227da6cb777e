// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include <QtCore/QString>

#include "model/base/Result.h"

namespace crowd::model {

/// Bytes kept on disk instead of in memory. The file is made at the first write and has no name in
/// its folder, so that the system removes it when the process ends, whichever way it ends.
/// What was written is read back exactly or not at all (checksum). One thread.
class SpillFile
{
public:
    /// A piece of the file.
    struct Extent
    {
        std::uint64_t offset = 0;
        std::uint64_t size = 0;
        std::uint64_t checksum = 0;
    };

    /// Empty folder: $TMPDIR, else /var/tmp (on disk where /tmp may be memory), else /tmp. A write
    /// fails that would leave less than `reserveBytes` of the disk free, for work to be saved on.
    SpillFile(const QString& folder, std::uint64_t reserveBytes);
    ~SpillFile();
    SpillFile(const SpillFile&) = delete;
    SpillFile& operator=(const SpillFile&) = delete;

    [[nodiscard]] Result<Extent> write(std::span<const std::byte> bytes);
    [[nodiscard]] Result<std::vector<std::byte>> read(const Extent& extent) const;
    /// The extent is not needed any more; its place is used again.
    void release(const Extent& extent);
    /// Length of the file.
    [[nodiscard]] std::uint64_t bytes() const { return m_end; }

private:
    [[nodiscard]] Result<void> open();
    [[nodiscard]] Result<void> checkRoom(std::uint64_t size) const;
    [[nodiscard]] std::uint64_t takePlace(std::uint64_t size);

    QString m_folder;
    std::uint64_t m_reserve;
    int m_file = -1;
    std::uint64_t m_end = 0;
    std::map<std::uint64_t, std::uint64_t> m_free; ///< offset → size, never touching each other
};

} // namespace crowd::model
