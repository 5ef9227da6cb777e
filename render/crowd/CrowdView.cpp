// SPDX-License-Identifier: MIT
#include "render/crowd/CrowdView.h"

#include <algorithm>

#include <epoxy/gl.h>

namespace crowd::render {

namespace {

using namespace model;

} // namespace

void sendInstances(GlBuffer& buffer, std::span<const Instance> instances)
{
    stream(buffer, std::as_bytes(instances));
}

void CrowdView::initialize()
{
    m_instances = GlBuffer::create();
    m_seeThroughInstances = GlBuffer::create();
}

void CrowdView::plan(const Request& request, const CrowdGpu& crowd)
{
    m_plan.make({request.frame, crowd.templates(), crowd.records().lifts(), request.view,
                 request.pixelRatio, request.levels, request.selected, request.hovered});
}

void CrowdView::uploadSolid()
{
    sendInstances(m_instances, m_plan.instances());
}

void CrowdView::upload(const Camera& camera, CrowdGpu& crowd)
{
    uploadSolid();
    collectSeeThrough(camera, crowd);
}

/// Individuals with something to see through, across templates: they are blended one over the
/// other, so that order counts. Neighbours of one template and level stay one run.
void CrowdView::collectSeeThrough(const Camera& camera, CrowdGpu& crowd)
{
    struct Seen
    {
        float depth;
        std::uint32_t row;
        const InstanceRun* run;
        const Instance* instance;
    };
    std::vector<Seen> seen;
    for (const InstanceRun& run : m_plan.runs()) {
        if (run.level == kImpostorLevel || !crowd.gpuOf(run.entry).level(run.level).isBlended) {
            continue;
        }
        for (const Instance& instance : m_plan.instances().subspan(run.first, run.count)) {
            const std::uint32_t row = instance.rowAndFlags & Instance::kRowMask;
            const glm::vec3 away = crowd.records().placements()[row].position - camera.position;
            seen.push_back({glm::dot(away, camera.forward()), row, &run, &instance});
        }
    }
    std::ranges::sort(seen, [](const Seen& a, const Seen& b) {
        return a.depth != b.depth ? a.depth > b.depth : a.row < b.row;
    });
    m_seeThrough.clear();
    m_seeThroughRuns.clear();
    const InstanceRun* last = nullptr;
    for (const Seen& one : seen) {
        if (one.run != last) {
            last = one.run;
            m_seeThroughRuns.push_back({last->entry, last->level, m_seeThrough.size(), 0});
        }
        m_seeThrough.push_back(*one.instance);
        ++m_seeThroughRuns.back().count;
    }
    if (!m_seeThrough.empty()) {
        sendInstances(m_seeThroughInstances, m_seeThrough);
    }
}

} // namespace crowd::render
