#!/usr/bin/env python3
"""Checks who includes whom (ARCHITECTURE: includes only point up the list) and which library stays in which file.

Prints one line an offence; exit 1 if there is any. Run: tools/check_layering.py [ROOT]
"""
import re
import sys
from pathlib import Path

# Folders in the order of the data flow: a file may include its own folder and those listed for it.
CORE = ["vision/core"]
VISION = ["vision/core", "vision/piping", "vision/scan", "vision/design", "vision/fit", "vision/align", "vision/find",
          "vision/inspect", "vision/measure"]
GUIDE = ["vision/guide"]    # beside the main path: it knows designs, not scans
MAY_INCLUDE = {
    "vision/core": CORE,
    "vision/piping": VISION[:2],
    "vision/scan": CORE + ["vision/scan"],
    "vision/design": VISION[:4],
    "vision/fit": VISION[:5],
    "vision/align": VISION[:6],
    "vision/find": VISION[:7],
    "vision/inspect": VISION[:8],
    "vision/measure": VISION,
    "vision/guide": VISION[:4] + GUIDE,
    "vision": VISION + ["vision"],
    "vision/live": VISION + ["vision", "vision/live"],
    "render": CORE + ["render"],
    "app/common": VISION + ["vision", "app/common"],
    "app/sensor": VISION + ["vision", "app/common", "app/sensor"],
    "app/job": VISION + GUIDE + ["vision", "app/common", "app/job"],
    "app/evidence": VISION + GUIDE + ["vision", "render", "app/common", "app/sensor", "app/job", "app/evidence"],
    "app/isometric": VISION + GUIDE + ["vision", "render", "app/common", "app/job", "app/isometric"],
    "app/ncr": VISION + GUIDE + ["vision", "render", "app/common", "app/job", "app/evidence", "app/isometric", "app/ncr"],
    "tools": VISION + GUIDE + ["vision", "vision/live", "render", "app/common", "app/sensor", "app/job", "app/evidence",
              "app/isometric", "app/ncr", "tools"],
    "app": None,    # joins everything
    "tests": None,
}
# Third-party headers, and the only places they may appear in. A folder means everything below it.
ONLY_IN = {
    r"GLES\d?/|EGL/": ["render", "app/window.cpp", "app/window.h", "tests/render", "tests/app"],
    r"GLFW/": ["app/window.cpp", "app/window.h"],
    r"imgui": ["render/imgui_pass", "app", "tests/app", "tests/render"],
    r"OpenNI\.h|openni2/|PS1080\.h|Driver/Oni": ["app/sensor", "tools/simulator", "tests/app/sensor"],
    r"nanoflann": ["vision/scan/point_index.cpp"],
    r"embree3/": ["vision/design", "tools/simulator"],
    r"assimp/": ["vision/design"],
    r"tiny_gltf": ["vision/design", "tests/vision/design"],
    r"oneapi/tbb|tbb/": ["vision/core/parallel.cpp"],
    r"sodium": ["vision/core/file_digest.cpp", "app/evidence/signing.cpp"],
    r"sqlite3": ["app/job/sqlite.cpp", "tests/app/job"],
    r"spdlog|fmt/": ["app", "tools"],
    r"nlohmann/": ["app", "tools", "tests", "render"],
    r"cairo|pango/": ["app/isometric/page_canvas.cpp"],
    r"zip\.h": ["app/ncr/zip_bytes.cpp", "tests/app/ncr"],
    r"X11/": ["app"],
    r"png\.h": ["render", "app/sensor", "tests"],
    r"open3d/": ["tools/compare/open3d_cloud.h", "tools/compare/open3d_icp.cpp",
                 "tools/compare/open3d_find.cpp", "tools/compare/open3d_track.cpp"],
    r"pcl/": ["tools/compare/pcl_cloud.h", "tools/compare/pcl_icp.cpp", "tools/compare/pcl_find.cpp"],
}
# Within a folder that may use a library, these files alone include its headers.
ONE_FILE = {r"imgui": ("render", "render/imgui_pass"), r"OpenNI\.h": ("app/sensor", "app/sensor/openni")}
NEVER_IN = {"app/ui": r"GLES\d?/|EGL/|GLFW/|OpenNI", "app/sensor": r"imgui|GLES|GLFW", "tools": r"imgui|GLFW"}


def folder_of(path):
    """The longest known folder that holds a path."""
    for folder in sorted(MAY_INCLUDE, key=len, reverse=True):
        if path.startswith(folder + "/"):
            return folder
    return None


def check(root):
    offences = []
    for path in sorted(root.rglob("*")):
        name = path.relative_to(root).as_posix()
        if path.suffix not in (".h", ".cpp") or name.startswith(("build", "out", ".")):
            continue
        folder = folder_of(name)
        if folder is None:
            offences.append(f"{name}: lies in no folder of the layout")
            continue
        allowed = MAY_INCLUDE[folder]
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = re.match(r'\s*#\s*include\s*([<"])([^>"]+)[>"]', line)
            if not match:
                continue
            kind, target = match.groups()
            where = f"{name}:{number}"
            if kind == '"':
                to = folder_of(target)
                if not (root / target).exists():
                    offences.append(f"{where}: {target} is not a path from the root")
                elif allowed is not None and to not in allowed:
                    offences.append(f"{where}: {folder} may not include {target}")
                continue
            for pattern, places in ONLY_IN.items():
                if re.match(pattern, target) and not any(
                        name.startswith(p if "." in p or p.endswith("pass") else p + "/") for p in places):
                    offences.append(f"{where}: <{target}> belongs only in {', '.join(places)}")
            for pattern, (inside, only) in ONE_FILE.items():
                if re.match(pattern, target) and name.startswith(inside + "/") and not name.startswith(only):
                    offences.append(f"{where}: <{target}> belongs only in {only}*")
            if folder in NEVER_IN and re.match(NEVER_IN[folder], target):
                offences.append(f"{where}: {folder} never includes <{target}>")
    return offences


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent).resolve()
    offences = check(root)
    print("\n".join(offences) if offences else "layering holds")
    return 1 if offences else 0


if __name__ == "__main__":
    sys.exit(main())
