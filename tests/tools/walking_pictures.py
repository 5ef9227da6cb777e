# SPDX-License-Identifier: MIT
"""Pictures that show whether feet slide: a man from the side, twelve moments below each other.

usage: PROGRAM script tests/tools/walking_pictures.py PROGRAM FOLDER
PROGRAM is build/release/crowdbrush. Needs python3-pil.

Writes walking.png, setting-off.png, running-up.png and stopping.png. The camera stands still and
the grey lines are fixed to the ground, a quarter of a metre apart. Where soles touch the ground
there is a red bar: a foot that bears weight has its bar at the same place in row after row.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

import crowdbrush

WIDTH, HEIGHT = 4.5, 1.0  # metres seen
SCALE = 160  # pixels per metre
BELOW = 0.12  # metres of ground under the feet
CONTACT = 0.012  # metres: soles lower than this touch the ground
GRID = 0.25  # metres
MOMENTS = 12
RATE = 60  # moments are multiples of 1/60 s
DIFFERENT = 24  # grey levels between a man and what is behind him
FROM, TO = -4.0, 20.0  # metres along the way that the first look covers


def scene_with(length, speed, rules=()):
    scene = crowdbrush.Scene()
    man = scene.add_template("builtin:templates/man.glb")
    scene.set_environment({
        "places": [{"id": 1, "name": "end", "position": [length, 0, 0], "radius": 0.1}],
        "paths": [{"id": 1, "name": "way", "kind": "simple", "places": [1]}],
        "rules": list(rules)})
    scene.create(template=man, position=[(0, 0, 0)], heading=np.pi / 2, clip="idle", path=1,
                 walkSpeed=speed)
    return scene


def pictures(program, scene, first, last, middle, width, height, scale):
    """Of all moments from first to last, from the side: he is as large wherever he walks."""
    scene.set_camera("side", crowdbrush.Camera.exact(
        (middle, height / 2 - BELOW, 20), (1, 0, 0, 0), orthographic=True, height=height))
    with tempfile.TemporaryDirectory() as folder:
        scene.save(f"{folder}/scene.crowd")
        subprocess.run([program, "render", f"{folder}/scene.crowd", "--output",
                        f"{folder}/####.png", "--camera", "side", "--frames", f"{first}-{last}",
                        "--fps", str(RATE), "--size",
                        f"{round(width * scale)}x{round(height * scale)}"],
                       check=True, stdout=subprocess.DEVNULL)
        return [np.asarray(Image.open(file).convert("RGB")).astype(np.int16)
                for file in sorted(pathlib.Path(folder).glob("*.png"))]


def figure(image):
    """Where the man is: the sky's colours go from row to row, and he is never at the left edge."""
    return np.abs(image - image[:, :1]).max(axis=2) > DIFFERENT


def row_of(image, middle):
    him = figure(image)
    image = image.copy()
    ground = round((HEIGHT - BELOW) * SCALE)
    touching = him[ground - round(CONTACT * SCALE):ground].any(axis=0)
    first = np.ceil((middle - WIDTH / 2) / GRID)
    for line in np.arange(first * GRID, middle + WIDTH / 2, GRID):
        column = int((line - middle + WIDTH / 2) * SCALE)
        image[:, column][~him[:, column]] -= 40
    image[ground + 3:ground + 9, touching] = (220, 20, 20)
    image[-1] = 0
    return np.clip(image, 0, 255).astype(np.uint8)


def sheet(program, folder, name, scene, start, step):
    """start and step: in moments."""
    last = start + (MOMENTS - 1) * step
    wide = [pictures(program, scene, at, at, (FROM + TO) / 2, TO - FROM, 3, 20)[0]
            for at in (start, last)]
    middle = np.mean([FROM + np.flatnonzero(figure(image).any(axis=0)).mean() / 20
                      for image in wide])
    seen = pictures(program, scene, start, last, middle, WIDTH, HEIGHT, SCALE)[::step]
    Image.fromarray(np.concatenate([row_of(image, middle) for image in seen])).save(
        folder / f"{name}.png")
    print(f"{name}.png: {len(seen)} moments from {start / RATE:.2f} to {last / RATE:.2f} s")


def main(program, folder):
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    run = {"id": 1, "name": "run", "when": {"kind": "start"},
           "do": [{"kind": "wait", "seconds": 4.0}, {"kind": "speed", "value": 2.9}]}
    sheet(program, folder, "walking", scene_with(30, 1.24), 300, 6)
    sheet(program, folder, "setting-off", scene_with(30, 1.24), 0, 7)
    sheet(program, folder, "running-up", scene_with(30, 1.24, [run]), 300, 5)
    sheet(program, folder, "stopping", scene_with(6, 1.24), 290, 7)


if __name__ == "__main__":
    main(*sys.argv[1:])
