# SPDX-License-Identifier: MIT
"""A skinned surface under construction: the left half is built, then mirrored."""
from dataclasses import dataclass

import numpy as np

from geometry import vec

SMALLEST_WEIGHT, MOST_WEIGHTS = .004, 4


@dataclass(frozen=True)
class Face:
    ids: tuple
    slot: str
    uv: tuple
    mirrors_uv: bool  # the right half gets 1 - u


def normalized(weights):
    """At most four weights that sum to 1."""
    kept = sorted(((b, w) for b, w in weights.items() if w > SMALLEST_WEIGHT),
                  key=lambda item: -item[1])[:MOST_WEIGHTS]
    total = sum(w for _, w in kept)
    return {bone: w / total for bone, w in kept}


def blend(weights, bone, share):
    """weights with the given share of one more bone."""
    result = {b: w * (1 - share) for b, w in weights.items()}
    result[bone] = result.get(bone, 0) + share
    return result


def other_side(bone):
    return bone[:-1] + {"L": "R", "R": "L"}[bone[-1]] if bone[-2:] in ("_L", "_R") else bone


class Surface:
    def __init__(self):
        self.positions, self.weights, self.faces, self.sharp = [], [], [], []
        self._mirrored = {}

    def add(self, position, weights):
        self.positions.append(np.array(position, float))
        self.weights.append(normalized(weights))
        return len(self.positions) - 1

    def add_ring(self, positions, weights_at):
        return [self.add(p, weights_at(p)) for p in positions]

    def face(self, ids, slot, uv, mirrors_uv=False):
        """Corners that coincide with their neighbour are dropped."""
        kept = [i for i in range(len(ids)) if ids[i] != ids[i - 1]]
        if len(kept) >= 3:
            self.faces.append(Face(tuple(ids[i] for i in kept), slot,
                                   tuple(uv[i] for i in kept), mirrors_uv))

    def band(self, lower, upper, slot, u, v, closed=False, mirrors_uv=False, inside_out=False):
        """Quads between two rings; u per column (one more when closed), v = (lower, upper)."""
        count = len(lower)
        for i in range(count if closed else count - 1):
            j = (i + 1) % count
            ids = [lower[i], lower[j], upper[j], upper[i]]
            uv = [(u[i], v[0]), (u[i + 1], v[0]), (u[i + 1], v[1]), (u[i], v[1])]
            if inside_out:
                ids.reverse()
                uv.reverse()
            self.face(ids, slot, uv, mirrors_uv)

    def mirror(self):
        """Adds the right half; vertices on the middle plane are shared."""
        for i in range(len(self.positions)):
            swapped = {other_side(b): w for b, w in self.weights[i].items()}
            if abs(self.positions[i][0]) < 1e-5:
                self.positions[i][0] = 0
                both = dict(self.weights[i])
                for bone, weight in swapped.items():
                    both[bone] = both.get(bone, 0) + weight
                self.weights[i] = normalized(both)
                self._mirrored[i] = i
            else:
                self.positions.append(self.positions[i] * vec(-1, 1, 1))
                self.weights.append(swapped)
                self._mirrored[i] = len(self.positions) - 1
        for face in list(self.faces):
            ids = tuple(self._mirrored[i] for i in reversed(face.ids))
            if set(ids) != set(face.ids):
                uv = tuple((1 - u if face.mirrors_uv else u, v) for u, v in reversed(face.uv))
                self.faces.append(Face(ids, face.slot, uv, face.mirrors_uv))

    def all_sharp_edges(self):
        return self.sharp + [(self._mirrored[a], self._mirrored[b]) for a, b in self.sharp]
