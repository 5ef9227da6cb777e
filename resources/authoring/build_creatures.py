#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Builds the dog, the horse, the beetle, the helicopter and the forklift (no Blender)."""
import os

from creature_file import LEVELS, CreatureWriter, Shape
from geometry import rot_y, rot_z, vec
from machines import forklift, helicopter
from quadrupeds import EYES, dog, foot_path, horse, sine

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "templates")
BEETLE_SIZE = .03  # metres from which the beetle's measures count: as long as a thumb
LEG_ROWS = (-.62, -.05, .60)


def beetle_bones():
    """(bones, legs as (name, sign, y, shift)); three legs move in turn with the other three."""
    s = BEETLE_SIZE
    bones = {"root": ("", vec(0, 0, 0)), "body": ("root", vec(0, 0, .62) * s),
             "head": ("body", vec(0, -1.0, .62) * s)}
    legs = []
    for k, y in enumerate(LEG_ROWS):
        for side, sign in (("L", 1), ("R", -1)):
            name = f"leg{k}_{side}"
            bones[name] = "body", vec(.42 * sign, y, .50) * s
            bones[f"leg{k}_foot_{side}"] = name, leg_points(sign, y)[-1] * s
            legs.append((name, sign, y, ((k + (sign > 0)) % 2) / 2))
    return bones, legs


def leg_points(sign, y):
    """Root, knee, ankle and foot: the front legs reach forward, the hind ones back."""
    return (vec(sign * .36, y, .50), vec(sign * .86, y * 1.30, .84),
            vec(sign * 1.12, y * 1.65, .16), vec(sign * 1.30, y * 1.85, .0))


def beetle_shape(level, legs):
    shape, s = Shape(level), BEETLE_SIZE
    oval = lambda y, z, w, h, bone: (vec(0, y, z) * s, w * s, h * s, {bone: 1})
    # Two wing cases with a seam between them, each its own half oval.
    shape.tube([oval(1.46, .56, .10, .06, "body"), oval(1.30, .60, .40, .24, "body"),
                oval(1.00, .64, .60, .36, "body"), oval(.60, .68, .70, .43, "body"),
                oval(.15, .69, .71, .44, "body"), oval(-.06, .69, .69, .42, "body"),
                oval(-.20, .67, .63, .38, "body"),
                oval(-.30, .64, .50, .28, "body")], 14, "shell")
    shape.tube([oval(1.40, .80, .012, .03, "body"), oval(.9, 1.02, .016, .03, "body"),
                oval(.3, 1.13, .018, .03, "body"), oval(-.2, 1.07, .016, .03, "body")], 4,
               "thorax", until=1)
    shape.tube([oval(-.22, .64, .50, .30, "body"), oval(-.40, .66, .58, .35, "body"),
                oval(-.66, .65, .55, .33, "body"), oval(-.88, .61, .40, .24, "body"),
                oval(-.94, .59, .26, .16, "body")], 12, "thorax")
    shape.tube([oval(-.86, .59, .24, .16, "head"), oval(-1.00, .58, .33, .21, "head"),
                oval(-1.20, .56, .30, .18, "head"), oval(-1.34, .53, .15, .10, "head")], 9,
               "thorax")
    for sign in (-1, 1):
        _add_face(shape, sign)
    for name, sign, y, _ in legs:
        root, knee, ankle, foot = (p * s for p in leg_points(sign, y))
        if level == 3:
            shape.tube([(foot, .03 * s, .03 * s, {name: 1}), (root, .09 * s, .09 * s, {name: 1})],
                       3, "leg", upright=True)
            continue
        for a, b, thick, thin, until in ((root, knee, .085, .065, 4), (knee, ankle, .062, .038, 4),
                                         (ankle, foot, .036, .026, 1)):
            low, high = (a, b) if a[2] < b[2] else (b, a)
            first, second = (thick, thin) if low is a else (thin, thick)
            shape.tube([(low, first * s, first * s, {name: 1}),
                        (high, second * s, second * s, {name: 1})], 6, "leg", upright=True,
                       until=until)
    return shape


def _add_face(shape, sign):
    """Mandible, feeler and eye of one side."""
    s, only = BEETLE_SIZE, {"head": 1}
    horn = [(vec(.13 * sign, -1.26, .53), .065), (vec(.29 * sign, -1.46, .56), .06),
            (vec(.31 * sign, -1.66, .61), .048), (vec(.24 * sign, -1.84, .66), .032),
            (vec(.10 * sign, -1.96, .70), .008)]
    shape.tube([(p * s, r * s, r * s, only) for p, r in horn][::-1], 5, "leg", until=2)
    feeler = [(vec(.24 * sign, -1.20, .66), .022), (vec(.52 * sign, -1.42, .82), .020),
              (vec(.74 * sign, -1.66, .80), .020), (vec(.84 * sign, -1.82, .76), .034)]
    shape.tube([(p * s, r * s, r * s, only) for p, r in feeler][::-1], 4, "leg", until=2)
    eye = vec(.28 * sign, -1.08, .63)
    shape.tube([((eye + vec(0, 0, d)) * s, r * s, r * s, only)
                for d, r in ((-.07, .04), (0, .085), (.07, .04))], 6, "eyes", upright=True, until=2)


def beetle():
    bones, legs = beetle_bones()
    shapes = [beetle_shape(level, legs) for level in range(LEVELS)]
    writer = CreatureWriter("beetle", {
        "shell": (("", (58, 84, 62)), ("Shell brown", (96, 56, 36)), ("Shell blue", (44, 62, 104)),
                  ("Shell red", (150, 40, 32))),
        "thorax": (("", (44, 46, 42)),), "leg": (("", (38, 32, 28)),), "eyes": EYES}, bones)
    node, s = writer.skin(shapes), BEETLE_SIZE

    def crawl(phase, stride, lift):
        """A leg slides under the body and lifts its foot; on the ground it only moves back."""
        pose = {"body": (vec(0, 0, 0), rot_z(1.5 * sine(phase)) if not stride else rot_z(0)),
                "head": (None, rot_z(6 * sine(phase, 1)))}
        for name, sign, _, shift in legs:
            y, z, _ = foot_path((phase + shift) % 1, stride, .5, 1.0)
            pose[name] = vec(0, y, 0) * s, rot_y(-sign * lift * z)
        return pose
    writer.clip("idle", 96, lambda p: crawl(p, 0, 0))
    for name, frames, stride, lift in (("walk", 10, .50, 13), ("run", 6, .74, 16)):
        writer.clip(name, frames, lambda p: crawl(p, stride, lift),
                    stride * s / (frames / 32 * .5))
    return writer, node, shapes


def build(name, made):
    writer, node, levels = made
    path = os.path.normpath(os.path.join(TEMPLATES, name + ".glb"))
    writer.write(path, [] if node is None else [node])
    counts = [len(getattr(level, "faces", level)) for level in levels]
    print(f"{path}: {os.path.getsize(path)} bytes, triangles {counts}")


if __name__ == "__main__":
    for creature in (dog, horse, beetle, helicopter, forklift):
        build(creature.__name__, creature())
