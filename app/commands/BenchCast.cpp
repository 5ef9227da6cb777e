// SPDX-License-Identifier: MIT
#include "app/commands/BenchCast.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtGui/QImage>

#include "app/commands/BenchReport.h"
#include "model/gltf/GltfImport.h"
#include "model/project/AssetPaths.h"

namespace crowd::app {

namespace {

constexpr qsizetype kHeader = 20; ///< of a .glb and its first chunk
constexpr qsizetype kChunkHeader = 8;

double millisecondsSince(std::chrono::steady_clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Bytes, JSON and pictures of one .glb; the number of bytes, 0 if it is none.
std::size_t readAtLeast(const QString& path)
{
    QFile file(path);
    const QByteArray bytes = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    std::uint32_t length = 0;
    if (bytes.size() < kHeader) {
        return 0;
    }
    std::memcpy(&length, bytes.constData() + 12, sizeof length);
    const qsizetype binary = kHeader + static_cast<qsizetype>(length) + kChunkHeader;
    if (binary > bytes.size()) {
        return 0;
    }
    const char* text = bytes.constData() + kHeader;
    const auto document = nlohmann::json::parse(text, text + length, nullptr, false);
    if (document.is_discarded()) {
        return 0;
    }
    for (const auto& image : document.value("images", nlohmann::json::array())) {
        const auto& view = document["bufferViews"][image.value("bufferView", 0U)];
        const QByteArray picture = bytes.mid(binary + view.value("byteOffset", 0),
                                             static_cast<qsizetype>(view.value("byteLength", 0)));
        if (QImage::fromData(picture).isNull()) {
            return 0;
        }
    }
    return static_cast<std::size_t>(bytes.size());
}

} // namespace

model::Result<CastTimes> timeCast(int rounds)
{
    const QDir folder(model::builtinFolder() + QStringLiteral("/templates"));
    const QStringList names = folder.entryList({QStringLiteral("*.glb")}, QDir::Files, QDir::Name);
    CastTimes times;
    times.templates = static_cast<std::size_t>(names.size());
    std::vector<double> load;
    std::vector<double> floor;
    for (int round = 0; round < rounds; ++round) {
        auto start = std::chrono::steady_clock::now();
        for (const QString& name : names) {
            const auto asset = model::importTemplate(folder.filePath(name).toStdString());
            if (!asset) {
                return asset.error();
            }
        }
        load.push_back(millisecondsSince(start));
        start = std::chrono::steady_clock::now();
        times.bytes = 0;
        for (const QString& name : names) {
            const std::size_t size = readAtLeast(folder.filePath(name));
            if (size == 0) {
                return model::Error{folder.filePath(name).toStdString() + ": is no .glb file"};
            }
            times.bytes += size;
        }
        floor.push_back(millisecondsSince(start));
    }
    times.loadMs = load.empty() ? 0.0 : rounded(median(load));
    times.floorMs = floor.empty() ? 0.0 : rounded(median(floor));
    return times;
}

} // namespace crowd::app
