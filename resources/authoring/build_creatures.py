#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Builds the dog, the horse, the beetle, the helicopter and the forklift (no Blender).

The importer makes their coarser levels."""
import math
import os

from creature_file import CreatureWriter, Shape, about_x
from geometry import FULL_TURN, hermite, rot_x, rot_y, rot_z, smoothstep, vec

TEMPLATES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "templates")
EYES = (("", (24, 20, 18)),)


def sine(phase, shift=0.0, times=1):
    return math.sin(times * FULL_TURN * phase + shift)


class Quadruped:
    """Measures in metres for a horse; size scales them. Legs bend in the plane of the walk."""

    def __init__(self, name, size, looks, neck_rise, head, tail, ears, girth, leg):
        self.name, self.size, self.looks = name, size, looks
        self.neck_rise, self.head, self.tail, self.ears = neck_rise, head, tail, ears
        self.girth, self.leg = girth, leg
        s, h = size, 1.02 * leg
        self.front, self.rear = -.48, .50
        self.bones = {"root": ("", vec(0, 0, 0)), "body": ("root", vec(0, 0, 1.15 * s)),
                      "neck": ("body", vec(0, -.62, 1.26) * s),
                      "head": ("neck", vec(0, -.62 - .42 * head[0], 1.26 + neck_rise) * s),
                      "tail": ("body", vec(0, .74, 1.26) * s)}
        for side, sign in (("L", 1), ("R", -1)):
            for end, y, bend in (("fore", self.front, -.05), ("hind", self.rear, .13)):
                x = .17 * girth * sign
                self.bones[f"{end}_{side}"] = "body", vec(x, y, h) * s
                self.bones[f"{end}_shin_{side}"] = f"{end}_{side}", vec(x, y + bend, h * .53) * s
                self.bones[f"{end}_foot_{side}"] = (f"{end}_shin_{side}",
                                                    vec(x, y + .02, h * .10) * s)

    def shape(self):
        shape, s, g = Shape(), self.size, self.girth
        body = lambda y, z, wide, high, w: (vec(0, y, z) * s, wide * g * s, high * g * s, w)
        own, neck, head = {"body": 1}, {"neck": 1}, {"head": 1}
        shape.tube([body(.80, 1.24, .08, .10, own), body(.72, 1.19, .22, .24, own),
                    body(.46, 1.16, .28, .30, own), body(.10, 1.12, .28, .31, own),
                    body(-.25, 1.12, .27, .33, own), body(-.52, 1.15, .23, .31, own),
                    body(-.70, 1.19, .13, .20, own), body(-.76, 1.20, .05, .10, own)], 10, "coat")
        top = self.bones["head"][1] / s
        low = vec(0, -.56, 1.20)
        mid = (low + top) / 2 + vec(0, .04, 0)
        shape.tube([(low * s, .15 * g * s, .24 * g * s, own), (mid * s, .11 * g * s, .16 * g * s, neck),
                    (top * s, .09 * g * s, .12 * g * s, {"neck": .5, "head": .5}),
                    ((top + vec(0, .02, .06)) * s, .03 * g * s, .04 * g * s, head)][::-1], 8, "coat")
        if self.size == 1:
            self._add_mane(shape, low, top, neck)
        self._add_head(shape, top, head)
        self._add_tail(shape)
        for side, sign in (("L", 1), ("R", -1)):
            for end in ("fore", "hind"):
                self._add_leg(shape, end, side)
        return shape

    def _add_head(self, shape, top, head):
        s, (length, wide, drop) = self.size, self.head
        at = lambda t, lift=0: (top + vec(0, .07 - (length + .07) * t, lift - drop * t)) * s
        shape.tube([(at(0), wide * .55 * s, wide * .7 * s, head),
                    (at(.18, .01), wide * s, wide * 1.15 * s, head),
                    (at(.45), wide * .85 * s, wide * .95 * s, head),
                    (at(.75), wide * .58 * s, wide * .60 * s, head),
                    (at(1), wide * .45 * s, wide * .42 * s, head)][::-1], 8, "coat")
        shape.tube([(at(1.03, -.01), wide * .30 * s, wide * .22 * s, head),
                    (at(.96, .012), wide * .40 * s, wide * .34 * s, head)], 6, "dark")
        for sign in (-1, 1):
            x, (tall, flop) = sign * wide * .62, self.ears
            foot = at(.08, wide * .8) + vec(x * s, 0, 0)
            shape.tube([(foot, wide * .30 * s, wide * .16 * s, head),
                        (foot + vec(sign * .02 + flop * sign * .05, 0, tall * .6) * s,
                         wide * .30 * s, wide * .12 * s, head),
                        (foot + vec(sign * .02 + flop * sign * .10, -.01, tall * (1 - flop)) * s,
                         .008 * s, .008 * s, head)], 5, "dark", upright=True)
            shape.tube([(at(.30, wide * .45) + vec(sign * wide * .62 * s, 0, -.015 * s), .02 * s, .02 * s, head),
                        (at(.30, wide * .45) + vec(sign * wide * .80 * s, 0, .018 * s), .02 * s, .02 * s,
                         head)], 5, "eyes", upright=True)

    def _add_mane(self, shape, low, top, neck):
        crest = [(low + vec(0, .26, .16), .03), (low * .6 + top * .4 + vec(0, .20, .10), .10),
                 (low * .25 + top * .75 + vec(0, .15, .08), .10), (top + vec(0, .06, .14), .05),
                 (top + vec(0, -.10, .10), .02)]
        shape.tube([(p * self.size, .035 * self.size, r * self.size, neck) for p, r in crest], 6,
                   "mane")

    def _add_tail(self, shape):
        s, (length, lift, thick) = self.size, self.tail
        start, tail = self.bones["tail"][1] / s, {"tail": 1}
        places = [(start + vec(0, .10 * k + .05 * math.sin(k), length * lift * k / 3
                               - length * (1 - abs(lift)) * (k / 3) ** 1.5 * (lift <= 0)), r)
                  for k, r in enumerate((.6, 1, 1, .25))]
        shape.tube([(p * s, thick * r * s, thick * r * s, tail) for p, r in places][::-1], 6, "mane")

    def _add_leg(self, shape, end, side):
        s, g = self.size, self.girth
        hip, knee, foot = (self.bones[f"{end}{part}_{side}"][1] / s
                           for part in ("", "_shin", "_foot"))
        upper, lower, hoof = ({f"{end}{part}_{side}": 1} for part in ("", "_shin", "_foot"))
        thick = 1.25 if end == "hind" else 1.0
        half = {f"{end}_{side}": .5, f"{end}_shin_{side}": .5}
        shape.tube([(vec(foot[0], foot[1] - .035, 0) * s, .062 * g * s, .072 * g * s, hoof),
                    (foot * s, .045 * g * s, .046 * g * s, hoof)], 7, "hoof", upright=True)
        ankle = {f"{end}_shin_{side}": .5, f"{end}_foot_{side}": .5}
        shape.tube([((foot - vec(0, 0, .01)) * s, .043 * g * s, .045 * g * s, ankle),
                    ((foot * .7 + knee * .3) * s, .038 * g * s, .040 * g * s, lower),
                    (knee * s, .056 * g * s, .066 * g * s, half),
                    ((knee * .6 + hip * .4) * s, .072 * g * thick * s, .095 * g * thick * s, upper),
                    ((hip + vec(0, 0, .02)) * s, .105 * g * s, .165 * g * thick * s,
                     {f"{end}_{side}": .7, "body": .3}),
                    ((hip + vec(-.04 * math.copysign(1, hip[0]), 0, .16)) * s, .06 * g * s,
                     .12 * g * s, {"body": 1})], 7, "coat", upright=True)

    def pose(self, phase, stride, stance, lift, shifts, bob, pitch, nod):
        """Feet on their paths, the body bobbing, head and tail in time."""
        body = vec(0, 0, bob * sine(phase, 0, 2)) * self.size
        tilt = pitch * sine(phase, .6)
        result = {"body": (body, rot_x(tilt)),
                  "neck": about_x(-tilt * .5 + nod * sine(phase, .8, 2)),
                  "head": about_x(-tilt * .3 - nod * .6 * sine(phase, .4, 2)),
                  "tail": (None, rot_z(9 * sine(phase)) @ rot_x(4 * sine(phase, 1, 2)))}
        for name, shift in shifts.items():
            self._leg(result, name, (phase + shift) % 1, stride, stance, lift, body, tilt)
        return result

    def _leg(self, result, name, phase, stride, stance, lift, body, tilt):
        end, side = name.split("_")
        hip, knee, foot = (self.bones[f"{end}{part}_{side}"][1] for part in ("", "_shin", "_foot"))
        y, z, curl = foot_path(phase, stride * self.size, stance, lift * self.size)
        centre = self.bones["body"][1]
        start = centre + body + rot_x(tilt) @ (hip - centre)
        target = vec(hip[0], foot[1] + y, foot[2] + z)
        first, second = knee - hip, foot - knee
        a, b = math.hypot(*first[1:]), math.hypot(*second[1:])
        line = target - start
        c = min(math.hypot(*line[1:]), (a + b) * .999)
        sign = 1 if end == "fore" else -1
        turn = math.acos(max(-1, min(1, (a * a + c * c - b * b) / (2 * a * c))))
        along = math.atan2(line[2], line[1])
        upper = along - sign * turn
        joint = vec(0, start[1] + a * math.cos(upper), start[2] + a * math.sin(upper))
        lower = math.atan2(target[2] - joint[2], target[1] - joint[1])
        rest = lambda v: math.atan2(v[2], v[1])
        one, two = upper - rest(first), lower - rest(second)
        result[f"{end}_{side}"] = about_x(math.degrees(one) - tilt)
        result[f"{end}_shin_{side}"] = about_x(math.degrees(two - one))
        result[f"{end}_foot_{side}"] = about_x(-math.degrees(two) + curl)

    def write(self, walk, run):
        writer = CreatureWriter(self.name, self.looks, self.bones)
        shape, s = self.shape(), self.size
        node = writer.skin(shape)
        still = {n: 0 for n in ("fore_L", "fore_R", "hind_L", "hind_R")}
        writer.clip("idle", 128, lambda p: self._idle(p, still))
        for name, (speed, frames, stance, lift, shifts, bob, pitch, nod) in (("walk", walk),
                                                                             ("run", run)):
            stride = speed * frames / 32 * stance / s
            order = dict(zip(("hind_L", "fore_L", "hind_R", "fore_R"), shifts))
            writer.clip(name, frames, lambda p: self.pose(p, stride, stance, lift, order, bob,
                                                          pitch, nod), speed)
        path = os.path.normpath(os.path.join(TEMPLATES, self.name + ".glb"))
        writer.write(path, [node])
        print(f"{path}: {os.path.getsize(path)} bytes, {shape.triangles()} triangles")

    def _idle(self, phase, still):
        pose = self.pose(phase, 0, .6, 0, still, .004, 0, 1)
        pose["neck"] = None, rot_x(3 + 5 * sine(phase, .5)) @ rot_z(8 * sine(phase, 1))
        pose["head"] = None, rot_z(12 * sine(phase, 1.6)) @ rot_x(2 * sine(phase, 0, 2))
        pose["tail"] = None, rot_z(20 * sine(phase, 0, 4 if self.size < .6 else 2))
        return pose


def foot_path(phase, stride, stance, lift):
    """(y, z, curl in degrees) of a foot: back along the ground, forward through the air."""
    if phase <= stance:
        return stride * (phase / stance - .5), 0.0, 0.0
    u = (phase - stance) / (1 - stance)
    slope = stride / stance * (1 - stance)
    return (float(hermite(stride / 2, slope, -stride / 2, slope, u)),
            lift * math.sin(math.pi * u) ** 2, 55 * math.sin(math.pi * min(1, u * 1.3)) ** 2
            * (u < 1 / 1.3) * min(1, lift * 8))


def dog():
    Quadruped("dog", .50, {
        "coat": (("", (196, 158, 112)), ("Coat black", (52, 48, 48)), ("Coat white", (236, 230, 220)),
                 ("Coat grey", (150, 146, 142))),
        "dark": (("", (112, 84, 60)), ("Ears black", (40, 36, 36))), "eyes": EYES,
        "mane": (("", (196, 158, 112)), ("Tail black", (52, 48, 48))),
        "hoof": (("", (206, 178, 140)), ("Paws white", (238, 234, 226)))},
        .30, (.40, .125, .10), (.42, .75, .05), (.20, .75), .80, .96).write(
        (.95, 24, .62, .10, (0, .25, .5, .75), .006, 1.0, 2), (3.6, 14, .34, .20,
                                                             (0, .55, .10, .65), .03, 5, 3))


def horse():
    Quadruped("horse", 1.0, {
        "coat": (("", (150, 100, 66)), ("Coat black", (48, 44, 44)), ("Coat grey", (196, 192, 186)),
                 ("Coat chestnut", (168, 92, 52))),
        "dark": (("", (74, 54, 44)), ("Muzzle black", (36, 32, 32))), "eyes": EYES,
        "mane": (("", (52, 40, 34)), ("Mane pale", (214, 192, 150))),
        "hoof": (("", (70, 60, 54)), ("Hooves white", (224, 216, 204)))},
        .52, (.50, .135, .34), (.75, -.05, .075), (.17, 0), 1.0, 1.0).write(
        (1.6, 36, .62, .16, (0, .25, .5, .75), .012, .8, 3), (6.4, 18, .30, .34,
                                                            (0, .55, .12, .68), .06, 4, 5))


def beetle():
    """As long as a thumb; three legs a side move in turn, two on one side with one on the other."""
    s = .03
    bones = {"root": ("", vec(0, 0, 0)), "body": ("root", vec(0, 0, .62) * s),
             "head": ("body", vec(0, -1.0, .62) * s)}
    legs = []
    for k, y in enumerate((-.55, 0, .55)):
        for side, sign in (("L", 1), ("R", -1)):
            name = f"leg{k}_{side}"
            bones[name] = "body", vec(.42 * sign, y, .50) * s
            legs.append((name, sign, y, ((k + (sign > 0)) % 2) / 2))
    shape = Shape()
    oval = lambda y, z, w, h, bone: (vec(0, y, z) * s, w * s, h * s, {bone: 1})
    shape.tube([oval(1.45, .60, .10, .06, "body"), oval(1.25, .64, .42, .26, "body"),
                oval(.80, .70, .66, .40, "body"), oval(.25, .72, .72, .44, "body"),
                oval(-.20, .70, .64, .38, "body"), oval(-.30, .66, .50, .28, "body")], 12, "shell")
    shape.tube([oval(-.24, .66, .50, .30, "body"), oval(-.55, .66, .56, .33, "body"),
                oval(-.90, .62, .40, .24, "body")], 10, "thorax")
    shape.tube([oval(-.86, .60, .30, .20, "head"), oval(-1.10, .58, .32, .20, "head"),
                oval(-1.32, .54, .16, .10, "head")], 8, "thorax")
    for sign in (-1, 1):
        horn = [(vec(.14 * sign, -1.26, .54), .06), (vec(.30 * sign, -1.52, .60), .05),
                (vec(.26 * sign, -1.80, .68), .035), (vec(.10 * sign, -1.94, .72), .01)]
        shape.tube([(p * s, r * s, r * s, {"head": 1}) for p, r in horn][::-1], 5, "leg")
        eye = vec(.28 * sign, -1.12, .64) * s
        shape.tube([(eye - vec(0, 0, .06 * s), .07 * s, .07 * s, {"head": 1}),
                    (eye + vec(0, 0, .06 * s), .06 * s, .06 * s, {"head": 1})], 6, "eyes",
                   upright=True)
    for name, sign, y, _ in legs:
        knee, foot = vec(sign * .92, y * 1.35, .72), vec(sign * 1.22, y * 1.75, 0)
        start = vec(.36 * sign, y, .50)
        for a, b, r in ((start, knee, .075), (knee, foot, .05)):
            low, high = (a, b) if a[2] < b[2] else (b, a)
            shape.tube([(low * s, r * .7 * s, r * .7 * s, {name: 1}),
                        (high * s, r * s, r * s, {name: 1})], 5, "leg", upright=True)
    writer = CreatureWriter("beetle", {
        "shell": (("", (58, 84, 62)), ("Shell brown", (96, 56, 36)), ("Shell blue", (44, 62, 104)),
                  ("Shell red", (150, 40, 32))),
        "thorax": (("", (44, 46, 42)),), "leg": (("", (38, 32, 28)),), "eyes": EYES}, bones)
    node = writer.skin(shape)

    def crawl(phase, swing, lift):
        pose = {"body": (vec(0, 0, .015 * s * sine(phase, 0, 2)), rot_y(1.5 * sine(phase))),
                "head": (None, rot_z(6 * sine(phase, 1)))}
        for name, sign, _, shift in legs:
            own = (phase + shift) % 1
            y, z, _ = foot_path(own, 2.0, .5, 1.0)
            pose[name] = None, rot_z(sign * swing * y) @ rot_y(-sign * lift * z)
        return pose
    writer.clip("idle", 96, lambda p: crawl(p, 0, 0))
    writer.clip("walk", 16, lambda p: crawl(p, 17, 14), .13)
    writer.clip("run", 10, lambda p: crawl(p, 20, 18), .25)
    path = os.path.normpath(os.path.join(TEMPLATES, "beetle.glb"))
    writer.write(path, [node])
    print(f"{path}: {os.path.getsize(path)} bytes, {shape.triangles()} triangles")


def helicopter():
    bones = {"root": ("", vec(0, 0, 0)), "hull": ("root", vec(0, 0, 1.4)),
             "rotor": ("hull", vec(0, 0, 2.75)), "tail_rotor": ("hull", vec(.22, 4.9, 2.35))}
    hull, ring = Shape(), lambda y, z, w, h: (vec(0, y, z), w, h, None)
    hull.tube([ring(5.2, 2.10, .06, .10), ring(3.2, 1.95, .14, .18), ring(1.6, 1.75, .34, .42),
               ring(.9, 1.55, .74, .72), ring(0, 1.45, .86, .82), ring(-.9, 1.38, .84, .78)],
              12, "paint")
    hull.tube([ring(-.86, 1.38, .83, .77), ring(-1.6, 1.30, .68, .62), ring(-2.15, 1.15, .36, .32),
               ring(-2.35, 1.08, .08, .08)], 12, "glass")
    hull.box((-.05, 4.5, 1.95), (.05, 5.25, 2.85), "trim")
    hull.box((-.75, 4.2, 2.0), (.75, 4.55, 2.06), "trim")
    hull.box((-.32, -.5, 2.15), (.32, .9, 2.45), "paint")
    hull.tube([(vec(0, 0, 2.40), .09, .09, None), (vec(0, 0, 2.78), .07, .07, None)], 8, "metal",
              upright=True)
    for sign in (-1, 1):
        hull.box((sign * .85 - .05, -1.6, .02), (sign * .85 + .05, 1.3, .10), "metal")
        for y in (-.8, .7):
            hull.box((sign * .85 - .04 - .12 * (sign > 0), y - .04, .08),
                     (sign * .85 + .04 + .12 * (sign < 0), y + .04, .86), "metal")
        hull.box((sign * .87 - .012, -.55, .95), (sign * .87 + .012, .45, 1.75), "trim")
    rotor, tail = Shape(), Shape()
    for k in range(4):
        low, high = ((-.09, .12, 2.74), (.09, 4.2, 2.77)) if k % 2 == 0 else \
            ((.12, -.09, 2.74), (4.2, .09, 2.77))
        flip = 1 if k < 2 else -1
        corners = [sorted((a * flip, b * flip)) for a, b in zip(low[:2], high[:2])]
        rotor.box((corners[0][0], corners[1][0], low[2]), (corners[0][1], corners[1][1], high[2]),
                  "metal")
    rotor.tube([(vec(0, 0, 2.68), .16, .16, None), (vec(0, 0, 2.85), .10, .10, None)], 8, "metal",
               upright=True)
    tail.box((.20, 4.86, 1.75), (.24, 4.94, 2.95), "metal")
    tail.box((.20, 4.30, 2.31), (.24, 5.50, 2.39), "metal")
    writer = CreatureWriter("helicopter", {
        "paint": (("", (214, 208, 196)), ("Paint red", (186, 48, 42)), ("Paint navy", (48, 62, 96)),
                  ("Paint yellow", (232, 182, 52))),
        "trim": (("", (176, 62, 52)), ("Trim dark", (60, 62, 66))),
        "glass": (("", (70, 92, 108)),), "metal": (("", (88, 90, 94)),)}, bones)
    for name, shape in (("hull", hull), ("rotor", rotor), ("tail_rotor", tail)):
        writer.hang(name, shape)

    def fly(phase, height, nose, turns):
        return {"hull": (vec(.05 * sine(phase), 0, height + .06 * sine(phase, 1, 2)),
                         rot_x(nose) @ rot_y(1.2 * sine(phase)) @ rot_z(sine(phase, .7))),
                "rotor": (None, rot_z(90 * phase * turns)),
                "tail_rotor": (None, rot_x(180 * phase * turns))}
    writer.clip("idle", 96, lambda p: fly(p, 0, 0, 24) | {"hull": (vec(0, 0, 0), rot_x(0))})
    writer.clip("hover", 96, lambda p: fly(p, 2.0 - 1.0, 0, 24))
    writer.clip("fly", 96, lambda p: fly(p, 1.0, 8, 24), 12.0)
    _finish(writer, "helicopter", (hull, rotor, tail))


def forklift():
    bones = {"root": ("", vec(0, 0, 0)), "chassis": ("root", vec(0, 0, .3)),
             "fork": ("chassis", vec(0, -1.15, .3))}
    wheels = {f"wheel_{end}_{side}": (vec(sign * .48, y, r), r) for end, y, r in
              (("front", -.72, .31), ("back", .62, .25)) for side, sign in (("L", 1), ("R", -1))}
    bones.update({name: ("chassis", place) for name, (place, _) in wheels.items()})
    body, fork = Shape(), Shape()
    body.box((-.46, -.95, .22), (.46, .30, .62), "paint")
    body.box((-.50, .22, .30), (.50, 1.12, 1.02), "paint")
    body.box((-.44, 1.10, .42), (.44, 1.24, .92), "dark")
    body.box((-.30, .02, .62), (.30, .22, 1.42), "dark")
    body.box((-.30, -.40, .62), (.30, .10, .74), "dark")
    body.box((-.04, -.72, .62), (.04, -.66, 1.20), "dark")
    for x in (-.45, .45):
        for y in (-.82, .42):
            body.box((x - .03, y - .03, .60), (x + .03, y + .03, 2.08), "metal")
        body.box((x * .62 - .04, -1.12, .10), (x * .62 + .04, -1.00, 2.10), "metal")
    body.box((-.50, -.88, 2.06), (.50, .50, 2.12), "metal")
    body.box((-.32, -1.10, 2.02), (.32, -1.02, 2.10), "metal")
    body.tube([(vec(0, .60, 1.02), .14, .14, None), (vec(0, .60, 1.16), .10, .10, None)], 8,
              "lamp", upright=True)
    fork.box((-.42, -1.20, .08), (.42, -1.13, .62), "metal")
    for x in (-.26, .26):
        fork.box((x - .06, -2.15, .06), (x + .06, -1.18, .10), "metal")
    writer = CreatureWriter("forklift", {
        "paint": (("", (232, 176, 52)), ("Paint orange", (222, 112, 44)), ("Paint green", (92, 140, 84)),
                  ("Paint grey", (160, 164, 168))),
        "dark": (("", (58, 58, 62)),), "metal": (("", (98, 100, 106)),), "lamp": (("", (230, 130, 40)),),
        "tyre": (("", (38, 38, 40)),)}, bones)
    writer.hang("chassis", body)
    writer.hang("fork", fork)
    shapes = [body, fork]
    for name, (place, radius) in wheels.items():
        wheel = Shape()
        turns = [FULL_TURN * i / 12 for i in range(12)]
        rows = [wheel.add([place + vec(x, r * math.cos(t), r * math.sin(t)) for t in turns], None)
                for x, r in ((-.10, radius * .5), (-.10, radius), (.10, radius), (.10, radius * .5))]
        for k, slot in enumerate(("metal", "tyre", "metal")):
            for i in range(12):
                j = (i + 1) % 12
                wheel.face([rows[k][i], rows[k][j], rows[k + 1][j], rows[k + 1][i]],
                           "tyre" if k != 1 else slot)
        wheel.face(rows[0][::-1], "metal")
        wheel.face(rows[-1], "metal")
        writer.hang(name, wheel)
        shapes.append(wheel)

    def drive(phase, speed, seconds):
        pose = {"chassis": (vec(0, 0, .004 * sine(phase, 0, 4)), None)}
        for name, (_, radius) in wheels.items():
            turns = max(1, round(speed * seconds / (FULL_TURN * radius))) if speed else 0
            pose[name] = None, rot_x(360 * turns * phase)
        return pose

    def lift(phase):
        up = smoothstep(phase, .05, .40) - smoothstep(phase, .55, .92)
        return {"fork": (vec(0, 0, 1.25 * up), None)}
    writer.clip("idle", 64, lambda p: drive(p, 0, 2))
    writer.clip("drive", 64, lambda p: drive(p, 2.0, 2), 2.0)
    writer.clip("lift", 192, lift)
    _finish(writer, "forklift", shapes)


def _finish(writer, name, shapes):
    path = os.path.normpath(os.path.join(TEMPLATES, name + ".glb"))
    writer.write(path)
    print(f"{path}: {os.path.getsize(path)} bytes, {sum(s.triangles() for s in shapes)} triangles")


if __name__ == "__main__":
    for build in (dog, horse, beetle, helicopter, forklift):
        build()
