// SPDX-License-Identifier: MIT
#include "app/commands/BenchIo.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

#include <nlohmann/json.hpp>

#include <QtCore/QFile>
#include <QtCore/QTemporaryDir>

#include "app/commands/BenchCast.h"
#include "app/commands/BenchReport.h"
#include "app/commands/BenchScene.h"
#include "app/commands/BenchStates.h"
#include "model/project/ProjectFile.h"
#include "model/states/StateKeeping.h"

namespace crowd::app {

namespace {

struct Times
{
    std::vector<double> saveMs;
    std::vector<double> loadMs;
    std::vector<double> parseFloorMs;
    std::vector<double> dumpFloorMs;
};

template<class Work>
double millisecondsOf(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Stands for a character: the file holds its path and clip names, nothing of its mesh.
model::TemplatePtr namesOnly(const char* name)
{
    auto asset = std::make_shared<model::Template>();
    asset->name = name;
    for (const char* clip : {"idle", "walk", "run", "sit", "sit_clap", "sit_cheer", "cheer"}) {
        asset->clips.emplace_back().name = clip;
    }
    return asset;
}

model::Scene sceneOf(int count)
{
    model::Scene scene = makeBenchField({namesOnly("man"), namesOnly("woman")}, count);
    for (model::TemplateEntry& entry : scene.templates) {
        entry.path = "builtin:templates/" + entry.name + ".glb";
    }
    return scene;
}

model::Result<std::string> bytesOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return model::Error{path.toStdString() + ": " + file.errorString().toStdString()};
    }
    return file.readAll().toStdString();
}

model::Result<void> timeFile(const model::Scene& scene, const QString& path, Times& times)
{
    model::Result<void> saved;
    times.saveMs.push_back(millisecondsOf([&] { saved = model::saveProject(scene, path); }));
    if (!saved) {
        return saved;
    }
    model::Result<model::Scene> loaded = model::Error{std::string()};
    times.loadMs.push_back(millisecondsOf([&] { loaded = model::readProject(path); }));
    if (!loaded) {
        return loaded.error();
    }
    if (!(loaded.value().population == scene.population)) {
        return model::Error{"The scene that was read is not the one that was written."};
    }
    return {};
}

model::Result<void> timeFloor(const std::string& bytes, Times& times)
{
    nlohmann::json tree;
    times.parseFloorMs.push_back(
        millisecondsOf([&] { tree = nlohmann::json::parse(bytes, nullptr, false); }));
    std::string text;
    times.dumpFloorMs.push_back(millisecondsOf([&] { text = tree.dump(); }));
    if (tree.is_discarded() || text.empty()) {
        return model::Error{"The JSON library cannot read the file that was written."};
    }
    return {};
}

/// With a state of everybody in what can be painted.
model::Scene sceneWithState(int count)
{
    model::Scene scene = sceneOf(count);
    shuffleLooks(scene, 1);
    scene.states.push_back(
        keepState(scene, "all", model::usualStateColumns(), scene.population.ids()));
    scene.states.back().id = 1;
    return scene;
}

model::Result<std::size_t> measure(const model::Scene& scene, int rounds, Times& times)
{
    const QTemporaryDir folder;
    if (!folder.isValid()) {
        return model::Error{"No temporary folder: " + folder.errorString().toStdString()};
    }
    const QString path = folder.filePath(QStringLiteral("bench.crowd"));
    std::size_t size = 0;
    for (int round = 0; round < rounds; ++round) {
        if (const auto file = timeFile(scene, path, times); !file) {
            return file.error();
        }
        const model::Result<std::string> bytes = bytesOf(path);
        if (!bytes) {
            return bytes.error();
        }
        if (const auto floor = timeFloor(bytes.value(), times); !floor) {
            return floor.error();
        }
        size = bytes.value().size();
    }
    return size;
}

} // namespace

int runBenchIo(const BenchIoOptions& options)
{
    Times times;
    const auto bytes = measure(sceneOf(options.count), options.rounds, times);
    if (!bytes) {
        std::cerr << bytes.error().message << '\n';
        return 1;
    }
    Times stateTimes;
    const auto stateBytes = measure(sceneWithState(options.count), options.rounds, stateTimes);
    if (!stateBytes) {
        std::cerr << stateBytes.error().message << '\n';
        return 1;
    }
    const model::Result<CastTimes> cast = timeCast(options.rounds);
    if (!cast) {
        std::cerr << cast.error().message << '\n';
        return 1;
    }
    nlohmann::ordered_json report;
    report["count"] = options.count;
    report["bytes"] = bytes.value();
    report["save_ms"] = rounded(median(times.saveMs));
    report["load_ms"] = rounded(median(times.loadMs));
    report["parse_floor_ms"] = rounded(median(times.parseFloorMs));
    report["dump_floor_ms"] = rounded(median(times.dumpFloorMs));
    report["state_bytes"] = stateBytes.value();
    report["state_save_ms"] = rounded(median(stateTimes.saveMs));
    report["state_load_ms"] = rounded(median(stateTimes.loadMs));
    report["state_parse_floor_ms"] = rounded(median(stateTimes.parseFloorMs));
    report["state_dump_floor_ms"] = rounded(median(stateTimes.dumpFloorMs));
    report["cast_templates"] = cast.value().templates;
    report["cast_bytes"] = cast.value().bytes;
    report["cast_load_ms"] = cast.value().loadMs;
    report["cast_floor_ms"] = cast.value().floorMs;
    if (options.json) {
        std::cout << report.dump() << '\n';
        return 0;
    }
    for (const auto& [name, value] : report.items()) {
        std::cout << name << ": " << value << '\n';
    }
    return 0;
}

} // namespace crowd::app
