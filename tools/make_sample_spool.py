#!/usr/bin/env python3
"""Writes the sample design assets/sample/spool.glb: a flanged NPS 3 spool with an NPS 2 branch.

Sizes are B36.10M pipe (STD wall), B16.9 fittings and B16.5 class 150 weld-neck flanges in millimetres;
one glTF node a part, the part's own frame at its node, semantics in extras.spoolsight. Standard library
only. Run: tools/make_sample_spool.py [OUT.glb]
"""
import math
import sys
from pathlib import Path

from solid_glb import check, cross, write_glb

# B36.10M: outside diameter, STD wall (mm) by NPS.
PIPE = {2: (60.3, 3.91), 3: (88.9, 5.49)}
# B16.9: long-radius 90 A, 45 B, by NPS; reducing tee 3x2 run C, outlet M.
ELBOW_90_LR = {2: 76.0, 3: 114.0}
ELBOW_45 = {2: 35.0, 3: 51.0}
TEE_3X2 = (86.0, 76.0)
# B16.5 class 150 weld neck: OD, thickness with raised face, raised-face diameter, bolt circle, holes,
# hole diameter, hub diameter at its base, length through hub.
FLANGE_150 = {2: (152.4, 19.0, 92.1, 120.6, 4, 19.0, 77.8, 63.5),
              3: (190.5, 23.8, 127.0, 152.4, 4, 19.0, 107.9, 69.8)}
RAISED_FACE = 1.6
SEGMENTS = 96  # round the largest circle: chord error 0.024 mm at NPS 3


class Mesh:
    """Triangles in millimetres, counter-clockwise from outside; corners are welded when written."""

    def __init__(self):
        self.triangles = []

    def quad(self, a, b, c, d):
        self.triangles += [(a, b, c), (a, c, d)]

    def strip(self, lower, upper):
        """Closed loops of equal length joined by quads; lower to upper, loops anticlockwise from outside."""
        n = len(lower)
        for i in range(n):
            j = (i + 1) % n
            self.quad(lower[i], lower[j], upper[j], upper[i])


    def zip(self, lower, upper):
        """Closed loops of different lengths about the z axis, both by rising angle, joined by triangles."""
        angle = lambda loop, i: math.atan2(loop[i % len(loop)][1], loop[i % len(loop)][0]) % (2 * math.pi) \
            + 2 * math.pi * (i // len(loop))
        i = j = 0
        while i < len(lower) or j < len(upper):
            if j == len(upper) or (i < len(lower) and angle(lower, i + 1) <= angle(upper, j + 1)):
                self.triangles.append((lower[i % len(lower)], lower[(i + 1) % len(lower)], upper[j % len(upper)]))
                i += 1
            else:
                self.triangles.append((lower[i % len(lower)], upper[(j + 1) % len(upper)], upper[j % len(upper)]))
                j += 1


def circle(radius, z, n=SEGMENTS, phase=0.0):
    return [(radius * math.cos(phase + 2 * math.pi * i / n), radius * math.sin(phase + 2 * math.pi * i / n), z)
            for i in range(n)]


def revolve(mesh, profile, n=SEGMENTS):
    """Solid of revolution about z from a closed profile of (radius, z), anticlockwise in the (r, z) plane."""
    loops = [circle(r, z, n) for r, z in profile]
    for i, loop in enumerate(loops):
        mesh.strip(loop, loops[(i + 1) % len(loops)])


def pipe(nps, length):
    od, wall = PIPE[nps]
    mesh = Mesh()
    r, b = od / 2, od / 2 - wall
    # z from 0 to length; outer wall upwards, top ring, bore downwards, bottom ring.
    revolve(mesh, [(r, 0.0), (r, length), (b, length), (b, 0.0)])
    ports = [("in", (0, 0, 0), (0, 0, -1), nps, "BW"), ("out", (0, 0, length), (0, 0, 1), nps, "BW")]
    return mesh, ports, {}


def elbow(nps, angle_deg, leg):
    """Inlet at the origin heading +z, turning towards +x; `leg` is centre to end."""
    od, wall = PIPE[nps]
    angle = math.radians(angle_deg)
    bend = leg / math.tan(angle / 2)  # the arc that closes the take-off (45s: B / tan 22.5)
    steps = max(12, int(angle_deg / 90 * 26))

    def ring(radius, t):
        # Section at bend angle t: centre on the arc about (bend, 0, 0), spanned by the outward radius and y.
        cx, cz = bend - bend * math.cos(t), bend * math.sin(t)
        loop = []
        for i in range(SEGMENTS):
            p = 2 * math.pi * i / SEGMENTS
            u, v = radius * math.cos(p), radius * math.sin(p)
            loop.append((cx + u * math.cos(t), v, cz - u * math.sin(t)))
        return loop

    mesh = Mesh()
    r, b = od / 2, od / 2 - wall
    ts = [angle * i / steps for i in range(steps + 1)]
    outer = [ring(r, t) for t in ts]
    inner = [ring(b, t) for t in ts]
    for i in range(steps):
        mesh.strip(outer[i], outer[i + 1])
        mesh.strip(inner[i + 1], inner[i])
    mesh.strip(outer[-1], inner[-1])
    mesh.strip(inner[0], outer[0])
    end = (bend - bend * math.cos(angle), 0, bend * math.sin(angle))
    heading = (math.sin(angle), 0, math.cos(angle))
    ports = [("in", (0, 0, 0), (0, 0, -1), nps, "BW"), ("out", end, heading, nps, "BW")]
    return mesh, ports, {}


def holed_plate(mesh, z, inner, outer, bolt_circle, holes, hole, up):
    """The ring between two radii with its bolt holes at height z; returns the outer, inner and hole loops.

    Each hole has its sector of the ring from a chord x0 outwards, joined to the hole along rays from the
    hole's centre, to which that piece is star-shaped; neighbours share the points of their common edge by
    mirror symmetry. The chords' polygon is zipped to the inner circle.
    """
    sector = 2 * math.pi / holes
    c = bolt_circle / 2
    x0 = (inner + c - hole / 2) / 2

    def reach(direction):
        """Distance from the hole's centre (c, 0) to the piece's edge along a direction."""
        dx, dy = math.cos(direction), math.sin(direction)
        along = c * dx
        best = -along + math.sqrt(along * along - (c * c - outer * outer))
        if dx < 0:
            best = min(best, (x0 - c) / dx)
        for side in (1, -1):
            nx, ny = -math.sin(sector / 2), side * math.cos(sector / 2)
            speed = dx * nx + dy * ny
            if speed > 1e-12:
                best = min(best, -c * nx / speed)
        return best

    corners = []
    for x, y in ((x0, x0 * math.tan(sector / 2)),
                 (outer * math.cos(sector / 2), outer * math.sin(sector / 2))):
        corners += [math.atan2(y, x - c), math.atan2(-y, x - c)]
    directions = sorted({round(d, 12) for d in
                         [2 * math.pi * i / 48 - math.pi for i in range(48)] + corners})
    hole_loops, outer_points, inner_points = [], [], []
    for k in range(holes):
        turn = sector / 2 + sector * k  # two-holed: the pattern straddles the part's x and y axes

        def place(x, y, turn=turn):
            return (x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), z)

        ring, edge = [], []
        for d in directions:
            t = reach(d)
            x, y = c + t * math.cos(d), t * math.sin(d)
            ring.append(place(c + hole / 2 * math.cos(d), hole / 2 * math.sin(d)))
            edge.append(place(x, y))
            radius = math.hypot(x, y)
            if abs(radius - outer) < 1e-6:
                outer_points.append(place(x, y))
            if abs(x - x0) < 1e-6:
                inner_points.append(place(x, y))
        if up:
            mesh.strip(edge, ring)
        else:
            mesh.strip(ring, edge)
        hole_loops.append(ring)

    def ordered(points):
        seen = {}
        for p in points:
            seen[round(math.atan2(p[1], p[0]) / (2 * math.pi), 7) % 1.0] = p
        return [seen[key] for key in sorted(seen)]

    polygon, rim = ordered(inner_points), circle(inner, z)
    mesh.zip(polygon, rim) if up else mesh.zip(rim, polygon)
    return ordered(outer_points), rim, hole_loops


def at(loop, z, radius=None):
    if radius is None:
        return [(x, y, z) for x, y, _ in loop]
    return [(x * radius / math.hypot(x, y), y * radius / math.hypot(x, y), z) for x, y, _ in loop]


def flange(nps):
    """Weld neck: raised face at z = 0 looking +z, weld end at z = -length."""
    od, thickness, rf, bolt_circle, holes, hole, hub, length = FLANGE_150[nps]
    pipe_od, wall = PIPE[nps]
    mesh = Mesh()
    bore = pipe_od / 2 - wall
    front_outer, front_inner, front_holes = holed_plate(
        mesh, -RAISED_FACE, rf / 2, od / 2, bolt_circle, holes, hole, True)
    back_outer, back_inner, back_holes = holed_plate(
        mesh, -thickness, hub / 2, od / 2, bolt_circle, holes, hole, False)
    mesh.strip(at(front_outer, -thickness), front_outer)          # rim
    for front, back in zip(front_holes, back_holes):              # hole walls face their axis
        mesh.strip(front, back)
    face = at(front_inner, 0.0)
    mesh.strip(front_inner, face)                                 # step of the raised face
    mesh.strip(face, at(front_inner, 0.0, bore))                  # raised face
    weld = at(back_inner, -length, pipe_od / 2)
    land = at(back_inner, -length + 6.0, pipe_od / 2)             # short straight land at the weld end
    mesh.strip(land, back_inner)                                  # hub cone
    mesh.strip(weld, land)
    mesh.strip(at(back_inner, -length, bore), weld)               # weld-end ring
    mesh.strip(at(front_inner, 0.0, bore), at(front_inner, -length, bore))  # bore
    ports = [("weld", (0, 0, -length), (0, 0, -1), nps, "BW"), ("face", (0, 0, 0), (0, 0, 1), nps, "FL")]
    extras = {"rating": "150", "holes": {"count": holes, "bolt_circle_m": bolt_circle / 1000,
                                         "clocking_rad": math.pi / holes}}
    return mesh, ports, extras


def tee(nps, nps2, run_c, outlet_m):
    """Run along z, centred; branch along +x."""
    mesh = Mesh()
    (od, wall), (od2, wall2) = PIPE[nps], PIPE[nps2]
    across, along, rings = 48, 40, 10

    def shell(radius, branch_radius, outward):
        # Run surface unrolled: (z in -C..C, angle in -pi..pi, 0 at the branch); the boundary rectangle is
        # joined to the branch's opening by rings between them.
        edge = []
        for i in range(across):
            edge.append((run_c, -math.pi + 2 * math.pi * i / across))
        for i in range(along):
            edge.append((run_c - 2 * run_c * i / along, math.pi))
        for i in range(across):
            edge.append((-run_c, math.pi - 2 * math.pi * i / across))
        for i in range(along):
            edge.append((-run_c + 2 * run_c * i / along, -math.pi))
        loops = []
        for ring in range(rings + 1):
            t = (ring / rings) ** 1.5  # finer at the opening
            loop = []
            for z, angle in edge:
                phi = math.atan2(angle / math.pi, z / run_c)
                z0 = branch_radius * math.cos(phi)
                a0 = math.asin(branch_radius * math.sin(phi) / radius)
                zz, aa = z0 + t * (z - z0), a0 + t * (angle - a0)
                loop.append((radius * math.cos(aa), radius * math.sin(aa), zz))
            loops.append(loop)
        opening = loops[0]
        end = [(outlet_m, y, z) for _, y, z in opening]
        ordered = loops if outward else loops[::-1]
        for a, b in zip(ordered, ordered[1:]):
            mesh.strip(a, b)
        mesh.strip(*((end, opening) if outward else (opening, end)))
        top = [(radius * math.cos(a), radius * math.sin(a), run_c) for z, a in edge[:across]]
        return end, top

    outer_end, outer_top = shell(od / 2, od2 / 2, True)
    inner_end, inner_top = shell(od / 2 - wall, od2 / 2 - wall2, False)
    mesh.strip(inner_end, outer_end)
    mesh.strip(outer_top, inner_top)
    mesh.strip(at(inner_top, -run_c), at(outer_top, -run_c))
    ports = [("in", (0, 0, -run_c), (0, 0, -1), nps, "BW"), ("out", (0, 0, run_c), (0, 0, 1), nps, "BW"),
             ("branch", (outlet_m, 0, 0), (1, 0, 0), nps2, "BW")]
    return mesh, ports, {"nps2": nps2}


# --- placing parts: 4x4 matrices, row-major, millimetres -------------------------------------------------

def matrix(columns, origin):
    return [[columns[j][i] for j in range(3)] + [origin[i]] for i in range(3)] + [[0, 0, 0, 1]]


def apply(m, p):
    return tuple(sum(m[i][j] * p[j] for j in range(3)) + m[i][3] for i in range(3))


def turn(m, d):
    return tuple(sum(m[i][j] * d[j] for j in range(3)) for i in range(3))


def place(z_axis, x_axis, origin):
    return matrix((x_axis, cross(z_axis, x_axis), z_axis), origin)


def build():
    """The spool: F1 - P1 - E1 - P2 - T1 - P3 - F2, and on T1's branch P4 - E2 - P5 - F3."""
    parts = []

    def add(name, kind, nps, shape, pose, **extras):
        mesh, ports, more = shape
        parts.append({"name": name, "mesh": mesh, "pose": pose, "extras": {
            "kind": kind, "nps": nps, "schedule": "STD", "order": len(parts), "spool": "SAMPLE-1",
            **more, **extras,
            "ports": [{"name": n, "position": [c / 1000 for c in p], "direction": list(d), "nps": s, "end": e}
                      for n, p, d, s, e in ports]}})
        return {n: (apply(pose, p), turn(pose, d)) for n, p, d, s, e in ports}

    x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
    minus = lambda v: tuple(-c for c in v)
    length3, length2 = FLANGE_150[3][7], FLANGE_150[2][7]
    # F1's face lies at the design's origin and looks -x.
    add("F1", "flange", 3, flange(3), place(minus(x), z, (0, 0, 0)))
    p1 = add("P1", "pipe", 3, pipe(3, 260), place(x, y, (length3, 0, 0)))
    e1 = add("E1", "elbow", 3, elbow(3, 90, ELBOW_90_LR[3]), place(x, z, p1["out"][0]))
    p2 = add("P2", "pipe", 3, pipe(3, 180), place(z, y, e1["out"][0]))
    run_c, outlet_m = TEE_3X2
    centre = tuple(a + run_c * b for a, b in zip(p2["out"][0], z))
    t1 = add("T1", "tee", 3, tee(3, 2, run_c, outlet_m), place(z, y, centre))
    p3 = add("P3", "pipe", 3, pipe(3, 150), place(z, y, t1["out"][0]))
    face2 = tuple(a + length3 * b for a, b in zip(p3["out"][0], z))
    add("F2", "flange", 3, flange(3), place(z, y, face2))
    p4 = add("P4", "pipe", 2, pipe(2, 120), place(y, x, t1["branch"][0]))
    # The 45 leans back over the run: its plane holds y and -x.
    e2 = add("E2", "elbow", 2, elbow(2, 45, ELBOW_45[2]), place(y, minus(x), p4["out"][0]))
    out = e2["out"]
    p5 = add("P5", "pipe", 2, pipe(2, 100), place(out[1], z, out[0]))
    face3 = tuple(a + length2 * b for a, b in zip(p5["out"][0], out[1]))
    add("F3", "flange", 2, flange(2), place(out[1], z, face3))
    joints = [("W1", "F1/weld", "P1/in"), ("W2", "P1/out", "E1/in"), ("W3", "E1/out", "P2/in"),
              ("W4", "P2/out", "T1/in"), ("W5", "T1/out", "P3/in"), ("W6", "P3/out", "F2/weld"),
              ("W7", "T1/branch", "P4/in"), ("W8", "P4/out", "E2/in"), ("W9", "E2/out", "P5/in"),
              ("W10", "P5/out", "F3/weld")]
    scene = {"line": "10-3-SAMPLE-001", "spool": "SAMPLE-1", "revision": "0", "root_gap_m": 0.0,
             "joints": [{"weld": w, "a": a, "b": b, "type": "fab"} for w, a, b in joints],
             "datums": ["F1"]}
    return parts, scene


def main():
    out = sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent / "assets/sample/spool.glb"
    parts, scene = build()
    for part in parts:
        check(part)
    triangles = write_glb(out, parts, scene)
    print(f"{out}: {len(parts)} parts, {triangles} triangles")


if __name__ == "__main__":
    main()
