"""VTK's side, with the same functions as havs_runs. One process a method, so that its peak memory is its own."""
import json
import sys
from pathlib import Path

import child

DRAW = Path(__file__).with_name("vtk_draw.py")
COUNT = Path(__file__).with_name("vtk_count.py")
display = None  # the name of the display, while the bench runs


def _environment(threads):
    environment = {"DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1"}
    if threads:
        environment["LP_NUM_THREADS"] = str(threads)  # what havs sets for llvmpipe
    return environment


def _run(method, setting, *options):
    command = [sys.executable, DRAW, "--mesh", setting.mesh, "--field", setting.field, "--tf", setting.transfer,
               "--camera", json.dumps(setting.camera), "--size", setting.size, "--method", method, *options]
    if setting.threads:
        command += ["--threads", setting.threads]
    done = child.run(command, setting.threads, _environment(setting.threads))
    return done, json.loads(done.output.splitlines()[-1])


def why_not(method, _setting):
    done = child.run([sys.executable, DRAW], environment=_environment(0), may_fail=True)
    return "" if done.status == 0 else "VTK's Python package does not start: " + done.error.strip().splitlines()[-1]


def start_seconds(setting):
    """What Python and its imports alone take; a part of every first picture by VTK."""
    return child.run([sys.executable, DRAW], setting.threads, _environment(setting.threads)).wall_s


def first_picture(method, setting):
    png = setting.folder / f"{method}-first.png"
    done, report = _run(method, setting, "--png", png)
    gl = report["opengl"]
    by = f"VTK {report['vtk']}, {gl['window']} on Xvfb, {gl['renderer']}, OpenGL {gl['version']}"
    return done, {"png": png, "start_s": start_seconds(setting), "drawn_by": by}


def frames(method, setting, count):
    png, floats = (setting.folder / f"{method}.{kind}" for kind in ("png", "pfm"))
    options = ["--frames", count, "--png", png]
    if method == "vtk-projected":  # the ray casters composite in float but keep 8 bits
        options += ["--pfm", floats]
    _, report = _run(method, setting, *options)
    return {**report, "png": png, "floats": floats if method == "vtk-projected" else None}


def shown(mesh, field, threshold):
    """Cells in all, and cells with a scalar above the threshold."""
    done = child.run([sys.executable, COUNT, mesh, field, threshold], environment=_environment(0))
    return json.loads(done.output.splitlines()[-1])
