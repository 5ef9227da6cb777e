// SPDX-License-Identifier: MIT
#include "app/pictures/PictureMaker.h"

#include "app/pictures/PassFile.h"
#include "app/pictures/PictureFile.h"
#include "app/pictures/PictureFormats.h"
#include "app/pictures/PictureTiles.h"
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

model::Error stopped()
{
    return {QT_TRANSLATE_NOOP("Messages", "The picture was stopped.")};
}

/// Whether all numbers of so many pixels fit in the memory.
model::Result<void> roomForLayers(glm::ivec2 size)
{
    if (static_cast<std::int64_t>(size.x) * size.y <= kMostPixels) {
        return {};
    }
    return model::Error{
        QT_TRANSLATE_NOOP("Messages",
                          "%1 by %2 pixels are too many for passes, whose numbers take much "
                          "memory: at most 40 million. Choose a smaller size."),
        size.x, size.y};
}

/// Of a picture in tiles.
class Progress
{
public:
    Progress(const model::KeepGoing& keepGoing, std::size_t tiles)
        : m_keepGoing(keepGoing), m_tiles(static_cast<double>(tiles))
    {
    }

    /// False: it is to stop.
    [[nodiscard]] bool next()
    {
        ++m_tile;
        return !m_keepGoing || m_tiles == 1.0 || m_keepGoing(m_tile / m_tiles);
    }
    /// Of what is drawn now.
    [[nodiscard]] model::KeepGoing ofTile() const
    {
        if (!m_keepGoing) {
            return {};
        }
        return [this](double share) { return m_keepGoing((m_tile + share) / m_tiles); };
    }

private:
    const model::KeepGoing& m_keepGoing;
    double m_tiles;
    double m_tile = -1.0;
};

} // namespace

model::Result<std::unique_ptr<PictureMaker>> PictureMaker::create(model::KeyframeStore& keyframes)
{
    std::unique_ptr<PictureMaker> maker(new PictureMaker(keyframes));
    if (auto ready = maker->beCurrent(); !ready) {
        return ready.error();
    }
    return maker;
}

/// A context that a driver has lost is made again, and everything sent once more.
model::Result<void> PictureMaker::beCurrent()
{
    if (m_context && m_context->makeCurrent()) {
        return {};
    }
    m_renderer.abandon();
    m_context.reset();
    auto context = render::OffscreenContext::create();
    if (!context) {
        return context.error();
    }
    m_context = std::move(context).value();
    return m_renderer.initialize();
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
    m_pixels.clear();
    auto drawn = allRows(request, false, keepGoing);
    if (!drawn) {
        return drawn.error();
    }
    m_pixels = std::move(drawn).value();
    return {};
}

model::Result<std::vector<std::uint8_t>>
PictureMaker::allRows(const PictureRequest& request, bool isDeep, const model::KeepGoing& keepGoing)
{
    std::vector<std::uint8_t> pixels;
    const auto keep = [&pixels](std::span<const std::uint8_t> rows) -> model::Result<void> {
        pixels.insert(pixels.end(), rows.begin(), rows.end());
        return {};
    };
    if (auto drawn = drawRows(request, isDeep, keep, keepGoing); !drawn) {
        return drawn.error();
    }
    return pixels;
}

model::Result<void> PictureMaker::drawRows(const PictureRequest& request, bool isDeep,
                                           const RowSink& sink, const model::KeepGoing& keepGoing)
{
    if (auto ready = beCurrent(); !ready) {
        return ready.error();
    }
    render::RenderInput input = inputOf(request, m_keyframes);
    input.isDeep = isDeep;
    const model::View whole = input.view;
    const std::vector<TileRow> rows = tilesOf(request.size, request.tileSide);
    const auto width = static_cast<std::size_t>(request.size.x);
    std::vector<std::uint8_t> pixels;
    const std::size_t tiles = rows.size() * rows.front().size();
    Progress progress{keepGoing, tiles};
    for (const TileRow& row : rows) {
        pixels.resize(width * static_cast<std::size_t>(row.front().size.y) * (isDeep ? 8 : 4));
        for (const PictureTile& tile : row) {
            if (tiles > 1) {
                input.view = whole.part(tile.drawnCorner, tile.drawnSize);
                input.pixelSize = tile.drawnSize;
            }
            if (!progress.next()) {
                return stopped();
            }
            if (auto drawn = drawTile(input, progress.ofTile()); !drawn) {
                return drawn;
            }
            copyTile(tile, m_renderer.readPixels(), pixels, request.size.x);
        }
        if (auto taken = sink(pixels); !taken) {
            return taken;
        }
    }
    return {};
}

model::Result<void> PictureMaker::drawTile(const render::RenderInput& input,
                                           const model::KeepGoing& keepGoing)
{
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
    if (auto room = roomForLayers(request.size); !room && !passes.empty()) {
        return room.error();
    }
    std::vector<std::uint8_t> colours;
    if (needAny(passes, PassNeed::Colours)) {
        auto drawn = allRows(request, true, keepGoing);
        if (!drawn) {
            return drawn.error();
        }
        colours = std::move(drawn).value();
    }
    return layersWith(colours, request, passes, keepGoing);
}

model::Result<std::vector<ExrLayer>> PictureMaker::layersWith(std::span<const std::uint8_t> colours,
                                                              const PictureRequest& request,
                                                              const PicturePasses& passes,
                                                              const model::KeepGoing& keepGoing)
{
    if (auto ready = beCurrent(); !ready) {
        return ready.error();
    }
    const auto shown = aovs(request, passes);
    if (!shown) {
        return shown.error();
    }
    const auto covered = coverage(request, passes, keepGoing);
    if (!covered) {
        return covered.error();
    }
    return layersOf(passes, {colours, request.isTransparent, shown.value(), covered.value(),
                             *request.frame, request.camera});
}

model::Result<void> PictureMaker::save(const QString& path, const PictureRequest& request,
                                       const PicturePasses& passes,
                                       const model::KeepGoing& keepGoing)
{
    return passes.empty() ? savePicture(path, request, keepGoing)
                          : savePasses(path, request, passes, keepGoing);
}

model::Result<void> PictureMaker::savePicture(const QString& path, const PictureRequest& request,
                                              const model::KeepGoing& keepGoing)
{
    const PictureFormat* format = pictureFormatOf(path);
    const bool isDeep = format != nullptr && format->isDeep;
    const auto file = PictureFile::begin(path, {request.size, request.isTransparent, isDeep});
    if (!file) {
        return file.error();
    }
    const auto add = [&](std::span<const std::uint8_t> rows) { return file.value()->add(rows); };
    auto drawn = drawRows(request, isDeep, add, keepGoing);
    return drawn ? file.value()->finish() : drawn;
}

model::Result<void> PictureMaker::savePasses(const QString& path, const PictureRequest& request,
                                             const PicturePasses& passes,
                                             const model::KeepGoing& keepGoing)
{
    auto room = roomForPasses(path, passes);
    room = room ? roomForLayers(request.size) : room;
    if (!room) {
        return room;
    }
    const bool drawsDeep = pictureFormatOf(path)->isDeep && needAny(passes, PassNeed::Colours);
    if (!drawsDeep) { // first: the passes are of clips that the picture has waited for
        if (auto drawn = draw(request, keepGoing); !drawn) {
            return drawn;
        }
    }
    const auto made =
        drawsDeep ? layers(request, passes, keepGoing) : layersWith({}, request, passes, keepGoing);
    if (!made) {
        return made.error();
    }
    const ExrHeader header = exrHeaderOf(passes, request.camera, request.size, *request.frame);
    return writePasses(path, {passes, made.value(), header, m_pixels, request.isTransparent});
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
