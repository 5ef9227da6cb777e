# SPDX-License-Identifier: MIT
"""Writes one person: levels of detail, skeleton, clips, materials and variants."""
import numpy as np

import wardrobe
from body_skirt import gathered
from clips import FRAMES_PER_SECOND
from geometry import srgb_to_linear, to_gltf
from glb import INDICES, VERTICES, GlbWriter, vertex_attributes
from gloss import CLOTH, gloss_of

TO_GLTF = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]], float)
STILL_METRES, STILL_QUATERNION = 2e-4, 1e-4


def quaternion(m):
    """x, y, z, w of a rotation matrix, from its largest component for accuracy."""
    squares = np.array([1 + m[0, 0] - m[1, 1] - m[2, 2], 1 - m[0, 0] + m[1, 1] - m[2, 2],
                        1 - m[0, 0] - m[1, 1] + m[2, 2], 1 + m[0, 0] + m[1, 1] + m[2, 2]])
    q = np.sqrt(np.maximum(squares, 0)) / 2
    i = int(np.argmax(q))
    if i == 3:
        q[:3] = np.array((m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1])) / (4 * q[3])
    else:
        j, k = (i + 1) % 3, (i + 2) % 3
        q[j], q[k] = (m[i, j] + m[j, i]) / (4 * q[i]), (m[i, k] + m[k, i]) / (4 * q[i])
        q[3] = (m[k, j] - m[j, k]) / (4 * q[i])
    return q / np.linalg.norm(q)


def quaternions(matrices):
    """One per matrix, each in the hemisphere of the one before."""
    result = []
    for m in matrices:
        q = quaternion(m)
        result.append(-q if result and np.dot(q, result[-1]) < 0 else q)
    return np.array(result)


class PersonWriter:
    def __init__(self, body, bones):
        self.body, self.bones, self.glb = body, bones, GlbWriter()
        self.joint = {}

    def write(self, levels, accessories, clips, path):
        """levels: per level (parts by slot, openness, weights by source vertex);
        accessories: (name, joint, slot, is shown, mesh part per level)."""
        materials = self._materials()
        skin = self._skeleton()
        nodes = [self._level(number, level, materials, skin)
                 for number, level in enumerate(levels)]
        first = self.glb.document["nodes"][nodes[0]]
        first["extensions"] = {"MSFT_lod": {"ids": nodes[1:]}}
        for accessory in accessories:
            self._accessory(accessory, materials)
        for clip in clips:
            self._clip(clip)
        self.glb.document["extensionsUsed"] = ["KHR_materials_variants", "MSFT_lod"]
        self.glb.add("scenes", {"name": self.body.name,
                                "nodes": [nodes[0], self.joint["root"]]})
        self.glb.write(path)

    def _materials(self):
        """slot -> (default material, variant mappings)."""
        pictures = {name: self.glb.add("textures", {"source": self.glb.image(data, name)})
                    for name, data in wardrobe.textures(self.body).items()}
        names, result = [], {}
        for slot, looks in wardrobe.looks(self.body).items():
            mappings = []
            for look in looks:
                material = self.glb.add("materials", self._material(slot, look, pictures))
                if look.variant:
                    mappings.append({"material": material, "variants": [len(names)]})
                    names.append({"name": look.variant})
                else:
                    default = material
            result[slot] = (default, mappings)
        self.glb.document["extensions"] = {"KHR_materials_variants": {"variants": names}}
        return result

    def _material(self, slot, look, pictures):
        factor = [round(c, 4) for c in srgb_to_linear(look.rgb)]
        return {"name": look.variant or slot,
                "pbrMetallicRoughness": {"baseColorFactor": factor + [1.0],
                                         "baseColorTexture": {"index": pictures[look.image]},
                                         **gloss_of(self.body.name, slot, CLOTH)},
                "extras": {"slot": slot, "tintable": wardrobe.is_tintable(slot)}}

    def _skeleton(self):
        for name, bone in self.bones.items():
            parent = self.bones[bone.parent].head if bone.parent else np.zeros(3)
            node = {"name": name}
            offset = to_gltf(bone.head - parent)
            if np.any(offset):
                node["translation"] = [round(float(x), 6) for x in offset]
            self.joint[name] = self.glb.add("nodes", node)
            if bone.parent:
                above = self.glb.document["nodes"][self.joint[bone.parent]]
                above.setdefault("children", []).append(self.joint[name])
        inverse = np.tile(np.eye(4, dtype=np.float32), (len(self.bones), 1, 1))
        for i, bone in enumerate(self.bones.values()):
            inverse[i, 3, :3] = -to_gltf(bone.head)  # column-major: the last row is the offset
        return self.glb.add("skins", {
            "name": self.body.name, "skeleton": self.joint["root"],
            "joints": list(self.joint.values()),
            "inverseBindMatrices": self.glb.accessor(inverse.reshape(-1, 16), "MAT4")})

    def _level(self, number, level, materials, skin):
        parts, openness, weights = level
        joints, shares = self._influences(weights)
        primitives = []
        for slot, part in zip(wardrobe.slots(self.body), parts):
            if part is None:
                continue
            light = openness[part.source]
            colors = np.stack([light, light, light, np.ones_like(light)], 1)
            attributes = vertex_attributes(self.glb, part.positions, part.normals, colors,
                                           part.values)
            attributes["JOINTS_0"] = self.glb.accessor(joints[part.source], "VEC4", VERTICES)
            attributes["WEIGHTS_0"] = self.glb.accessor(shares[part.source], "VEC4", VERTICES,
                                                        True)
            default, mappings = materials[slot]
            primitive = {
                "attributes": attributes, "material": default,
                "indices": self.glb.accessor(part.triangles.reshape(-1).astype(np.uint16),
                                             "SCALAR", INDICES)}
            if mappings:
                primitive["extensions"] = {"KHR_materials_variants": {"mappings": mappings}}
            primitives.append(primitive)
        name = self.body.name if number == 0 else f"{self.body.name}_LOD{number}"
        mesh = self.glb.add("meshes", {"name": name, "primitives": primitives})
        return self.glb.add("nodes", {"name": name, "mesh": mesh, "skin": skin})

    def _accessory(self, accessory, materials):
        """A mesh without skin under its joint, which makes it a part that can be hidden."""
        name, joint, slot, is_shown, parts = accessory
        default, mappings = materials[slot]
        nodes = []
        for number, part in enumerate(parts):
            white = np.ones((len(part.positions), 4))
            primitive = {"attributes": vertex_attributes(
                self.glb, part.positions, part.normals, white,
                np.full((len(part.positions), 2), .5)), "material": default,
                "indices": self.glb.accessor(part.triangles.reshape(-1).astype(np.uint16),
                                             "SCALAR", INDICES)}
            if mappings:
                primitive["extensions"] = {"KHR_materials_variants": {"mappings": mappings}}
            label = name if number == 0 else f"{name}_LOD{number}"
            mesh = self.glb.add("meshes", {"name": label, "primitives": [primitive]})
            nodes.append(self.glb.add("nodes", {"name": label, "mesh": mesh}))
        first = self.glb.document["nodes"][nodes[0]]
        first["extras"] = {"shown": is_shown}
        first["extensions"] = {"MSFT_lod": {"ids": nodes[1:]}}
        above = self.glb.document["nodes"][self.joint[joint]]
        above.setdefault("children", []).extend(nodes)

    def _influences(self, weights):
        """Joint indices and weights in bytes that sum to 255."""
        order = {name: i for i, name in enumerate(self.bones)}
        joints = np.zeros((len(weights), 4), np.uint8)
        shares = np.zeros((len(weights), 4), np.uint8)
        for row, own in enumerate(weights):
            items = sorted(own.items(), key=lambda item: (-item[1], order[item[0]]))
            bytes_ = [int(round(share * 255)) for _, share in items]
            bytes_[0] += 255 - sum(bytes_)
            for i, ((name, _), share) in enumerate(zip(items, bytes_)):
                if share > 0:
                    joints[row, i], shares[row, i] = order[name], share
        return joints, shares

    def _clip(self, clip):
        animation = {"name": clip.name, "channels": [], "samplers": [], "extras": clip.extras}
        times = (np.arange(clip.frames + 1) / FRAMES_PER_SECOND).astype(np.float32)
        for name, matrices in clip.local.items():
            values = quaternions([TO_GLTF @ m @ TO_GLTF.T for m in matrices])
            if clip.extras["loop"]:
                values[-1] = values[0] if np.dot(values[0], values[-1]) > 0 else -values[0]
            if np.abs(values - (0, 0, 0, 1)).max() < STILL_QUATERNION:
                continue
            keys = np.round(values * 32767).astype(np.int16)
            self._channel(animation, name, "rotation", times, keys, "VEC4", True)
        offsets = to_gltf(np.array(clip.hips) - self.bones["root"].head).astype(np.float32)
        if clip.extras["loop"]:
            offsets[-1] = offsets[0]
        if np.abs(offsets - to_gltf(self.bones["hips"].head)).max() > STILL_METRES:
            self._channel(animation, "hips", "translation", times, offsets, "VEC3", False)
        if "skirt_L" in self.bones and max(clip.gather) > 0:
            self._gather(animation, times, np.array(clip.gather)[:, None])
        self.glb.add("animations", animation)

    def _gather(self, animation, times, share):
        """Draws a short skirt around the thighs."""
        offset, scale = gathered(self.body)
        for side, sign in (("_L", 1), ("_R", -1)):
            moved = to_gltf(share * offset * (sign, 1, 1)).astype(np.float32)
            sized = 1 + share * (scale[[0, 2, 1]] - 1)
            self._channel(animation, "skirt" + side, "translation", times, moved, "VEC3", False)
            self._channel(animation, "skirt" + side, "scale", times, sized.astype(np.float32),
                          "VEC3", False)

    def _channel(self, animation, bone, path, times, values, kind, normalized):
        if np.ptp(values.astype(float), axis=0).max() == 0:
            times, values = times[[0, -1]], values[[0, -1]]
        animation["samplers"].append({
            "input": self.glb.accessor(times[:, None], "SCALAR", bounds=True),
            "output": self.glb.accessor(values, kind, normalized=normalized),
            "interpolation": "LINEAR"})
        animation["channels"].append({"sampler": len(animation["samplers"]) - 1,
                                      "target": {"node": self.joint[bone], "path": path}})
