// SPDX-License-Identifier: MIT
#include "model/project/RelationsJson.h"

#include "model/project/LinkParser.h"

namespace crowd::model {

namespace {

void checkRelationNames(const RelationKinds& kinds, Message& problem)
{
    const char* key = members::RelationKinds::key;
    for (std::size_t i = 0; i < kinds.size() && problem.empty(); ++i) {
        const std::string& name = kinds[i].name;
        if (name.empty()) {
            problem = Message(QT_TRANSLATE_NOOP("Messages", "%1: a kind has no name"), key);
        } else if (findRelation(kinds, name) != &kinds[i]) {
            problem = Message(QT_TRANSLATE_NOOP("Messages", "%1: the name \"%2\" is given twice"),
                              key, shortened(name));
        }
    }
}

} // namespace

void readMember(members::RelationKinds, JsonFields& top, Scene& scene, Message& problem)
{
    const char* key = members::RelationKinds::key;
    if (top.find(key) == nullptr) {
        return;
    }
    RelationKinds kinds;
    readObjects(top, key, "", problem, [&kinds](JsonFields fields, const std::string&) {
        RelationKind& kind = kinds.emplace_back();
        readFields(fields, fieldsOf<RelationKind>(), &kind);
        kind.unknownMembers = fields.unknown();
    });
    sortById(kinds, key, problem);
    checkRelationNames(kinds, problem);
    scene.relationKinds = std::move(kinds);
}

nlohmann::json memberJson(members::Relations, const Scene& /*scene*/)
{
    nlohmann::json columns = nlohmann::json::array();
    for (const char* name : kLinkColumns) {
        columns.push_back(name);
    }
    return {{"columns", std::move(columns)}};
}

void readMember(members::Relations, JsonFields& top, Scene& /*scene*/, Message& /*problem*/)
{
    const nlohmann::json* table = top.find(members::Relations::key);
    if (table != nullptr && !table->is_object()) {
        top.complain(members::Relations::key,
                     QT_TRANSLATE_NOOP("Messages", "%1 must be an object with columns and rows"));
    }
}

} // namespace crowd::model
