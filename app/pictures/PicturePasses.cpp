// SPDX-License-Identifier: MIT
#include "app/pictures/PicturePasses.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <QtCore/QJsonDocument>
#include <QtCore/QJsonObject>
#include <glm/geometric.hpp>

namespace crowd::app {

namespace {

using render::AovPicture;

constexpr float kFarthest = 1e10F; ///< depth of the sky, as other programs write it

ExrChannel floatsOf(std::string name, std::size_t count, bool isHalf = false)
{
    return {std::move(name), std::vector<float>(count), isHalf};
}

std::vector<float>& floats(ExrChannel& channel)
{
    return std::get<std::vector<float>>(channel.values);
}

ExrLayer colourPass(const PassSource& source)
{
    return deepColourLayer(source.colours, source.isTransparent);
}

ExrLayer depthPass(const PassSource& source)
{
    const AovPicture& aovs = source.aovs;
    const glm::vec3 eye = source.camera.position;
    const glm::vec3 forward = source.camera.forward();
    ExrLayer layer{"depth", {floatsOf("depth.Z", aovs.rows.size())}};
    for (std::size_t i = 0; i < aovs.rows.size(); ++i) {
        floats(layer.channels[0])[i] = aovs.rows[i] == AovPicture::kNothing
                                           ? kFarthest
                                           : glm::dot(aovs.places[i] - eye, forward);
    }
    return layer;
}

ExrLayer vectorPass(const std::string& name, const std::vector<glm::vec3>& vectors, bool isHalf)
{
    ExrLayer layer{name, {}};
    constexpr std::array kAxes{".X", ".Y", ".Z"};
    for (int axis = 0; axis < 3; ++axis) {
        const std::string axisName = kAxes[static_cast<std::size_t>(axis)];
        ExrChannel channel = floatsOf(name + axisName, vectors.size(), isHalf);
        std::ranges::transform(vectors, floats(channel).begin(),
                               [axis](const glm::vec3& each) { return each[axis]; });
        layer.channels.push_back(std::move(channel));
    }
    return layer;
}

ExrLayer normalPass(const PassSource& source)
{
    return vectorPass("normal", source.aovs.normals, true);
}

ExrLayer positionPass(const PassSource& source)
{
    return vectorPass("position", source.aovs.places, false);
}

/// Named as compositing programs know it, which blur along it.
ExrLayer motionPass(const PassSource& source)
{
    const AovPicture& aovs = source.aovs;
    ExrLayer layer{"backward", {}};
    constexpr std::array kAxes{".u", ".v"};
    for (int axis = 0; axis < 2; ++axis) {
        ExrChannel channel =
            floatsOf(layer.name + kAxes[static_cast<std::size_t>(axis)], aovs.rows.size());
        // Without a moment before nothing has moved.
        std::ranges::transform(aovs.before, floats(channel).begin(),
                               [axis](const glm::vec2& each) { return each[axis]; });
        layer.channels.push_back(std::move(channel));
    }
    return layer;
}

/// Whatever a person has, 0 where there is none.
template<class Of>
ExrLayer numberPass(const std::string& name, const PassSource& source, const Of& of)
{
    std::vector<std::uint32_t> numbers;
    numbers.reserve(source.aovs.rows.size());
    const auto people = static_cast<std::int32_t>(source.frame.population.size());
    for (const std::int32_t row : source.aovs.rows) {
        const bool isPerson = row >= 0 && row < people;
        numbers.push_back(isPerson ? of(static_cast<std::size_t>(row)) : 0U);
    }
    return {name, {{name + ".X", std::move(numbers), false}}};
}

ExrLayer individualPass(const PassSource& source)
{
    const auto ids = source.frame.population.ids();
    return numberPass("id", source,
                      [ids](std::size_t row) { return static_cast<std::uint32_t>(ids[row]); });
}

ExrLayer templatePass(const PassSource& source)
{
    const auto templates = source.frame.population.column(model::columns::templateId);
    return numberPass("template", source, [templates](std::size_t row) {
        return static_cast<std::uint32_t>(templates[row]);
    });
}

ExrLayer cryptomattePass(const PassSource& source)
{
    return cryptomatteLayer(source.coverage, source.frame);
}

constexpr PicturePass kPasses[] = {
    {"colour", QT_TRANSLATE_NOOP("PicturePasses", "Colour"),
     "red, green, blue and alpha of the finished picture, as linear light beyond 8 bits and white, "
     "colours times alpha",
     PassNeed::Colours, &colourPass},
    {"depth", QT_TRANSLATE_NOOP("PicturePasses", "Depth"),
     "metres along the view axis; 1e10 where nothing is", PassNeed::Aovs, &depthPass,
     &depthSamples},
    {"normal", QT_TRANSLATE_NOOP("PicturePasses", "Normal"),
     "unit vectors, world, towards the camera's side; 0 where nothing is", PassNeed::Aovs,
     &normalPass, &normalSamples},
    {"position", QT_TRANSLATE_NOOP("PicturePasses", "Position"),
     "metres, world, Y up; 0 where nothing is", PassNeed::Aovs, &positionPass, &positionSamples},
    {"motion", QT_TRANSLATE_NOOP("PicturePasses", "Motion"),
     "pixels, right and up, to where the same point was a frame earlier; 0 where somebody was not "
     "there yet",
     PassNeed::Motion, &motionPass, &motionSamples},
    {"id", QT_TRANSLATE_NOOP("PicturePasses", "Individual"),
     "the individual's id; 0 where nobody is", PassNeed::Aovs, &individualPass, &numberSamples},
    {"template", QT_TRANSLATE_NOOP("PicturePasses", "Template"),
     "the individual's template; 0 where nobody is", PassNeed::Aovs, &templatePass, &numberSamples},
    {"cryptomatte", QT_TRANSLATE_NOOP("PicturePasses", "Cryptomatte"),
     "mattes of everybody and of every template with smooth edges, by the Cryptomatte "
     "specification; 24 components; sharp where the colours have depth of field",
     PassNeed::Coverage, &cryptomattePass, nullptr, &addCryptomatteNotes}};

std::string templatesOf(const model::CrowdFrame& frame)
{
    QJsonObject names;
    if (frame.templates) {
        for (const model::TemplateEntry& entry : *frame.templates) {
            names[QString::number(entry.id)] = QString::fromStdString(entry.name);
        }
    }
    return QJsonDocument(names).toJson(QJsonDocument::Compact).toStdString();
}

std::string_view withoutBlanks(std::string_view text)
{
    while (text.starts_with(' ')) {
        text.remove_prefix(1);
    }
    while (text.ends_with(' ')) {
        text.remove_suffix(1);
    }
    return text;
}

const PicturePass* passOf(std::string_view key)
{
    const auto* found = std::ranges::find(kPasses, key, &PicturePass::key);
    return found != std::end(kPasses) ? found : nullptr;
}

} // namespace

std::span<const PicturePass> picturePasses()
{
    return kPasses;
}

std::string passKeys()
{
    std::string all;
    for (const PicturePass& pass : kPasses) {
        all += (all.empty() ? "" : ", ") + std::string(pass.key);
    }
    return all;
}

model::Result<PicturePasses> passesOf(std::string_view keys)
{
    PicturePasses passes;
    bool isMore = !keys.empty();
    while (isMore) {
        const std::size_t comma = keys.find(',');
        const std::string_view key = withoutBlanks(keys.substr(0, comma));
        const PicturePass* pass = passOf(key);
        if (pass == nullptr) {
            return model::Error{
                QT_TRANSLATE_NOOP("Messages", "There is no pass \"%1\". There are: %2."),
                std::string(key), passKeys()};
        }
        passes.push_back(pass);
        isMore = comma != std::string_view::npos;
        keys.remove_prefix(isMore ? comma + 1 : keys.size());
    }
    std::ranges::sort(passes);
    passes.erase(std::unique(passes.begin(), passes.end()), passes.end());
    return passes;
}

bool needAny(const PicturePasses& passes, PassNeed need)
{
    return std::ranges::find(passes, need, &PicturePass::need) != passes.end();
}

ExrHeader exrHeaderOf(const PicturePasses& passes, const model::Camera& camera, glm::ivec2 size,
                      const model::CrowdFrame& frame)
{
    const model::View view(camera, glm::vec2(size));
    ExrHeader header{size, view.viewMatrix(), view.viewProjection(), {}};
    header.notes["crowdbrush.templates"] = templatesOf(frame);
    for (const PicturePass* pass : passes) {
        if (pass->addNotes != nullptr) {
            pass->addNotes(frame, header);
        }
    }
    return header;
}

std::vector<ExrLayer> layersOf(const PicturePasses& passes, const PassSource& source)
{
    std::vector<ExrLayer> layers;
    layers.reserve(passes.size());
    for (const PicturePass* pass : passes) {
        layers.push_back(pass->layer(source));
    }
    return layers;
}

} // namespace crowd::app
