// SPDX-License-Identifier: MIT
#include "model/gltf/GltfJson.h"

#include <algorithm>
#include <cmath>

#include <QtCore/QByteArrayView>

#include "model/gltf/GltfLimits.h"
#include "model/gltf/GltfText.h"

namespace crowd::model::gltf {

namespace {

/// What is too much about the text, empty if nothing is: found before anything is built from it.
Message excess(std::string_view text)
{
    int depth = 0;
    std::size_t values = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\') {
                ++i;
            } else if (c == '"') {
                inString = false;
            }
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            if (++depth > kMaxJsonDepth) {
                return {QT_TRANSLATE_NOOP("Messages",
                                          "the JSON is nested more than %1 levels deep at byte %2"),
                        kMaxJsonDepth, i};
            }
            ++values;
        } else if (c == '}' || c == ']') {
            --depth;
        } else if (c == ',') {
            ++values;
        }
        if (values > kMaxJsonValues) {
            return {QT_TRANSLATE_NOOP("Messages", "the JSON has more than %1 values"),
                    kMaxJsonValues};
        }
    }
    return {};
}

/// "… parse error at line 3, column 7: …" without nlohmann's error number in front.
std::string parseMessage(const char* what)
{
    std::string text(what);
    if (const std::size_t bracket = text.find("] "); bracket != std::string::npos) {
        text.erase(0, bracket + 2);
    }
    // It ends with all that was read of the last word, which may be megabytes, or no UTF-8.
    if (!QByteArrayView(text).isValidUtf8()) {
        text.resize(std::min(text.size(), text.find("; last read")));
    }
    return shortened(std::move(text), 240);
}

} // namespace

Result<Json> parseJson(std::string_view text)
{
    if (Message problem = excess(text); !problem.empty()) {
        return Error{std::move(problem)};
    }
    try {
        Json root = Json::parse(text.begin(), text.end());
        if (!root.is_object()) {
            return Error{
                QT_TRANSLATE_NOOP("Messages", "the JSON is not an object, so this is no glTF")};
        }
        return root;
    } catch (const Json::exception& problem) {
        return Error{QT_TRANSLATE_NOOP("Messages", "the JSON cannot be read: %1"),
                     parseMessage(problem.what())};
    }
}

const Json& member(const Json& object, const char* key)
{
    static const Json none;
    if (!object.is_object()) {
        return none;
    }
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
}

std::optional<std::uint64_t> asWhole(const Json& value)
{
    if (value.is_number_unsigned()) {
        return value.get<std::uint64_t>();
    }
    if (value.is_number_float()) {
        const auto number = value.get<double>();
        if (number >= 0.0 && number < 9.0e15 && number == std::floor(number)) {
            return static_cast<std::uint64_t>(number);
        }
    }
    return std::nullopt;
}

std::uint64_t wholeOr(const Json& object, const char* key, std::uint64_t fallback)
{
    return asWhole(member(object, key)).value_or(fallback);
}

std::string textOf(const Json& object, const char* key)
{
    const Json& value = member(object, key);
    return value.is_string() ? value.get<std::string>() : std::string();
}

std::size_t countOf(const Json& root, const char* arrayKey)
{
    const Json& array = member(root, arrayKey);
    return array.is_array() ? array.size() : 0;
}

std::string place(std::string_view array, std::size_t index)
{
    return std::string(array) + "[" + std::to_string(index) + "]";
}

} // namespace crowd::model::gltf
