// SPDX-License-Identifier: MIT
#include "model/project/PresetFolder.h"

#include <algorithm>

#include <QtCore/QDir>
#include <QtCore/QFile>
#include <QtCore/QFileInfo>
#include <QtCore/QStandardPaths>

#include "model/base/ShownText.h"

namespace crowd::model {

namespace {

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

} // namespace

PresetFolder::PresetFolder(QString folder) : m_path(std::move(folder))
{
    reload();
}

void PresetFolder::reload()
{
    m_presets.clear();
    m_problems.clear();
    const QDir folder(m_path);
    const QStringList files =
        folder.entryList({QStringLiteral("*") + QLatin1String(kEnding)}, QDir::Files, QDir::Name);
    for (const QString& file : files) {
        auto preset = readPreset(folder.filePath(file));
        if (!preset) {
            m_problems.push_back(preset.error().said);
        } else if (find(preset.value().name) == nullptr) {
            m_presets.push_back(std::move(preset).value());
        }
    }
    std::ranges::stable_sort(m_presets, [](const BrushPreset& a, const BrushPreset& b) {
        return QString::localeAwareCompare(a.name, b.name) < 0;
    });
}

const BrushPreset* PresetFolder::find(const QString& name) const
{
    const auto found = std::ranges::find(m_presets, name, &BrushPreset::name);
    return found == m_presets.end() ? nullptr : &*found;
}

QString PresetFolder::freeName(const QString& like) const
{
    QString name = like;
    for (int number = 2; find(name) != nullptr; ++number) {
        name = QStringLiteral("%1 %2").arg(like).arg(number);
    }
    return name;
}

QString PresetFolder::freeFile(const QString& name) const
{
    const QDir folder(m_path);
    QString path = folder.filePath(fileNameOf(name) + QLatin1String(kEnding));
    for (int number = 2; QFileInfo::exists(path); ++number) {
        path = folder.filePath(QStringLiteral("%1-%2%3")
                                   .arg(fileNameOf(name))
                                   .arg(number)
                                   .arg(QLatin1String(kEnding)));
    }
    return path;
}

Result<void> PresetFolder::make() const
{
    if (!QDir().mkpath(m_path)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "The folder %1 cannot be made."),
                     m_path.toStdString()};
    }
    return {};
}

Result<void> PresetFolder::save(const QString& name, const BrushSettings& brush)
{
    const BrushPreset preset = presetOf(name, brush);
    if (preset.name.isEmpty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "A preset needs a name.")};
    }
    if (auto made = make(); !made) {
        return made.error();
    }
    const BrushPreset* before = find(preset.name);
    auto written = writePreset(preset, before != nullptr ? before->file : freeFile(preset.name));
    reload();
    return written;
}

Result<void> PresetFolder::rename(const QString& name, const QString& newName)
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
                     shortened(wanted.toStdString())};
    }
    BrushPreset renamed = *preset;
    renamed.name = wanted;
    auto written = writePreset(renamed, renamed.file);
    reload();
    return written;
}

Result<void> PresetFolder::remove(const QString& name)
{
    const BrushPreset* preset = find(name);
    if (preset == nullptr) {
        return {};
    }
    // Qt takes the working directory for the trash of a user who has no folder for data yet.
    QDir().mkpath(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation));
    QFile file(preset->file);
    if (!file.moveToTrash() && !file.remove()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1 cannot be removed: %2"),
                     preset->file.toStdString(), file.errorString().toStdString()};
    }
    reload();
    return {};
}

Result<QString> PresetFolder::importFile(const QString& path)
{
    const auto read = readPreset(path);
    if (!read) {
        return read.error();
    }
    BrushPreset preset = read.value();
    const BrushPreset* same = find(preset.name);
    if (same != nullptr && same->json == preset.json) {
        return preset.name;
    }
    preset.name = freeName(preset.name);
    if (auto made = make(); !made) {
        return made.error();
    }
    if (auto written = writePreset(preset, freeFile(preset.name)); !written) {
        return written.error();
    }
    reload();
    return preset.name;
}

} // namespace crowd::model
