// SPDX-License-Identifier: MIT
#include "app/python/ScriptTakes.h"

#include <algorithm>
#include <functional>
#include <utility>

#include <QtCore/QFileInfo>
#include <QtCore/QString>

#include "app/python/ColumnRules.h"
#include "behavior/session/MotionReader.h"
#include "behavior/takes/TakeBeginning.h"
#include "behavior/takes/TakeFile.h"
#include "model/base/ShownText.h"
#include "model/project/HandEditJson.h"
#include "model/project/TakeFiles.h"

namespace crowd::app {

using namespace model;

namespace {

Error noTake(const Takes& takes, const std::string& name)
{
    std::string known;
    for (const Take& each : takes) {
        known += (known.empty() ? "" : ", ") + shortened(each.name);
    }
    return Error{"There is no take \"" + shortened(name) +
                 "\"; there are: " + (known.empty() ? "none yet" : known) + '.'};
}

/// A step over a copy of the list.
Result<void> editTakes(ScriptScene& script, const char* text,
                       const std::function<Result<void>(Takes&)>& change)
{
    return script.onDocument([&]() -> Result<void> {
        Takes all = script.document().scene().takes;
        if (auto changed = change(all); !changed) {
            return changed;
        }
        return script.edit(stepText(text),
                           [&](SceneEdit& open) { open.set<members::Takes>(std::move(all)); });
    });
}

Result<void> checkNewName(const Takes& takes, const std::string& name)
{
    if (QString::fromStdString(name).simplified().isEmpty()) {
        return Error{"A take needs a name."};
    }
    if (std::ranges::find(takes, name, &Take::name) != takes.end()) {
        return Error{"There is a take \"" + shortened(name) + "\" already; choose another name."};
    }
    return {};
}

/// Its id where it has one, else the next.
Result<Take> insertTake(ScriptScene& script, Take take, const char* text)
{
    const auto done = editTakes(script, text, [&](Takes& takes) -> Result<void> {
        if (auto free = checkNewName(takes, take.name); !free) {
            return free;
        }
        if (takes.size() >= kMostTakes) {
            return Error{"There are as many takes as there can be. Remove some first."};
        }
        if (take.id != 0 && findTake(takes, take.id) != nullptr) {
            return Error{"There is a take with the id " + std::to_string(take.id) +
                         " already; give another one, or none."};
        }
        take.id = take.id != 0 ? take.id : freeTakeId(takes);
        if (take.id == 0) {
            return Error{"There is no id left for a take. Remove the one with the highest."};
        }
        takes.insert(std::ranges::upper_bound(takes, take.id, {}, &Take::id), take);
        return {};
    });
    if (!done) {
        return done.error();
    }
    return take;
}

} // namespace

Result<void> showTake(ScriptScene& script, const std::optional<std::string>& name)
{
    return editTakes(script, "Show take", [&](Takes& takes) -> Result<void> {
        const auto found = name ? std::ranges::find(takes, *name, &Take::name) : takes.end();
        if (name && found == takes.end()) {
            return noTake(takes, *name);
        }
        if (name && !found->motion) {
            return Error{found->problem};
        }
        if (name) {
            if (const auto opened = behavior::openTake(found->motion); !opened) {
                return opened.error();
            }
        }
        for (Take& each : takes) {
            each.isShown = name && &each == &*found;
        }
        return {};
    });
}

Result<void> removeTake(ScriptScene& script, const std::string& name)
{
    return editTakes(script, "Delete take", [&](Takes& takes) -> Result<void> {
        const auto found = std::ranges::find(takes, name, &Take::name);
        if (found == takes.end()) {
            return noTake(takes, name);
        }
        takes.erase(found);
        return {};
    });
}

Result<void> setHandEdits(ScriptScene& script, const std::string& name, const std::string& edits,
                          bool areOn)
{
    auto read = readHandEdits(edits);
    if (!read) {
        return read.error();
    }
    return editTakes(script, "Edit take by hand", [&](Takes& takes) -> Result<void> {
        const auto found = std::ranges::find(takes, name, &Take::name);
        if (found == takes.end()) {
            return noTake(takes, name);
        }
        found->edits = std::move(read).value();
        found->areEditsOn = areOn;
        return {};
    });
}

Result<behavior::RunBeginning> beginningInTake(const ScriptScene& script, const std::string& name,
                                               double seconds)
{
    const auto scene = script.scene();
    const auto found = std::ranges::find(scene->takes, name, &Take::name);
    if (found == scene->takes.end()) {
        return noTake(scene->takes, name);
    }
    return behavior::beginningIn(*found, *scene, seconds);
}

Result<Take> keepTake(ScriptSession& session, const std::string& name, const KeepGoing& goesOn)
{
    ScriptScene& script = *session.scene();
    const auto scene = script.scene();
    if (const auto free = checkNewName(scene->takes, name); !free) {
        return free.error();
    }
    const auto motion = session.motion();
    if (!motion) {
        return Error{"The session does not record: make it as Session(scene, record=True)."};
    }
    const QString folder = newTakesFolder(QString::fromStdString(script.path()));
    auto taken = behavior::writeTake(*motion, folder, goesOn);
    if (!taken) {
        return taken;
    }
    Take take = std::move(taken).value();
    take.name = name;
    return insertTake(script, std::move(take), "Keep take");
}

Result<Take> retake(ScriptScene& script, const ScriptRetake& wish, const KeepGoing& goesOn)
{
    const auto scene = script.snapshot().scene; // whoever listens to the progress may edit
    const auto found = std::ranges::find(scene->takes, wish.take, &Take::name);
    if (found == scene->takes.end()) {
        return noTake(scene->takes, wish.take);
    }
    if (const auto free = checkNewName(scene->takes, wish.name); !free) {
        return free.error();
    }
    if (auto alive = checkAlive(*scene, wish.order.people); !alive) {
        return alive.error();
    }
    if (!found->motion) {
        return Error{found->problem};
    }
    const auto motion = behavior::openTake(found->motion);
    if (!motion) {
        return motion.error();
    }
    auto kept = behavior::keepRetake(*scene, *found, motion.value(), wish.order, nullptr,
                                     newTakesFolder(QString::fromStdString(script.path())), goesOn);
    if (!kept) {
        return kept.error();
    }
    Take take = std::move(kept).value().take;
    take.name = wish.name;
    return insertTake(script, std::move(take), "Retake");
}

Result<Take> addTake(ScriptScene& script, const std::string& path, const std::string& name,
                     TakeId id)
{
    const QString file = QString::fromStdString(path);
    if (!file.endsWith(QStringLiteral(".take"))) {
        return Error{path + ": is no take; give a file whose name ends in .take."};
    }
    const auto opened = MotionFile::open(file);
    if (!opened) {
        return opened.error();
    }
    const auto motion = behavior::openTake(opened.value());
    if (!motion) {
        return motion.error();
    }
    const behavior::MotionCache::Extent extent = motion.value()->extent();
    const auto last = behavior::MotionReader(motion.value()).around(extent.last).first;
    if (!last) {
        return Error{path + ": is damaged. Fetch it from a copy."};
    }
    Take take;
    take.id = id;
    take.name = name;
    take.file = QFileInfo(file).fileName().toStdString();
    take.begin = extent.first;
    take.end = extent.last;
    take.people = static_cast<int>(last->ids.size());
    take.motion = opened.value();
    return insertTake(script, std::move(take), "Add take");
}

Result<void> renameTake(ScriptScene& script, const std::string& name, const std::string& to)
{
    return editTakes(script, "Rename take", [&](Takes& takes) -> Result<void> {
        const auto found = std::ranges::find(takes, name, &Take::name);
        if (found == takes.end()) {
            return noTake(takes, name);
        }
        if (auto free = checkNewName(takes, to); !free && to != name) {
            return free;
        }
        found->name = to;
        return {};
    });
}

} // namespace crowd::app
