// SPDX-License-Identifier: MIT
#include "app/pictures/MovieFormats.h"

#include <QtCore/QFileInfo>

namespace crowd::app {

namespace {

/// An even number of rows and columns, which these encoders want.
constexpr const char* kEvenSize = "pad=max(iw\\,2):max(ih\\,2),crop=trunc(iw/2)*2:trunc(ih/2)*2,"
                                  "scale=out_color_matrix=bt709:out_range=tv";

/// Colours as televisions have them, said in the file.
#define CROWD_MOVIE_COLOURS                                                                        \
    "-vf", kEvenSize, "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709",  \
        "-color_trc", "bt709", "-color_range", "tv"

constexpr const char* kMp4[] = {"-c:v", "libx264",           "-preset",   "medium",     "-crf",
                                "16",   CROWD_MOVIE_COLOURS, "-movflags", "+faststart", "-f",
                                "mp4"};
constexpr const char* kWebm[] = {"-c:v", "libvpx-vp9",        "-crf", "22",  "-b:v", "0", "-row-mt",
                                 "1",    CROWD_MOVIE_COLOURS, "-f",   "webm"};
/// A palette of all pictures' own colours.
constexpr const char* kOwnPalette =
    "split[all][some];[some]palettegen=stats_mode=full[colours];[all][colours]paletteuse=dither="
    "sierra2_4a";
constexpr const char* kGif[] = {"-filter_complex", kOwnPalette, "-loop", "0", "-f", "gif"};

#undef CROWD_MOVIE_COLOURS

constexpr MovieFormat kMovieFormats[] = {
    {"MP4", "mp4", kMp4}, {"WebM", "webm", kWebm}, {"GIF", "gif", kGif}};

} // namespace

std::span<const MovieFormat> movieFormats()
{
    return kMovieFormats;
}

const MovieFormat* movieFormatOf(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    for (const MovieFormat& format : kMovieFormats) {
        if (ending == QLatin1String(format.ending)) {
            return &format;
        }
    }
    return nullptr;
}

std::string movieEndings()
{
    std::string all;
    for (const MovieFormat& format : kMovieFormats) {
        all += (all.empty() ? "." : ", .") + std::string(format.ending);
    }
    return all;
}

} // namespace crowd::app
