# SPDX-License-Identifier: MIT
"""Builds the people under templates/, or those named after "--". Runs inside Blender."""
import os
import sys

import bpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import accessories
import wardrobe
from blender_mesh import make_mesh, split_by_material, vertex_openness
from body_mesh import build_body
from cast import today
from cast_antique import antique
from clips import foot_slide, make_clips
from person_file import PersonWriter
from skeleton import make_bones

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "templates")
LEVELS = 4
SMOOTH_DEGREES = 75
OCCLUSION = (.52, .52, .45, .20)  # blotchy on few vertices


def build_level(body, level):
    """(parts by slot, openness and weights by vertex, triangles)."""
    surface = build_body(body, level)
    slot = {name: i for i, name in enumerate(wardrobe.slots(body))}
    mesh = make_mesh(f"{body.name}{level}", surface.positions, [f.ids for f in surface.faces],
                     [slot[f.slot] for f in surface.faces], SMOOTH_DEGREES,
                     surface.all_sharp_edges())
    corner_uv = []
    for polygon, face in zip(mesh.polygons, surface.faces):
        uv = {i: (u, 1 - v) for i, (u, v) in zip(face.ids, face.uv)}
        corner_uv += [uv[mesh.loops[loop].vertex_index] for loop in polygon.loop_indices]
    openness = vertex_openness(mesh, 64, .40, OCCLUSION[level])
    return split_by_material(mesh, corner_uv, len(slot)), openness, surface.weights


def build_accessory(body, name, bones):
    """(name, joint, slot, is shown, mesh part per level)."""
    joint, parts = accessories.JOINT_OF[name], []
    for level in range(LEVELS):
        shape = accessories.build(name, body, bones[joint].head, level)
        mesh = make_mesh(f"{body.name}-{name}{level}", shape.vertices, shape.faces,
                         [0] * len(shape.faces), SMOOTH_DEGREES)
        no_values = [(0,)] * len(mesh.loops)
        parts.append(split_by_material(mesh, no_values, 1)[0])
    return name, joint, accessories.SLOT_OF[name], accessories.SHOWN[name], parts


def build_person(body):
    bones = make_bones(body)
    levels = [build_level(body, level) for level in range(LEVELS)]
    worn = [build_accessory(body, name, bones) for name in body.accessories]
    clips = make_clips(body, bones)
    path = os.path.normpath(os.path.join(TEMPLATES, body.name + ".glb"))
    PersonWriter(body, bones).write(levels, worn, clips, path)
    triangles = [sum(len(p.triangles) for p in level[0] if p) for level in levels]
    slides = {c.name: round(foot_slide(c, bones) * 1000, 2) for c in clips
              if c.extras["speed"] > 0}
    print(f"{path}: {os.path.getsize(path)} bytes, triangles {triangles}, "
          f"foot slide in mm {slides}")


if __name__ == "__main__":
    bpy.ops.wm.read_factory_settings(use_empty=True)
    chosen = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    for person in today() + antique():
        if not chosen or person.name in chosen:
            build_person(person)
