// SPDX-License-Identifier: MIT
#include "model/project/EnvironmentText.h"

#include <set>

#include "model/base/ShownText.h"
#include "model/project/EnvironmentChecks.h"
#include "model/project/MemberJson.h"

namespace crowd::model {

using nlohmann::json;

namespace {

constexpr int kDeepest = 64; ///< as project files

/// Reading goes down as deep as text is nested, and so does writing what is not known.
bool isTooDeep(const std::string& text)
{
    int depth = 0;
    bool isInText = false;
    for (std::size_t i = 0; i < text.size() && depth <= kDeepest; ++i) {
        const char letter = text[i];
        if (isInText && letter == '\\') {
            ++i;
        } else if (letter == '"') {
            isInText = !isInText;
        } else if (!isInText) {
            depth += letter == '[' || letter == '{' ? 1 : letter == ']' || letter == '}' ? -1 : 0;
        }
    }
    return depth > kDeepest;
}

/// Calls act(member) for each member that belongs to the environment.
template<class Act>
void forEachPart(const Act& act)
{
    forEachMember([&act]<class M>(const M& member) {
        if constexpr (M::isEnvironment) {
            act(member);
        }
    });
}

std::string allKeys()
{
    std::string all;
    forEachPart([&]<class M>(const M&) { all += (all.empty() ? "" : ", ") + std::string(M::key); });
    return all;
}

/// Names of members that the scene keeps without knowing them.
class UnknownNames
{
public:
    explicit UnknownNames(const Scene& scene)
    {
        forEachPart([&]<class M>(const M&) { addOf(M::of(scene)); });
    }
    [[nodiscard]] const JsonFields::Tolerated& names() const { return m_names; }

private:
    template<class Entry>
    void addOf(const std::vector<Entry>& entries)
    {
        for (const Entry& entry : entries) {
            addOf(entry);
        }
    }
    template<class Entry>
    void addOf(const Entry& entry)
    {
        add(entry.unknownMembers);
    }
    void addOf(std::uint32_t) {}
    void addOf(const Path& path)
    {
        add(path.unknownMembers);
        addOf(path.branches);
    }
    void addOf(const Rule& rule)
    {
        add(rule.unknownMembers);
        add(rule.trigger.unknownMembers);
        addOf(rule.conditions);
        addOf(rule.actions);
        model::forEachPart(rule, [this](const RuleKind& kind, const void* object) {
            for (const FieldInfo& field : kind.fields) {
                if (field.is<std::vector<ClipWeight>>()) {
                    addOf(std::get<std::vector<ClipWeight>>(field.get(object)));
                }
            }
        });
    }
    template<Described Entry>
    void addOf(const Entry& entry)
    {
        add(entry.unknownMembers);
        addItems(fieldsOf<Entry>(), const_cast<Entry*>(&entry)); // only read
    }
    void addItems(std::span<const FieldInfo> fields, void* object)
    {
        for (const FieldInfo& field : fields) {
            if (field.isGroup() && field.unknownOf) {
                add(*field.unknownOf(field.childOf(object)));
            }
            for (std::size_t i = 0; field.isList() && i < field.count(object); ++i) {
                void* item = field.itemOf(object, i);
                add(*field.unknownOf(item));
                addItems(field.children, item);
            }
        }
    }
    void add(const std::string& members)
    {
        if (!members.empty()) {
            const json object = json::parse(members);
            for (const auto& [name, value] : object.items()) {
                m_names.insert(name);
            }
        }
    }

    JsonFields::Tolerated m_names;
};

} // namespace

MemberSet environmentMembers()
{
    MemberSet all;
    forEachPart([&all]<class M>(const M&) { all.add<M>(); });
    return all;
}

std::string environmentText(const Scene& scene, const MemberSet& meant)
{
    json top = json::object();
    forEachPart([&]<class M>(const M& member) {
        if (meant.contains<M>()) {
            top[M::key] = memberJson(member, scene);
        }
    });
    return top.dump(-1, ' ', false, json::error_handler_t::replace);
}

Result<void> readEnvironmentText(const std::string& text, Scene& scene, bool isStrict)
{
    if (isTooDeep(text)) {
        return Error{QT_TRANSLATE_NOOP("Messages", "The environment is nested more than %1 deep."),
                     kDeepest};
    }
    const json top = json::parse(text, nullptr, false);
    if (top.is_discarded() || !top.is_object()) {
        return Error{QT_TRANSLATE_NOOP("Messages",
                                       "The environment must be an object with lists of places, "
                                       "paths, groups, tags, rules, numbers and cues.")};
    }
    Scene changed = scene;
    std::set<std::string> known;
    forEachPart([&]<class M>(const M&) {
        known.insert(M::key);
        if constexpr (requires { M::of(changed).clear(); }) {
            if (top.contains(M::key)) {
                M::of(changed).clear();
            }
        }
    });
    for (const auto& [name, value] : top.items()) {
        if (!known.contains(name)) {
            return Error{
                QT_TRANSLATE_NOOP("Messages", "The environment has no \"%1\": there are %2."),
                shortened(name), allKeys()};
        }
    }
    Message problem;
    const UnknownNames kept(scene);
    JsonFields fields(top, "", problem, isStrict ? &kept.names() : nullptr);
    forEachPart([&](const auto& member) { readMember(member, fields, changed, problem); });
    if (isStrict) {
        checkEnvironment(scene, changed, problem);
    }
    if (!problem.empty()) {
        return Error{QT_TRANSLATE_NOOP("Messages", "%1."), problem};
    }
    scene = std::move(changed);
    return {};
}

} // namespace crowd::model
