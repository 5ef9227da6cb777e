// SPDX-License-Identifier: MIT
#include "model/project/HandEditJson.h"

#include <set>
#include <string>

#include "model/project/MemberJson.h"

namespace crowd::model {

std::string handEditsText(const std::vector<HandEdit>& edits)
{
    nlohmann::json list = nlohmann::json::array();
    for (const HandEdit& edit : edits) {
        list.push_back(describedJson(edit));
    }
    return list.dump();
}

Result<std::vector<HandEdit>> readHandEdits(const std::string& text)
{
    const nlohmann::json list = nlohmann::json::parse(text, nullptr, false);
    if (!list.is_array()) {
        return Error{
            QT_TRANSLATE_NOOP("Messages", "What is done to people by hand is a list of objects.")};
    }
    if (list.size() > kMostHandEdits) {
        return Error{QT_TRANSLATE_NOOP("Messages", "A take has at most %1 edits by hand, not %2."),
                     kMostHandEdits, list.size()};
    }
    static const JsonFields::Tolerated kNothing;
    std::vector<HandEdit> edits;
    Message problem;
    for (std::size_t i = 0; i < list.size() && problem.empty(); ++i) {
        readDescribed(JsonFields(list[i], "edits[" + std::to_string(i) + "]", problem, &kNothing),
                      edits.emplace_back());
    }
    if (!problem.empty()) {
        return Error{problem};
    }
    for (HandEdit& edit : edits) {
        const std::set<int> people(edit.people.begin(), edit.people.end());
        edit.people.assign(people.begin(), people.end());
    }
    return edits;
}

} // namespace crowd::model
