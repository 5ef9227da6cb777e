# SPDX-License-Identifier: MIT
"""Everything of the theatre but the seats: orchestra, outer wall, stage building, cypresses."""
import math

import numpy as np

from stage_surface import polar
from theatre_seating import (DEPTH, FIRST_RADIUS, HALF_ANGLE, LOWER_RANKS, OUTER_RADIUS, RANKS,
                             RISE, TOP_LEVEL, edge_radius, feet_level)

STAGE_FRONT, STAGE_HALF_WIDTH, STAGE_HEIGHT = -9.3, 12.5, 1.2
BACK_WALL, BACK_EDGE = -12.9, -16.0
COLUMN_X = (1.9, 3.8, 5.0, 7.4, 8.6, 11.2)
ARCHES = 26


def add_ground(surface):
    surface.arc([(7.6, .015), (OUTER_RADIUS, .015), (OUTER_RADIUS + 3, .015), (62, .015)],
                -math.pi, math.pi, 36, ["earth"] * 3)
    # As far as under the steps: their rings have other corners.
    surface.arc([(.8, .04), (1.6, .04), (6.4, .04), (7.35, .04)], -math.pi, math.pi, 40,
                ["sand"] * 3)
    surface.arc([(7.2, .04), (7.2, .10), (FIRST_RADIUS, .10)], -HALF_ANGLE, HALF_ANGLE, 40,
                ["marble", "stone"])
    surface.arc([(7.2, .04), (7.2, .10), (7.6, .10), (7.6, .015)], HALF_ANGLE,
                2 * math.pi - HALF_ANGLE, 28, ["marble", "marble", "stone"])
    surface.turned(0, 0, [(.9, .04), (.9, .25), (.6, .32), (.55, 1.0), (.72, 1.1), (.72, 1.22),
                          (.01, 1.22)], 10, "marble")


def add_outer_wall(surface):
    top, outer = TOP_LEVEL, OUTER_RADIUS
    surface.arc([(outer - 1.6, top), (outer - .5, top), (outer - .5, top + .9),
                 (outer, top + .9), (outer, top + .3)], -HALF_ANGLE, HALF_ANGLE, 40,
                ["stone_dark", "stone", "marble", "stone"])
    for arch in range(ARCHES):
        start = -HALF_ANGLE + 2 * HALF_ANGLE * arch / ARCHES
        _add_arch(surface, start, start + 2 * HALF_ANGLE / ARCHES, top + .3)
    for side in (-1, 1):
        _add_end_wall(surface, side)


def _add_arch(surface, start, end, top):
    """One bay of the outer wall with a blind niche."""
    middle, half, height = (start + end) / 2, (end - start) * .30, top * .52
    outline = [(middle - half, 0), (middle - half, height)]
    outline += [(middle + half * math.sin(t), height + half * OUTER_RADIUS * .9 * math.cos(t))
                for t in (-math.pi / 3, 0, math.pi / 3)]
    outline += [(middle + half, height), (middle + half, 0)]
    rim = surface.points(polar(OUTER_RADIUS, a, z) for a, z in outline)
    deep = surface.points(polar(OUTER_RADIUS - .6, a, z) for a, z in outline)
    for i in range(len(rim) - 1):
        surface.face((rim[i], rim[i + 1], deep[i + 1], deep[i]), "stone_dark")
    for face in ((0, 1, 5, 6), (1, 2, 3), (1, 3, 5), (3, 4, 5)):
        surface.face([deep[i] for i in face], "stone_dark")
    corner = surface.points(polar(OUTER_RADIUS, a, z) for a, z in
                            ((start, 0), (start, top), (end, top), (end, 0), (middle, top)))
    r = rim
    around = ((corner[0], r[0], r[1]), (corner[0], r[1], corner[1]), (corner[1], r[1], r[2]),
              (corner[1], r[2], r[3]), (corner[1], r[3], corner[4]), (corner[4], r[3], corner[2]),
              (corner[2], r[3], r[4]), (corner[2], r[4], r[5]), (corner[2], r[5], corner[3]),
              (corner[3], r[5], r[6]))
    tone = surface.tone()
    for face in around:
        surface.face(face[::-1], "stone", tone)


def _add_end_wall(surface, side):
    """A stepped wall that closes the seats towards the stage."""
    angle, thickness = side * HALF_ANGLE, .5
    profile = [(FIRST_RADIUS - .4, 0), (FIRST_RADIUS - .4, .95)]
    for rank in (2, LOWER_RANKS - 1, RANKS - 3):
        profile += [(edge_radius(rank) + DEPTH * .6, feet_level(rank) + RISE + .75)]
    profile += [(OUTER_RADIUS, TOP_LEVEL + .9), (OUTER_RADIUS, 0)]
    shift = (side * math.cos(angle) * thickness, -side * math.sin(angle) * thickness)
    inner = [polar(r, angle, z) for r, z in profile]
    outer = [(x + shift[0], y + shift[1], z) for x, y, z in inner]
    surface.prism(inner, outer, "marble", "stone", flip=side > 0)


def add_column(surface, x, y, z, height, radius):
    surface.box((x - radius * 1.3, y - radius * 1.3, z),
                (x + radius * 1.3, y + radius * 1.3, z + .14), "marble")
    surface.turned(x, y, [(radius * 1.15, z + .14), (radius, z + .28),
                          (radius * .84, z + height - .32), (radius * 1.22, z + height - .14)],
                   8, "marble")
    surface.box((x - radius * 1.3, y - radius * 1.3, z + height - .14),
                (x + radius * 1.3, y + radius * 1.3, z + height), "marble", True)


def add_stage_building(surface):
    w = STAGE_HALF_WIDTH
    surface.box((-w, BACK_EDGE, 0), (w, STAGE_FRONT, STAGE_HEIGHT), "stone")
    for i in range(13):
        x = -w + .3 + i * (2 * w - .6) / 12
        surface.box((x - .18, STAGE_FRONT, 0), (x + .18, STAGE_FRONT + .2, STAGE_HEIGHT - .08),
                    "marble", without=0)
    for side in (-1, 1):
        x = side * (w - 2.2)
        for step in range(6):
            surface.box((x - 1.1, STAGE_FRONT + .2, 0),
                        (x + 1.1, STAGE_FRONT + .2 + (6 - step) * .32, .2 * (step + 1)),
                        "marble")
    surface.box((-w, BACK_EDGE, STAGE_HEIGHT), (w, BACK_WALL, 9.2), "stone")
    _add_doors(surface)
    for x in COLUMN_X:
        for side in (-1, 1):
            add_column(surface, side * x, STAGE_FRONT - 2.1, STAGE_HEIGHT, 4.0, .27)
            add_column(surface, side * x, STAGE_FRONT - 2.4, 6.0, 2.9, .20)
    for z, height, out in ((5.2, .5, 0), (5.7, .3, .25), (8.9, .35, .1), (9.25, .45, .3)):
        surface.box((-w - out, BACK_EDGE - out, z), (w + out, STAGE_FRONT - 1.7 + out, z + height),
                    "marble", True)
    add_gable(surface, (-w - .5, w + .5), (BACK_EDGE - .5, STAGE_FRONT - 1.3), 9.7, 1.9)


def _add_doors(surface):
    for x, width, height in ((0, 2.2, 3.5), (-6.2, 1.5, 2.9), (6.2, 1.5, 2.9)):
        top = STAGE_HEIGHT + height
        surface.box((x - width / 2 - .3, BACK_WALL, STAGE_HEIGHT),
                    (x + width / 2 + .3, BACK_WALL + .15, top + .4), "marble")
        surface.box((x - width / 2, BACK_WALL, STAGE_HEIGHT),
                    (x + width / 2, BACK_WALL + .2, top), "stone_dark")
    for x in (-9.9, -6.2, -2.85, 2.85, 6.2, 9.9):
        surface.box((x - .5, BACK_WALL, 6.2), (x + .5, BACK_WALL + .1, 8.2), "stone_dark")


def add_gable(surface, x_range, y_range, z, height):
    """A roof with its ridge along the shorter side."""
    (x0, x1), (y0, y1) = x_range, y_range
    a = surface.points(((x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)))
    if x1 - x0 < y1 - y0:
        t = surface.points((((x0 + x1) / 2, y0, z + height), ((x0 + x1) / 2, y1, z + height)))
        ends, slopes = ((0, 1, 0), (2, 3, 1)), ((1, 2, 1, 0), (3, 0, 0, 1))
    else:
        t = surface.points(((x0, (y0 + y1) / 2, z + height), (x1, (y0 + y1) / 2, z + height)))
        ends, slopes = ((1, 2, 1), (3, 0, 0)), ((0, 1, 1, 0), (2, 3, 0, 1))
    for i, j, k in ends:
        surface.face((a[i], a[j], t[k]), "marble")
    for i, j, k, m in slopes:
        surface.face((a[i], a[j], t[k], t[m]), "roof")


def add_wings(surface):
    for side in (-1, 1):
        x = side * (STAGE_HALF_WIDTH + 1.8)
        surface.box((x - 1.8, BACK_EDGE, 0), (x + 1.8, STAGE_FRONT - .6, 8.0), "stone")
        add_gable(surface, (x - 2.1, x + 2.1), (BACK_EDGE - .3, STAGE_FRONT + .7), 8.0, 1.3)
        for shift in (-1.2, 1.2):
            add_column(surface, x + shift, STAGE_FRONT - .1, 0, 7.3, .30)
        surface.box((x - 1.9, STAGE_FRONT - .6, 7.3), (x + 1.9, STAGE_FRONT + .4, 8.0), "marble",
                    True)


def add_trees(surface):
    """Cypresses close to the wall, umbrella pines further out."""
    random = np.random.default_rng(4)
    for i in range(26):
        angle = -2.45 + 4.9 * i / 25 + random.uniform(-.06, .06)
        _add_cypress(surface, polar(OUTER_RADIUS + 4 + random.uniform(0, 7), angle, 0), random)
    for i in range(22):
        angle = -2.3 + 4.6 * i / 21 + random.uniform(-.1, .1)
        _add_pine(surface, polar(OUTER_RADIUS + 11 + random.uniform(0, 22), angle, 0), random)


def _add_cypress(surface, place, random):
    x, y, _ = place
    height, girth = random.uniform(7, 11), random.uniform(.85, 1.15)
    surface.turned(x, y, [(.18, 0), (.15, 1.1)], 4, "trunk")
    outline = ((.30, .08), (1.0, .20), (1.06, .38), (.74, .70), (.30, .91), (.02, 1))
    surface.turned(x, y, [(r * girth, z * height) for r, z in outline], 6, "leaf")


def _add_pine(surface, place, random):
    x, y, _ = place
    height, girth = random.uniform(8, 12), random.uniform(2.4, 3.6)
    surface.turned(x, y, [(.28, 0), (.20, height * .74)], 4, "trunk")
    outline = ((.05, .62), (.76, .66), (1.0, .76), (.72, .91), (.02, 1))
    surface.turned(x, y, [(r * girth, z * height) for r, z in outline], 8, "pine")


def add_hills(surface):
    """Two ridges on the horizon."""
    random = np.random.default_rng(11)
    for radius, start, height, material in ((100, 61, 11, "hill"), (145, 92, 25, "hill_far")):
        steps = 48
        waves = random.uniform(0, 2 * math.pi, 4)
        heights = [height * (.55 + .22 * math.sin(3 * a + waves[0])
                             + .16 * math.sin(7 * a + waves[1])
                             + .10 * math.sin(13 * a + waves[2])
                             + .06 * math.sin(23 * a + waves[3]))
                   for a in (2 * math.pi * i / steps for i in range(steps))]
        turns = [2 * math.pi * i / steps for i in range(steps)]
        foot, crest = ([polar(r, a, z) for a, z in zip(turns, levels)] for r, levels in (
            (start, [.01] * steps), (radius, heights)))
        low, high = surface.points(foot), surface.points(crest)
        for i in range(steps):
            j = (i + 1) % steps
            surface.face((low[i], low[j], high[j], high[i]), material, 1.0)


def add_banners(surface):
    """Masts with hanging cloth on the rim of the audience."""
    count = 18
    for i in range(count):
        angle = -HALF_ANGLE + 2 * HALF_ANGLE * (i + .5) / count
        x, y, z = polar(OUTER_RADIUS - .25, angle, TOP_LEVEL + .9)
        surface.turned(x, y, [(.06, z), (.05, z + 3.6)], 4, "trunk")
        cloth = []
        for side, level in ((-.55, 3.4), (.55, 3.4), (.55, 1.5), (0, 1.15), (-.55, 1.5)):
            px, py, _ = polar(OUTER_RADIUS - .36, angle + side / OUTER_RADIUS, 0)
            cloth.append(surface.point(px, py, z + level))
        material = "banner" if i % 2 else "banner_light"
        surface.face(cloth, material, 1.0)
        surface.face(cloth[::-1], material, 1.0)
