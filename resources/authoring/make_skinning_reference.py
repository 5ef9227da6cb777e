# SPDX-License-Identifier: MIT
"""Writes tests/data/skinning: the people as Blender deforms them, to test our own baking against.

Runs inside Blender. Every number comes from Blender's own importer, animation and armature
modifier; check_skinning.py compares it with an independent calculation."""
import json
import os
import sys

import bpy
import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
from clips import FRAMES_PER_SECOND
from geometry import to_gltf
from glb import read_glb

RESOURCES = os.path.join(HERE, "..")
TARGET = os.path.join(RESOURCES, "..", "tests", "data", "skinning")
SAMPLES = (("idle", 40), ("walk", 0), ("walk", 7), ("walk", 15), ("run", 3), ("sit", 10),
           ("sit_clap", 9), ("sit_cheer", 5), ("sit_cheer", 20), ("cheer", 12))


def import_person(name):
    """(armature, level 0 object, action by clip name) in an empty scene at 32 frames a second."""
    np.bool = bool  # the importer of Blender 3.4 uses the name that NumPy dropped
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = FRAMES_PER_SECOND
    bpy.ops.import_scene.gltf(filepath=os.path.join(RESOURCES, "templates", name + ".glb"))
    armature = next(o for o in bpy.data.objects if o.type == "ARMATURE")
    document, _ = read_glb(os.path.join(RESOURCES, "templates", name + ".glb"))
    triangles = {}
    for item in bpy.data.objects:
        if item.type == "MESH":
            item.data.calc_loop_triangles()
            triangles[len(item.data.loop_triangles)] = item
    for track in list(armature.animation_data.nla_tracks):
        armature.animation_data.nla_tracks.remove(track)
    suffix = "_" + armature.name
    actions = {action.name[:-len(suffix)] if action.name.endswith(suffix) else action.name: action
               for action in bpy.data.actions}
    return armature, triangles[max(triangles)], actions, document


def deformed_vertices(armature, item, action, frame):
    for bone in armature.pose.bones:
        bone.matrix_basis.identity()  # bones that the clip leaves alone rest
    armature.animation_data.action = action
    bpy.context.scene.frame_set(frame)
    evaluated = item.evaluated_get(bpy.context.evaluated_depsgraph_get())
    vertices = np.empty(len(evaluated.data.vertices) * 3)
    evaluated.data.vertices.foreach_get("co", vertices)
    world = np.array(evaluated.matrix_world)
    return to_gltf(vertices.reshape(-1, 3) @ world[:3, :3].T + world[:3, 3])


def write_reference(name):
    armature, item, actions, document = import_person(name)
    node = next(n for n in document["nodes"] if n.get("name") == name and "mesh" in n)
    counts = [document["accessors"][p["attributes"]["POSITION"]]["count"]
              for p in document["meshes"][node["mesh"]]["primitives"]]
    samples, binary = [], b""
    for clip, keyframe in SAMPLES:
        positions = deformed_vertices(armature, item, actions[clip], keyframe)
        if len(positions) != sum(counts):
            raise RuntimeError(f"{name}: Blender has {len(positions)} vertices, the file "
                               f"{sum(counts)}")
        samples.append({"clip": clip, "keyframe": keyframe, "byteOffset": len(binary)})
        binary += positions.astype("<f4").tobytes()
    header = {"template": f"builtin:templates/{name}.glb", "binary": name + ".bin",
              "framesPerSecond": FRAMES_PER_SECOND, "primitiveVertexCounts": counts,
              "samples": samples}
    with open(os.path.join(TARGET, name + ".json"), "w", encoding="utf-8") as file:
        json.dump(header, file, indent=1)
        file.write("\n")
    with open(os.path.join(TARGET, name + ".bin"), "wb") as file:
        file.write(binary)
    print(f"{name}: {len(samples)} samples of {sum(counts)} vertices")


if __name__ == "__main__":
    os.makedirs(TARGET, exist_ok=True)
    for person in ("man", "woman"):
        write_reference(person)
