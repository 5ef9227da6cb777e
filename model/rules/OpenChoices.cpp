// SPDX-License-Identifier: MIT
#include "model/rules/OpenChoices.h"

#include <algorithm>
#include <optional>

namespace crowd::model {

namespace {

/// Nothing, unless a path has come in the place of one that was still to choose.
std::optional<PathId> newlyChosen(const Rule& before, const Rule& after)
{
    const std::vector<std::uint32_t> had = idsNamedIn(before, FieldRole::Path);
    const std::vector<std::uint32_t> has = idsNamedIn(after, FieldRole::Path);
    if (had.size() != has.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < has.size(); ++i) {
        if (had[i] == kNotChosen && has[i] != kNotChosen && has[i] != 0) {
            return has[i];
        }
    }
    return std::nullopt;
}

template<class Part>
bool fill(Part& part, FieldRole role, std::uint32_t id)
{
    bool isFilled = false;
    for (const FieldInfo& field : part.kind().fields) {
        const bool isOpen = field.meta.role == role && field.meta.isStored &&
                            field.get(part.object()) == FieldValue(std::int64_t{kNotChosen});
        if (isOpen) {
            field.set(part.object(), std::int64_t{id});
            isFilled = true;
        }
    }
    return isFilled;
}

bool fill(Rule& rule, const Path& path)
{
    bool isFilled = fill(rule.trigger, FieldRole::Path, path.id);
    if (!path.places.empty()) {
        isFilled |= fill(rule.trigger, FieldRole::Place, path.places.front());
    }
    for (Condition& condition : rule.conditions) {
        isFilled |= fill(condition, FieldRole::Path, path.id);
    }
    for (Action& action : rule.actions) {
        isFilled |= fill(action, FieldRole::Path, path.id);
    }
    return isFilled;
}

} // namespace

int fillOpenChoices(std::vector<Rule>& rules, const Rule& before, const Rule& after,
                    const std::vector<Path>& paths)
{
    const std::optional<PathId> chosen = newlyChosen(before, after);
    const auto path = std::ranges::find(paths, chosen.value_or(0), &Path::id);
    if (!chosen || path == paths.end()) {
        return 0;
    }
    int filled = 0;
    for (Rule& rule : rules) {
        filled += fill(rule, *path) && rule.id != after.id ? 1 : 0;
    }
    return filled;
}

} // namespace crowd::model
