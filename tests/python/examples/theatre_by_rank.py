# SPDX-License-Identifier: MIT
"""Fills an empty theatre by rank: the front rows in white, the middle in red, the rest in brown.

usage: theatre_by_rank.py OUTPUT.crowd [PICTURE.png]
"""
import sys

import numpy as np

import crowdbrush

CLASSES = [  # rows counted from the stage, colour, share of the seats that are taken
    (range(0, 3), (238, 232, 220), 1.0),
    (range(3, 8), (150, 40, 44), 0.9),
    (range(8, 99), (120, 92, 66), 0.7),
]


def fill(scene, random):
    """One undo step for the whole audience."""
    people = [scene.add_template("builtin:templates/man.glb"),
              scene.add_template("builtin:templates/woman.glb")]
    clothes = [people[0].slots.index(slot) for slot in ("top", "bottom")]
    seats = scene.seats
    with scene.edit("Fill the theatre by rank"):
        for ranks, colour, share in CLASSES:
            wanted = np.flatnonzero(np.isin(seats["rank"], list(ranks)) & seats["free"])
            taken = wanted[random.random(len(wanted)) < share]
            if len(taken) == 0:
                continue
            templates = np.array([t.id for t in people])[random.integers(0, 2, len(taken))]
            scene.create(
                template=templates,
                seat=seats["id"][taken],
                clip=list(random.choice(["sit", "sit_clap", "sit_cheer"], len(taken),
                                        p=[0.8, 0.15, 0.05])),
                **{f"tint{slot}": (*colour, 255) for slot in clothes},
                height=random.uniform(0.95, 1.05, len(taken)),
                phase=random.random(len(taken)),
            )


def main(output, picture=None):
    scene = crowdbrush.Scene()
    scene.add_stage("builtin:stages/theatre.glb")
    scene.set_camera("from the stage", crowdbrush.Camera((0, 6, -18), (0, 4, 12), fov=55))
    fill(scene, np.random.default_rng(1))
    scene.save(output)
    print(f"{len(scene)} people on {len(scene.seats['id'])} seats")
    if picture:
        scene.render(1280, 720).save_png(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
