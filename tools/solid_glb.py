"""Closed solids as a GLB with semantics: what make_sample_spool.py builds, checked and written."""
import json
import struct
import sys
from pathlib import Path


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def weld_key(p):
    """Corners nearer than half a micrometre are one; the offset keeps round sizes off the rounding edge."""
    return tuple(round(c + 0.000317, 3) for c in p)


def check(part):
    """Every edge of a closed solid belongs to two triangles that run along it in opposite directions."""
    edges, volume = {}, 0.0
    key = weld_key
    for a, b, c in part["mesh"].triangles:
        for p, q in ((a, b), (b, c), (c, a)):
            edges[(key(p), key(q))] = edges.get((key(p), key(q)), 0) + 1
        volume += sum(u * v for u, v in zip(a, cross(b, c))) / 6
    loose = [e for e, n in edges.items() if n != 1 or (e[1], e[0]) not in edges]
    if loose or volume <= 0:
        sys.exit(f"{part['name']}: {len(loose)} loose edges, volume {volume:.0f} mm3: not a closed solid")


def write_glb(path, parts, scene):
    binary, views, accessors, meshes, nodes = bytearray(), [], [], [], []

    def view(data, target):
        views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data), "target": target})
        binary.extend(data)
        binary.extend(b"\0" * (-len(binary) % 4))
        return len(views) - 1

    for part in parts:
        corners, order, indices = {}, [], []
        for triangle in part["mesh"].triangles:
            ids = []
            for p in triangle:
                key = weld_key(p)
                if key not in corners:
                    corners[key] = len(order)
                    order.append(tuple(c / 1000 for c in p))
                ids.append(corners[key])
            if len(set(ids)) == 3:
                indices += ids
        positions = b"".join(struct.pack("<3f", *p) for p in order)
        low = [min(p[i] for p in order) for i in range(3)]
        high = [max(p[i] for p in order) for i in range(3)]
        accessors.append({"bufferView": view(positions, 34962), "componentType": 5126, "count": len(order),
                          "type": "VEC3", "min": low, "max": high})
        accessors.append({"bufferView": view(struct.pack(f"<{len(indices)}H", *indices), 34963),
                          "componentType": 5123, "count": len(indices), "type": "SCALAR"})
        meshes.append({"name": part["name"], "primitives": [
            {"attributes": {"POSITION": len(accessors) - 2}, "indices": len(accessors) - 1, "mode": 4}]})
        m = part["pose"]
        columns = [m[i][j] for j in range(3) for i in range(4)] + [m[i][3] / 1000 for i in range(3)] + [1]
        nodes.append({"name": part["name"], "mesh": len(meshes) - 1, "matrix": columns,
                      "extras": {"spoolsight": part["extras"]}})
    gltf = {"asset": {"version": "2.0", "generator": "SpoolSight tools/make_sample_spool.py"},
            "scene": 0, "scenes": [{"nodes": list(range(len(nodes))), "extras": {"spoolsight": scene}}],
            "nodes": nodes, "meshes": meshes, "accessors": accessors, "bufferViews": views,
            "buffers": [{"byteLength": len(binary)}]}
    text = json.dumps(gltf, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    total = 12 + 8 + len(text) + 8 + len(binary)
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_bytes(struct.pack("<4sII", b"glTF", 2, total) +
                           struct.pack("<I4s", len(text), b"JSON") + text +
                           struct.pack("<I4s", len(binary), b"BIN\0") + bytes(binary))
    return sum(len(p["mesh"].triangles) for p in parts)
