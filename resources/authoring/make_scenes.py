#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes scenes/city.crowd, stadium.crowd and meadow.crowd. Nobody walks on the spot."""
import math
import random

from build_stages import BLOCKS, LEVEL, PER_BLOCK, RANKS, ground
from crowd_scene import STAGE_ID, Crowd, camera, lantern, spot, stage_seats

TODAY = ("man", "woman", "man_2", "woman_2", "girl", "boy", "old_woman", "old_man")
ADULTS = ("man", "woman", "man_2", "woman_2", "man", "woman", "old_woman", "old_man")
CURB = .15
DAY = {"sunAzimuth": .75, "sunElevation": .80, "sunColor": [1.0, .95, .86], "sunStrength": 1.1,
       "shadowStrength": .85, "occlusion": .6, "highlights": 1.0, "shadowSoftness": .02,
       "ambientColor": [.72, .77, .86], "ambientStrength": .50, "skyZenith": [.30, .52, .82], "skyHorizon": [.86, .90, .94],
       "ground": [.46, .47, .49], "groundGrid": False}


def city():
    rng = random.Random(7)
    crowd, taken = Crowd(TODAY, rng), [(0, 0, 6.2)]
    for x in (-15, -9, 9, 15):
        taken += [(x, 15, 1.9), (x, -15, 1.9)]
    for x in (-12, 12):
        taken += [(x, 15, 2.0), (x, -15, 2.0)]
        _bench(crowd, rng, x)
    for _ in range(58):
        size = rng.choice((2, 2, 3, 3, 4, 5))
        spot = _free(rng, taken, 19, 1.0 + .16 * size)
        if spot:
            names = [rng.choice(ADULTS) for _ in range(size)]
            if rng.random() < .25:
                names.append(rng.choice(("girl", "boy")))
            crowd.group(names, spot, ("talk", "talk", "idle", "idle_2", "look_around"),
                        ground=lambda x, z: CURB, turn=rng.uniform(0, 6))
    for _ in range(46):
        spot = _free(rng, taken, 20, .6)
        if spot:
            name = rng.choice(TODAY)
            clip = rng.choice(("idle", "idle_2", "look_around", "bored", "wave", "idle"))
            crowd.add(name, (spot[0], CURB, spot[1]), rng.uniform(-3.1, 3.1), clip)
    _pavements(crowd, rng)
    crowd.write("city.crowd", "City", "city", [
        camera("Square", (4.5, 6.2, 20.5), (-2.0, 1.4, -4.0), 44),
        camera("Fountain", (-7.4, 3.0, 10.6), (1.5, 1.3, -1.5), 42),
        camera("From the bridge", (37.5, 6.2, 2.8), (0, 1.0, -3.0), 46),
        camera("Above", (34, 36, 40), (0, 0, 0), 42),
        camera("Eye to eye", (3.5, 1.75, 12.5), (-4.5, 1.2, 2.0), 46)], DAY, _street_lamps())


def _street_lamps():
    """Where build_stages.py puts posts; and one that lights the fountain from below."""
    posts = [(x, z) for x in (-19, 19) for z in (-19, 0, 19)]
    lamps = [lantern(f"Street lamp {i}", (x, 4.4, z), .3, size=2.0)
             for i, (x, z) in enumerate(posts, 1)]
    for i, (x, z) in enumerate(((-2.8, 1.9), (2.8, 1.9), (0.0, -3.3)), 1):
        lamps.append(spot(f"Fountain {i}", (x, .7, z), (0, 2.4, 0), 60, .05, (168, 206, 255),
                          size=2.0, beam=0.0))
    return lamps


def _free(rng, taken, half, radius):
    for _ in range(60):
        x, z = rng.uniform(-half, half), rng.uniform(-half, half)
        if all(math.hypot(x - a, z - b) > r + radius for a, b, r in taken):
            taken.append((x, z, radius))
            return x, z
    return None


def _bench(crowd, rng, x):
    for z, heading in ((-14.55, 0.0), (14.55, math.pi)):
        for shift in (-.52, .52):
            if rng.random() < .8:
                crowd.add(rng.choice(ADULTS), (x + shift, CURB, z), heading,
                          rng.choice(("sit", "sit_2", "sit_bored", "sit")), size=.99)


def _pavements(crowd, rng):
    """People who wait at the crossings and stand before the shops."""
    for turn in range(4):
        for _ in range(13):
            along, away = rng.uniform(-17, 17), rng.uniform(29.9, 31.4)
            if abs(along) < 5.6:
                continue
            angle = turn * math.pi / 2
            x = along * math.cos(angle) + away * math.sin(angle)
            z = -along * math.sin(angle) + away * math.cos(angle)
            crowd.add(rng.choice(TODAY), (x, CURB, z), angle + rng.choice((0, math.pi, math.pi))
                      + rng.gauss(0, .4), rng.choice(("idle", "idle_2", "look_around", "bored")))


# The picture in the stand: who sits on the star, on the ring around it, elsewhere.
FIELD, RING, STAR = (58, 92, 168), (240, 240, 234), (240, 190, 52)


def colour_at(u, v):
    """u, v: -1..1 across and up the stand, in units of half its height."""
    radius, angle = math.hypot(u, v), math.atan2(u, v)
    point = math.cos(math.pi / 5) / math.cos((angle % (2 * math.pi / 5)) - math.pi / 5)
    sharp = .40 + .60 * abs(((angle / (2 * math.pi / 5)) % 1) * 2 - 1) ** 1.5
    if radius < .78 * sharp * (.6 + .4 * point):
        return STAR
    if .86 < radius < 1.0:
        return RING
    return FIELD if radius < .86 else (RING if int(abs(u) * 4) % 2 else (196, 62, 56))


def stadium():
    rng = random.Random(9)
    crowd = Crowd(TODAY, rng)
    width = BLOCKS * PER_BLOCK * .56 + (BLOCKS + 1) * 1.3
    for index, seat in enumerate(stage_seats("stadium")):
        x, rank, block = seat["position"][0], seat["rank"], seat["wedge"]
        if rng.random() > (.93 if 1 <= block <= 3 else .30):
            continue
        v = (rank + .5) / RANKS * 2 - 1
        top = colour_at(x / (RANKS * .85 / 2) * .92, v)
        wave = .5 + .5 * math.sin(x * .16 + rank * .05)
        value = wave + rng.gauss(0, .22)
        clip = "sit_cheer" if value > .92 else "sit_clap" if value > .60 else \
            rng.choice(("sit", "sit", "sit_2"))
        crowd.add(rng.choice(TODAY), seat["position"], rng.gauss(-x / width * .25, .06), clip,
                  STAGE_ID << 24 | index, top=top)
    crowd.write("stadium.crowd", "Stadium", "stadium", [
        camera("Stand", (0, 13.0, 18.5), (0, 9.4, -24), 43),
        camera("Close", (9.5, 5.4, -6.4), (4.0, 4.6, -17.0), 44),
        camera("From the side", (-33, 9, -4), (4, 6.0, -24), 48),
        camera("From the top row", (-16, 16.3, -36.2), (8, 1.5, 2), 56),
        camera("Pitch", (27, 14, 34), (1, 6.0, -22), 44)],
        dict(DAY, sunAzimuth=.35, ground=[.70, .71, .66]), _floodlights())


def _floodlights():
    """Four on masts behind who looks from the pitch."""
    return [spot(f"Floodlight {i}", (x, 24.0, 14.0), (x * .55, 6.5, -24.0), 48, 9.0,
                 (236, 242, 255), shadows=True, beam=.04)
            for i, x in enumerate((-34, -12, 12, 34), 1)]


def place(x, z):
    return x, ground(x, -z), z


def meadow():
    rng = random.Random(4)
    crowd = Crowd(TODAY + ("dog", "horse", "beetle", "helicopter", "forklift"), rng)
    here = lambda x, z: ground(x, -z)
    for centre, size in (((-6, 3), 4), ((3.5, 8), 3), ((-1, -5), 5), ((8, 1.5), 4), ((-12, 8), 3)):
        names = [rng.choice(TODAY) for _ in range(size)]
        crowd.group(names, centre, ("talk", "idle", "wave", "clap", "idle_2"), .8, here,
                    rng.uniform(0, 6))
    crowd.group([rng.choice(TODAY) for _ in range(9)], (1.0, 1.5), ("dance", "dance_2"), 1.5, here)
    for _ in range(15):
        x, z = rng.uniform(-30, 6), rng.uniform(-21, -9)
        if math.hypot(x + 14, z + 13) > 9.5:
            crowd.add("horse", place(x, z), rng.uniform(-3, 3), "idle")
    for x, z in ((-4.6, 4.2), (4.8, 6.7), (1.2, -3.6), (-9, 1), (10, 4.5), (6.2, -1), (-13, 9.4)):
        crowd.add("dog", place(x, z), rng.uniform(-3, 3), "idle")
    taken = []
    for _ in range(40):
        spot = _free(rng, taken, .9, .07)
        if spot:
            crowd.add("beetle", place(1.3 * spot[0], 10.6 + .7 * spot[1]), rng.uniform(-3, 3),
                      "idle", size=rng.uniform(.8, 1.3))
    crowd.add("helicopter", (20, LEVEL + .14, -10), -.7, "idle", speed=1.0)
    crowd.add("helicopter", (-8, LEVEL + 11.5, -26), .9, "hover", speed=1.0)
    for x, z, turn in ((19.5, -1.3, .8), (16.8, -15.4, -1.2), (12.6, -9.4, 1.6)):
        crowd.add("forklift", place(x, z), turn, "lift")
    crowd.write("meadow.crowd", "Meadow", "meadow", [
        camera("Meadow", (3.5, LEVEL + 4.0, 18.5), (2.6, LEVEL + 1.2, -4.0), 46),
        camera("Horses", (-2.2, LEVEL + 3.0, -9.6), (4.2, LEVEL + 1.5, -15.0), 46),
        camera("Beetles", (.5, here(.5, 11.9) + .42, 11.9), (0, here(0, 10.6), 10.6), 38),
        camera("Machines", (8.6, LEVEL + 3.2, -.6), (17.6, LEVEL + 1.1, -7.0), 48),
        camera("Above", (26, LEVEL + 26, 32), (0, LEVEL, -4), 42)],
        dict(DAY, ground=[.46, .56, .34], skyHorizon=[.88, .92, .92]),
        [lantern("Picnic", (2.6, LEVEL + 3.2, -3.0), .09, size=1.5, shadows=True),
         spot("Landing pad", (23.5, LEVEL + 5.0, -9.0), (17.6, LEVEL + .5, -8.0), 70, .3,
              (226, 236, 255))])


if __name__ == "__main__":
    city()
    stadium()
    meadow()
