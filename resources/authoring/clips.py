# SPDX-License-Identifier: MIT
"""All clips of a person, sampled at 32 frames a second."""
import numpy as np

import clips_seated as seated
import clips_standing as standing
from clips_gait import gait_pose, lower_until_legs_reach, run_gait, stroll_gait, walk_gait

FRAMES_PER_SECOND = 32

# name, frames of an energetic person, pose; in the order of the files.
IN_PLACE = (
    ("idle", 160, standing.idle_pose), ("idle_2", 192, standing.idle_2_pose))
SEATED = (
    ("sit", 160, seated.sit_pose), ("sit_2", 192, seated.sit_2_pose),
    ("sit_clap", 64, seated.sit_clap_pose), ("sit_cheer", 64, seated.sit_cheer_pose))
MOODS = (
    ("clap", 64, standing.clap_pose), ("cheer", 32, standing.cheer_pose),
    ("wave", 64, standing.wave_pose), ("sad", 160, standing.sad_pose))
SEATED_MOODS = (("sit_sad", 160, seated.sit_sad_pose),)
MORE = (
    ("bored", 192, standing.bored_pose),)
SEATED_MORE = (("sit_bored", 192, seated.sit_bored_pose),)
GESTURES = (
    ("angry", 64, standing.angry_pose), ("talk", 128, standing.talk_pose),
    ("look_around", 192, standing.look_around_pose), ("dance", 128, standing.dance_pose),
    ("dance_2", 96, standing.dance_2_pose))
ONCE = (("sit_down", 56, seated.sitting_down_pose), ("stand_up", 56, seated.standing_up_pose))
SEATED_GESTURES = (
    ("sit_talk", 192, seated.sit_talk_pose), ("sit_look_around", 208, seated.sit_look_around_pose),
    ("sit_angry", 96, seated.sit_angry_pose), ("sit_wave", 80, seated.sit_wave_pose))

# Seated, and only where a brush or a rule asks for it.
NO_REST = ("sit_clap", "sit_cheer", "sit_sad", "sit_bored", "sit_angry", "sit_wave")


class Clip:
    """local[bone] and hips hold frames + 1 keys; in a loop the last equals the first."""

    def __init__(self, name, frames, extras):
        self.name, self.frames, self.extras = name, frames, extras
        self.local, self.hips, self.gather, self.poses = {}, [], [], []


def sample(name, frames, extras, bones, pose_at, loop=True):
    clip = Clip(name, frames, dict(extras, loop=loop))
    last = frames if loop else frames + 1
    clip.poses = [pose_at((i % last) / frames).solve() for i in range(frames + 1)]
    for bone_name, bone in bones.items():
        parent = lambda pose: pose.rotation[bone.parent] if bone.parent else np.eye(3)
        clip.local[bone_name] = [parent(pose).T @ pose.rotation[bone_name] for pose in clip.poses]
    clip.hips = [pose.position["hips"] for pose in clip.poses]
    clip.gather = [pose.gather for pose in clip.poses]
    return clip


class ClipMaker:
    def __init__(self, body, bones):
        self.body, self.bones = body, bones

    def gait(self, name, gait, is_walk):
        gait = lower_until_legs_reach(self.body, self.bones, gait, is_walk)
        return sample(name, gait.frames, {"speed": gait.speed}, self.bones,
                      lambda phase: gait_pose(self.body, self.bones, gait, is_walk, phase))

    def listed(self, items, extras, loop=True):
        """Calmer people take longer."""
        pace = 1 if self.body.energy == 1 else 1.15
        role = lambda name: {"role": "other"} if name in NO_REST else {}
        return [sample(name, 2 * round(frames * pace / 2),
                       {"speed": 0.0, **extras, **role(name)}, self.bones,
                       lambda phase, f=pose: f(self.body, self.bones, phase), loop)
                for name, frames, pose in items]


def make_clips(body, bones):
    make, sitting = ClipMaker(body, bones), {"seatHeight": seated.SEAT_HEIGHT}
    gaits = [make.gait("walk", walk_gait(body), True), make.gait("walk_2", stroll_gait(body), True),
             make.gait("run", run_gait(body), False)]
    return make.listed(IN_PLACE, {}) + gaits + make.listed(SEATED, sitting) \
        + make.listed(MOODS, {}) + make.listed(SEATED_MOODS, sitting) + make.listed(MORE, {}) \
        + make.listed(SEATED_MORE, sitting) + make.listed(GESTURES, {}) \
        + make.listed(ONCE, sitting, loop=False) + make.listed(SEATED_GESTURES, sitting)


def foot_slide(clip, bones):
    """Largest drift, in metres, of the ball of a flat foot against the moving ground."""
    worst, speed = 0.0, clip.extras["speed"]
    stance = (.12, .56) if clip.name.startswith("walk") else (.10, .33)
    for side, shift in (("L", 0.0), ("R", .5)):
        drift = []
        for i in range(clip.frames * 2):
            phase = i / clip.frames + shift - 1
            if stance[0] <= phase <= stance[1]:
                ball = clip.poses[i % clip.frames].position["toe_" + side]
                drift.append(ball[1] - speed * i / FRAMES_PER_SECOND)
        worst = max(worst, max(drift) - min(drift))
    return worst
