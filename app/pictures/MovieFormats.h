// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include <QtCore/QString>

namespace crowd::app {

/// A kind of file that moving pictures are written as, by ffmpeg. The command line, the window and
/// their messages follow from the table.
struct MovieFormat
{
    const char* name;
    const char* ending;                     ///< without the dot, lower case
    std::span<const char* const> arguments; ///< of ffmpeg, between what is read and the file
};

/// Of the frames, a side: what encoders take.
inline constexpr int kMostMoviePixelsASide = 16384;

/// The usual one first.
[[nodiscard]] std::span<const MovieFormat> movieFormats();
/// By the ending of a file's name; null where there is none of that ending.
[[nodiscard]] const MovieFormat* movieFormatOf(const QString& path);
/// ".mp4, .webm, .gif".
[[nodiscard]] std::string movieEndings();

} // namespace crowd::app
