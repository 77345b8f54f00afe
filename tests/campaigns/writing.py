"""How fast meshio and Gmsh write the mesh that `writing --keep` leaves (meshio writes no mesh with
lines and triangles as .msh 4.1 unless it came from such a file):

    cargo run --release -p meshwright-campaigns --bin writing -- --keep
    python tests/campaigns/writing.py /dev/shm
"""

import sys
import time
from pathlib import Path

import gmsh
import meshio


def timed(name, file, write):
    """Writes a file and prints how long it had a processor for that."""
    start = time.process_time()
    write(str(file))
    seconds = time.process_time() - start
    size = file.stat().st_size / 1e6
    file.unlink()
    print(f"{name:<24}{size:>9.0f}{seconds:>9.2f}{size / seconds:>9.0f}", flush=True)


def main(folder):
    mesh = meshio.read(folder / "writing.vtu")
    print(f"{'':<24}{'MB':>9}{'s':>9}{'MB/s':>9}")
    for name, end, options in (
        ("meshio .vtu binary", "vtu", {"compression": None}),
        ("meshio .vtu zlib", "vtu", {"compression": "zlib"}),
        ("meshio .msh 2.2 text", "msh", {"file_format": "gmsh22", "binary": False}),
        ("meshio .msh 2.2 binary", "msh", {"file_format": "gmsh22", "binary": True}),
    ):
        timed(name, folder / f"peer.{end}", lambda file: meshio.write(file, mesh, **options))
    source = folder / "peer.msh"
    meshio.write(source, mesh, file_format="gmsh22", binary=True)
    gmsh.initialize(["gmsh", "-v", "1"])
    gmsh.open(str(source))
    source.unlink()
    for version in ("2.2", "4.1"):
        for binary in (0, 1):
            gmsh.option.setNumber("Mesh.MshFileVersion", float(version))
            gmsh.option.setNumber("Mesh.Binary", binary)
            kind = ("text", "binary")[binary]
            timed(f"Gmsh .msh {version} {kind}", folder / "peer.msh", gmsh.write)
    gmsh.finalize()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
