// SPDX-License-Identifier: MIT
#include "app/python/ScriptPeople.h"

#include "app/python/ColumnRules.h"
#include "behavior/session/PoseKeeping.h"
#include "model/document/GroundEdits.h"

namespace crowd::app {

using namespace model;

Result<std::vector<IndividualId>> createPeople(ScriptScene& script, std::size_t n,
                                               std::span<const ColumnValues> values)
{
    std::vector<IndividualId> ids;
    const auto done = script.onDocument([&]() -> Result<void> {
        auto rows = newRows(script.document().scene(), n, values);
        if (!rows) {
            return rows.error();
        }
        return script.edit(
            stepText(QT_TRANSLATE_NOOP("Script", "Create characters")),
            [&](SceneEdit& open) { ids = open.addIndividuals(std::move(rows).value()); });
    });
    if (!done) {
        return done.error();
    }
    return ids;
}

Result<void> removePeople(ScriptScene& script, std::span<const IndividualId> ids)
{
    return script.onDocument([&]() -> Result<void> {
        if (auto alive = checkAlive(script.document().scene(), ids); !alive) {
            return alive;
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove characters")),
                           [&](SceneEdit& open) { open.removeIndividuals(ids); });
    });
}

Result<void> changePeople(ScriptScene& script, std::span<const IndividualId> ids,
                          std::span<const ColumnValues> values)
{
    return script.onDocument([&]() -> Result<void> {
        if (auto alive = checkAlive(script.document().scene(), ids); !alive) {
            return alive;
        }
        if (auto valid = checkChange(script.document().scene(), ids, values); !valid) {
            return valid;
        }
        return script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Change characters")),
                           [&](SceneEdit& open) {
                               for (const ColumnValues& each : values) {
                                   open.setColumn(each.column, ids, each.bytes);
                               }
                           });
    });
}

Result<int> keepPose(ScriptScene& script, const Population& shown,
                     const behavior::SessionPose& pose, ScriptScene::Snapshot& after)
{
    int people = 0;
    const auto done = script.onDocument([&] {
        auto kept =
            script.edit(stepText(QT_TRANSLATE_NOOP("Script", "Keep the pose")),
                        [&](SceneEdit& open) { people = behavior::keepPose(open, shown, &pose); });
        after = {std::make_shared<const Scene>(script.document().scene()),
                 script.document().revision()};
        return kept;
    });
    if (!done) {
        return done.error();
    }
    return people;
}

Result<int> putOnGround(ScriptScene& script, std::span<const IndividualId> ids)
{
    int people = 0;
    const auto done = script.onDocument([&]() -> Result<void> {
        const Scene& now = script.document().scene();
        if (auto alive = checkAlive(now, ids); !alive) {
            return alive;
        }
        const WalkableGroundPtr ground = script.ground().of(now);
        if (!ground) {
            return {}; // open ground
        }
        return script.edit(
            stepText(QT_TRANSLATE_NOOP("Script", "Put characters on the ground")),
            [&](SceneEdit& open) { people = model::putOnGround(open, *ground, ids); });
    });
    if (!done) {
        return done.error();
    }
    return people;
}

} // namespace crowd::app
