// SPDX-License-Identifier: MIT
#include "widgets/state/BrushPresets.h"

#include <utility>

#include <QtCore/QDir>

#include "model/base/Translated.h"

namespace crowd::widgets {

using model::Result;

BrushPresets::BrushPresets(QString folder, QObject* parent)
    : QObject(parent), m_folder(std::move(folder))
{
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, &BrushPresets::follow);
    QDir().mkpath(m_folder.path()); // what is not there cannot be watched
    watch();
}

void BrushPresets::watch()
{
    if (m_watcher.directories().isEmpty() && QDir(m_folder.path()).exists()) {
        m_watcher.addPath(m_folder.path());
    }
}

QStringList BrushPresets::problems() const
{
    QStringList texts;
    for (const model::Message& problem : m_folder.problems()) {
        texts << model::translated(problem);
    }
    return texts;
}

void BrushPresets::reload()
{
    m_folder.reload();
    watch();
    Q_EMIT changed();
}

/// What was written from here is known already: a name that is being typed stays open.
void BrushPresets::follow()
{
    const std::vector<BrushPreset> presets = m_folder.all();
    const std::vector<model::Message> problems = m_folder.problems();
    m_folder.reload();
    if (presets != m_folder.all() || problems != m_folder.problems()) {
        Q_EMIT changed();
    }
}

Result<void> BrushPresets::save(const QString& name, const model::BrushSettings& brush)
{
    auto saved = m_folder.save(name, brush);
    reload();
    return saved;
}

Result<void> BrushPresets::rename(const QString& name, const QString& newName)
{
    auto renamed = m_folder.rename(name, newName);
    if (renamed && name != newName) {
        reload();
    }
    return renamed;
}

Result<void> BrushPresets::remove(const QString& name)
{
    auto removed = m_folder.remove(name);
    if (removed) {
        reload();
    }
    return removed;
}

Result<QString> BrushPresets::importFile(const QString& path)
{
    auto taken = m_folder.importFile(path);
    if (taken) {
        reload();
    }
    return taken;
}

Result<void> BrushPresets::exportFile(const QString& name, const QString& path) const
{
    const BrushPreset* preset = find(name);
    return preset != nullptr ? model::writePreset(*preset, path) : Result<void>();
}

} // namespace crowd::widgets
