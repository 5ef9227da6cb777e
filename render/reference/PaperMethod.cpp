// SPDX-License-Identifier: MIT
#include "render/reference/PaperMethod.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "model/bake/KeyframeTime.h"
#include "model/base/Color.h"
#include "render/gl/TextureUpload.h"
#include "render/style/LinearLight.h"

namespace crowd::render {

namespace {

using namespace model;

constexpr float kGroundHalfSize = 1500.0F;

void emitTriangles(const Mesh& mesh, const Submesh& submesh, const BakedClip& baked, int keyframe)
{
    glBegin(GL_TRIANGLES);
    for (std::uint32_t i = 0; i < submesh.indexCount; ++i) {
        const std::uint32_t v = mesh.indices[submesh.firstIndex + i];
        glTexCoord2fv(glm::value_ptr(mesh.uv[v]));
        glNormal3fv(glm::value_ptr(baked.normal(0, keyframe, v)));
        glVertex3fv(glm::value_ptr(baked.position(0, keyframe, v)));
    }
    glEnd();
}

void emitStageMesh(const StageMesh& mesh)
{
    glBegin(GL_TRIANGLES);
    for (const std::uint32_t v : mesh.indices) {
        glColor4fv(v < mesh.colors.size() ? glm::value_ptr(mesh.colors[v])
                                          : glm::value_ptr(glm::vec4(1.0F)));
        if (v < mesh.uv.size()) {
            glTexCoord2fv(glm::value_ptr(mesh.uv[v]));
        }
        glNormal3fv(glm::value_ptr(mesh.normals[v]));
        glVertex3fv(glm::value_ptr(mesh.positions[v]));
    }
    glEnd();
}

void bindImage(const GlTexture* texture)
{
    if (texture != nullptr) {
        glEnable(GL_TEXTURE_2D);
        glBindTexture(GL_TEXTURE_2D, texture->name());
    } else {
        glDisable(GL_TEXTURE_2D);
    }
}

glm::vec4 tinted(const MaterialChoice& material, const Tint& tint, bool isTintable)
{
    const glm::vec3 color = linearFromSrgb(glm::vec3(tint.red, tint.green, tint.blue) / 255.0F);
    const float strength = isTintable ? static_cast<float>(tint.strength) / 255.0F : 0.0F;
    return material.baseColor * glm::vec4(glm::mix(glm::vec3(1.0F), color, strength), 1.0F);
}

} // namespace

void PaperMethod::destroy()
{
    for (const auto& [template_, asset] : m_assets) {
        for (const std::vector<std::uint32_t>& lists : asset.lists) {
            if (!lists.empty()) {
                glDeleteLists(lists.front(), static_cast<GLsizei>(lists.size()));
            }
        }
    }
    m_assets.clear();
    m_stageLists.clear();
    m_stageTextures.clear();
    m_target = {};
}

PaperMethod::Asset& PaperMethod::assetOf(const TemplatePtr& asset)
{
    Asset& made = m_assets[asset.get()];
    if (!made.asset) {
        made.asset = asset;
        made.lists.resize(asset->clips.size());
        for (const Image& image : asset->images) {
            made.textures.push_back(uploadImage(image, {}));
        }
    }
    return made;
}

void PaperMethod::makeClipLists(Asset& asset, int clip)
{
    KeyframeStore store;
    const TemplatePtr& source = asset.asset;
    (void)store.clip(source, clip);
    store.waitForAll();
    const BakedClipPtr baked = store.clip(source, clip).clip;
    const Mesh& mesh = source->levels.front();
    const auto count =
        static_cast<GLsizei>(static_cast<std::size_t>(baked->keyframes) * mesh.submeshes.size());
    GLuint list = glGenLists(count);
    std::vector<std::uint32_t>& lists = asset.lists[static_cast<std::size_t>(clip)];
    for (int k = 0; k < baked->keyframes; ++k) {
        for (const Submesh& submesh : mesh.submeshes) {
            glNewList(list, GL_COMPILE);
            emitTriangles(mesh, submesh, *baked, k);
            glEndList();
            lists.push_back(list++);
        }
    }
}

std::uint32_t PaperMethod::listOf(Asset& asset, int clip, int keyframe, std::size_t submesh)
{
    std::vector<std::uint32_t>& lists = asset.lists[static_cast<std::size_t>(clip)];
    if (lists.empty()) {
        makeClipLists(asset, clip);
    }
    const std::size_t submeshes = asset.asset->levels.front().submeshes.size();
    return lists[static_cast<std::size_t>(keyframe) * submeshes + submesh];
}

void PaperMethod::collect(const RenderInput& input)
{
    m_people.clear();
    const Population& people = input.frame->population;
    for (std::size_t row = 0; row < people.size(); ++row) {
        const TemplateId id = people.column(columns::templateId)[row];
        const auto entry = std::ranges::find(*input.frame->templates, id, &TemplateEntry::id);
        if (entry == input.frame->templates->end() || !entry->asset) {
            continue;
        }
        Asset& asset = assetOf(entry->asset);
        const int clipIndex = std::max(
            0, entry->asset->clipIndex(entry->clipNames[people.column(columns::clip)[row]]));
        const Clip& clip = entry->asset->clips[static_cast<std::size_t>(clipIndex)];
        const float phase =
            shownPhase(clip, people.column(columns::phase)[row],
                       people.column(columns::playbackSpeed)[row], input.frame->seconds);
        const KeyframePlace place = keyframePlace(clip, phase);
        const int keyframe = place.blend < 0.5F ? place.first : place.second;
        const std::vector<Submesh>& submeshes = entry->asset->levels.front().submeshes;
        for (std::size_t s = 0; s < submeshes.size(); ++s) {
            const int part = submeshes[s].part;
            if (part >= 0 && (people.column(columns::parts)[row] >> part & 1U) == 0) {
                continue;
            }
            const auto slot = static_cast<std::size_t>(submeshes[s].slot);
            const std::uint64_t choice =
                slot < 8 ? people.column(columns::materialChoices)[row][slot] : 0;
            const std::uint64_t key = static_cast<std::uint64_t>(id) << 48U | s << 40U |
                                      choice << 32U | static_cast<std::uint64_t>(clipIndex) << 16U |
                                      static_cast<std::uint64_t>(keyframe);
            m_people.push_back(
                {key, static_cast<std::uint32_t>(row), listOf(asset, clipIndex, keyframe, s)});
        }
    }
    std::ranges::sort(m_people, [](const Call& a, const Call& b) {
        return a.key != b.key ? a.key < b.key : a.row < b.row;
    });
}

void PaperMethod::setUp(const RenderInput& input) const
{
    const LinearLight light = LinearLight::from(input.lighting);
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(glm::value_ptr(input.view.projectionMatrix()));
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixf(glm::value_ptr(input.view.viewMatrix()));
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glLightfv(GL_LIGHT0, GL_POSITION, glm::value_ptr(glm::vec4(light.sunDirection, 0.0F)));
    glLightfv(GL_LIGHT0, GL_DIFFUSE, glm::value_ptr(glm::vec4(light.sun, 1.0F)));
    const glm::vec4 ambient((light.sky + light.bounce) * 0.5F, 1.0F);
    glLightModelfv(GL_LIGHT_MODEL_AMBIENT, glm::value_ptr(ambient));
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glEnable(GL_COLOR_MATERIAL);
    glEnable(GL_NORMALIZE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glClearColor(light.horizon.x, light.horizon.y, light.horizon.z, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void PaperMethod::drawPeople(const RenderInput& input)
{
    const Population& people = input.frame->population;
    std::uint64_t lastMaterial = ~std::uint64_t{0};
    const Template* asset = nullptr;
    const Slot* slot = nullptr;
    const MaterialChoice* material = nullptr;
    std::size_t slotIndex = 0;
    for (const Call& call : m_people) {
        if (call.key >> 32U != lastMaterial) {
            lastMaterial = call.key >> 32U;
            const auto id = static_cast<TemplateId>(call.key >> 48U);
            asset = std::ranges::find(*input.frame->templates, id, &TemplateEntry::id)->asset.get();
            slotIndex = static_cast<std::size_t>(
                asset->levels.front().submeshes[call.key >> 40U & 0xFFU].slot);
            slot = &asset->slots[slotIndex];
            const std::size_t choice = call.key >> 32U & 0xFFU;
            material = &slot->choices[choice < slot->choices.size() ? choice : 0];
            bindImage(material->image < 0
                          ? nullptr
                          : &m_assets[asset].textures[static_cast<std::size_t>(material->image)]);
            (material->doubleSided ? glDisable : glEnable)(GL_CULL_FACE);
        }
        Tint tint;
        if (slotIndex < static_cast<std::size_t>(kMaxTintSlots)) {
            tint = people.column(columns::tint(static_cast<int>(slotIndex)))[call.row];
        }
        glColor4fv(glm::value_ptr(tinted(*material, tint, slot->tintable)));
        glPushMatrix();
        const glm::mat4 matrix = individualMatrix(
            people.column(columns::position)[call.row], people.column(columns::heading)[call.row],
            people.column(columns::height)[call.row], people.column(columns::girth)[call.row]);
        glMultMatrixf(glm::value_ptr(matrix));
        glCallList(call.list);
        glPopMatrix();
        ++m_calls;
    }
}

void PaperMethod::drawStages(const RenderInput& input)
{
    for (const StageEntry& entry : input.stages) {
        if (!entry.asset) {
            continue;
        }
        std::vector<std::uint32_t>& lists = m_stageLists[entry.asset.get()];
        std::vector<GlTexture>& textures = m_stageTextures[entry.asset.get()];
        if (lists.empty()) {
            for (const Image& image : entry.asset->images) {
                textures.push_back(uploadImage(image, {}));
            }
            for (const StageMesh& mesh : entry.asset->meshes) {
                lists.push_back(glGenLists(1));
                glNewList(lists.back(), GL_COMPILE);
                emitStageMesh(mesh);
                glEndList();
            }
        }
        glPushMatrix();
        glMultMatrixf(glm::value_ptr(entry.worldFromStage()));
        for (std::size_t i = 0; i < lists.size(); ++i) {
            const auto index = static_cast<std::size_t>(entry.asset->meshes[i].material);
            const MaterialChoice& material = entry.asset->materials[index];
            bindImage(material.image < 0 ? nullptr
                                         : &textures[static_cast<std::size_t>(material.image)]);
            (material.doubleSided ? glDisable : glEnable)(GL_CULL_FACE);
            glCallList(lists[i]);
            ++m_calls;
        }
        glPopMatrix();
    }
}

/// A plain ground and a sky that runs from horizon to zenith over the picture.
void PaperMethod::drawBackground(const RenderInput& input) const
{
    const LinearLight light = LinearLight::from(input.lighting);
    bindImage(nullptr);
    glDisable(GL_CULL_FACE);
    glDisable(GL_LIGHTING);
    if (input.showGround) {
        glColor3fv(glm::value_ptr(light.ground * light.onGround()));
        glBegin(GL_TRIANGLE_STRIP);
        for (int corner = 0; corner < 4; ++corner) {
            glVertex3f((corner & 1) != 0 ? kGroundHalfSize : -kGroundHalfSize, -0.02F,
                       (corner & 2) != 0 ? kGroundHalfSize : -kGroundHalfSize);
        }
        glEnd();
    }
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glBegin(GL_TRIANGLE_STRIP);
    for (int corner = 0; corner < 4; ++corner) {
        glColor3fv(glm::value_ptr((corner & 2) != 0 ? light.zenith : light.horizon));
        glVertex3f((corner & 1) != 0 ? 1.0F : -1.0F, (corner & 2) != 0 ? 1.0F : -1.0F, 1.0F);
    }
    glEnd();
}

Result<void> PaperMethod::draw(const RenderInput& input)
{
    const glm::ivec2 size =
        input.pixelSize.x > 0 ? input.pixelSize : glm::ivec2(input.view.size() + 0.5F);
    if (auto begun = m_target.begin(size, input.samples); !begun) {
        return begun;
    }
    m_calls = 0;
    setUp(input);
    if (input.frame) {
        collect(input);
        drawPeople(input);
    }
    drawStages(input);
    drawBackground(input);
    m_target.end(nullptr, false);
    return {};
}

} // namespace crowd::render
