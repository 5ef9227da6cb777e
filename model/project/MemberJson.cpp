// SPDX-License-Identifier: MIT
#include "model/project/MemberJson.h"

namespace crowd::model {

void writeMembers(const Scene& scene, nlohmann::json& top)
{
    static const Scene kEmpty;
    forEachMember([&]<class M>(const M& member) {
        if constexpr (M::isOptional) {
            if (M::of(scene) == M::of(kEmpty)) {
                return;
            }
        }
        top[M::key] = memberJson(member, scene);
    });
}

void readMembers(JsonFields& top, Scene& scene, Message& problem)
{
    forEachMember([&](const auto& member) { readMember(member, top, scene, problem); });
}

} // namespace crowd::model
