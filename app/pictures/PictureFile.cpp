// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFile.h"

#include <string_view>

#include <QtCore/QByteArray>

#include "app/pictures/PictureFormats.h"
#include "model/project/WholeFile.h"

namespace crowd::app {

namespace {

model::Error notMade(const QString& path, const model::Error& error)
{
    return {QT_TRANSLATE_NOOP(
                "Messages",
                "%1: the picture could not be made: %2. Try a smaller size, or another ending."),
            path.toStdString(), error.said};
}

model::Result<void> writeBytes(const QString& path, const QByteArray& bytes)
{
    const std::string_view text(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    if (auto written = model::writeWholeFile(path, text); !written) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2. Check the folder, its rights "
                                          "and the space on the disk."),
            path.toStdString(), written.error().said};
    }
    return {};
}

} // namespace

model::Result<void> writePicture(const QString& path, const std::vector<std::uint8_t>& rgba,
                                 glm::ivec2 size, bool isTransparent)
{
    const PictureFormat* format = pictureFormatOf(path);
    if (format == nullptr) {
        return model::Error{
            QT_TRANSLATE_NOOP(
                "Messages",
                "%1: let the name end in one of %2; it says what the picture is written as."),
            path.toStdString(), pictureEndings()};
    }
    if (isTransparent && !format->hasTransparency) {
        return model::Error{QT_TRANSLATE_NOOP("Messages",
                                              "%1: a %2 file cannot be transparent. Let the name "
                                              "end in .png, or switch the transparency off."),
                            path.toStdString(), std::string(format->name)};
    }
    const auto encoded = format->encode({rgba, size, isTransparent});
    if (!encoded) {
        return notMade(path, encoded.error());
    }
    return writeBytes(path, encoded.value());
}

model::Result<void> roomForPasses(const QString& path)
{
    const PictureFormat* format = pictureFormatOf(path);
    if (format != nullptr && format->hasLayers) {
        return {};
    }
    return model::Error{
        QT_TRANSLATE_NOOP("Messages", "%1 has no room for passes: let the name end in .exr."),
        path.toStdString()};
}

model::Result<void> writeLayers(const QString& path, const ExrHeader& header,
                                std::span<const ExrLayer> layers)
{
    if (auto room = roomForPasses(path); !room) {
        return room;
    }
    const auto encoded = encodeExr(header, layers);
    if (!encoded) {
        return notMade(path, encoded.error());
    }
    return writeBytes(path, encoded.value());
}

} // namespace crowd::app
