// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFile.h"

#include <string_view>

#include <QtCore/QBuffer>
#include <QtCore/QFileInfo>
#include <QtGui/QImage>
#include <QtGui/QImageWriter>

#include "model/project/WholeFile.h"

namespace crowd::app {

model::Result<void> writePicture(const QString& path, const std::vector<std::uint8_t>& rgba,
                                 glm::ivec2 size)
{
    const QByteArray format = QFileInfo(path).suffix().toLower().toLatin1();
    if (!QImageWriter::supportedImageFormats().contains(format)) {
        return model::Error{path.toStdString() +
                            ": pictures are written as PNG; let the name end in .png."};
    }
    // Opaque: no alpha channel in the file.
    const QImage image = QImage(rgba.data(), size.x, size.y, size.x * 4, QImage::Format_RGBX8888)
                             .convertToFormat(QImage::Format_RGB888);
    QBuffer encoded;
    QImageWriter writer(&encoded, format);
    if (!writer.write(image)) {
        return model::Error{path.toStdString() + ": the picture could not be made: " +
                            writer.errorString().toStdString() + ". Try a smaller size."};
    }
    const QByteArray& bytes = encoded.data();
    const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    if (auto written = model::writeWholeFile(path, text); !written) {
        return model::Error{path.toStdString() + " cannot be written: " + written.error().message +
                            ". Check the folder, its rights and the space on the disk."};
    }
    return {};
}

} // namespace crowd::app
