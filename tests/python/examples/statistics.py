# SPDX-License-Identifier: MIT
"""What is in a scene, in numbers.

usage: statistics.py SCENE.crowd
"""
import sys

import numpy as np

import crowdbrush


def report(scene):
    """Lines of text."""
    yield f"{len(scene)} people, {len(scene.templates)} templates"
    template = scene.column("template")
    clip = scene.column("clip")
    for each in scene.templates:
        mine = template == each.id
        yield f"  {each.name}: {np.count_nonzero(mine)}"
        for index, count in zip(*np.unique(clip[mine], return_counts=True)):
            yield f"    {each.clip_names[index]}: {count}"
    seats = scene.seats
    if len(seats["id"]):
        yield f"{np.count_nonzero(~seats['free'])} of {len(seats['id'])} seats are taken"
    if len(scene) > 1:
        places = scene.column("position")
        yield "from {:.1f}, {:.1f}, {:.1f} m".format(*places.min(axis=0))
        yield "to {:.1f}, {:.1f}, {:.1f} m".format(*places.max(axis=0))


if __name__ == "__main__":
    print("\n".join(report(crowdbrush.open(sys.argv[1]))))
