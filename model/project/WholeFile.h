// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include <QtCore/QByteArray>
#include <QtCore/QString>

#include "model/base/Result.h"

namespace crowd::model {

/// A file that is written whole or not at all: to a temporary one beside it, flushed to the disk,
/// then renamed over the old one, which stays untouched when anything fails. A link stays one, and
/// what it leads to is written. Devices, pipes and folders are refused. What writers that were
/// killed left beside this very file is removed. Errors say only why, without path and stop.
class WholeFile
{
public:
    [[nodiscard]] static Result<WholeFile> begin(const QString& path);
    ~WholeFile(); ///< without commit() the old file stays
    WholeFile(WholeFile&& other) noexcept;
    WholeFile& operator=(WholeFile&&) = delete;
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    [[nodiscard]] Result<void> write(std::string_view bytes);
    /// Once, after the last write.
    [[nodiscard]] Result<void> commit();

private:
    WholeFile(QByteArray target, QByteArray temporary, int file);

    QByteArray m_target;
    QByteArray m_temporary; ///< empty: there is none (any more)
    int m_file;             ///< descriptor; -1: closed
};

/// All at once.
[[nodiscard]] Result<void> writeWholeFile(const QString& path, std::string_view bytes);

} // namespace crowd::model
