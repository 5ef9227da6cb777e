# SPDX-License-Identifier: MIT
"""What a clip does to feet, knees and its own seam (plain NumPy; glTF's frame)."""
import numpy as np

from baked import FRAMES_PER_SECOND

ON_GROUND = .0003  # metres above the lowest place of a foot
BALLS = ("toe_L", "toe_R", "fore_foot_L", "fore_foot_R", "hind_foot_L", "hind_foot_R",
         *(f"leg{k}_foot_{side}" for k in range(3) for side in "LR"))


def joint(world, template, name):
    return world[template.index[name]][:, :3, 3]


def balls(template):
    return [name for name in BALLS if name in template.index]


def foot_slide(template, world, speed):
    """Largest drift of a foot while it lies on the ground, in metres."""
    worst = 0.0
    for name in balls(template):
        ball = joint(world, template, name)[:-1]
        down = ball[:, 1] < ball[:, 1].min() + ON_GROUND
        start = int(np.argmin(down))  # in the air, so that no stance is cut in two
        order = (np.arange(len(ball)) + start) % len(ball)
        drift = ball[order] + np.outer(np.arange(len(ball)) / FRAMES_PER_SECOND, (0, 0, speed))
        for run in np.split(np.arange(len(ball)), np.flatnonzero(np.diff(down[order])) + 1):
            if down[order[run[0]]] and len(run) > 1:
                worst = max(worst, float(np.ptp(drift[run][:, [0, 2]], axis=0).max()))
    return worst


def knee_acceleration(template, world, loops):
    """Largest angular acceleration of a knee, in rad/s2; over the seam of a loop as well."""
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


def seam(world):
    """Largest difference between the first and the last keyframe, in metres and parts of one."""
    return max(np.abs(m[0] - m[-1]).max() for m in world.values())


def jerk(world):
    """How much more the joints' speed changes over the seam of a loop than anywhere else in the
    clip, in m/s: 0 for a movement that goes on as it was."""
    places = np.stack([m[:-1, :3, 3] for m in world.values()], 1)
    speed = (np.roll(places, -1, axis=0) - places) * FRAMES_PER_SECOND
    change = np.linalg.norm(speed - np.roll(speed, 1, axis=0), axis=2).max(1)
    return max(0.0, float(change[0] - change[1:].max()))
