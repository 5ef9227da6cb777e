// SPDX-License-Identifier: MIT
#include "app/python/ScriptPeople.h"

#include <optional>
#include <utility>

#include "app/python/ColumnRules.h"
#include "behavior/session/PoseKeeping.h"
#include "model/document/GroundEdits.h"

namespace crowd::app {

using namespace model;

namespace {

/// Of fewer a host makes one piece of work, so that its other scripts never meet an open edit.
constexpr std::size_t kMany = 100'000;

Error stopped()
{
    return Error{"It was stopped."};
}

/// A step over n people of which nothing remains where it is stopped or fails. `prepare` finds
/// out what is wrong, `write` does it; both where the document is.
Result<void> stoppableStep(ScriptScene& script, const char* text, std::size_t n,
                           const KeepGoing& keepGoing, const std::function<Result<void>()>& prepare,
                           const ScriptScene::Work& write)
{
    constexpr double kPrepared = 0.4;
    const auto add = [&] { return script.edit(stepText(text), write); };
    if (!script.isOwn() && n < kMany) {
        if (!script.ask(keepGoing, 1.0)) {
            return stopped();
        }
        return script.onDocument([&] {
            auto prepared = prepare();
            return prepared ? add() : prepared;
        });
    }
    const bool isPart = script.isInsideEdit(); // which cannot be taken back by halves
    if (!isPart) {
        if (auto begun = script.beginEdit(stepText(text).toStdString()); !begun) {
            return begun;
        }
    }
    Result<void> done = script.onDocument(prepare);
    const auto ask = [&](double share) {
        if (done && !script.ask(keepGoing, share)) {
            done = stopped();
        }
    };
    ask(isPart ? 1.0 : kPrepared);
    if (done) {
        done = script.onDocument(add);
    }
    if (!isPart) {
        ask(1.0);
        script.endEdit(static_cast<bool>(done));
    }
    return done;
}

} // namespace

Result<std::vector<IndividualId>> createPeople(ScriptScene& script, std::size_t n,
                                               std::span<const ColumnValues> values,
                                               const KeepGoing& keepGoing, MissingEntries missing)
{
    std::optional<IndividualRows> rows;
    std::vector<IndividualId> ids;
    const auto make = [&]() -> Result<void> {
        auto made = newRows(script.document().scene(), n, values, missing);
        if (!made) {
            return made.error();
        }
        rows = std::move(made).value();
        return {};
    };
    const auto done =
        stoppableStep(script, QT_TRANSLATE_NOOP("Script", "Create characters"), n, keepGoing, make,
                      [&](SceneEdit& open) { ids = open.addIndividuals(std::move(rows).value()); });
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
                          std::span<const ColumnValues> values, const KeepGoing& keepGoing,
                          MissingEntries missing)
{
    const auto check = [&]() -> Result<void> {
        if (auto alive = checkAlive(script.document().scene(), ids); !alive) {
            return alive;
        }
        return checkChange(script.document().scene(), ids, values, missing);
    };
    return stoppableStep(script, QT_TRANSLATE_NOOP("Script", "Change characters"), ids.size(),
                         keepGoing, check, [&](SceneEdit& open) {
                             for (const ColumnValues& each : values) {
                                 open.setColumn(each.column, ids, each.bytes);
                             }
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
