# SPDX-License-Identifier: MIT
"""A template as it moves, read from the .glb alone (plain NumPy): every keyframe of every clip.

glTF's frame: metres, Y up, facing +Z."""
import numpy as np

from glb import accessor_values, read_glb

FRAMES_PER_SECOND = 32


def _matrices(translation, rotation, scale):
    """F x 4 x 4 of F translations, quaternions (x, y, z, w) and scales."""
    x, y, z, w = (rotation / np.linalg.norm(rotation, axis=1, keepdims=True)).T
    result = np.zeros((len(rotation), 4, 4))
    result[:, :3, :3] = np.moveaxis(np.array(
        [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
         [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
         [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]), 2, 0)
    result[:, :3, :3] *= scale[:, None, :]
    result[:, :3, 3], result[:, 3, 3] = translation, 1
    return result


class Primitive:
    """Triangles of one slot: rest positions V x 3, triangles T x 3, joints and weights V x 4."""

    def __init__(self, slot, node, positions, triangles, joints, weights):
        self.slot, self.node, self.positions, self.triangles = slot, node, positions, triangles
        self.joints, self.weights = joints, weights


class BakedTemplate:
    def __init__(self, path):
        self.document, self.binary = read_glb(path)
        self.nodes = self.document["nodes"]
        self.index = {n.get("name", str(i)): i for i, n in enumerate(self.nodes)}
        self.parent = {c: i for i, n in enumerate(self.nodes) for c in n.get("children", ())}
        self.clips = {a["name"]: a for a in self.document.get("animations", ())}
        coarser = {i for n in self.nodes for i in self._coarser(n)}
        self.finest = [i for i, n in enumerate(self.nodes) if "mesh" in n and i not in coarser]
        skins = self.document.get("skins", ())
        self.joints = skins[0]["joints"] if skins else []
        self.inverse = None
        if skins:
            columns = self.values(skins[0]["inverseBindMatrices"]).reshape(-1, 4, 4)
            self.inverse = columns.transpose(0, 2, 1)
        self.primitives = [p for i in self.finest for p in self._primitives(i)]

    @staticmethod
    def _coarser(node):
        return node.get("extensions", {}).get("MSFT_lod", {}).get("ids", [])

    def values(self, accessor):
        return accessor_values(self.document, self.binary, accessor)

    def _primitives(self, node):
        for item in self.document["meshes"][self.nodes[node]["mesh"]]["primitives"]:
            material = self.document["materials"][item["material"]]
            has, get = item["attributes"], lambda key: self.values(item["attributes"][key])
            yield Primitive(material.get("extras", {}).get("slot", material["name"]), node,
                            get("POSITION").astype(float),
                            self.values(item["indices"]).reshape(-1, 3).astype(int),
                            get("JOINTS_0").astype(int) if "JOINTS_0" in has else None,
                            get("WEIGHTS_0") if "WEIGHTS_0" in has else None)

    def is_skinned(self):
        return self.inverse is not None

    def tintable(self):
        """slot -> whether a tint colours it."""
        return {m["extras"]["slot"]: m["extras"]["tintable"] for m in self.document["materials"]}

    def looks(self):
        """slot -> how many materials there are to choose from."""
        slots = [m["extras"]["slot"] for m in self.document["materials"]]
        return {slot: slots.count(slot) for slot in slots}

    def triangles_per_level(self):
        """Skinned meshes alone for people, all meshes for machines."""
        counts = np.zeros(4, int)
        for i in self.finest:
            if self.is_skinned() and "skin" not in self.nodes[i]:
                continue
            levels = [i] + self._coarser(self.nodes[i])
            for k in range(4):
                mesh = self.document["meshes"][self.nodes[levels[min(k, len(levels) - 1)]]["mesh"]]
                counts[k] += sum(self.document["accessors"][p["indices"]]["count"] // 3
                                 for p in mesh["primitives"])
        return counts.tolist()

    def keyframes(self, clip):
        seconds = max(self.values(s["input"])[-1, 0] for s in self.clips[clip]["samplers"])
        return int(round(float(seconds) * FRAMES_PER_SECOND)) + 1

    def globals(self, clip):
        """Node -> F x 4 x 4 at every keyframe of the clip."""
        count, animation = self.keyframes(clip), self.clips[clip]
        times = np.arange(count) / FRAMES_PER_SECOND
        tracks = {}
        for channel in animation["channels"]:
            sampler = animation["samplers"][channel["sampler"]]
            keys, values = self.values(sampler["input"])[:, 0], self.values(sampler["output"])
            tracks[channel["target"]["node"], channel["target"]["path"]] = np.stack(
                [np.interp(times, keys, values[:, c]) for c in range(values.shape[1])], 1)
        rest = {"translation": (0, 0, 0), "rotation": (0, 0, 0, 1), "scale": (1, 1, 1)}
        result = {}

        def world(i):
            if i not in result:
                own = [tracks.get((i, path), np.tile(self.nodes[i].get(path, value), (count, 1)))
                       for path, value in rest.items()]
                local = _matrices(*own)
                result[i] = world(self.parent[i]) @ local if i in self.parent else local
            return result[i]
        for i in range(len(self.nodes)):
            world(i)
        return result

    def deformed(self, primitive, world, frames):
        """len(frames) x V x 3."""
        points = np.concatenate([primitive.positions, np.ones((len(primitive.positions), 1))], 1)
        if primitive.joints is None:
            return np.einsum("fij,vj->fvi", world[primitive.node][frames], points)[..., :3]
        palette = np.stack([world[joint][frames] @ self.inverse[i]
                            for i, joint in enumerate(self.joints)], 1)[:, :, :3]
        share = np.zeros((len(points), len(self.joints)))
        for k in range(4):
            np.add.at(share, (np.arange(len(points)), primitive.joints[:, k]),
                      primitive.weights[:, k])
        share /= share.sum(1, keepdims=True)
        blended = share @ palette.reshape(len(palette), len(self.joints), 12)
        blended = blended.reshape(len(palette), len(points), 3, 4)
        return sum(blended[..., k] * points[:, k, None] for k in range(4))
