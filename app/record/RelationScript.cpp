// SPDX-License-Identifier: MIT
#include "app/record/RelationScript.h"

#include <algorithm>

#include "app/record/ScriptText.h"

namespace crowd::app {

using namespace model;

namespace {

/// One for all where they are the same.
template<class Value>
std::string valuesText(const std::vector<Relation>& relations, Value Relation::*member)
{
    const bool areSame = std::ranges::all_of(
        relations, [&](const Relation& each) { return each.*member == relations.front().*member; });
    if (areSame) {
        return pythonText(relations.front().*member);
    }
    std::vector<std::string> items;
    items.reserve(relations.size());
    for (const Relation& each : relations) {
        items.push_back(pythonText(each.*member));
    }
    return pythonList(items, kIndent);
}

std::string callText(const char* call, const std::vector<Relation>& relations,
                     const RelationKind& kind)
{
    return std::string(call) + '(' + valuesText(relations, &Relation::from) + ", " +
           valuesText(relations, &Relation::to) + ", " + pythonText(kind.name);
}

} // namespace

std::vector<std::string> relationLines(const RelationDelta& changed, const Scene& after)
{
    std::vector<std::string> lines;
    for (const RelationKind& kind : after.relationKinds) {
        std::vector<Relation> gone;
        std::vector<Relation> come;
        std::ranges::copy_if(changed.added, std::back_inserter(come),
                             [&kind](const Relation& each) { return each.kind == kind.id; });
        std::ranges::copy_if(changed.removed, std::back_inserter(gone), [&](const Relation& each) {
            const bool areThere = after.population.rowOf(each.from) != Population::npos &&
                                  after.population.rowOf(each.to) != Population::npos;
            return each.kind == kind.id && areThere &&
                   after.relations.find(each.from, each.to, each.kind) == nullptr;
        });
        if (!gone.empty()) {
            lines.push_back(callText("scene.unrelate", gone, kind) + ")\n");
        }
        if (!come.empty()) {
            lines.push_back(callText("scene.relate", come, kind) +
                            ", strength=" + valuesText(come, &Relation::strength) + ")\n");
        }
    }
    return lines;
}

} // namespace crowd::app
