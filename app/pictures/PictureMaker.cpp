// SPDX-License-Identifier: MIT
#include "app/pictures/PictureMaker.h"

#include "app/pictures/PictureFile.h"
#include "render/SceneLook.h"

namespace crowd::app {

namespace {

/// Places of a lens that a picture is seen through: enough that single ones are not told apart
/// where bright things are soft.
constexpr int kPlacesOfLens = 96;
/// Of pictures with passes: all of them take 200 bytes a pixel.
constexpr std::int64_t kMostPixels = 40'000'000;

render::RenderInput inputOf(const PictureRequest& request, model::KeyframeStore& keyframes)
{
    render::RenderInput input(model::View(request.camera, glm::vec2(request.size)), keyframes);
    input.frame = request.frame;
    input.pixelSize = request.size;
    input.stages = request.stages;
    input.seats = request.seats;
    input.seatsVersion = request.seatsVersion;
    input.lighting = request.lighting;
    input.lights = request.lights;
    input.look = request.look;
    input.showShadows = request.showShadows;
    input.isTransparent = request.isTransparent;
    input.lens = request.lens;
    if (request.ownLook) {
        render::useLook(input, *request.ownLook);
    }
    input.levels.hysteresis = 0.0F; // a picture does not depend on the one before
    return input;
}

model::Error contextLost()
{
    return {QT_TRANSLATE_NOOP("Messages",
                              "The graphics context for pictures was lost. Start the program "
                              "again.")};
}

model::Error stopped()
{
    return {QT_TRANSLATE_NOOP("Messages", "The picture was stopped.")};
}

} // namespace

model::Result<std::unique_ptr<PictureMaker>> PictureMaker::create(model::KeyframeStore& keyframes)
{
    auto context = render::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    std::unique_ptr<PictureMaker> maker(new PictureMaker(keyframes));
    maker->m_context = std::move(context).value();
    if (auto ready = maker->m_renderer.initialize(); !ready) {
        return ready.error();
    }
    return maker;
}

PictureMaker::~PictureMaker()
{
    if (m_context && m_context->makeCurrent()) {
        m_renderer.destroy();
    }
}

model::Result<void> PictureMaker::draw(const PictureRequest& request,
                                       const model::KeepGoing& keepGoing)
{
    if (!m_context->makeCurrent()) {
        return contextLost();
    }
    const render::RenderInput input = inputOf(request, m_keyframes);
    auto drawn = drawComplete(input);
    // Clips of earlier pictures may leave no room for these; a picture does not depend on them.
    if (drawn && m_hasDrawn && m_renderer.statistics().areKeyframesMissing) {
        m_renderer.destroy();
        m_keyframes.clear();
        drawn = m_renderer.initialize();
        if (drawn) {
            drawn = drawComplete(input);
        }
    }
    m_hasDrawn = true;
    return drawn && input.lens ? ripen(input, keepGoing) : drawn;
}

model::Result<render::AovPicture> PictureMaker::aovs(const PictureRequest& request,
                                                     const PicturePasses& passes)
{
    const bool needsMotion = needAny(passes, PassNeed::Motion);
    if (!needsMotion && !needAny(passes, PassNeed::Aovs)) {
        return render::AovPicture();
    }
    render::RenderInput input = inputOf(request, m_keyframes);
    if (needsMotion) {
        input.earlier = request.earlier;
    }
    return m_renderer.drawAovs(input);
}

model::Result<Coverage> PictureMaker::coverage(const PictureRequest& request,
                                               const PicturePasses& passes,
                                               const model::KeepGoing& keepGoing)
{
    Coverage coverage;
    if (!needAny(passes, PassNeed::Coverage)) {
        return coverage;
    }
    render::RenderInput input = inputOf(request, m_keyframes);
    input.lens.reset();
    for (int n = 0; n < kCoverageSamples; ++n) {
        if (keepGoing && !keepGoing(static_cast<float>(n) / kCoverageSamples)) {
            return stopped();
        }
        input.ripeness = n;
        const auto sample = m_renderer.drawAovs(input);
        if (!sample) {
            return sample.error();
        }
        coverage.add(sample.value(), *request.frame);
    }
    return coverage;
}

model::Result<std::vector<ExrLayer>> PictureMaker::layers(const PictureRequest& request,
                                                          const PicturePasses& passes,
                                                          const model::KeepGoing& keepGoing)
{
    if (!m_context->makeCurrent()) {
        return contextLost();
    }
    const auto pixelCount = static_cast<std::int64_t>(request.size.x) * request.size.y;
    if (pixelCount > kMostPixels && !passes.empty()) {
        return model::Error{
            QT_TRANSLATE_NOOP("Messages",
                              "%1 by %2 pixels are too many for passes, whose numbers take much "
                              "memory: at most 40 million. Choose a smaller size."),
            request.size.x, request.size.y};
    }
    const auto shown = aovs(request, passes);
    if (!shown) {
        return shown.error();
    }
    const auto covered = coverage(request, passes, keepGoing);
    if (!covered) {
        return covered.error();
    }
    return layersOf(passes, {pixels(), request.isTransparent, shown.value(), covered.value(),
                             *request.frame, request.camera});
}

model::Result<void> PictureMaker::save(const QString& path, const PictureRequest& request,
                                       const PicturePasses& passes,
                                       const model::KeepGoing& keepGoing)
{
    if (passes.empty()) {
        return writePicture(path, pixels(), size(), request.isTransparent);
    }
    const auto made = layers(request, passes, keepGoing);
    if (!made) {
        return made.error();
    }
    return writeLayers(path, exrHeaderOf(passes, request.camera, size(), *request.frame),
                       made.value());
}

/// The mean of pictures through all of the lens.
model::Result<void> PictureMaker::ripen(render::RenderInput input,
                                        const model::KeepGoing& keepGoing)
{
    input.samples = 0; // the mean has smooth edges
    model::Result<void> drawn;
    for (int n = 0; n < kPlacesOfLens && drawn; ++n) {
        if (keepGoing && !keepGoing(static_cast<float>(n) / kPlacesOfLens)) {
            return stopped();
        }
        input.ripeness = n;
        drawn = m_renderer.draw(input);
    }
    return drawn;
}

/// The first time asks for the clips; it is drawn again when they are complete.
model::Result<void> PictureMaker::drawComplete(const render::RenderInput& input)
{
    auto drawn = m_renderer.draw(input);
    if (drawn && m_renderer.statistics().areKeyframesMissing) {
        m_keyframes.waitForAll();
        drawn = m_renderer.draw(input);
    }
    return drawn;
}

} // namespace crowd::app
