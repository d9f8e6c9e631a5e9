"""One process of VTK, for one method: a mesh to a PNG; with --frames also frames with the camera still and turning by
a degree. Prints JSON. Without --mesh it only starts, for what that alone costs."""
import argparse
import array
import json
import time

import pfm
import vtk_scene
from vtkmodules.vtkCommonCore import vtkVersion


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--mesh")
    parser.add_argument("--field")
    parser.add_argument("--tf")
    parser.add_argument("--camera", help="JSON, as havs reports it")
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--method", choices=list(vtk_scene.MAPPERS))
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--frames", type=int, default=0)
    parser.add_argument("--png")
    parser.add_argument("--pfm", help="projected tetrahedra before they are rounded to 8 bits")
    return parser.parse_args()


def timed(picture, frames, degrees):
    """One frame that is not counted, then `frames`, each turned by `degrees` from the one before."""
    times = {"wall_ms": [], "cpu_ms": []}
    picture.draw()
    for _ in range(frames):
        wall, cpu = time.perf_counter(), time.process_time()  # process_time: all threads
        if degrees:
            picture.turn(degrees)
        picture.draw()
        times["wall_ms"].append(1e3 * (time.perf_counter() - wall))
        times["cpu_ms"].append(1e3 * (time.process_time() - cpu))
    return times


def write_floats(picture, path):
    rgba = array.array("f")
    rgba.frombytes(picture.draw_floats(3))  # the first of VTK's pictures differs from those after it
    rgb = array.array("f", bytes(12 * picture.size * picture.size))
    for channel in range(3):
        rgb[channel::3] = rgba[channel::4]
    pfm.write(path, picture.size, picture.size, rgb)


def main():
    args = arguments()
    report = {"vtk": vtkVersion.GetVTKVersion()}
    if args.mesh:
        mesh = vtk_scene.read_mesh(args.mesh, args.field)
        camera = json.loads(args.camera)
        picture = vtk_scene.Picture(args.method, mesh, args.tf, camera, args.size, args.threads)
        if args.frames:
            report["still"] = timed(picture, args.frames, 0)
        else:
            picture.draw()
        if args.png:
            picture.write_png(args.png)
        report["opengl"] = picture.opengl()
        if args.frames:
            report["turning"] = timed(picture, args.frames, 1)
        if args.pfm:
            picture.set_camera(camera)
            write_floats(picture, args.pfm)
    print(json.dumps(report))


if __name__ == "__main__":
    main()
