// SPDX-License-Identifier: MIT
#include "widgets/state/GroundFinder.h"

#include <atomic>
#include <thread>

namespace crowd::widgets {

/// The stages as they were when it began, and the thread that looks at them.
struct GroundFinder::Search
{
    model::Scene stages;
    model::WalkableGroundPtr found; ///< of the thread, until it is done
    std::atomic<bool> isDone{false};
    std::jthread thread;

    [[nodiscard]] bool isFor(const model::Scene& scene) const
    {
        const auto now = behavior::SurfacePlan::ofStages(scene);
        const auto then = behavior::SurfacePlan::ofStages(stages);
        return now.hasSameStages(then) && now.hasSameWays(then);
    }
};

GroundFinder::GroundFinder(model::SceneDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
}

GroundFinder::~GroundFinder() = default;

void GroundFinder::begin()
{
    const model::Scene& scene = m_document.scene();
    if (m_search && m_search->isFor(scene)) {
        return;
    }
    m_search = std::make_unique<Search>(); // waits for the former one
    m_search->stages.stages = scene.stages;
    m_search->stages.surface = scene.surface;
    m_search->thread = std::jthread([this, search = m_search.get()] {
        search->found = m_keeper.of(search->stages);
        search->isDone = true;
    });
}

model::WalkableGroundPtr GroundFinder::soon()
{
    begin();
    return m_search->isDone ? m_search->found : nullptr;
}

model::WalkableGroundPtr GroundFinder::wait()
{
    begin();
    if (!m_search->isDone) {
        Q_EMIT waiting(true);
        m_search->thread.join();
        Q_EMIT waiting(false);
    }
    return m_search->found;
}

} // namespace crowd::widgets
