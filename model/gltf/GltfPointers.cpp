// SPDX-License-Identifier: MIT
#include "model/gltf/GltfPointers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>
#include <string_view>

#include "model/gltf/GltfText.h"

namespace crowd::model::gltf {

namespace {

constexpr std::size_t kMostNamed = 3; ///< pointers in one message

struct NodePointer
{
    std::size_t node = 0;
    std::string path;
};

/// "/nodes/3/rotation".
std::optional<NodePointer> nodePointer(std::string_view text, std::size_t nodes)
{
    constexpr std::string_view kStart = "/nodes/";
    constexpr std::array<std::string_view, 4> kPaths{"translation", "rotation", "scale", "weights"};
    if (!text.starts_with(kStart)) {
        return std::nullopt;
    }
    text.remove_prefix(kStart.size());
    NodePointer pointer;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pointer.node);
    const auto digits = static_cast<std::size_t>(end - text.data());
    if (error != std::errc() || pointer.node >= nodes || digits >= text.size() ||
        text[digits] != '/') {
        return std::nullopt;
    }
    pointer.path = text.substr(digits + 1);
    return std::ranges::find(kPaths, pointer.path) == kPaths.end() ? std::nullopt
                                                                   : std::optional(pointer);
}

class Resolver
{
public:
    Resolver(Json& root, std::vector<Message>& warnings)
        : m_root(root), m_warnings(warnings), m_nodes(countOf(root, "nodes"))
    {
    }

    void run()
    {
        Json kept = Json::array();
        for (std::size_t i = 0; i < countOf(m_root, "animations"); ++i) {
            Json& animation = m_root["animations"][i];
            if (keepsChannels(animation)) {
                kept.push_back(std::move(animation));
            } else {
                m_stillClips.push_back(textOf(animation, "name").empty()
                                           ? place("animations", i)
                                           : "\"" + shortened(textOf(animation, "name"), 60) +
                                                 "\"");
            }
        }
        if (m_root.contains("animations")) {
            m_root["animations"] = std::move(kept);
        }
        warn();
    }

private:
    /// False where pointers that are not followed were all it had.
    bool keepsChannels(Json& animation)
    {
        if (countOf(animation, "channels") == 0) {
            return true;
        }
        Json kept = Json::array();
        for (Json& channel : animation["channels"]) {
            if (follow(channel["target"])) {
                kept.push_back(std::move(channel));
            }
        }
        animation["channels"] = std::move(kept);
        return !animation["channels"].empty();
    }

    /// False for a pointer to anything but a node.
    bool follow(Json& target)
    {
        if (textOf(target, "path") != "pointer") {
            return true;
        }
        const std::string text =
            textOf(member(member(target, "extensions"), "KHR_animation_pointer"), "pointer");
        const std::optional<NodePointer> pointer = nodePointer(text, m_nodes);
        if (!pointer) {
            m_unread.insert(text);
            return false;
        }
        target = Json{{"node", pointer->node}, {"path", pointer->path}};
        return true;
    }

    void warn()
    {
        if (m_unread.empty()) {
            return;
        }
        std::string names;
        std::size_t named = 0;
        for (const std::string& pointer : m_unread) {
            if (++named <= kMostNamed) {
                names += (named > 1 ? ", " : "") + shortened(pointer, 80);
            }
        }
        names += m_unread.size() > kMostNamed ? ", …" : "";
        m_warnings.emplace_back(
            QT_TRANSLATE_NOOP("Messages", "KHR_animation_pointer moves nodes alone; what else it "
                                          "animates stands still (%1)."),
            names);
        for (const std::string& clip : m_stillClips) {
            m_warnings.emplace_back(
                QT_TRANSLATE_NOOP(
                    "Messages",
                    "The animation %1 moves nothing that Crowdbrush can move, and is left out."),
                clip);
        }
    }

    Json& m_root;
    std::vector<Message>& m_warnings;
    std::size_t m_nodes;
    std::set<std::string> m_unread;
    std::vector<std::string> m_stillClips;
};

} // namespace

void resolveAnimationPointers(Json& root, std::vector<Message>& warnings)
{
    Resolver(root, warnings).run();
}

} // namespace crowd::model::gltf
