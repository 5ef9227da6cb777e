// SPDX-License-Identifier: MIT
#include "render/crowd/TemplateGpu.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <epoxy/gl.h>

#include "render/crowd/TemplateImages.h"
#include "render/gl/TextureUpload.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr float kStandInMargin = 0.5F; ///< share of a first keyframe's size, while a clip is baked

struct ClipBox
{
    glm::vec4 low{0.0F};
    glm::vec4 step{0.0F}; ///< size / 65535
};

TemplateGpu::Level makeLevel(const Template& asset, const DrawLevel& source)
{
    const GroupedMesh mesh = groupMesh(asset, source);
    TemplateGpu::Level level;
    level.groups = mesh.groups;
    level.isBlended = std::ranges::any_of(mesh.groups, [](const MeshGroup& group) {
        return group.state.alphaMode == AlphaMode::Blend;
    });
    level.vertexLevel = source.vertexLevel;
    level.verticesPerKeyframe = static_cast<std::uint32_t>(
        asset.levels[static_cast<std::size_t>(source.vertexLevel)].positions.size());
    level.array = GlVertexArray::create();
    glBindVertexArray(level.array.name());
    level.vertices = makeBuffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(mesh.vertices)));
    constexpr GLsizei kStride = sizeof(StaticVertex);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride,
                          bufferOffset(offsetof(StaticVertex, uv)));
    glVertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          bufferOffset(offsetof(StaticVertex, color)));
    glVertexAttribIPointer(2, 1, GL_UNSIGNED_INT, kStride,
                           bufferOffset(offsetof(StaticVertex, source)));
    glVertexAttribIPointer(3, 2, GL_UNSIGNED_SHORT, kStride,
                           bufferOffset(offsetof(StaticVertex, slot)));
    for (GLuint attribute = 0; attribute < 6; ++attribute) {
        glEnableVertexAttribArray(attribute);
    }
    glVertexAttribDivisor(4, 1);
    glVertexAttribDivisor(5, 1);
    level.indices = makeBuffer(GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(std::span(mesh.indices)));
    glBindVertexArray(0);
    return level;
}

} // namespace

TemplateGpu::TemplateGpu(TemplatePtr asset, int reduction)
    : m_asset(std::move(asset)), m_clips(m_asset->clips.size()), m_uploaded(m_asset->clips.size()),
      m_impostors(*m_asset), m_boxes(GL_RGBA32F), m_materials(GL_RGBA32F)
{
    for (std::size_t i = 0; i < m_clips.size(); ++i) {
        m_clips[i].clip = &m_asset->clips[i];
    }
    const glm::vec3 size = m_asset->bounds.size();
    m_shadowRadius = std::max(0.28F * (size.x + size.z), 0.12F * size.y);
    makeLevels(reduction);
    makeMaterials(reduction);
}

void TemplateGpu::makeLevels(int reduction)
{
    for (std::size_t i = 0; i < m_asset->levels.size(); ++i) {
        m_keyframes.emplace_back(GL_RGBA16UI);
    }
    const int first = std::min(reduction, static_cast<int>(m_asset->levels.size()) - 1);
    for (const DrawLevel& level : drawLevels(*m_asset)) {
        const bool isLeftOut = level.vertexLevel < first;
        m_levels.push_back(isLeftOut ? Level() : makeLevel(*m_asset, level));
        m_finest += isLeftOut ? 1 : 0;
    }
}

void TemplateGpu::makeMaterials(int reduction)
{
    const TemplateImages images = templateImages(*m_asset, reduction);
    m_choicesPerSlot = images.choicesPerSlot;
    for (std::size_t slot = 0; slot < m_asset->slots.size() && slot < kMaxTintSlots; ++slot) {
        m_tintableSlots |= m_asset->slots[slot].tintable ? 1U << slot : 0U;
    }
    const std::span<const std::byte> records = std::as_bytes(std::span(images.materials));
    m_materials.reserve(records.size());
    m_materials.write(0, records);
    const auto impostorArray = static_cast<std::size_t>(m_impostors.state().pictures);
    m_pictureTexels = static_cast<float>(
        std::max(images.arrays[impostorArray].width, images.arrays[impostorArray].height));
    for (const PictureArray& array : images.arrays) {
        m_pictures.push_back(uploadLayers(array.width, array.height, array.layers, array.sampling));
    }
}

void TemplateGpu::useClip(KeyframeStore& store, int clipIndex)
{
    const KeyframeStore::Entry entry = store.clip(m_asset, clipIndex);
    if (m_uploaded[static_cast<std::size_t>(clipIndex)] != entry.clip) {
        append(clipIndex, entry);
    }
}

void TemplateGpu::wantImpostors(KeyframeStore& store, int clipIndex, int band)
{
    m_impostors.want(clipIndex, band);
    takeImpostors(store);
}

void TemplateGpu::takeImpostors(KeyframeStore& store)
{
    if (!m_impostors.isAnyWanted()) {
        return;
    }
    std::vector<BakedClipPtr> complete(m_uploaded.size());
    for (std::size_t i = 0; i < complete.size(); ++i) {
        complete[i] = m_clips[i].isComplete ? m_uploaded[i] : nullptr;
    }
    m_impostors.take(store, m_asset, complete, m_clips);
}

/// Whether anything is drawn of the vertices of that level of the asset.
bool TemplateGpu::isSent(std::size_t vertexLevel) const
{
    return static_cast<int>(vertexLevel) >= level(0).vertexLevel;
}

/// A clip that replaces its first keyframe goes behind it; the few bytes before are not reused.
void TemplateGpu::append(int clipIndex, const KeyframeStore::Entry& entry)
{
    const BakedClip& baked = *entry.clip;
    const auto count = static_cast<std::size_t>(baked.keyframes);
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    PlanClip& clip = m_clips[static_cast<std::size_t>(clipIndex)];
    for (std::size_t level = 0; level < baked.levels.size(); ++level) {
        const std::size_t vertices = baked.levels[level].size() / count;
        if (isSent(level) &&
            (m_keyframeCount + count) * vertices > static_cast<std::size_t>(most) &&
            !clip.bounds.isEmpty()) {
            return; // The card addresses no more: the clip stays at its first keyframe.
        }
    }
    for (std::size_t level = 0; level < baked.levels.size(); ++level) {
        if (!isSent(level)) {
            continue;
        }
        const std::vector<PackedVertex>& packed = baked.levels[level];
        const std::size_t offset = m_keyframeCount * (packed.size() / count) * sizeof(PackedVertex);
        m_keyframes[level].reserve(offset + packed.size() * sizeof(PackedVertex));
        m_keyframes[level].write(offset, std::as_bytes(std::span(packed)));
    }
    const std::array<ClipBox, 1> box{
        {{glm::vec4(baked.bounds.low, 0.0F), glm::vec4(baked.bounds.size() / 65535.0F, 0.0F)}}};
    m_boxes.reserve((m_boxCount + std::size_t{1}) * sizeof(ClipBox));
    m_boxes.write(m_boxCount * sizeof(ClipBox), std::as_bytes(std::span(box)));
    clip.firstKeyframe = m_keyframeCount;
    clip.box = m_boxCount;
    clip.isComplete = entry.isComplete;
    clip.bounds = baked.bounds;
    if (!entry.isComplete) {
        const glm::vec3 margin = baked.bounds.size() * kStandInMargin;
        clip.bounds.add(baked.bounds.low - margin);
        clip.bounds.add(baked.bounds.high + margin);
    }
    m_uploaded[static_cast<std::size_t>(clipIndex)] = entry.clip;
    m_keyframeCount += static_cast<std::uint32_t>(count);
    ++m_boxCount;
}

void TemplateGpu::bindTables(int levelIndex, int first) const
{
    m_keyframes[static_cast<std::size_t>(level(levelIndex).vertexLevel)].bind(first);
    m_boxes.bind(first + 1);
    m_materials.bind(first + 2);
}

void TemplateGpu::bindPictures(int array, int unit) const
{
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, m_pictures[static_cast<std::size_t>(array)].name());
}

} // namespace crowd::render
