"""The records as tables: text for the terminal, markdown for the docs; and how each method grows."""
import itertools
import math

import cases

LABELS = {
    "vtk-projected": "VTK projected tetrahedra",
    "vtk-bunyk-partial": "VTK Bunyk, partial pre-integration",
    "vtk-bunyk-preintegration": "VTK Bunyk, pre-integration",
    "vtk-bunyk-linear": "VTK Bunyk, linear",
    "vtk-zsweep": "VTK ZSweep",
}
COLUMNS = ("", "first picture s", "its CPU s", "memory MB", "frame ms", "its CPU ms", "turning ms", "its CPU ms",
           "levels: 99.9%", "max", "floats: rmse", "99.9%", "max")


def label(method):
    if method in LABELS:
        return LABELS[method]
    _, device, *lookup = method.split("-", 2)
    return f"havs {device}" + (f", {lookup[0]}" if lookup else "")


def _key(record):
    return record["mesh"], record["case"], record["size"], record["threads"]


def jobs_of(records):
    """Records that differ in the method only, in the order in which they were measured."""
    groups = {}
    for record in records:
        groups.setdefault(_key(record), []).append(record)
    return list(groups.values())


def title(group):
    r = group[0]
    shown = f" ({r['shown']:.1%} of the cells)" if "shown" in r else ""
    return (f"{cases.CASES[r['case']].title}{shown}: {r['mesh']}, {r['tetrahedra']:,} tetrahedra, "
            f"{r['size']} x {r['size']}, {r['threads']} thread{'s' if r['threads'] != 1 else ''}")


def _levels(error):
    return [f"{255 * error['p999']:.1f}", f"{255 * error['max']:.1f}"]


def _floats(error):
    return [f"{error[name]:.1e}" for name in ("rmse", "p999", "max")] if error else ["8 bits only", "", ""]


def row(record):
    first, still, turning, error = (record[name] for name in ("first", "still", "turning", "error"))
    return [label(record["method"]), f"{first['wall_s']:.2f}", f"{first['cpu_s']:.2f}",
            f"{first['peak_bytes'] / 1e6:.0f}", f"{still['median_wall_ms']:.0f}", f"{still['median_cpu_ms']:.0f}",
            f"{turning['median_wall_ms']:.0f}", f"{turning['median_cpu_ms']:.0f}", *_levels(error["png"]),
            *_floats(error["floats"])]


def text_table(header, rows):
    widths = [max(len(r[i]) for r in [header, *rows]) for i in range(len(header))]
    line = lambda r: "  ".join(c.ljust(w) if i == 0 else c.rjust(w) for i, (c, w) in enumerate(zip(r, widths))).rstrip()
    return "\n".join(line(r) for r in [header, *rows])


def markdown_table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(r) + " |" for r in rows])


def _to_compare(ours, other):
    """Ours against each of VTK's, and native against OpenGL with the same lookup."""
    mine, theirs = ours["method"].split("-", 2), other["method"].split("-", 2)
    if mine[0] != "havs":
        return False
    return theirs[0] == "vtk" or (mine[1] == "native" and theirs[1] == "osmesa" and mine[2:] == theirs[2:])


def ratios(group):
    """How many times less ours takes than each other method, within one job."""
    found = []
    for ours, other in itertools.product(group, group):
        if not _to_compare(ours, other):
            continue
        over = lambda part, key: f"{other[part][key] / ours[part][key]:.1f}"
        found.append([label(ours["method"]), label(other["method"]), over("still", "median_wall_ms"),
                      over("turning", "median_wall_ms"), over("turning", "median_cpu_ms"), over("first", "wall_s"),
                      over("first", "cpu_s"), _error_ratio(ours, other)])
    return found


RATIO_COLUMNS = ("times less for", "than for", "frame", "turning", "turning, CPU", "first picture",
                 "first picture, CPU", "error (rmse)")


def _error_ratio(ours, other):
    """Before rounding where the other has that, else as its PNG."""
    theirs = other["error"]["floats"] or other["error"]["png"]
    ratio = theirs["rmse"] / ours["error"]["floats"]["rmse"]
    return f"{ratio:.0f}" + ("" if other["error"]["floats"] else " (its PNG)")


def _slopes(records, quantity, amount):
    """Cost of the greatest over that of the smallest, and the power of `amount` that it grows with."""
    ordered = sorted(records, key=lambda r: r[quantity])
    low, high = ordered[0], ordered[-1]
    cells = [label(low["method"])]
    span = amount(high) / amount(low)
    for part, key in (("turning", "median_wall_ms"), ("turning", "median_cpu_ms"), ("first", "wall_s")):
        ratio = high[part][key] / low[part][key]
        cells.append(f"{ratio:.2f} ({math.log(ratio) / math.log(span):+.2f})")
    cells.append(f"{high['first']['peak_bytes'] / low['first']['peak_bytes']:.2f}")
    return cells


GROWTH = (("tetrahedra", lambda r: r["tetrahedra"], ("case", "size", "threads")),
          ("size", lambda r: r["size"] ** 2, ("mesh", "case", "threads")),
          ("threads", lambda r: r["threads"], ("mesh", "case", "size")))
GROWTH_COLUMNS = ("", "frame", "frame, CPU", "first picture", "memory")


def growth(records):
    """A table a quantity: records that differ in it alone. Only the cube's meshes and the main case are compared."""
    records = [r for r in records if r["mesh"].startswith("cube") and r["case"] == "visible"]
    for quantity, amount, same in GROWTH:
        groups = {}
        for r in records:
            groups.setdefault((*(r[name] for name in same), r["method"]), []).append(r)
        rows = {}
        for key, group in groups.items():
            values = sorted({r[quantity] for r in group})
            if len(values) > 1:
                rows.setdefault((key[:-1], tuple(values)), []).append(_slopes(group, quantity, amount))
        for (fixed, values), cells in rows.items():
            what = {"size": "pixels along a side", "threads": "threads", "tetrahedra": "tetrahedra"}[quantity]
            held = ", ".join(f"{name} {value}" for name, value in zip(same, fixed) if name != "case")
            yield f"From {values[0]:,} to {values[-1]:,} {what} ({held}): the factor, and the power that it stands for", cells


def tenth(records):
    """What clear cells save: the main case's frame over the same with a tenth of the cells shown."""
    rows = []
    for shown in (r for r in records if r["case"] == "tenth"):
        for full in records:
            if full["case"] == "visible" and all(full[k] == shown[k] for k in ("mesh", "size", "threads", "method")):
                over = lambda part, key: f"{full[part][key] / shown[part][key]:.1f}"
                rows.append([label(shown["method"]), shown["mesh"], over("still", "median_wall_ms"),
                             over("turning", "median_wall_ms"), over("turning", "median_cpu_ms"),
                             over("first", "wall_s")])
    return rows


TENTH_COLUMNS = ("", "mesh", "frame", "turning", "turning, CPU", "first picture")


def report(result, table, heading):
    """The whole result, by `table` (text_table or markdown_table) and `heading` (of a string)."""
    records, parts = result["records"], []
    for group in jobs_of(records):
        parts += [heading(title(group)), table(COLUMNS, [row(r) for r in group])]
        if compared := ratios(group):
            parts.append(table(RATIO_COLUMNS, compared))
    for name, rows in growth(records):
        parts += [heading(name), table(GROWTH_COLUMNS, rows)]
    if rows := tenth(records):
        parts += [heading("How many times less a picture costs that shows a tenth of the cells"),
                  table(TENTH_COLUMNS, rows)]
    notes = sorted(set(result["skipped"])) + [f"{method}: {by}" for method, by in drawn_by(records).items()]
    return "\n\n".join(parts + ["\n".join(f"- {note}" for note in notes)]) + "\n"


def drawn_by(records):
    return {label(r["method"]): r["drawn_by"] for r in records}
