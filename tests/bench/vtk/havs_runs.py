"""Our side: a method is havs-DEVICE or havs-DEVICE-LOOKUP; without a lookup it is havs's default."""
import json
from dataclasses import replace

import child
from setting import BIN


def options_of(method):
    _, device, *lookup = method.split("-", 2)
    return ["--device", device] + (["--lookup", lookup[0]] if lookup else [])


def why_not(method, setting):
    """Why this build does not draw by the method; empty where it does."""
    small = replace(setting, size=16)
    done = child.run([BIN / "havs", "render", *small.havs_options(), *options_of(method), "--quiet"], may_fail=True)
    return "" if done.status == 0 else (done.error.strip().splitlines() or ["it ended silently"])[-1]


def first_picture(method, setting):
    """The whole process, from the file to a PNG."""
    png = setting.folder / f"{method}-first.png"
    done = child.run([BIN / "havs", "render", *setting.havs_options(), *options_of(method), "-o", png, "--json",
                      "--quiet"], setting.threads)
    report = json.loads(done.output)
    return done, {"png": png, "stages_ms": report["stages_ms"], "drawn_by": drawn_by(report)}


def drawn_by(report):
    settings = report["settings"]
    return f"{report['device']['renderer']}; lookup {settings['lookup']}, {settings['sort']}, k {settings['k']}"


def frames(method, setting, count):
    floats = setting.folder / f"{method}.pfm"
    done = child.run([BIN / "bench_turn", *setting.havs_options(), *options_of(method), "--frames", count, "-o", floats],
                     setting.threads)
    return {**json.loads(done.output), "floats": floats}


def compare(picture, setting):
    """Error against the truth, pixels on the boundary's edges left out; with them under with_masked_pixels."""
    done = child.run([BIN / "havs", "compare", picture, setting.truth, "--mask", setting.mask, "--json"])
    report = json.loads(done.output)
    measures = ("rmse", "p999", "max")
    error = {name: report[name] for name in measures}
    error["with_masked_pixels"] = {name: report["with_masked_pixels"][name] for name in measures}
    return error
