# SPDX-License-Identifier: MIT
"""Walking and running in place. The stance foot moves back at the clip's speed, so it is planted
on the ground when the person moves forward with it."""
import math

from clips_standing import relaxed_elbow
from geometry import (FULL_TURN, hermite, lerp, periodic_curve, rot_x, rot_y, rot_z, smoothstep,
                      vec)
from skeleton import SIDES, LegTarget, Pose, hanging_arm

LARGEST_REACH = .988  # keeps the knee a little bent: a straight knee pops


class Gait:
    """Numbers of one way to move. stance: share of the cycle that a foot is on the ground."""

    def __init__(self, speed, frames, stance, middle, track, lift, bob, drop, pitch, sway=1.0):
        self.speed, self.frames, self.seconds = speed, frames, frames / 32
        self.stance, self.middle, self.track = stance, middle, track
        self.lift, self.bob, self.drop, self.pitch = lift, bob, drop, pitch
        self.sway = sway


# Pitch of the foot over the cycle in degrees: below 0 on the heel, above 0 on the ball.
WALK_PITCH = [(0, -17), (.04, -10), (.08, -3), (.12, 0), (.20, 0), (.29, 1), (.37, 4), (.45, 11),
              (.52, 24), (.60, 50), (.66, 54), (.74, 34), (.83, 4), (.91, -12), (.96, -16)]
STROLL_PITCH = [(phase, pitch * .72) for phase, pitch in WALK_PITCH]
RUN_PITCH = [(0, -4), (.05, 0), (.10, 0), (.15, 4), (.22, 18), (.30, 36), (.36, 50), (.46, 74),
             (.58, 66), (.72, 24), (.86, -8), (.94, -9)]


def _scaled(body, speed, frames, track, lift, bob, drop, rest, sway=1.0):
    """Numbers for an adult made fit for longer or shorter legs, and for less energy."""
    leg = body.hip[2] / (.855 if body.is_woman else .905)
    if body.skirt:
        speed *= .92  # shorter steps
    frames = 2 * round(frames * math.sqrt(leg / body.energy) / 2)
    return Gait(round(speed * math.sqrt(leg) * body.energy, 3), frames, rest[0], rest[1],
                track * body.hip[0] / (.090 if body.is_woman else .093), lift * leg, bob * leg,
                drop * leg, rest[2], sway)


def walk_gait(body):
    woman = body.is_woman
    return _scaled(body, 1.25, 32 if woman else 34, .045 if woman else .070, .035, .020, .012,
                   (.60, .265, WALK_PITCH))


def stroll_gait(body):
    """Slower, with more sway."""
    woman = body.is_woman
    return _scaled(body, .86, 38 if woman else 40, .052 if woman else .078, .030, .015, .010,
                   (.60, .265, STROLL_PITCH), 1.45)


def run_gait(body):
    """A long robe keeps the heels lower."""
    woman, is_long = body.is_woman, body.skirt and body.skirt.bottom_z < body.knee[2] - .2
    pitch = [(phase, p * .66) for phase, p in RUN_PITCH] if is_long else RUN_PITCH
    return _scaled(body, 2.5 if is_long else 2.9, 21 if woman else 22, .030 if woman else .045,
                   .05 if is_long else .10, .024, .045, (.36, .14, pitch))


class FootPath:
    """Where the ankle is over the cycle, with the pitch of foot and toes."""

    def __init__(self, body, gait, is_walk):
        self.gait, self.is_walk, self.foot = gait, is_walk, body.foot
        self.start_y = -.078 * body.foot - (0 if is_walk else .05)
        self.ball = vec(0, -.098 * body.foot - body.ankle[1], .018 - body.ankle[2])
        self.heel = vec(0, .058 * body.foot - body.ankle[1], -body.ankle[2])

    def turned_out(self, outwards, pitch):
        """What the ankle moves so that a foot turned outwards still rolls over its ball."""
        shift = lambda arm: arm - outwards @ arm
        return (shift(rot_x(pitch) @ self.ball) - shift(self.ball)) * vec(1, 1, 0)

    def at(self, phase):
        pitch = periodic_curve(phase, self.gait.pitch)
        if phase <= self.gait.stance:
            return self._on_ground(phase), pitch, min(pitch, 0.0)
        return self._in_air(phase, pitch)

    def _on_ground(self, phase):
        gait = self.gait
        pitch = periodic_curve(phase, gait.pitch)
        y = self.start_y + gait.speed * gait.seconds * (phase - gait.middle)
        if pitch < 0:
            return vec(0, y + self.heel[1] - self.ball[1], 0) - rot_x(pitch) @ self.heel
        return vec(0, y, .018) - rot_x(pitch) @ self.ball

    def _in_air(self, phase, pitch):
        stance, step = self.gait.stance, 1e-3
        length = 1 - stance
        u = (phase - stance) / length
        leave, land = self._on_ground(stance), self._on_ground(0)
        leave_slope = (leave - self._on_ground(stance - step)) / step * vec(1, 1, .6)
        land_slope = (self._on_ground(step) - land) / step * vec(1, .55, .3)
        ankle = hermite(leave, leave_slope * length, land, land_slope * length, u)
        if self.is_walk:
            ankle[2] += self.gait.lift * math.sin(math.pi * min(1, u * 1.05)) ** 2
        else:
            ankle[2] += self.gait.lift * math.sin(math.pi * u) ** 2 * 1.6
        toe = lerp(0, pitch, smoothstep(u, 0, .45))
        tip = ankle + rot_x(pitch) @ self.ball + rot_x(toe) @ vec(0, -.095 * self.foot, -.018)
        clearance = .014 * math.sin(math.pi * u)
        ankle[2] += max(0, clearance - tip[2])
        return ankle, pitch, toe


def gait_pose(body, bones, gait, is_walk, phase):
    pose = Pose(body, bones)
    _move_trunk(pose, gait, is_walk, phase)
    path = FootPath(body, gait, is_walk)
    for (side, sign), shift in zip(SIDES, (0, .5)):
        own = (phase + shift) % 1.0
        ankle, pitch, toe = path.at(own)
        outwards = rot_z(sign * (6 if is_walk else 3))
        ankle = ankle + path.turned_out(outwards, pitch) + vec(sign * gait.track, 0, 0)
        pose.legs[side] = LegTarget(ankle,
                                    outwards @ rot_x(pitch), outwards @ rot_x(toe),
                                    vec(sign * (.10 if not body.is_woman else .04), -1, .15))
        (_walking_arm if is_walk else _running_arm)(pose, side, sign, own)
    return pose


def _move_trunk(pose, gait, is_walk, phase):
    woman = pose.body.is_woman
    wave = lambda shift: math.cos(FULL_TURN * (phase + shift))
    twice = lambda shift: math.cos(2 * FULL_TURN * (phase + shift))
    rise = twice(-.29) if is_walk else -.8 * twice(-.16)
    pose.offset = vec((.020 if is_walk else .010) * wave(-.29 if is_walk else -.16),
                      (0 if is_walk else -.01) + .008 * math.sin(
                          2 * FULL_TURN * (phase - (.29 if is_walk else .16))),
                      0) * pose.body.size + vec(0, 0, gait.bob * rise - gait.drop)
    sway = gait.sway * (.5 + .5 * pose.body.energy)
    yaw = -(7 if woman else 5) * sway * wave(.02) if is_walk else -9 * wave(.05)
    roll = -(5.0 if woman else 3.5) * sway * wave(-.20) if is_walk else -4 * wave(-.14)
    lean = 2.0 if is_walk else 9
    twist = (4.5 if is_walk else 11) * wave(0)
    pose.local["hips"] = rot_z(yaw) @ rot_y(roll) @ rot_x(lean * .5 + twice(0))
    pose.local["spine"] = rot_z(-yaw * .5 + twist * .4) @ rot_y(-roll * .55) \
        @ rot_x(lean * .25 - .5)
    pose.local["chest"] = rot_z(-yaw * .5 + twist * .6) @ rot_y(-roll * .40) \
        @ rot_x(lean * .25 + twice(-.1))
    pose.local["neck"] = rot_z(-twist * .45) @ rot_x(-lean * .35)
    pose.local["head"] = rot_z(-twist * .45) @ rot_y(.8 * wave(-.25)) \
        @ rot_x(-lean * .4 - 1.2 * twice(-.05))


def _walking_arm(pose, side, sign, phase):
    swing = math.cos(FULL_TURN * (phase - .02)) * (.35 + .65 * pose.body.energy)
    bend = 13 + 18 * (.5 - .5 * math.cos(FULL_TURN * (phase - .06)))
    pose.local["shoulder_" + side] = rot_z(sign * 2.0 * swing)
    off = 150 * max(0, pose.body.belly - .02) + (4 if pose.body.skirt else 0) + pose.body.arms_off
    pose.local["upperarm_" + side] = hanging_arm(sign, 38 - off, 20 * swing + 5)
    pose.local["forearm_" + side] = relaxed_elbow(pose, sign) @ rot_z(sign * -6) @ rot_x(-bend)
    pose.local["hand_" + side] = rot_x(-4 - 5 * math.cos(FULL_TURN * (phase - .15)))


def _running_arm(pose, side, sign, phase):
    swing = math.cos(FULL_TURN * (phase - .02)) * (.35 + .65 * pose.body.energy)
    bend = 82 - 16 * math.cos(FULL_TURN * (phase - .05))
    pose.local["shoulder_" + side] = rot_z(sign * 5 * swing)
    pose.local["upperarm_" + side] = hanging_arm(sign, 34, 38 * swing + 4)
    pose.local["forearm_" + side] = rot_z(sign * -14) @ rot_x(-bend)
    pose.local["hand_" + side] = rot_x(-6)


def lower_until_legs_reach(body, bones, gait, is_walk):
    """Sinks the pelvis until no leg is stretched further than LARGEST_REACH."""
    for _ in range(60):
        reaches = [gait_pose(body, bones, gait, is_walk, i / gait.frames).solve().reach
                   for i in range(gait.frames)]
        if max(max(r["thigh_L"], r["thigh_R"]) for r in reaches) < LARGEST_REACH:
            return gait
        gait.drop += .002
    raise ValueError("the steps are too long for the legs")
