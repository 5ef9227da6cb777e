// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFormats.h"

#include <QtCore/QBuffer>
#include <QtCore/QFileInfo>
#include <QtGui/QImage>
#include <QtGui/QImageWriter>

namespace crowd::app {

namespace {

constexpr int kJpegQuality = 95; ///< of 100

model::Result<QByteArray> encoded(const QImage& image, const char* format, int quality = -1)
{
    QBuffer bytes;
    QImageWriter writer(&bytes, format);
    writer.setQuality(quality);
    if (!writer.write(image)) {
        return model::Error{writer.errorString().toStdString()};
    }
    return bytes.data();
}

constexpr const char* kPng[] = {"png"};
constexpr const char* kJpeg[] = {"jpg", "jpeg"};
constexpr const char* kTiff[] = {"tif", "tiff"};
constexpr const char* kWebp[] = {"webp"};

constexpr PictureFormat kFormats[] = {
    {"PNG", kPng, true, [](const QImage& image) { return encoded(image, "png"); }},
    {"JPEG", kJpeg, false, [](const QImage& image) { return encoded(image, "jpg", kJpegQuality); }},
    {"TIFF", kTiff, true, [](const QImage& image) { return encoded(image, "tiff"); }},
    {"WebP", kWebp, true, [](const QImage& image) { return encoded(image, "webp", 100); }}};

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
