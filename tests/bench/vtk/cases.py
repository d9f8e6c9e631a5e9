"""What is drawn: the meshes, the transfer functions, the cases that join them, and the jobs of a run."""
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Mesh:
    surface: str  # in meshes/
    switches: str  # TetGen's
    tetrahedra: int  # with Debian 12's TetGen; says which mesh is meant, nothing depends on it


MESHES = {
    "cube-50k": Mesh("cube.poly", "pqa3.8e-5", 53_535),
    "cube-200k": Mesh("cube.poly", "pqa9.6e-6", 204_890),
    "cube-1m": Mesh("cube.poly", "pqa1.9e-6", 1_009_689),
    "cube-3m": Mesh("cube.poly", "pqa6.35e-7", 2_989_679),
    "bracket-200k": Mesh("bracket.poly", "pqa5.5e-5", 216_898),  # not convex, three tunnels
}

# Fields at the points, all within 0 to 1.
FIELDS = {
    "smooth": "0.5+0.25*sin(7*x)*cos(5*y)+0.2*sin(6*z+3*x*y)",
    "fine": "0.5+0.25*sin(29*x)*cos(23*y)+0.2*sin(31*z+11*x*y)",
    "constant": "0.5",
    "linear": "(x+y+z)/3",
}


@dataclass(frozen=True)
class Transfer:
    """Control points of colour and opacity together: so VTK's ray integrators get the union of both functions' knots.
    (9.1 drops every opacity knot but the first where it has to join them itself.)"""
    unit_length: float  # extinction = opacity / unit_length, in mesh units, on both sides
    points: tuple  # of (scalar, (red, green, blue), opacity); opacities reach 1, as VTK may keep them in 8 bits


def _spikes(centers, width, colors):
    """Triangles of opacity on clear ground."""
    points = [(0.0, colors[0], 0.0)]
    for center, color in zip(centers, colors):
        points += [(center - width / 2, color, 0.0), (center, color, 1.0), (center + width / 2, color, 0.0)]
    return tuple(points + [(1.0, colors[-1], 0.0)])


_VIRIDIS = ((0.27, 0.0, 0.33), (0.23, 0.32, 0.55), (0.13, 0.57, 0.55), (0.36, 0.78, 0.39), (0.99, 0.91, 0.14))
_FIVE = ((0.37, 0.24, 0.6), (0.2, 0.53, 0.74), (0.4, 0.76, 0.65), (0.99, 0.78, 0.19), (0.9, 0.33, 0.05))

TRANSFERS = {
    "visible": Transfer(0.5, tuple(zip((0.0, 0.25, 0.5, 0.75, 1.0), _VIRIDIS, (0.15, 0.35, 0.2, 0.7, 1.0)))),
    "spikes": Transfer(0.004, _spikes((0.2, 0.35, 0.5, 0.65, 0.8), 0.01, _FIVE)),
    "tenth": Transfer(0.1, ((0.0, _VIRIDIS[0], 0.0), (0.75, _VIRIDIS[3], 0.0), (1.0, _VIRIDIS[4], 1.0))),
    "white": Transfer(1.0, ((0.0, (1.0, 1.0, 1.0), 1.0), (1.0, (1.0, 1.0, 1.0), 1.0))),
    "ramp": Transfer(0.5, ((0.0, (0.1, 0.2, 0.9), 0.1), (1.0, (0.9, 0.6, 0.1), 1.0))),
}


@dataclass(frozen=True)
class Case:
    field: str
    transfer: str
    title: str


CASES = {
    "visible": Case("smooth", "visible", "every cell visible"),
    "fine": Case("fine", "visible", "every cell visible, a field of higher frequency"),
    "spikes": Case("smooth", "spikes", "spikes of opacity narrower than a cell's range"),
    "tenth": Case("smooth", "tenth", "about a tenth of the cells shown"),
    "constant": Case("constant", "white", "constant field"),
    "linear": Case("linear", "ramp", "linear field and transfer function"),
}


@dataclass(frozen=True)
class Job:
    """One table's worth of measurements: everything the same but the method."""
    mesh: str
    case: str
    size: int
    threads: int  # 0: all
    methods: tuple = field(default=())
    rounds: int = 1


VTK = ("vtk-projected", "vtk-bunyk-partial", "vtk-bunyk-preintegration")
OURS = ("havs-osmesa", "havs-native")
LOOKUPS = tuple(f"havs-{device}-{lookup}" for device in ("osmesa", "native")
                for lookup in ("exact", "3d", "3d-normalised"))
ONE_BUNYK = ("vtk-projected", "vtk-bunyk-partial") + OURS
NO_BUNYK = ("vtk-projected",) + OURS
PROJECTED_AND_NATIVE = ("vtk-projected", "havs-native")


def quick_jobs():
    return [
        Job("cube-200k", "visible", 512, 0, VTK + OURS),
        Job("cube-200k", "tenth", 512, 0, NO_BUNYK),
        Job("cube-200k", "spikes", 512, 0, ("vtk-projected", "vtk-bunyk-partial") + LOOKUPS),
        Job("cube-1m", "visible", 1024, 0, ONE_BUNYK),
        Job("cube-1m", "tenth", 1024, 0, NO_BUNYK),
        Job("cube-1m", "visible", 1024, 1, PROJECTED_AND_NATIVE),
        Job("cube-200k", "visible", 1024, 0, PROJECTED_AND_NATIVE),
        Job("cube-3m", "visible", 1024, 0, PROJECTED_AND_NATIVE),
    ]


def full_jobs(cores):
    jobs = [Job(mesh, "visible", 1024, 0, VTK + OURS, 2) for mesh in ("cube-50k", "cube-200k", "cube-1m", "cube-3m")]
    jobs += [Job("cube-1m", "visible", size, 0, ONE_BUNYK) for size in (512, 2048)]
    jobs += [Job("cube-1m", "visible", 1024, threads, ONE_BUNYK) for threads in (1, 2) if threads < cores]
    jobs += [Job("cube-200k", "fine", 1024, 0, ONE_BUNYK), Job("bracket-200k", "visible", 1024, 0, ONE_BUNYK)]
    jobs += [Job("cube-200k", "spikes", 1024, 0, ("vtk-projected", "vtk-bunyk-partial") + LOOKUPS)]
    jobs += [Job(mesh, "tenth", 1024, 0, NO_BUNYK, 2) for mesh in ("cube-200k", "cube-1m")]
    return jobs
