// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include <QtCore/QByteArray>
#include <QtCore/QString>

#include "model/base/Result.h"

class QImage;

namespace crowd::app {

/// A kind of file that pictures are written as. The command line, its help, scripts and their
/// messages follow from the table.
struct PictureFormat
{
    const char* name;
    std::span<const char* const> endings; ///< without the dot, lower case; the first is the usual
    bool hasTransparency;
    /// The file's bytes; the message says why there are none.
    model::Result<QByteArray> (*encode)(const QImage& image);
};

/// The usual one first.
[[nodiscard]] std::span<const PictureFormat> pictureFormats();
/// By the ending of a file's name; null where there is none of that ending.
[[nodiscard]] const PictureFormat* pictureFormatOf(const QString& path);
/// ".png, .jpg, .jpeg".
[[nodiscard]] std::string pictureEndings();

} // namespace crowd::app
