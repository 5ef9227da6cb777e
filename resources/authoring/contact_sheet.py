#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Renders every clip of a template in eight phases with the program itself, to look at.

usage: contact_sheet.py CROWDBRUSH TEMPLATE OUTPUT.png [DEGREES]   (TEMPLATE: man or woman)"""
import json
import math
import os
import subprocess
import sys
import tempfile

from crowd_scene import camera, template_entry

PHASES, SPACING, ROW = 8, 1.4, 5.0


def people(clips, heading):
    """One row of people a clip, from the front to the back."""
    rows = []
    for row in range(len(clips)):
        for phase in range(PHASES):
            rows.append([len(rows) + 1, 1, [(phase - (PHASES - 1) / 2) * SPACING, 0.0, -row * ROW],
                         heading, row, phase / PHASES])
    return rows


def write_scene(path, name, degrees):
    template = template_entry(1, name)
    rows = people(template["clips"], math.radians(degrees))
    depth = (len(template["clips"]) - 1) * ROW
    view = camera("Sheet", (0, 15, 32 - depth / 2), (0, .9, -depth / 2), 30)
    view.update(orthographic=True, orthographicHeight=16.5)
    scene = {"format": "crowdbrush-scene", "version": 1, "name": name, "seed": 1,
             "nextId": len(rows) + 1, "templates": [template], "stages": [], "cameras": [view],
             "individuals": {"columns": ["id", "template", "position", "heading", "clip", "phase"],
                             "rows": rows}}
    with open(path, "w", encoding="utf-8") as file:
        json.dump(scene, file)


def main(program, name, output, degrees="30"):
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "sheet.crowd")
        write_scene(scene, name, float(degrees))
        subprocess.run([program, "render", scene, "--output", output, "--camera", "Sheet",
                        "--size", "1400x1900"], check=True)


if __name__ == "__main__":
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    main(*sys.argv[1:])
