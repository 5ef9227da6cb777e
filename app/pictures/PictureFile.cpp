// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFile.h"

#include <QtCore/QFileInfo>
#include <QtCore/QSaveFile>
#include <QtGui/QImage>
#include <QtGui/QImageWriter>

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
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) {
        return model::Error{path.toStdString() +
                            " cannot be written: " + file.errorString().toStdString() +
                            ". Check the folder and its rights."};
    }
    QImageWriter writer(&file, format);
    if (!writer.write(image) || !file.commit()) {
        return model::Error{path.toStdString() + " cannot be written: " +
                            (writer.error() == QImageWriter::UnknownError ? file.errorString()
                                                                          : writer.errorString())
                                .toStdString() +
                            ". Check the space on the disk."};
    }
    return {};
}

} // namespace crowd::app
