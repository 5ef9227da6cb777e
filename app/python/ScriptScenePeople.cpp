// SPDX-License-Identifier: MIT
#include "app/python/ColumnRules.h"
#include "app/python/ScriptSceneParts.h"
#include "behavior/session/PoseKeeping.h"
#include "model/document/GroundEdits.h"

namespace crowd::app {

using namespace model;

Result<std::vector<IndividualId>> ScriptScene::create(std::size_t n,
                                                      std::span<const ColumnValues> values)
{
    std::vector<IndividualId> ids;
    const auto done = onDocument([&]() -> Result<void> {
        auto rows = newRows(m_host.document->scene(), n, values);
        if (!rows) {
            return rows.error();
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Create characters")),
                    [&](SceneEdit& open) { ids = open.addIndividuals(std::move(rows).value()); });
    });
    if (!done) {
        return done.error();
    }
    return ids;
}

Result<void> ScriptScene::remove(std::span<const IndividualId> ids)
{
    return onDocument([&]() -> Result<void> {
        if (auto alive = checkAlive(m_host.document->scene(), ids); !alive) {
            return alive;
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Remove characters")),
                    [&](SceneEdit& open) { open.removeIndividuals(ids); });
    });
}

Result<void> ScriptScene::change(std::span<const IndividualId> ids,
                                 std::span<const ColumnValues> values)
{
    return onDocument([&]() -> Result<void> {
        if (auto alive = checkAlive(m_host.document->scene(), ids); !alive) {
            return alive;
        }
        if (auto valid = checkChange(m_host.document->scene(), ids, values); !valid) {
            return valid;
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Change characters")),
                    [&](SceneEdit& open) {
                        for (const ColumnValues& each : values) {
                            open.setColumn(each.column, ids, each.bytes);
                        }
                    });
    });
}

Result<int> ScriptScene::keepPose(const Population& shown, const behavior::SessionPose& pose,
                                  Snapshot& after)
{
    int people = 0;
    const auto done = onDocument([&] {
        auto kept = edit(stepText(QT_TRANSLATE_NOOP("Script", "Keep the pose")),
                         [&](SceneEdit& open) { people = behavior::keepPose(open, shown, &pose); });
        after = {std::make_shared<const Scene>(m_host.document->scene()),
                 m_host.document->revision()};
        return kept;
    });
    if (!done) {
        return done.error();
    }
    return people;
}

Result<int> ScriptScene::putOnGround(std::span<const IndividualId> ids)
{
    (void)m_ground.of(*scene()); // takes long: not while a host waits
    int people = 0;
    const auto done = onDocument([&]() -> Result<void> {
        const Scene& now = m_host.document->scene();
        if (auto alive = checkAlive(now, ids); !alive) {
            return alive;
        }
        const WalkableGroundPtr ground = m_ground.of(now);
        if (!ground) {
            return {}; // open ground
        }
        return edit(stepText(QT_TRANSLATE_NOOP("Script", "Put characters on the ground")),
                    [&](SceneEdit& open) { people = model::putOnGround(open, *ground, ids); });
    });
    if (!done) {
        return done.error();
    }
    return people;
}

} // namespace crowd::app
