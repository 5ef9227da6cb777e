// SPDX-License-Identifier: MIT
#include "app/pictures/ExrFile.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <exception>
#include <list>
#include <stdexcept>
#include <utility>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <QtCore/QFile>

#include "model/base/Color.h"

namespace crowd::app {

namespace {

/// A file in memory: it goes to the disk as a whole.
class MemoryStream : public Imf::OStream
{
public:
    MemoryStream() : Imf::OStream("picture") {}

    void write(const char bytes[], int count) override
    {
        const qsizetype end = m_place + count;
        if (m_bytes.size() < end) {
            m_bytes.resize(end);
        }
        std::memcpy(m_bytes.data() + m_place, bytes, static_cast<std::size_t>(count));
        m_place = end;
    }
    uint64_t tellp() override { return static_cast<uint64_t>(m_place); }
    void seekp(uint64_t place) override { m_place = static_cast<qsizetype>(place); }
    [[nodiscard]] QByteArray bytes() const { return m_bytes; }

private:
    QByteArray m_bytes;
    qsizetype m_place = 0;
};

Imf::PixelType typeOf(const ExrChannel& channel)
{
    if (!std::holds_alternative<std::vector<float>>(channel.values)) {
        return Imf::UINT;
    }
    return channel.isHalf ? Imf::HALF : Imf::FLOAT;
}

/// Its vectors are of rows, ours of columns: in memory they are the same.
Imath::M44f transposed(const glm::mat4& matrix)
{
    Imath::M44f other;
    std::memcpy(other.getValue(), &matrix[0][0], sizeof(float) * 16);
    return other;
}

Imf::Header headerOf(const ExrHeader& common, const ExrLayer& layer)
{
    Imf::Header header(common.size.x, common.size.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.setName(layer.name);
    header.setType(Imf::SCANLINEIMAGE);
    for (const ExrChannel& channel : layer.channels) {
        header.channels().insert(channel.name, Imf::Channel(typeOf(channel)));
    }
    if (common.cameraFromWorld) {
        Imf::addWorldToCamera(header, transposed(*common.cameraFromWorld));
    }
    if (common.screenFromWorld) {
        Imf::addWorldToNDC(header, transposed(*common.screenFromWorld));
    }
    return header;
}

/// The channels of a layer as the library reads them, which writes to nothing.
class LayerBuffer
{
public:
    LayerBuffer(const ExrLayer& layer, glm::ivec2 size)
    {
        for (const ExrChannel& channel : layer.channels) {
            add(channel, static_cast<std::size_t>(size.x));
        }
    }
    [[nodiscard]] const Imf::FrameBuffer& buffer() const { return m_buffer; }

private:
    void add(const ExrChannel& channel, std::size_t width)
    {
        if (const auto* ids = std::get_if<std::vector<std::uint32_t>>(&channel.values)) {
            insert(channel, *ids, width);
            return;
        }
        const auto& values = std::get<std::vector<float>>(channel.values);
        if (!channel.isHalf) {
            insert(channel, values, width);
            return;
        }
        std::vector<Imath::half>& halves = m_halves.emplace_back();
        halves.reserve(values.size());
        for (const float value : values) {
            halves.emplace_back(value);
        }
        insert(channel, halves, width);
    }
    template<class T>
    void insert(const ExrChannel& channel, const std::vector<T>& values, std::size_t width)
    {
        // NOLINTNEXTLINE(cppcoreguidelines-pro-type-const-cast): what is written is only read
        char* base = const_cast<char*>(reinterpret_cast<const char*>(values.data()));
        m_buffer.insert(channel.name,
                        Imf::Slice(typeOf(channel), base, sizeof(T), sizeof(T) * width));
    }

    std::list<std::vector<Imath::half>> m_halves; ///< the buffer points into them
    Imf::FrameBuffer m_buffer;
};

QByteArray exrBytes(const ExrHeader& header, std::span<const ExrLayer> layers)
{
    std::vector<Imf::Header> headers;
    headers.reserve(layers.size());
    if (layers.empty()) {
        throw std::invalid_argument("there is no layer");
    }
    for (const ExrLayer& layer : layers) {
        headers.push_back(headerOf(header, layer));
    }
    for (const auto& [name, text] : header.notes) { // where everybody looks for them, and but once
        headers.front().insert(name, Imf::StringAttribute(text));
    }
    MemoryStream stream;
    {
        Imf::MultiPartOutputFile file(stream, headers.data(), static_cast<int>(headers.size()));
        for (std::size_t i = 0; i < layers.size(); ++i) {
            const LayerBuffer pixels(layers[i], header.size);
            Imf::OutputPart part(file, static_cast<int>(i));
            part.setFrameBuffer(pixels.buffer());
            part.writePixels(header.size.y);
        }
    } // it completes its tables as it goes
    return stream.bytes();
}

constexpr std::size_t kAlpha = 3;

/// value(pixel, channel)
template<class Value>
ExrLayer colours(std::size_t pixels, bool isTransparent, const Value& value)
{
    constexpr std::array kNames{"R", "G", "B", "A"};
    ExrLayer layer{"rgba", {}};
    for (std::size_t channel = 0; channel < kNames.size(); ++channel) {
        std::vector<float> values;
        values.reserve(pixels);
        for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
            const bool saysNothing = channel == kAlpha && !isTransparent;
            values.push_back(saysNothing ? 1.0F : value(pixel, channel));
        }
        layer.channels.push_back({kNames[channel], std::move(values), true});
    }
    return layer;
}

} // namespace

ExrLayer colourLayer(std::span<const std::uint8_t> rgba, bool isTransparent)
{
    constexpr float kMost = 255.0F;
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) {
        linear[i] = model::linearFromSrgb(static_cast<float>(i) / kMost);
    }
    return colours(rgba.size() / 4, isTransparent, [&](std::size_t pixel, std::size_t channel) {
        const std::uint8_t byte = rgba[pixel * 4 + channel];
        return channel == kAlpha ? static_cast<float>(byte) / kMost : linear[byte];
    });
}

ExrLayer deepColourLayer(std::span<const std::uint8_t> halves, bool isTransparent)
{
    constexpr std::size_t kBytes = sizeof(std::uint16_t);
    return colours(halves.size() / (4 * kBytes), isTransparent,
                   [&](std::size_t pixel, std::size_t channel) {
                       std::uint16_t bits = 0;
                       std::memcpy(&bits, &halves[(pixel * 4 + channel) * kBytes], kBytes);
                       Imath::half value;
                       value.setBits(bits);
                       return static_cast<float>(value);
                   });
}

model::Result<QByteArray> encodeExr(const ExrHeader& header, std::span<const ExrLayer> layers)
{
    try {
        return exrBytes(header, layers);
    } catch (const std::exception& error) { // the library says so what it cannot do
        return model::Error{std::string(error.what())};
    }
}

bool isWholeExr(const QString& path, glm::ivec2 size)
{
    try {
        Imf::MultiPartInputFile file(QFile::encodeName(path).constData());
        for (int part = 0; part < file.parts(); ++part) {
            const Imath::Box2i& window = file.header(part).dataWindow();
            if (window.size() != Imath::V2i(size.x - 1, size.y - 1) || !file.partComplete(part)) {
                return false;
            }
            const char* lines =
                nullptr; // complete is what has all its lines, also of a file cut off
            int bytes = 0;
            Imf::InputPart(file, part).rawPixelData(window.max.y, lines, bytes);
        }
        return file.parts() > 0;
    } catch (const std::exception&) { // it is none
        return false;
    }
}

} // namespace crowd::app
