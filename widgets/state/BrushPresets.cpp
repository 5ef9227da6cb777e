// SPDX-License-Identifier: MIT
#include "widgets/state/BrushPresets.h"

#include <algorithm>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <nlohmann/json.hpp>

#include "model/base/ShownText.h"
#include "model/base/Translated.h"
#include "model/brush/BrushJson.h"
#include "model/project/WholeFile.h"

namespace crowd::widgets {

using model::BrushSettings;
using model::Error;
using model::Result;
using nlohmann::json;

namespace {

constexpr const char* kFormat = "crowdbrush brush";
constexpr int kVersion = 1;
constexpr qint64 kMostBytes = 1 << 20; ///< no preset is larger
const char* const kEnding = ".brush";

/// Names of files without what file systems mind.
QString fileNameOf(const QString& name)
{
    QString file;
    for (const QChar letter : name) {
        file += letter.isLetterOrNumber() ? letter.toLower() : QLatin1Char('-');
    }
    return file.left(40);
}

Result<BrushPreset> read(const json& content, const std::string& path)
{
    const auto text = [&content](const char* key) {
        const auto found = content.find(key);
        return found != content.end() && found->is_string() ? found->get<std::string>()
                                                            : std::string();
    };
    if (!content.is_object() || text("format") != kFormat) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 is no brush preset."), path};
    }
    const auto version = content.find("version");
    if (version == content.end() || !version->is_number_integer() || *version != kVersion) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "%1 was written by a newer version; update to use it."),
            path};
    }
    const auto brush = content.find("brush");
    const auto sound = model::brushFromJson(brush != content.end() ? *brush : json());
    if (!sound) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be used: %2"), path,
                     sound.error().said};
    }
    BrushPreset preset;
    preset.name = QString::fromStdString(text("name")).simplified();
    preset.kind = sound.value().kind();
    preset.json = brush->dump();
    if (preset.name.isEmpty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 has no name."), path};
    }
    return preset;
}

Result<BrushPreset> readFile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be read: %2"), path.toStdString(),
                     file.errorString().toStdString()};
    }
    const QByteArray bytes = file.read(kMostBytes + 1);
    const json content = bytes.size() > kMostBytes
                             ? json()
                             : json::parse(bytes.begin(), bytes.end(), nullptr, false);
    auto preset = read(content, path.toStdString());
    if (preset) {
        preset.value().file = path;
    }
    return preset;
}

} // namespace

BrushPresets::BrushPresets(QString folder, QObject* parent)
    : QObject(parent), m_folder(std::move(folder))
{
    reload();
}

void BrushPresets::reload()
{
    m_presets.clear();
    m_problems.clear();
    const QDir folder(m_folder);
    const QStringList files =
        folder.entryList({QStringLiteral("*") + QLatin1String(kEnding)}, QDir::Files, QDir::Name);
    for (const QString& file : files) {
        auto preset = readFile(folder.filePath(file));
        if (!preset) {
            m_problems << model::translated(preset.error());
        } else if (find(preset.value().name) == nullptr) {
            m_presets.push_back(std::move(preset).value());
        }
    }
    std::ranges::stable_sort(m_presets, [](const BrushPreset& a, const BrushPreset& b) {
        return QString::localeAwareCompare(a.name, b.name) < 0;
    });
    Q_EMIT changed();
}

const BrushPreset* BrushPresets::find(const QString& name) const
{
    const auto found = std::ranges::find(m_presets, name, &BrushPreset::name);
    return found == m_presets.end() ? nullptr : &*found;
}

QString BrushPresets::freeName(const QString& like) const
{
    QString name = like;
    for (int number = 2; find(name) != nullptr; ++number) {
        name = QStringLiteral("%1 %2").arg(like).arg(number);
    }
    return name;
}

QString BrushPresets::freeFile(const QString& name) const
{
    const QDir folder(m_folder);
    QString path = folder.filePath(fileNameOf(name) + QLatin1String(kEnding));
    for (int number = 2; QFileInfo::exists(path); ++number) {
        path = folder.filePath(QStringLiteral("%1-%2%3")
                                   .arg(fileNameOf(name))
                                   .arg(number)
                                   .arg(QLatin1String(kEnding)));
    }
    return path;
}

Result<void> BrushPresets::write(const BrushPreset& preset, const QString& path) const
{
    const json content{{"format", kFormat},
                       {"version", kVersion},
                       {"name", preset.name.toStdString()},
                       {"brush", json::parse(preset.json)}};
    const auto written = model::writeWholeFile(path, content.dump(2) + "\n");
    if (!written) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be written: %2"), path.toStdString(),
                     written.error().said};
    }
    return {};
}

Result<void> BrushPresets::save(const QString& name, const BrushSettings& brush)
{
    BrushPreset preset;
    preset.name = name.simplified();
    preset.kind = brush.kind();
    preset.json = model::brushJson(brush, model::BrushFields::Portable).dump();
    if (preset.name.isEmpty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "A preset needs a name.")};
    }
    if (!QDir().mkpath(m_folder)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "The folder %1 cannot be made."),
                     m_folder.toStdString()};
    }
    const BrushPreset* before = find(preset.name);
    auto written = write(preset, before != nullptr ? before->file : freeFile(preset.name));
    reload();
    return written;
}

Result<void> BrushPresets::rename(const QString& name, const QString& newName)
{
    const BrushPreset* preset = find(name);
    const QString wanted = newName.simplified();
    if (preset == nullptr || wanted == name) {
        return {};
    }
    if (wanted.isEmpty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "A preset needs a name.")};
    }
    if (find(wanted) != nullptr) {
        return Error{QT_TRANSLATE_NOOP("Messages", "There already is a preset %1."),
                     model::shortened(wanted.toStdString())};
    }
    BrushPreset renamed = *preset;
    renamed.name = wanted;
    auto written = write(renamed, renamed.file);
    reload();
    return written;
}

Result<void> BrushPresets::remove(const QString& name)
{
    const BrushPreset* preset = find(name);
    if (preset == nullptr) {
        return {};
    }
    QFile file(preset->file);
    if (!file.moveToTrash() && !file.remove()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be removed: %2"),
                     preset->file.toStdString(), file.errorString().toStdString()};
    }
    reload();
    return {};
}

Result<QString> BrushPresets::importFile(const QString& path)
{
    const auto read = readFile(path);
    if (!read) {
        return read.error();
    }
    BrushPreset preset = read.value();
    const BrushPreset* same = find(preset.name);
    if (same != nullptr && same->json == preset.json) {
        return preset.name;
    }
    preset.name = freeName(preset.name);
    if (!QDir().mkpath(m_folder)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "The folder %1 cannot be made."),
                     m_folder.toStdString()};
    }
    if (auto written = write(preset, freeFile(preset.name)); !written) {
        return written.error();
    }
    reload();
    return preset.name;
}

Result<void> BrushPresets::exportFile(const QString& name, const QString& path) const
{
    const BrushPreset* preset = find(name);
    return preset != nullptr ? write(*preset, path) : Result<void>();
}

BrushSettings BrushPresets::applied(const BrushPreset& preset, const BrushSettings& now)
{
    return model::withRemembered(now, json::parse(preset.json, nullptr, false),
                                 model::BrushFields::Portable);
}

} // namespace crowd::widgets
