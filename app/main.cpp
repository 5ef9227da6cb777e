// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>

#include "app/InfoCommand.h"
#include "app/commands/BenchPaint.h"
#include "app/commands/BenchRender.h"
#include "app/commands/RenderCli.h"
#include "app/commands/RenderCommand.h"

namespace {

constexpr int kBadUsage = 2;

} // namespace

/// Dispatches the command line; each command lives in a file of its own.
int main(int argc, char** argv)
{
    CLI::App cli("Crowdbrush: paint crowds", "crowdbrush");
    cli.require_subcommand(1);
    crowd::app::InfoOptions info;
    CLI::App* infoCommand = cli.add_subcommand("info", "Say what is in a scene, template or stage");
    infoCommand->add_option("FILE", info.file, "A .crowd, .glb or .gltf file")->required();
    infoCommand->add_flag("--json", info.json, "Print one JSON object");
    infoCommand->add_option("--as", info.as, "Read a glTF file as this")
        ->check(CLI::IsMember({"template", "stage"}));
    crowd::app::BenchPaintOptions benchPaint;
    CLI::App* benchCommand = cli.add_subcommand("bench", "Measure");
    benchCommand->require_subcommand(1);
    CLI::App* benchPaintCommand = benchCommand->add_subcommand("paint", "How long a brush takes");
    benchPaintCommand->add_option("--count", benchPaint.count, "People in the scene")
        ->check(CLI::Range(1, 1000000));
    benchPaintCommand->add_flag("--json", benchPaint.json, "Print one JSON object");
    int status = 0;
    crowd::app::BenchRenderOptions benchRender;
    crowd::app::addBenchRenderCommand(*benchCommand, benchRender, status);
    crowd::app::RenderOptions render;
    crowd::app::addRenderCommand(cli, render, status);
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return cli.exit(problem) == 0 ? 0 : kBadUsage;
    }
    if (benchPaintCommand->parsed()) {
        return crowd::app::runBenchPaint(benchPaint);
    }
    return infoCommand->parsed() ? crowd::app::runInfo(info) : status;
}
