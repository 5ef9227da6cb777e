// SPDX-License-Identifier: MIT
#include "model/gltf/GltfCheck.h"

#include <algorithm>

#include "model/gltf/GltfText.h"

namespace crowd::model::gltf {

bool JsonCheck::indexValue(Json& value, const char* target, const std::string& where)
{
    const std::optional<std::uint64_t> whole = asWhole(value);
    const std::size_t count = countOf(m_root, target);
    if (!whole) {
        return fail(where,
                    QT_TRANSLATE_NOOP("Messages", "%1 is not the index of one of the file's %2"),
                    target);
    }
    if (*whole >= count) {
        return fail(where, QT_TRANSLATE_NOOP("Messages", "%1 is %2, but the file has only %3 %4"),
                    *whole, count, target);
    }
    value = *whole;
    return true;
}

bool JsonCheck::index(Json& object, const std::string& key, const char* target,
                      const std::string& where, Need need)
{
    const auto found = object.find(key);
    if (found == object.end()) {
        return need == Need::Optional ||
               fail(where + "." + key, QT_TRANSLATE_NOOP("Messages", "%1 is missing"));
    }
    return indexValue(*found, target, where + "." + key);
}

bool JsonCheck::indices(Json& object, const char* key, const char* target, const std::string& where,
                        Need need)
{
    const auto found = object.find(key);
    if (found == object.end()) {
        return need == Need::Optional ||
               fail(where + "." + key, QT_TRANSLATE_NOOP("Messages", "%1 is missing"));
    }
    if (!found->is_array() || (found->empty() && need == Need::Required)) {
        return fail(where + "." + key,
                    QT_TRANSLATE_NOOP("Messages", "%1 is not a list of indices"));
    }
    for (std::size_t i = 0; i < found->size(); ++i) {
        if (!indexValue((*found)[i], target, where + "." + place(key, i))) {
            return false;
        }
    }
    return true;
}

bool JsonCheck::whole(Json& object, const char* key, const std::string& where, std::uint64_t low,
                      std::uint64_t high, Need need)
{
    const auto found = object.find(key);
    if (found == object.end()) {
        return need == Need::Optional ||
               fail(where + "." + key, QT_TRANSLATE_NOOP("Messages", "%1 is missing"));
    }
    const std::optional<std::uint64_t> value = asWhole(*found);
    if (!value || *value < low || *value > high) {
        return fail(where + "." + key,
                    QT_TRANSLATE_NOOP("Messages", "%1 is %2, not a whole number from %3 to %4"),
                    shortened(found->dump(), 40), low, high);
    }
    *found = *value;
    return true;
}

bool JsonCheck::numbers(const Json& object, const char* key, std::size_t count,
                        const std::string& where)
{
    const Json& list = member(object, key);
    if (list.is_null()) {
        return true;
    }
    const bool isFine =
        list.is_array() && list.size() == count &&
        std::all_of(list.begin(), list.end(), [](const Json& value) { return value.is_number(); });
    return isFine || fail(where + "." + key,
                          QT_TRANSLATE_NOOP("Messages", "%1 is not a list of %2 numbers"), count);
}

} // namespace crowd::model::gltf
