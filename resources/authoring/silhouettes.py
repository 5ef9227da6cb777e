# SPDX-License-Identifier: MIT
"""Front silhouettes of people and how much two of them overlap (plain NumPy and Pillow)."""
import itertools

import numpy as np
from PIL import Image, ImageDraw

PIXELS_PER_METRE, HALF_WIDTH, HEIGHT = 250, .75, 2.2


def silhouette(template, scale=1.0):
    """What the first keyframe of idle covers, seen from the front without perspective; parts that
    are hidden by default are not worn."""
    world = template.globals("idle")
    picture = Image.new("1", (int(2 * HALF_WIDTH * PIXELS_PER_METRE),
                              int(HEIGHT * PIXELS_PER_METRE)))
    draw = ImageDraw.Draw(picture)
    for primitive in template.primitives:
        if not template.nodes[primitive.node].get("extras", {}).get("shown", True):
            continue
        points = template.deformed(primitive, world, [0])[0] * scale
        across = (points[:, 0] + HALF_WIDTH) * PIXELS_PER_METRE
        down = (HEIGHT - points[:, 1]) * PIXELS_PER_METRE
        for triangle in primitive.triangles:
            draw.polygon([(across[i], down[i]) for i in triangle], fill=1)
    return np.array(picture)


def height(picture):
    """Metres of what the silhouette covers."""
    return (picture.shape[0] - np.flatnonzero(picture.any(1))[0]) / PIXELS_PER_METRE


def overlap(a, b):
    """Intersection over union, the best of b shifted up to 2 cm to either side."""
    best = 0.0
    for shift in range(-5, 6):
        moved = np.roll(b, shift, axis=1)
        best = max(best, (a & moved).sum() / (a | moved).sum())
    return best


def overlaps(pictures):
    """[(overlap, name, name)], the most alike first; pictures: name -> silhouette."""
    return sorted(((overlap(pictures[a], pictures[b]), a, b)
                   for a, b in itertools.combinations(sorted(pictures), 2)), reverse=True)
