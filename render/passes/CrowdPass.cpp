// SPDX-License-Identifier: MIT
#include "render/passes/CrowdPass.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <set>
#include <utility>

#include <epoxy/gl.h>

#include "model/bake/KeyframeTime.h"
#include "model/base/Color.h"

namespace crowd::render {

namespace {

using namespace model;
using Clock = std::chrono::steady_clock;

constexpr int kPlacementUnit = 0;
constexpr int kAppearanceUnit = 1;
constexpr int kTemplateUnit = 2; ///< and the two after it
constexpr int kPicturesUnit = kTemplateUnit + 3;
constexpr int kFramesBeforeDropping = 600;
/// A software rasteriser works on what was flushed while the next piece is prepared.
constexpr std::size_t kSoftwarePiece = 100;
constexpr int kShadowCorners = 8;
constexpr float kShadowStrength = 0.42F;
/// Arms and jumps reach out of a template's bounds: so many times its size.
constexpr float kReachOfClips = 1.5F;

double millisecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// How many rows were written.
template<class Record>
std::size_t writeRows(TexelBuffer& buffer, std::span<const Record> records,
                      std::span<const RowRange> ranges)
{
    std::size_t rows = 0;
    for (const RowRange& range : ranges) {
        buffer.write(range.first * sizeof(Record),
                     std::as_bytes(records.subspan(range.first, range.count)));
        rows += range.count;
    }
    return rows;
}

} // namespace

CrowdPass::RowBuffers::RowBuffers() : placement(GL_RGBA32F), appearance(GL_RGBA32UI) {}

CrowdPass::CrowdPass() = default;

Result<void> CrowdPass::initialize()
{
    auto blob = ShaderProgram::build("blob");
    if (!blob) {
        return blob.error();
    }
    m_blobProgram = std::move(blob).value();
    std::array<glm::vec2, kShadowCorners> corners{};
    for (int i = 0; i < kShadowCorners; ++i) {
        const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(kShadowCorners);
        // Out to where the octagon's edges touch the circle.
        corners[static_cast<std::size_t>(i)] =
            glm::vec2(std::cos(angle), -std::sin(angle)) * 1.0824F;
    }
    m_blobArray = GlVertexArray::create();
    glBindVertexArray(m_blobArray.name());
    m_blobCorners = makeBuffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(corners)));
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glEnableVertexAttribArray(0);
    glEnableVertexAttribArray(4);
    glVertexAttribDivisor(4, 1);
    glBindVertexArray(0);
    for (RowBuffers* rows : {&m_rows, &m_ghostRows}) {
        rows->instances = GlBuffer::create();
        rows->placement.reserve(sizeof(PlacementRecord));
        rows->appearance.reserve(sizeof(AppearanceRecord));
    }
    m_seeThroughInstances = GlBuffer::create();
    return {};
}

TemplateGpu& CrowdPass::gpuOf(const TemplatePtr& asset)
{
    std::unique_ptr<TemplateGpu>& gpu = m_gpu[asset.get()];
    if (!gpu) {
        gpu = std::make_unique<TemplateGpu>(asset);
    }
    m_unusedFrames[asset.get()] = 0;
    return *gpu;
}

void CrowdPass::countUnused()
{
    if (m_entries) {
        for (const TemplateEntry& entry : *m_entries) {
            m_unusedFrames[entry.asset.get()] = 0;
        }
    }
    for (auto& [asset, frames] : m_unusedFrames) {
        ++frames;
    }
}

void CrowdPass::dropUnused(int frames)
{
    std::erase_if(m_unusedFrames, [&](const auto& item) {
        const bool isDropped = item.second > frames;
        if (isDropped) {
            m_gpu.erase(item.first);
        }
        return isDropped;
    });
}

void CrowdPass::releaseUnused()
{
    dropUnused(0);
}

void CrowdPass::refreshTemplates(const PassContext& context)
{
    const auto& entries = context.input.frame->templates;
    if (entries == m_entries) {
        return;
    }
    m_entries = entries;
    ++m_templatesVersion;
    m_planTemplates.assign(entries->size(), {});
    m_recordTemplates.assign(entries->size(), {});
    for (std::size_t i = 0; i < entries->size(); ++i) {
        const TemplateEntry& entry = (*entries)[i];
        if (!entry.asset || entry.asset->levels.empty()) {
            continue;
        }
        const TemplateGpu& gpu = gpuOf(entry.asset);
        PlanTemplate& plan = m_planTemplates[i];
        RecordTemplate& record = m_recordTemplates[i];
        for (const std::string& name : entry.clipNames) {
            const int found = entry.asset->clipIndex(name);
            plan.clipOfName.push_back(
                static_cast<std::uint16_t>(found >= 0 ? found : entry.asset->defaultClip));
        }
        if (plan.clipOfName.empty()) {
            plan.clipOfName.push_back(static_cast<std::uint16_t>(entry.asset->defaultClip));
        }
        for (const std::uint16_t clip : plan.clipOfName) {
            record.clipOfName.push_back(&entry.asset->clips[clip]);
        }
        record.shadowRadius = gpu.shadowRadius();
        plan.height = entry.asset->height;
        plan.levels = gpu.levelCount();
        plan.isDrawable = true;
    }
}

/// Finds out, when somebody changed, which clips somebody is in.
void CrowdPass::findUsedClips(const Population& people)
{
    if (people.version() == m_usedVersion && m_usedTemplatesVersion == m_templatesVersion) {
        return;
    }
    m_usedVersion = people.version();
    m_usedTemplatesVersion = m_templatesVersion;
    /// Of a template id, in a list of all clips; the first item is for ids without a template.
    struct Names
    {
        std::uint32_t first = 0;
        std::uint32_t last = 0; ///< offset
    };
    std::vector<Names> namesOfId(std::size_t{1} << 16U);
    std::vector<std::uint8_t> isUsed(1);
    for (std::size_t i = 0; i < m_planTemplates.size(); ++i) {
        const std::size_t names = m_planTemplates[i].clipOfName.size();
        if (names > 0) {
            namesOfId[(*m_entries)[i].id] = {static_cast<std::uint32_t>(isUsed.size()),
                                             static_cast<std::uint32_t>(names - 1)};
            isUsed.resize(isUsed.size() + names);
        }
    }
    const std::span<const TemplateId> templates = people.column(columns::templateId);
    const std::span<const std::uint16_t> clips = people.column(columns::clip);
    for (std::size_t row = 0; row < templates.size(); ++row) {
        const Names names = namesOfId[templates[row]];
        isUsed[names.first + std::min<std::uint32_t>(clips[row], names.last)] = 1;
    }
    m_usedClips.clear();
    for (std::size_t i = 0; i < m_planTemplates.size(); ++i) {
        const std::vector<std::uint16_t>& clipOfName = m_planTemplates[i].clipOfName;
        for (std::size_t name = 0; name < clipOfName.size(); ++name) {
            if (isUsed[namesOfId[(*m_entries)[i].id].first + name] != 0) {
                m_usedClips.push_back({i, clipOfName[name]});
            }
        }
    }
}

/// The clips that people come from; some of them nobody else may be in.
void CrowdPass::useFadedClips(const PassContext& context)
{
    const CrowdFrame& frame = *context.input.frame;
    if (frame.fades.empty()) {
        return;
    }
    const std::span<const TemplateId> templates = frame.population.column(columns::templateId);
    std::set<std::pair<TemplateId, std::uint16_t>> faded;
    for (const ClipFade& fade : frame.fades) {
        faded.emplace(templates[fade.row], fade.clip);
    }
    for (const auto& [id, name] : faded) {
        const auto entry = std::ranges::find(*m_entries, id, &TemplateEntry::id);
        const auto index = static_cast<std::size_t>(entry - m_entries->begin());
        if (entry == m_entries->end() || !m_planTemplates[index].isDrawable) {
            continue;
        }
        const std::vector<std::uint16_t>& clips = m_planTemplates[index].clipOfName;
        const std::size_t clip = std::min<std::size_t>(name, clips.size() - 1);
        gpuOf(entry->asset).useClip(context.input.keyframes, clips[clip]);
    }
}

/// Asks for the clips that somebody is in or comes from; others are not baked.
void CrowdPass::useShownClips(const PassContext& context)
{
    findUsedClips(context.input.frame->population);
    for (const UsedClip& used : m_usedClips) {
        gpuOf((*m_entries)[used.entry].asset).useClip(context.input.keyframes, used.clip);
    }
    useFadedClips(context);
    for (std::size_t i = 0; i < m_planTemplates.size(); ++i) {
        if (m_planTemplates[i].isDrawable) {
            m_planTemplates[i].clips = gpuOf((*m_entries)[i].asset).clips();
        }
    }
}

void CrowdPass::uploadRecords(const PassContext& context)
{
    const std::span<const PlacementRecord> placements = m_records.placements();
    const std::span<const AppearanceRecord> appearances = m_records.appearances();
    m_rows.placement.reserve(placements.size_bytes());
    m_rows.appearance.reserve(appearances.size_bytes());
    const std::size_t moved =
        writeRows(m_rows.placement, placements, m_records.changedPlacements());
    const std::size_t restyled =
        writeRows(m_rows.appearance, appearances, m_records.changedAppearances());
    context.statistics.uploadedPlacements = static_cast<int>(moved);
    context.statistics.uploadedAppearances = static_cast<int>(restyled);
    context.statistics.uploadedBytes = static_cast<std::int64_t>(
        moved * sizeof(PlacementRecord) + restyled * sizeof(AppearanceRecord));
}

void CrowdPass::uploadInstances(GlBuffer& buffer, std::span<const Instance> instances) const
{
    glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
                 GL_STREAM_DRAW);
}

Result<void> CrowdPass::prepare(const PassContext& context)
{
    const RenderInput& input = context.input;
    countUnused();
    dropUnused(kFramesBeforeDropping); // after a while: ghosts come back often
    if (!input.frame) {
        return {};
    }
    auto start = Clock::now();
    refreshTemplates(context);
    useShownClips(context);
    m_records.update(
        {*input.frame, m_recordTemplates, input.seats, input.seatsVersion, m_templatesVersion});
    context.statistics.recordsMs = millisecondsSince(start);
    start = Clock::now();
    const float ratio = static_cast<float>(context.pixelSize.y) / input.view.size().y;
    m_plan.make({*input.frame, m_planTemplates, m_records.lifts(), input.view, ratio, input.levels,
                 input.selected, input.hovered});
    context.statistics.planMs = millisecondsSince(start);
    uploadRecords(context);
    uploadInstances(m_rows.instances, m_plan.instances());
    collectSeeThrough(context);
    context.statistics.individuals = static_cast<int>(input.frame->population.size());
    context.statistics.visible = static_cast<int>(m_plan.instances().size());
    context.statistics.byLevel = m_plan.byLevel();
    context.statistics.areKeyframesMissing = m_plan.areKeyframesMissing();
    return {};
}

Result<ShaderProgram*> CrowdPass::program(const std::string& defines)
{
    const auto found = m_programs.find(defines);
    if (found != m_programs.end()) {
        return &found->second;
    }
    auto built = ShaderProgram::build("crowd", defines);
    if (!built) {
        return built.error();
    }
    ShaderProgram& program = m_programs.emplace(defines, std::move(built).value()).first->second;
    program.use();
    program.set("placement", kPlacementUnit);
    program.set("appearance", kAppearanceUnit);
    program.set("keyframes", kTemplateUnit);
    program.set("clipBoxes", kTemplateUnit + 1);
    program.set("materials", kTemplateUnit + 2);
    program.set("images", kPicturesUnit);
    return &program;
}

void CrowdPass::setUniforms(const PassContext& context, const Drawing& drawing,
                            const TemplateGpu& gpu, std::uint32_t verticesPerKeyframe,
                            ShaderProgram& shader) const
{
    context.setCommon(shader);
    shader.set("verticesPerKeyframe", verticesPerKeyframe);
    shader.set("choicesPerSlot", gpu.choicesPerSlot());
    shader.set("tintableSlots", gpu.tintableSlots());
    shader.set("opacity", drawing.opacity);
}

void CrowdPass::drawGroup(const PassContext& context, const MeshGroup& group,
                          const InstanceRun& run) const
{
    const std::size_t piece = context.isSoftware ? kSoftwarePiece : run.count;
    const auto* indices = bufferOffset(group.firstIndex * sizeof(std::uint32_t));
    for (std::size_t done = 0; done < run.count; done += piece) {
        const std::size_t count = std::min(piece, run.count - done);
        const std::size_t offset = (run.first + done) * sizeof(Instance);
        glVertexAttribIPointer(4, 4, GL_UNSIGNED_INT, sizeof(Instance), bufferOffset(offset));
        glVertexAttribPointer(5, 1, GL_FLOAT, GL_FALSE, sizeof(Instance),
                              bufferOffset(offset + offsetof(Instance, blend)));
        glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(group.indexCount),
                                GL_UNSIGNED_INT, indices, static_cast<GLsizei>(count));
        context.countDraw(static_cast<std::int64_t>(group.indexCount / 3) *
                          static_cast<std::int64_t>(count));
        if (context.isSoftware && count == piece) {
            glFlush();
        }
    }
}

Result<void> CrowdPass::drawRun(const PassContext& context, const Drawing& drawing,
                                const TemplateGpu& gpu, const InstanceRun& run)
{
    const TemplateGpu::Level& level = gpu.level(run.level);
    drawing.rows.placement.bind(kPlacementUnit);
    drawing.rows.appearance.bind(kAppearanceUnit);
    gpu.bindTables(run.level, kTemplateUnit);
    glBindVertexArray(level.array.name());
    glBindBuffer(GL_ARRAY_BUFFER, drawing.instances.name());
    for (const MeshGroup& group : level.groups) {
        const bool isSeeThrough = drawing.surface == Surface::SeeThrough;
        if (isSeeThrough && group.state.alphaMode != AlphaMode::Blend) {
            continue;
        }
        auto shader = program(drawing.defines + definesOf(group.state, drawing.surface));
        if (!shader) {
            return shader.error();
        }
        shader.value()->use();
        setUniforms(context, drawing, gpu, level.verticesPerKeyframe, *shader.value());
        gpu.bindPictures(group.state.pictures, kPicturesUnit);
        const bool isCulled = !group.state.isDoubleSided;
        (isCulled ? glEnable : glDisable)(GL_CULL_FACE);
        (isSeeThrough || drawing.opacity < 1.0F ? glEnable : glDisable)(GL_BLEND);
        drawGroup(context, group, run);
    }
    return {};
}

Result<void> CrowdPass::drawPeople(const PassContext& context)
{
    if (!context.input.frame) {
        return {};
    }
    Drawing drawing{m_rows, m_rows.instances, lookInfo(context.input.look).defines};
    drawing.defines += m_records.replacesColours() ? "REPLACED " : "";
    for (const InstanceRun& run : m_plan.runs()) {
        const TemplateEntry& entry = (*m_entries)[static_cast<std::size_t>(run.entry)];
        TemplateGpu& gpu = gpuOf(entry.asset);
        if (auto drawn = drawRun(context, drawing, gpu, run); !drawn) {
            return drawn;
        }
    }
    glDisable(GL_BLEND);
    return {};
}

/// Individuals with something to see through, across templates: they are blended one over the
/// other, so that order counts. Neighbours of one template and level stay one run.
void CrowdPass::collectSeeThrough(const PassContext& context)
{
    struct Seen
    {
        float depth;
        std::uint32_t row;
        const InstanceRun* run;
        const Instance* instance;
    };
    std::vector<Seen> seen;
    const Camera& camera = context.input.view.camera();
    for (const InstanceRun& run : m_plan.runs()) {
        if (!gpuOf((*m_entries)[static_cast<std::size_t>(run.entry)].asset)
                 .level(run.level)
                 .isBlended) {
            continue;
        }
        for (const Instance& instance : m_plan.instances().subspan(run.first, run.count)) {
            const std::uint32_t row = instance.rowAndFlags & Instance::kRowMask;
            const glm::vec3 away = m_records.placements()[row].position - camera.position;
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
        uploadInstances(m_seeThroughInstances, m_seeThrough);
    }
}

/// They hide nothing of each other, so nothing of them is lost where they overlap.
Result<void> CrowdPass::drawSeeThrough(const PassContext& context)
{
    if (!context.input.frame || m_seeThrough.empty()) {
        return {};
    }
    Drawing drawing{m_rows, m_seeThroughInstances, lookInfo(context.input.look).defines};
    drawing.defines += m_records.replacesColours() ? "REPLACED " : "";
    drawing.surface = Surface::SeeThrough;
    glDepthMask(GL_FALSE);
    Result<void> drawn;
    for (const InstanceRun& run : m_seeThroughRuns) {
        const TemplateEntry& entry = (*m_entries)[static_cast<std::size_t>(run.entry)];
        drawn = drawRun(context, drawing, gpuOf(entry.asset), run);
        if (!drawn) {
            break;
        }
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    return drawn;
}

/// Under everybody but those at the coarsest level, whose shadows would be a pixel or two.
void CrowdPass::drawShadows(const PassContext& context)
{
    if (!context.input.frame || !context.input.showShadows) {
        return;
    }
    std::size_t count = 0;
    for (const InstanceRun& run : m_plan.runs()) {
        if (run.level < kMaxLevels - 1) {
            count = run.first + run.count;
        }
    }
    if (count == 0) {
        return;
    }
    m_blobProgram.use();
    context.setCommon(m_blobProgram);
    m_blobProgram.set("placement", kPlacementUnit);
    m_blobProgram.set("appearance", kAppearanceUnit);
    m_blobProgram.set("strength", kShadowStrength);
    m_rows.placement.bind(kPlacementUnit);
    m_rows.appearance.bind(kAppearanceUnit);
    glBindVertexArray(m_blobArray.name());
    glBindBuffer(GL_ARRAY_BUFFER, m_rows.instances.name());
    glVertexAttribIPointer(4, 4, GL_UNSIGNED_INT, sizeof(Instance), nullptr);
    glEnable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0F, -2.0F);
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLE_FAN, 0, kShadowCorners, static_cast<GLsizei>(count));
    context.countDraw(static_cast<std::int64_t>(kShadowCorners - 2) *
                      static_cast<std::int64_t>(count));
    glDepthMask(GL_TRUE);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_BLEND);
}

PixelRect CrowdPass::highlightedPart(const PassContext& context) const
{
    constexpr float kRim = 4.0F;
    const View& view = context.input.view;
    const glm::vec2 size(context.pixelSize);
    const float ratio = size.y / view.size().y;
    glm::vec2 low = size;
    glm::vec2 high(0.0F);
    for (const InstanceRun& run : m_plan.highlightedRuns()) {
        const Bounds& box = (*m_entries)[static_cast<std::size_t>(run.entry)].asset->bounds;
        const float far = glm::length(glm::max(glm::abs(box.low), glm::abs(box.high)));
        for (const Instance& instance : m_plan.highlighted().subspan(run.first, run.count)) {
            const PlacementRecord& place =
                m_records.placements()[instance.rowAndFlags & Instance::kRowMask];
            const float reach = far * kReachOfClips * std::max(place.height, place.girth);
            const auto foot = view.project(place.position);
            if (!foot || foot->z <= reach) {
                return {{0, 0}, context.pixelSize};
            }
            const glm::vec2 middle(foot->x * ratio, size.y - foot->y * ratio);
            const float pixels = (reach * view.pixelsPerMetre(foot->z - reach) + kRim) * ratio;
            low = glm::min(low, middle - pixels);
            high = glm::max(high, middle + pixels);
        }
    }
    return {glm::ivec2(glm::max(glm::floor(low), 0.0F)),
            glm::ivec2(glm::min(glm::ceil(high), size))};
}

Result<void> CrowdPass::drawGhosts(const PassContext& context)
{
    for (const Ghost& ghost : context.input.ghosts) {
        if (ghost.asset && !ghost.asset->levels.empty()) {
            if (auto drawn = drawGhost(context, ghost); !drawn) {
                return drawn;
            }
        }
    }
    glDisable(GL_BLEND);
    return {};
}

/// First its depth alone, so that only its front shows through.
Result<void> CrowdPass::drawGhost(const PassContext& context, const Ghost& ghost)
{
    const int clipIndex =
        std::clamp(ghost.clip, 0, static_cast<int>(ghost.asset->clips.size()) - 1);
    TemplateGpu& gpu = gpuOf(ghost.asset);
    gpu.useClip(context.input.keyframes, clipIndex);
    const PlanClip& clip = gpu.clips()[static_cast<std::size_t>(clipIndex)];
    Instance instance;
    instance.boxes = clip.box | static_cast<std::uint32_t>(clip.box) << 16U;
    const KeyframePlace place =
        clip.isComplete ? keyframePlace(*clip.clip, ghost.phase) : KeyframePlace{};
    instance.keyframeA = clip.firstKeyframe + static_cast<std::uint32_t>(place.first);
    instance.keyframeB = clip.firstKeyframe + static_cast<std::uint32_t>(place.second);
    instance.blend = place.blend;
    context.statistics.areKeyframesMissing |= !clip.isComplete;
    const std::array<PlacementRecord, 1> placement{
        {{ghost.position + glm::vec3(0.0F, ghost.lift, 0.0F), std::cos(ghost.headingRadians),
          std::sin(ghost.headingRadians), ghost.height, ghost.girth, ghost.lift}}};
    const std::array<AppearanceRecord, 1> appearance{
        {{ghost.tints, ghost.materialChoices, ghost.parts, 0}}};
    m_ghostRows.placement.write(0, std::as_bytes(std::span(placement)));
    m_ghostRows.appearance.write(0, std::as_bytes(std::span(appearance)));
    uploadInstances(m_ghostRows.instances, {&instance, 1});
    const InstanceRun run{0, 0, 0, 1};
    Drawing drawing{m_ghostRows, m_ghostRows.instances, lookInfo(context.input.look).defines};
    if (ghost.alpha < 1.0F) {
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        auto drawn = drawRun(context, drawing, gpu, run);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        if (!drawn) {
            return drawn;
        }
        drawing.defines += "OPACITY ";
        drawing.opacity = ghost.alpha;
    }
    if (auto drawn = drawRun(context, drawing, gpu, run); !drawn) {
        return drawn;
    }
    drawing.surface = Surface::SeeThrough;
    glDepthMask(GL_FALSE);
    auto drawn = drawRun(context, drawing, gpu, run);
    glDepthMask(GL_TRUE);
    return drawn;
}

} // namespace crowd::render
