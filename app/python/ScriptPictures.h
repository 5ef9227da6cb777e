// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include <glm/vec2.hpp>

#include "app/pictures/LensWish.h"
#include "app/pictures/LookWish.h"
#include "app/pictures/PictureMaker.h"
#include "model/bake/KeyframeStore.h"
#include "model/scene/Scene.h"

namespace crowd::app {

class ScriptScene;

/// For baked animations, of strokes and of pictures each.
inline constexpr std::size_t kScriptKeyframeBytes = std::size_t{2} << 30U;

/// Between work that takes long and whoever waits for it.
struct Waiting
{
    std::atomic<bool> isCancelled{false};
    std::atomic<double> share{0.0}; ///< that is done
};

/// Does work that takes long, on whatever thread, and returns when it is done. May cancel it, and
/// then throws.
using Patience = std::function<void(Waiting& waiting, const std::function<void()>& work)>;

/// A picture as a script asks for it.
struct ScriptPicture
{
    glm::ivec2 size{1280, 720};
    std::optional<model::Camera> camera; ///< the scene's first one without
    double seconds = 0.0;                ///< of the transport
    double frameSeconds = 1.0 / 30.0;    ///< that motion is said over
    bool isTransparent = false;          ///< see PictureRequest
    model::CrowdFramePtr frame;          ///< people; null: as the scene shows them at that time
    model::CrowdFramePtr frameBefore;    ///< the same of the moment that motion is said against
    struct Before
    {
        double seconds = 0.0;
        model::Camera camera;
    };
    std::optional<Before> before{}; ///< the moment that motion is said against; none: it stands
    ChosenLook look{};
    LensWish lens{};
    PicturePasses passes{};
    model::KeepGoing keepGoing{}; ///< of drawing
    Patience patience = [](Waiting&, const std::function<void()>& work) { work(); };
};

struct ScriptDrawing
{
    std::vector<std::uint8_t> pixels; ///< RGBA8, sRGB, rows from the top
    std::vector<ExrLayer> layers;     ///< one of each pass
    ExrHeader header;                 ///< of a file of them
};

/// The camera, or the scene's first one.
[[nodiscard]] model::Result<model::Camera>
cameraOrFirst(const model::Scene& scene, const std::optional<model::Camera>& camera);

/// Draws pictures of a scene for scripts, and keeps between two of them what both need. One at a
/// time, on any thread.
class ScriptPictures
{
public:
    ScriptPictures();
    ~ScriptPictures();
    ScriptPictures(const ScriptPictures&) = delete;
    ScriptPictures& operator=(const ScriptPictures&) = delete;

    [[nodiscard]] model::Result<ScriptDrawing> picture(ScriptScene& script,
                                                       const ScriptPicture& picture);
    /// The thread that a picture is being drawn on; none else. Another one waits until it is done.
    [[nodiscard]] std::thread::id drawingThread() const { return m_drawing; }

private:
    struct Motion;

    [[nodiscard]] model::CrowdFramePtr frameAt(ScriptScene& script, double seconds,
                                               const Patience& patience);
    [[nodiscard]] model::Result<ScriptDrawing> draw(ScriptScene& script,
                                                    const ScriptPicture& picture);

    model::KeyframeStore m_keyframes;      ///< pictures wait for all of it, whatever else goes on
    std::unique_ptr<PictureMaker> m_maker; ///< made when first asked for
    std::unique_ptr<Motion> m_motion;      ///< where the scene has behaviour
    std::thread::id m_drawing;
    std::uint64_t m_count = 0;
};

} // namespace crowd::app
