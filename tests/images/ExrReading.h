// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>

#include <QtCore/QString>

/// OpenEXR files as any other program reads them.
namespace crowd::testing {

/// "part: channel channel" of each.
inline std::vector<std::string> exrParts(const QString& path)
{
    const Imf::MultiPartInputFile file(qPrintable(path));
    std::vector<std::string> parts;
    for (int i = 0; i < file.parts(); ++i) {
        std::string text = file.header(i).name() + ":";
        const Imf::ChannelList& channels = file.header(i).channels();
        for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
            text += std::string(" ") + channel.name();
        }
        parts.push_back(text);
    }
    return parts;
}

/// One channel, converted to what is asked for.
template<class T>
std::vector<T> exrValues(const QString& path, int part, const std::string& channel, int width,
                         int height, Imf::PixelType type)
{
    Imf::MultiPartInputFile file(qPrintable(path));
    Imf::InputPart input(file, part);
    std::vector<T> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    Imf::FrameBuffer buffer;
    buffer.insert(channel, Imf::Slice(type, reinterpret_cast<char*>(values.data()), sizeof(T),
                                      sizeof(T) * static_cast<std::size_t>(width)));
    input.setFrameBuffer(buffer);
    input.readPixels(0, height - 1);
    return values;
}

} // namespace crowd::testing
