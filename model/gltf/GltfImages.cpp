// SPDX-License-Identifier: MIT
#include "model/gltf/GltfImages.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <string_view>

#include <QtCore/QBuffer>
#include <QtCore/QByteArray>
#include <QtGui/QImage>
#include <QtGui/QImageReader>

#include "model/base/Result.h"
#include "model/gltf/GltfContainer.h"
#include "model/gltf/GltfJson.h"
#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

/// By the first bytes; empty for what is none of the formats that glTF may hold. Nothing else gets
/// to a decoder, of which Qt has many.
QByteArray formatOf(std::span<const std::uint8_t> bytes)
{
    const std::string_view head(reinterpret_cast<const char*>(bytes.data()),
                                std::min<std::size_t>(bytes.size(), 12));
    if (head.starts_with("\x89PNG\r\n\x1a\n")) {
        return "png";
    }
    if (head.starts_with("\xFF\xD8\xFF")) {
        return "jpeg";
    }
    return head.starts_with("RIFF") && head.ends_with("WEBP") ? "webp" : QByteArray();
}

/// The size is asked for before anything is decoded. `pixelsLeft` bounds what may be allocated.
Result<Image> decode(std::span<const std::uint8_t> bytes, std::uint64_t pixelsLeft)
{
    const QByteArray format = formatOf(bytes);
    if (format.isEmpty()) {
        return Error{QT_TRANSLATE_NOOP(
            "Messages", "it is not a picture that can be read (PNG, JPEG and WebP can)")};
    }
    QByteArray data = QByteArray::fromRawData(reinterpret_cast<const char*>(bytes.data()),
                                              static_cast<qsizetype>(bytes.size()));
    QBuffer buffer(&data);
    buffer.open(QIODevice::ReadOnly);
    QImageReader reader(&buffer, format);
    reader.setAutoDetectImageFormat(false);
    reader.setAutoTransform(false);
    const QSize size = reader.size();
    if (!reader.canRead() || !size.isValid()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "it cannot be decoded: %1"),
                     reader.errorString().toStdString()};
    }
    const auto pixels =
        static_cast<std::uint64_t>(size.width()) * static_cast<std::uint64_t>(size.height());
    if (std::max(size.width(), size.height()) > kMaxImageSide || pixels > pixelsLeft) {
        return Error{QT_TRANSLATE_NOOP("Messages", "it is too large (%1 x %2 pixels)"),
                     size.width(), size.height()};
    }
    QImage picture;
    if (!reader.read(&picture)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "it cannot be decoded: %1"),
                     reader.errorString().toStdString()};
    }
    picture.convertTo(QImage::Format_RGBA8888);
    Image image;
    image.width = picture.width();
    image.height = picture.height();
    const std::size_t row = static_cast<std::size_t>(image.width) * 4;
    image.rgba.resize(row * static_cast<std::size_t>(image.height));
    for (int y = 0; y < image.height; ++y) {
        std::memcpy(image.rgba.data() + row * static_cast<std::size_t>(y), picture.constScanLine(y),
                    row);
    }
    return image;
}

/// Images that a texture may show, the first that can be decoded: the plain one, then WebP.
std::vector<int> sourcesOf(const tinygltf::Texture& texture)
{
    std::vector<int> sources;
    if (texture.source >= 0) {
        sources.push_back(texture.source);
    }
    const tinygltf::Value* webp = find(texture.extensions, "EXT_texture_webp");
    if (const int image = webp == nullptr ? -1 : wholeIn(*webp, "source", -1); image >= 0) {
        sources.push_back(image);
    }
    return sources;
}

glm::vec4 meanOf(const Image& image)
{
    std::array<std::uint64_t, 4> sums{};
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        sums[i % 4] += image.rgba[i];
    }
    const std::size_t pixels = std::max<std::size_t>(image.rgba.size() / 4, 1);
    const double all = 255.0 * static_cast<double>(pixels);
    glm::vec4 mean(0.0F);
    for (int i = 0; i < 4; ++i) {
        mean[i] = static_cast<float>(static_cast<double>(sums[static_cast<std::size_t>(i)]) / all);
    }
    return mean;
}

} // namespace

ImageTable::ImageTable(const GltfFile& file, std::vector<Message>& warnings)
    : m_file(file), m_warnings(warnings)
{
}

int ImageTable::fromTexture(int texture)
{
    if (texture < 0) {
        return -1;
    }
    const std::vector<int> sources =
        sourcesOf(m_file.model->textures[static_cast<std::size_t>(texture)]);
    for (const int source : sources) {
        if (const int image = fromImage(source); image >= 0) {
            return image;
        }
    }
    if (sources.empty() && m_withoutPicture.insert(texture).second) {
        m_warnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages", "%1 has no PNG, JPEG or WebP picture and is left out."),
            place("textures", static_cast<std::size_t>(texture)));
    }
    return -1;
}

/// Each is read when it is asked for and let go when it is decoded, so that a file that names many
/// takes no more memory than one.
Result<Image> ImageTable::read(const ImageSource& source, Taken& taken)
{
    Bytes loaded;
    std::span<const std::uint8_t> bytes;
    if (source.buffer >= 0) {
        const auto& buffer = m_file.model->buffers[static_cast<std::size_t>(source.buffer)].data;
        bytes = std::span(buffer).subspan(source.offset, source.length);
    } else if (source.uri.empty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "it has neither uri nor bufferView")};
    } else {
        Result<Bytes> read = readUri(source.uri, m_file.folder);
        if (!read) {
            return read.error();
        }
        loaded = std::move(read).value();
        bytes = loaded;
    }
    taken.encodedBytes += bytes.size();
    if (taken.encodedBytes > kMaxEncodedBytes) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "the pictures are larger than 512 MiB together")};
    }
    Result<Image> image = decode(bytes, kMaxImagePixels - taken.pixels);
    taken.pixels += image ? image.value().rgba.size() / 4 : 0;
    return image;
}

std::optional<Image> ImageTable::readOrWarn(int index, Taken& taken)
{
    const ImageSource& from = m_file.images[static_cast<std::size_t>(index)];
    Result<Image> image = read(from, taken);
    if (image) {
        image.value().name = from.name;
        return std::move(image).value();
    }
    const std::string where = place("images", static_cast<std::size_t>(index));
    m_warnings.emplace_back(QT_TRANSLATE_NOOP("Messages", "%1 is left out: %2."),
                            from.name.empty() ? where : where + " \"" + from.name + '"',
                            image.error().said);
    return std::nullopt;
}

int ImageTable::fromImage(int index)
{
    const auto [known, isNew] = m_ofFileImage.try_emplace(index, -1);
    if (!isNew) {
        return known->second;
    }
    if (std::optional<Image> image = readOrWarn(index, m_kept)) {
        known->second = static_cast<int>(m_images.size());
        m_images.push_back(std::move(*image));
    }
    return known->second;
}

std::optional<glm::vec4> ImageTable::meanOf(int texture)
{
    const auto& textures = m_file.model->textures;
    if (texture < 0 || static_cast<std::size_t>(texture) >= textures.size()) {
        return std::nullopt;
    }
    for (const int source : sourcesOf(textures[static_cast<std::size_t>(texture)])) {
        if (const std::optional<glm::vec4> mean = meanOfImage(source)) {
            return mean;
        }
    }
    return std::nullopt;
}

std::optional<glm::vec4> ImageTable::meanOfImage(int index)
{
    const auto [known, isNew] = m_means.try_emplace(index);
    if (!isNew) {
        return known->second;
    }
    const auto kept = m_ofFileImage.find(index);
    if (kept != m_ofFileImage.end()) { // told of already, where it cannot be read
        if (kept->second >= 0) {
            known->second = gltf::meanOf(m_images[static_cast<std::size_t>(kept->second)]);
        }
    } else if (const std::optional<Image> image = readOrWarn(index, m_passing)) {
        known->second = gltf::meanOf(*image);
    }
    return known->second;
}

} // namespace crowd::model::gltf
