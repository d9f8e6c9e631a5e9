"""One process run to its end: wall and processor seconds, peak memory."""
import ctypes
import os
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass


@dataclass
class Finished:
    status: int
    output: str
    error: str
    wall_s: float
    cpu_s: float  # user and system, of it and of the children it waited for
    peak_bytes: int  # the largest resident size of any one of these processes


class Failed(Exception):
    pass


def end_with_parent():
    """For a child, before it becomes its program: a bench that is killed leaves nothing running."""
    ctypes.CDLL(None).prctl(1, signal.SIGTERM)  # PR_SET_PDEATHSIG


def all_cores():
    return sorted(os.sched_getaffinity(0))


def run(command, threads=0, environment=None, may_fail=False):
    """Runs `command` on the first `threads` cores (0: all). Throws Failed, with what it printed, unless it ends well."""
    cores = all_cores()[:threads or None]

    def prepare():
        end_with_parent()
        os.sched_setaffinity(0, cores)

    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        start = time.monotonic()
        process = subprocess.Popen([str(part) for part in command], stdout=out, stderr=err, stdin=subprocess.DEVNULL,
                                   env={**os.environ, **(environment or {})},
                                   preexec_fn=prepare)
        _, state, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(state)
        texts = []
        for stream in (out, err):
            stream.seek(0)
            texts.append(stream.read().decode(errors="replace"))
    done = Finished(process.returncode, texts[0], texts[1], wall, usage.ru_utime + usage.ru_stime,
                    usage.ru_maxrss * 1024)
    if done.status != 0 and not may_fail:
        raise Failed(f"{' '.join(map(str, command))}\nended with status {done.status}\n{done.error[-2000:]}")
    return done


def say(text):
    print(text, file=sys.stderr, flush=True)
