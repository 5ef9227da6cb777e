// SPDX-License-Identifier: MIT
#include "model/project/BrushPreset.h"

#include <algorithm>

#include <QtCore/QFile>
#include <nlohmann/json.hpp>

#include "model/base/ShownText.h"
#include "model/brush/BrushJson.h"
#include "model/project/UserFolder.h"
#include "model/project/WholeFile.h"

namespace crowd::model {

using nlohmann::json;

namespace {

constexpr const char* kFormat = "crowdbrush brush";
constexpr int kVersion = 1;
constexpr qint64 kMostBytes = 1 << 20; ///< no preset is larger

std::string textIn(const json& content, const char* key)
{
    const auto found = content.find(key);
    return found != content.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Result<void> checkVersion(const json& content, const std::string& path)
{
    const auto version = content.find("version");
    if (version == content.end() || !version->is_number_integer() || *version < 1) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "%1: \"version\" must be %2. Copy the file again "
                                       "from where it came."),
                     path, kVersion};
    }
    if (*version != kVersion) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "%1 was written by a newer version; update to use it."),
            path};
    }
    return {};
}

Result<BrushPreset> presetIn(const json& content, const std::string& path)
{
    if (!content.is_object() || textIn(content, "format") != kFormat) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 is no brush preset. Choose a file that was "
                                                   "saved as one."),
                     path};
    }
    if (const auto known = checkVersion(content, path); !known) {
        return known.error();
    }
    const auto brush = content.find("brush");
    const auto sound = brushFromJson(brush != content.end() ? *brush : json());
    if (!sound) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be used: %2"), path,
                     sound.error().said};
    }
    BrushPreset preset;
    preset.name = QString::fromStdString(textIn(content, "name")).simplified();
    preset.kind = sound.value().kind();
    preset.json = brush->dump();
    if (preset.name.isEmpty()) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "%1 has no name. Write one into the file, as its "
                                       "member \"name\"."),
                     path};
    }
    return preset;
}

/// The whole content, or where it stops being JSON.
Result<json> parsed(const QByteArray& bytes, const std::string& path)
{
    try {
        return json::parse(bytes.begin(), bytes.end());
    } catch (const json::exception& problem) {
        const auto* broken = dynamic_cast<const json::parse_error*>(&problem);
        const auto read = static_cast<std::ptrdiff_t>(broken != nullptr ? broken->byte : 0);
        const auto* end = bytes.begin() + std::min<std::ptrdiff_t>(read, bytes.size());
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 is damaged: in line %2 it is no JSON any "
                                                   "more. Copy the file again from where it came."),
                     path, std::count(bytes.begin(), end, '\n') + 1};
    }
}

} // namespace

QString presetFolder()
{
    return userFolder() + QStringLiteral("/brushes");
}

BrushPreset presetOf(const QString& name, const BrushSettings& brush)
{
    return {name.simplified(), {}, brush.kind(), brushJson(brush, BrushFields::Portable).dump()};
}

BrushSettings applied(const BrushPreset& preset, const BrushSettings& now)
{
    return withRemembered(now, json::parse(preset.json, nullptr, false), BrushFields::Portable);
}

Result<BrushPreset> readPreset(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be read: %2"), path.toStdString(),
                     file.errorString().toStdString()};
    }
    const QByteArray bytes = file.read(kMostBytes + 1);
    if (bytes.size() > kMostBytes) {
        return presetIn({}, path.toStdString());
    }
    const auto content = parsed(bytes, path.toStdString());
    if (!content) {
        return content.error();
    }
    auto preset = presetIn(content.value(), path.toStdString());
    if (preset) {
        preset.value().file = path;
    }
    return preset;
}

Result<void> writePreset(const BrushPreset& preset, const QString& path)
{
    if (preset.name.isEmpty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "A preset needs a name.")};
    }
    const json content{{"format", kFormat},
                       {"version", kVersion},
                       {"name", preset.name.toStdString()},
                       {"brush", json::parse(preset.json)}};
    const auto written = writeWholeFile(path, content.dump(2) + "\n");
    if (!written) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2"), path.toStdString(),
                     written.error().said};
    }
    return {};
}

} // namespace crowd::model
