// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFile.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <QtGui/QImage>

#include "app/pictures/PictureFormats.h"
#include "model/base/Color.h"
#include "model/project/WholeFile.h"

namespace crowd::app {

namespace {

/// sRGB of what light times alpha was encoded from, without the alpha.
std::uint8_t unmultiplied(std::uint8_t encoded, std::uint8_t alpha)
{
    constexpr float kMost = 255.0F;
    const float light = model::linearFromSrgb(static_cast<float>(encoded) / kMost);
    const float own = std::min(1.0F, light * kMost / static_cast<float>(alpha));
    return static_cast<std::uint8_t>(std::lround(model::srgbFromLinear(own) * kMost));
}

QImage transparentImage(std::vector<std::uint8_t> rgba, glm::ivec2 size)
{
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
        const std::uint8_t alpha = rgba[i + 3];
        if (alpha == 0 || alpha == 255) {
            continue;
        }
        for (std::size_t channel = 0; channel < 3; ++channel) {
            rgba[i + channel] = unmultiplied(rgba[i + channel], alpha);
        }
    }
    return QImage(rgba.data(), size.x, size.y, size.x * 4, QImage::Format_RGBA8888).copy();
}

/// Without an alpha channel in the file.
QImage opaqueImage(const std::vector<std::uint8_t>& rgba, glm::ivec2 size)
{
    return QImage(rgba.data(), size.x, size.y, size.x * 4, QImage::Format_RGBX8888)
        .convertToFormat(QImage::Format_RGB888);
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
    const QImage image = isTransparent ? transparentImage(rgba, size) : opaqueImage(rgba, size);
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
