"""Draws the same with VTK and with havs, in turn, and compares: times, memory, error. Started by ./bench."""
import argparse
import datetime
import itertools
import json
import os
import shlex
import sys

import agreement
import cases
import child
import display
import docs
import measure
import tables
import vtk_runs
from setting import ROOT, WORK, mesh_file

RESULT = WORK / "bench.json"


def arguments():
    parser = argparse.ArgumentParser(prog="./bench", description=__doc__)
    parser.add_argument("--full", action="store_true", help="all meshes, sizes and threads (about an hour or more)")
    parser.add_argument("--docs", action="store_true", help="no drawing: the last result's tables into docs/07-performance.md")
    parser.add_argument("--mesh", action="append", choices=list(cases.MESHES), help="instead of the selection; several")
    parser.add_argument("--case", action="append", choices=list(cases.CASES))
    parser.add_argument("--size", action="append", type=int, help="pixels along each side")
    parser.add_argument("--threads", action="append", type=int, help="0: all cores")
    parser.add_argument("--method", action="append",
                        help=f"{', '.join(tables.LABELS)}, havs-DEVICE or havs-DEVICE-LOOKUP; several")
    parser.add_argument("--frames", type=int, default=5, help="counted frames of each way and round (default 5)")
    parser.add_argument("--rounds", type=int, help="times that all methods take turns")
    parser.add_argument("--output", default=str(RESULT), help="the result as JSON (default build/bench/bench.json)")
    args = parser.parse_args()
    if args.frames < 1 or (args.rounds or 1) < 1 or any(t < 0 for t in args.threads or []):
        parser.error("frames, rounds and threads are counts")
    if any(not 16 <= size <= 2048 for size in args.size or []):
        parser.error("sizes are from 16 to 2048")
    known = lambda m: m in tables.LABELS or (m.startswith("havs-") and len(m) > 5)
    if bad := [m for m in args.method or [] if not known(m)]:
        parser.error(f"unknown method {bad[0]}")
    return args


def jobs_of(args):
    """The jobs, from the fixed lists or as a product of what was given."""
    chosen = [args.mesh, args.case, args.size, args.threads]
    if not any(chosen):
        jobs = cases.full_jobs(len(child.all_cores())) if args.full else cases.quick_jobs()
    else:
        product = itertools.product(args.mesh or ["cube-200k"], args.case or ["visible"], args.size or [512],
                                    args.threads or [0])
        jobs = [cases.Job(*parts, cases.VTK + cases.OURS) for parts in product]
    for job in jobs:
        yield cases.Job(job.mesh, job.case, job.size, job.threads, tuple(args.method or job.methods),
                        args.rounds or job.rounds)


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        return next((line.split(":", 1)[1].strip() for line in file if line.startswith("model name")), "unknown processor")


def machine():
    return {"processor": processor(), "cores": len(child.all_cores()), "load": os.getloadavg()[0],
            "date": datetime.date.today().isoformat()}


def share_shown(job):
    """The part of the cells that the transfer function of the case "tenth" shows."""
    clear_up_to = max(s for s, _, opacity in cases.TRANSFERS["tenth"].points if opacity == 0)
    count = vtk_runs.shown(mesh_file(job.mesh), cases.CASES[job.case].field, clear_up_to)
    return count["shown"] / count["cells"]


def run(args):
    jobs = list(jobs_of(args))
    result = {"command": shlex.join(["./bench", *sys.argv[1:]]), "machine": machine(), "frames": args.frames,
              "complete": False, "skipped": [], "agreement": [], "records": []}
    with display.xvfb() as name:
        vtk_runs.display = name
        result["agreement"] = agreement.check(list(dict.fromkeys(m for job in jobs for m in job.methods)))
        for job in jobs:
            records, skipped = measure.measure(job, args.frames)
            if job.case == "tenth":
                share = share_shown(job)
                records = [{**record, "shown": share} for record in records]
            result["records"] += records
            result["skipped"] += skipped
            result["complete"] = job is jobs[-1]
            with open(args.output, "w", encoding="utf-8") as file:  # after each job: a run that is stopped keeps what it has
                json.dump(result, file, indent=1)
    return result


def main():
    args = arguments()
    if args.docs:
        with open(args.output, encoding="utf-8") as file:
            docs.insert(json.load(file), ROOT / "docs/07-performance.md")
        return
    try:
        result = run(args)
    except (child.Failed, agreement.Disagreement) as error:
        raise SystemExit(f"bench: {error}") from None
    print(tables.report(result, tables.text_table, lambda title: title))
    print(f"The result: {args.output}\nThe pictures: {WORK / 'pictures'}")


if __name__ == "__main__":
    main()
