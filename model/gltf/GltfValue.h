// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

#include <tiny_gltf.h>

/// Reading extras and extensions, which may hold anything.
namespace crowd::model::gltf {

/// Member of an object; null where there is none.
inline const tinygltf::Value* find(const tinygltf::Value& object, const std::string& key)
{
    return object.IsObject() && object.Has(key) ? &object.Get(key) : nullptr;
}

inline const tinygltf::Value* find(const tinygltf::ExtensionMap& extensions,
                                   const std::string& name)
{
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &found->second;
}

inline std::optional<double> numberIn(const tinygltf::Value& object, const std::string& key)
{
    const tinygltf::Value* value = find(object, key);
    return value != nullptr && value->IsNumber() ? std::optional(value->GetNumberAsDouble())
                                                 : std::nullopt;
}

inline std::optional<float> floatIn(const tinygltf::Value& object, const std::string& key)
{
    const std::optional<double> value = numberIn(object, key);
    return value && *value > -1e30 && *value < 1e30 ? std::optional(static_cast<float>(*value))
                                                    : std::nullopt;
}

/// Whole number member; `fallback` where it is missing or does not fit.
inline int wholeIn(const tinygltf::Value& object, const std::string& key, int fallback)
{
    const std::optional<double> value = numberIn(object, key);
    return value && *value > -2e9 && *value < 2e9 ? static_cast<int>(*value) : fallback;
}

inline std::string textIn(const tinygltf::Value& object, const std::string& key)
{
    const tinygltf::Value* value = find(object, key);
    return value != nullptr && value->IsString() ? value->Get<std::string>() : std::string();
}

inline std::optional<bool> flagIn(const tinygltf::Value& object, const std::string& key)
{
    const tinygltf::Value* value = find(object, key);
    if (value != nullptr && value->IsBool()) {
        return value->Get<bool>();
    }
    // Blender writes custom properties that are switches as 0 and 1.
    const std::optional<double> number = numberIn(object, key);
    return number ? std::optional(*number != 0.0) : std::nullopt;
}

/// The first `count` (at most 4) numbers of a list; false where there are fewer.
inline bool numbersIn(const tinygltf::Value& object, const std::string& key, int count, float* out)
{
    const tinygltf::Value* list = find(object, key);
    if (list == nullptr || !list->IsArray() || list->ArrayLen() < static_cast<std::size_t>(count)) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        const tinygltf::Value& value = list->Get(i);
        if (!value.IsNumber()) {
            return false;
        }
        out[i] = static_cast<float>(value.GetNumberAsDouble());
    }
    return true;
}

} // namespace crowd::model::gltf
