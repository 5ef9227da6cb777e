# SPDX-License-Identifier: MIT
"""A procession along a curve: pairs at an even distance, each facing the way it goes.

usage: procession.py OUTPUT.crowd [PICTURE.png]
"""
import sys

import numpy as np

import crowdbrush

GAP = 1.4  # metres from pair to pair
ASIDE = 0.5  # metres from the middle of the way


def even_points(curve, gap):
    """Points at equal distances along a polyline of N×2, and the directions there."""
    steps = np.diff(curve, axis=0)
    way = np.concatenate([[0], np.cumsum(np.hypot(*steps.T))])
    at = np.arange(0, way[-1], gap)
    points = np.stack([np.interp(at, way, curve[:, axis]) for axis in (0, 1)], axis=1)
    segment = np.clip(np.searchsorted(way, at, side="right") - 1, 0, len(steps) - 1)
    return points, steps[segment] / np.hypot(*steps[segment].T)[:, None]


def walk(scene, curve):
    points, ahead = even_points(curve, GAP)
    aside = np.stack([ahead[:, 1], -ahead[:, 0]], axis=1) * ASIDE
    ground = np.concatenate([points + aside, points - aside])
    places = np.zeros((len(ground), 3), np.float32)
    places[:, [0, 2]] = ground
    heading = np.tile(np.arctan2(ahead[:, 0], ahead[:, 1]), 2)
    random = np.random.default_rng(3)
    people = [scene.add_template(f"builtin:templates/{name}.glb") for name in ("man", "woman")]
    return scene.create(template=np.array([t.id for t in people])[random.integers(0, 2, len(places))],
                        position=places, heading=heading, clip="walk",
                        phase=random.random(len(places)),
                        **{f"tint{people[0].slots.index('top')}": (240, 236, 226, 255)})


def main(output, picture=None):
    scene = crowdbrush.Scene()
    t = np.linspace(0, 1, 400)
    walk(scene, np.stack([40 * (t - 0.5), 10 * np.sin(2 * np.pi * t)], axis=1))
    scene.set_camera("hill", crowdbrush.Camera((0, 18, 30), (0, 0, 0)))
    scene.save(output)
    print(f"{len(scene)} people walk in {len(scene) // 2} pairs")
    if picture:
        scene.render(1280, 720).save_png(picture)


if __name__ == "__main__":
    main(*sys.argv[1:])
