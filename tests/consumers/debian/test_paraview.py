"""ParaView opens `.vtu`, with a picture."""

import json
import os
import subprocess

import pytest

import pictures
import programs

COLORS = {
    (2, 11): (255, 200, 100), (2, 12): (100, 200, 255), (1, 1): (0, 0, 0), (1, 2): (255, 0, 0),
    (1, 3): (0, 160, 0), (1, 7): (160, 0, 160), (1, 9): (0, 0, 255),
}  # fmt: skip


@pytest.fixture
def display(tmp_path):
    """A screen that nobody sees; its name."""
    reads, writes = os.pipe()
    screen = ["Xvfb", "-displayfd", str(writes), "-noreset", "-screen", "0", "1280x1024x24"]
    with open(tmp_path / "screen.log", "w") as log, open(reads) as number:
        server = subprocess.Popen(screen, pass_fds=[writes], stdout=log, stderr=log)
        os.close(writes)
        yield f":{number.readline().strip()}"
        server.terminate()
        server.wait()


def test_paraview_sees_the_rooms_and_shows_them(named_rooms, hold, display, tmp_path):
    file = named_rooms("rooms.vtu", "--for", "paraview")
    colors = json.dumps([(tag, color) for (_, tag), color in COLORS.items()])
    seen = programs.seen_json(
        "pvpython", "--force-offscreen-rendering", programs.HERE / "see_paraview.py",
        file, tmp_path / "rooms.png", colors, folder=tmp_path, DISPLAY=display,
    )  # fmt: skip
    version = programs.version("paraview")
    hold("ParaView", version, ".vtu", "paraview", seen["points"], seen["triangles"], seen["groups"])
    pictures.show_the_rooms(tmp_path / "rooms.png", COLORS, width=5)
