# SPDX-License-Identifier: MIT
"""Writes animals and machines: plain colours per slot, bones or moving nodes, no textures.

Authoring frame: metres, Z up, facing -Y."""
import math

import numpy as np

from geometry import rot_x, srgb_to_linear, to_gltf
from glb import INDICES, VERTICES, GlbWriter, vertex_attributes
from gloss import CLOTH, gloss_of
from person_file import TO_GLTF, quaternions

FRAMES_PER_SECOND = 32
SHARP_DEGREES = 40
LEVELS = 4
SIDES = (1, .70, .46, .30)  # of a tube, what each level keeps
FEWEST_SIDES = (5, 4, 3, 3)


def thinned(rings, level):
    """The ends and every ring between, two out of three of them, every second one, or one."""
    if level == 0 or len(rings) < 4:
        return rings
    if level == 1:
        return [rings[0], *(r for k, r in enumerate(rings[1:-1]) if k % 3 != 1), rings[-1]]
    if level == 2:
        return [rings[0], *rings[1:-1][::2], rings[-1]]
    return [rings[0], rings[len(rings) // 2], rings[-1]]


class Shape:
    """Vertices with a bone share each, and faces with a slot, at one level of detail.

    Tubes get coarser by themselves; what is small is left out past the level "until". Edges that
    turn by more than sharp_degrees are hard."""

    def __init__(self, level=0, sharp_degrees=SHARP_DEGREES):
        self.level, self.sharp_degrees = level, sharp_degrees
        self.positions, self.weights, self.faces = [], [], []

    def add(self, points, weights):
        first = len(self.positions)
        self.positions += [np.array(p, float) for p in points]
        self.weights += [weights] * len(points)
        return list(range(first, first + len(points)))

    def face(self, ids, slot):
        self.faces += [((ids[0], ids[i], ids[i + 1]), slot) for i in range(1, len(ids) - 1)]

    def tube(self, rings, sides, slot, upright=False, until=LEVELS):
        """rings: (centre, half width, half height, weights), closed at both ends. A tube runs
        along Y; upright ones along Z, where the second radius lies along Y."""
        if self.level > until:
            return
        rings = thinned(rings, self.level)
        sides = max(min(sides, FEWEST_SIDES[self.level]), round(sides * SIDES[self.level]))
        turns = [2 * math.pi * (i + .5) / sides for i in range(sides)]
        rows = []
        for (x, y, z), wide, high, weights in rings:
            rows.append(self.add(
                [(x + wide * math.cos(t), y + high * math.sin(t), z) if upright else
                 (x + wide * math.cos(t), y, z + high * math.sin(t)) for t in turns], weights))
        first, last = rings[0][0], rings[-1][0]
        turned = (last[2] > first[2]) if upright else (last[1] < first[1])
        order = (lambda ids: ids) if turned else (lambda ids: ids[::-1])
        for low, high in zip(rows[:-1], rows[1:]):
            for i in range(sides):
                j = (i + 1) % sides
                self.face(order([low[i], low[j], high[j], high[i]]), slot)
        self.face(order(rows[0][::-1]), slot)
        self.face(order(rows[-1]), slot)

    def box(self, low, high, slot, weights=None, until=LEVELS):
        if self.level > until:
            return
        (x0, y0, z0), (x1, y1, z1) = low, high
        p = self.add([(x, y, z) for z in (z0, z1)
                      for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))], weights)
        for side in ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (4, 5, 6, 7),
                     (3, 2, 1, 0)):
            self.face([p[i] for i in side], slot)

    def triangles(self):
        return len(self.faces)

    def split(self, slot):
        """(positions, normals, weights, triangles) of one slot, hard edges kept hard."""
        points = np.array(self.positions)
        faces = [f for f, s in self.faces if s == slot]
        normal = {f: np.cross(points[f[1]] - points[f[0]], points[f[2]] - points[f[0]])
                  for f in faces}
        around = {}
        for f in faces:
            for i in f:
                around.setdefault(i, []).append(normal[f])
        rows, index, triangles = [], {}, []
        limit = math.cos(math.radians(self.sharp_degrees))
        for f in faces:
            own = normal[f] / max(np.linalg.norm(normal[f]), 1e-12)
            corner = []
            for i in f:
                soft = sum(n for n in around[i]
                           if np.dot(n, own) >= limit * np.linalg.norm(n) - 1e-12)
                soft = soft / max(np.linalg.norm(soft), 1e-12)
                key = (i, tuple(np.round(soft, 2)))
                if key not in index:
                    index[key] = len(rows)
                    rows.append((points[i], soft, self.weights[i]))
                corner.append(index[key])
            triangles.append(corner)
        return (np.array([r[0] for r in rows]), np.array([r[1] for r in rows]),
                [r[2] for r in rows], np.array(triangles))


class CreatureWriter:
    """looks: slot -> ((variant or "", 0..255 sRGB), ...), the default first.
    bones: name -> (parent, place), parents first."""

    def __init__(self, name, looks, bones):
        self.name, self.looks, self.bones, self.glb = name, looks, bones, GlbWriter()
        self.materials = self._materials()
        self.node = {}
        for bone, (parent, place) in bones.items():
            start = np.array(bones[parent][1] if parent else (0, 0, 0), float)
            offset = to_gltf(np.array(place, float) - start)
            node = {"name": bone}
            if np.any(offset):
                node["translation"] = [round(float(v), 6) for v in offset]
            self.node[bone] = self.glb.add("nodes", node)
            if parent:
                self._child(parent, self.node[bone])

    def _child(self, parent, node):
        self.glb.document["nodes"][self.node[parent]].setdefault("children", []).append(node)

    def _materials(self):
        names, result = [], {}
        for slot, looks in self.looks.items():
            mappings, default = [], None
            for variant, rgb in looks:
                factor = [round(c, 4) for c in srgb_to_linear(rgb)] + [1.0]
                material = self.glb.add("materials", {
                    "name": variant or slot, "pbrMetallicRoughness": {
                        "baseColorFactor": factor, **gloss_of(self.name, slot, CLOTH)},
                    "extras": {"slot": slot, "tintable": slot not in ("eyes", "glass")}})
                if variant:
                    mappings.append({"material": material, "variants": [len(names)]})
                    names.append({"name": variant})
                else:
                    default = material
            result[slot] = default, mappings
        if names:
            self.glb.document["extensions"] = {"KHR_materials_variants": {"variants": names}}
            self.glb.document["extensionsUsed"] = ["KHR_materials_variants"]
        return result

    def mesh(self, name, shape, origin=(0, 0, 0), is_skinned=False):
        primitives = []
        for slot in self.looks:
            if not any(s == slot for _, s in shape.faces):
                continue
            points, normals, weights, triangles = shape.split(slot)
            attributes = vertex_attributes(self.glb, to_gltf(points - np.array(origin)),
                                           to_gltf(normals))
            if is_skinned:
                joints, shares = self._influences(weights)
                attributes["JOINTS_0"] = self.glb.accessor(joints, "VEC4", VERTICES)
                attributes["WEIGHTS_0"] = self.glb.accessor(shares, "VEC4", VERTICES, True)
            default, mappings = self.materials[slot]
            primitive = {"attributes": attributes, "material": default,
                         "indices": self.glb.accessor(triangles.reshape(-1).astype(np.uint16),
                                                      "SCALAR", INDICES)}
            if mappings:
                primitive["extensions"] = {"KHR_materials_variants": {"mappings": mappings}}
            primitives.append(primitive)
        return self.glb.add("meshes", {"name": name, "primitives": primitives})

    def _influences(self, weights):
        order = list(self.bones)
        joints = np.zeros((len(weights), 4), np.uint8)
        shares = np.zeros((len(weights), 4), np.uint8)
        for row, own in enumerate(weights):
            for i, (bone, share) in enumerate((b, w) for b, w in own.items() if w > 0):
                joints[row, i], shares[row, i] = order.index(bone), round(share * 255)
            shares[row, 0] += 255 - int(shares[row].sum())
        return joints, shares

    def hang(self, bone, shapes):
        """A stiff mesh on a moving node; one shape per level of detail."""
        nodes = []
        for level, shape in enumerate(shapes):
            name = f"{bone}_mesh" if level == 0 else f"{bone}_mesh_LOD{level}"
            nodes.append(self.glb.add("nodes", {"name": name, "mesh": self.mesh(
                name, shape, self.bones[bone][1])}))
            self._child(bone, nodes[-1])
        self._link_levels(nodes)

    def _link_levels(self, nodes):
        self.glb.document["nodes"][nodes[0]]["extensions"] = {"MSFT_lod": {"ids": nodes[1:]}}
        used = self.glb.document.setdefault("extensionsUsed", [])
        if "MSFT_lod" not in used:
            used.append("MSFT_lod")

    def skin(self, shapes):
        """The node of the finest level; one shape per level of detail."""
        inverse = np.tile(np.eye(4, dtype=np.float32), (len(self.bones), 1, 1))
        for i, (_, place) in enumerate(self.bones.values()):
            inverse[i, 3, :3] = -to_gltf(np.array(place, float))
        skin = self.glb.add("skins", {
            "name": self.name, "skeleton": 0, "joints": list(self.node.values()),
            "inverseBindMatrices": self.glb.accessor(inverse.reshape(-1, 16), "MAT4")})
        nodes = []
        for level, shape in enumerate(shapes):
            name = self.name if level == 0 else f"{self.name}_LOD{level}"
            mesh = self.mesh(name, shape, is_skinned=True)
            nodes.append(self.glb.add("nodes", {"name": name, "mesh": mesh, "skin": skin}))
        self._link_levels(nodes)
        return nodes[0]

    def clip(self, name, frames, pose_at, speed=0.0):
        """pose_at(phase) -> bone -> (offset or None, 3x3 rotation or None); it must loop."""
        times = (np.arange(frames + 1) / FRAMES_PER_SECOND).astype(np.float32)
        poses = [pose_at((i % frames) / frames) for i in range(frames + 1)]
        animation = {"name": name, "channels": [], "samplers": [],
                     "extras": {"speed": round(float(speed), 3), "loop": True}}
        for bone in poses[0]:
            offset, turn = poses[0][bone]
            if turn is not None:
                values = quaternions([TO_GLTF @ p[bone][1] @ TO_GLTF.T for p in poses])
                keys = np.round(values * 32767).astype(np.int16)
                self._channel(animation, bone, "rotation", times,
                              self.glb.accessor(keys, "VEC4", normalized=True))
            if offset is not None:
                parent, place = self.bones[bone]
                rest = np.array(place, float) - np.array(self.bones[parent][1] if parent
                                                         else (0, 0, 0), float)
                values = to_gltf(np.array([rest + p[bone][0] for p in poses])).astype(np.float32)
                self._channel(animation, bone, "translation", times,
                              self.glb.accessor(values, "VEC3"))
        self.glb.add("animations", animation)

    def _channel(self, animation, bone, path, times, output):
        animation["samplers"].append({
            "input": self.glb.accessor(times[:, None], "SCALAR", bounds=True), "output": output,
            "interpolation": "LINEAR"})
        animation["channels"].append({"sampler": len(animation["samplers"]) - 1,
                                      "target": {"node": self.node[bone], "path": path}})

    def write(self, path, extra_nodes=()):
        self.glb.add("scenes", {"name": self.name,
                                "nodes": [self.node[next(iter(self.bones))], *extra_nodes]})
        self.glb.write(path)


def about_x(degrees):
    return None, rot_x(degrees)
