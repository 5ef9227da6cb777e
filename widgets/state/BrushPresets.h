// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QtCore/QObject>
#include <QtCore/QString>
#include <QtCore/QStringList>

#include "model/base/Result.h"
#include "model/brush/BrushSettings.h"

namespace crowd::widgets {

/// A brush kept under a name. Words of the name that begin with # are tags.
struct BrushPreset
{
    QString name; ///< with its tags
    QString file;
    model::BrushKind kind = model::BrushKind::Create;
    std::string json; ///< of the brush; what means something in one scene alone is not in it
};

/// Brushes that the artist keeps, one file each in a folder of the user. A file that is broken or
/// of a newer version is left alone and named. Main thread.
class BrushPresets : public QObject
{
    Q_OBJECT

public:
    /// `folder` need not be there.
    explicit BrushPresets(QString folder, QObject* parent = nullptr);

    /// By name.
    [[nodiscard]] const std::vector<BrushPreset>& all() const { return m_presets; }
    /// Files of the folder that could not be read, with why; for the artist.
    [[nodiscard]] const QStringList& problems() const { return m_problems; }
    /// Reads the folder again.
    void reload();

    /// A name like this that no preset has.
    [[nodiscard]] QString freeName(const QString& like) const;
    /// Keeps a brush; takes the place of the preset with the same name.
    [[nodiscard]] model::Result<void> save(const QString& name, const model::BrushSettings& brush);
    /// Fails where another has that name.
    [[nodiscard]] model::Result<void> rename(const QString& name, const QString& newName);
    [[nodiscard]] model::Result<void> remove(const QString& name);
    /// Takes a preset of somebody else in; the name that it has here. A copy of what is there
    /// already is not taken twice.
    [[nodiscard]] model::Result<QString> importFile(const QString& path);
    [[nodiscard]] model::Result<void> exportFile(const QString& name, const QString& path) const;

    [[nodiscard]] const BrushPreset* find(const QString& name) const;
    /// The brush as it is kept; what the preset does not say is as in `now`, of the same kind.
    [[nodiscard]] static model::BrushSettings applied(const BrushPreset& preset,
                                                      const model::BrushSettings& now);

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] QString freeFile(const QString& name) const;
    [[nodiscard]] model::Result<void> write(const BrushPreset& preset, const QString& path) const;

    QString m_folder;
    std::vector<BrushPreset> m_presets;
    QStringList m_problems;
};

} // namespace crowd::widgets
