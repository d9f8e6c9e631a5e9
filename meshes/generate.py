#!/usr/bin/env python3
"""Writes the generated inputs of this folder: bracket.poly, nested_shells.poly, torus_knot.off, ramp.node and ramp.ele.

Nothing but Python's own library is needed. Coordinates are rounded to six digits, so every run gives the same bytes.
"""
import itertools
import math
from pathlib import Path

FOLDER = Path(__file__).parent


def number(x):
    text = f"{x:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def position(p):
    return " ".join(number(x) for x in p)


def write(name, lines):
    (FOLDER / name).write_text("\n".join(lines) + "\n")


def poly(title, points, facets, holes, regions):
    """A .poly file. A facet is (polygons, hole points in it)."""
    lines = [f"# {title}", f"{len(points)} 3 0 0"]
    lines += [f"{i} {position(p)}" for i, p in enumerate(points)]
    lines.append(f"{len(facets)} 0")
    for polygons, facet_holes in facets:
        lines.append(f"{len(polygons)} {len(facet_holes)}")
        lines += [f"{len(polygon)} " + " ".join(map(str, polygon)) for polygon in polygons]
        lines += [f"{i} {position(p)}" for i, p in enumerate(facet_holes)]
    lines.append(f"{len(holes)}")
    lines += [f"{i} {position(p)}" for i, p in enumerate(holes)]
    lines.append(f"{len(regions)}")
    lines += [f"{i} {position(seed)} {attribute} -1" for i, (seed, attribute) in enumerate(regions)]
    return lines


def bracket():
    """An L of two plates, extruded along z, with two round holes through the foot and one through the wall."""
    length, height, width, thickness, radius, sides = 4.0, 3.0, 2.0, 0.5, 0.4, 24
    outline = [(0, 0), (length, 0), (length, thickness), (thickness, thickness), (thickness, height), (0, height)]
    points = [(x, y, z) for z in (0.0, width) for x, y in outline]
    n = len(outline)
    facets = [([list(range(n))], []), ([list(range(n, 2 * n))], [])]
    sides_of_outline = [([[i, (i + 1) % n, n + (i + 1) % n, n + i]], []) for i in range(n)]

    def tunnel(place, faces, center):
        """Two rings of points on the faces' planes; each face gets the ring as polygon and its centre as hole."""
        rings = []
        for end in (0, 1):
            first = len(points)
            for s in range(sides):
                angle = 2 * math.pi * s / sides
                points.append(place(end, radius * math.cos(angle), radius * math.sin(angle)))
            rings.append(list(range(first, first + sides)))
            polygons, holes = sides_of_outline[faces[end]]
            polygons.append(rings[end])
            holes.append(center(end))
        for s in range(sides):
            t = (s + 1) % sides
            facets.append(([[rings[0][s], rings[0][t], rings[1][t], rings[1][s]]], []))

    for x in (1.6, 3.1):  # through the foot, along y: the outline's sides 0 (y = 0) and 2 (y = thickness)
        tunnel(lambda end, u, v, x=x: (x + u, end * thickness, width / 2 + v), (0, 2),
               lambda end, x=x: (x, end * thickness, width / 2))
    tunnel(lambda end, u, v: (end * thickness, 1.9 + u, width / 2 + v), (5, 3),
           lambda end: (end * thickness, 1.9, width / 2))  # through the wall, along x
    write("bracket.poly", poly("an L-shaped bracket with three round holes, region 1 (generate.py)", points,
                               facets + sides_of_outline, [], [((0.25, 0.25, 0.25), 1)]))


def icosphere(radius, levels):
    golden = (1 + math.sqrt(5)) / 2
    corners = [(s * a, t * b, 0) for a, b in [(1, golden)] for s in (-1, 1) for t in (-1, 1)]
    corners = [p for x, y, z in corners for p in ((x, y, z), (z, x, y), (y, z, x))]
    points = [tuple(c / math.hypot(*p) for c in p) for p in corners]
    edge = min(math.dist(points[0], p) for p in points[1:])
    near = lambda i, j: math.dist(points[i], points[j]) < 1.01 * edge
    triangles = [t for t in itertools.combinations(range(12), 3) if all(near(*e) for e in itertools.combinations(t, 2))]
    for _ in range(levels):
        middle = {}

        def mid(i, j):
            key = (min(i, j), max(i, j))
            if key not in middle:
                m = [(a + b) / 2 for a, b in zip(points[i], points[j])]
                middle[key] = len(points)
                points.append(tuple(c / math.hypot(*m) for c in m))
            return middle[key]

        triangles = [t for a, b, c in triangles
                     for t in ((a, mid(a, b), mid(a, c)), (b, mid(b, c), mid(a, b)), (c, mid(a, c), mid(b, c)),
                               (mid(a, b), mid(b, c), mid(a, c)))]
    return [tuple(radius * c for c in p) for p in points], triangles


def nested_shells():
    """Spheres of radius 1, 0.75 and 0.4: regions 1 and 2 between them, the innermost hollow."""
    points, facets = [], []
    for radius, levels in ((1.0, 2), (0.75, 2), (0.4, 1)):
        first = len(points)
        sphere, triangles = icosphere(radius, levels)
        points += sphere
        facets += [([[first + c for c in t]], []) for t in triangles]
    write("nested_shells.poly", poly("two nested shells around a hollow, regions 1 and 2 (generate.py)", points, facets,
                                     [(0, 0, 0)], [((0.87, 0, 0), 1), ((0.6, 0, 0), 2)]))


def torus_knot(p=2, q=3, along=240, around=12, tube=0.42):
    """The knot winds q times round the tube of a torus while it goes p times round its axis; its tube is elliptic and turns."""
    def center(t):
        r = 2 + math.cos(q * t)
        return (r * math.cos(p * t), r * math.sin(p * t), 1.1 * math.sin(q * t))

    def minus(a, b):
        return tuple(x - y for x, y in zip(a, b))

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def unit(a):
        return tuple(x / math.hypot(*a) for x in a)

    h = 1e-4
    points = []
    for i in range(along):
        t = 2 * math.pi * i / along
        before, here, after = center(t - h), center(t), center(t + h)
        tangent = unit(minus(after, before))
        bend = tuple(a - 2 * b + c for a, b, c in zip(after, here, before))
        binormal = unit(cross(tangent, bend))
        normal = cross(binormal, tangent)
        for j in range(around):
            angle = 2 * math.pi * j / around
            u, v = tube * math.cos(angle), 0.75 * tube * math.sin(angle)
            turn = 3 * t  # a whole number of turns, so that the ends meet
            u, v = u * math.cos(turn) - v * math.sin(turn), u * math.sin(turn) + v * math.cos(turn)
            points.append(tuple(c + u * n + v * b for c, n, b in zip(here, normal, binormal)))
    triangles = []
    for i, j in itertools.product(range(along), range(around)):
        a, b = i * around + j, i * around + (j + 1) % around
        c, d = ((i + 1) % along) * around + (j + 1) % around, ((i + 1) % along) * around + j
        triangles += [(a, b, c), (a, c, d)]
    write("torus_knot.off", ["OFF", f"{len(points)} {len(triangles)} 0"] + [position(p) for p in points] +
          ["3 " + " ".join(map(str, t)) for t in triangles])


def ramp(n=4):
    """The unit cube, n cubes a side, six tetrahedra a cube along its diagonal; the attributes are x + 2y + 3z and |p|^2."""
    side = range(n + 1)
    points = [(x / n, y / n, z / n) for z in side for y in side for x in side]
    write("ramp.node", ["# attributes: x + 2 y + 3 z; x^2 + y^2 + z^2 (generate.py)", f"{len(points)} 3 2 0"] +
          [f"{i + 1} {position(p)} {number(p[0] + 2 * p[1] + 3 * p[2])} {number(sum(c * c for c in p))}"
           for i, p in enumerate(points)])
    tetrahedra = []
    for z, y, x in itertools.product(range(n), repeat=3):
        for axes in itertools.permutations(range(3)):
            corner = [x, y, z]
            path = [tuple(corner)]
            for axis in axes:
                corner[axis] += 1
                path.append(tuple(corner))
            odd = axes in ((1, 0, 2), (0, 2, 1), (2, 1, 0))
            if odd:
                path[1], path[2] = path[2], path[1]
            tetrahedra.append([1 + i + (n + 1) * (j + (n + 1) * k) for i, j, k in path] + [1 if x < n // 2 else 2])
    write("ramp.ele", ["# the attribute is 1 where x < 1/2, else 2 (generate.py)", f"{len(tetrahedra)} 4 1"] +
          [f"{i + 1} " + " ".join(map(str, t)) for i, t in enumerate(tetrahedra)])


if __name__ == "__main__":
    bracket()
    nested_shells()
    torus_knot()
    ramp()
