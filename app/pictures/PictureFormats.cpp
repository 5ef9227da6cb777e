// SPDX-License-Identifier: MIT
#include "app/pictures/PictureFormats.h"

#include <array>
#include <utility>
#include <vector>

#include <QtCore/QBuffer>
#include <QtCore/QFileInfo>
#include <QtGui/QImage>
#include <QtGui/QImageWriter>

#include "app/pictures/ExrFile.h"
#include "app/pictures/PngEncoder.h"
#include "app/pictures/StraightAlpha.h"

namespace crowd::app {

namespace {

constexpr int kJpegQuality = 95; ///< of 100
constexpr int kMostAtOnce = 16384;

/// Of those that want the picture whole.
class WholeEncoder : public PictureEncoder
{
public:
    using Encode = model::Result<QByteArray> (*)(std::vector<std::uint8_t>& rgba,
                                                 const PictureShape& shape);

    WholeEncoder(const PictureShape& shape, ByteSink sink, Encode encode)
        : m_shape(shape), m_sink(std::move(sink)), m_encode(encode)
    {
    }

    model::Result<void> add(std::span<const std::uint8_t> rows) override
    {
        const auto width = static_cast<std::size_t>(m_shape.size.x);
        const std::size_t pixelBytes = m_shape.isDeep ? 8 : 4;
        m_pixels.reserve(width * static_cast<std::size_t>(m_shape.size.y) * pixelBytes);
        m_pixels.insert(m_pixels.end(), rows.begin(), rows.end());
        return {};
    }

    model::Result<void> finish() override
    {
        const auto bytes = m_encode(m_pixels, m_shape);
        if (!bytes) {
            return bytes.error();
        }
        return m_sink({bytes.value().constData(), static_cast<std::size_t>(bytes.value().size())});
    }

private:
    PictureShape m_shape;
    ByteSink m_sink;
    Encode m_encode;
    std::vector<std::uint8_t> m_pixels;
};

template<WholeEncoder::Encode kEncode>
std::unique_ptr<PictureEncoder> whole(const PictureShape& shape, ByteSink sink)
{
    return std::make_unique<WholeEncoder>(shape, std::move(sink), kEncode);
}

/// Without an alpha channel in the file, unless it is transparent. Shares the pixels.
QImage imageOf(std::vector<std::uint8_t>& rgba, const PictureShape& shape)
{
    const glm::ivec2 size = shape.size;
    if (shape.isTransparent) {
        straightenAlpha(rgba);
        return {rgba.data(), size.x, size.y, size.x * 4, QImage::Format_RGBA8888};
    }
    return QImage(rgba.data(), size.x, size.y, size.x * 4, QImage::Format_RGBX8888)
        .convertToFormat(QImage::Format_RGB888);
}

model::Result<QByteArray> encoded(std::vector<std::uint8_t>& rgba, const PictureShape& shape,
                                  const char* format, int quality = -1)
{
    QBuffer bytes;
    QImageWriter writer(&bytes, format);
    writer.setQuality(quality);
    if (!writer.write(imageOf(rgba, shape))) {
        return model::Error{writer.errorString().toStdString()};
    }
    return bytes.data();
}

model::Result<QByteArray> jpeg(std::vector<std::uint8_t>& rgba, const PictureShape& shape)
{
    return encoded(rgba, shape, "jpg", kJpegQuality);
}

model::Result<QByteArray> tiff(std::vector<std::uint8_t>& rgba, const PictureShape& shape)
{
    return encoded(rgba, shape, "tiff");
}

model::Result<QByteArray> webp(std::vector<std::uint8_t>& rgba, const PictureShape& shape)
{
    return encoded(rgba, shape, "webp", 100);
}

/// Of half floats, for those who go on working with it.
model::Result<QByteArray> linear(std::vector<std::uint8_t>& rgba, const PictureShape& shape)
{
    const std::array layer{shape.isDeep ? deepColourLayer(rgba, shape.isTransparent)
                                        : colourLayer(rgba, shape.isTransparent)};
    ExrHeader header;
    header.size = shape.size;
    return encodeExr(header, layer);
}

constexpr const char* kPng[] = {"png"};
constexpr const char* kJpeg[] = {"jpg", "jpeg"};
constexpr const char* kTiff[] = {"tif", "tiff"};
constexpr const char* kWebp[] = {"webp"};
constexpr const char* kExr[] = {"exr"};

constexpr std::string_view kPngEnd = "IEND\xAE\x42\x60\x82"; ///< the last chunk

constexpr PictureFormat kFormats[] = {
    {"PNG", kPng, true, false, PassRoom::FilesEach, kPngEnd, kMostPixelsASide, &makePngEncoder},
    {"JPEG", kJpeg, false, false, PassRoom::None, "\xFF\xD9", kMostAtOnce, &whole<&jpeg>},
    {"TIFF", kTiff, true, false, PassRoom::None, "", kMostAtOnce, &whole<&tiff>},
    {"WebP", kWebp, true, false, PassRoom::None, "", 16383,
     &whole<&webp>}, // the format's own limit
    {"OpenEXR", kExr, true, true, PassRoom::Layers, "", kMostAtOnce, &whole<&linear>}};

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
