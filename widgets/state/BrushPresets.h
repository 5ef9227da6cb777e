// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <QtCore/QFileSystemWatcher>
#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QStringList>

#include "model/base/Result.h"
#include "model/project/PresetFolder.h"

namespace crowd::widgets {

using model::BrushPreset;

/// Brushes that the artist keeps, as the panel shows them. Follows the folder: scripts and other
/// programs write into it too. Main thread.
class BrushPresets : public QObject
{
    Q_OBJECT

public:
    /// `folder` need not be there.
    explicit BrushPresets(QString folder, QObject* parent = nullptr);

    /// By name.
    [[nodiscard]] const std::vector<BrushPreset>& all() const { return m_folder.all(); }
    /// Files of the folder that could not be read, with why; for the artist.
    [[nodiscard]] QStringList problems() const;
    /// Reads the folder again.
    void reload();

    [[nodiscard]] QString freeName(const QString& like) const { return m_folder.freeName(like); }
    // As those of PresetFolder.
    [[nodiscard]] model::Result<void> save(const QString& name, const model::BrushSettings& brush);
    [[nodiscard]] model::Result<void> rename(const QString& name, const QString& newName);
    [[nodiscard]] model::Result<void> remove(const QString& name);
    [[nodiscard]] model::Result<QString> importFile(const QString& path);
    [[nodiscard]] model::Result<void> exportFile(const QString& name, const QString& path) const;

    [[nodiscard]] const BrushPreset* find(const QString& name) const { return m_folder.find(name); }

Q_SIGNALS:
    void changed();

private:
    void watch();
    void follow();

    model::PresetFolder m_folder;
    QFileSystemWatcher m_watcher;
};

} // namespace crowd::widgets
