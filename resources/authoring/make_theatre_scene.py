#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes scenes/theatre.crowd: an audience in the theatre, with the two middle wedges empty.

Plain Python: reads the built-in .glb files next to it, needs no Blender. The same bytes each run.
"""
import json
import math
import os
import random

import numpy as np

from glb import read_glb

RESOURCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
STAGE_ID = 1
EMPTY_WEDGES = (4, 5)
OCCUPANCY = .955
LIGHT = {"sunAzimuth": .95, "sunElevation": .72, "sunColor": [1.0, .95, .84], "sunStrength": 1.1,
         "ambientColor": [.70, .74, .84], "ambientStrength": .62,
         "skyZenith": [.28, .50, .80], "skyHorizon": [.86, .90, .93],
         "ground": [.70, .64, .48], "groundGrid": False}
COLUMNS = ["id", "template", "position", "heading", "height", "girth", "tint1", "tint2", "tint3",
           "tint4", "choices", "clip", "phase", "speed", "seat", "seed"]

# Calm clothes, then the few that stand out. 0..255 sRGB, they multiply a light cloth.
CALM_TOPS = [(238, 234, 224), (208, 214, 220), (176, 190, 204), (126, 150, 178), (94, 112, 138),
             (196, 184, 164), (164, 176, 156), (128, 144, 122), (206, 190, 180), (150, 136, 128),
             (112, 108, 112), (78, 82, 94), (216, 206, 182), (170, 160, 178)]
ACCENT_TOPS = [(206, 84, 66), (236, 184, 88), (56, 126, 146), (190, 104, 124), (84, 140, 96),
               (246, 240, 228), (92, 128, 190), (222, 132, 76)]
BOTTOMS = [(196, 186, 168), (150, 140, 126), (112, 112, 118), (92, 100, 120), (134, 124, 104),
           (220, 214, 202)]
SHOES = [(150, 126, 104), (110, 100, 96), (226, 222, 214)]
HAIR_CHOICES = [(0, 34), (1, 26), (2, 10), (3, 10), (4, 14)]  # brown black blond auburn grey
SKIN_CHOICES = [(0, 30), (1, 26), (2, 20), (3, 14), (4, 10)]


def template_entry(identifier, name):
    document, _ = read_glb(os.path.join(RESOURCES, "templates", name + ".glb"))
    return {"id": identifier, "name": name, "path": f"builtin:templates/{name}.glb",
            "clips": [clip["name"] for clip in document["animations"]]}


def stage_seats():
    document, _ = read_glb(os.path.join(RESOURCES, "stages", "theatre.glb"))
    return document["scenes"][document["scene"]]["extras"]["seats"]


class Mood:
    """Smooth waves of excitement over the audience: 0 calm, 1 cheering."""

    def __init__(self, rng):
        self.waves = [(rng.uniform(-.55, .55), rng.uniform(-.55, .55), rng.uniform(0, 6.28))
                      for _ in range(5)]

    def at(self, position):
        x, _, z = position
        total = sum(math.sin(a * x + b * z + c) for a, b, c in self.waves)
        return .5 + total / 7


def choose_clip(excitement, rng):
    value = excitement + rng.gauss(0, .12)
    return "sit_cheer" if value > .86 else "sit_clap" if value > .60 else "sit"


def weighted(choices, rng):
    values, weights = zip(*choices)
    return rng.choices(values, weights)[0]


def tint(rgb, rng, strength=255):
    vary = rng.uniform(.94, 1.04)
    return "#" + "".join(f"{min(255, round(c * vary)):02x}" for c in rgb) + f"{strength:02x}"


def clothing(rng):
    """(tints of hair, top, bottom and shoes, choices as text)."""
    skin, hair = weighted(SKIN_CHOICES, rng), weighted(HAIR_CHOICES, rng)
    if skin >= 3:
        hair = rng.choice((0, 1, 1, 1, 4))
    top = rng.choice(ACCENT_TOPS if rng.random() < .30 else CALM_TOPS)
    trousers = rng.choices((0, 1, 2), (55, 25, 20))[0]
    choices = [skin, hair, 1 if rng.random() < .10 else 0, trousers,
               1 if rng.random() < .45 else 0, 0, 0, 0]
    bottom = rng.choice(BOTTOMS) if trousers == 0 else (255, 255, 255)
    shoes = rng.choice(SHOES) if choices[4] == 0 else (255, 255, 255)
    tints = [tint((255, 250, 244), rng), tint(top, rng), tint(bottom, rng), tint(shoes, rng)]
    return tints, "".join(f"{choice:02x}" for choice in choices)


def rounded(value, digits=4):
    return round(float(value), digits)


def individual(identifier, index, seat, clips, mood, rng):
    is_woman = rng.random() < .5
    tints, choices = clothing(rng)
    clip = choose_clip(mood.at(seat["position"]), rng)
    height = min(1.04, max(.98, rng.gauss(1.008, .018)))  # soles stay near the floor
    return [identifier, 2 if is_woman else 1, seat["position"],
            rounded(seat["headingRadians"] + rng.gauss(0, .07)), rounded(height),
            rounded(min(1.10, max(.93, height * rng.gauss(1.0, .035)))), *tints, choices,
            clips.index(clip), rounded(rng.random()), rounded(rng.uniform(.88, 1.12)),
            STAGE_ID << 24 | index, rng.randrange(1 << 32)]


def camera(name, position, target, field_degrees):
    """A camera looks along its -Z; the orientation is x, y, z, w."""
    position, target = np.array(position, float), np.array(target, float)
    back = position - target
    yaw = math.atan2(back[0], back[2])
    pitch = -math.atan2(back[1], math.hypot(back[0], back[2]))
    cy, sy, cp, sp = (math.cos(yaw / 2), math.sin(yaw / 2), math.cos(pitch / 2),
                      math.sin(pitch / 2))
    return {"name": name, "position": [rounded(x) for x in position],
            "orientation": [rounded(x, 7) for x in (cy * sp, sy * cp, -sy * sp, cy * cp)],
            "orthographic": False, "fovY": rounded(math.radians(field_degrees)),
            "orthographicHeight": 20.0, "pivotDistance": rounded(np.linalg.norm(back))}


CAMERAS = [
    camera("Audience", (7.5, 5.6, 2.0), (-2.6, 2.6, -12.5), 42),
    camera("From the stage", (-4.0, 3.0, 8.6), (2.5, 2.6, -12), 48),
    camera("Whole theatre", (34, 24, 14), (0, .5, -3), 40),
    camera("Back row", (3.5, 7.6, -20.2), (-.5, 3.2, 10), 50),
    camera("Close", (-6.0, 2.3, -4.2), (-10.2, 1.6, -9.2), 42),
]


def write_scene(path):
    rng = random.Random(2026)
    mood = Mood(rng)
    templates = [template_entry(1, "man"), template_entry(2, "woman")]
    rows = []
    for index, seat in enumerate(stage_seats()):
        if seat["wedge"] in EMPTY_WEDGES or rng.random() > OCCUPANCY:
            continue
        rows.append(individual(len(rows) + 1, index, seat, templates[0]["clips"], mood, rng))
    stage = {"id": STAGE_ID, "name": "theatre", "path": "builtin:stages/theatre.glb",
             "position": [0.0, 0.0, 0.0], "heading": 0.0, "scale": 1.0}
    compact = lambda value: json.dumps(value, separators=(",", ":"), sort_keys=True)
    lines = lambda items: "[\n" + ",\n".join(compact(item) for item in items) + "\n]"
    with open(path, "w", encoding="utf-8") as file:
        file.write('{\n"format": "crowdbrush-scene",\n"version": 1,\n"name": "Theatre",\n'
                   f'"seed": 1,\n"nextId": {len(rows) + 1},\n'
                   f'"templates": {lines(templates)},\n"stages": {lines([stage])},\n'
                   f'"cameras": {lines(CAMERAS)},\n"lighting": {compact(LIGHT)},\n'
                   '"individuals": {\n'
                   f'"columns": {compact(COLUMNS)},\n"rows": {lines(rows)}}}\n}}\n')
    print(f"{os.path.normpath(path)}: {len(rows)} people")


if __name__ == "__main__":
    write_scene(os.path.join(RESOURCES, "scenes", "theatre.crowd"))
