// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFile.h"

#include <string_view>

#include <QtGui/QImage>

#include "app/pictures/PictureFormats.h"
#include "model/project/WholeFile.h"

namespace crowd::app {

model::Result<void> writePicture(const QString& path, const std::vector<std::uint8_t>& rgba,
                                 glm::ivec2 size)
{
    const PictureFormat* format = pictureFormatOf(path);
    if (format == nullptr) {
        return model::Error{path.toStdString() + ": let the name end in one of " +
                            pictureEndings() + "; it says what the picture is written as."};
    }
    // Opaque: no alpha channel in the file.
    const QImage image = QImage(rgba.data(), size.x, size.y, size.x * 4, QImage::Format_RGBX8888)
                             .convertToFormat(QImage::Format_RGB888);
    const auto encoded = format->encode(image);
    if (!encoded) {
        return model::Error{path.toStdString() + ": the picture could not be made: " +
                            encoded.error().message + ". Try a smaller size, or another ending."};
    }
    const QByteArray& bytes = encoded.value();
    const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    if (auto written = model::writeWholeFile(path, text); !written) {
        return model::Error{path.toStdString() + " cannot be written: " + written.error().message +
                            ". Check the folder, its rights and the space on the disk."};
    }
    return {};
}

} // namespace crowd::app
