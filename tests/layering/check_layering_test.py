#!/usr/bin/env python3
"""The layering check has to notice what it is there for: one planted offence a row."""
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import check_layering  # noqa: E402

ROWS = [  # file, its text, what must be said (None: nothing)
    ("vision/core/a.h", '#include <Eigen/Core>\n', None),
    ("vision/core/a.h", '#include "vision/scan/b.h"\n', "may not include"),
    ("vision/scan/a.cpp", '#include "vision/design/b.h"\n', "may not include"),
    ("vision/align/a.cpp", '#include <GLES3/gl3.h>\n', "belongs only in"),
    ("vision/scan/a.cpp", '#include <nanoflann.hpp>\n', "belongs only in"),
    ("render/a.cpp", '#include "vision/design/b.h"\n', "may not include"),
    ("render/a.cpp", '#include <imgui.h>\n', "belongs only in"),
    ("render/imgui_pass.cpp", '#include <imgui.h>\n', None),
    ("app/sensor/a.cpp", '#include <OpenNI.h>\n', "belongs only in"),
    ("app/sensor/openni_source.cpp", '#include <OpenNI.h>\n', None),
    ("vision/find/a.h", '#include "vision/design/b.h"\n', None),
    ("app/runner/a.cpp", '#include <sqlite3.h>\n', "belongs only in"),
    ("app/job/sqlite.cpp", '#include <sqlite3.h>\n', None),
    ("vision/measure/a.cpp", '#include "vision/guide/b.h"\n', "may not include"),
    ("app/ui/a.cpp", '#include <GLES3/gl3.h>\n', "belongs only in"),
    ("tools/a.cpp", '#include <GLFW/glfw3.h>\n', "belongs only in"),
    ("elsewhere/a.cpp", "\n", "lies in no folder"),
    ("vision/core/a.h", '#include "missing.h"\n', "not a path from the root"),
]


def main():
    failed = 0
    for name, text, expected in ROWS:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for target in ("vision/scan/b.h", "vision/design/b.h", "vision/guide/b.h"):
                (root / target).parent.mkdir(parents=True, exist_ok=True)
                (root / target).write_text("\n", encoding="utf-8")
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
            said = check_layering.check(root)
            good = not said if expected is None else any(expected in line for line in said)
            if not good:
                failed += 1
                print(f"{name} with {text!r}: expected {expected!r}, got {said}")
    print(f"{len(ROWS) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
