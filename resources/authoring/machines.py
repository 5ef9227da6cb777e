# SPDX-License-Identifier: MIT
"""The helicopter and the forklift: stiff meshes on moving nodes."""
import math

from creature_file import LEVELS, CreatureWriter, Shape
from geometry import FULL_TURN, rot_x, rot_y, rot_z, smoothstep, vec

WHEEL_SIDES = (9, 8, 6, 3)


def sine(phase, shift=0.0, times=1):
    return math.sin(times * FULL_TURN * phase + shift)


def ring(y, z, wide, high):
    return vec(0, y, z), wide, high, None


def post(shape, x, y, low, high, radius, sides=6, slot="metal", until=LEVELS):
    shape.tube([(vec(x, y, low), radius, radius, None), (vec(x, y, high), radius, radius, None)],
               sides, slot, upright=True, until=until)


def helicopter_hull(level):
    hull = Shape(level)
    hull.tube([ring(5.3, 2.14, .05, .08), ring(4.4, 2.06, .11, .14), ring(3.2, 1.96, .16, .20),
               ring(2.1, 1.84, .25, .32), ring(1.4, 1.72, .42, .50), ring(.9, 1.57, .72, .70),
               ring(.4, 1.49, .83, .79), ring(-.3, 1.42, .86, .81), ring(-.9, 1.38, .84, .78)],
              14, "paint")
    hull.tube([ring(-.86, 1.38, .83, .77), ring(-1.3, 1.34, .77, .71), ring(-1.75, 1.26, .61, .56),
               ring(-2.1, 1.16, .40, .37), ring(-2.36, 1.08, .09, .09)], 13, "glass")
    hull.tube([ring(-1.02, 1.02, .70, .44), ring(-1.6, 1.00, .56, .36), ring(-2.16, .98, .30, .22),
               ring(-2.40, .98, .07, .06)], 10, "paint", until=1)  # below the windscreen
    # The fin leans back and is thinner at its edges; the tailplane has end plates.
    hull.tube([(vec(0, 4.95, 1.95), .06, .34, None), (vec(0, 5.10, 2.45), .05, .28, None),
               (vec(0, 5.28, 2.95), .03, .18, None)], 6, "trim", upright=True)
    hull.box((-.80, 4.2, 2.02), (.80, 4.52, 2.07), "trim", until=2)
    for sign in (-1, 1):
        hull.box((sign * .82 - .02, 4.10, 1.86), (sign * .82 + .02, 4.60, 2.26), "trim", until=0)
    hull.tube([ring(1.3, 2.14, .12, .12), ring(.9, 2.22, .30, .22), ring(.0, 2.26, .34, .24),
               ring(-.5, 2.20, .22, .16), ring(-.72, 2.12, .06, .06)], 8, "paint", until=1)
    for sign in (-1, 1):
        hull.tube([(vec(sign * .22, 1.65, 2.22), .08, .08, None),
                   (vec(sign * .22, .95, 2.26), .09, .09, None)], 6, "metal", until=0)
    post(hull, 0, 0, 2.44, 2.80, .075, 8, until=1)
    for sign in (-1, 1):
        _add_side(hull, sign)
    return hull


def _add_side(hull, sign):
    """Skid with a bent-up toe, struts, a window, a door and its handle."""
    x = sign * .92
    hull.tube([(vec(x, -1.85, .24), .03, .03, None), (vec(x, -1.62, .08), .045, .045, None),
               (vec(x, 0, .06), .045, .045, None), (vec(x, 1.35, .06), .045, .045, None)], 6,
              "metal", until=2)
    if hull.level == 3:
        hull.box((x - .05, -1.7, .02), (x + .05, 1.35, .10), "metal")
    for y in (-.85, .75):
        hull.tube([(vec(x, y, .07), .034, .034, None), (vec(sign * .80, y, .45), .034, .034, None),
                   (vec(sign * .52, y, .86), .05, .05, None)], 6, "metal", upright=True, until=2)
    hull.box((sign * .845 - .02, -.62, 1.32), (sign * .845 + .02, -.02, 1.78), "glass", until=2)
    hull.box((sign * .845 - .02, .12, 1.38), (sign * .845 + .02, .50, 1.74), "glass", until=0)
    hull.box((sign * .86 - .012, -.64, 1.14), (sign * .86 + .012, .52, 1.26), "trim", until=1)
    hull.box((sign * .875 - .012, -.12, 1.29), (sign * .875 + .012, -.02, 1.31), "metal", until=0)
    hull.box((sign * .30 - .03, -2.22, .92), (sign * .30 + .03, -2.14, 1.0), "lamp", until=0)


def helicopter_rotor(level):
    """Four blades, broader towards the tip and drooping, on a hub with cuffs."""
    rotor = Shape(level)
    sections = ((.16, .05, 0), (.55, .05, .005), (.60, .10, .005), (2.4, .105, .0),
                (4.2, .11, -.06))
    if level >= 2:
        sections = (sections[0], sections[-1])
    for k in range(4):
        c, s = math.cos(k * math.pi / 2), math.sin(k * math.pi / 2)
        rows = []
        for along, half, drop in sections:
            corners = ((along, -half, .028), (along, half, 0), (along, half * .3, -.012))
            rows.append(rotor.add([vec(a * c - b * s, a * s + b * c, 2.76 + z + drop)
                                   for a, b, z in corners], None))
        for low, high in zip(rows[:-1], rows[1:]):
            for i in range(3):
                j = (i + 1) % 3
                rotor.face([low[i], high[i], high[j], low[j]], "metal")
        rotor.face(rows[-1], "metal")
        rotor.face(rows[0][::-1], "metal")
    rotor.tube([(vec(0, 0, 2.66), .17, .17, None), (vec(0, 0, 2.76), .19, .19, None),
                (vec(0, 0, 2.88), .10, .10, None)], 8, "metal", upright=True, until=1)
    return rotor


def helicopter_tail(level):
    tail = Shape(level)
    tail.box((.20, 4.87, 1.75), (.23, 4.93, 2.95), "metal")
    tail.box((.20, 4.30, 2.32), (.23, 5.50, 2.38), "metal", until=2)
    tail.tube([(vec(.17, 4.90, 2.29), .07, .07, None), (vec(.17, 4.90, 2.41), .07, .07, None)], 6,
              "metal", upright=True, until=1)
    return tail


def helicopter():
    bones = {"root": ("", vec(0, 0, 0)), "hull": ("root", vec(0, 0, 1.4)),
             "rotor": ("hull", vec(0, 0, 2.75)), "tail_rotor": ("hull", vec(.22, 4.9, 2.35))}
    writer = CreatureWriter("helicopter", {
        "paint": (("", (214, 208, 196)), ("Paint red", (186, 48, 42)), ("Paint navy", (48, 62, 96)),
                  ("Paint yellow", (232, 182, 52))),
        "trim": (("", (176, 62, 52)), ("Trim dark", (60, 62, 66))),
        "glass": (("", (70, 92, 108)),), "metal": (("", (88, 90, 94)),),
        "lamp": (("", (250, 240, 210)),)}, bones)
    parts = {"hull": helicopter_hull, "rotor": helicopter_rotor, "tail_rotor": helicopter_tail}
    shapes = {name: [build(level) for level in range(LEVELS)] for name, build in parts.items()}
    for name, own in shapes.items():
        writer.hang(name, own)

    def fly(phase, height, nose, turns):
        return {"hull": (vec(.05 * sine(phase), 0, height + .06 * sine(phase, 1, 2)),
                         rot_x(nose) @ rot_y(1.2 * sine(phase)) @ rot_z(sine(phase, .7))),
                "rotor": (None, rot_z(90 * phase * turns)),
                "tail_rotor": (None, rot_x(180 * phase * turns))}
    writer.clip("idle", 96, lambda p: fly(p, 0, 0, 24) | {"hull": (vec(0, 0, 0), rot_x(0))})
    writer.clip("hover", 96, lambda p: fly(p, 1.0, 0, 24))
    writer.clip("fly", 96, lambda p: fly(p, 1.0, 8, 24), 12.0)
    return writer, None, [sum((own[level].faces for own in shapes.values()), [])
                          for level in range(LEVELS)]


def forklift_body(level):
    body = Shape(level)
    body.box((-.46, -.95, .22), (.46, .30, .62), "paint")
    # The counterweight is round at the back.
    body.tube([(vec(0, 1.20, .66), .40, .30, None), (vec(0, 1.12, .66), .50, .37, None),
               (vec(0, .86, .66), .54, .40, None), (vec(0, .22, .66), .52, .38, None)][::-1], 10,
              "paint")
    body.box((-.50, .22, .26), (.50, 1.02, .80), "paint", until=2)
    body.box((-.34, 1.14, .44), (.34, 1.22, .62), "dark", until=0)
    for z in (.74, .80, .86):
        body.box((-.30, 1.13, z), (.30, 1.20, z + .025), "dark", until=0)
    body.box((-.30, .06, .74), (.30, .24, 1.40), "dark", until=2)
    body.box((-.24, .02, 1.36), (.24, .22, 1.52), "dark", until=0)
    body.box((-.30, -.40, .62), (.30, .12, .76), "dark", until=2)
    for sign in (-1, 1):
        body.box((sign * .32 - .04, -.22, .86), (sign * .32 + .04, .10, .91), "dark", until=0)
    body.box((-.40, -.90, .62), (.40, -.72, .92), "paint", until=2)
    post(body, 0, -.64, .84, 1.08, .035, 5, "dark", until=0)
    body.tube([(vec(0, -.60, 1.06), .19, .17, None), (vec(0, -.60, 1.09), .19, .17, None)], 10,
              "dark", upright=True, until=1)
    _add_guard(body)
    _add_mast(body)
    body.tube([(vec(0, .60, 1.03), .15, .15, None), (vec(0, .60, 1.12), .13, .13, None),
               (vec(0, .60, 1.17), .07, .07, None)], 8, "lamp", upright=True, until=1)
    return body


def _add_guard(body):
    """Posts and a roof of bars, with a lamp at each corner in front."""
    for x in (-.45, .45):
        post(body, x, -.82, .60, 2.08, .035, 6)
        post(body, x, .42, .95, 2.08, .035, 6, until=2)
        body.box((x - .04, -.90, 2.06), (x + .04, .52, 2.13), "metal", until=1)
        body.box((x * .78 - .07, -.95, 1.86), (x * .78 + .07, -.88, 2.0), "lamp", until=0)
    bars = {0: (-.86, -.46, -.06, .34), 1: (-.86, -.26, .34)}
    for y in bars.get(body.level, ()):
        body.box((-.45, y, 2.07), (.45, y + .10, 2.12), "metal")
    if body.level >= 2:
        body.box((-.45, -.88, 2.07), (.45, .50, 2.11), "metal")


def _add_mast(body):
    if body.level == 3:
        body.box((-.33, -1.10, .10), (.33, -.98, 2.10), "metal")
    for sign in (-1, 1):
        body.box((sign * .30 - .035, -1.10, .10), (sign * .30 + .035, -.98, 2.10), "metal",
                 until=2)
        body.box((sign * .22 - .025, -1.13, .12), (sign * .22 + .025, -1.04, 2.04), "dark", until=0)
        post(body, sign * .13, -1.06, .20, 1.90, .02, 4, "dark", until=0)
    for z in (.16, 1.10, 2.02):
        body.box((-.32, -1.08, z), (.32, -1.01, z + .08), "metal", until=0 if z == 1.10 else 1)
    body.tube([(vec(0, -1.04, .20), .05, .05, None), (vec(0, -1.04, 1.30), .05, .05, None)], 6,
              "metal", upright=True, until=0)


def forklift_fork(level):
    fork = Shape(level)
    for z in (.10, .52):
        fork.box((-.42, -1.20, z), (.42, -1.13, z + .11), "metal", until=1)
    if level >= 2:
        fork.box((-.42, -1.20, .10), (.42, -1.13, .62), "metal")
    for x in (-.38, -.13, .13, .38):
        fork.box((x - .02, -1.17, .62), (x + .02, -1.13, 1.05), "metal", until=0)
    fork.box((-.40, -1.17, 1.03), (.40, -1.13, 1.08), "metal", until=0)
    for x in (-.26, .26):
        fork.box((x - .06, -1.25, .06), (x + .06, -1.19, .66), "metal", until=2)
        # A tine gets thinner and narrower towards its tip.
        rows = [fork.add([vec(x - w, y, .06), vec(x + w, y, .06), vec(x + w, y, z),
                          vec(x - w, y, z)], None)
                for y, w, z in ((-1.20, .06, .115), (-1.75, .06, .105), (-2.15, .035, .075))]
        rows = rows if level < 2 else [rows[0], rows[-1]]
        for near, far in zip(rows[:-1], rows[1:]):
            for i in range(4):
                j = (i + 1) % 4
                fork.face([near[i], near[j], far[j], far[i]][::-1], "metal")
        fork.face(rows[-1][::-1], "metal")
    return fork


def forklift_wheel(place, radius, level):
    """A tyre with shoulders and a hub that lies a little deeper."""
    wheel, sides = Shape(level), WHEEL_SIDES[level]
    turns = [FULL_TURN * (i + .5) / sides for i in range(sides)]
    profile = ((-.10, .52, "metal"), (-.115, .80, "tyre"), (-.09, 1.0, "tyre"), (.09, 1.0, "tyre"),
               (.115, .80, "tyre"), (.10, .52, "tyre"))
    if level == 1:
        profile = (profile[0], profile[2], profile[3], profile[5])
    if level >= 2:
        profile = ((-.10, 1.0, "tyre"), (.10, 1.0, "tyre"))
    rows = [wheel.add([place + vec(x, radius * r * math.cos(t), radius * r * math.sin(t))
                       for t in turns], None) for x, r, _ in profile]
    for low, high in zip(rows[:-1], rows[1:]):
        for i in range(sides):
            j = (i + 1) % sides
            wheel.face([low[i], low[j], high[j], high[i]], "tyre")
    hub = "metal" if level < 2 else "tyre"
    wheel.face(rows[0][::-1], hub)
    wheel.face(rows[-1], hub)
    return wheel


def forklift():
    bones = {"root": ("", vec(0, 0, 0)), "chassis": ("root", vec(0, 0, .3)),
             "fork": ("chassis", vec(0, -1.15, .3))}
    wheels = {f"wheel_{end}_{side}": (vec(sign * .50, y, r), r) for end, y, r in
              (("front", -.72, .31), ("back", .62, .25)) for side, sign in (("L", 1), ("R", -1))}
    bones.update({name: ("chassis", place) for name, (place, _) in wheels.items()})
    writer = CreatureWriter("forklift", {
        "paint": (("", (232, 176, 52)), ("Paint orange", (222, 112, 44)),
                  ("Paint green", (92, 140, 84)), ("Paint grey", (160, 164, 168))),
        "dark": (("", (58, 58, 62)),), "metal": (("", (98, 100, 106)),),
        "lamp": (("", (236, 150, 60)),), "tyre": (("", (38, 38, 40)),)}, bones)
    shapes = {"chassis": [forklift_body(level) for level in range(LEVELS)],
              "fork": [forklift_fork(level) for level in range(LEVELS)]}
    for name, (place, radius) in wheels.items():
        shapes[name] = [forklift_wheel(place, radius, level) for level in range(LEVELS)]
    for name, own in shapes.items():
        writer.hang(name, own)

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
    return writer, None, [sum((own[level].faces for own in shapes.values()), [])
                          for level in range(LEVELS)]
