# SPDX-License-Identifier: MIT
"""Clips of people who stand: waiting, moods, gestures, dances. All of them loop."""
import math

from geometry import (FULL_TURN, lerp, periodic_curve, rot_x, rot_y, rot_z, smoothstep, unit, vec)
from skeleton import SIDES, ArmTarget, Pose, hanging_arm, plant_foot


def sine(phase, shift=0.0, times=1):
    return math.sin(times * FULL_TURN * phase + shift)


def beat(phase, times):
    """0..1, peaks at 0."""
    return .5 + .5 * math.cos(times * FULL_TURN * phase)


def arm_length(body):
    return body.upper_arm + body.forearm


def in_chest(pose, x, front, up):
    """A place in the moving frame of the chest, in metres of a man's trunk."""
    joint = pose.body.joint_z
    scale = (joint["neck"] - joint["chest"]) / .268
    return pose.position["chest"] + pose.rotation["chest"] @ (vec(x, -front, up) * scale)


def in_hips(pose, x, front, up):
    scale = pose.body.size
    return pose.position["hips"] + pose.rotation["hips"] @ (vec(x, -front, up) * scale)


def standing(body, bones, phase, weight=1.0, breath=1.0, width=1.05, turn=11):
    """Feet on the ground, the weight going from one leg to the other, arms hanging."""
    pose = Pose(body, bones)
    s = body.size
    shift, breathing = weight * sine(phase), breath * sine(phase, times=2)
    roll = -(3.6 if body.is_woman else 2.6) * shift
    pose.offset = vec(.022 * shift + .004, .004 * sine(phase, .7), -.004 - .0025 * shift ** 2) * s
    pose.local.update({
        "hips": rot_y(roll) @ rot_z(1.8 * sine(phase, .5)),
        "spine": rot_y(-roll * .7) @ rot_x(-.6 + .8 * breathing),
        "chest": rot_y(-roll * .5) @ rot_x(-1.2 * breathing) @ rot_z(-1.5 * sine(phase, .3)),
        "neck": rot_x(1 + .5 * breathing),
        "head": rot_x(1.5) @ rot_y(roll * .3)})
    for side, sign in SIDES:
        apart = body.stance * (.95 if body.is_woman else width)
        plant_foot(pose, side, sign, body.ankle[0] * apart, -.010 * s * sign, turn)
        hang(pose, side, sign, 40 - 1.2 * breathing, 2 + 1.5 * sine(phase, sign),
             13 + 2.5 * sine(phase, sign * 1.2))
        pose.local["shoulder_" + side] = rot_y(sign * (1.0 - 1.4 * breathing))
    return pose


def hang(pose, side, sign, lower, swing, bend):
    """An arm at the side; a wide trunk holds it off."""
    off = 150 * max(0, pose.body.belly - .02) + (4 if pose.body.skirt else 0) + pose.body.arms_off
    pose.local["upperarm_" + side] = hanging_arm(sign, lower - off, swing)
    pose.local["forearm_" + side] = relaxed_elbow(pose, sign) @ rot_z(sign * -8) @ rot_x(-bend)
    pose.local["hand_" + side] = rot_x(-5) @ rot_y(sign * 3)


def relaxed_elbow(pose, sign):
    """Forearms hang down again where upper arms stand off."""
    return rot_y(sign * .6 * pose.body.arms_off)


def turned(pose, name, rotation):
    pose.local[name] = pose.local.get(name, rot_x(0)) @ rotation


def idle_pose(body, bones, phase):
    """Breathing twice, a slow shift of weight, looking around."""
    pose = standing(body, bones, phase)
    turned(pose, "neck", rot_z(3 * sine(phase, 1.6)))
    turned(pose, "head", rot_z(7 * sine(phase, 1.9) + 2.5 * sine(phase, .4, 2))
           @ rot_x(1.2 * sine(phase, 1, 2)))
    return pose


def idle_2_pose(body, bones, phase):
    """Hands folded in front."""
    pose = standing(body, bones, phase, .8, turn=8)
    turned(pose, "head", rot_z(9 * sine(phase, .4)) @ rot_x(3 + 2 * sine(phase, 2)))
    pose.solve()
    reach = arm_length(body)
    for side, sign in SIDES:
        shoulder = pose.position["upperarm_" + side]
        wrist = vec(sign * (.078 if sign > 0 else .070) * body.size + pose.offset[0],
                    pose.position["hips"][1] - ((.180 if body.skirt else .150) * body.size
                                                   + body.belly * .9),
                    shoulder[2] - .86 * reach)
        pose.arms[side] = ArmTarget(wrist, vec(-sign * .62, -.22, -.72),
                                    vec(-sign * .35, .9, -.2), vec(sign * .9, .55, 0))
    return pose


def look_around_pose(body, bones, phase):
    """To the right, to the left, the trunk following the head."""
    pose = standing(body, bones, phase, .6)
    late = lambda delay: periodic_curve((phase - delay) % 1.0, [
        (0, 0), (.10, -.72), (.18, -1), (.34, -.96), (.46, 0), (.58, .80), (.66, 1), (.84, .96),
        (.94, .26)])
    turned(pose, "head", rot_z(-34 * late(0)) @ rot_x(-3 * abs(late(0))))
    turned(pose, "neck", rot_z(-16 * late(.01)))
    turned(pose, "chest", rot_z(-15 * late(.03)))
    turned(pose, "spine", rot_z(-9 * late(.04)))
    turned(pose, "hips", rot_z(-4 * late(.05)))
    return pose


def sad_pose(body, bones, phase):
    """Head and shoulders down, a slow shake of the head."""
    pose = standing(body, bones, phase, .7)
    turned(pose, "spine", rot_x(5))
    turned(pose, "chest", rot_x(9 + .8 * sine(phase, .4, 2)))
    turned(pose, "neck", rot_x(7))
    turned(pose, "head", rot_x(9 + 2 * sine(phase, 1)) @ rot_z(7 * sine(phase, .2, 2)))
    for side, sign in SIDES:
        turned(pose, "shoulder_" + side, rot_y(sign * 5) @ rot_z(sign * -8))
        hang(pose, side, sign, 36, -14 + 1.5 * sine(phase, sign), 10)
    return pose


def bored_pose(body, bones, phase):
    """Hands on the hips, the weight on one leg, a tapping foot, a look at the sky."""
    pose = standing(body, bones, phase, .5, width=1.2)
    up = smoothstep(sine(phase, -1.2), .1, .9)
    turned(pose, "head", rot_z(16 * sine(phase, 1.0)) @ rot_x(4 - 17 * up) @ rot_y(5 * sine(phase)))
    turned(pose, "chest", rot_x(-3 * up))
    tapping = smoothstep(sine(phase, 1.4), -.1, .4) * max(0.0, sine(phase, 0, 12)) ** 2
    plant_foot(pose, "R", -1, body.ankle[0] * 1.2, -.05 * body.size, 20, heel=13 * tapping)
    pose.solve()
    for side, sign in SIDES:
        half = body.trunk["hem"].half_width / body.size
        wrist = in_hips(pose, sign * (half + .065 + .5 * body.belly), -.015, .070)
        turn = pose.rotation["hips"]
        pose.arms[side] = ArmTarget(wrist, turn @ vec(-sign * .55, -.78, -.30),
                                    turn @ vec(-sign * .8, .35, -.45), vec(sign, .55, -.05))
    return pose


def talk_pose(body, bones, phase):
    """Both hands underline what is said; nodding."""
    pose = standing(body, bones, phase, .9)
    turned(pose, "head", rot_z(6 * sine(phase, .5)) @ rot_x(2 + 3 * sine(phase, .6, 4))
           @ rot_y(3 * sine(phase, 1.1, 2)))
    turned(pose, "chest", rot_z(4 * sine(phase, 0, 2)))
    pose.solve()
    for side, sign in SIDES:
        shift = 0 if side == "R" else 1.9
        wide, rise = sine(phase, shift, 2), sine(phase, shift + .8, 4)
        size = .6 + .4 * sine(phase, shift)
        front = .245 + body.belly * .6
        wrist = in_chest(pose, sign * (.165 + .045 * wide * size),
                         front + .03 * sine(phase, shift, 4),
                         -.045 + (.040 + .05 * size) * rise * size)
        pose.arms[side] = ArmTarget(wrist, vec(-sign * (.30 - .25 * wide), -1, .22 + .25 * rise),
                                    vec(-sign * .75, .12, .60 + .2 * wide),
                                    vec(sign * .75, .6, -.7))
    return pose


def wave_pose(body, bones, phase):
    """The right hand waves four times above the shoulder."""
    pose = standing(body, bones, phase, .5)
    swing = sine(phase, 0, 4)
    turned(pose, "head", rot_z(-3) @ rot_y(3 * sine(phase, 0, 2)) @ rot_x(-3))
    turned(pose, "chest", rot_y(-2 + swing))
    pose.local["shoulder_R"] = rot_y(14)
    pose.solve()
    wrist = in_chest(pose, -.335 - .085 * swing, .12, .455 - .015 * abs(swing))
    pose.arms["R"] = ArmTarget(wrist, vec(-.42 * swing - .04, -.05, 1), vec(0, -1, -.05),
                               vec(-1, .35, -.8))
    return pose


def clap_hands(pose, phase, claps):
    """Palms meet in front of the chest."""
    closing = beat(phase, claps) ** 1.6
    front = .285 + pose.body.belly * .4
    for side, sign in SIDES:
        wrist = in_chest(pose, sign * lerp(.135, .026, closing), front,
                         .075 + .01 * sine(phase, 1) - .012 * sign)
        pose.arms[side] = ArmTarget(wrist, vec(sign * .16 * (1 - closing), -.75, .65),
                                    vec(-sign, 0, 0), vec(sign * .75, .35, -.8))
    return pose


def clap_pose(body, bones, phase):
    pose = standing(body, bones, phase, .6)
    turned(pose, "chest", rot_x(-2 + 1.5 * beat(phase, 4)))
    turned(pose, "head", rot_x(-3 + 2 * beat(phase, 4)) @ rot_z(4 * sine(phase)))
    return clap_hands(pose.solve(), phase, 4)


def angry_pose(body, bones, phase):
    """Leaning forward, the right fist shaken high, the left one low, a shaking head."""
    pose = standing(body, bones, phase, .4, width=1.3, turn=14)
    shake = sine(phase, 0, 4)
    pose.offset = pose.offset + vec(0, 0, -.020 - .008 * shake) * body.size
    turned(pose, "spine", rot_x(5))
    turned(pose, "chest", rot_x(5 + 1.5 * shake) @ rot_z(7 + 2 * shake))
    turned(pose, "head", rot_x(-7) @ rot_z(-5 + 7 * sine(phase, .5, 3)))
    pose.local["shoulder_R"] = rot_y(12)
    pose.solve()
    right = in_chest(pose, -.285, .255 + .03 * shake, .330 + .065 * shake)
    left = in_chest(pose, .245, .215, .015 + .035 * sine(phase, 1.3, 4))
    pose.arms["R"] = ArmTarget(right, vec(.05, -.35 - .25 * shake, 1), vec(1, -.1, 0),
                               vec(-1, .2, -.9))
    pose.arms["L"] = ArmTarget(left, vec(-.1, -.75, .65), vec(-1, 0, .1), vec(1, .6, -.7))
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
    lively = body.size * (1 if body.energy == 1 else .35)
    height = periodic_curve(phase, [(0, -.055), (.12, -.085), (.26, .015), (.38, .100),
                                    (.50, .105), (.62, .020), (.74, -.085), (.88, -.060)]) * lively
    up = periodic_curve(phase, [(0, .62), (.14, .50), (.32, .95), (.46, 1.0), (.62, .92),
                                (.78, .66), (.9, .60)]) * (1 if body.energy == 1 else .82)
    crouch = max(0, -height) / .085
    pose.offset = vec(.008 * sine(phase), .012 - .02 * up, height - .012)
    pose.local.update({
        "hips": rot_x(8 * crouch - 3 * up) @ rot_z(3 * sine(phase)),
        "spine": rot_x(5 * crouch - 4 * up),
        "chest": rot_x(3 * crouch - 6 * up) @ rot_z(-3 * sine(phase)),
        "neck": rot_x(-4 * up),
        "head": rot_x(-9 * up + 2 * crouch) @ rot_y(3 * sine(phase))})
    for side, sign in SIDES:
        plant_foot(pose, side, sign, body.ankle[0] * 1.25, 0, 12,
                   lift=max(0, height - .028 * lively),
                   heel=34 * smoothstep(height, -.01 * lively, .07 * lively))
        own = min(1.05, up + .06 * sine(phase, 0 if side == "L" else 1.2))
        raise_arm(pose, side, sign, own, 10 * sine(phase))
    return pose


def dance_pose(body, bones, phase):
    """Side steps on the spot with pumping arms: two bars of four beats."""
    pose = Pose(body, bones)
    s, e = body.size, body.energy
    sway, bounce = sine(phase, 0, 2), beat(phase, 8)
    pose.offset = vec(.052 * sway, 0, -.046 + .020 * bounce) * s * e
    pose.local.update({
        "hips": rot_y(6 * sway * e) @ rot_z(8 * sine(phase, .6, 2) * e),
        "spine": rot_y(-6 * sway * e) @ rot_x(3),
        "chest": rot_z(-13 * sine(phase, .6, 2) * e) @ rot_y(-4 * sway * e),
        "neck": rot_z(4 * sine(phase, .6, 2)),
        "head": rot_x(2 + 5 * bounce * e) @ rot_y(5 * sway)})
    for side, sign in SIDES:
        light = smoothstep(-sign * sway, .05, .9)
        plant_foot(pose, side, sign, body.ankle[0] * 1.45, -.02 * s * sign, 14, heel=24 * light * e)
        own = sine(phase, 0 if side == "L" else math.pi, 4)
        pose.local["shoulder_" + side] = rot_y(sign * -5)
        pose.local["upperarm_" + side] = hanging_arm(sign, 24, -18 + 20 * own * e)
        pose.local["forearm_" + side] = rot_z(sign * -16) @ rot_x(-88 - 14 * own)
        pose.local["hand_" + side] = rot_x(-8)
    return pose


def dance_2_pose(body, bones, phase):
    """Arms overhead, swaying from side to side while the hips circle."""
    pose = Pose(body, bones)
    s, e = body.size, body.energy
    sway, bounce = sine(phase), beat(phase, 4)
    pose.offset = vec(.055 * sine(phase, -.5), .022 * math.cos(FULL_TURN * phase),
                      -.040 + .016 * bounce) * s * e
    pose.local.update({
        "hips": rot_y(7 * sine(phase, -.5) * e) @ rot_z(6 * sine(phase, .9)),
        "spine": rot_y(-3 * sway), "chest": rot_y(-12 * sway * e) @ rot_x(-4),
        "neck": rot_y(4 * sway), "head": rot_y(6 * sway) @ rot_x(-5 + 4 * bounce)})
    for side, sign in SIDES:
        plant_foot(pose, side, sign, body.ankle[0] * 1.4, 0, 12,
                   heel=16 * smoothstep(-sign * sine(phase, -.5), .1, .9) * e)
        up = .86 * (1 if e == 1 else .85) + .06 * sine(phase, sign)
        raise_arm(pose, side, sign, up, 14 * sway * sign, outwards=10 * sway * sign)
    return pose
