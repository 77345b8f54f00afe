"""three.js shows `.glb` in Chromium, drawn without a graphics card."""

import html
import json
import re
import shutil
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer

import numpy as np
import pytest

import pictures
import programs

THREE = programs.HERE / "three"
CHROMIUM = (
    "chromium", "--headless", "--no-sandbox", "--disable-gpu", "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--hide-scrollbars", "--window-size=840,560", "--virtual-time-budget=20000",
)  # fmt: skip


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@pytest.fixture(scope="module")
def page(named_rooms, tmp_path_factory):
    """Opens the page with the mesh in a browser that is new: what to do in, what it prints out."""
    folder = tmp_path_factory.mktemp("three")
    shutil.copy(named_rooms("rooms.glb", "--for", "paraview"), folder / "mesh.glb")
    shutil.copy(THREE / "index.html", folder)
    (folder / "three").symlink_to(THREE / "node_modules" / "three")
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}/index.html"

    def look(*wanted):
        profile = f"--user-data-dir={tmp_path_factory.mktemp('profile')}"
        return programs.execute(*CHROMIUM, profile, *wanted, address, folder=folder)

    yield look
    server.shutdown()


@pytest.fixture(scope="module")
def seen(page):
    """What three.js has loaded."""
    text = re.search(r'<pre id="seen">(.*?)</pre>', page("--dump-dom"), re.S)[1]
    seen = json.loads(html.unescape(text))
    assert "error" not in seen, seen
    return seen


def size(corners):
    """The length or the area."""
    sides = corners[:, 1:] - corners[:, :1]
    if corners.shape[1] == 2:
        return float(np.hypot(*sides[:, 0].T).sum())
    return float(np.abs(np.linalg.det(sides)).sum() / 2)


def test_three_js_sees_the_rooms(seen, hold):
    groups, points, triangles = [], [], 0
    for group in seen["groups"]:
        dim = group["dim"]
        places = np.array(group["places"])[:, :2] + seen["extras"]["origin"][:2]
        corners = places.reshape(-1, dim + 1, 2)
        groups.append((dim, group["tag"], group["name"], size(corners)))
        if dim == 2:
            triangles += len(corners)
            points.append(places)
    points = np.unique(np.concatenate(points).round(6), axis=0)
    version = seen["version"]
    hold("three.js", version, ".glb", "paraview", points, triangles, groups, digits=7)


def srgb(color):
    """The colour on the screen of one that is linear, as glTF's are."""
    color = np.array(color)
    light = np.where(color <= 0.0031308, 12.92 * color, 1.055 * color ** (1 / 2.4) - 0.055)
    return tuple(np.rint(255 * light).astype(int).tolist())


def test_the_picture_shows_every_group_in_its_colour(seen, page, tmp_path):
    page(f"--screenshot={tmp_path / 'rooms.png'}")
    colors = {(group["dim"], group["tag"]): srgb(group["color"]) for group in seen["groups"]}
    pictures.show_the_rooms(tmp_path / "rooms.png", colors, width=1)
