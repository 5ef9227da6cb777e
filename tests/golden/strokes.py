# SPDX-License-Identifier: MIT
"""Each brush, with each way to select and each operator, over a small crowd seen from above."""
import math

from crowdbrush import (Brush, BrushKind, Camera, Facing, Operator, Scene, Selection)

SIZE = (640, 480)
CAMERA = Camera((0.0, 14.0, 10.0), (0.0, 0.0, 0.0))
SELECTIONS = (Selection.POINT, Selection.SPRAY, Selection.ALL_IN_CIRCLE, Selection.RECTANGLE)
OPERATORS = (Operator.UNIFORM, Operator.RANDOM, Operator.GRADIENT)


def crowd():
    """Forty-eight people of two kinds in rows."""
    scene = Scene()
    kinds = [scene.add_template(f"builtin:templates/{name}.glb") for name in ("man", "woman")]
    places = [(1.2 * (i % 8) - 4.2, 0.0, 1.3 * (i // 8) - 3.2) for i in range(48)]
    scene.create(template=[kinds[i % 2].id for i in range(48)], position=places, clip="idle",
                 heading=[0.13 * i for i in range(48)], seed=list(range(100, 148)))
    scene.set_camera("Above", CAMERA)
    return scene


def way(n=40, seconds=0.8):
    """A bent way across the picture, with pressure and time."""
    return [(90 + 460 * i / n, 240 + 90 * math.sin(6 * i / n), 0.4 + 0.6 * i / n, seconds * i / n)
            for i in range(n + 1)]


def of_creation(brush, scene):
    brush.create.mix = {template: 1.0 + i for i, template in enumerate(scene.templates)}
    brush.create.height = (0.9, 1.1)
    brush.create.density = 0.4


def of_colour(brush, scene):
    brush.colour.slot = "top"
    brush.colour.colors = [(200, 30, 60), (20, 120, 220), (250, 240, 20)]
    brush.colour.strength = 0.73


def of_orientation(brush, scene):
    brush.orientation.facing.mode = Facing.TOWARDS_POINT
    brush.orientation.facing.towards_point = (3.0, 0.0, -4.0)
    brush.orientation.facing.spread = 0.4


def of_animation(brush, scene):
    brush.animation.clips = {"walk": 1.0, "idle": 0.5}
    brush.animation.sets_phase = True
    brush.animation.sets_speed = True
    brush.animation.speed = (0.8, 1.3)


def of_walking(brush, scene):
    scene.set_environment({
        "places": [{"id": 1, "name": "A", "position": [-4, 0, 0], "radius": 1},
                   {"id": 2, "name": "B", "position": [4, 0, 2], "radius": 1.5}],
        "paths": [{"id": 1, "name": "Way", "places": [1, 2]}]})
    brush.walk.path = 1
    brush.walk.sets_speed = True
    brush.walk.speed = (1.0, 2.0)


def of_style(brush, scene):
    brush.style.clips = {"walk": 1.0}
    brush.style.sets_speed = True
    brush.style.speed = (0.7, 1.4)


def of_tag(brush, scene):
    scene.set_environment({"tags": [{"tag": 5, "name": "chorus"}]})
    brush.tag = 5


def of_removal(brush, scene):
    brush.removal.percent = 60.0


KINDS = {
    BrushKind.CREATE: of_creation, BrushKind.DELETE: of_removal, BrushKind.COLOUR: of_colour,
    BrushKind.ORIENTATION: of_orientation, BrushKind.ANIMATION: of_animation,
    BrushKind.WALK: of_walking, BrushKind.STYLE: of_style, BrushKind.TAG: of_tag,
}


def painted(kind, selection, operator):
    scene = crowd()
    brush = Brush(kind)
    brush.selection = selection
    brush.operator = operator
    brush.radius = 55
    brush.rate = 90
    brush.pressure_size = operator == Operator.RANDOM
    KINDS[kind](brush, scene)
    scene.stroke(brush, way(), camera=CAMERA, size=SIZE, seed=11, time=0.6)
    return scene


def edited():
    """Without brushes: columns, cameras, light, undo and redo."""
    scene = crowd()
    ids = scene.ids
    scene.change(ids[::3], tint=(10, 200, 30), height=1.1, girth=0.9, phase=0.25, speed=1.5)
    scene.remove(ids[5:9])
    scene.undo()
    scene.remove(ids[1:3])
    scene.change(ids[10:20], heading=1.5)
    scene.undo()
    scene.redo()
    return scene


def cases():
    """Pairs of name and what makes the scene."""
    made = []
    for kind in KINDS:
        for selection in SELECTIONS:
            for operator in OPERATORS:
                name = "_".join(str(each).rsplit(".", 1)[-1].lower()
                                for each in (kind, selection, operator))
                made.append((name, lambda a=kind, b=selection, c=operator: painted(a, b, c)))
    made.append(("edited_without_brushes", edited))
    return made
