"""A display for VTK: Debian's package has neither EGL nor OSMesa, so it draws through GLX. Xvfb, on a number that is
free, for as long as it is needed."""
import contextlib
import os
import select
import subprocess

import child


@contextlib.contextmanager
def xvfb():
    """Gives the display's name, such as ":3"."""
    reading, writing = os.pipe()
    process = subprocess.Popen(
        ["Xvfb", "-displayfd", str(writing), "-screen", "0", "2560x2560x24", "-nolisten", "tcp", "-noreset"],
        pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=child.end_with_parent)
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
