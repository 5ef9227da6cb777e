// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace crowd::app {

struct BenchRenderOptions;
struct RenderOptions;

/// "render": fills the options and puts runRender's exit code into status when chosen.
void addRenderCommand(CLI::App& cli, RenderOptions& options, int& status);
/// "render" below `bench`.
void addBenchRenderCommand(CLI::App& bench, BenchRenderOptions& options, int& status);

} // namespace crowd::app
