#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Writes scenes/theatre.crowd: an antique audience, with the two middle wedges empty."""
import math
import random

from crowd_scene import ANTIQUE, STAGE_ID, Crowd, camera, lantern, spot, stage_seats

EMPTY_WEDGES = (4, 5)
OCCUPANCY = .955
LIGHT = {"sunAzimuth": .95, "sunElevation": .72, "sunColor": [1.0, .95, .84], "sunStrength": 1.1,
         "shadowStrength": .85, "occlusion": .6, "highlights": 1.0, "shadowSoftness": .02,
         "ambientColor": [.70, .74, .84], "ambientStrength": .50,
         "skyZenith": [.28, .50, .80], "skyHorizon": [.86, .90, .93],
         "ground": [.70, .64, .48], "groundGrid": False}
CAMERAS = [
    camera("Audience", (7.5, 5.6, 2.0), (-2.6, 2.6, -12.5), 42),
    camera("From the stage", (-4.0, 3.0, 8.6), (2.5, 2.6, -12), 48),
    camera("Whole theatre", (34, 24, 14), (0, .5, -3), 40),
    camera("Back row", (3.5, 7.6, -20.2), (-.5, 3.2, 10), 50),
    camera("Close", (-6.0, 2.3, -4.2), (-10.2, 1.6, -9.2), 42),
]
LAMPS = [
    spot("Stage left", (-8.0, 14.0, -9.0), (-1.5, .8, 3.0), 34, 2.0, (255, 214, 160),
         shadows=True),
    spot("Stage right", (8.0, 14.0, -9.0), (1.5, .8, 3.0), 34, 2.0, (255, 178, 120), shadows=True),
    lantern("Left stand", (-10.5, 6.5, -7.0), .14, size=2.0),
    lantern("Middle", (0.0, 7.0, -14.0), .14, size=2.0),
    lantern("Right stand", (10.5, 6.5, -7.0), .14, size=2.0),
]
# Who sits where: those of rank in the first rows, the others behind them.
FRONT = (("patrician", 46), ("matron", 28), ("priest", 18), ("citizen", 8))
MIDDLE = (("citizen", 46), ("matron", 30), ("patrician", 12), ("labourer", 12))
BACK = (("labourer", 42), ("citizen", 32), ("matron", 26))


class Mood:
    """Smooth waves of excitement over the audience: 0 calm, 1 cheering."""

    def __init__(self, rng):
        self.waves = [(rng.uniform(-.55, .55), rng.uniform(-.55, .55), rng.uniform(0, 6.28))
                      for _ in range(5)]

    def at(self, position):
        x, _, z = position
        return .5 + sum(math.sin(a * x + b * z + c) for a, b, c in self.waves) / 7


def choose_clip(excitement, rng):
    value = excitement + rng.gauss(0, .12)
    if value > .86:
        return "sit_cheer"
    if value > .60:
        return "sit_clap"
    if value < .17:
        return rng.choice(("sit_bored", "sit_sad", "sit_2"))
    return "sit" if rng.random() < .62 else "sit_2"


def choose_person(rank, rng):
    choices = FRONT if rank < 3 else MIDDLE if rank < 8 else BACK
    names, weights = zip(*choices)
    return rng.choices(names, weights)[0]


def main():
    rng = random.Random(2026)
    mood = Mood(rng)
    crowd = Crowd(("patrician", "matron", "citizen", "labourer", "priest"), rng)
    for index, seat in enumerate(stage_seats("theatre")):
        if seat["wedge"] in EMPTY_WEDGES or rng.random() > OCCUPANCY:
            continue
        crowd.add(choose_person(seat["rank"], rng), seat["position"],
                  seat["headingRadians"] + rng.gauss(0, .07),
                  choose_clip(mood.at(seat["position"]), rng), STAGE_ID << 24 | index, ANTIQUE)
    crowd.write("theatre.crowd", "Theatre", "theatre", CAMERAS, LIGHT, LAMPS)


if __name__ == "__main__":
    main()
