#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Compares tests/data/skinning with skinning calculated here from the .glb alone (plain NumPy).

Exits with 1 when any vertex differs by more than a tenth of a millimetre."""
import json
import os
import sys

import numpy as np

from glb import accessor_values, read_glb

HERE = os.path.dirname(os.path.abspath(__file__))
REFERENCE = os.path.join(HERE, "..", "..", "tests", "data", "skinning")
TOLERANCE = 1e-4


def slerp(a, b, t):
    cosine = float(np.dot(a, b))
    if cosine < 0:
        b, cosine = -b, -cosine
    if cosine > .9999995:
        result = a + (b - a) * t
    else:
        angle = np.arccos(cosine)
        result = (np.sin((1 - t) * angle) * a + np.sin(t * angle) * b) / np.sin(angle)
    return result / np.linalg.norm(result)


def matrix(translation, q):
    x, y, z, w = q
    result = np.eye(4)
    result[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    result[:3, 3] = translation
    return result


def node_matrices(document, binary, clip, seconds):
    """Global matrix per node with the clip applied."""
    nodes = document["nodes"]
    local = [[np.array(n.get("translation", (0, 0, 0)), float),
              np.array(n.get("rotation", (0, 0, 0, 1)), float)] for n in nodes]
    animation = next(a for a in document["animations"] if a["name"] == clip)
    for channel in animation["channels"]:
        sampler = animation["samplers"][channel["sampler"]]
        times = accessor_values(document, binary, sampler["input"])[:, 0]
        values = accessor_values(document, binary, sampler["output"]).astype(float)
        i = min(max(int(np.searchsorted(times, seconds, "right")) - 1, 0), len(times) - 2)
        t = min(max((seconds - times[i]) / (times[i + 1] - times[i]), 0), 1)
        target = channel["target"]
        if target["path"] == "translation":
            local[target["node"]][0] = values[i] + (values[i + 1] - values[i]) * t
        else:
            a, b = (v / np.linalg.norm(v) for v in values[i:i + 2])
            local[target["node"]][1] = slerp(a, b, t)
    parent = {child: i for i, n in enumerate(nodes) for child in n.get("children", ())}
    globals_ = {}

    def world(i):
        if i not in globals_:
            own = matrix(*local[i])
            globals_[i] = world(parent[i]) @ own if i in parent else own
        return globals_[i]
    return [world(i) for i in range(len(nodes))]


def skinned(document, binary, node, clip, seconds):
    """Level 0 positions, primitive after primitive."""
    skin = document["skins"][node["skin"]]
    inverse = accessor_values(document, binary, skin["inverseBindMatrices"])
    inverse = inverse.reshape(-1, 4, 4).transpose(0, 2, 1)
    world = node_matrices(document, binary, clip, seconds)
    palette = np.array([world[j] @ inverse[i] for i, j in enumerate(skin["joints"])])
    result = []
    for primitive in document["meshes"][node["mesh"]]["primitives"]:
        values = {k: accessor_values(document, binary, i)
                  for k, i in primitive["attributes"].items()}
        weights = values["WEIGHTS_0"] / values["WEIGHTS_0"].sum(1, keepdims=True)
        blended = np.einsum("vk,vkij->vij", weights, palette[values["JOINTS_0"]])
        points = np.concatenate([values["POSITION"], np.ones((len(weights), 1))], 1)
        result.append(np.einsum("vij,vj->vi", blended, points)[:, :3])
    return np.concatenate(result)


def largest_difference(name):
    with open(os.path.join(REFERENCE, name + ".json"), encoding="utf-8") as file:
        header = json.load(file)
    document, binary = read_glb(os.path.join(HERE, "..", "templates", name + ".glb"))
    node = next(n for n in document["nodes"] if n.get("name") == name and "mesh" in n)
    count = sum(header["primitiveVertexCounts"])
    worst = 0.0
    for sample in header["samples"]:
        with open(os.path.join(REFERENCE, header["binary"]), "rb") as file:
            file.seek(sample["byteOffset"])
            stored = np.frombuffer(file.read(count * 12), "<f4").reshape(-1, 3)
        seconds = sample["keyframe"] / header["framesPerSecond"]
        ours = skinned(document, binary, node, sample["clip"], seconds)
        worst = max(worst, float(np.abs(ours - stored).max()))
    return worst


if __name__ == "__main__":
    differences = {name: largest_difference(name) for name in ("man", "woman")}
    for name, worst in differences.items():
        print(f"{name}: largest difference {worst * 1000:.4f} mm")
    sys.exit(any(worst > TOLERANCE for worst in differences.values()))
