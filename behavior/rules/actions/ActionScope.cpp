// SPDX-License-Identifier: MIT
#include "behavior/rules/actions/ActionScope.h"

#include <limits>

#include "model/base/Random.h"
#include "model/base/WeightedDraw.h"

namespace crowd::behavior {

double endAfter(const ActionScope& scope, float seconds)
{
    return seconds > 0.0F ? scope.now() + static_cast<double>(seconds)
                          : std::numeric_limits<double>::infinity();
}

std::string drawClip(const ActionScope& scope, const std::vector<model::ClipWeight>& clips)
{
    if (clips.empty()) {
        return {};
    }
    const float share = draw(scope, scope.agent, model::hashKeys(scope.self().line, 71));
    return clips[model::weightedIndex(clips, share, [](const auto& clip) { return clip.weight; })]
        .clip;
}

void setTag(const ActionScope& scope, std::uint8_t tag, bool hasIt)
{
    std::uint64_t& tags = scope.self().tags;
    const std::uint64_t bit = std::uint64_t{1} << tag;
    const std::uint64_t now = hasIt ? tags | bit : tags & ~bit;
    if (now != tags) {
        tags = now;
        scope.host.noteTags(scope.agent, now);
        if (hasIt) {
            scope.state.people.noteTag(scope.agent, tag);
        }
    }
}

void changeNumber(const ActionScope& scope, model::NumberId number, float value, bool isAdded)
{
    if (!scope.state.numbers.change(scope.agent, number, value, isAdded)) {
        scope.report(QT_TRANSLATE_NOOP(
            "Messages",
            "Rule \"%1\" changes a number that is not there any more. Choose another one."));
    }
}

} // namespace crowd::behavior
