// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <csignal>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/commands/BenchIo.h"
#include "app/commands/BenchMotion.h"
#include "app/commands/BenchPaint.h"
#include "app/commands/BenchPython.h"
#include "app/commands/BenchRender.h"
#include "app/commands/BenchSimulate.h"
#include "app/commands/CardCommand.h"
#include "app/commands/EditorCommand.h"
#include "app/commands/InfoCommand.h"
#include "app/commands/RenderCli.h"
#include "app/commands/RenderCommand.h"
#include "app/commands/ScriptCommand.h"
#include "app/window/Language.h"

namespace {

using namespace crowd::app;

constexpr int kBadUsage = 2;

/// What the command line can hold, and the exit status of what it asked for.
struct CommandLine
{
    std::vector<std::string> files;
    std::string language; ///< empty: the remembered one
    InfoOptions info;
    RenderOptions render;
    BenchIoOptions benchIo;
    BenchPaintOptions benchPaint;
    BenchPythonOptions benchPython;
    BenchRenderOptions benchRender;
    BenchMotionOptions benchMotion;
    BenchSimulateOptions benchSimulate;
    CardOptions card;
    ScriptOptions script;
    int status = 0;
};

void addInfo(CLI::App& cli, CommandLine& line)
{
    CLI::App* command = cli.add_subcommand("info", "Say what is in a scene, template or stage");
    command
        ->add_option("FILE", line.info.file,
                     "A .crowd, .glb or .gltf file, or builtin:scenes/theatre.crowd")
        ->required();
    command->add_flag("--json", line.info.json, "Print one JSON object");
    command->add_option("--as", line.info.as, "Read a glTF file as this")
        ->check(CLI::IsMember({"template", "stage"}));
    command->callback([&line] { line.status = runInfo(line.info); });
}

void addBenchIo(CLI::App& bench, CommandLine& line)
{
    CLI::App* command = bench.add_subcommand("io", "How long saving and opening takes");
    command->add_option("--count", line.benchIo.count, "Characters in the scene")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_flag("--json", line.benchIo.json, "Print one JSON object");
    command->callback([&line] { line.status = runBenchIo(line.benchIo); });
}

void addBenchPaint(CLI::App& bench, CommandLine& line)
{
    CLI::App* command = bench.add_subcommand("paint", "How long a brush takes");
    command->add_option("--count", line.benchPaint.count, "Characters in the scene")
        ->check(CLI::Range(1, 1000000));
    command->add_flag("--json", line.benchPaint.json, "Print one JSON object");
    command->callback([&line] { line.status = runBenchPaint(line.benchPaint); });
}

void addBenchMotion(CLI::App& bench, CommandLine& line)
{
    CLI::App* command =
        bench.add_subcommand("motion", "What it takes to keep a run and show it again");
    command->add_option("--count", line.benchMotion.count, "Characters")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--frames", line.benchMotion.frames, "Steps of 1/30 s")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_flag("--json", line.benchMotion.json, "Print one JSON object");
    command->callback([&line] { line.status = runBenchMotion(line.benchMotion); });
}

void addBenchPython(CLI::App& bench, CommandLine& line)
{
    CLI::App* command = bench.add_subcommand("python", "What scripts cost against C++");
    command->add_option("--count", line.benchPython.count, "Characters created from arrays")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--rounds", line.benchPython.rounds, "Times that each is measured")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command->add_flag("--json", line.benchPython.json, "Print one JSON object");
    command->callback([&line] { line.status = runBenchPython(line.benchPython); });
}

void addCard(CLI::App& cli, CommandLine& line)
{
    CLI::App* command =
        cli.add_subcommand("card", "Write the quick reference card as a page to print");
    command->add_option("--output", line.card.output, "A .pdf file")->required();
    command->callback([&line] { line.status = runCard(line.card, line.language); });
}

void addScript(CLI::App& cli, CommandLine& line)
{
    CLI::App* command = cli.add_subcommand("script", "Run a Python script");
    command->add_option("FILE", line.script.file, "A .py file")->required();
    command->footer("What follows FILE is what the script finds in sys.argv.");
    command->callback([&line] { line.status = runScript(line.script); });
}

/// No number is in no range, and compares as outside of none.
std::string refuseNan(std::string& text)
{
    double value = 0.0;
    const bool isNumber = CLI::detail::lexical_cast(text, value) && !std::isnan(value);
    return isNumber ? std::string() : text + " is no number";
}

void addBenchSimulate(CLI::App& bench, CommandLine& line)
{
    BenchSimulateOptions& options = line.benchSimulate;
    CLI::App* command = bench.add_subcommand("simulate", "How long a crowd takes to walk");
    command->add_option("--workload", options.workload, "What the crowd does")
        ->check(CLI::IsMember({"square", "corridor", "city", "paths"}))
        ->capture_default_str();
    command->add_option("--count", options.count, "Characters")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--steps", options.steps, "Steps of 1/30 s")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--threads", options.threads, "Threads at most")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_flag("--against-one-thread", options.againstOneThread,
                      "Take every other ten steps on one thread and compare");
    command
        ->add_option("--slowing", options.slowing,
                     "How much density slows walkers: 0 not at all, 1 as observed")
        ->check(CLI::Range(0.0, 1.0) & CLI::Validator(refuseNan, ""));
    command->add_flag("--validate", options.validate,
                      "Repeat published experiments and print how people walked there and here");
    command->add_flag("--json", options.json, "Print one JSON object");
    command->callback([&line] { line.status = runBenchSimulate(line.benchSimulate); });
}

/// What is wrong with it; empty: nothing.
std::string refuseUnknownLanguage(const std::string& code)
{
    std::string known;
    for (const Language& language : languages()) {
        if (language.code.toStdString() == code) {
            return {};
        }
        known += (known.empty() ? "" : ", ") + language.code.toStdString();
    }
    return "there is no translation for " + code + "; there are " + known;
}

void addCommands(CLI::App& cli, CommandLine& line)
{
    cli.set_version_flag("--version", std::string("crowdbrush ") + CROWD_VERSION);
    cli.require_subcommand(0, 1);
    cli.add_option("FILE", line.files,
                   "Scenes and models to open in the editor, such as builtin:scenes/city.crowd");
    cli.add_option("--language", line.language, "Language of the editor this time, such as de")
        ->check(CLI::Validator(refuseUnknownLanguage, ""));
    addInfo(cli, line);
    addRenderCommand(cli, line.render, line.status);
    addCard(cli, line);
    addScript(cli, line);
    CLI::App* bench = cli.add_subcommand("bench", "Measure");
    bench->require_subcommand(1);
    addBenchIo(*bench, line);
    addBenchMotion(*bench, line);
    addBenchPaint(*bench, line);
    addBenchPython(*bench, line);
    addBenchRenderCommand(*bench, line.benchRender, line.status);
    addBenchSimulate(*bench, line);
}

/// How many words of the command line are the program's own: what follows FILE of `script FILE` is
/// the script's, also what looks like an option or a separator.
int ownWords(std::span<char* const> words)
{
    const auto wordAt = [&words](std::size_t place) {
        return place < words.size() ? std::string_view(words[place]) : std::string_view();
    };
    std::size_t place = 1;
    while (wordAt(place).starts_with("--language")) {
        place += wordAt(place) == "--language" ? 2 : 1;
    }
    if (wordAt(place) != "script") {
        return static_cast<int>(words.size());
    }
    ++place;
    if (wordAt(place) == "--") {
        ++place;
    } else if (wordAt(place).starts_with('-')) {
        return static_cast<int>(words.size()); // no file yet: --help
    }
    return static_cast<int>(std::min(place + 1, words.size()));
}

QStringList toList(const std::vector<std::string>& texts)
{
    QStringList list;
    for (const std::string& text : texts) {
        list << QString::fromStdString(text);
    }
    return list;
}

} // namespace

/// Dispatches the command line; each command lives in a file of its own.
int main(int argc, char** argv)
{
    // A limit on the size of files is a message, and not the end of the program.
    std::signal(SIGXFSZ, SIG_IGN);
    CLI::App cli("Crowdbrush: paint crowds. Without a command the editor opens.", "crowdbrush");
    CommandLine line;
    addCommands(cli, line);
    const int own = ownWords({argv, static_cast<std::size_t>(argc)});
    line.script.arguments.assign(argv + own, argv + argc);
    try {
        cli.parse(own, argv);
    } catch (const CLI::ParseError& problem) {
        return cli.exit(problem) == 0 ? 0 : kBadUsage;
    }
    if (cli.get_subcommands().empty()) {
        line.status =
            runEditor(argc, argv, toList(line.files), QString::fromStdString(line.language));
    }
    return line.status;
}
