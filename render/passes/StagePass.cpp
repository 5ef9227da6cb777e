// SPDX-License-Identifier: MIT
#include "render/passes/StagePass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <epoxy/gl.h>

#include "render/crowd/TemplateImages.h"
#include "render/gl/TextureUpload.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr int kFramesBeforeDroppingStage = 60;
constexpr int kReliefUnit = 2; ///< of textures

struct StageVertex
{
    glm::vec3 position{0.0F};
    glm::vec3 normal{0.0F, 1.0F, 0.0F};
    glm::vec2 uv{0.0F};
    glm::u8vec4 color{255};
};
static_assert(sizeof(StageVertex) == 36);

glm::u8vec4 toBytes(const glm::vec4& color)
{
    return glm::u8vec4(glm::clamp(color, 0.0F, 1.0F) * 255.0F + 0.5F);
}

void append(const StageMesh& mesh, std::vector<StageVertex>& vertices,
            std::vector<std::uint32_t>& indices)
{
    const auto first = static_cast<std::uint32_t>(vertices.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        StageVertex vertex;
        vertex.position = mesh.positions[v];
        if (v < mesh.normals.size()) {
            vertex.normal = mesh.normals[v];
        }
        if (v < mesh.uv.size()) {
            vertex.uv = mesh.uv[v];
        }
        if (v < mesh.colors.size()) {
            vertex.color = toBytes(mesh.colors[v]);
        }
        vertices.push_back(vertex);
    }
    for (const std::uint32_t index : mesh.indices) {
        indices.push_back(first + index);
    }
}

std::vector<std::size_t> meshesByMaterial(const StageAsset& asset)
{
    std::vector<std::size_t> order(asset.meshes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {},
                             [&asset](std::size_t i) { return asset.meshes[i].material; });
    return order;
}

void pointAttributes()
{
    constexpr GLsizei kStride = sizeof(StageVertex);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride,
                          bufferOffset(offsetof(StageVertex, position)));
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, kStride,
                          bufferOffset(offsetof(StageVertex, normal)));
    glVertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, kStride,
                          bufferOffset(offsetof(StageVertex, uv)));
    glVertexAttribPointer(3, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride,
                          bufferOffset(offsetof(StageVertex, color)));
    for (GLuint attribute = 0; attribute < 4; ++attribute) {
        glEnableVertexAttribArray(attribute);
    }
}

/// Whether anything of it lies by texture coordinates.
bool isTextured(const MaterialChoice& material)
{
    return material.image >= 0 || material.emissiveImage >= 0 || material.normalImage >= 0;
}

std::string definesOf(const MaterialChoice& material, const Style& style)
{
    // Walls and grounds are rough, and fill the picture: what they would mirror is not seen, but
    // paid for by the pixel.
    constexpr float kDull = 0.8F;
    std::string defines =
        material.roughness < kDull ? style.materialDefines() : style.surfaceDefines;
    defines += isTextured(material) ? "TEXTURED " : "";
    defines += material.normalImage >= 0 && style.hasRelief ? "RELIEF " : "";
    defines += material.emissiveImage >= 0 ? "GLOWING " : "";
    defines += material.alphaMode == AlphaMode::Mask ? "CUTOUT " : "";
    defines += material.alphaMode == AlphaMode::Blend ? "BLENDED " : "";
    return defines;
}

/// Halved so many times, and as large as the card takes it.
Image fitting(const Image& image, int halvings)
{
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const int width = std::clamp(image.width >> halvings, 1, static_cast<int>(most));
    const int height = std::clamp(image.height >> halvings, 1, static_cast<int>(most));
    if (width == image.width && height == image.height) {
        return image;
    }
    return {image.name, width, height, resized(image, width, height)};
}

/// White where the material has no such picture, but another.
GlTexture pictureOf(const StageAsset& asset, const MaterialChoice& material, int image,
                    int halvings)
{
    static const Image white{"white", 1, 1, {255, 255, 255, 255}};
    if (!isTextured(material)) {
        return {};
    }
    return uploadImage(image < 0 ? white
                                 : fitting(asset.images[static_cast<std::size_t>(image)], halvings),
                       {material.wrapU, material.wrapV, material.nearest});
}

GlTexture reliefOf(const StageAsset& asset, const MaterialChoice& material, int halvings)
{
    if (material.normalImage < 0) {
        return {};
    }
    return uploadValues(
        fitting(asset.images[static_cast<std::size_t>(material.normalImage)], halvings),
        {material.wrapU, material.wrapV, false});
}

void bindPicture(ShaderProgram& shader, const char* name, int unit, const GlTexture& picture)
{
    shader.set(name, unit);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, picture.name());
}

} // namespace

StagePass::Gpu& StagePass::gpuOf(const StagePtr& asset)
{
    std::unique_ptr<Gpu>& gpu = m_gpu[asset.get()];
    if (gpu) {
        gpu->unusedFrames = 0;
        return *gpu;
    }
    gpu = std::make_unique<Gpu>();
    gpu->asset = asset;
    std::vector<StageVertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const std::size_t i : meshesByMaterial(*asset)) {
        const StageMesh& mesh = asset->meshes[i];
        if (gpu->batches.empty() || gpu->batches.back().material != mesh.material) {
            gpu->batches.push_back({mesh.material, static_cast<std::uint32_t>(indices.size()), 0});
        }
        append(mesh, vertices, indices);
        gpu->batches.back().indexCount += static_cast<std::uint32_t>(mesh.indices.size());
    }
    gpu->array = GlVertexArray::create();
    glBindVertexArray(gpu->array.name());
    gpu->vertices = makeBuffer(GL_ARRAY_BUFFER, std::as_bytes(std::span(vertices)));
    pointAttributes();
    gpu->indices = makeBuffer(GL_ELEMENT_ARRAY_BUFFER, std::as_bytes(std::span(indices)));
    glBindVertexArray(0);
    for (const MaterialChoice& material : asset->materials) {
        gpu->textures.push_back(pictureOf(*asset, material, material.image, m_halvings));
        gpu->glows.push_back(pictureOf(*asset, material, material.emissiveImage, m_halvings));
        gpu->reliefs.push_back(reliefOf(*asset, material, m_halvings));
    }
    return *gpu;
}

/// What its colour and its holes are made of.
void StagePass::setSurface(ShaderProgram& shader, const Gpu& gpu, std::size_t index)
{
    const MaterialChoice& material = gpu.asset->materials[index];
    shader.set("baseColor", material.baseColor);
    shader.set("alphaCutoff", material.alphaCutoff);
    const std::array<float, 6>& uv = material.uvTransform;
    shader.set("uvRowU", glm::vec3(uv[0], uv[1], uv[2]));
    shader.set("uvRowV", glm::vec3(uv[3], uv[4], uv[5]));
    if (isTextured(material)) {
        bindPicture(shader, "image", 0, gpu.textures[index]);
    }
}

void StagePass::setRelief(ShaderProgram& shader, const Gpu& gpu, std::size_t index)
{
    const MaterialChoice& material = gpu.asset->materials[index];
    const std::array<float, 6>& uv = material.normalUvTransform;
    shader.set("reliefRowU", glm::vec3(uv[0], uv[1], uv[2]));
    shader.set("reliefRowV", glm::vec3(uv[3], uv[4], uv[5]));
    shader.set("reliefScale", material.normalScale);
    bindPicture(shader, "reliefImage", kReliefUnit, gpu.reliefs[index]);
}

Result<void> StagePass::drawBatch(const PassContext& context, const Gpu& gpu, const Batch& batch,
                                  const glm::mat4& matrix)
{
    const auto index = static_cast<std::size_t>(batch.material);
    const MaterialChoice& material = gpu.asset->materials[index];
    auto built = m_programs.get(definesOf(material, context.style));
    if (!built) {
        return built.error();
    }
    ShaderProgram& shader = *built.value();
    shader.use();
    context.setCommon(shader);
    if (context.style.paint) {
        shader.set("paint", context.style.paint->stage);
    }
    shader.set("worldFromStage", matrix);
    shader.set("emissive", material.emissive);
    shader.set("unlit", material.unlit ? 1.0F : 0.0F);
    if (context.style.highlights > 0.0F) {
        shader.set("gloss", glm::vec2(material.roughness, material.metallic));
    }
    setSurface(shader, gpu, index);
    if (material.emissiveImage >= 0) {
        const std::array<float, 6>& glow = material.emissiveUvTransform;
        shader.set("glowRowU", glm::vec3(glow[0], glow[1], glow[2]));
        shader.set("glowRowV", glm::vec3(glow[3], glow[4], glow[5]));
        bindPicture(shader, "glowImage", 1, gpu.glows[index]);
    }
    if (material.normalImage >= 0 && context.style.hasRelief) {
        setRelief(shader, gpu, index);
    }
    (material.doubleSided ? glDisable : glEnable)(GL_CULL_FACE);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.indexCount), GL_UNSIGNED_INT,
                   bufferOffset(batch.firstIndex * sizeof(std::uint32_t)));
    context.countDraw(batch.indexCount / 3);
    return {};
}

Result<void> StagePass::drawEntries(const PassContext& context, bool isBlended)
{
    for (const StageEntry& entry : context.input.stages) {
        if (!entry.asset) {
            continue;
        }
        const Gpu& gpu = gpuOf(entry.asset);
        glBindVertexArray(gpu.array.name());
        for (const Batch& batch : gpu.batches) {
            const MaterialChoice& material =
                entry.asset->materials[static_cast<std::size_t>(batch.material)];
            if ((material.alphaMode == AlphaMode::Blend) != isBlended) {
                continue;
            }
            if (auto drawn = drawBatch(context, gpu, batch, entry.worldFromStage()); !drawn) {
                return drawn;
            }
        }
    }
    return {};
}

Result<void> StagePass::draw(const PassContext& context)
{
    std::erase_if(m_gpu, [](const auto& item) {
        return ++item.second->unusedFrames > kFramesBeforeDroppingStage;
    });
    return drawEntries(context, false);
}

void StagePass::releaseUnused()
{
    std::erase_if(m_gpu, [](const auto& item) { return item.second->unusedFrames > 0; });
}

/// Both sides: a wall keeps the sun out from wherever it comes.
Result<void> StagePass::drawCasters(const PassContext& context)
{
    return drawSolids(context, true);
}

/// What lamps give a pixel costs several times as much as where it is.
bool StagePass::areDepthsWorthwhile(const PassContext& context)
{
    return !context.style.isWire && !context.style.lights.empty();
}

Result<void> StagePass::drawDepths(const PassContext& context)
{
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    auto drawn = drawSolids(context, false);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    return drawn;
}

Result<void> StagePass::drawSolids(const PassContext& context, bool fromBothSides)
{
    for (const StageEntry& entry : context.input.stages) {
        if (!entry.asset) {
            continue;
        }
        const Gpu& gpu = gpuOf(entry.asset);
        glBindVertexArray(gpu.array.name());
        for (const Batch& batch : gpu.batches) {
            const auto& material = entry.asset->materials[static_cast<std::size_t>(batch.material)];
            if (material.alphaMode == AlphaMode::Blend) {
                continue;
            }
            (fromBothSides || material.doubleSided ? glDisable : glEnable)(GL_CULL_FACE);
            auto drawn = drawCaster(context, gpu, batch, entry.worldFromStage());
            if (!drawn) {
                return drawn;
            }
        }
    }
    return {};
}

Result<void> StagePass::drawCaster(const PassContext& context, const Gpu& gpu, const Batch& batch,
                                   const glm::mat4& matrix)
{
    const auto index = static_cast<std::size_t>(batch.material);
    const MaterialChoice& material = gpu.asset->materials[index];
    const bool isCut = material.alphaMode == AlphaMode::Mask;
    auto built = m_programs.get(!isCut                ? "CASTER "
                                : material.image >= 0 ? "CASTER TEXTURED CUTOUT "
                                                      : "CASTER CUTOUT ");
    if (!built) {
        return built.error();
    }
    ShaderProgram& shader = *built.value();
    shader.use();
    shader.set("viewProjection", context.viewProjection);
    shader.set("worldFromStage", matrix);
    if (isCut) {
        setSurface(shader, gpu, index);
    }
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(batch.indexCount), GL_UNSIGNED_INT,
                   bufferOffset(batch.firstIndex * sizeof(std::uint32_t)));
    context.countDraw(batch.indexCount / 3);
    return {};
}

Result<void> StagePass::drawBlended(const PassContext& context)
{
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    auto drawn = drawEntries(context, true);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    return drawn;
}

} // namespace crowd::render
