"""A display for VTK: Debian's package has neither EGL nor OSMesa, so it draws through GLX. Xvfb, on a number that is
free, for as long as it is needed."""
import contextlib
import ctypes
import os
import select
import signal
import subprocess


def _end_with_parent():
    ctypes.CDLL(None).prctl(1, signal.SIGTERM)  # PR_SET_PDEATHSIG


@contextlib.contextmanager
def xvfb():
    """Gives the display's name, such as ":3"."""
    reading, writing = os.pipe()
    process = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "2560x2560x24", "-nolisten", "tcp", "-noreset"],
        pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=_end_with_parent)
    os.close(writing)
    try:
        ready, _, _ = select.select([reading], [], [], 30)
        number = os.read(reading, 16).decode().strip() if ready else ""
        if not number:
            raise RuntimeError("Xvfb gives no display; Debian: apt install xvfb")
        yield f":{number}"
    finally:
        os.close(reading)
        process.terminate()
        process.wait()
