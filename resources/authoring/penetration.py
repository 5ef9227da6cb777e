# SPDX-License-Identifier: MIT
"""How far hands go into a person and legs out of what she wears (plain NumPy)."""
import numpy as np

NEAR = .06   # metres; a hand cannot get deeper than this from one keyframe to the next
BODY = ("hips", "spine", "chest", "shoulder", "neck", "head", "thigh", "shin", "foot", "skirt")
SHALLOW = .001
AT_ONCE = 64
AXIS = {"thigh": "shin", "shin": "foot"}


def joint(world, template, name):
    return world[template.index[name]][:, :3, 3]


def _dot(a, b):
    return (a * b).sum(-1)


def near_pairs(points, corners):
    """(frame, point, triangle) of F x P points that are within NEAR of the box of one of the
    F x T triangles."""
    low, high = corners.min(2) - NEAR, corners.max(2) + NEAR
    own_low, own_high = points.min(1)[:, None], points.max(1)[:, None]
    frame, triangle = np.nonzero(((own_low <= high) & (own_high >= low)).all(2))
    inside = np.ones((len(frame), points.shape[1]), bool)
    for axis in range(3):
        own = points[frame, :, axis]
        inside &= own >= low[frame, triangle, axis, None]
        inside &= own <= high[frame, triangle, axis, None]
    row, point = np.nonzero(inside)
    return frame[row], point, triangle[row]


def offsets_from(p, a, b, c):
    """From the nearest spot of triangle a, b, c to p, row by row."""
    ab, ac, ap = b - a, c - a, p - a
    d00, d01, d11, d20, d21 = _dot(ab, ab), _dot(ab, ac), _dot(ac, ac), _dot(ap, ab), _dot(ap, ac)
    area = np.maximum(d00 * d11 - d01 * d01, 1e-14)
    v, w = (d11 * d20 - d01 * d21) / area, (d00 * d21 - d01 * d20) / area
    along = np.clip(_dot(p - b, c - b) / np.maximum(_dot(c - b, c - b), 1e-14), 0, 1)
    best, offset = np.full(len(p), np.inf), np.zeros_like(p)
    for s, t, is_valid in ((v, w, (v >= 0) & (w >= 0) & (v + w <= 1)),
                           (np.clip(d20 / np.maximum(d00, 1e-14), 0, 1), 0 * v, True),
                           (0 * v, np.clip(d21 / np.maximum(d11, 1e-14), 0, 1), True),
                           (1 - along, along, True)):
        own = ap - s[:, None] * ab - t[:, None] * ac
        square = np.where(is_valid, _dot(own, own), np.inf)
        closer = square < best
        best, offset = np.where(closer, square, best), np.where(closer[:, None], own, offset)
    return offset, best


def depths(points, corners):
    """How deep each of F x P points lies behind the triangle next to it, 0 in front of it or
    further off than NEAR."""
    frames, count = points.shape[:2]
    depth = np.zeros(frames * count)
    frame, point, triangle = near_pairs(points, corners)
    if not len(frame):
        return depth.reshape(frames, count)
    a, b, c = (corners[frame, triangle, k] for k in range(3))
    normal = np.cross(b - a, c - a)
    length = np.linalg.norm(normal, axis=1)
    offset, square = offsets_from(points[frame, point], a, b, c)
    square = np.where(length > 1e-10, square, np.inf)
    side = _dot(offset, normal) / np.maximum(length, 1e-10)
    key, best = frame * count + point, np.full(frames * count, np.inf)
    np.minimum.at(best, key, square)
    tied = np.flatnonzero((square <= best[key] + 1e-9) & (best[key] < NEAR * NEAR))
    tied = tied[np.argsort(np.abs(side[tied]), kind="stable")]  # at an edge the clearest side wins
    depth[key[tied]] = np.where(side[tied] < 0, np.sqrt(square[tied]), 0)
    return depth.reshape(frames, count)


def winding(points, corners):
    """How often N x T triangles go round N points: 1 inside a closed surface, 0 outside, and
    between the two where the surface has holes."""
    a, b, c = (corners[:, :, k] - points[:, None] for k in range(3))
    la, lb, lc = (np.sqrt(_dot(v, v)) for v in (a, b, c))
    below = la * lb * lc + _dot(a, b) * lc + _dot(b, c) * la + _dot(c, a) * lb
    return np.arctan2(_dot(a, np.cross(b, c)), below).sum(1) / (2 * np.pi)


def through(inner, outer, corners):
    """How far the lines from F x P inner to outer points go on behind the F x T triangles that
    they cross; one number a frame."""
    low, high = corners.min(2), corners.max(2)
    own_low, own_high = np.minimum(inner, outer), np.maximum(inner, outer)
    meets = np.ones((len(inner), inner.shape[1], corners.shape[1]), bool)
    for axis in range(3):
        meets &= own_low[:, :, None, axis] <= high[:, None, :, axis]
        meets &= own_high[:, :, None, axis] >= low[:, None, :, axis]
    frame, point, triangle = np.nonzero(meets)
    a, b, c = (corners[frame, triangle, k] for k in range(3))
    start, ray = inner[frame, point], outer[frame, point] - inner[frame, point]
    ab, ac = b - a, c - a
    p, offset = np.cross(ray, ac), start - a
    determinant = _dot(p, ab)
    determinant = np.where(np.abs(determinant) < 1e-12, 1e-12, determinant)
    q = np.cross(offset, ab)
    u, v, t = (_dot(x, y) / determinant for x, y in ((offset, p), (ray, q), (ac, q)))
    crosses = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0) & (t < 1)
    result = np.zeros(len(inner))
    np.maximum.at(result, frame, np.where(crosses, (1 - t) * np.linalg.norm(ray, axis=1), 0))
    return result


class Surfaces:
    """Which vertices are hands, legs, trunk and garment of a person.

    The body is what bones of the trunk and the legs own, cloth that lies on it included. What
    hangs freely around both legs is a garment: it gives way under a hand, and has to hide legs."""

    def __init__(self, template):
        self.template = template
        self.skinned = [p for p in template.primitives if p.joints is not None]
        offsets = np.cumsum([0] + [len(p.positions) for p in self.skinned])
        self.rest = np.concatenate([p.positions for p in self.skinned])
        self.triangles = np.concatenate([p.triangles + o for p, o in zip(self.skinned, offsets)])
        slot = np.concatenate([np.full(len(p.positions), p.slot, object) for p in self.skinned])
        names = [template.nodes[j]["name"] for j in template.joints]
        joints = np.concatenate([p.joints[:, 0] for p in self.skinned])
        owner = np.array([names[j][:-2] if names[j][-2] == "_" else names[j] for j in joints])
        is_hand = owner == "hand"
        self.hands = [np.flatnonzero(is_hand & (self.rest[:, 0] * sign > 0)) for sign in (1, -1)]
        own = np.isin(owner, BODY)
        self.body = self.triangles[own[self.triangles].all(1)]
        is_arm = np.isin(owner, ("forearm", "hand"))
        self.closed = self.triangles[~is_arm[self.triangles].any(1)]
        self.is_loose = np.zeros(len(self.body), bool)
        self.slot_of = slot[self.triangles[:, 0]]
        self._find_garment(owner, slot, [names[j] for j in joints])

    def _find_garment(self, owner, slot, bones):
        """Triangles of cloth that reach from one leg to the other."""
        rest, triangles = self.rest, self.triangles
        hip = self._rest_height("thigh_L")
        top = rest[triangles][..., 1].max(1)
        middle = (np.abs(rest[triangles][..., 0]) < .01).any(1) & (top < .80 * hip)
        cloth = {s for s in slot[triangles[middle][:, 0]] if s in ("top", "bottom")}
        self.garment, self.legs = np.zeros((0, 3), int), np.zeros((0, 2), int)
        if not cloth:
            return
        kind = cloth.pop()
        low = rest[triangles[middle]][..., 1].min()
        # Cloth that faces the legs is no surface that a hand could enter or a leg leave.
        self.body = self.body[~((slot[self.body[:, 0]] == kind) & self._faces_legs(self.body))]
        self.is_loose = (slot[self.body[:, 0]] == kind) & (rest[self.body][..., 1].max(1) < hip)
        is_tube = self._connected_to(middle & (slot[triangles[:, 0]] == kind))
        self.garment = triangles[is_tube & (slot[triangles[:, 0]] == kind) & (top < hip + .05)
                                 & ~self._faces_legs(triangles)]
        is_leg = np.isin(owner, ("thigh", "shin"))[triangles].all(1)
        own = triangles[is_leg & ~(is_tube & (slot[triangles[:, 0]] == kind))]
        edges = np.concatenate([own[:, [0, 0]], own[:, [0, 1]], own[:, [1, 2]], own[:, [2, 0]]])
        self.legs = edges[rest[edges][..., 1].mean(1) > low + .01]  # samples: their middles
        self.leg_bones = [bones[i] for i in self.legs[:, 0]]

    def _connected_to(self, chosen):
        """Triangles that hang together with chosen ones of the same slot; leggings under a skirt
        may have its slot and are apart."""
        _, place = np.unique(np.round(self.rest, 5), axis=0, return_inverse=True)
        corners, reached = place[self.triangles], np.zeros(len(place), bool)
        reached[corners[chosen]] = True
        same = self.slot_of == self.slot_of[np.argmax(chosen)]
        while True:
            hit = same & reached[corners].any(1)
            before = reached.sum()
            reached[corners[hit]] = True
            if reached.sum() == before:
                return hit

    def _faces_legs(self, triangles):
        corners = self.rest[triangles]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return _dot(normal, corners.mean(1) * (1, 0, 1)) < 0

    def _rest_height(self, name):
        i, height = self.template.index[name], 0.0
        while i is not None:
            height += self.template.nodes[i].get("translation", (0, 0, 0))[1]
            i = self.template.parent.get(i)
        return height

    def _inside(self, points, hand, triangles):
        """Deepest of the hand's points that really are inside: behind an open edge of the surface,
        such as a collar or a hem, is not."""
        depth = depths(points[:, hand], points[:, triangles])
        frame, own = np.nonzero(depth > SHALLOW)
        deepest = np.argsort(-depth[frame, own])
        for k in range(0, len(deepest), AT_ONCE):
            f, v = frame[deepest[k:k + AT_ONCE]], own[deepest[k:k + AT_ONCE]]
            turns = winding(points[f, hand[v]], points[f][:, self.closed])
            if (turns > .5).any():
                return float(depth[f, v][turns > .5][0])
        return 0.0

    def _leg_axes(self, world, frames, samples):
        """The spot of its own bone next to each sample of a leg; frames x samples x 3."""
        place = lambda name: joint(world, self.template, name)[frames]
        start = np.stack([place(n) for n in self.leg_bones], 1)
        bone = np.stack([place(AXIS[n[:-2]] + n[-2:]) for n in self.leg_bones], 1) - start
        share = _dot(samples - start, bone) / _dot(bone, bone)
        return start + np.clip(share, .05, .95)[..., None] * bone

    def penetration(self, world, frames):
        """Metres by what it is, worst of the frames: hands in the body, hands in the garment, legs
        out of it."""
        points = np.concatenate([self.template.deformed(p, world, frames) for p in self.skinned], 1)
        result = {"hand": 0.0, "hand in garment": 0.0, "leg": 0.0}
        for hand in self.hands:
            for name, own in (("hand", ~self.is_loose), ("hand in garment", self.is_loose)):
                if own.any():
                    result[name] = max(result[name],
                                       self._inside(points, hand, self.body[own]))
        if len(self.legs):
            samples = points[:, self.legs].mean(2)
            axes = self._leg_axes(world, frames, samples)
            result["leg"] = through(axes, samples, points[:, self.garment]).max(initial=0)
        return result
