"""Measures a job: every method in turn, and that for each round; gives a record a method."""
import statistics

import cases
import child
import havs_runs
import vtk_runs
from setting import setting_of


def _side(method):
    return vtk_runs if method.startswith("vtk-") else havs_runs


def _with_medians(times):
    return {**times, "median_wall_ms": statistics.median(times["wall_ms"]),
            "median_cpu_ms": statistics.median(times["cpu_ms"])}


class Record:
    """What is gathered of one method over the rounds."""

    def __init__(self, job, method, setting):
        self.job, self.method, self.setting = job, method, setting
        self.firsts, self.still, self.turning = [], _none(), _none()
        self.last_first = self.last_frames = None

    def visit(self, frame_count):
        side = _side(self.method)
        done, self.last_first = side.first_picture(self.method, self.setting)
        self.firsts.append(done)
        self.last_frames = side.frames(self.method, self.setting, frame_count)
        for kept, new in ((self.still, self.last_frames["still"]), (self.turning, self.last_frames["turning"])):
            for key in ("wall_ms", "cpu_ms"):
                kept[key] += new[key]

    def _errors(self):
        """8 bits: what is delivered, of frames that have settled and of the first picture; floats: before rounding,
        where the method has them."""
        first, frames = self.last_first, self.last_frames
        errors = {"first_png": havs_runs.compare(first["png"], self.setting)}
        errors["png"] = havs_runs.compare(frames["png"], self.setting) if "png" in frames else errors["first_png"]
        floats = frames.get("floats")
        errors["floats"] = havs_runs.compare(floats, self.setting) if floats else None
        return errors

    def as_json(self):
        job, firsts = self.job, self.firsts
        first = {"wall_s": statistics.median(f.wall_s for f in firsts), "cpu_s": statistics.median(f.cpu_s for f in firsts),
                 "peak_bytes": max(f.peak_bytes for f in firsts)}
        for key in ("start_s", "stages_ms"):
            if key in self.last_first:
                first[key] = self.last_first[key]
        return {"mesh": job.mesh, "tetrahedra": cases.MESHES[job.mesh].tetrahedra, "case": job.case, "size": job.size,
                "threads": job.threads or len(child.all_cores()), "method": self.method,
                "drawn_by": self.last_first["drawn_by"], "first": first, "still": _with_medians(self.still),
                "turning": _with_medians(self.turning), "error": self._errors(),
                **({"still_stages_ms": s} if (s := self.last_frames["still"].get("stages_ms")) else {})}


def _none():
    return {"wall_ms": [], "cpu_ms": []}


def measure(job, frame_count):
    """The job's records, and a line for each method that was left out."""
    child.say(f"{job.mesh}, {cases.CASES[job.case].title}, {job.size}x{job.size}, "
              f"{job.threads or len(child.all_cores())} threads")
    setting = setting_of(job)
    records, skipped = [], []
    for method in job.methods:
        reason = _side(method).why_not(method, setting)
        if reason:
            skipped.append(f"{method} skipped: {reason}")
            child.say("  " + skipped[-1])
        else:
            records.append(Record(job, method, setting))
    for round_number in range(job.rounds):
        for record in records:
            child.say(f"  {record.method}" + (f" (round {round_number + 1})" if job.rounds > 1 else ""))
            record.visit(frame_count)
    return [record.as_json() for record in records], skipped
