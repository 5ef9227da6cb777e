#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Facts about glTF files, read with nothing but Python's standard library.

An independent second opinion for the importer's tests: triangles, slots, clips and the height of
the first keyframe of a named clip. Standard input holds one "path<TAB>clip" a line (an empty clip
means the resting pose); standard output gets one JSON object, facts by path.
"""
import base64
import json
import math
import os
import struct
import sys
import urllib.parse

COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
FORMATS = {5120: "b", 5121: "B", 5122: "h", 5123: "H", 5125: "I", 5126: "f"}
NORMALIZERS = {5120: 127.0, 5121: 255.0, 5122: 32767.0, 5123: 65535.0, 5125: 4294967295.0}


class Gltf:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        binary = b""
        if data[:4] == b"glTF":
            size = struct.unpack_from("<I", data, 12)[0]
            text = data[20:20 + size]
            binary = data[20 + size + 8:]
        else:
            text = data
        self.json = json.loads(text)
        self.folder = os.path.dirname(path)
        self.buffers = [self.buffer(b, binary) for b in self.json.get("buffers", [])]

    def buffer(self, buffer, binary):
        uri = buffer.get("uri")
        if uri is None:
            return binary
        if uri.startswith("data:"):
            return base64.b64decode(uri.split(",", 1)[1])
        with open(os.path.join(self.folder, urllib.parse.unquote(uri)), "rb") as file:
            return file.read()

    def items(self, key):
        return self.json.get(key, [])

    def run(self, view_index, offset, count, component_type, components, stride=None):
        """`count` tuples of raw numbers from a buffer view."""
        view = self.items("bufferViews")[view_index]
        one = "<%d%s" % (components, FORMATS[component_type])
        step = stride or struct.calcsize(one)
        begin = view.get("byteOffset", 0) + offset
        data = self.buffers[view["buffer"]]
        return [struct.unpack_from(one, data, begin + i * step) for i in range(count)]

    def accessor(self, index):
        a = self.items("accessors")[index]
        components = COMPONENTS[a["type"]]
        kind = a["componentType"]
        if "bufferView" in a:
            stride = self.items("bufferViews")[a["bufferView"]].get("byteStride")
            values = self.run(a["bufferView"], a.get("byteOffset", 0), a["count"], kind, components,
                              stride)
        else:
            values = [(0,) * components] * a["count"]
        if "sparse" in a:
            s = a["sparse"]
            at = self.run(s["indices"]["bufferView"], s["indices"].get("byteOffset", 0), s["count"],
                          s["indices"]["componentType"], 1)
            new = self.run(s["values"]["bufferView"], s["values"].get("byteOffset", 0), s["count"],
                           kind, components)
            for (i,), value in zip(at, new):
                values[i] = value
        if a.get("normalized") and kind in NORMALIZERS:
            divisor = NORMALIZERS[kind]
            values = [tuple(max(x / divisor, -1.0) for x in v) for v in values]
        return [tuple(x if math.isfinite(x) else 0.0 for x in v) for v in values]


def multiply(a, b):
    """4x4 matrices, columns one after another."""
    return tuple(sum(a[k * 4 + row] * b[column * 4 + k] for k in range(4))
                 for column in range(4) for row in range(4))


def matrix_of(node):
    if "matrix" in node:
        return tuple(node["matrix"])
    tx, ty, tz = node.get("translation", (0, 0, 0))
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    length = math.sqrt(x * x + y * y + z * z + w * w) or 1.0
    x, y, z, w = x / length, y / length, z / length, w / length
    sx, sy, sz = node.get("scale", (1, 1, 1))
    return ((1 - 2 * (y * y + z * z)) * sx, 2 * (x * y + z * w) * sx, 2 * (x * z - y * w) * sx, 0,
            2 * (x * y - z * w) * sy, (1 - 2 * (x * x + z * z)) * sy, 2 * (y * z + x * w) * sy, 0,
            2 * (x * z + y * w) * sz, 2 * (y * z - x * w) * sz, (1 - 2 * (x * x + y * y)) * sz, 0,
            tx, ty, tz, 1)


IDENTITY = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)


def scene_roots(gltf):
    scenes = gltf.items("scenes")
    if scenes:
        return scenes[gltf.json.get("scene", 0)].get("nodes", [])
    children = {c for n in gltf.items("nodes") for c in n.get("children", [])}
    return [i for i in range(len(gltf.items("nodes"))) if i not in children]


def is_drawn(primitive):
    return primitive.get("mode", 4) >= 4 and "POSITION" in primitive["attributes"]


def drawn(gltf):
    """(node, mesh, primitive) of the default scene, without coarser levels of detail."""
    nodes = gltf.items("nodes")
    coarser = {i for n in nodes
               for i in n.get("extensions", {}).get("MSFT_lod", {}).get("ids", [])}
    stack = list(reversed(scene_roots(gltf)))
    while stack:
        i = stack.pop()
        stack.extend(reversed(nodes[i].get("children", [])))
        if "mesh" in nodes[i] and i not in coarser:
            mesh = gltf.items("meshes")[nodes[i]["mesh"]]
            for primitive in mesh["primitives"]:
                if is_drawn(primitive):
                    yield nodes[i], i, mesh, primitive


def triangle_count(gltf, primitive):
    corners = gltf.items("accessors")[primitive.get("indices",
                                                    primitive["attributes"]["POSITION"])]["count"]
    return corners // 3 if primitive.get("mode", 4) == 4 else max(corners - 2, 0)


def slot_names(gltf):
    used = sorted({p.get("material", math.inf) for _, _, _, p in drawn(gltf)})
    materials = gltf.items("materials")
    names = []
    for i in used:
        if i == math.inf:
            name = "default"
        else:
            material = materials[i]
            name = material.get("extras", {}).get("slot") or material.get("name") or f"material_{i}"
        names.append(name)
    return names


def clip_facts(gltf):
    facts = []
    for i, animation in enumerate(gltf.items("animations")):
        times = [t for c in animation["channels"]
                 for (t,) in gltf.accessor(animation["samplers"][c["sampler"]]["input"])]
        seconds = max(times) - min(times) if times else 0.0
        facts.append({"name": animation.get("name") or f"animation_{i}", "seconds": seconds})
    return facts


def posed_nodes(gltf, clip):
    """The nodes with the values of a clip's first keys in place of their own."""
    nodes = [dict(n) for n in gltf.items("nodes")]
    for i, animation in enumerate(gltf.items("animations")):
        if clip != (animation.get("name") or f"animation_{i}"):
            continue
        for channel in animation["channels"]:
            target = channel["target"]
            if "node" in target and target["path"] in ("translation", "rotation", "scale"):
                sampler = animation["samplers"][channel["sampler"]]
                first = 1 if sampler.get("interpolation") == "CUBICSPLINE" else 0
                node = nodes[target["node"]]
                node[target["path"]] = gltf.accessor(sampler["output"])[first]
                node.pop("matrix", None)
        break
    return nodes


def world_matrices(nodes):
    parent = {c: i for i, n in enumerate(nodes) for c in n.get("children", [])}
    worlds = {}

    def world(i):
        if i not in worlds:
            local = matrix_of(nodes[i])
            worlds[i] = multiply(world(parent[i]), local) if i in parent else local
        return worlds[i]

    return [world(i) for i in range(len(nodes))]


def morphed(gltf, node, mesh, primitive):
    positions = gltf.accessor(primitive["attributes"]["POSITION"])
    weights = node.get("weights", mesh.get("weights", []))
    for weight, target in zip(weights, primitive.get("targets", [])):
        if "POSITION" in target and weight:
            delta = gltf.accessor(target["POSITION"])
            positions = [tuple(p + weight * d for p, d in zip(a, b))
                         for a, b in zip(positions, delta)]
    return positions


def heights_of(matrix, positions):
    a, b, c, d = matrix[1], matrix[5], matrix[9], matrix[13]
    return [a * x + b * y + c * z + d for x, y, z in positions]


def skin_matrices(gltf, skin, worlds):
    joints = skin["joints"]
    binds = (gltf.accessor(skin["inverseBindMatrices"]) if "inverseBindMatrices" in skin
             else [IDENTITY] * len(joints))
    return [multiply(worlds[j], b) for j, b in zip(joints, binds)]


def skinned_heights(gltf, primitive, matrices, positions):
    attributes = primitive["attributes"]
    influences = [[] for _ in positions]
    for k in range(4):
        if f"JOINTS_{k}" not in attributes:
            break
        for i, (joints, weights) in enumerate(zip(gltf.accessor(attributes[f"JOINTS_{k}"]),
                                                  gltf.accessor(attributes[f"WEIGHTS_{k}"]))):
            influences[i].extend((j, w) for j, w in zip(joints, weights) if w > 0)
    heights = []
    for (x, y, z), list_ in zip(positions, influences):
        total = sum(w for _, w in list_)
        if total == 0:
            list_, total = [(0, 1.0)], 1.0
        height = 0.0
        for joint, weight in list_:
            m = matrices[joint]
            height += weight / total * (m[1] * x + m[5] * y + m[9] * z + m[13])
        heights.append(height)
    return heights


def height(gltf, clip):
    worlds = world_matrices(posed_nodes(gltf, clip))
    low, high = math.inf, -math.inf
    for node, index, mesh, primitive in drawn(gltf):
        positions = morphed(gltf, node, mesh, primitive)
        if "skin" in node and "JOINTS_0" in primitive["attributes"]:
            matrices = skin_matrices(gltf, gltf.items("skins")[node["skin"]], worlds)
            heights = skinned_heights(gltf, primitive, matrices, positions)
        else:
            heights = heights_of(worlds[index], positions)
        if "indices" in primitive:
            heights = [heights[i] for i in {i for (i,) in gltf.accessor(primitive["indices"])}]
        low = min([low, *heights])
        high = max([high, *heights])
    return max(high - low, 0.0)


def facts(path, clip):
    gltf = Gltf(path)
    compressed = any("KHR_draco_mesh_compression" in p.get("extensions", {})
                     for m in gltf.items("meshes") for p in m["primitives"])
    return {
        "triangles": sum(triangle_count(gltf, p) for _, _, _, p in drawn(gltf)),
        "slots": slot_names(gltf),
        "clips": clip_facts(gltf),
        "height": None if compressed else height(gltf, clip),
    }


def main():
    result = {}
    for line in sys.stdin:
        path, clip = line.rstrip("\n").split("\t")
        result[path] = facts(path, clip)
    json.dump(result, sys.stdout)


if __name__ == "__main__":
    main()
