// SPDX-License-Identifier: MIT
#include "model/gltf/GltfCheckScenes.h"

#include <vector>

namespace crowd::model::gltf {

namespace {

class SceneCheck
{
public:
    explicit SceneCheck(JsonCheck& check) : m_check(check) {}

    bool run()
    {
        return checkNodes() && checkSkins() && checkAnimations() && checkScenes() && checkTrees();
    }

private:
    bool checkNodes()
    {
        return m_check.each(
            m_check.root(), "nodes", "", [this](Json& node, const std::string& where) {
                return m_check.indices(node, "children", "nodes", where) &&
                       m_check.index(node, "mesh", "meshes", where) &&
                       m_check.index(node, "skin", "skins", where) &&
                       m_check.numbers(node, "matrix", 16, where) &&
                       m_check.numbers(node, "translation", 3, where) &&
                       m_check.numbers(node, "rotation", 4, where) &&
                       m_check.numbers(node, "scale", 3, where) && checkLods(node, where);
            });
    }

    bool checkLods(Json& node, const std::string& where)
    {
        if (!member(member(node, "extensions"), "MSFT_lod").is_object()) {
            return true;
        }
        return m_check.indices(node["extensions"]["MSFT_lod"], "ids", "nodes",
                               where + ".extensions.MSFT_lod");
    }

    bool checkSkins()
    {
        return m_check.each(
            m_check.root(), "skins", "", [this](Json& skin, const std::string& where) {
                if (!m_check.indices(skin, "joints", "nodes", where, JsonCheck::Need::Required) ||
                    !m_check.index(skin, "inverseBindMatrices", "accessors", where)) {
                    return false;
                }
                if (!skin.contains("inverseBindMatrices")) {
                    return true;
                }
                const Json& accessor =
                    m_check.root()["accessors"][wholeOr(skin, "inverseBindMatrices", 0)];
                if (textOf(accessor, "type") != "MAT4" ||
                    wholeOr(accessor, "componentType", 0) != 5126 ||
                    wholeOr(accessor, "count", 0) < countOf(skin, "joints")) {
                    return m_check.fail(
                        where + ".inverseBindMatrices",
                        QT_TRANSLATE_NOOP("Messages",
                                          "%1 is not a list of one 4x4 matrix a joint"));
                }
                return true;
            });
    }

    bool checkAnimations()
    {
        return m_check.each(
            m_check.root(), "animations", "", [this](Json& clip, const std::string& where) {
                const std::size_t samplers = countOf(clip, "samplers");
                return m_check.each(clip, "samplers", where + ".",
                                    [this](Json& sampler, const std::string& at) {
                                        return m_check.index(sampler, "input", "accessors", at,
                                                             JsonCheck::Need::Required) &&
                                               m_check.index(sampler, "output", "accessors", at,
                                                             JsonCheck::Need::Required);
                                    }) &&
                       m_check.each(clip, "channels", where + ".",
                                    [&](Json& channel, const std::string& at) {
                                        return checkChannel(channel, samplers, at);
                                    });
            });
    }

    bool checkChannel(Json& channel, std::size_t samplers, const std::string& where)
    {
        if (wholeOr(channel, "sampler", samplers) >= samplers) {
            return m_check.fail(
                where + ".sampler",
                QT_TRANSLATE_NOOP("Messages", "%1 is not one of the animation's %2 samplers"),
                samplers);
        }
        const auto target = channel.find("target");
        if (target == channel.end() || !target->is_object()) {
            return m_check.fail(where + ".target", QT_TRANSLATE_NOOP("Messages", "%1 is missing"));
        }
        return m_check.index(*target, "node", "nodes", where + ".target");
    }

    bool checkScenes()
    {
        if (m_check.root().contains("scene") && countOf(m_check.root(), "scenes") == 0) {
            return m_check.fail(
                "scene", QT_TRANSLATE_NOOP("Messages", "%1 names a scene, but the file has none"));
        }
        return m_check.index(m_check.root(), "scene", "scenes", "file") &&
               m_check.each(m_check.root(), "scenes", "",
                            [this](Json& scene, const std::string& where) {
                                return m_check.indices(scene, "nodes", "nodes", where);
                            });
    }

    /// Each node has at most one parent, and following parents ends at a root.
    bool checkTrees()
    {
        const std::size_t count = countOf(m_check.root(), "nodes");
        std::vector<std::size_t> parent(count, count);
        for (std::size_t i = 0; i < count; ++i) {
            const Json& children = member(m_check.root()["nodes"][i], "children");
            for (std::size_t c = 0; children.is_array() && c < children.size(); ++c) {
                const auto child = children[c].get<std::size_t>();
                if (parent[child] != count && parent[child] != i) {
                    return m_check.fail(
                        place("nodes", child),
                        QT_TRANSLATE_NOOP("Messages", "%1 is a child of both %2 and %3"),
                        place("nodes", parent[child]), place("nodes", i));
                }
                parent[child] = i;
            }
        }
        return checkCycles(parent);
    }

    bool checkCycles(const std::vector<std::size_t>& parent)
    {
        const std::size_t count = parent.size();
        std::vector<std::size_t> seenFrom(count, count);
        for (std::size_t start = 0; start < count; ++start) {
            for (std::size_t at = start; at != count && seenFrom[at] == count; at = parent[at]) {
                seenFrom[at] = start;
                if (parent[at] != count && seenFrom[parent[at]] == start) {
                    return m_check.fail(place("nodes", at),
                                        QT_TRANSLATE_NOOP("Messages", "%1 is its own ancestor"));
                }
            }
        }
        return true;
    }

    JsonCheck& m_check;
};

} // namespace

bool checkScenes(JsonCheck& check)
{
    return SceneCheck(check).run();
}

} // namespace crowd::model::gltf
