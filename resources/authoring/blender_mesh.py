# SPDX-License-Identifier: MIT
"""What Blender does for us: smooth normals with hard edges, triangles, ambient occlusion."""
import math

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

import geometry


class Part:
    """Triangles of one material: split vertices, with the index of the source vertex of each and
    whatever values the corners carry (texture coordinates, a tone)."""

    def __init__(self, source, positions, normals, values, triangles):
        self.source, self.positions, self.normals = source, positions, normals
        self.values, self.triangles = values, triangles


def make_mesh(name, vertices, faces, material_of, smooth_degrees, sharp_edges=(), smooth=None):
    """A Blender mesh. Edges between materials are hard. faces: (ids, ...) per face."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(v) for v in vertices], [], faces)
    users = {}
    for polygon, material in zip(mesh.polygons, material_of):
        polygon.material_index = material
        polygon.use_smooth = True if smooth is None else smooth[material]
        for edge in polygon.edge_keys:
            users.setdefault(edge, []).append(material)
    hard = {tuple(sorted(edge)) for edge in sharp_edges}
    for edge in mesh.edges:
        key = tuple(sorted(edge.vertices))
        edge.use_edge_sharp = key in hard or len(set(users.get(edge.key, [0]))) > 1
    mesh.use_auto_smooth, mesh.auto_smooth_angle = True, math.radians(smooth_degrees)
    mesh.calc_normals_split()
    return mesh


def split_by_material(mesh, corner_values, material_count):
    """Parts by material index; None where a material is not used. A tuple of values per loop."""
    mesh.calc_loop_triangles()
    parts = []
    for material in range(material_count):
        corners, rows, triangles = {}, [], []
        for triangle in mesh.loop_triangles:
            if triangle.material_index != material:
                continue
            triangles.append([_corner(mesh, loop, corner_values[loop], corners, rows)
                              for loop in triangle.loops])
        if not rows:
            parts.append(None)
            continue
        source = np.array([row[0] for row in rows])
        parts.append(Part(source,
                          geometry.to_gltf([mesh.vertices[i].co[:] for i in source]),
                          geometry.to_gltf([row[1] for row in rows]),
                          np.array([row[2] for row in rows]), np.array(triangles)))
    return parts


def _corner(mesh, loop, values, corners, rows):
    vertex = mesh.loops[loop].vertex_index
    normal = Vector(mesh.loops[loop].normal).normalized()
    key = (vertex, tuple(round(x, 3) for x in normal), tuple(round(x, 4) for x in values))
    if key not in corners:
        corners[key] = len(rows)
        rows.append((vertex, normal[:], values))
    return corners[key]


def vertex_openness(mesh, rays, distance, strength):
    """Openness of each vertex of the mesh, see openness()."""
    return openness(mesh, [(v.co, v.normal) for v in mesh.vertices], rays, distance, strength)


def openness(mesh, points, rays, distance, strength):
    """1 = open sky, for each (position, normal), from rays over the hemisphere (ambient
    occlusion)."""
    tree = BVHTree.FromPolygons([v.co for v in mesh.vertices],
                                [tuple(p.vertices) for p in mesh.polygons])
    directions = _hemisphere(rays)
    return np.array([1 - strength * _occlusion(tree, position, normal, directions, distance)
                     for position, normal in points])


def _hemisphere(count):
    directions = []
    for i in range(count):
        z = 1 - (i + .5) / count
        radius, angle = math.sqrt(1 - z * z), i * 2.399963
        directions.append(Vector((radius * math.cos(angle), radius * math.sin(angle), z)))
    return directions


def _occlusion(tree, position, normal, directions, distance):
    turn = Vector((0, 0, 1)).rotation_difference(normal)
    origin = position + normal * distance * .015
    blocked = total = 0.0
    for direction in directions:
        total += direction.z
        hit = tree.ray_cast(origin, turn @ direction, distance)
        if hit[0] is not None:
            blocked += direction.z * (1 - hit[3] / distance) ** .5
    return blocked / total
