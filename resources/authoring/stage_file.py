# SPDX-License-Identifier: MIT
"""Writes a stage with flat faces (no Blender): a primitive per material, tones as colours."""
import os

import numpy as np

from geometry import srgb_to_linear, to_gltf
from glb import INDICES, GlbWriter, vertex_attributes
from gloss import gloss_of

STAGES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "stages")


def write_stage(surface, name, seats=(), smooth=()):
    """smooth: materials whose faces share normals."""
    points, glb, primitives = np.array(surface.vertices, float), GlbWriter(), []
    for index, (material, rgb) in enumerate(surface.palette.items()):
        own = [k for k, m in enumerate(surface.materials) if m == index]
        if not own:
            continue
        positions, normals, tones, triangles = _corners(surface, points, own)
        if material in smooth:
            normals = _shared(positions, normals)
        colors = np.stack([tones, tones, tones, np.ones_like(tones)], 1)
        attributes = vertex_attributes(glb, to_gltf(positions), to_gltf(normals), colors)
        primitives.append({"attributes": attributes, "material": glb.add("materials", {
            "name": material, "pbrMetallicRoughness": {
                "baseColorFactor": [round(c, 4) for c in srgb_to_linear(rgb)] + [1.0],
                **gloss_of(name, material)}}),
            "indices": glb.accessor(triangles.reshape(-1).astype(np.uint32), "SCALAR", INDICES)})
    glb.add("meshes", {"name": name, "primitives": primitives})
    glb.add("nodes", {"name": name, "mesh": 0})
    glb.add("scenes", {"name": name, "nodes": [0], "extras": {"seats": list(seats)}})
    path = os.path.normpath(os.path.join(STAGES, name + ".glb"))
    glb.write(path)
    print(f"{path}: {os.path.getsize(path)} bytes, {surface.triangle_count()} triangles, "
          f"{len(seats)} seats")


def _corners(surface, points, faces):
    positions, normals, tones, triangles = [], [], [], []
    for k in faces:
        ids, first = surface.faces[k], len(positions)
        corner = points[list(ids)]
        normal = np.cross(corner[1] - corner[0], corner[-1] - corner[0])
        normal = normal / max(np.linalg.norm(normal), 1e-12)
        positions += list(corner)
        normals += [normal] * len(ids)
        tones += [min(1.0, surface.tones[k] * .95)] * len(ids)
        triangles += [(first, first + i, first + i + 1) for i in range(1, len(ids) - 1)]
    return np.array(positions), np.array(normals), np.array(tones), np.array(triangles)


def _shared(positions, normals):
    sums = {}
    keys = [tuple(np.round(p, 3)) for p in positions]
    for key, normal in zip(keys, normals):
        sums[key] = sums.get(key, 0) + normal
    return np.array([sums[k] / max(np.linalg.norm(sums[k]), 1e-12) for k in keys])
