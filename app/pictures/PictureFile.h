// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <QtCore/QString>

#include <glm/vec2.hpp>

#include "app/pictures/ExrFile.h"
#include "app/pictures/PictureFormats.h"
#include "model/base/Result.h"
#include "model/project/WholeFile.h"

namespace crowd::app {

/// A picture that is written to a file row by row, whole or not at all; its ending tells what as.
/// A transparent one has its colours times alpha, as the renderer leaves them; the alpha of another
/// one says nothing.
class PictureFile
{
public:
    /// Before any pixel is drawn, also of what cannot be; see roomForPicture().
    [[nodiscard]] static model::Result<std::unique_ptr<PictureFile>>
    begin(const QString& path, const PictureShape& shape);

    /// Some rows, from the top: RGBA8; where the shape is deep four half floats a pixel.
    [[nodiscard]] model::Result<void> add(std::span<const std::uint8_t> rows);
    /// Once, after the last row; without it the file stays as it was.
    [[nodiscard]] model::Result<void> finish();

private:
    explicit PictureFile(QString path) : m_path(std::move(path)) {}

    [[nodiscard]] model::Result<void> take(std::string_view bytes);
    [[nodiscard]] model::Result<void> said(const model::Result<void>& done) const;

    QString m_path;
    std::optional<model::WholeFile> m_file;
    std::optional<model::Error> m_diskError;
    std::unique_ptr<PictureEncoder> m_encoder;
};

/// All rows at once.
[[nodiscard]] model::Result<void> writePicture(const QString& path,
                                               std::span<const std::uint8_t> rgba, glm::ivec2 size,
                                               bool isTransparent = false);

/// An error where no file of that ending can be of that shape.
[[nodiscard]] model::Result<void> roomForPicture(const QString& path, const PictureShape& shape);
/// Whether a file is a picture of that size, and whole as far as its end tells.
[[nodiscard]] bool isPictureThere(const QString& path, glm::ivec2 size);
/// What is said of a picture that could not be made, or not be written.
[[nodiscard]] model::Error pictureNotMade(const QString& path, const model::Error& why);
[[nodiscard]] model::Error pictureNotWritten(const QString& path, const model::Error& why);
/// Several layers of one, as OpenEXR, which the path says; whole or not at all.
[[nodiscard]] model::Result<void> writeLayers(const QString& path, const ExrHeader& header,
                                              std::span<const ExrLayer> layers);

} // namespace crowd::app
