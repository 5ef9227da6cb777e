// SPDX-License-Identifier: MIT
#include "model/scene/State.h"

#include <tuple>

namespace crowd::model {

namespace {

bool areSamePeople(const StoredRows& a, const StoredRows& b)
{
    return &a == &b || a == b;
}

} // namespace

bool operator==(const State& a, const State& b)
{
    const auto all = [](const State& state) {
        return std::tie(state.id, state.name, state.columns, state.templates, state.unknownColumns,
                        state.unknownHolds, state.unknownMembers);
    };
    return all(a) == all(b) && areSamePeople(*a.people, *b.people);
}

} // namespace crowd::model
