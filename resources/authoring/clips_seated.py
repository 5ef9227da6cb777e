# SPDX-License-Identifier: MIT
"""Seated clips, and sitting down and standing up.

The origin lies on the ground between the ankles; the pelvis is SEAT_BACK behind it and the seat
plane SEAT_HEIGHT above it. Whose legs are too short for the seat lets them dangle."""
import math

import numpy as np

from body_skirt import is_gathered
from clips_standing import beat, clap_hands, hang, in_chest, raise_arm, sine, standing, turned
from geometry import (FULL_TURN, lerp, periodic_curve, rot_x, rot_y, rot_z, smoothstep, unit, vec)
from skeleton import SIDES, ArmTarget, LegTarget, Pose, plant_foot

SEAT_HEIGHT = .44
SEAT_BACK = .40


def hip_height(body):
    return SEAT_HEIGHT + .102 * body.leg_girth


def seat_offset(body):
    return vec(0, SEAT_BACK - body.hip[1], hip_height(body) - body.hip[2])


def _bone_lengths(body):
    return np.linalg.norm(body.hip - body.knee), np.linalg.norm(body.knee - body.ankle)


def dangles(body):
    return hip_height(body) - _bone_lengths(body)[1] > body.ankle[2] + .06


def place_feet(pose, phase):
    body = pose.body
    for side, sign in SIDES:
        x = body.hip[0] * (1.0 if body.is_woman else 1.35)
        if dangles(body):
            thigh, shin = _bone_lengths(body)
            swing = sine(phase, 0 if sign > 0 else 2.2, 2)
            pose.legs[side] = LegTarget(
                vec(sign * x, SEAT_BACK - thigh * .96 + .030 - .035 * swing,
                    hip_height(body) - shin * .95 + .010 * swing * swing),
                rot_z(sign * 5) @ rot_x(14 - 6 * swing), rot_z(sign * 5) @ rot_x(14 - 6 * swing),
                vec(sign * .04, -1, .6))
        else:
            plant_foot(pose, side, sign, x, -body.ankle[1] - .012 * sign,
                       5 if body.is_woman else 10,
                       vec(sign * (.04 if body.is_woman else .12), -1, 1))


def seated_trunk(body, bones, phase, lean, nod, look=9.0):
    """Legs and trunk that all seated clips share."""
    pose = Pose(body, bones)
    sway, breath = sine(phase), sine(phase, times=2)
    pose.offset, pose.gather = seat_offset(body) + vec(.004 * sway, 0, 0), 1.0
    pose.local.update({
        "hips": rot_x(-9 + .6 * sway) @ rot_z(1.2 * sway),
        "spine": rot_x(8 + lean + 1.0 * breath) @ rot_z(-1 * sway),
        "chest": rot_x(6 + lean - 1.4 * breath) @ rot_z(-2 * sine(phase, .6)),
        "neck": rot_x(-1 - lean * .5) @ rot_z(look * .55 * sine(phase, 1.1)),
        "head": rot_x(-3 - lean + nod) @ rot_z(look * sine(phase, 1.5))})
    place_feet(pose, phase)
    return pose.solve()


def hand_on_thigh(pose, phase, side, sign, share=.58, inwards=0.0):
    body = pose.body
    knee, hip = pose.position["shin_" + side], pose.position["thigh_" + side]
    above = .108 * body.leg_girth
    if body.skirt:
        above = body.trunk["hem"].front + .6 * body.skirt.front \
            + (.012 if is_gathered(body) else .044)
    wrist = hip + (knee - hip) * share + vec(sign * (.010 - inwards), 0,
                                             above + .002 * sine(phase, times=2))
    return ArmTarget(wrist, unit(knee - hip) + vec(-sign * .30, 0, -.10), vec(0, -.1, -1),
                     vec(sign * .85, .55, -.25))


def sit_pose(body, bones, phase):
    """Hands on the thighs, breathing, looking around."""
    pose = seated_trunk(body, bones, phase, 0, 1.5 * sine(phase, .8, 2))
    for side, sign in SIDES:
        pose.arms[side] = hand_on_thigh(pose, phase, side, sign)
    return pose


def sit_2_pose(body, bones, phase):
    """Leaning forward, forearms on the thighs, hands between the knees."""
    pose = seated_trunk(body, bones, phase, 13 - body.stoop * .5, 2 + 2 * sine(phase, .3, 2), 12)
    for side, sign in SIDES:
        knee = pose.position["shin_" + side]
        above = .075
        if body.skirt:
            above = (body.trunk["hem"].front + .6 * body.skirt.front
                     + (.055 if is_gathered(body) else .085)) / body.size
        wrist = vec(sign * (.062 + .003 * sign) * body.size, knee[1] + .035 * body.size,
                    knee[2] + (above + .003 * sine(phase, times=2)) * body.size)
        pose.arms[side] = ArmTarget(wrist, vec(-sign * .50, -.80, -.28), vec(-sign * .55, .1, -.6),
                                    vec(sign * .9, .25, -.45))
    return pose


def sit_clap_pose(body, bones, phase):
    """Four claps in the clip, leaning forward a little."""
    closing = (.5 + .5 * math.cos(4 * FULL_TURN * phase)) ** 1.6
    pose = seated_trunk(body, bones, phase, 3 + .6 * closing, 1.5 * closing)
    return clap_hands(pose, phase, 4)


def sit_cheer_pose(body, bones, phase):
    """Arms thrown up twice in the clip, the left a little ahead of the right."""
    lift = .5 - .5 * math.cos(2 * FULL_TURN * phase)
    pose = seated_trunk(body, bones, phase, 2 - 5 * lift, -5 * lift)
    pose.local["chest"] = pose.local["chest"] @ rot_y(3 * sine(phase))
    reach = 1 if body.energy == 1 else .82
    for side, sign in SIDES:
        own = .5 - .5 * math.cos(2 * FULL_TURN * phase + (.35 if side == "L" else 0))
        raise_arm(pose, side, sign, (.58 + .42 * own) * reach, 10 * sine(phase, sign, 2))
    return pose


def sit_sad_pose(body, bones, phase):
    """Bent over, head down, hands in the lap."""
    pose = seated_trunk(body, bones, phase, 9 - body.stoop * .3, 0, 4)
    pose.local["neck"] = rot_x(5) @ rot_z(3 * sine(phase, .2, 2))
    pose.local["head"] = rot_x(6 + 2 * sine(phase, 1)) @ rot_z(5 * sine(phase, 0, 2))
    pose.solve()
    for side, sign in SIDES:
        pose.arms[side] = hand_on_thigh(pose, phase, side, sign, .62, .035 * body.size)
    return pose


def sit_bored_pose(body, bones, phase):
    """The chin in the right hand, the left one on the thigh."""
    pose = seated_trunk(body, bones, phase, 10 - body.stoop * .4, 4, 3)
    pose.local["chest"] = pose.local["chest"] @ rot_y(4)
    pose.local["head"] = pose.local["head"] @ rot_y(7 + 1.5 * sine(phase, 0, 2))
    pose.solve()
    size, head = body.head.size, pose.position["head"]
    chin = head + pose.rotation["head"] @ vec(-.22, -.51 if body.size < .8 else -.48, -.52) * size
    pose.arms["R"] = ArmTarget(chin, vec(-.05, .05, 1), vec(.8, .5, 0), vec(-.35, -.45, -1))
    pose.arms["L"] = hand_on_thigh(pose, phase, "L", 1)
    return pose


def sit_talk_pose(body, bones, phase):
    """Turned to the neighbour at the left: nods, then explains with the right hand, with a glance
    ahead for the word that does not come."""
    talking = smoothstep(phase, .14, .27) - smoothstep(phase, .76, .91)
    turn = 1 - .55 * (smoothstep(phase, .43, .50) - smoothstep(phase, .57, .66))
    nod, stress = (1 - talking) * (1 - beat(phase, 11)), talking * sine(phase, .4, 9)
    pose = seated_trunk(body, bones, phase, 1 + 1.5 * talking, 0, 2)
    turned(pose, "spine", rot_z(7 * turn) @ rot_y(2))
    turned(pose, "chest", rot_z(10 * turn + 1.5 * talking * sine(phase, 0, 4)))
    turned(pose, "neck", rot_z(13 * turn) @ rot_x(1.5 * nod))
    turned(pose, "head", rot_z(20 * turn) @ rot_y(3 + 2.5 * talking * sine(phase, 1.1, 3))
           @ rot_x(8 * nod + 2.2 * stress - 5 * (1 - turn)))
    pose.solve()
    chest = pose.rotation["chest"]
    wide, rise = sine(phase, .6, 4), .65 * sine(phase, .2, 9) + .35 * sine(phase, 1.9, 5)
    above_lap = .025 + (.025 if body.skirt else 0) + .0035 * body.stoop
    wrist = in_chest(pose, -.150 - .050 * wide, .255 + body.belly * .6 + .020 * rise,
                     above_lap + .055 * rise)
    gesture = ArmTarget(wrist, chest @ vec(.30 - .30 * wide, -1, .20 + .25 * rise),
                        chest @ vec(.75, .12, .50 + .35 * wide), chest @ vec(-.75, .6, -.7))
    pose.arms["R"] = between(hand_on_thigh(pose, phase, "R", -1), gesture, talking)
    pose.arms["L"] = hand_on_thigh(pose, phase, "L", 1, .48)
    return pose


def sit_look_around_pose(body, bones, phase):
    """Past the neighbour at the left, up at something with the back straightened, and to the right,
    bent forward."""
    late = lambda delay: periodic_curve((phase - delay) % 1.0, [
        (0, .04), (.07, .50), (.14, .95), (.20, 1), (.29, .94), (.38, .10), (.45, -.28),
        (.53, -.34), (.60, -.40), (.68, -.88), (.74, -1), (.84, -.96), (.93, -.35)])
    up = smoothstep(phase, .36, .48) - smoothstep(phase, .58, .69)
    left = smoothstep(phase, .08, .21) - smoothstep(phase, .28, .40)
    right = smoothstep(phase, .64, .77) - smoothstep(phase, .84, .97)
    pose = seated_trunk(body, bones, phase, 5 * right - 5 * up, 0, 1.5)
    turned(pose, "hips", rot_z(2 * late(.05)) @ rot_y(2 * left - 2 * right))
    turned(pose, "spine", rot_z(7 * late(.04)) @ rot_y(5 * left - 3 * right))
    turned(pose, "chest", rot_z(12 * late(.03)) @ rot_y(5 * left - 2 * right))
    turned(pose, "neck", rot_z(15 * late(.01)) @ rot_x(-7 * up + 2 * right)
           @ rot_y(-3 * left + 2 * right))
    turned(pose, "head", rot_z(31 * late(0)) @ rot_x(-18 * up - 3 * left + 3 * right)
           @ rot_y(-3 * left + 4 * up))
    pose.solve()
    for side, sign in SIDES:
        pose.arms[side] = hand_on_thigh(pose, phase, side, sign, .56)
    return pose


def sit_angry_pose(body, bones, phase):
    """Leaning forward on the left hand, the right fist shaken; three shouts in the clip."""
    shout, force = beat(phase, 3) ** 1.5, .75 + .25 * sine(phase, .8)
    shake = force * sine(phase, .9, 6)
    pose = seated_trunk(body, bones, phase, 11 + 1.5 * shout - body.stoop * .4, 0, 1)
    turned(pose, "chest", rot_z(7 + 2 * shake) @ rot_y(3))
    turned(pose, "neck", rot_x(3 + 4 * shout))
    turned(pose, "head", rot_x(-5 - 5 * shout) @ rot_z(-6 + 5 * sine(phase, .5, 2)))
    pose.local["shoulder_R"] = rot_y(12)
    pose.solve()
    wrist = in_chest(pose, -.320, .290 + .075 * shake, .455 - .070 * shake)
    pose.arms["R"] = ArmTarget(wrist, vec(.25, -.80 - .50 * shake, .8), vec(1, -.1, 0),
                               vec(-.8, -.1, -1))
    pose.arms["L"] = hand_on_thigh(pose, phase, "L", 1, .78)
    return pose


def sit_wave_pose(body, bones, phase):
    """The right hand waves four times overhead, the trunk giving way to the left."""
    swing = sine(phase, 0, 4)
    pose = seated_trunk(body, bones, phase, -1, 0, 3)
    turned(pose, "spine", rot_y(3))
    turned(pose, "chest", rot_y(3 + 1.2 * swing) @ rot_z(2))
    turned(pose, "head", rot_x(-5) @ rot_y(-3 + 3 * sine(phase, .4, 2)) @ rot_z(-3))
    pose.local["shoulder_R"] = rot_y(20)
    pose.solve()
    wrist = in_chest(pose, -.375 - .100 * swing, .09, .600 - .025 * swing * swing)
    pose.arms["R"] = ArmTarget(wrist, vec(-.50 * swing - .06, -.05, 1), vec(0, -1, -.05),
                               vec(-1, .10, -.35))
    pose.arms["L"] = hand_on_thigh(pose, phase, "L", 1)
    return pose


def between(first, second, share):
    """A hand on its way from one target to another."""
    return ArmTarget(lerp(first.wrist, second.wrist, share),
                     lerp(unit(first.fingers), unit(second.fingers), share),
                     lerp(unit(first.palm), unit(second.palm), share),
                     lerp(first.pole, second.pole, share))


def sitting_down_pose(body, bones, phase):
    """From standing at the foot point to the seat: lean, lower, lean back."""
    seat, stand = sit_pose(body, bones, 0.0).solve(), standing(body, bones, 0.0)
    down = smoothstep(phase, .10, .80)
    bend = math.sin(math.pi * smoothstep(phase, 0, 1)) * 30
    pose = Pose(body, bones)
    pose.offset = lerp(stand.offset, seat.offset, down) \
        + vec(0, .05 * body.size * math.sin(math.pi * down), 0)
    pose.gather = down
    _mix(pose, stand, seat, smoothstep(phase, .35, 1))
    pose.local["hips"] = rot_x(bend * .8) @ pose.local["hips"]
    pose.local["spine"] = rot_x(bend * .3) @ pose.local["spine"]
    pose.local["chest"] = rot_x(bend * .2) @ pose.local["chest"]
    pose.local["head"] = rot_x(-bend * .6) @ pose.local["head"]
    _walk_feet(pose, seat, down)
    for side, sign in SIDES:
        around_skirt = body.skirt.side * 110 * math.sin(math.pi * phase) if body.skirt else 0
        hang(pose, side, sign, 40 - around_skirt, 2 - bend * .35, 14 + bend * .5)
    pose.solve()
    for side, sign in SIDES:
        own, target = smoothstep(phase, .45, .95), hand_on_thigh(pose, 0.0, side, sign)
        wide = .075 if not body.skirt else .125
        around = vec(sign * wide, -.03, .085) * body.size * math.sin(math.pi * own)
        wrist = lerp(pose.position["hand_" + side], target.wrist, own) + around
        resting = pose.rotation["hand_" + side] @ _rest_fingers(body, sign)
        pose.arms[side] = ArmTarget(
            wrist, lerp(resting, unit(target.fingers), own),
            lerp(pose.rotation["hand_" + side] @ _rest_palm(body, sign), target.palm, own),
            lerp(vec(sign * .5, 1, -.1), vec(sign * .85, .55, -.25), own))
    return pose


def standing_up_pose(body, bones, phase):
    return sitting_down_pose(body, bones, 1 - phase)


def _mix(pose, first, second, share):
    """Local rotations of the trunk between two poses, by normalised sums of their axes."""
    for name in ("hips", "spine", "chest", "neck", "head"):
        sum_ = lerp(first.local[name], second.local[name], share)
        u, _, v = np.linalg.svd(sum_)
        pose.local[name] = u @ v


def _walk_feet(pose, seat, down):
    body = pose.body
    for side, sign in SIDES:
        target = seat.legs[side]
        if not dangles(body):
            pose.legs[side] = target
            continue
        plant_foot(pose, side, sign, body.hip[0], -body.ankle[1] - .012 * sign, 5)
        ground, own = pose.legs[side], smoothstep(down, .45, 1)
        u, _, v = np.linalg.svd(lerp(ground.foot, target.foot, own))
        pose.legs[side] = LegTarget(lerp(ground.ankle, target.ankle, own), u @ v, u @ v,
                                    lerp(ground.pole, target.pole, own))


def _rest_fingers(body, sign):
    angle = math.radians(body.arm_angle)
    return vec(sign * math.cos(angle), 0, -math.sin(angle))


def _rest_palm(body, sign):
    angle = math.radians(body.arm_angle)
    return vec(-sign * math.sin(angle), 0, -math.cos(angle))
