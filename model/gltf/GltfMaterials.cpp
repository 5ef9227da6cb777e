// SPDX-License-Identifier: MIT
#include "model/gltf/GltfMaterials.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "model/gltf/GltfGloss.h"
#include "model/gltf/GltfNames.h"
#include "model/gltf/GltfValue.h"

namespace crowd::model::gltf {

namespace {

constexpr std::size_t kMaxCompared = 64; ///< slots of one name that a further one may join
constexpr int kNoMaterial = std::numeric_limits<int>::max(); ///< sorts behind all others
constexpr float kSteepest = 20.0F;                           ///< that a normal map is made

const tinygltf::Material& materialAt(const tinygltf::Model& model, int material)
{
    static const tinygltf::Material plain;
    return material == kNoMaterial ? plain : model.materials[static_cast<std::size_t>(material)];
}

/// A picture as a material refers to it.
struct TextureUse
{
    int texture = -1;
    int texCoord = 0;
    const tinygltf::Value* transform = nullptr; ///< KHR_texture_transform
};

/// Where the base colour comes from, in whichever of the two workflows.
struct BaseColor
{
    glm::vec4 factor{1.0F};
    TextureUse use;
};

TextureUse useOf(int texture, int texCoord, const tinygltf::Value* transform)
{
    return {texture, transform ? wholeIn(*transform, "texCoord", texCoord) : texCoord, transform};
}

glm::vec4 colorOf(const std::vector<double>& values)
{
    glm::vec4 color(1.0F);
    for (std::size_t i = 0; i < std::min<std::size_t>(values.size(), 4); ++i) {
        if (std::isfinite(values[i])) {
            color[static_cast<int>(i)] = static_cast<float>(values[i]);
        }
    }
    return color;
}

BaseColor baseColorOf(const tinygltf::Material& material)
{
    BaseColor base;
    const tinygltf::Value* glossiness =
        find(material.extensions, "KHR_materials_pbrSpecularGlossiness");
    if (glossiness != nullptr) {
        numbersIn(*glossiness, "diffuseFactor", 4, &base.factor.x);
        if (const tinygltf::Value* texture = find(*glossiness, "diffuseTexture")) {
            const tinygltf::Value* extensions = find(*texture, "extensions");
            base.use = useOf(wholeIn(*texture, "index", -1), wholeIn(*texture, "texCoord", 0),
                             extensions ? find(*extensions, "KHR_texture_transform") : nullptr);
        }
    } else {
        const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
        base.factor = colorOf(pbr.baseColorFactor);
        base.use = useOf(pbr.baseColorTexture.index, pbr.baseColorTexture.texCoord,
                         find(pbr.baseColorTexture.extensions, "KHR_texture_transform"));
    }
    return base;
}

TextureUse emissiveUseOf(const tinygltf::Material& material)
{
    const tinygltf::TextureInfo& from = material.emissiveTexture;
    return useOf(from.index, from.texCoord, find(from.extensions, "KHR_texture_transform"));
}

/// The set of texture coordinates that a material's pictures lie by: a vertex has one set.
int texCoordOf(const tinygltf::Material& material)
{
    const TextureUse base = baseColorOf(material).use;
    const TextureUse emissive = emissiveUseOf(material);
    const tinygltf::NormalTextureInfo& normal = material.normalTexture;
    return base.texture >= 0       ? base.texCoord
           : emissive.texture >= 0 ? emissive.texCoord
           : normal.index >= 0     ? useOf(normal.index, normal.texCoord,
                                           find(normal.extensions, "KHR_texture_transform"))
                                     .texCoord
                               : base.texCoord;
}

/// KHR_texture_transform: translation * rotation * scale, rotation counter-clockwise as seen in the
/// picture, whose v axis points down.
std::array<float, 6> uvTransform(const tinygltf::Value& transform)
{
    float offset[2] = {0.0F, 0.0F};
    float scale[2] = {1.0F, 1.0F};
    numbersIn(transform, "offset", 2, offset);
    numbersIn(transform, "scale", 2, scale);
    const float angle = floatIn(transform, "rotation").value_or(0.0F);
    const float cosine = std::cos(angle);
    const float sine = std::sin(angle);
    return {cosine * scale[0], sine * scale[1],   offset[0],
            -sine * scale[0],  cosine * scale[1], offset[1]};
}

Wrap wrapOf(int mode)
{
    switch (mode) {
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE:
        return Wrap::Clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT:
        return Wrap::Mirror;
    default:
        return Wrap::Repeat;
    }
}

void applySampler(const tinygltf::Model& model, int texture, MaterialChoice& choice)
{
    const int sampler = model.textures[static_cast<std::size_t>(texture)].sampler;
    if (sampler >= 0) {
        const tinygltf::Sampler& from = model.samplers[static_cast<std::size_t>(sampler)];
        choice.wrapU = wrapOf(from.wrapS);
        choice.wrapV = wrapOf(from.wrapT);
        choice.nearest = from.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
}

glm::vec3 emissiveOf(const tinygltf::Material& material)
{
    glm::vec3 emissive(0.0F);
    if (material.emissiveFactor.size() == 3) {
        emissive = {material.emissiveFactor[0], material.emissiveFactor[1],
                    material.emissiveFactor[2]};
    }
    if (const auto* strength = find(material.extensions, "KHR_materials_emissive_strength")) {
        emissive *= floatIn(*strength, "emissiveStrength").value_or(1.0F);
    }
    return emissive;
}

/// Whether two slots look the same, so that coarser levels can share the slot of the finer.
bool looksLike(const MaterialChoice& a, const MaterialChoice& b)
{
    constexpr float kAlike = 0.05F;
    return a.image == b.image && a.tintMask == b.tintMask && a.unlit == b.unlit &&
           a.alphaMode == b.alphaMode && a.alphaCutoff == b.alphaCutoff &&
           a.doubleSided == b.doubleSided && a.uvTransform == b.uvTransform &&
           a.emissiveImage == b.emissiveImage && a.emissiveUvTransform == b.emissiveUvTransform &&
           a.wrapU == b.wrapU && a.wrapV == b.wrapV && a.nearest == b.nearest &&
           std::abs(a.roughness - b.roughness) < kAlike &&
           std::abs(a.metallic - b.metallic) < kAlike &&
           glm::all(glm::lessThan(glm::abs(a.emissive - b.emissive), glm::vec3(1e-3F))) &&
           glm::all(glm::lessThan(glm::abs(a.baseColor - b.baseColor), glm::vec4(1e-3F)));
}

} // namespace

SlotTable::SlotTable(const GltfFile& file, std::vector<Message>& warnings)
    : m_file(file), m_warnings(warnings), m_images(file, warnings)
{
}

SlotTable::Key SlotTable::keyOf(const tinygltf::Primitive& primitive)
{
    Key key{primitive.material < 0 ? kNoMaterial : primitive.material};
    const tinygltf::Value* extension = find(primitive.extensions, "KHR_materials_variants");
    const tinygltf::Value* mappings = extension ? find(*extension, "mappings") : nullptr;
    std::map<int, int> materialOfVariant;
    for (std::size_t i = 0; mappings && mappings->IsArray() && i < mappings->ArrayLen(); ++i) {
        const tinygltf::Value& mapping = mappings->Get(static_cast<int>(i));
        const tinygltf::Value* variants = find(mapping, "variants");
        for (std::size_t v = 0; variants && variants->IsArray() && v < variants->ArrayLen(); ++v) {
            materialOfVariant[variants->Get(static_cast<int>(v)).GetNumberAsInt()] =
                wholeIn(mapping, "material", kNoMaterial);
        }
    }
    for (const auto& [variant, material] : materialOfVariant) {
        key.insert(key.end(), {variant, material});
    }
    return key;
}

void SlotTable::add(const tinygltf::Primitive& primitive)
{
    m_slotOfKey[keyOf(primitive)] = -1;
}

void SlotTable::finish()
{
    for (auto& entry : m_slotOfKey) {
        mergeIntoEarlier(entry.first, makeSlot(entry.first));
    }
    if (m_slots.empty()) {
        m_slots.push_back(makeSlot({kNoMaterial}));
    }
    if (m_file.wantsReliefs) {
        addReliefs();
    }
    NameSet names;
    for (Slot& slot : m_slots) {
        slot.name = names.unique(slot.name);
    }
    if (m_slots.size() > static_cast<std::size_t>(kMaxTintSlots)) {
        m_warnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "The file has %1 slots; only the first %2 can be tinted."),
            m_slots.size(), kMaxTintSlots);
    }
}

/// Materials that name the same slot in their extras and look the same are one slot.
void SlotTable::mergeIntoEarlier(const Key& key, Slot slot)
{
    const tinygltf::Material& material = materialAt(*m_file.model, key.front());
    std::vector<std::size_t>& sameName = m_slotsOfName[slot.name];
    if (!textIn(material.extras, "slot").empty()) {
        for (const std::size_t i : sameName) {
            if (m_slots[i].choices.size() == slot.choices.size() &&
                looksLike(m_slots[i].choices[0], slot.choices[0])) {
                m_slotOfKey[key] = static_cast<int>(i);
                return;
            }
        }
    }
    if (sameName.size() < kMaxCompared) {
        sameName.push_back(m_slots.size());
    }
    m_slotOfKey[key] = static_cast<int>(m_slots.size());
    m_slots.push_back(std::move(slot));
}

int SlotTable::slotOf(const tinygltf::Primitive& primitive) const
{
    return m_slotOfKey.at(keyOf(primitive));
}

int SlotTable::texCoordOf(const tinygltf::Primitive& primitive) const
{
    const int material = primitive.material < 0 ? kNoMaterial : primitive.material;
    return gltf::texCoordOf(materialAt(*m_file.model, material));
}

Slot SlotTable::makeSlot(const Key& key)
{
    const tinygltf::Material& material = materialAt(*m_file.model, key.front());
    Slot slot;
    slot.name = textIn(material.extras, "slot");
    if (slot.name.empty()) {
        slot.name = !material.name.empty()       ? material.name
                    : key.front() == kNoMaterial ? std::string("default")
                                                 : "material_" + std::to_string(key.front());
    }
    const std::optional<bool> isTintable = flagIn(material.extras, "tintable");
    slot.tintable = isTintable.value_or(true);
    slot.takesPalette =
        slot.tintable && (isTintable.has_value() || !textIn(material.extras, "slot").empty());
    slot.choices.push_back(makeChoice(key.front()));
    for (std::size_t i = 1; i + 1 < key.size(); i += 2) {
        slot.choices.push_back(makeChoice(key[i + 1]));
        slot.choices.back().name = variantName(key[i]);
        const int texCoord = gltf::texCoordOf(materialAt(*m_file.model, key[i + 1]));
        if (slot.choices.back().image >= 0 && texCoord != gltf::texCoordOf(material)) {
            m_warnings.emplace_back(
                QT_TRANSLATE_NOOP("Messages",
                                  "Slot \"%1\", variant \"%2\": its picture lies by another set of "
                                  "coordinates than the default's, which is used for both."),
                slot.name, slot.choices.back().name);
        }
    }
    return slot;
}

MaterialChoice SlotTable::makeChoice(int index)
{
    const tinygltf::Model& model = *m_file.model;
    const tinygltf::Material& material = materialAt(model, index);
    const BaseColor base = baseColorOf(material);
    MaterialChoice choice;
    choice.name = material.name;
    choice.baseColor = base.factor;
    choice.image = m_images.fromTexture(base.use.texture);
    if (base.use.texture >= 0) {
        applySampler(model, base.use.texture, choice);
    }
    if (base.use.transform != nullptr) {
        choice.uvTransform = uvTransform(*base.use.transform);
    }
    const int mask = wholeIn(material.extras, "tintMask", -1);
    if (mask >= 0 && static_cast<std::size_t>(mask) < model.textures.size()) {
        choice.tintMask = m_images.fromTexture(mask);
    } else if (mask >= 0) {
        m_warnings.emplace_back(
            QT_TRANSLATE_NOOP(
                "Messages",
                "Material \"%1\": extras.tintMask is %2, which is no texture of the file."),
            material.name, mask);
    }
    choice.alphaMode = material.alphaMode == "MASK"    ? AlphaMode::Mask
                       : material.alphaMode == "BLEND" ? AlphaMode::Blend
                                                       : AlphaMode::Opaque;
    choice.alphaCutoff = static_cast<float>(material.alphaCutoff);
    choice.doubleSided = material.doubleSided;
    choice.unlit = find(material.extensions, "KHR_materials_unlit") != nullptr;
    choice.emissive = emissiveOf(material);
    addGlow(material, choice);
    const Gloss gloss = glossOf(material, m_images);
    choice.roughness = gloss.roughness;
    choice.metallic = gloss.metallic;
    return choice;
}

/// The factor alone would make the whole slot shine: a picture that cannot be shown puts it out.
void SlotTable::addGlow(const tinygltf::Material& material, MaterialChoice& choice)
{
    const TextureUse use = emissiveUseOf(material);
    if (use.texture < 0 || choice.emissive == glm::vec3(0.0F)) {
        return;
    }
    const bool fits = use.texCoord == gltf::texCoordOf(material);
    choice.emissiveImage = fits ? m_images.fromTexture(use.texture) : -1;
    if (!fits) {
        m_warnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "Material \"%1\": its emissive picture lies by another set of "
                              "coordinates than its base colour, and is left out."),
            material.name);
    }
    if (choice.emissiveImage < 0) {
        choice.emissive = glm::vec3(0.0F);
        return;
    }
    if (choice.image < 0) {
        applySampler(*m_file.model, use.texture, choice);
    }
    if (use.transform != nullptr) {
        choice.emissiveUvTransform = uvTransform(*use.transform);
    }
}

/// After all other pictures: where there are too many, these are the ones to do without.
void SlotTable::addReliefs()
{
    for (const auto& [key, slot] : m_slotOfKey) {
        MaterialChoice& choice = m_slots[static_cast<std::size_t>(slot)].choices.front();
        if (choice.normalImage < 0 && !choice.unlit) {
            addRelief(materialAt(*m_file.model, key.front()), choice);
        }
    }
}

void SlotTable::addRelief(const tinygltf::Material& material, MaterialChoice& choice)
{
    const tinygltf::NormalTextureInfo& from = material.normalTexture;
    const TextureUse use =
        useOf(from.index, from.texCoord, find(from.extensions, "KHR_texture_transform"));
    if (use.texture < 0) {
        return;
    }
    const bool hasOthers = choice.image >= 0 || choice.emissiveImage >= 0;
    if (hasOthers && use.texCoord != gltf::texCoordOf(material)) {
        m_warnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages",
                              "Material \"%1\": its normal map lies by another set of coordinates "
                              "than its base colour, and is left out."),
            material.name);
        return;
    }
    choice.normalImage = m_images.fromTexture(use.texture);
    if (choice.normalImage < 0) {
        return;
    }
    const auto scale = static_cast<float>(from.scale);
    choice.normalScale = std::isfinite(scale) ? std::clamp(scale, -kSteepest, kSteepest) : 1.0F;
    if (!hasOthers) {
        applySampler(*m_file.model, use.texture, choice);
    }
    if (use.transform != nullptr) {
        choice.normalUvTransform = uvTransform(*use.transform);
    }
}

std::string SlotTable::variantName(int variant) const
{
    const tinygltf::Value* extension = find(m_file.model->extensions, "KHR_materials_variants");
    const tinygltf::Value* variants = extension ? find(*extension, "variants") : nullptr;
    const std::string name =
        variants && variants->IsArray() ? textIn(variants->Get(variant), "name") : std::string();
    return name.empty() ? "variant " + std::to_string(variant + 1) : name;
}

} // namespace crowd::model::gltf
