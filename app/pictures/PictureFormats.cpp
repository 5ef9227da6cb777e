// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFormats.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QtCore/QBuffer>
#include <QtCore/QFileInfo>
#include <QtGui/QImage>
#include <QtGui/QImageWriter>

#include "app/pictures/ExrFile.h"
#include "model/base/Color.h"

namespace crowd::app {

namespace {

constexpr int kJpegQuality = 95; ///< of 100

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

QImage imageOf(const DrawnPicture& picture)
{
    return picture.isTransparent ? transparentImage(picture.rgba, picture.size)
                                 : opaqueImage(picture.rgba, picture.size);
}

model::Result<QByteArray> encoded(const DrawnPicture& picture, const char* format, int quality = -1)
{
    QBuffer bytes;
    QImageWriter writer(&bytes, format);
    writer.setQuality(quality);
    if (!writer.write(imageOf(picture))) {
        return model::Error{writer.errorString().toStdString()};
    }
    return bytes.data();
}

/// Of half floats, for those who go on working with it.
model::Result<QByteArray> linear(const DrawnPicture& picture)
{
    const std::array layer{colourLayer(picture.rgba, picture.isTransparent)};
    ExrHeader header;
    header.size = picture.size;
    return encodeExr(header, layer);
}

constexpr const char* kPng[] = {"png"};
constexpr const char* kJpeg[] = {"jpg", "jpeg"};
constexpr const char* kTiff[] = {"tif", "tiff"};
constexpr const char* kWebp[] = {"webp"};
constexpr const char* kExr[] = {"exr"};

constexpr PictureFormat kFormats[] = {
    {"PNG", kPng, true, false, [](const DrawnPicture& drawn) { return encoded(drawn, "png"); }},
    {"JPEG", kJpeg, false, false,
     [](const DrawnPicture& drawn) { return encoded(drawn, "jpg", kJpegQuality); }},
    {"TIFF", kTiff, true, false, [](const DrawnPicture& drawn) { return encoded(drawn, "tiff"); }},
    {"WebP", kWebp, true, false,
     [](const DrawnPicture& drawn) { return encoded(drawn, "webp", 100); }},
    {"OpenEXR", kExr, true, true, &linear}};

} // namespace

std::span<const PictureFormat> pictureFormats()
{
    return kFormats;
}

const PictureFormat* pictureFormatOf(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    for (const PictureFormat& format : kFormats) {
        for (const char* each : format.endings) {
            if (ending == QLatin1String(each)) {
                return &format;
            }
        }
    }
    return nullptr;
}

std::string pictureEndings()
{
    std::string all;
    for (const PictureFormat& format : kFormats) {
        for (const char* each : format.endings) {
            all += (all.empty() ? "." : ", .") + std::string(each);
        }
    }
    return all;
}

} // namespace crowd::app
