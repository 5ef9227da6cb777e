#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Builds the city, the stadium and the meadow (no Blender). Metres, Z up."""
import math
import random

from stage_file import write_stage
from stage_surface import StageSurface

CITY = {"street": (112, 114, 120), "pavement": (186, 180, 170), "plaza": (206, 192, 168),
        "line": (236, 234, 226), "wall_a": (222, 196, 160), "wall_b": (198, 142, 112),
        "wall_c": (214, 208, 196), "wall_d": (168, 178, 180), "wall_e": (226, 178, 122),
        "trim": (236, 228, 212), "window": (84, 106, 122), "door": (98, 70, 52),
        "roof": (158, 88, 66), "stone": (196, 186, 166), "water": (96, 158, 186),
        "leaf": (92, 134, 72), "trunk": (98, 78, 60), "metal": (78, 82, 88),
        "awning": (190, 70, 58), "awning_light": (236, 222, 190), "sign": (52, 96, 150),
        "grass": (132, 156, 92), "hill": (128, 148, 108), "hill_far": (150, 166, 166)}
STADIUM = {"concrete": (188, 186, 180), "dark": (128, 128, 132), "seat": (64, 92, 150),
           "seat_light": (210, 214, 222), "grass": (96, 146, 74), "grass_light": (110, 160, 84),
           "track": (178, 92, 66), "line": (240, 240, 236), "metal": (206, 208, 212),
           "roof": (226, 228, 232), "board": (190, 62, 54), "board_light": (236, 196, 84),
        "lawn": (120, 150, 88), "leaf": (86, 126, 70), "trunk": (98, 78, 60),
        "hill": (128, 148, 108), "hill_far": (150, 166, 166)}
MEADOW = {"grass": (124, 158, 82), "path": (190, 166, 122), "leaf": (86, 128, 66),
          "leaf_light": (122, 156, 76), "trunk": (104, 82, 62), "wood": (146, 116, 84),
          "stone": (164, 160, 150), "water": (108, 164, 188), "hill": (134, 158, 122),
          "flower": (232, 186, 70), "flower_red": (206, 84, 72), "pad": (150, 148, 144)}


def flat(surface, x0, y0, x1, y1, z, material, tone=1.0):
    surface.face(surface.points(((x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z))), material,
                 tone)


def tree(surface, x, y, z, height, leaf="leaf"):
    surface.turned(x, y, [(.22, z), (.15, z + height * .5)], 6, "trunk")
    r = height * .30
    surface.turned(x, y, [(.1, z + height * .36), (r * .85, z + height * .48),
                          (r, z + height * .66),
                          (r * .7, z + height * .86), (.02, z + height)], 8, leaf)


def ridges(surface, seed, rows, middle=0):
    """Hills on the horizon, around y = middle. rows: (foot radius, crest radius, height, material),
    near first. No further off than they must be: what can be walked on is measured over all."""
    rng, steps = random.Random(seed), 48
    for foot, crest, height, material in rows:
        shifts = [rng.uniform(0, 2 * math.pi) for _ in range(3)]
        low, high = [], []
        for k in range(steps):
            a = 2 * math.pi * k / steps
            top = height * (.58 + sum(share * math.sin(times * a + shift) for share, times, shift
                                      in zip((.22, .16, .08), (3, 7, 13), shifts)))
            low.append(surface.point(foot * math.cos(a), middle + foot * math.sin(a), .01))
            high.append(surface.point(crest * math.cos(a), middle + crest * math.sin(a), top))
        for k in range(steps):
            n = (k + 1) % steps
            surface.face((low[n], low[k], high[k], high[n]), material, 1.0)


# -- the city ------------------------------------------------------------------------------------
PLAZA, STREET, BLOCK, CURB = 22.0, 5.0, 26.0, .15
TERRACE = 1.5


def city():
    surface, rng, details = StageSurface(11, CITY), random.Random(5), random.Random(6)
    flat(surface, -90, -90, 90, 90, 0, "street")
    _plaza(surface)
    _blocks(surface, rng, details)
    _crossings(surface)
    _bridge(surface)
    _outskirts(surface, details)
    write_stage(surface, "city", smooth=("leaf", "hill", "hill_far"))


def _outskirts(surface, rng):
    """What the streets lead to: houses across their ends, woods and hills."""
    for turn in range(4):
        x = -34.0
        while x < 34:
            wide, storeys = rng.uniform(7, 12), rng.choice((2, 3, 3, 4))
            _far_house(House(surface, turn, rng), rng, x, x + wide, 86 + rng.uniform(0, 1.5),
                       storeys)
            x += wide + rng.choice((0, 0, 0, 4))
    ridges(surface, 3, ((97, 106, 9, "hill"), (101, 107, 19, "hill_far")))


def _far_house(house, rng, x0, x1, edge, storeys):
    top = 3.2 * storeys
    wall = rng.choice(("wall_a", "wall_b", "wall_c", "wall_d", "wall_e"))
    back = (2 + house.turn) % 4
    house.box((x0, edge, 0), (x1, edge + 9, top), wall, back)
    house.box((x0 - .3, edge - .3, top), (x1 + .3, edge + 9, top + 1.2), "roof", back)
    for floor in range(storeys):
        for k in range(2):
            x = x0 + (x1 - x0) * (k + .5) / 2
            house.pane(x - .55, x + .55, edge - .03, 3.2 * floor + .9, 3.2 * floor + 2.5, "window")


def _plaza(surface):
    """A raised square in large slabs, the fountain, trees, benches and lamps."""
    step = 2 * PLAZA / 11
    surface.box((-PLAZA, -PLAZA, -.02), (PLAZA, PLAZA, CURB - .01), "pavement")
    for i in range(11):
        for j in range(11):
            x, y = -PLAZA + i * step, -PLAZA + j * step
            flat(surface, x + .03, y + .03, x + step - .03, y + step - .03, CURB, "plaza",
                 surface.tone(.035))
    surface.turned(0, 0, [(4.6, CURB), (4.6, .75), (4.2, .80), (4.1, .45)], 24, "stone")
    surface.turned(0, 0, [(4.12, .55), (.02, .55)], 24, "water")
    surface.turned(0, 0, [(.9, .5), (.6, .9), (.35, 1.2), (.35, 2.0), (1.7, 2.35), (1.75, 2.5),
                          (1.5, 2.4)], 16, "stone")
    surface.turned(0, 0, [(1.52, 2.42), (.02, 2.42)], 16, "water")
    surface.turned(0, 0, [(.3, 2.4), (.18, 3.1), (.5, 3.4), (.02, 3.6)], 10, "stone")
    for x in (-15, -9, 9, 15):
        for y in (-15, 15):
            surface.box((x - .9, y - .9, CURB), (x + .9, y + .9, .55), "stone")
            flat(surface, x - .75, y - .75, x + .75, y + .75, .56, "grass")
            tree(surface, x, y, .5, 5.4)
    for x in (-12, 12):
        for y in (-15, 15):
            surface.box((x - .9, y - .25, .50), (x + .9, y + .25, .59), "trunk")
            for side in (-.7, .7):
                surface.box((x + side - .08, y - .2, CURB), (x + side + .08, y + .2, .50), "metal")
    for x in (-19, 19):
        for y in (-19, 0, 19):
            surface.turned(x, y, [(.12, CURB), (.06, 1.0), (.05, 4.0)], 6, "metal")
            surface.turned(x, y, [(.12, 4.0), (.28, 4.3), (.22, 4.6), (.02, 4.7)], 8, "trim")


def _blocks(surface, rng, details):
    """Three blocks of houses on each side of the square and one at each corner."""
    edge = PLAZA + 2 * STREET
    for turn in range(4):
        for low, high in ((-62, -edge + 2.6), (-18, -5), (5, 18), (edge - 2.6, 62)):
            is_arcade = turn == 0 and abs(low) < 20
            _row(House(surface, turn, details), rng, low, high, edge, is_arcade)


def _turned(turn, x, y):
    for _ in range(turn):
        x, y = -y, x
    return x, y


class House:
    """Boxes and panes of one house; its front lies at y = edge, looking towards the square."""

    def __init__(self, surface, turn, details):
        self.surface, self.turn, self.details = surface, turn, details

    def box(self, low, high, material, without=None):
        a, b = _turned(self.turn, low[0], low[1]), _turned(self.turn, high[0], high[1])
        self.surface.box((min(a[0], b[0]), min(a[1], b[1]), low[2]),
                         (max(a[0], b[0]), max(a[1], b[1]), high[2]), material, bottom=True,
                         without=without)

    def on_wall(self, low, high, material):
        """A box whose back nobody sees."""
        self.box(low, high, material, (2 + self.turn) % 4)

    def pane(self, x0, x1, y, z0, z1, material):
        corners = ((x0, z0), (x1, z0), (x1, z1), (x0, z1))
        self.surface.face(self.surface.points((*_turned(self.turn, x, y), z) for x, z in corners),
                          material)


def _row(house, rng, low, high, edge, is_arcade):
    house.box((low, edge - 2.6, -.02), (high, edge + 16, CURB), "pavement")
    x = low + .4
    while x < high - 3:
        width = min(rng.uniform(6.0, 9.0), high - .4 - x)
        if high - .4 - x - width < 4:
            width = high - .4 - x
        _house(house, rng, x, x + width, edge, is_arcade)
        x += width


def _house(house, rng, x0, x1, edge, is_arcade):
    floors, wall = rng.choice((3, 3, 4, 4, 5)), rng.choice(("wall_a", "wall_b", "wall_c", "wall_d",
                                                          "wall_e"))
    storey, deep = rng.uniform(3.0, 3.5), rng.uniform(9, 13)
    top = CURB + floors * storey + .5
    first = CURB + storey if is_arcade else CURB
    house.box((x0, edge, first), (x1, edge + deep, top), wall)
    house.box((x0 - .1, edge - .25, top), (x1 + .1, edge + deep, top + .35), "trim")
    house.box((x0 + .6, edge + .8, top + .35), (x1 - .6, edge + deep - .8, top + 1.1), "roof")
    count = max(2, int((x1 - x0) / 2.1))
    pitch = (x1 - x0) / count
    for floor in range(1, floors):
        base = CURB + floor * storey + .85
        for k in range(count):
            middle = x0 + (k + .5) * pitch
            house.on_wall((middle - .62, edge - .06, base - .12),
                          (middle + .62, edge, base + 1.75), "trim")
            house.pane(middle - .50, middle + .50, edge - .07, base, base + 1.62, "window")
        if floor < 3 and house.details.random() < .25:
            k = house.details.randrange(count)
            _balcony(house, x0 + (k + .5) * pitch, edge, base)
    _chimneys(house, x0, x1, edge + deep * .45, top)
    if is_arcade:
        _arcade(house, x0, x1, edge, storey, count, pitch, wall)
    else:
        _shop(house, rng, x0, x1, edge, storey)


def _balcony(house, middle, edge, base):
    """A slab with a rail on bars, and a box of plants."""
    front, floor = edge - .95, base - .30
    house.box((middle - .95, front, floor - .12), (middle + .95, edge, floor), "stone")
    house.box((middle - .95, front, floor + .92), (middle + .95, front + .06, floor + .98), "metal")
    for x in (-.92, -.31, .31, .92):
        house.box((middle + x - .03, front, floor), (middle + x + .03, front + .06, floor + .92),
                  "metal")
    house.box((middle - .6, front - .22, floor + .62), (middle + .6, front, floor + .86), "trunk")
    house.box((middle - .56, front - .20, floor + .84), (middle + .56, front - .02, floor + 1.02),
              "leaf")


def _chimneys(house, x0, x1, y, top):
    for _ in range(house.details.choice((1, 2))):
        x = house.details.uniform(x0 + 1.2, x1 - 1.2)
        tall = top + house.details.uniform(1.7, 2.4)
        house.box((x - .35, y - .3, top + .3), (x + .35, y + .3, tall), "stone")
        house.box((x - .45, y - .4, tall), (x + .45, y + .4, tall + .12), "trim")
        house.box((x - .14, y - .14, tall + .12), (x + .14, y + .14, tall + .5), "roof")


def _arcade(house, x0, x1, edge, storey, count, pitch, wall):
    house.box((x0, edge + 3.2, CURB), (x1, edge + 5, CURB + storey), wall)
    for k in range(count + 1):
        x = x0 + k * pitch
        house.box((max(x0, x - .28), edge, CURB), (min(x1, x + .28), edge + .55, CURB + storey),
                  "stone")
    house.box((x0, edge - .08, CURB + storey - .45), (x1, edge + .6, CURB + storey), "trim")
    for k in range(count):
        middle = x0 + (k + .5) * pitch
        house.pane(middle - .6, middle + .6, edge + 3.19, CURB + .2, CURB + 2.3, "window")


def _shop(house, rng, x0, x1, edge, storey):
    middle, low = (x0 + x1) / 2, CURB
    house.pane(x0 + .6, middle - .8, edge - .03, low + .7, low + 2.5, "window")
    house.pane(middle + .8, x1 - .6, edge - .03, low + .7, low + 2.5, "window")
    house.on_wall((middle - .6, edge - .08, low), (middle + .6, edge, low + 2.45), "trim")
    house.pane(middle - .5, middle + .5, edge - .09, low + .02, low + 2.3, "door")
    if rng.random() < .6:
        house.box((x0 + .4, edge - 1.3, low + 2.62), (x1 - .4, edge, low + 2.74),
                  rng.choice(("awning", "awning_light", "sign")))
    else:
        house.box((x0 + .6, edge - .12, low + 2.6), (x1 - .6, edge, low + 3.0), "sign")


def _crossings(surface):
    """Stripes where the streets leave the square, and lines along them."""
    inner, outer = PLAZA + 1.0, PLAZA + 2 * STREET - 3.4
    for turn in range(4):
        for k in range(9):
            x = -4.0 + k * 1.0
            a, b = _turned(turn, x, inner), _turned(turn, x + .5, outer)
            flat(surface, min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1]), .012,
                 "line")
        for k in range(12):
            a, b = _turned(turn, -.08, 34 + 4 * k), _turned(turn, .08, 36 + 4 * k)
            flat(surface, min(a[0], b[0]), min(a[1], b[1]), max(a[0], b[0]), max(a[1], b[1]), .012,
                 "line")


def _bridge(surface):
    """Stairs up on both sides of the eastern street, and a footbridge over it."""
    x0, x1, top = 36.0, 39.0, 4.4
    surface.box((x0, -9, top - .35), (x1, 9, top), "stone", bottom=True)
    for side in (-1, 1):
        y0, y1 = sorted((side * 5.1, side * 9))
        for rail in (x0, x1 - .12):
            a, b = sorted((side * 0.0, side * 9))
            surface.box((rail, a, top), (rail + .12, b, top + 1.0), "metal")
        surface.box((x0 + .2, side * 5.6 - .4, 0), (x1 - .2, side * 5.6 + .4, top - .35), "stone")
        for k in range(26):
            z = top * (26 - k) / 26
            surface.box((x0 - .3 * (k + 1), min(side * 7, side * 9), 0),
                        (x0 - .3 * k, max(side * 7, side * 9), z), "stone")


# -- the stadium ---------------------------------------------------------------------------------
RANKS, PER_BLOCK, BLOCKS, PITCH, DEPTH, RISE = 30, 20, 5, .56, .85, .42
AISLE, FIRST_Y, FIRST_Z, SEAT = 1.3, 12.0, 1.6, .44


def stadium():
    surface, seats = StageSurface(12, STADIUM), []
    width = BLOCKS * PER_BLOCK * PITCH + (BLOCKS + 1) * AISLE
    half = width / 2
    flat(surface, -75, -110, 75, FIRST_Y, 0, "track")
    for x0, y0, x1, y1 in ((-120, -160, -75, 80), (75, -160, 120, 80), (-75, -160, 75, -110),
                           (-75, FIRST_Y, 75, 80)):
        flat(surface, x0, y0, x1, y1, 0, "lawn", 1.0)
    _far_side(surface, half)
    for k in range(14):
        flat(surface, -52, -84 + 6 * k, 52, -78 + 6 * k, .02, ("grass", "grass_light")[k % 2])
    _pitch_lines(surface)
    for x in range(-8, 8):
        surface.box((x * 3.6, FIRST_Y - 2.6, 0), (x * 3.6 + 3.5, FIRST_Y - 2.45, .95),
                    ("board", "board_light", "metal")[x % 3])
    surface.box((-half, FIRST_Y - .9, 0), (half, FIRST_Y - .7, FIRST_Z + .9), "concrete")
    for rank in range(RANKS):
        y, z = FIRST_Y + rank * DEPTH, FIRST_Z + rank * RISE
        surface.box((-half, y - (.7 if rank == 0 else 0), 0), (half, y + DEPTH, z), "concrete")
        for block in range(BLOCKS):
            start = -half + AISLE + block * (PER_BLOCK * PITCH + AISLE)
            surface.box((start - AISLE * .8, y, z),
                        (start - AISLE * .2, y + DEPTH * .5, z + RISE / 2),
                        "dark")
            for k in range(PER_BLOCK):
                x = start + (k + .5) * PITCH
                slot = "seat_light" if (rank // 3 + block) % 4 == 0 else "seat"
                _seat(surface, x, y + .40, z, slot)
                seats.append({"position": [round(x, 4), round(z, 4), round(-(y + .20), 4)],
                              "headingRadians": 0.0, "height": SEAT, "rank": rank, "wedge": block})
    _roof(surface, half)
    write_stage(surface, "stadium", seats, smooth=("leaf", "hill", "hill_far"))


def _far_side(surface, half):
    """An empty bank of steps across the pitch, boards before it, trees and hills."""
    for step in range(9):
        y = -92.5 - 1.6 * step
        surface.box((-half, y - 1.6, 0), (half, y, .7 + .62 * step),
                    "seat_light" if step % 3 == 2 else "seat", without=2 if step > 8 else None)
    surface.box((-half, -107.6, 0), (half, -107.0, 8.6), "concrete")
    for x in range(-8, 8):
        surface.box((x * 3.6, -90.4, 0), (x * 3.6 + 3.5, -90.2, .95),
                    ("metal", "board", "board_light")[x % 3])
    rng = random.Random(15)
    for k in range(46):
        angle = 2 * math.pi * (k + rng.uniform(-.3, .3)) / 46
        radius = 92 + rng.uniform(0, 16)
        x, y = radius * 1.05 * math.cos(angle), radius * math.sin(angle) - 40
        tree(surface, x, y, 0, rng.uniform(8, 13))
    ridges(surface, 5, ((116, 145, 11, "hill"), (138, 180, 27, "hill_far")), -40)


def _seat(surface, x, y, z, material):
    """A shell: the seat and its back."""
    w, tone = PITCH * .43, surface.tone(.03)
    p = surface.points(((x - w, y, z + SEAT - .03), (x + w, y, z + SEAT - .03),
                        (x + w, y + .36, z + SEAT - .05), (x - w, y + .36, z + SEAT - .05),
                        (x + w, y + .43, z + SEAT + .34), (x - w, y + .43, z + SEAT + .34),
                        (x - w, y + .02, z + SEAT - .16), (x + w, y + .02, z + SEAT - .16)))
    for ids in ((0, 1, 2, 3), (3, 2, 4, 5), (6, 7, 1, 0)):
        surface.face([p[i] for i in ids], material, tone)


def _pitch_lines(surface):
    for x0, y0, x1, y1 in ((-46, -80, 46, -79.85), (-46, -8.15, 46, -8), (-46, -80, -45.85, -8),
                           (45.85, -80, 46, -8), (-.07, -80, .07, -8), (-46, -60, -32, -59.85),
                           (-46, -28, -32, -27.85), (-32, -60, -31.85, -28), (32, -60, 46, -59.85),
                           (32, -28, 46, -27.85), (31.85, -60, 32, -28)):
        flat(surface, x0, y0, x1, y1, .03, "line")
    for k in range(40):
        a, b = 2 * math.pi * k / 40, 2 * math.pi * (k + 1) / 40
        ring = [(r * math.cos(t), -44 + r * math.sin(t), .03) for r, t in
                ((9.0, a), (9.15, a), (9.15, b), (9.0, b))]
        surface.face(surface.points(ring), "line", 1.0)
    for x in (-46, 46):
        for y in (-47.6, -40.4):
            surface.box((x - .07, y - .07, 0), (x + .07, y + .07, 2.44), "line")
        surface.box((x - .07, -47.6, 2.40), (x + .07, -40.4, 2.52), "line")


def _roof(surface, half):
    back, top = FIRST_Y + RANKS * DEPTH, FIRST_Z + RANKS * RISE
    surface.box((-half, back, 0), (half, back + .5, top + 7), "concrete")
    p = surface.points(((-half, back - 14, top + 8.6), (half, back - 14, top + 8.6),
                        (half, back + .5, top + 6.8), (-half, back + .5, top + 6.8)))
    surface.face(p, "roof", 1.0)
    surface.face(p[::-1], "roof", 1.0)
    for k in range(8):
        x = -half + 1 + k * (2 * half - 2) / 7
        surface.box((x - .15, back - .5, top + 1), (x + .15, back, top + 7), "metal")


# -- the meadow ----------------------------------------------------------------------------------
LEVEL = 4.2  # keeps the lowest spot above the endless ground plane
PATH_LIFT = .03  # over the grass, whose squares lie a few millimetres off the ground's curve


def ground(x, y):
    """Height of the meadow; a scene asks here where the ground is."""
    gentle = 1.1 * math.sin(x * .055 + .6) * math.cos(y * .048) + .5 * math.sin(x * .11 + y * .09)
    pond = 2.0 * math.exp(-((x + 14) ** 2 + (y - 13) ** 2) / 60)
    pad = min(1.0, math.hypot(x - 20, y - 10) / 14)
    return LEVEL + gentle * pad ** 2 - pond + .0016 * max(0, math.hypot(x, y) - 30) ** 2


def _meadow_path(surface):
    """A ribbon that lies on the grass."""
    rows = []
    for k in range(129):
        x = -80 + k * 1.25
        y, slope = -6 + 7 * math.sin(x * .06), .42 * math.cos(x * .06)
        long = math.hypot(1, slope)
        across = (-slope / long, 1 / long)
        rows.append([surface.point(x + across[0] * w, y + across[1] * w,
                                   ground(x + across[0] * w, y + across[1] * w)
                                   + (PATH_LIFT if abs(w) < 1.6 else -.04))
                     for w in (-1.75, -1.6, -.55, .55, 1.6, 1.75)])
    for near, far in zip(rows[:-1], rows[1:]):
        for i in range(len(near) - 1):
            surface.face((near[i], far[i], far[i + 1], near[i + 1]), "path")


def meadow():
    surface, rng = StageSurface(13, MEADOW), random.Random(8)
    size, count = 90.0, 72
    step = 2 * size / count
    ids = [[surface.point(-size + i * step, -size + j * step,
                          ground(-size + i * step, -size + j * step)) for i in range(count + 1)]
           for j in range(count + 1)]
    for j in range(count):
        for i in range(count):
            surface.face((ids[j][i], ids[j][i + 1], ids[j + 1][i + 1], ids[j + 1][i]), "grass")
    _meadow_path(surface)
    surface.turned(-14, 13, [(8.0, LEVEL - .95), (.02, LEVEL - .95)], 24, "water")
    surface.turned(20, 10, [(6.0, LEVEL - .3), (6.0, LEVEL + .14), (.02, LEVEL + .14)], 24, "pad")
    for _ in range(110):
        x, y = rng.uniform(-80, 80), rng.uniform(-80, 80)
        if math.hypot(x, y) > 30 or (y > 24):
            tree(surface, x, y, ground(x, y) - .1, rng.uniform(4.5, 8.5),
                 rng.choice(("leaf", "leaf_light")))
    for k in range(26):
        _fence(surface, -34 + k * 2.4)
    for _ in range(260):
        x, y = rng.uniform(-24, 24), rng.uniform(-24, 18)
        z, r = ground(x, y), rng.uniform(.05, .10)
        if math.hypot(x - 20, y - 10) > 7 and math.hypot(x + 14, y - 13) > 8.5:
            surface.turned(x, y, [(r, z + .16), (.01, z + .24)], 5,
                           rng.choice(("flower", "flower_red")))
    for _ in range(14):
        x, y = rng.uniform(-26, 26), rng.uniform(-26, 20)
        r, z = rng.uniform(.2, .6), ground(x, y)
        surface.turned(x, y, [(r, z - .2), (r * 1.1, z + r * .3), (r * .5, z + r * .8),
                              (.02, z + r * .85)], 7, "stone")
    write_stage(surface, "meadow", smooth=("grass", "path", "leaf", "leaf_light"))


def _fence(surface, x):
    y = 22.0
    z, after = ground(x, y), ground(x + 2.4, y)
    surface.box((x - .07, y - .07, z - .3), (x + .07, y + .07, z + 1.15), "wood")
    for height in (.5, .95):
        p = surface.points(((x, y - .03, z + height - .06),
                            (x + 2.4, y - .03, after + height - .06),
                            (x + 2.4, y - .03, after + height + .06),
                            (x, y - .03, z + height + .06)))
        surface.face(p, "wood")
        surface.face(p[::-1], "wood")


if __name__ == "__main__":
    city()
    stadium()
    meadow()
