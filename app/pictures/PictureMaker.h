// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "app/pictures/PicturePasses.h"
#include "model/base/KeepGoing.h"
#include "model/base/Result.h"
#include "model/scene/CrowdFrame.h"
#include "render/OffscreenContext.h"
#include "render/Renderer.h"

namespace crowd::app {

/// What a picture without a window shows. The spans outlive the call that gets them.
struct PictureRequest
{
    model::CrowdFramePtr frame;
    std::span<const model::StageEntry> stages;
    std::span<const model::WorldSeat> seats;
    std::uint64_t seatsVersion = 1; ///< grows when the seats are others
    model::Lighting lighting;
    model::Lights lights;
    model::Camera camera;
    glm::ivec2 size{1280, 720}; ///< pixels
    render::Look look = render::Look::Lit;
    std::optional<model::LookPreset> ownLook{}; ///< of the scene; its light, background and lines
    bool showShadows = true;
    bool isTransparent = false;         ///< see render::RenderInput
    int tileSide = 2016;                ///< of those that larger ones are drawn in, see tilesOf()
    std::optional<render::Lens> lens{}; ///< none: everything is sharp
    /// A frame earlier, for the pass that says how everything moves; none: it stands.
    std::optional<render::EarlierMoment> earlier{};
};

/// Draws scenes without a window: owns a context and a renderer. Used on the thread that made it,
/// or on any other after release().
class PictureMaker
{
public:
    /// The store outlives it, and is used by nobody else.
    [[nodiscard]] static model::Result<std::unique_ptr<PictureMaker>>
    create(model::KeyframeStore& keyframes);
    ~PictureMaker();
    PictureMaker(const PictureMaker&) = delete;
    PictureMaker& operator=(const PictureMaker&) = delete;

    /// Waits until all clips in the picture are baked. What was drawn before makes no difference.
    /// One that is larger than graphics cards draw at once is put together. An error where it is
    /// stopped.
    [[nodiscard]] model::Result<void> draw(const PictureRequest& request,
                                           const model::KeepGoing& keepGoing = {});
    /// What these passes say of the picture of a request, which has just been drawn unless its
    /// colours are among them.
    [[nodiscard]] model::Result<std::vector<ExrLayer>>
    layers(const PictureRequest& request, const PicturePasses& passes,
           const model::KeepGoing& keepGoing = {});
    /// Draws a picture to a file, whole or not at all: with passes see writePasses(), without as
    /// its ending says. A large one is never whole in memory.
    [[nodiscard]] model::Result<void> save(const QString& path, const PictureRequest& request,
                                           const PicturePasses& passes,
                                           const model::KeepGoing& keepGoing = {});
    /// The picture that draw() made last: RGBA8, sRGB, rows from the top.
    [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return m_pixels; }
    /// What is drawn is coarser than wished: the graphics card has no memory for it.
    [[nodiscard]] bool isReduced() const { return m_renderer.statistics().reduction > 0; }
    /// Until the next picture the context belongs to no thread.
    void release()
    {
        if (m_context) {
            m_context->doneCurrent();
        }
    }

private:
    explicit PictureMaker(model::KeyframeStore& keyframes) : m_keyframes(keyframes) {}

    [[nodiscard]] model::Result<void> beCurrent();

    /// Takes some rows of a picture, from the top; RGBA8, or where it is deep half floats.
    using RowSink = std::function<model::Result<void>(std::span<const std::uint8_t> rows)>;

    [[nodiscard]] model::Result<void> drawRows(const PictureRequest& request, bool isDeep,
                                               const RowSink& sink,
                                               const model::KeepGoing& keepGoing);
    [[nodiscard]] model::Result<std::vector<std::uint8_t>>
    allRows(const PictureRequest& request, bool isDeep, const model::KeepGoing& keepGoing);
    [[nodiscard]] model::Result<void> savePicture(const QString& path,
                                                  const PictureRequest& request,
                                                  const model::KeepGoing& keepGoing);
    [[nodiscard]] model::Result<void> savePasses(const QString& path, const PictureRequest& request,
                                                 const PicturePasses& passes,
                                                 const model::KeepGoing& keepGoing);
    /// As layers(), with such colours.
    [[nodiscard]] model::Result<std::vector<ExrLayer>>
    layersWith(std::span<const std::uint8_t> colours, const PictureRequest& request,
               const PicturePasses& passes, const model::KeepGoing& keepGoing);
    [[nodiscard]] model::Result<void> drawTile(const render::RenderInput& input,
                                               const model::KeepGoing& keepGoing);
    [[nodiscard]] model::Result<void> drawComplete(const render::RenderInput& input);
    [[nodiscard]] model::Result<void> ripen(render::RenderInput input,
                                            const model::KeepGoing& keepGoing);

    [[nodiscard]] model::Result<render::AovPicture> aovs(const PictureRequest& request,
                                                         const PicturePasses& passes);
    [[nodiscard]] model::Result<Coverage> coverage(const PictureRequest& request,
                                                   const PicturePasses& passes,
                                                   const model::KeepGoing& keepGoing);

    model::KeyframeStore& m_keyframes;
    bool m_hasDrawn = false;
    std::vector<std::uint8_t> m_pixels;
    std::unique_ptr<render::OffscreenContext> m_context;
    render::Renderer m_renderer;
};

} // namespace crowd::app
