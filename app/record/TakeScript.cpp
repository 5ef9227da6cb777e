// SPDX-License-Identifier: MIT
#include "app/record/TakeScript.h"

#include <utility>

#include "app/record/ScriptText.h"
#include "model/project/HandEditJson.h"

namespace crowd::app {

using namespace model;

namespace {

std::string additionOf(const Take& take)
{
    const std::string name = pythonText(take.name);
    if (!take.motion) {
        return "pass  # the take " + name + ", whose motion is not there\n";
    }
    return "scene.add_take(" + pythonText(take.motion->path().toStdString()) + ", " + name +
           ", id=" + pythonText(take.id) + ")\n";
}

/// Empty: they are the same.
std::string editsLine(const Take* was, const Take& take)
{
    const bool isSame = was == nullptr
                            ? take.edits.empty() && take.areEditsOn
                            : was->edits == take.edits && was->areEditsOn == take.areEditsOn;
    if (isSame || !take.motion) {
        return {};
    }
    return "scene.edit_take(" + pythonText(take.name) + ", " +
           pythonText(handEditsText(take.edits)) +
           (take.areEditsOn ? std::string() : ", on=" + pythonText(false)) + ")\n";
}

} // namespace

std::vector<std::string> takeLines(const Takes& before, const Takes& after)
{
    std::vector<std::string> lines;
    for (const Take& each : before) {
        if (findTake(after, each.id) == nullptr) {
            lines.push_back("scene.remove_take(" + pythonText(each.name) + ")\n");
        }
    }
    for (const Take& each : after) {
        const Take* was = findTake(before, each.id);
        if (was == nullptr) {
            lines.push_back(additionOf(each));
        } else if (was->name != each.name) {
            lines.push_back("scene.rename_take(" + pythonText(was->name) + ", " +
                            pythonText(each.name) + ")\n");
        }
        if (std::string line = editsLine(was, each); !line.empty()) {
            lines.push_back(std::move(line));
        }
    }
    const Take* shown = shownTake(after);
    const Take* wasShown = shownTake(before);
    const bool isSame =
        (shown == nullptr ? 0 : shown->id) == (wasShown == nullptr ? 0 : wasShown->id);
    if (!isSame) {
        lines.push_back("scene.show_take(" +
                        (shown != nullptr ? pythonText(shown->name) : std::string("None")) + ")\n");
    }
    if (lines.empty()) {
        lines.emplace_back("pass\n"); // numbers of a file that say nothing else
    }
    return lines;
}

} // namespace crowd::app
