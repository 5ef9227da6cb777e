// SPDX-License-Identifier: MIT
#include "app/record/TakeScript.h"

#include "app/record/ScriptText.h"

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
