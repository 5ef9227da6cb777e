# SPDX-License-Identifier: MIT
"""Builds stages/theatre.glb. Runs inside Blender."""
import os
import sys

import bpy
import numpy as np
from mathutils import Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import theatre_buildings as buildings
from blender_mesh import make_mesh, openness, split_by_material
from geometry import srgb_to_linear
from glb import INDICES, GlbWriter, vertex_attributes
from gloss import gloss_of
from stage_surface import MATERIALS, ROUNDED, StageSurface
from theatre_seating import add_seating

STAGES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "stages")


def build_surface():
    surface = StageSurface(seed=7)
    seats = add_seating(surface)
    buildings.add_ground(surface)
    buildings.add_outer_wall(surface)
    buildings.add_stage_building(surface)
    buildings.add_wings(surface)
    buildings.add_trees(surface)
    buildings.add_hills(surface)
    buildings.add_banners(surface)
    return surface, seats


def corner_values(mesh, surface):
    """Per loop: the tone of its face."""
    return [(tone,) for polygon, tone in zip(mesh.polygons, surface.tones)
            for _ in polygon.loop_indices]


def shading(mesh, part):
    """Tone times openness; the normals are turned back from glTF's frame."""
    points = [(mesh.vertices[source].co, Vector((n[0], -n[2], n[1])))
              for source, n in zip(part.source, part.normals)]
    light = openness(mesh, points, 40, 3.0, .75) * part.values[:, 0]
    return np.stack([light, light, light, np.ones_like(light)], 1)


def write(surface, seats, path):
    smooth = [name in ROUNDED for name in MATERIALS]
    mesh = make_mesh("theatre", surface.vertices, surface.faces, surface.materials, 40,
                     smooth=smooth)
    glb = GlbWriter()
    primitives = []
    parts = split_by_material(mesh, corner_values(mesh, surface), len(MATERIALS))
    for (name, rgb), part in zip(MATERIALS.items(), parts):
        attributes = vertex_attributes(glb, part.positions, part.normals, shading(mesh, part))
        primitives.append({"attributes": attributes, "material": glb.add("materials", {
            "name": name, "pbrMetallicRoughness": {
                "baseColorFactor": [round(c, 4) for c in srgb_to_linear(rgb)] + [1.0],
                **gloss_of("theatre", name)}}),
            "indices": glb.accessor(part.triangles.reshape(-1).astype(np.uint16), "SCALAR",
                                    INDICES)})
    glb.add("meshes", {"name": "theatre", "primitives": primitives})
    glb.add("nodes", {"name": "theatre", "mesh": 0})
    glb.add("scenes", {"name": "theatre", "nodes": [0], "extras": {"seats": seats}})
    glb.write(path)


if __name__ == "__main__":
    bpy.ops.wm.read_factory_settings(use_empty=True)
    theatre, places = build_surface()
    target = os.path.normpath(os.path.join(STAGES, "theatre.glb"))
    write(theatre, places, target)
    print(f"{target}: {os.path.getsize(target)} bytes, {theatre.triangle_count()} triangles, "
          f"{len(places)} seats")
