// SPDX-License-Identifier: MIT
#include "model/scene/Feature.h"

#include <algorithm>

namespace crowd::model {

namespace {

template<class Entries, class Value, class Member>
auto found(const Entries& entries, const Value& value, Member member)
{
    const auto each = std::ranges::find(entries, value, member);
    return each == entries.end() ? nullptr : &*each;
}

} // namespace

const FeatureValue* FeatureKind::find(std::string_view valueName) const
{
    return found(values, valueName, &FeatureValue::name);
}

const FeatureKind* findKind(const FeatureKinds& kinds, std::string_view name)
{
    return found(kinds, name, &FeatureKind::name);
}

const FeatureKind* findKind(const FeatureKinds& kinds, std::uint8_t id)
{
    return found(kinds, id, &FeatureKind::id);
}

const FeatureKind* kindOf(const FeatureKinds& kinds, FeatureId value)
{
    for (const FeatureKind& kind : kinds) {
        if (value != 0 && found(kind.values, value, &FeatureValue::id) != nullptr) {
            return &kind;
        }
    }
    return nullptr;
}

std::vector<NamedFeature> allFeatures(const FeatureKinds& kinds)
{
    std::vector<NamedFeature> all;
    for (const FeatureKind& kind : kinds) {
        for (const FeatureValue& value : kind.values) {
            all.push_back({value.id, value.name, kind.name});
        }
    }
    return all;
}

const FeatureValue* findFeature(const FeatureKinds& kinds, FeatureId value)
{
    const FeatureKind* kind = kindOf(kinds, value);
    return kind != nullptr ? found(kind->values, value, &FeatureValue::id) : nullptr;
}

} // namespace crowd::model
