# SPDX-License-Identifier: MIT
"""Gives ready-made scenes what there is to replay: the theatre three states of its audience, the
meadow families and friends. Run by the program, after make_theatre_scene.py and make_scenes.py:

usage: crowdbrush script prepare_scenes.py"""
import os

import numpy as np

import crowdbrush

SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes")
MOODS = {"Calm": {"neutral": 5, "attentive": 3, "bored": 1},
         "Cheering": {"excited": 6, "happy": 3, "neutral": 0.5},
         "Disappointed": {"sad": 4, "angry": 3, "bored": 2}}
HELD = ["clip", "phase", "speed", "feature1"]  # the last: emotions
NEAR = 1.45  # metres between those who stand together
CHILDREN = ("girl", "boy")


def prepare_theatre():
    scene = crowdbrush.open(os.path.join(SCENES, "theatre.crowd"))
    if scene.states:
        return
    scene.save_state("As before", columns=HELD)
    for name, mood in MOODS.items():
        scene.set_feature(scene.ids, "emotion", mood)
        scene.save_state(name, columns=HELD)
    scene.recall_state("As before")
    del scene.states["As before"]
    scene.save()


def groups_of(scene):
    """Lists of rows that stand together, people alone."""
    places = np.asarray(scene.column("position"))
    names = {template.id: template.name for template in scene.templates}
    kinds = [names[each] for each in scene.column("template")]
    people = [row for row, kind in enumerate(kinds) if kind not in
              ("dog", "horse", "beetle", "helicopter", "forklift")]
    left, groups = set(people), []
    while left:
        group, edge = [], [left.pop()]
        while edge:
            row = edge.pop()
            group.append(row)
            near = [each for each in left if np.linalg.norm(places[each] - places[row]) < NEAR]
            left.difference_update(near)
            edge += near
        groups.append(sorted(group))
    return sorted(groups), kinds


def prepare_meadow():
    scene = crowdbrush.open(os.path.join(SCENES, "meadow.crowd"))
    if len(scene.relations["from"]):
        return
    groups, kinds = groups_of(scene)
    ids = np.asarray(scene.ids)
    for group in groups:
        is_family = any(kinds[row] in CHILDREN for row in group) and len(group) <= 6
        for i, row in enumerate(group):
            for other in group[i + 1:]:
                scene.relate(ids[row], ids[other], "family" if is_family else "friends")
    scene.save()


if __name__ == "__main__":
    prepare_theatre()
    prepare_meadow()
