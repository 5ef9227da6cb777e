// SPDX-License-Identifier: MIT
#include "model/project/LocateAssets.h"

#include <algorithm>

#include <QtCore/QFileInfo>
#include <QtCore/QStringList>

#include "model/project/AssetPaths.h"

namespace crowd::model {

namespace {

template<class Entry>
void addMissing(const std::vector<Entry>& entries, bool isStage, std::vector<MissingAsset>& missing)
{
    for (const Entry& entry : entries) {
        if (!entry.asset && !entry.problem.empty()) {
            missing.push_back({isStage, entry.id, entry.name, entry.path, entry.problem});
        }
    }
}

QStringList partsOf(const std::string& path)
{
    return QString::fromStdString(path).split(QLatin1Char('/'));
}

} // namespace

std::vector<MissingAsset> missingAssets(const Scene& scene)
{
    std::vector<MissingAsset> missing;
    addMissing(scene.stages, true, missing);
    addMissing(scene.templates, false, missing);
    return missing;
}

std::vector<std::string> missingFromPictures(const Scene& scene)
{
    const auto used = scene.population.column(columns::templateId);
    std::vector<std::string> missing;
    for (const MissingAsset& each : missingAssets(scene)) {
        if (each.isStage) {
            missing.push_back("stage \"" + each.name + "\". " + each.problem.english());
            continue;
        }
        const auto people = std::ranges::count(used, each.id);
        if (people > 0) {
            missing.push_back("character \"" + each.name + "\", of whom there are " +
                              std::to_string(people) + ". " + each.problem.english());
        }
    }
    return missing;
}

std::string movedAlong(const std::string& missingPath, const std::string& oldPath,
                       const std::string& newPath)
{
    if (isBuiltin(missingPath)) {
        return {};
    }
    QStringList from = partsOf(oldPath);
    QStringList to = partsOf(newPath);
    const QStringList wanted = partsOf(missingPath);
    const QString beside = QFileInfo(QString::fromStdString(newPath)).absolutePath() +
                           QLatin1Char('/') + wanted.back();
    if (QFileInfo(beside).isFile()) {
        return beside.toStdString();
    }
    while (!from.isEmpty() && !to.isEmpty() && from.back() == to.back()) {
        from.removeLast();
        to.removeLast();
    }
    if (wanted.size() <= from.size() || wanted.mid(0, from.size()) != from) {
        return {};
    }
    const QString moved = (to + wanted.mid(from.size())).join(QLatin1Char('/'));
    return QFileInfo(moved).isFile() ? moved.toStdString() : std::string();
}

} // namespace crowd::model
