// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <QtCore/QProcess>
#include <QtCore/QString>

#include <glm/vec2.hpp>

#include "model/base/Result.h"

namespace crowd::app {

/// A moving picture, written by ffmpeg (CROWDBRUSH_FFMPEG in the environment: another one) while
/// its pictures are drawn: to a file beside it, which takes its name when it is whole. The same
/// pictures make the same bytes. One thread, an application object exists. Messages name the file
/// and what to do.
class MovieFile
{
public:
    /// By the ending of its name; `size` in pixels.
    [[nodiscard]] static model::Result<std::unique_ptr<MovieFile>>
    create(const QString& path, glm::ivec2 size, double framesPerSecond);
    ~MovieFile(); ///< unless it is finished, nothing stays of it
    MovieFile(const MovieFile&) = delete;
    MovieFile& operator=(const MovieFile&) = delete;

    /// RGBA8 rows from the top, of that size; alpha says nothing.
    [[nodiscard]] model::Result<void> add(std::span<const std::uint8_t> rgba);
    /// Once, after the last picture.
    [[nodiscard]] model::Result<void> finish();

private:
    explicit MovieFile(const QString& path);
    [[nodiscard]] model::Error problem();

    QString m_path;
    QString m_temporary; ///< empty: it has its name
    QProcess m_encoder;
};

} // namespace crowd::app
