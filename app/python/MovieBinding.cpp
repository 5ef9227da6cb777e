// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "app/pictures/MovieFile.h"
#include "app/pictures/MovieFormats.h"
#include "app/pictures/NumberedPictures.h"
#include "app/pictures/PassFile.h"
#include "app/pictures/PictureFile.h"
#include "app/pictures/PictureFormats.h"
#include "app/python/Binding.h"
#include "app/python/LongCall.h"
#include "app/python/OutsidePython.h"
#include "behavior/session/SceneMotion.h"

namespace crowd::app {

using namespace model;

namespace {

constexpr double kLeastRate = 0.01; ///< frames a second
constexpr double kMostRate = 1000.0;

/// Where a script's frames go to: one movie, or a file each.
class FrameFiles
{
public:
    FrameFiles(QString path, glm::ivec2 size, double framesPerSecond, const PicturePasses& passes)
        : m_path(std::move(path)), m_size(size), m_passes(passes)
    {
        if (!m_passes.empty()) {
            valueOrRaise(roomForPasses(m_path, m_passes));
        } else if (movieFormatOf(m_path) != nullptr) {
            m_movie = valueOrRaise(MovieFile::create(m_path, size, framesPerSecond));
        }
    }

    void add(int frame, const ScriptDrawing& drawn, bool isTransparent)
    {
        if (m_movie) {
            valueOrRaise(m_movie->add(drawn.pixels));
            return;
        }
        const QString file = fileForFrame(numberedPattern(m_path), frame);
        valueOrRaise(m_passes.empty() ? writePicture(file, drawn.pixels, m_size, isTransparent)
                                      : writePasses(file, {m_passes, drawn.layers, drawn.header,
                                                           drawn.pixels, isTransparent}));
        for (const QString& written : passFiles(file, m_passes)) {
            m_written.append(written.toStdString());
        }
    }
    [[nodiscard]] py::list finish()
    {
        if (m_movie) {
            valueOrRaise(m_movie->finish());
            m_written.append(m_path.toStdString());
        }
        return m_written;
    }

private:
    QString m_path;
    glm::ivec2 m_size;
    const PicturePasses& m_passes;
    std::unique_ptr<MovieFile> m_movie;
    py::list m_written;
};

struct MovieOptions
{
    double framesPerSecond;
    glm::ivec2 size;
    PicturePasses passes;
    bool isTransparent;
};

void refuseFrames(const std::vector<int>& frames, double framesPerSecond)
{
    if (!(framesPerSecond >= kLeastRate && framesPerSecond <= kMostRate)) {
        throw ScriptError("fps must be from 0.01 to 1000 frames per second.");
    }
    if (frames.empty()) {
        throw ScriptError("frames names none: give a range, such as range(300).");
    }
    const bool isRising =
        std::ranges::adjacent_find(frames, std::greater_equal<>()) == frames.end();
    if (!isRising || frames.front() < 0) {
        throw ScriptError("frames must rise, and begin at 0 or later.");
    }
    if (frames.back() / framesPerSecond > behavior::kMostSceneSeconds) {
        throw ScriptError("frames go on for more than a week of the scene's time.");
    }
}

py::list makeFrames(ScriptScene& scene, const QString& path, const std::vector<int>& frames,
                    const MovieOptions& options, const CameraKey& camera, const PictureKey& look,
                    LongCall& call)
{
    FrameFiles files(path, options.size, options.framesPerSecond, options.passes);
    const auto count = static_cast<double>(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        call.within(static_cast<double>(i) / count, 1.0 / count);
        ScriptPicture request;
        request.size = options.size;
        request.seconds = frames[i] / options.framesPerSecond;
        request.frameSeconds = 1.0 / options.framesPerSecond;
        request.passes = options.passes;
        request.isTransparent = options.isTransparent;
        files.add(frames[i], drawingOf(scene, std::move(request), camera, look, call),
                  options.isTransparent);
    }
    return files.finish();
}

/// Those named; without any, colours where a file has room for more than a picture's bytes.
PicturePasses passesFor(const QString& file, const std::vector<std::string>& names)
{
    if (!names.empty()) {
        return passesNamed(names);
    }
    const PictureFormat* format = pictureFormatOf(file);
    return format != nullptr && format->isDeep ? passesNamed({"colour"}) : PicturePasses();
}

py::list makeMovie(const ScenePtr& scene, const FilePath& path, const std::vector<int>& frames,
                   double framesPerSecond, int width, int height, const CameraKey& camera,
                   const std::string& look, const std::string& by,
                   const std::vector<std::string>& passes, bool isTransparent, bool allowsMissing,
                   const LongCall::Listener& progress)
{
    refuseFrames(frames, framesPerSecond);
    const QString file = QString::fromStdString(path.string());
    if (isTransparent && movieFormatOf(file) != nullptr) {
        throw ScriptError("A movie cannot be transparent: write pictures, such as f_####.png.");
    }
    if (!allowsMissing) {
        refuseMissing(*scene->scene());
    }
    LongCall call(progress);
    const MovieOptions options{
        framesPerSecond, {width, height}, passesFor(file, passes), isTransparent};
    return makeFrames(*scene, file, frames, options, camera, {{look, by, cameraName(camera)}, {}},
                      call);
}

} // namespace

void bindMovies(SceneClass& scene)
{
    scene.def(
        "make_movie", &makeMovie, py::arg("path"), py::arg("frames"), py::kw_only(),
        py::arg("fps") = 30.0, py::arg("width") = 1280, py::arg("height") = 720,
        py::arg("camera") = CameraKey(), py::arg("look") = "", py::arg("by") = "",
        py::arg("passes") = std::vector<std::string>(), py::arg("transparent") = false,
        py::arg("allow_missing") = false, py::arg("progress") = py::none(),
        "Draws frames of the scene, such as range(300), each at its number / fps seconds: into one "
        "movie where path ends as one (.mp4, .webm, .gif; made by ffmpeg), else each into a "
        "picture of its own, with its number for the #### of path. Without a camera, the timeline "
        "moves it. passes: as of render_passes, into .exr files. Returns what was written. camera, "
        "look, by and allow_missing are as of render. " CROWD_PROGRESS_DOC);
}

} // namespace crowd::app
