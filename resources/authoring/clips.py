# SPDX-License-Identifier: MIT
"""All clips of a person, sampled at 32 frames a second."""
import numpy as np

from clips_gait import gait_pose, lower_until_legs_reach, run_gait, walk_gait
from clips_in_place import (SEAT_HEIGHT, cheer_pose, idle_pose, sit_cheer_pose, sit_clap_pose,
                            sit_pose)

FRAMES_PER_SECOND = 32


class Clip:
    """local[bone] and hips hold frames + 1 keys; the last equals the first."""

    def __init__(self, name, frames, extras):
        self.name, self.frames, self.extras = name, frames, extras
        self.local, self.hips, self.poses = {}, [], []


def sample(name, frames, extras, bones, pose_at):
    clip = Clip(name, frames, dict(extras, loop=True))
    clip.poses = [pose_at((i % frames) / frames).solve() for i in range(frames + 1)]
    for bone_name, bone in bones.items():
        parent = lambda pose: pose.rotation[bone.parent] if bone.parent else np.eye(3)
        clip.local[bone_name] = [parent(pose).T @ pose.rotation[bone_name] for pose in clip.poses]
    clip.hips = [pose.position["hips"] for pose in clip.poses]
    return clip


def make_clips(body, bones):
    walk = lower_until_legs_reach(body, bones, walk_gait(body), True)
    run = lower_until_legs_reach(body, bones, run_gait(body), False)
    seated = {"speed": 0.0, "seatHeight": SEAT_HEIGHT}
    still = {"speed": 0.0}
    at = lambda function: lambda phase: function(body, bones, phase)
    return [
        sample("idle", 160, still, bones, at(idle_pose)),
        sample("walk", walk.frames, {"speed": walk.speed}, bones,
               lambda phase: gait_pose(body, bones, walk, True, phase)),
        sample("run", run.frames, {"speed": run.speed}, bones,
               lambda phase: gait_pose(body, bones, run, False, phase)),
        sample("sit", 160, seated, bones, at(sit_pose)),
        sample("sit_clap", 64, seated, bones, at(sit_clap_pose)),
        sample("sit_cheer", 64, seated, bones, at(sit_cheer_pose)),
        sample("cheer", 32, still, bones, at(cheer_pose)),
    ]


def foot_slide(clip, bones):
    """Largest drift, in metres, of the ball of a flat foot against the moving ground."""
    worst, speed = 0.0, clip.extras["speed"]
    stance = (.12, .56) if clip.name == "walk" else (.10, .33)
    for side, shift in (("L", 0.0), ("R", .5)):
        drift = []
        for i in range(clip.frames * 2):
            phase = i / clip.frames + shift - 1
            if stance[0] <= phase <= stance[1]:
                ball = clip.poses[i % clip.frames].position["toe_" + side]
                drift.append(ball[1] - speed * i / FRAMES_PER_SECOND)
        worst = max(worst, max(drift) - min(drift))
    return worst
