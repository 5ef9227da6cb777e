# SPDX-License-Identifier: MIT
"""Ready-made scenes and small ones, run without a clock: a digest of each column every second."""
import hashlib

import numpy as np

import crowdbrush
from crowdbrush import Session

COLUMNS = ("position", "heading", "clip", "phase", "tags", "seat")


def lines_of(session, second):
    """One line a column: where a difference begins, and in what, can be read."""
    lines = [f"second {second} people {len(session)}"]
    for name in COLUMNS:
        values = np.ascontiguousarray(session.column(name))
        lines.append(f"  {name} {hashlib.sha256(values.tobytes()).hexdigest()[:24]}")
    return lines


def run(scene, seconds, events=()):
    """The digest of a session; events: (second, name)."""
    session = Session(scene)
    lines = lines_of(session, 0)
    for second in range(1, seconds + 1):
        for at, name in events:
            if at == second:
                session.send(name)
        session.run(1.0)
        lines += lines_of(session, second)
    fired = " ".join(f"{rule}:{count}" for rule, count in sorted(session.fired.items()))
    lines.append(f"fired {fired}")
    return "\n".join(lines) + "\n"


def theatre():
    return run(crowdbrush.open("builtin:scenes/theatre.crowd"), 6, [(1, "clap"), (3, "cheer")])


def city():
    return run(crowdbrush.open("builtin:scenes/city.crowd"), 8)


def stadium():
    return run(crowdbrush.open("builtin:scenes/stadium.crowd"), 4, [(1, "wave")])


def crossing():
    """Two streams on an empty plain, through each other."""
    scene = crowdbrush.Scene()
    man = scene.add_template("builtin:templates/man.glb")
    scene.set_environment({
        "places": [{"id": 1, "name": "West", "position": [-12, 0, 0], "radius": 2},
                   {"id": 2, "name": "East", "position": [12, 0, 0], "radius": 2}],
        "paths": [{"id": 1, "name": "Out", "places": [1, 2], "kind": "cyclic"}]})
    n = 60
    scene.create(template=man, position=[(0.8 * (i % 20) - 8, 0, 0.8 * (i // 20) - 1)
                                         for i in range(n)], clip="idle", path=1,
                 heading=[0.1 * i for i in range(n)], seed=list(range(n)))
    return run(scene, 12)


def cases():
    """Pairs of name and what makes the text."""
    return [("theatre_claps", theatre), ("city_walks", city), ("stadium_waves", stadium),
            ("crossing_streams", crossing)]
