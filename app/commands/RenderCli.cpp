// SPDX-License-Identifier: MIT
#include "app/commands/RenderCli.h"

#include <array>
#include <string>

#include <CLI/CLI.hpp>

#include <QtCore/QCoreApplication>

#include "app/commands/BenchRender.h"
#include "app/commands/RenderCommand.h"
#include "app/pictures/MovieFormats.h"
#include "app/pictures/PictureFormats.h"
#include "app/pictures/PicturePasses.h"
#include "render/Looks.h"

namespace crowd::app {

namespace {

/// Finds the built-in content and picture formats; needs no display.
class HeadlessApplication
{
public:
    HeadlessApplication() : m_application(m_count, m_arguments.data()) {}

private:
    std::string m_name = "crowdbrush";
    std::array<char*, 2> m_arguments{m_name.data(), nullptr};
    int m_count = 1;
    QCoreApplication m_application;
};

/// What a picture shows of the scene.
void addView(CLI::App& command, RenderOptions& options)
{
    command.add_option("--camera", options.camera,
                       "Name of a camera of the scene; without it, as the timeline moves it, else "
                       "the first");
    command.add_option("--take", options.take,
                       "Move people as in a kept take, by its name; none: as the scene plays. Else "
                       "as in the take that the scene shows, if any");
    command.add_option("--camera-move", options.cameraMove,
                       "turntable: once around what the camera looks at, over all frames; or a "
                       "JSON file with marks of a timeline that move it");
    command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command.add_option("--time", options.time, "Seconds of the scene's time");
    command.add_option("--look", options.look,
                       "How it is drawn: a look of the scene by its name, or " +
                           render::lookKeys() + "; without it, as the camera has it, else lit");
    command.add_option("--by", options.by,
                       "What people are coloured by: template, group, tag, clip, height, density, "
                       "a property that is a number, or feature:KIND");
    command.add_option("--focus", options.focusMetres,
                       "Depth of field: metres from the camera to what is sharp; without it, what "
                       "the camera turns around");
    command.add_option("--f-stop", options.fStop,
                       "Depth of field: the smaller, the less is sharp; 0.5 where only --focus is "
                       "given");
}

} // namespace

void addRenderCommand(CLI::App& cli, RenderOptions& options, int& status)
{
    CLI::App* command =
        cli.add_subcommand("render", "Draw pictures of a scene without opening a window");
    command
        ->add_option("SCENE", options.scene,
                     "A .crowd, .glb or .gltf file, or builtin:scenes/theatre.crowd")
        ->required();
    command
        ->add_option("--output", options.output,
                     "Picture to write (" + pictureEndings() +
                         "), #### for the frame; or a movie of all frames (" + movieEndings() +
                         "), made by ffmpeg")
        ->required();
    addView(*command, options);
    command->add_option("--passes", options.passes,
                        "Layers of an .exr file, or each a .png of its own (a.depth.png, whole "
                        "numbers), with commas: " +
                            passKeys());
    command->add_option("--frames", options.frames,
                        "Draw frames A-B; in steps A-BxN; several with commas: 5,20-29,40-90x10");
    command->add_flag("--transparent", options.isTransparent,
                      "Nothing where neither people nor stages are: for pictures to be put over "
                      "others");
    command->add_flag("--resume", options.isResumed,
                      "Draw only those frames whose pictures are not there yet, whole and of "
                      "that size");
    command->add_option("--fps", options.framesPerSecond, "Frames per second")
        ->capture_default_str();
    command->add_flag("--allow-missing", options.allowsMissing,
                      "Draw without characters and stages that cannot be loaded");
    command->callback([&options, &status] {
        const HeadlessApplication application;
        status = runRender(options);
    });
}

namespace {

void addQualityOptions(CLI::App& command, BenchRenderOptions& options)
{
    command.add_flag("--quality", options.quality,
                     "Also what --detail levels loses beside full detail; more than 0.6 dB or "
                     "0.010 of structural similarity ends with 1");
    command
        .add_option("--thresholds", options.thresholds,
                    "Three heights in pixels, falling, below which a coarser level is drawn")
        ->expected(model::kMaxLevels - 1)
        ->check(CLI::Range(0.0F, 10000.0F));
    command
        .add_option(
            "--impostors", options.impostors,
            "Height in pixels below which --detail levels draws pictures on cards; 0: never")
        ->check(CLI::Range(0.0F, 10000.0F));
}

} // namespace

void addBenchRenderCommand(CLI::App& bench, BenchRenderOptions& options, int& status)
{
    CLI::App* command = bench.add_subcommand(
        "render", "Time our drawing against display lists with fixed-function light");
    command->add_option("--count", options.count, "Characters; 0: what an empty picture takes")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    command
        ->add_option("--field", options.field,
                     "near: from 17 metres on, or far: from 50, where nobody is above 30 pixels")
        ->check(CLI::IsMember({"near", "far"}))
        ->capture_default_str();
    command
        ->add_option("--triangles", options.triangles,
                     "Triangles of a figure made in code instead of the built-in characters")
        ->check(CLI::Range(0, 1000000));
    command->add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--detail", options.detail, "full or levels")
        ->check(CLI::IsMember({"full", "levels"}))
        ->capture_default_str();
    command->add_option("--scene", options.scene,
                        "Draw this scene instead of a field of characters");
    command->add_option("--look", options.look, render::lookKeys())
        ->check([](const std::string& key) {
            return render::lookOfKey(key) ? std::string() : "one of: " + render::lookKeys();
        })
        ->capture_default_str();
    command->add_option("--light", options.light,
                        "A ready-made light instead of that of the scene, as noon or dusk");
    command->add_option("--frames", options.frames, "Frames timed")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--samples", options.samples, "Samples per pixel, for both ways")
        ->check(CLI::Range(0, 16))
        ->capture_default_str();
    addQualityOptions(*command, options);
    command->add_flag("--edges", options.edges, "Smooth edges of ours in the last step");
    command
        ->add_option("--clock", options.clock,
                     "wall, or cpu: processor time of all threads, for a busy machine")
        ->check(CLI::IsMember({"wall", "cpu"}))
        ->capture_default_str();
    command->add_option("--picture", options.picture,
                        "Write what both drew to NAME-ours.png and NAME-reference.png");
    command->add_flag("--json", options.json, "Print one JSON object");
    command->callback([&options, &status] {
        const HeadlessApplication application;
        status = runBenchRender(options);
    });
}

} // namespace crowd::app
