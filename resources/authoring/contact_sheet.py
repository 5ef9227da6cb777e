#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Contact sheets, drawn by the program itself, to look at: every template from four sides, every
clip in eight phases, every level of detail side by side, every outfit, and a crowd of forty.

usage: contact_sheet.py CROWDBRUSH FOLDER [SHEET ...] [--only NAME ...]

SHEET is sides, clips, levels, outfits or crowd; all of them when none is named."""
import argparse
import copy
import glob
import json
import math
import os
import random
import struct
import subprocess
import sys
import tempfile

from crowd_scene import ANTIQUE, RESOURCES, TODAY, Actor, camera
from glb import read_glb

SHEETS = ("sides", "clips", "levels", "outfits", "crowd")
PHASES, LEVELS, NO_TINT = 8, 4, "#ffffff00"
UNEVEN = 9 / 8  # so that what repeats four times in a clip does not look still
COLUMNS = ["id", "template", "position", "heading", "tint0", "tint1", "tint2", "tint3", "tint4",
           "tint5", "choices", "parts", "clip", "phase"]
WIDTH, HEIGHTS = 1500, (500, 1900)  # pixels
DEGREES = (0, 90, 180, 270)
TURNED = .5
DOWN = 14  # degrees that the camera looks down
# Width, height and depth to leave for those who are not people, in metres.
ROOM = {"beetle": (.16, .06, .20), "dog": (.9, .9, 1.6), "horse": (1.6, 2.2, 3.4),
        "helicopter": (9.5, 4.6, 11.0), "forklift": (2.2, 3.2, 4.2)}
PERSON = (1.05, 2.0, 1.05)
DAYLIGHT = {"sunAzimuth": .5, "sunElevation": .7, "sunColor": [1.0, .96, .9], "sunStrength": 1.1,
            "ambientColor": [.75, .78, .84], "ambientStrength": .7, "skyZenith": [.42, .5, .6],
            "skyHorizon": [.86, .9, .94], "ground": [.74, .75, .76], "groundGrid": False}


class Figure:
    """One cell of a sheet. template: a key of the sheet's templates."""

    def __init__(self, template, clip=0, phase=0.0, heading=0.0, dress=None):
        self.template, self.clip, self.phase, self.heading = template, clip, phase, heading
        self.tints, self.choices, self.parts = dress or ([NO_TINT] * 6, "00" * 8, None)


def usual_parts(actor):
    return sum(1 << k for k, is_shown in enumerate(actor.parts) if is_shown)


def write_scene(path, templates, rows, room):
    """rows of Figures, one above the other; templates: key -> (entry, usual parts). Returns the
    size of the picture that suits them."""
    wide, high = room[:2]
    step = high * 1.12 / math.sin(math.radians(DOWN))
    table, keys = [], list(templates)
    for r, row in enumerate(rows):
        for c, figure in enumerate(row):
            parts = templates[figure.template][1] if figure.parts is None else figure.parts
            table.append([len(table) + 1, keys.index(figure.template) + 1,
                          [(c - (len(row) - 1) / 2) * wide, 0.0, -r * step], figure.heading,
                          *figure.tints, figure.choices, parts, figure.clip, figure.phase])
    # A camera that looks down a little without perspective sees each row above the last.
    depth = (len(rows) - 1) * step
    tall = len(rows) * high * 1.12
    width = max(len(row) for row in rows) * wide
    pixels = min(HEIGHTS[1], max(HEIGHTS[0], round(WIDTH * tall / width * 1.1)))
    far = 40 + depth
    view = camera("Sheet", (0, high * .45 + far * math.sin(math.radians(DOWN)),
                            far * math.cos(math.radians(DOWN)) - depth / 2),
                  (0, high * .45, -depth / 2), 30)
    view.update(orthographic=True, orthographicHeight=max(tall * 1.1, width * pixels / WIDTH))
    entries = [dict(entry, id=k + 1) for k, (entry, _) in enumerate(templates.values())]
    scene = {"format": "crowdbrush-scene", "version": 1, "name": "Sheet", "seed": 1,
             "nextId": len(table) + 1, "templates": entries, "stages": [], "cameras": [view],
             "lighting": DAYLIGHT,
             "individuals": {"columns": COLUMNS, "rows": table}}
    with open(path, "w", encoding="utf-8") as file:
        json.dump(scene, file)
    return f"{WIDTH}x{pixels}"


class Studio:
    def __init__(self, program, folder):
        self.program, self.folder = os.path.abspath(program), os.path.abspath(folder)
        os.makedirs(folder, exist_ok=True)

    def draw(self, name, templates, rows, room):
        with tempfile.TemporaryDirectory() as folder:
            scene = os.path.join(folder, "sheet.crowd")
            size = write_scene(scene, templates, rows, room)
            output = os.path.join(self.folder, name + ".png")
            subprocess.run([self.program, "render", scene, "--output", output, "--camera", "Sheet",
                            "--size", size], check=True)
            print(output, flush=True)

    def sides(self, actors):
        """One sheet for all people, one for each of the others."""
        people = [a for a in actors if a.name not in ROOM]
        for half, own in enumerate((people[:7], people[7:])):
            if own:
                rows = [[Figure(a.name, heading=math.radians(d)) for a in own[k:k + 2]
                         for d in DEGREES] for k in range(0, len(own), 2)]
                self.draw(f"sides_people_{half + 1}", entries(own), rows, PERSON)
        for actor in (a for a in actors if a.name in ROOM):
            rows = [[Figure(actor.name, heading=math.radians(d)) for d in (25, 90)],
                    [Figure(actor.name, heading=math.radians(d)) for d in (180, 315)]]
            wide = max(ROOM[actor.name])
            self.draw(f"sides_{actor.name}", entries([actor]), rows,
                      (wide, ROOM[actor.name][1], wide))

    def clips(self, actors):
        for actor in actors:
            rows = [[Figure(actor.name, clip, p * UNEVEN / PHASES, TURNED) for p in range(PHASES)]
                    for clip in range(len(actor.clips))]
            for k in range(0, len(rows), 6):
                suffix = f"_{k // 6 + 1}" if len(rows) > 6 else ""
                self.draw(f"clips_{actor.name}{suffix}", entries([actor]), rows[k:k + 6],
                          ROOM.get(actor.name, PERSON))

    def levels(self, actors):
        with tempfile.TemporaryDirectory() as folder:
            for k in range(0, len(actors), 5):
                people = [a for a in actors[k:k + 5] if a.name not in ROOM]
                self._levels(folder, f"levels_people_{k // 5 + 1}", people)
            for actor in (a for a in actors if a.name in ROOM):
                self._levels(folder, f"levels_{actor.name}", [actor])

    def _levels(self, folder, name, actors):
        if not actors:
            return
        templates, rows = {}, []
        for actor in actors:
            row = []
            for level in range(LEVELS):
                path = os.path.join(folder, f"{actor.name}{level}.glb")
                write_level(actor.name, level, path)
                entry = {"name": f"{actor.name}{level}", "path": path, "clips": actor.clips}
                templates[entry["name"]] = entry, usual_parts(actor)
                row += [Figure(entry["name"], heading=h) for h in (TURNED, math.pi - TURNED)]
            rows.append(row)
        room = ROOM.get(actors[0].name, PERSON)
        rows = [rows[0][:4], rows[0][4:]] if len(rows) == 1 else rows
        self.draw(name, templates, rows, (max(room) if actors[0].name in ROOM else room[0],
                                          room[1], room[2]))

    def outfits(self, actors):
        """All choices of one slot after the other, the other slots as they come."""
        for actor in actors:
            figures = []
            for slot, own in enumerate(actor.slots):
                for choice in range(actor.looks[own]):
                    choices = [0] * 8
                    choices[slot] = choice
                    figures.append(Figure(actor.name, heading=TURNED, dress=(
                        [NO_TINT] * 6, "".join(f"{c:02x}" for c in choices),
                        (1 << len(actor.parts)) - 1 if own in ("bag", "scarf", "hat", "cloak")
                        else usual_parts(actor))))
            rows = [figures[k:k + 9] for k in range(0, len(figures), 9)]
            room = ROOM.get(actor.name, PERSON)
            self.draw(f"outfits_{actor.name}", entries([actor]), rows, (PERSON[2] if room is PERSON
                                                                    else max(room),) + room[1:])

    def crowd(self, actors):
        """Forty people as a scene would dress them, today's and the antique audience apart."""
        for name, own, palette in (("today", actors[:8], TODAY),
                                   ("antique", actors[8:13], ANTIQUE)):
            rng, figures = random.Random(3), []
            for k in range(40 if own else 0):
                actor = own[k % len(own)]
                figures.append(Figure(actor.name, actor.clips.index("idle"), rng.random(),
                                      rng.uniform(-.5, .5), actor.fresh_dress(rng, palette)))
            rng.shuffle(figures)
            if figures:
                self.draw(f"crowd_{name}", entries(own), [figures[k:k + 10]
                                                          for k in range(0, 40, 10)], PERSON)


def entries(actors):
    return {a.name: (a.entry(), usual_parts(a)) for a in actors}


def write_level(name, level, path):
    """The template with one of its coarser meshes in place of the finest."""
    document, binary = read_glb(os.path.join(RESOURCES, "templates", name + ".glb"))
    document = copy.deepcopy(document)
    for node in document["nodes"]:
        coarser = node.get("extensions", {}).pop("MSFT_lod", {}).get("ids", ())
        if coarser and level > 0:
            node["mesh"] = document["nodes"][coarser[min(level, len(coarser)) - 1]]["mesh"]
        if coarser:
            for other in coarser:
                document["nodes"][other].pop("mesh", None)
                document["nodes"][other].pop("skin", None)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(binary), 0x004E4942) + binary)


def everybody():
    """People of today, the antique audience, then all others."""
    order = ("man woman man_2 woman_2 girl boy old_woman old_man patrician matron citizen labourer "
             "priest dog horse beetle helicopter forklift").split()
    found = {os.path.basename(p)[:-4] for p in glob.glob(os.path.join(RESOURCES, "templates",
                                                                      "*.glb"))}
    return [Actor(k + 1, name) for k, name in enumerate(order + sorted(found - set(order)))]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("sheets", nargs="*", default=SHEETS)
    parser.add_argument("--only", nargs="*", default=())
    options = parser.parse_args()
    actors, studio = everybody(), Studio(options.program, options.folder)
    chosen = [a for a in actors if not options.only or a.name in options.only]
    for sheet in options.sheets or SHEETS:
        getattr(studio, sheet)(actors if sheet == "crowd" else chosen)


if __name__ == "__main__":
    sys.exit(main())
