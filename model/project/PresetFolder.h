// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "model/project/BrushPreset.h"

namespace crowd::model {

/// The presets of a folder, one file each. A file that is broken or of a newer version is left
/// alone and named. Holds what reload() found; whoever writes reads again. One thread at a time.
class PresetFolder
{
public:
    /// `folder` need not be there. Reads it.
    explicit PresetFolder(QString folder);

    [[nodiscard]] const QString& path() const { return m_path; }
    /// By name.
    [[nodiscard]] const std::vector<BrushPreset>& all() const { return m_presets; }
    /// Files that could not be read, with why.
    [[nodiscard]] const std::vector<Message>& problems() const { return m_problems; }
    /// Reads the folder again.
    void reload();

    [[nodiscard]] const BrushPreset* find(const QString& name) const;
    /// A name like this that no preset has.
    [[nodiscard]] QString freeName(const QString& like) const;
    /// Keeps a brush; takes the place of the preset with the same name.
    [[nodiscard]] Result<void> save(const QString& name, const BrushSettings& brush);
    /// Fails where another has that name.
    [[nodiscard]] Result<void> rename(const QString& name, const QString& newName);
    [[nodiscard]] Result<void> remove(const QString& name);
    /// Takes a preset of somebody else in; the name that it has here. A copy of what is there
    /// already is not taken twice.
    [[nodiscard]] Result<QString> importFile(const QString& path);

private:
    [[nodiscard]] Result<void> make() const;
    [[nodiscard]] QString freeFile(const QString& name) const;

    QString m_path;
    std::vector<BrushPreset> m_presets;
    std::vector<Message> m_problems;
};

} // namespace crowd::model
