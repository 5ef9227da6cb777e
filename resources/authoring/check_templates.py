#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Reads every built-in template and measures what an artist would notice (plain NumPy, no Blender).

usage: check_templates.py [--step N] [NAME ...]     N: look at every Nth keyframe for penetration

Prints a line of figures per template and a line per fault; exits with 1 when there is a fault."""
import argparse
import glob
import os
import sys

import numpy as np

from baked import FRAMES_PER_SECOND, BakedTemplate

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "templates")
PEOPLE_CLIPS = ("idle idle_2 walk walk_2 run sit sit_2 sit_clap sit_cheer clap cheer wave sad "
                "sit_sad bored sit_bored angry talk look_around dance dance_2 sit_down stand_up "
                ).split()
ANIMAL_CLIPS = ["idle", "walk", "run"]
PEOPLE_SLOTS = {"skin", "hair", "top", "shoes"}  # a dress has no lower half of its own
LEVELS = ((900, 1350), (480, 700), (240, 360), (70, 140))
MOST_SLIDE, MOST_SEAM, MOST_HAND, MOST_LEG = .002, .0005, .020, .010
MOST_KNEE = 600.0  # rad/s2; a straight knee that snaps has several thousand
# In the hollow of the knee, hidden from sight while she sits.
LEG_OF = {"matron": .033}
NEAR = .15
HEIGHT_METRES = (.02, 6.0)


def kind_of(template):
    if "thigh_L" in template.index:
        return "person"
    return "animal" if template.is_skinned() else "machine"


def joint(world, template, name):
    return world[template.index[name]][:, :3, 3]


def foot_slide(template, world, speed):
    """Largest drift of the ball of a foot while it lies on the ground, in metres."""
    worst = 0.0
    for name in ("toe_L", "toe_R"):
        ball = joint(world, template, name)[:-1]
        down = ball[:, 1] < ball[:, 1].min() + .0003
        start = int(np.argmin(down))  # in the air, so that no stance is cut in two
        order = (np.arange(len(ball)) + start) % len(ball)
        drift = ball[order] + np.outer(np.arange(len(ball)) / FRAMES_PER_SECOND, (0, 0, speed))
        for run in np.split(np.arange(len(ball)), np.flatnonzero(np.diff(down[order])) + 1):
            if down[order[run[0]]] and len(run) > 1:
                worst = max(worst, float(np.ptp(drift[run][:, [0, 2]], axis=0).max()))
    return worst


def knee_acceleration(template, world, loops):
    """Largest angular acceleration of a knee, in rad/s2."""
    worst = 0.0
    for side in "LR":
        hip, knee, ankle = (joint(world, template, f"{name}_{side}")
                            for name in ("thigh", "shin", "foot"))
        a, b = hip - knee, ankle - knee
        angle = np.arccos(np.clip((a * b).sum(1) / np.linalg.norm(a, axis=1)
                                  / np.linalg.norm(b, axis=1), -1, 1))
        angle = np.concatenate([angle[-2:-1], angle, angle[1:2]]) if loops else angle
        worst = max(worst, float(np.abs(np.diff(angle, 2)).max()) * FRAMES_PER_SECOND ** 2)
    return worst


def signed_distance(points, corners, normals):
    """Distance of P points from T triangles, negative behind the nearest one, and
    the index of that one."""
    a, ab, ac = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    ap = points[:, None] - a
    d00, d01, d11 = (ab * ab).sum(1), (ab * ac).sum(1), (ac * ac).sum(1)
    d20, d21 = np.einsum("pti,ti->pt", ap, ab), np.einsum("pti,ti->pt", ap, ac)
    area = np.maximum(d00 * d11 - d01 * d01, 1e-14)
    v, w = (d11 * d20 - d01 * d21) / area, (d00 * d21 - d01 * d20) / area
    candidates = []
    for s, t, ok in ((v, w, (v >= 0) & (w >= 0) & (v + w <= 1)),
                     (np.clip(d20 / d00, 0, 1), 0 * v, True),
                     (0 * v, np.clip(d21 / d11, 0, 1), True)):
        candidates.append((s, t, ok))
    bc = ac - ab
    along = np.clip(np.einsum("pti,ti->pt", ap - ab, bc) / (bc * bc).sum(1), 0, 1)
    candidates.append((1 - along, along, True))
    best, offset = np.full(v.shape, np.inf), None
    side = np.zeros(v.shape)
    for s, t, ok in candidates:
        offset = ap - s[..., None] * ab - t[..., None] * ac
        distance = np.where(ok, (offset * offset).sum(2), np.inf)
        closer = distance < best
        best = np.where(closer, distance, best)
        side = np.where(closer, np.einsum("pti,ti->pt", offset, normals), side)
    near = best <= best.min(1, keepdims=True) + 1e-9
    behind = np.where(near, side, 0)
    sign = np.sign(np.take_along_axis(behind, np.abs(behind).argmax(1)[:, None], 1)[:, 0])
    return np.sqrt(best.min(1)) * sign, best.argmin(1)


def through(inner, outer, corners):
    """How far the lines from inner to outer points go on behind the triangles that they cross."""
    a, ab, ac = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    ray = outer - inner
    p = np.cross(ray[:, None], ac[None])
    determinant = (p * ab).sum(2)
    determinant = np.where(np.abs(determinant) < 1e-12, 1e-12, determinant)
    offset = inner[:, None] - a
    q = np.cross(offset, ab[None])
    u, v = (offset * p).sum(2) / determinant, np.einsum("pi,pti->pt", ray, q) / determinant
    t = (q * ac).sum(2) / determinant
    crosses = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 0) & (t < 1)
    beyond = np.where(crosses, (1 - t) * np.linalg.norm(ray, axis=1)[:, None], 0)
    return float(beyond.max(initial=0))


def distances(points, corners, is_loose):
    """Signed distances of those points that are within NEAR of the triangles, next to no loose
    one."""
    low, high = points.min(0) - NEAR, points.max(0) + NEAR
    is_near = (corners.max(1) > low).all(1) & (corners.min(1) < high).all(1)
    corners, is_loose = corners[is_near], is_loose[is_near]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normals, axis=1)
    flat = length > 1e-10
    if not flat.any():
        return np.zeros(0)
    distance, nearest = signed_distance(points, corners[flat], normals[flat] / length[flat, None])
    return distance[(np.abs(distance) < NEAR) & ~is_loose[flat][nearest]]


class Surfaces:
    """Which vertices are hands, legs, trunk and garment of a person."""

    def __init__(self, template):
        self.template = template
        skinned = [p for p in template.primitives if p.joints is not None]
        self.skinned = skinned
        offsets = np.cumsum([0] + [len(p.positions) for p in skinned])
        self.rest = np.concatenate([p.positions for p in skinned])
        self.triangles = np.concatenate([p.triangles + o for p, o in zip(skinned, offsets)])
        slot = np.concatenate([np.full(len(p.positions), p.slot, object) for p in skinned])
        names = [template.nodes[j]["name"] for j in template.joints]
        joints = np.concatenate([p.joints[:, 0] for p in skinned])
        owner = np.array([names[j][:-2] if names[j][-2] == "_" else names[j] for j in joints])
        hands = owner == "hand"
        self.hands = [np.flatnonzero(hands & (self.rest[:, 0] * sign > 0)) for sign in (1, -1)]
        own = np.isin(owner, ("hips", "spine", "chest", "thigh", "shin"))
        self.solid = self.triangles[own[self.triangles].all(1)]
        self.is_loose = np.zeros(len(self.solid), bool)  # cloth that gives way under a hand
        self._find_garment(owner, slot, [names[j] for j in joints])

    def _find_garment(self, owner, slot, bones):
        """A garment over the legs: triangles that reach from one leg to the other."""
        sides = self.rest[self.triangles][..., 0]
        hip = self.rest_height("thigh_L")
        top = self.rest[self.triangles][..., 1].max(1)
        middle = (np.abs(sides) < .01).any(1) & (top < .80 * hip)
        cloth = {s for s in slot[self.triangles[middle][:, 0]] if s in ("top", "bottom")}
        self.garment, self.legs = np.zeros((0, 3), int), np.zeros((0, 2), int)
        if not cloth or not middle.any():
            return
        kind = cloth.pop()
        low = self.rest[self.triangles[middle]][..., 1].min()
        self.is_loose = (slot[self.solid[:, 0]] == kind) \
            & (self.rest[self.solid][..., 1].max(1) < hip)
        in_cloth = (slot[self.triangles[:, 0]] == kind) \
            & (self.rest[self.triangles][..., 1].max(1) < hip + .05)
        self.garment = self.triangles[in_cloth]
        is_leg = (slot != kind) & np.isin(owner, ("thigh", "shin"))
        own = self.triangles[is_leg[self.triangles].all(1)]
        edges = np.concatenate([own[:, [0, 0]], own[:, [0, 1]], own[:, [1, 2]], own[:, [2, 0]]])
        self.legs = edges[self.rest[edges][..., 1].mean(1) > low + .01]  # samples: their middles
        self.leg_bones = [bones[i] for i in self.legs[:, 0]]

    def rest_height(self, name):
        i, height = self.template.index[name], 0.0
        while True:
            height += self.template.nodes[i].get("translation", (0, 0, 0))[1]
            if i not in self.template.parent:
                return height
            i = self.template.parent[i]

    def _leg_axes(self, world, frames, points):
        """The point of its own bone next to each sample of a leg; frames x samples x 3."""
        if not len(self.legs):
            return points
        place = lambda name: joint(world, self.template, name)[frames]
        below = {"thigh": "shin", "shin": "foot"}
        start = np.stack([place(n) for n in self.leg_bones], 1)
        end = np.stack([place(below[n[:-2]] + n[-2:]) for n in self.leg_bones], 1)
        sample, bone = points[:, self.legs].mean(2), end - start
        share = ((sample - start) * bone).sum(2) / (bone * bone).sum(2)
        return start + np.clip(share, .05, .95)[..., None] * bone

    def penetration(self, world, frames):
        """(hands in the body, legs out of the garment), in metres, worst of the frames."""
        points = np.concatenate([self.template.deformed(p, world, frames) for p in self.skinned], 1)
        hand, leg = 0.0, 0.0
        axes = self._leg_axes(world, frames, points)
        for k, frame in enumerate(points):
            for hand_vertices in self.hands:
                hand = max(hand, -distances(
                    frame[hand_vertices], frame[self.solid], self.is_loose).min(initial=0))
            if len(self.legs):
                leg = max(leg, through(axes[k], frame[self.legs].mean(1), frame[self.garment]))
        return hand, leg


class Report:
    def __init__(self, name):
        self.name, self.faults, self.figures = name, [], {}

    def demand(self, is_right, text):
        if not is_right:
            self.faults.append(f"{self.name}: {text}")

    def largest(self, figure, value, clip, limit):
        if value > self.figures.get(figure, (-1, ""))[0]:
            self.figures[figure] = value, clip
        self.demand(value <= limit, f"{figure} {value:.4f} in {clip}, at most {limit}")


def check_clips(template, report, step):
    kind = kind_of(template)
    surfaces = Surfaces(template) if kind == "person" else None
    for clip, animation in template.clips.items():
        extras, world = animation["extras"], template.globals(clip)
        if extras["loop"]:
            seam = max(np.abs(m[0] - m[-1]).max() for m in world.values())
            report.largest("seam", seam, clip, MOST_SEAM)
        check_bounds(template, report, clip, world)
        if kind != "person":
            continue
        if extras["speed"] > 0:
            report.largest("slide", foot_slide(template, world, extras["speed"]), clip, MOST_SLIDE)
        report.largest("knee", knee_acceleration(template, world, extras["loop"]), clip, MOST_KNEE)
        hand, leg = surfaces.penetration(world, np.arange(0, template.keyframes(clip), step))
        report.largest("hand", hand, clip, MOST_HAND)
        report.largest("leg", leg, clip, LEG_OF.get(report.name, MOST_LEG))


def check_bounds(template, report, clip, world):
    frames = np.arange(0, template.keyframes(clip), 16)
    low = min(template.deformed(p, world, frames)[..., 1].min() for p in template.primitives)
    high = max(template.deformed(p, world, frames)[..., 1].max() for p in template.primitives)
    report.demand(HEIGHT_METRES[0] < high < HEIGHT_METRES[1], f"{clip} is {high:.2f} m high")
    report.demand(low > -.03, f"{clip} reaches {-low:.3f} m into the ground")


def check(path, step):
    template, report = BakedTemplate(path), Report(os.path.basename(path)[:-4])
    kind, counts = kind_of(template), template.triangles_per_level()
    for level, (count, (low, high)) in enumerate(zip(counts, LEVELS)):
        report.demand(low <= count <= high or (kind != "person" and 0 < count <= LEVELS[0][1]),
                      f"level {level} has {count} triangles, not {low} to {high}")
    if kind == "person":
        report.demand(PEOPLE_SLOTS <= template.slots(), f"slots {sorted(template.slots())}")
    wanted = {"person": PEOPLE_CLIPS, "animal": ANIMAL_CLIPS, "machine": ["idle"]}[kind]
    missing = [c for c in wanted if c not in template.clips]
    report.demand(not missing, f"clips {missing} are missing")
    check_clips(template, report, step)
    figures = ", ".join(f"{k} {v:.4f} ({c})" for k, (v, c) in report.figures.items())
    print(f"{report.name}: triangles {counts}, {len(template.clips)} clips; {figures}", flush=True)
    return report.faults


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--step", type=int, default=4)
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    paths = sorted(glob.glob(os.path.join(TEMPLATES, "*.glb")))
    paths = [p for p in paths if not options.names or os.path.basename(p)[:-4] in options.names]
    faults = [fault for path in paths for fault in check(path, options.step)]
    print("\n".join(faults))
    return 1 if faults or not paths else 0


if __name__ == "__main__":
    sys.exit(main())
