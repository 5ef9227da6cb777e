// SPDX-License-Identifier: MIT
#include "model/project/FeaturesJson.h"

#include <set>

namespace crowd::model {

namespace {

/// What is wrong with one of several things of the same kind.
class UniqueNames
{
public:
    UniqueNames(const char* of, Message& problem) : m_of(of), m_problem(problem) {}

    void add(const std::string& name)
    {
        if (!m_problem.empty()) {
            return;
        }
        if (name.empty()) {
            m_problem =
                Message(QT_TRANSLATE_NOOP("Messages", "%1: a kind or a value has no name"), m_of);
        } else if (!m_names.insert(name).second) {
            m_problem = Message(QT_TRANSLATE_NOOP("Messages", "%1: the name \"%2\" is given twice"),
                                m_of, shortened(name));
        }
    }

private:
    const char* m_of;
    Message& m_problem;
    std::set<std::string> m_names;
};

void checkValues(const FeatureKind& kind, std::set<FeatureId>& ids, Message& problem)
{
    UniqueNames names(members::Features::key, problem);
    for (const FeatureValue& value : kind.values) {
        names.add(value.name);
        if (problem.empty() && (value.id == 0 || !ids.insert(value.id).second)) {
            problem = idProblem(members::Features::key, value.id);
        }
    }
}

} // namespace

void readMember(members::Features, JsonFields& top, Scene& scene, Message& problem)
{
    if (top.find(members::Features::key) == nullptr) {
        return;
    }
    FeatureKinds kinds;
    readObjects(top, members::Features::key, "", problem,
                [&kinds](JsonFields fields, const std::string&) {
                    FeatureKind& kind = kinds.emplace_back();
                    readFields(fields, fieldsOf<FeatureKind>(), &kind);
                    kind.unknownMembers = fields.unknown();
                });
    sortById(kinds, members::Features::key, problem);
    UniqueNames names(members::Features::key, problem);
    std::set<FeatureId> ids;
    for (FeatureKind& kind : kinds) {
        names.add(kind.name);
        checkValues(kind, ids, problem);
        for (FeatureValue& value : kind.values) {
            std::ranges::sort(value.templates);
        }
    }
    scene.features = std::move(kinds);
}

} // namespace crowd::model
