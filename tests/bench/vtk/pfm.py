"""Portable float maps: three floats a pixel, the lowest row first."""
import array
import sys


def write(path, width, height, rgb):
    """`rgb`: array('f'), the lowest row first."""
    order = "-1.0" if sys.byteorder == "little" else "1.0"
    with open(path, "wb") as out:
        out.write(f"PF\n{width} {height}\n{order}\n".encode())
        rgb.tofile(out)


def read(path):
    """(width, height, array('f')), the lowest row first."""
    with open(path, "rb") as file:
        kind, size, order = (file.readline().split() for _ in range(3))
        if kind != [b"PF"]:
            raise ValueError(f"{path}: no PFM of three channels")
        width, height = map(int, size)
        values = array.array("f")
        values.fromfile(file, 3 * width * height)
    if (float(order[0]) < 0) != (sys.byteorder == "little"):
        values.byteswap()
    return width, height, values
