// SPDX-License-Identifier: MIT
#include "app/commands/RenderPlan.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "app/commands/OptionText.h"
#include "app/pictures/MovieFormats.h"
#include "app/pictures/PassFile.h"
#include "app/pictures/PictureFile.h"
#include "app/pictures/PictureFormats.h"
#include "behavior/session/SceneMotion.h"

namespace crowd::app {

namespace {

constexpr double kLeastRate = 0.01; ///< frames per second
constexpr double kMostRate = 1000.0;

/// No number is one, too.
bool isInRange(double value, double least, double most)
{
    return value >= least && value <= most;
}

model::Result<void> planFrames(const RenderOptions& options, RenderPlan& plan)
{
    const bool hasPlace = options.output.find('#') != std::string::npos;
    if (!isInRange(options.framesPerSecond, kLeastRate, kMostRate)) {
        return model::Error{"--fps must be from 0.01 to 1000 frames per second."};
    }
    plan.isMovie = movieFormatOf(QString::fromStdString(options.output)) != nullptr;
    if (plan.isMovie && hasPlace) {
        return model::Error{"--output " + options.output +
                            " is one movie: leave the #### away, or give the pictures another "
                            "ending."};
    }
    plan.isResumed = options.isResumed;
    if (options.isResumed && plan.isMovie) {
        return model::Error{"--resume is for pictures: a movie is made as a whole. Draw pictures, "
                            "such as f_####.png, or leave it away."};
    }
    if (options.frames.empty() && plan.isMovie) {
        return model::Error{"--output " + options.output +
                            " is a movie: say of which frames with --frames A-B, such as 0-299."};
    }
    if (options.frames.empty()) {
        if (hasPlace) {
            return model::Error{"--output " + options.output +
                                " has a place for frame numbers: say which with --frames A-B."};
        }
        return {};
    }
    const auto frames = FrameList::parsed(options.frames);
    if (!frames) {
        return model::Error{"--frames " + options.frames +
                            " is not a range of frames: give it as A-B, such as 0-99, in steps as "
                            "0-90x10, or several with commas, such as 5,20-29."};
    }
    if (!hasPlace && !plan.isMovie && frames->first() != frames->last()) {
        return model::Error{"--output " + options.output +
                            " would be written over and over: put #### where the frame number "
                            "goes, such as f_####.png."};
    }
    plan.frames = *frames;
    plan.framesPerSecond = options.framesPerSecond;
    return {};
}

model::Result<void> planPasses(const RenderOptions& options, RenderPlan& plan)
{
    auto passes = passesOf(options.passes);
    if (!passes) {
        return model::Error{"--passes " + options.passes + ": " + passes.error().message};
    }
    plan.passes = std::move(passes).value();
    return plan.passes.empty() ? model::Result<void>()
                               : roomForPasses(QString::fromStdString(options.output), plan.passes);
}

model::Result<void> planTransparency(const RenderOptions& options, RenderPlan& plan)
{
    const PictureFormat* format = pictureFormatOf(QString::fromStdString(options.output));
    const bool isPossible = !plan.isMovie && (format == nullptr || format->hasTransparency);
    if (options.isTransparent && !isPossible) {
        return model::Error{"--output " + options.output +
                            " cannot be transparent: let it end in .png or .exr, or leave "
                            "--transparent away."};
    }
    plan.isTransparent = options.isTransparent;
    return {};
}

/// Before anything is simulated.
model::Result<void> checkRoom(const RenderOptions& options, const RenderPlan& plan)
{
    const QString path = QString::fromStdString(options.output);
    if (plan.isMovie && std::max(plan.size.x, plan.size.y) > kMostMoviePixelsASide) {
        return model::Error{"--size " + options.size +
                            " is too large for a movie: at most 16384 a side."};
    }
    const bool isPicture =
        pictureFormatOf(path) != nullptr; // others are told when they are written
    return isPicture ? roomForPicture(path, {plan.size, plan.isTransparent})
                     : model::Result<void>();
}

} // namespace

double RenderPlan::secondsBefore(int frame) const
{
    const double before = secondsOf(frame - 1); // the same as when that is drawn, to the last bit
    return before < 0.0 ? secondsOf(frame) : before;
}

double RenderPlan::beginSeconds() const
{
    return secondsOf(frames.first());
}

double RenderPlan::seconds() const
{
    const int count = frames.last() - frames.first() + 1;
    return static_cast<double>(count) / framesPerSecond;
}

double RenderPlan::secondsOf(int frame) const
{
    return startSeconds + static_cast<double>(frame) / framesPerSecond;
}

model::Result<RenderPlan> planOf(const RenderOptions& options)
{
    RenderPlan plan;
    const auto size = parseSize(options.size);
    if (!size) {
        return model::Error{"--size " + options.size +
                            " is not a size in pixels: give it as WIDTHxHEIGHT, such as 1280x720, "
                            "at most 32768 a side."};
    }
    plan.size = *size;
    plan.startSeconds = options.time;
    constexpr double kMost = behavior::kMostSceneSeconds;
    if (!isInRange(options.time, -kMost, kMost)) {
        return model::Error{"--time must be a number of seconds from -604800 to 604800, a week."};
    }
    if (auto frames = planFrames(options, plan); !frames) {
        return frames.error();
    }
    if (auto passes = planPasses(options, plan); !passes) {
        return passes.error();
    }
    if (auto transparency = planTransparency(options, plan); !transparency) {
        return transparency.error();
    }
    if (auto room = checkRoom(options, plan); !room) {
        return room.error();
    }
    if (!isInRange(plan.secondsOf(plan.frames.last()), -kMost, kMost)) {
        return model::Error{"--frames " + options.frames +
                            " goes on for more than a week of the scene's time: give a smaller "
                            "last frame, a smaller --time or a larger --fps."};
    }
    return plan;
}

} // namespace crowd::app
