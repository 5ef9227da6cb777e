// SPDX-License-Identifier: MIT
#pragma once

#include <QtCore/QString>
#include <nlohmann/json.hpp>

#include "model/base/Result.h"

/// Parts of a scene as files of their own, so that projects share them: one object with "format",
/// "version" and the part.
namespace crowd::model {

struct SharedFormat
{
    const char* name;   ///< "format"
    int version;        ///< the highest that is known
    const char* notOne; ///< said of another file, %1 for its path; context "Messages"
};

[[nodiscard]] Result<void> writeSharedFile(const QString& path, const SharedFormat& format,
                                           const char* key, nlohmann::json part);
/// The whole object. Errors name the file.
[[nodiscard]] Result<nlohmann::json> readSharedFile(const QString& path,
                                                    const SharedFormat& format);

} // namespace crowd::model
