"""What one job draws, as files: mesh, transfer function, camera, size, truth."""
import json
from dataclasses import dataclass, field
from pathlib import Path

import cases
import child
import transfer

ROOT = Path(__file__).resolve().parents[3]
BIN = ROOT / "build/release/bin"
WORK = ROOT / "build/bench"


def mesh_file(name):
    """The mesh, made where it is not there yet by this recipe."""
    mesh = cases.MESHES[name]
    folder = WORK / "meshes"
    file, recipe = folder / f"{name}.vtu", folder / f"{name}.txt"
    command = [BIN / "havs", "mesh", ROOT / "meshes" / mesh.surface, "--tetgen", mesh.switches, "-o", file, "--quiet"]
    for field_name, expression in cases.FIELDS.items():
        command += ["--scalar", f"{field_name}={expression}"]
    text = " ".join([mesh.surface, mesh.switches, json.dumps(cases.FIELDS)])
    if not file.exists() or not recipe.exists() or recipe.read_text() != text:
        child.say(f"making {name} ({mesh.tetrahedra:,} tetrahedra)")
        folder.mkdir(parents=True, exist_ok=True)
        child.run(command)
        recipe.write_text(text)
    return file


@dataclass
class Setting:
    mesh: Path
    field: str
    transfer: Path
    size: int
    threads: int
    folder: Path  # for pictures
    camera: dict = field(default_factory=dict)  # as havs reports it
    truth: Path = None
    mask: Path = None

    def havs_options(self):
        options = [self.mesh, "--field", self.field, "--tf", self.transfer, "--size", f"{self.size}x{self.size}",
                   "--background", "black"]
        if self.threads:
            options += ["--threads", self.threads]
        if self.camera:
            options += ["--camera", json.dumps(self.camera)]
        return options


def setting_of(job):
    case = cases.CASES[job.case]
    folder = WORK / "pictures" / f"{job.mesh}-{job.case}-{job.size}"
    folder.mkdir(parents=True, exist_ok=True)
    file = transfer.write(WORK / "transfer" / f"{case.transfer}.json", case.transfer, cases.TRANSFERS[case.transfer])
    setting = Setting(mesh_file(job.mesh), case.field, file, job.size, job.threads, folder)
    setting.truth, setting.mask = folder / "reference.pfm", folder / "edges.png"
    # With all cores whatever the job measures: the truth does not depend on them. Its report has the camera in full.
    options = Setting(setting.mesh, setting.field, file, job.size, 0, folder).havs_options()
    done = child.run([BIN / "havs", "reference", *options, "-o", setting.truth, "-o", setting.truth.with_suffix(".png"),
                      "--edge-mask", setting.mask, "--json", "--quiet"])
    setting.camera = json.loads(done.output)["settings"]["camera"]
    return setting
