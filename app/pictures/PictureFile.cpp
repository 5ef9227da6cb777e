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
        return model::Error{
            QT_TRANSLATE_NOOP(
                "Messages",
                "%1: let the name end in one of %2; it says what the picture is written as."),
            path.toStdString(), pictureEndings()};
    }
    // Opaque: no alpha channel in the file.
    const QImage image = QImage(rgba.data(), size.x, size.y, size.x * 4, QImage::Format_RGBX8888)
                             .convertToFormat(QImage::Format_RGB888);
    const auto encoded = format->encode(image);
    if (!encoded) {
        return model::Error{
            QT_TRANSLATE_NOOP(
                "Messages",
                "%1: the picture could not be made: %2. Try a smaller size, or another ending."),
            path.toStdString(), encoded.error().said};
    }
    const QByteArray& bytes = encoded.value();
    const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    if (auto written = model::writeWholeFile(path, text); !written) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2. Check the folder, its rights "
                                          "and the space on the disk."),
            path.toStdString(), written.error().said};
    }
    return {};
}

} // namespace crowd::app
