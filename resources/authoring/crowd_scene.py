# SPDX-License-Identifier: MIT
"""What the ready-made scenes share: templates, clothes, cameras, groups, and the .crowd file.

Plain Python: reads the built-in .glb files, needs no Blender. The same bytes each run."""
import json
import math
import os
from collections import deque

import numpy as np

from glb import read_glb

RESOURCES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
STAGE_ID = 1
COLUMNS = ["id", "template", "position", "heading", "height", "girth", "tint0", "tint1", "tint2",
           "tint3", "tint4", "tint5", "choices", "parts", "clip", "phase", "speed", "seat", "seed"]
WHITE = (255, 255, 255)
NO_SEAT = 4294967295

# 0..255 sRGB; they multiply a light cloth.
CALM = [(238, 234, 224), (208, 214, 220), (176, 190, 204), (126, 150, 178), (94, 112, 138),
        (196, 184, 164), (164, 176, 156), (128, 144, 122), (206, 190, 180), (150, 136, 128),
        (112, 108, 112), (78, 82, 94), (216, 206, 182), (170, 160, 178)]
ACCENTS = [(206, 84, 66), (236, 184, 88), (56, 126, 146), (190, 104, 124), (84, 140, 96),
           (246, 240, 228), (92, 128, 190), (222, 132, 76)]
BOTTOMS = [(196, 186, 168), (150, 140, 126), (112, 112, 118), (92, 100, 120), (134, 124, 104),
           (220, 214, 202)]
SHOES = [(150, 126, 104), (110, 100, 96), (226, 222, 214)]
TODAY = {"top": (CALM, ACCENTS, .30), "bottom": (BOTTOMS, BOTTOMS, 0), "shoes": (SHOES, SHOES, 0),
         "bag": (ACCENTS, CALM, .5), "scarf": (ACCENTS, CALM, .4), "hat": (CALM, ACCENTS, .2)}
UNDYED = [(255, 250, 238), (240, 228, 204), (226, 208, 178), (206, 184, 150), (214, 204, 190)]
DYES = [(206, 132, 92), (222, 176, 96), (150, 158, 108), (136, 154, 172), (178, 104, 92),
        (192, 150, 160), (160, 120, 92)]
ANTIQUE = {"top": (UNDYED, DYES, .42), "shoes": (SHOES, SHOES, 0), "cloak": (UNDYED, DYES, .6),
           "scarf": (DYES, UNDYED, .4), "hat": (UNDYED, DYES, .2)}
SKINS = ((0, 30), (1, 26), (2, 20), (3, 14), (4, 10))
RED_ROBE_CHOICE, RED_ROBE = 2, (185, 80, 71)  # the look of a robe, and the tint of a veil like it
FEWEST_DIFFERENCES, ALIKE_COLOURS, MOST_TRIES = 3, 36, 24
HAIRS = ((0, 34), (1, 26), (2, 10), (3, 10), (4, 14))  # own, black, blond, auburn, grey


def rounded(value, digits=4):
    return round(float(value), digits)


def weighted(choices, rng):
    values, weights = zip(*choices)
    return rng.choices(values, weights)[0]


def tint(rgb, rng, strength=255):
    vary = rng.uniform(.94, 1.04)
    return "#" + "".join(f"{min(255, round(c * vary)):02x}" for c in rgb) + f"{strength:02x}"


class Actor:
    """A built-in template as the scenes use it."""

    def __init__(self, identifier, name):
        self.identifier, self.name = identifier, name
        self.document, _ = read_glb(os.path.join(RESOURCES, "templates", name + ".glb"))
        self.clips = [clip["name"] for clip in self.document["animations"]]
        self.slots, self.parts = [], []
        nodes, materials = self.document["nodes"], self.document["materials"]
        coarser = {i for n in nodes for i in n.get("extensions", {}).get("MSFT_lod", {})
                   .get("ids", ())}
        fine = [n for i, n in enumerate(nodes) if "mesh" in n and i not in coarser]
        for node in sorted(fine, key=lambda n: "skin" not in n):
            for primitive in self.document["meshes"][node["mesh"]]["primitives"]:
                slot = materials[primitive["material"]]["extras"]["slot"]
                if slot not in self.slots:
                    self.slots.append(slot)
            if "shown" in node.get("extras", {}):
                self.parts.append(node["extras"]["shown"])
        self.looks = {slot: sum(m["extras"]["slot"] == slot for m in materials)
                      for slot in self.slots}
        self.worn = deque(maxlen=40)
        self.is_old = name in ("old_man", "old_woman", "priest")

    def entry(self):
        return {"id": self.identifier, "name": self.name,
                "path": f"builtin:templates/{self.name}.glb", "clips": self.clips}

    def dress(self, rng, palette=TODAY, top=None):
        """(tints of six slots, choices, parts) at random; top fixes the colour of the top."""
        tints, choices = [], [0] * 8
        skin = weighted(SKINS, rng)
        for i in range(6):
            slot = self.slots[i] if i < len(self.slots) else ""
            if slot == "skin":
                choices[i] = skin
            if slot == "hair" and not self.is_old:
                choices[i] = weighted(HAIRS, rng) if skin < 3 else rng.choice((0, 1, 1, 1, 4))
            rgb = WHITE
            if slot in palette and not (slot == "cloak" and self.name == "priest"):
                often, seldom, share = palette[slot]
                rgb = rng.choice(seldom if rng.random() < share else often)
                if self.looks[slot] > 1 and rng.random() < .42 and not (top and slot == "top"):
                    choices[i] = rng.randrange(1, self.looks[slot])
                    rgb = WHITE if slot == "bottom" else tuple(c + (255 - c) * .55 for c in rgb)
            if slot == "cloak" and self.name == "priest":  # it is drawn from his robe
                rgb = RED_ROBE if choices[top_slot] == RED_ROBE_CHOICE else robe
            elif slot not in ("skin", "hair", "", *palette) and self.looks[slot] > 1:
                choices[i] = rng.randrange(self.looks[slot])
            if slot == "top":
                rgb = top or rgb
                robe, top_slot = rgb, i
            tints.append(tint(rgb, rng))
        shown = sum(1 << k for k, usual in enumerate(self.parts)
                    if rng.random() < (.8 if usual else .35))
        return tints, "".join(f"{c:02x}" for c in choices), shown

    def fresh_dress(self, rng, palette, top=None):
        """A dress that cannot be taken for one of the last that this was asked for."""
        for _ in range(MOST_TRIES):
            dress = self.dress(rng, palette, top)
            if not any(self._are_alike(dress, other) for other in self.worn):
                break
        self.worn.append(dress)
        return dress

    def _are_alike(self, first, second):
        """The top, which one sees first, counts twice; shoes do not."""
        differing = first[2] != second[2]
        for i, slot in enumerate(self.slots[:6]):
            colours = ([int(tints[i][k:k + 2], 16) for k in (1, 3, 5)]
                       for tints in (first[0], second[0]))
            look = slice(2 * i, 2 * i + 2)
            if slot != "shoes" and (first[1][look] != second[1][look] or max(
                    abs(a - b) for a, b in zip(*colours)) > ALIKE_COLOURS):
                differing += 2 if slot == "top" else 1
        return differing < FEWEST_DIFFERENCES


class Crowd:
    """Collects the rows of a scene."""

    def __init__(self, names, rng):
        self.actors = {name: Actor(i + 1, name) for i, name in enumerate(names)}
        self.rng, self.rows = rng, []

    def add(self, name, position, heading, clip, seat=NO_SEAT, palette=TODAY, top=None, speed=None,
            size=1.0, phase=None):
        rng, actor = self.rng, self.actors[name]
        tints, choices, parts = actor.fresh_dress(rng, palette, top)
        height = size * min(1.05, max(.96, rng.gauss(1.0, .022)))
        girth = min(1.12, max(.92, rng.gauss(1.0, .040))) * height
        self.rows.append([
            len(self.rows) + 1, actor.identifier, [rounded(x) for x in position], rounded(heading),
            rounded(height), rounded(girth), *tints, choices, parts, actor.clips.index(clip),
            rounded(rng.random() if phase is None else phase),
            rounded(rng.uniform(.88, 1.12) if speed is None else speed), seat,
            rng.randrange(1 << 32)])

    def group(self, names, centre, clips, radius=.62, ground=lambda x, z: 0.0, turn=0.0):
        """People in a ring who look at each other."""
        for i, name in enumerate(names):
            angle = turn + 2 * math.pi * (i + self.rng.uniform(-.12, .12)) / len(names)
            own = radius * self.rng.uniform(.9, 1.15) * (1 + .09 * max(0, len(names) - 3))
            x, z = centre[0] + own * math.sin(angle), centre[1] + own * math.cos(angle)
            self.add(name, (x, ground(x, z), z), angle + math.pi + self.rng.gauss(0, .12),
                     self.rng.choice(clips))

    def write(self, file_name, title, stage, cameras, light, lamps=()):
        stage_entry = {"id": STAGE_ID, "name": stage, "path": f"builtin:stages/{stage}.glb",
                       "position": [0.0, 0.0, 0.0], "heading": 0.0, "scale": 1.0}
        compact = lambda value: json.dumps(value, separators=(",", ":"), sort_keys=True)
        lines = lambda items: "[\n" + ",\n".join(compact(item) for item in items) + "\n]"
        templates = [actor.entry() for actor in self.actors.values()]
        path = os.path.join(RESOURCES, "scenes", file_name)
        with open(path, "w", encoding="utf-8") as file:
            file.write('{\n"format": "crowdbrush-scene",\n"version": 1,\n'
                       f'"name": {compact(title)},\n"seed": 1,\n"nextId": {len(self.rows) + 1},\n'
                       f'"templates": {lines(templates)},\n"stages": {lines([stage_entry])},\n'
                       f'"cameras": {lines(cameras)},\n"lighting": {compact(light)},\n'
                       f'"lights": {lines(numbered(lamps))},\n'
                       '"individuals": {\n'
                       f'"columns": {compact(COLUMNS)},\n"rows": {lines(self.rows)}}}\n}}\n')
        print(f"{os.path.normpath(path)}: {len(self.rows)} individuals")


def template_entry(identifier, name):
    return Actor(identifier, name).entry()


def stage_seats(stage):
    document, _ = read_glb(os.path.join(RESOURCES, "stages", stage + ".glb"))
    return document["scenes"][document["scene"]]["extras"]["seats"]


def spot(name, lamp, target, degrees, strength, colour=(255, 222, 176), **more):
    """It goes on after dark; so do those to all sides."""
    return {"name": name, "kind": "spot", "position": list(lamp), "target": list(target),
            "cone": rounded(math.radians(degrees)), "softness": .5, "beam": .1,
            "strength": strength, "color": hexed(colour), "afterDark": True, **more}


def lantern(name, lamp, strength, colour=(255, 206, 140), **more):
    return {"name": name, "kind": "point", "position": list(lamp), "strength": strength,
            "color": hexed(colour), "afterDark": True, **more}


def hexed(colour):
    return "#" + "".join(f"{c:02x}" for c in colour)


def numbered(lamps):
    return [{"id": index, **lamp} for index, lamp in enumerate(lamps, 1)]


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
