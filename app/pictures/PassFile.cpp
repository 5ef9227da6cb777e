// SPDX-License-Identifier: MIT
#include "app/pictures/PassFile.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <QtCore/QFileInfo>

#include "app/pictures/PictureFile.h"
#include "app/pictures/PictureFormats.h"
#include "app/pictures/PngStream.h"
#include "model/project/WholeFile.h"

namespace crowd::app {

namespace {

PassRoom roomOf(const QString& path)
{
    const PictureFormat* format = pictureFormatOf(path);
    return format != nullptr ? format->passes : PassRoom::None;
}

/// f_0001.png → f_0001.depth.png
QString fileOfPass(const QString& path, const PicturePass& pass)
{
    if (pass.need == PassNeed::Colours) {
        return path;
    }
    const QString ending = QLatin1Char('.') + QFileInfo(path).suffix();
    return path.left(path.size() - ending.size()) + QLatin1Char('.') +
           QString::fromUtf8(pass.key.data(), static_cast<qsizetype>(pass.key.size())) + ending;
}

model::Result<void> encodeSamples(const PassSamples& samples, glm::ivec2 size, ByteSink sink)
{
    PngStream png({size, samples.channels, 16}, std::move(sink));
    const auto count =
        static_cast<std::size_t>(size.x) * static_cast<std::size_t>(samples.channels);
    model::Result<void> added;
    for (std::size_t first = 0; first + count <= samples.values.size() && added; first += count) {
        added = png.add(std::span(samples.values).subspan(first, count));
    }
    return added ? png.finish() : added;
}

model::Result<void> writeSamples(const QString& path, const PassSamples& samples, glm::ivec2 size)
{
    std::string bytes;
    const auto encoded =
        encodeSamples(samples, size, [&bytes](std::string_view more) -> model::Result<void> {
            bytes += more;
            return {};
        });
    if (!encoded) {
        return pictureNotMade(path, encoded.error());
    }
    const auto written = model::writeWholeFile(path, bytes);
    return written ? written : pictureNotWritten(path, written.error());
}

} // namespace

model::Result<void> roomForPasses(const QString& path, const PicturePasses& passes)
{
    const PassRoom room = roomOf(path);
    if (room == PassRoom::None) {
        return model::Error{QT_TRANSLATE_NOOP("Messages", "%1 has no room for passes: let the name "
                                                          "end in .exr or .png."),
                            path.toStdString()};
    }
    for (const PicturePass* pass : passes) {
        const bool isPossible =
            room == PassRoom::Layers || pass->need == PassNeed::Colours || pass->samples != nullptr;
        if (!isPossible) {
            return model::Error{
                QT_TRANSLATE_NOOP("Messages", "%1: only OpenEXR has room for the pass \"%2\". Let "
                                              "the name end in .exr, or leave that pass away."),
                path.toStdString(), std::string(pass->key)};
        }
    }
    return {};
}

QStringList passFiles(const QString& path, const PicturePasses& passes)
{
    if (passes.empty() || roomOf(path) != PassRoom::FilesEach) {
        return {path};
    }
    QStringList files;
    for (const PicturePass* pass : passes) {
        files << fileOfPass(path, *pass);
    }
    return files;
}

bool arePassesThere(const QString& path, const PicturePasses& passes, glm::ivec2 size)
{
    const QStringList files = passFiles(path, passes);
    return std::ranges::all_of(files,
                               [size](const QString& file) { return isPictureThere(file, size); });
}

model::Result<void> writePasses(const QString& path, const DrawnPasses& drawn)
{
    if (auto room = roomForPasses(path, drawn.passes); !room) {
        return room;
    }
    if (roomOf(path) == PassRoom::Layers) {
        return writeLayers(path, drawn.header, drawn.layers);
    }
    model::Result<void> written;
    for (std::size_t i = 0; i < drawn.passes.size() && written; ++i) {
        const PicturePass& pass = *drawn.passes[i];
        const QString file = fileOfPass(path, pass);
        written = pass.need == PassNeed::Colours
                      ? writePicture(file, drawn.colours, drawn.header.size, drawn.isTransparent)
                      : writeSamples(file, pass.samples(drawn.layers[i]), drawn.header.size);
    }
    return written;
}

} // namespace crowd::app
