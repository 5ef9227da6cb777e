# SPDX-License-Identifier: MIT
"""Clips that stay on the spot: idle, cheer, and the seated ones.

Seated clips: the origin lies on the ground between the ankles; the pelvis is SEAT_BACK behind it
and the seat plane SEAT_HEIGHT above it."""
import math

from geometry import FULL_TURN, lerp, periodic_curve, rot_x, rot_y, rot_z, smoothstep, unit, vec
from skeleton import SIDES, ArmTarget, Pose, hanging_arm, plant_foot

SEAT_HEIGHT = .44
SEAT_BACK = .40
HIP_ABOVE_SEAT = .100


def sine(phase, shift=0.0, times=1):
    return math.sin(times * FULL_TURN * phase + shift)


def idle_pose(body, bones, phase):
    """Breathing twice, a slow shift of weight, looking around."""
    pose = Pose(body, bones)
    shift, breath = sine(phase), sine(phase, times=2)
    roll = -(3.6 if body.is_woman else 2.6) * shift
    pose.offset = vec(.022 * shift + .004, .004 * sine(phase, .7), -.004 - .0025 * shift ** 2)
    pose.local.update({
        "hips": rot_y(roll) @ rot_z(1.8 * sine(phase, .5)),
        "spine": rot_y(-roll * .7) @ rot_x(-.6 + .8 * breath),
        "chest": rot_y(-roll * .5) @ rot_x(-1.2 * breath) @ rot_z(-1.5 * sine(phase, .3)),
        "neck": rot_x(1 + .5 * breath) @ rot_z(3 * sine(phase, 1.6)),
        "head": rot_z(7 * sine(phase, 1.9) + 2.5 * sine(phase, .4, 2))
        @ rot_x(1.5 + 1.2 * sine(phase, 1, 2)) @ rot_y(roll * .3)})
    for side, sign in SIDES:
        plant_foot(pose, side, sign, body.ankle[0] * (.95 if body.is_woman else 1.05),
                   -.010 * sign, 11)
        pose.local["shoulder_" + side] = rot_y(sign * (1.0 - 1.4 * breath))
        pose.local["upperarm_" + side] = hanging_arm(sign, 40 - 1.2 * breath,
                                                     2 + 1.5 * sine(phase, sign))
        pose.local["forearm_" + side] = rot_z(sign * -8) \
            @ rot_x(-13 - 2.5 * sine(phase, sign * 1.2))
        pose.local["hand_" + side] = rot_x(-5) @ rot_y(sign * 3)
    return pose


def raise_arm(pose, side, sign, up, sway=0.0, outwards=0.0):
    """Arm bent at 0, overhead at 1; the shoulder girdle takes its share of the lift."""
    pose.local["shoulder_" + side] = rot_y(sign * -26 * up)
    pose.local["upperarm_" + side] = rot_x(-14 * up) \
        @ rot_y(sign * (-(pose.body.arm_angle - 6) - 32 * up + outwards)) @ rot_z(sign * 12)
    pose.local["forearm_" + side] = rot_y(sign * (-70 * (1 - up) - 16 - sway)) @ rot_z(sign * 14)
    pose.local["hand_" + side] = rot_y(sign * (-8 + sway))


def cheer_pose(body, bones, phase):
    """Crouch, jump, land; both arms pump."""
    pose = Pose(body, bones)
    height = periodic_curve(phase, [(0, -.055), (.12, -.085), (.26, .015), (.38, .100),
                                    (.50, .105), (.62, .020), (.74, -.085), (.88, -.060)])
    up = periodic_curve(phase, [(0, .62), (.14, .50), (.32, .95), (.46, 1.0), (.62, .92),
                                (.78, .66), (.9, .60)])
    crouch = max(0, -height) / .085
    pose.offset = vec(.008 * sine(phase), .012 - .02 * up, height - .012)
    pose.local.update({
        "hips": rot_x(8 * crouch - 3 * up) @ rot_z(3 * sine(phase)),
        "spine": rot_x(5 * crouch - 4 * up),
        "chest": rot_x(3 * crouch - 6 * up) @ rot_z(-3 * sine(phase)),
        "neck": rot_x(-4 * up),
        "head": rot_x(-9 * up + 2 * crouch) @ rot_y(3 * sine(phase))})
    for side, sign in SIDES:
        plant_foot(pose, side, sign, body.ankle[0] * 1.25, 0, 12, lift=max(0, height - .028),
                   heel=34 * smoothstep(height, -.01, .07))
        own = min(1.05, up + .06 * sine(phase, 0 if side == "L" else 1.2))
        raise_arm(pose, side, sign, own, 10 * sine(phase))
    return pose


def seated_trunk(body, bones, phase, lean, nod):
    """Legs and trunk that all seated clips share."""
    pose = Pose(body, bones)
    sway, breath = sine(phase), sine(phase, times=2)
    pose.offset = vec(.004 * sway, SEAT_BACK - body.hip[1],
                      SEAT_HEIGHT + HIP_ABOVE_SEAT - body.hip[2])
    pose.local.update({
        "hips": rot_x(-9 + .6 * sway) @ rot_z(1.2 * sway),
        "spine": rot_x(8 + lean + 1.0 * breath) @ rot_z(-1 * sway),
        "chest": rot_x(6 + lean - 1.4 * breath) @ rot_z(-2 * sine(phase, .6)),
        "neck": rot_x(-1 - lean * .5) @ rot_z(5 * sine(phase, 1.1)),
        "head": rot_x(-3 - lean + nod) @ rot_z(9 * sine(phase, 1.5))})
    for side, sign in SIDES:
        plant_foot(pose, side, sign, body.hip[0] * (1.0 if body.is_woman else 1.35),
                   -body.ankle[1] - .012 * sign, 5 if body.is_woman else 10,
                   vec(sign * (.04 if body.is_woman else .12), -1, 1))
    return pose.solve()


def sit_pose(body, bones, phase):
    """Hands on the thighs, breathing, looking around."""
    pose = seated_trunk(body, bones, phase, 0, 1.5 * sine(phase, .8, 2))
    for side, sign in SIDES:
        knee, hip = pose.position["shin_" + side], pose.position["thigh_" + side]
        wrist = hip + (knee - hip) * .58 + vec(sign * .010, 0, .108 * body.leg_girth
                                               + .002 * sine(phase, times=2))
        pose.arms[side] = ArmTarget(wrist, unit(knee - hip) + vec(-sign * .30, 0, -.10),
                                    vec(0, -.1, -1), vec(sign * .85, .55, -.25))
    return pose


def sit_clap_pose(body, bones, phase):
    """Four claps in the clip, leaning forward a little."""
    beat = (.5 + .5 * math.cos(4 * FULL_TURN * phase)) ** 1.6
    pose = seated_trunk(body, bones, phase, 3 + .6 * beat, 1.5 * beat)
    chest = pose.position["chest"]
    for side, sign in SIDES:
        wrist = vec(sign * lerp(.135, .024, beat), chest[1] - .29 - .01 * sine(phase),
                    chest[2] + .075 + .01 * sine(phase, 1) - .012 * sign)
        pose.arms[side] = ArmTarget(wrist, vec(sign * .16 * (1 - beat), -.75, .65),
                                    vec(-sign, 0, 0), vec(sign * .75, .35, -.8))
    return pose


def sit_cheer_pose(body, bones, phase):
    """Arms thrown up twice in the clip, the left a little ahead of the right."""
    lift = .5 - .5 * math.cos(2 * FULL_TURN * phase)
    pose = seated_trunk(body, bones, phase, 2 - 5 * lift, -5 * lift)
    pose.local["chest"] = pose.local["chest"] @ rot_y(3 * sine(phase))
    for side, sign in SIDES:
        own = .5 - .5 * math.cos(2 * FULL_TURN * phase + (.35 if side == "L" else 0))
        raise_arm(pose, side, sign, .58 + .42 * own, 10 * sine(phase, sign, 2))
    return pose
