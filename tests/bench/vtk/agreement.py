"""Whether both sides draw the same thing, before any time is taken: camera, opacity, orientation. Where they do not, the
bench ends."""
import array
import math

import child
import havs_runs
import pfm
import vtk_runs
from cases import TRANSFERS, Job
from setting import setting_of

SIZE = 256
# In levels of 255; a camera or an opacity that is off by a few percent gives tens. VTK's pictures are rounded to 8 bits
# (half a level), its opacities at the points as well. The ray casters' pictures are, besides, stretched by about half a
# pixel over their width (found by fitting them to the closed form), 3.3 levels where this cube's colours are steep.
MOST_LEVELS_P999 = {"vtk-projected": 2.0}
MOST_LEVELS_P999_CASTERS = 4.5
CLOSED_FORM_MAX = 2e-5  # float rounding over some 60 cells of a ray


class Disagreement(Exception):
    pass


def box_lengths(camera, size):
    """Length of each pixel's ray within the unit cube, the lowest row first."""
    eye, target, up = (camera[key] for key in ("eye", "target", "up"))
    unit = lambda v: [x / math.hypot(*v) for x in v]
    cross = lambda a, b: [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    forward = unit([t - e for t, e in zip(target, eye)])
    right = unit(cross(forward, up))
    above = cross(right, forward)
    tangent = math.tan(math.radians(camera["field_of_view"]) / 2)
    steps = [tangent * (2 * (i + 0.5) / size - 1) for i in range(size)]
    for v in steps:
        for u in steps:
            direction = unit([f + u * r + v * a for f, r, a in zip(forward, right, above)])
            near, far = -math.inf, math.inf
            for e, d in zip(eye, direction):
                a, b = sorted((-e / d, (1 - e) / d)) if d else (-math.inf, math.inf) if 0 < e < 1 else (1, 0)
                near, far = max(near, a), min(far, b)
            yield max(0.0, far - near)


def _write_closed_form(setting, path):
    transfer = TRANSFERS["white"]
    kappa = transfer.points[0][2] / transfer.unit_length
    rgb = array.array("f")
    for length in box_lengths(setting.camera, setting.size):
        rgb.extend([-math.expm1(-kappa * length)] * 3)
    pfm.write(path, setting.size, setting.size, rgb)


def _check(name, value, most, unit, failures):
    good = value <= most
    child.say(f"  {name}: {value:.3g} {unit}, at most {most:.3g}: {'agrees' if good else 'DOES NOT AGREE'}")
    if not good:
        failures.append(f"{name}: {value:.3g} {unit}, at most {most:.3g}")


def check(methods):
    """Draws a constant field (against its closed form) and a smooth one (against the reference) by every method."""
    failures, results = [], []
    for case in ("constant", "linear"):
        child.say(f"checking that the pictures agree: {case} field")
        setting = setting_of(Job("cube-50k", case, SIZE, 0))
        if case == "constant":
            closed = setting.folder / "closed-form.pfm"
            _write_closed_form(setting, closed)
            error = havs_runs.compare(closed, setting)
            _check("closed form against havs reference, maximum", error["max"], 1e-6, "", failures)
            setting.truth = closed
        for method in methods:
            side = vtk_runs if method.startswith("vtk-") else havs_runs
            if reason := side.why_not(method, setting):
                child.say(f"  {method} is left out: {reason}")
                continue
            if side is vtk_runs:
                error = havs_runs.compare(side.frames(method, setting, 1)["png"], setting)
                most = MOST_LEVELS_P999.get(method, MOST_LEVELS_P999_CASTERS)
                _check(f"{method}, 99.9%", 255 * error["p999"], most, "levels", failures)
            else:
                error = havs_runs.compare(side.frames(method, setting, 1)["floats"], setting)
                _check(f"{method}, 99.9%", error["p999"], CLOSED_FORM_MAX if case == "constant" else 1e-3, "", failures)
            results.append({"case": case, "method": method, "error": error})
    if failures:
        raise Disagreement("the pictures do not agree, so nothing is measured:\n  " + "\n  ".join(failures) +
                           f"\nLook at them in {setting.folder.parent}")
    return results
