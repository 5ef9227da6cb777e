# SPDX-License-Identifier: MIT
"""Makes a mosaic of people from a picture: one person per pixel, wearing its colour.

usage: mosaic.py OUTPUT.crowd [PICTURE.png]
The picture here is drawn by a formula; any height × width × 3 uint8 array will do.
"""
import sys

import numpy as np

import crowdbrush

SPACING = 0.9  # metres


def sunrise(height=24, width=40):
    y, x = np.mgrid[0:1:height * 1j, -1:1:width * 1j]
    pixels = np.stack([60 + 150 * y, 40 + 90 * y, 110 - 40 * y], axis=2)
    pixels[np.hypot(x, (y - 0.7) * 1.2) < 0.45] = (250, 210, 70)
    return pixels.astype(np.uint8)


def stand(scene, pixels):
    """The ids of those who stand for the pixels, row by row from the top left."""
    height, width = pixels.shape[:2]
    row, column = np.mgrid[0:height, 0:width]
    places = np.zeros((height * width, 3), np.float32)
    places[:, 0] = (column.ravel() - (width - 1) / 2) * SPACING
    places[:, 2] = (row.ravel() - (height - 1) / 2) * SPACING
    colours = np.full((height * width, 8, 4), 255, np.uint8)
    colours[..., :3] = pixels.reshape(-1, 1, 3)
    man = scene.add_template("builtin:templates/man.glb")
    return scene.create(template=man, position=places, tint=colours, clip="idle",
                        phase=np.random.default_rng(2).random(len(places)))


def main(output, picture=None):
    scene = crowdbrush.Scene()
    pixels = sunrise()
    stand(scene, pixels)
    scene.set_camera("above", crowdbrush.Camera((0, 45, 0.01), (0, 0, 0)))
    scene.save(output)
    print(f"{len(scene)} people stand for {pixels.shape[1]} × {pixels.shape[0]} pixels")
    if picture:
        scene.render(1280, 800).save_png(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
