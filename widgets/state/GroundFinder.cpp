// SPDX-License-Identifier: MIT
#include "widgets/state/GroundFinder.h"

#include "widgets/state/SceneChanges.h"

namespace crowd::widgets {

GroundFinder::GroundFinder(model::SceneDocument& document, QObject* parent)
    : QObject(parent), m_document(document)
{
    connect(&document, &model::SceneDocument::changed, this, [this](const auto& change) {
        if (isOneOf<model::SceneReplaced, model::StagesChanged>(change)) {
            forget();
        }
    });
}

GroundFinder::~GroundFinder() = default;

void GroundFinder::forget()
{
    const bool wasFinding = m_builder.isBuilding();
    m_builder.cancel();
    m_plan = {};
    m_isBegun = false;
    m_found.reset();
    if (wasFinding) {
        Q_EMIT findingChanged(false);
    }
}

void GroundFinder::begin()
{
    auto plan = behavior::SurfacePlan::ofStages(m_document.scene());
    if (m_isBegun && plan.hasSameStages(m_plan) && plan.hasSameWays(m_plan)) {
        return;
    }
    forget();
    m_plan = std::move(plan);
    m_isBegun = true;
    if (m_plan.isWorthwhile()) {
        m_builder.start(m_plan, [this](const model::Result<SurfacePtr>& built) {
            if (built) {
                m_found = built.value();
                Q_EMIT changed();
            }
            Q_EMIT findingChanged(false);
        });
        Q_EMIT findingChanged(true);
    }
}

model::WalkableGroundPtr GroundFinder::soon()
{
    begin();
    return m_found;
}

model::WalkableGroundPtr GroundFinder::wait()
{
    if (soon() == nullptr && m_builder.isBuilding()) {
        Q_EMIT waiting(true);
        m_builder.wait();
        Q_EMIT waiting(false);
    }
    return m_found;
}

} // namespace crowd::widgets
