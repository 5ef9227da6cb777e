// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <QtCore/QString>

#include "model/base/Result.h"

namespace crowd::model {

/// A file in which it is written how people moved: open as long as anybody reads it, so that it is
/// read on whatever happens to its name. What is in it the room of behaviour knows. Immutable; any
/// thread.
class MotionFile
{
public:
    /// A file of no known kind is opened too.
    [[nodiscard]] static Result<std::shared_ptr<const MotionFile>> open(const QString& path);
    ~MotionFile();
    MotionFile(const MotionFile&) = delete;
    MotionFile& operator=(const MotionFile&) = delete;

    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// Exactly so many bytes, or why they are not to be had.
    [[nodiscard]] Result<std::vector<std::byte>> read(std::uint64_t offset,
                                                      std::uint64_t size) const;
    /// Absolute, as it was opened.
    [[nodiscard]] const QString& path() const { return m_path; }

private:
    MotionFile(QString path, int file, std::uint64_t size);

    QString m_path;
    int m_file; ///< descriptor
    std::uint64_t m_size;
};

using MotionFilePtr = std::shared_ptr<const MotionFile>;

} // namespace crowd::model
