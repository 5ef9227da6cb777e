// SPDX-License-Identifier: MIT
#pragma once

#include <numeric>
#include <span>
#include <vector>

#include "model/base/Random.h"
#include "model/document/SceneDocument.h"
#include "model/document/SceneEdit.h"
#include "tests/model/ProjectText.h"

/// Edits of a document for tests of undo; the random ones are the same for the same key.
namespace crowd::testing {

using namespace crowd::model;

struct Snapshot
{
    Population population;
    IndividualId nextId;
    std::size_t templates;
    std::size_t cameras;
};

inline Snapshot snapshotOf(const SceneDocument& document)
{
    const Scene& scene = document.scene();
    return {scene.population, scene.nextId, scene.templates.size(), scene.cameras.size()};
}

inline bool isSame(const Snapshot& a, const Snapshot& b)
{
    return a.population == b.population && a.nextId == b.nextId && a.templates == b.templates &&
           a.cameras == b.cameras;
}

inline std::vector<IndividualId> addPeople(SceneDocument& document, std::size_t count)
{
    const auto edit = document.beginEdit().value();
    auto ids = edit->addIndividuals(IndividualRows::withDefaults(std::vector<IndividualId>(count)));
    edit->commit(QStringLiteral("Add"));
    return ids;
}

/// A random subset of the ids, ascending.
inline std::vector<IndividualId> someOf(std::span<const IndividualId> ids, std::uint64_t key)
{
    std::vector<IndividualId> chosen;
    for (const IndividualId id : ids) {
        if (hashKeys(key, id) % 7 == 0) {
            chosen.push_back(id);
        }
    }
    return chosen;
}

inline void randomStep(SceneEdit& edit, std::uint64_t key)
{
    const auto present = edit.scene().population.ids();
    const std::vector<IndividualId> chosen = someOf(present, key);
    switch (hashKeys(key, 1) % 8) {
    case 0:
        (void)edit.addIndividuals(
            IndividualRows::withDefaults(std::vector<IndividualId>(1 + hashKeys(key, 2) % 9)));
        break;
    case 1:
        edit.removeIndividuals(chosen);
        break;
    case 2: {
        const float heading = unitFloat(hashKeys(key, 3));
        edit.setColumn(columns::heading, chosen, std::span<const float>(&heading, 1));
    } break;
    case 3: {
        std::vector<Tint> tints(chosen.size());
        for (std::size_t i = 0; i < tints.size(); ++i) {
            tints[i].red = static_cast<std::uint8_t>(hashKeys(key, i) % 256);
        }
        edit.setColumn(columns::tint(static_cast<int>(hashKeys(key, 4) % 8)), chosen,
                       std::span<const Tint>(tints));
        break;
    }
    case 4:
        if (edit.scene().templates.size() < 5) {
            TemplateEntry entry;
            entry.path = "builtin:templates/man.glb";
            edit.addTemplate(entry);
        } else {
            edit.removeTemplate(edit.scene().templates.front().id);
        }
        break;
    case 5: {
        auto cameras = edit.scene().cameras;
        cameras.resize(hashKeys(key, 5) % 4);
        edit.setCameras(cameras);
        break;
    }
    default: {
        std::vector<float> phases(chosen.size());
        std::iota(phases.begin(), phases.end(), unitFloat(hashKeys(key, 6)));
        edit.setColumn(columns::phase, chosen, std::span<const float>(phases));
        break;
    }
    }
}

/// The whole scene as text. People of these tests have no template, which files do not allow: they
/// are written with one.
inline std::string sceneText(Scene scene)
{
    TemplateEntry entry;
    entry.id = 0xFFFF;
    entry.path = "builtin:templates/man.glb";
    scene.templates.push_back(entry);
    const std::vector<IndividualId> ids(scene.population.ids().begin(),
                                        scene.population.ids().end());
    if (!ids.empty()) {
        scene.population.setValues(columns::templateId, ids,
                                   std::span<const TemplateId>(&entry.id, 1));
    }
    return projectText(scene);
}

/// One undo step of one to three random changes; false when they came to nothing.
inline bool randomEdit(SceneDocument& document, std::uint64_t key)
{
    const auto edit = document.beginEdit().value();
    for (std::uint64_t step = 0; step <= hashKeys(key, 7) % 3; ++step) {
        randomStep(*edit, hashKeys(key, step));
    }
    return edit->commit(QStringLiteral("Random"));
}

} // namespace crowd::testing
