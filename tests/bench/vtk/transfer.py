"""A transfer function as havs reads it; VTK's are made from the same file (vtk_scene.py)."""
import json


def write(path, name, transfer):
    points = [{"scalar": s, "color": list(color), "opacity": opacity} for s, color, opacity in transfer.points]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps({"version": 1, "name": name, "opacity": "extinction", "unit_length": transfer.unit_length,
                                "domain": [0, 1], "scale": "data", "points": points}, indent=1))
    return path
