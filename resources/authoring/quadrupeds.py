# SPDX-License-Identifier: MIT
"""The dog and the horse: measures, shapes, and legs that follow their feet."""
import math
from dataclasses import dataclass

from creature_file import LEVELS, CreatureWriter, Shape, about_x
from geometry import FULL_TURN, hermite, rot_x, rot_z, vec

SHARP_DEGREES = 70  # legs have few sides and are round all the same
EYES = (("", (24, 20, 18)),)


def sine(phase, shift=0.0, times=1):
    return math.sin(times * FULL_TURN * phase + shift)


def foot_path(phase, stride, stance, lift):
    """(y, z, curl in degrees) of a foot: back along the ground, forward through the air."""
    if phase <= stance:
        return stride * (phase / stance - .5), 0.0, 0.0
    u = (phase - stance) / (1 - stance)
    slope = stride / stance * (1 - stance)
    return (float(hermite(stride / 2, slope, -stride / 2, slope, u)),
            lift * math.sin(math.pi * u) ** 2, 55 * math.sin(math.pi * min(1, u * 1.3)) ** 2
            * (u < 1 / 1.3) * min(1, lift * 8))


@dataclass(frozen=True)
class Measures:
    """In units of size metres. Rings are (y, z, half width, half height); those of the head count
    from its joint. A leg's rings are (share of the way, half width, half depth), from the shoulder
    to the knee and from there to the foot."""
    name: str
    size: float
    looks: dict
    body: tuple
    neck: tuple
    head_joint: tuple   # y, z
    head: tuple
    jaw: tuple
    nose: tuple
    eye: tuple          # x, y, z, radius
    ear: tuple          # (x, y, z, half width, half depth) from the root to the tip
    tail: tuple         # (y, z, radius) from the root on
    upper: dict         # by end of the body
    lower: tuple
    paw: tuple          # (y, z, half width, half depth) from the foot's joint down
    mane: tuple = ()
    leg: float = 1.0
    spread: float = .1
    forelegs_y: float = -.48
    hindlegs_y: float = .50


class Quadruped:
    """Legs bend in the plane of the walk."""

    def __init__(self, measures):
        self.m = m = measures
        self.size, s, h = m.size, m.size, 1.02 * m.leg
        y, z = m.head_joint
        self.bones = {"root": ("", vec(0, 0, 0)), "body": ("root", vec(0, 0, 1.15 * s)),
                      "neck": ("body", vec(0, -.62, 1.26) * s),
                      "head": ("neck", vec(0, y, z) * s),
                      "tail": ("body", vec(0, *m.tail[0][:2]) * s)}
        for side, sign in (("L", 1), ("R", -1)):
            for end, y, bend in (("fore", m.forelegs_y, -.05), ("hind", m.hindlegs_y, .13)):
                x = m.spread * sign
                self.bones[f"{end}_{side}"] = "body", vec(x, y, h) * s
                self.bones[f"{end}_shin_{side}"] = f"{end}_{side}", vec(x, y + bend, h * .53) * s
                self.bones[f"{end}_foot_{side}"] = (f"{end}_shin_{side}",
                                                    vec(x, y + .02, h * .10) * s)

    def shape(self, level):
        shape, m, s = Shape(level, SHARP_DEGREES), self.m, self.size
        ring = lambda weights: lambda r: (vec(0, *r[:2]) * s, r[2] * s, r[3] * s, weights)
        shape.tube([ring({"body": 1})(r) for r in m.body][::-1], 11, "coat")
        count = len(m.neck) - 1
        neck = [ring({"body": 1 - k / count, "neck": k / count} if k < count else
                     {"neck": .5, "head": .5})(r) for k, r in enumerate(m.neck)]
        shape.tube(neck[::-1], 8, "coat")
        if m.mane:
            shape.tube([ring({"neck": 1})(r) for r in m.mane][::-1], 4, "mane", until=2)
        self._add_head(shape)
        tail = [(vec(0, y, z) * s, r * s, r * s, {"tail": 1}) for y, z, r in m.tail]
        shape.tube(tail if tail[-1][0][1] > tail[0][0][1] else tail[::-1], 6, "mane")
        for side, sign in (("L", 1), ("R", -1)):
            for end in ("fore", "hind"):
                self._add_leg(shape, end, side)
        return shape

    def _add_head(self, shape):
        m, s, only = self.m, self.size, {"head": 1}
        joint = self.bones["head"][1]
        at = lambda x, y, z: joint + vec(x, y, z) * s
        ring = lambda r: (at(0, *r[:2]), r[2] * s, r[3] * s, only)
        shape.tube([ring(r) for r in m.head][::-1], 8, "coat")
        shape.tube([ring(r) for r in m.jaw][::-1], 6, "coat", until=2)
        shape.tube([ring(r) for r in m.nose][::-1], 6, "dark", until=2)
        x, y, z, radius = m.eye
        for sign in (-1, 1):
            shape.tube([(at(sign * x, y, z - radius), radius * .6 * s, radius * .6 * s, only),
                        (at(sign * (x + .3 * radius), y - .2 * radius, z), radius * s, radius * s,
                         only),
                        (at(sign * x, y, z + radius), radius * .6 * s, radius * .6 * s, only)], 5,
                       "eyes", upright=True, until=1)
            ear = [(at(sign * r[0], *r[1:3]), r[3] * s, r[4] * s, only) for r in m.ear]
            shape.tube(ear if ear[-1][0][2] > ear[0][0][2] else ear[::-1], 5, "dark",
                       upright=True, until=2)

    def _add_leg(self, shape, end, side):
        m, s = self.m, self.size
        hip, knee, foot = (self.bones[f"{end}{part}_{side}"][1] / s
                           for part in ("", "_shin", "_foot"))
        upper, lower, paw = (f"{end}{part}_{side}" for part in ("", "_shin", "_foot"))
        sign = math.copysign(1, hip[0])
        # From within the trunk, so that the shoulder grows out of it.
        _, wide, deep = m.upper[end][0]
        rings = [(hip + vec(-.45 * m.spread * sign, 0, .24), wide, deep, {"body": 1})]
        for t, wide, deep in m.upper[end][1:]:
            weights = {upper: .7, "body": .3} if t < .1 else \
                {upper: .5, lower: .5} if t == 1 else {upper: 1}
            rings.append((hip * (1 - t) + knee * t, wide, deep, weights))
        for t, wide, deep in m.lower:
            weights = {lower: .5, paw: .5} if t == 1 else {lower: 1}
            place = knee * (1 - t) + foot * t
            if t == 1 and shape.level > 1:
                place[2] = 0  # there are no paws
            rings.append((place, wide, deep, weights))
        scaled = lambda items: [(p * s, w * s, d * s, b) for p, w, d, b in items]
        shape.tube(scaled(rings[::-1]), 7, "coat", upright=True)
        shape.tube(scaled([(vec(foot[0], foot[1] + y, z), wide, deep, {paw: 1})
                           for y, z, wide, deep in m.paw][::-1]), 6, "hoof", upright=True,
                   until=1)

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

    def writer(self, walk, run):
        """(writer, node of the finest level, shapes by level)"""
        writer = CreatureWriter(self.m.name, self.m.looks, self.bones)
        shapes, s = [self.shape(level) for level in range(LEVELS)], self.size
        node = writer.skin(shapes)
        still = {n: 0 for n in ("fore_L", "fore_R", "hind_L", "hind_R")}
        writer.clip("idle", 128, lambda p: self._idle(p, still))
        for name, (speed, frames, stance, lift, shifts, bob, pitch, nod) in (("walk", walk),
                                                                             ("run", run)):
            stride = speed * frames / 32 * stance / s
            order = dict(zip(("hind_L", "fore_L", "hind_R", "fore_R"), shifts))
            writer.clip(name, frames, lambda p: self.pose(p, stride, stance, lift, order, bob,
                                                          pitch, nod), speed)
        return writer, node, shapes

    def _idle(self, phase, still):
        pose = self.pose(phase, 0, .6, 0, still, .004, 0, 1)
        pose["neck"] = None, rot_x(3 + 5 * sine(phase, .5)) @ rot_z(8 * sine(phase, 1))
        pose["head"] = None, rot_z(12 * sine(phase, 1.6)) @ rot_x(2 * sine(phase, 0, 2))
        pose["tail"] = None, rot_z(20 * sine(phase, 0, 4 if self.size < .6 else 2))
        return pose


def dog():
    """A retriever: deep chest, drawn-in loins, hanging ears."""
    looks = {
        "coat": (("", (204, 164, 112)), ("Coat black", (52, 48, 48)),
                 ("Coat white", (236, 230, 220)), ("Coat grey", (150, 146, 142))),
        "dark": (("", (128, 92, 62)), ("Ears black", (40, 36, 36))), "eyes": EYES,
        "mane": (("", (204, 164, 112)), ("Tail black", (52, 48, 48))),
        "hoof": (("", (206, 178, 140)), ("Paws white", (238, 234, 226)))}
    return Quadruped(Measures(
        "dog", .50, looks,
        body=((-.78, 1.20, .07, .10), (-.72, 1.18, .15, .20), (-.56, 1.12, .21, .28),
              (-.34, 1.08, .235, .31), (-.06, 1.09, .225, .28), (.22, 1.13, .195, .23),
              (.44, 1.16, .185, .205), (.62, 1.16, .185, .21), (.76, 1.17, .13, .16),
              (.82, 1.18, .05, .07)),
        neck=((-.52, 1.17, .17, .25), (-.66, 1.30, .145, .19), (-.76, 1.43, .13, .16),
              (-.82, 1.53, .125, .14)),
        head_joint=(-.80, 1.50),
        head=((.10, .10, .06, .07), (.06, .10, .125, .125), (-.04, .11, .155, .145),
              (-.15, .10, .15, .135), (-.23, .06, .115, .105), (-.28, .025, .085, .078),
              (-.42, .005, .074, .066), (-.49, 0, .062, .055), (-.51, -.005, .035, .035)),
        jaw=((-.16, -.03, .08, .05), (-.36, -.065, .05, .026), (-.45, -.062, .028, .016)),
        nose=((-.47, .045, .034, .020), (-.515, .034, .040, .026), (-.535, .028, .022, .016)),
        eye=(.098, -.225, .095, .022),
        ear=((.115, -.01, .215, .030, .06), (.175, -.01, .17, .026, .085),
             (.20, -.03, .06, .022, .085), (.195, -.05, -.05, .014, .04)),
        tail=((.78, 1.23, .055), (.92, 1.27, .058), (1.08, 1.36, .05), (1.22, 1.50, .042),
              (1.28, 1.62, .012)),
        upper={"fore": ((0, .045, .10), (.02, .085, .145), (.5, .072, .088), (1, .052, .060)),
               "hind": ((0, .055, .13), (.02, .095, .185), (.5, .085, .125), (1, .050, .066))},
        lower=((.35, .042, .046), (.75, .036, .040), (1, .042, .046)),
        paw=((-.005, .10, .044, .048), (-.035, .055, .058, .075), (-.055, 0, .062, .090)),
        leg=.96, spread=.135)).writer(
        (.95, 24, .62, .10, (0, .25, .5, .75), .006, 1.0, 2),
        (3.6, 14, .34, .20, (0, .55, .10, .65), .03, 5, 3))


def horse():
    looks = {
        "coat": (("", (150, 100, 66)), ("Coat black", (48, 44, 44)), ("Coat grey", (196, 192, 186)),
                 ("Coat chestnut", (168, 92, 52))),
        "dark": (("", (74, 54, 44)), ("Muzzle black", (36, 32, 32))), "eyes": EYES,
        "mane": (("", (52, 40, 34)), ("Mane pale", (214, 192, 150))),
        "hoof": (("", (70, 60, 54)), ("Hooves white", (224, 216, 204)))}
    return Quadruped(Measures(
        "horse", 1.0, looks,
        body=((-.80, 1.17, .05, .09), (-.73, 1.14, .135, .20), (-.58, 1.14, .205, .29),
              (-.36, 1.15, .235, .335), (-.08, 1.12, .255, .315), (.20, 1.13, .255, .30),
              (.44, 1.18, .250, .295), (.62, 1.20, .225, .27), (.76, 1.17, .15, .20),
              (.82, 1.14, .06, .10)),
        neck=((-.48, 1.24, .17, .28), (-.68, 1.42, .130, .240), (-.82, 1.66, .105, .190),
              (-.89, 1.88, .085, .125), (-.90, 1.98, .055, .07)),
        head_joint=(-.86, 1.93),
        head=((.06, .02, .05, .07), (.0, 0, .095, .135), (-.10, -.055, .110, .150),
              (-.20, -.115, .100, .135), (-.32, -.20, .082, .105), (-.44, -.285, .068, .085),
              (-.53, -.345, .066, .080), (-.58, -.385, .040, .050)),
        jaw=((-.06, -.13, .07, .055), (-.24, -.235, .05, .04), (-.36, -.305, .03, .02)),
        nose=((-.50, -.325, .069, .082), (-.545, -.355, .068, .078), (-.59, -.392, .045, .052)),
        eye=(.088, -.135, -.02, .024),
        ear=((.055, .02, .10, .034, .026), (.064, .01, .17, .036, .022),
             (.062, -.005, .255, .006, .006)),
        tail=((.80, 1.30, .05), (.90, 1.22, .075), (.98, .98, .085), (1.00, .70, .075),
              (.97, .48, .012)),
        upper={"fore": ((0, .07, .13), (.02, .105, .17), (.5, .082, .105), (1, .060, .066)),
               "hind": ((0, .08, .17), (.02, .125, .235), (.5, .100, .15), (1, .062, .078))},
        lower=((.35, .043, .050), (.75, .038, .042), (1, .046, .048)),
        paw=((0, .115, .046, .048), (-.015, .07, .056, .062), (-.035, 0, .068, .080)),
        mane=((-.40, 1.49, .015, .03), (-.52, 1.54, .030, .09), (-.62, 1.61, .034, .11),
              (-.74, 1.79, .036, .12), (-.86, 2.01, .034, .075),
              (-.97, 2.00, .024, .05), (-1.03, 1.92, .010, .02)),
        leg=1.0, spread=.155)).writer(
        (1.6, 36, .62, .16, (0, .25, .5, .75), .012, .8, 3),
        (6.4, 18, .30, .34, (0, .55, .12, .68), .06, 4, 5))
