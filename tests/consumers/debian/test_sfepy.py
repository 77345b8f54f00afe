"""SfePy reads Medit's format: triangles alone, its groups of points are the numbers of points."""

import programs

# Its package cannot be installed beside ParaView's; `tests/solvers` unpacks it here.
SFEPY = programs.HERE.parents[2] / "target" / "sfepy" / "usr" / "lib" / "python3" / "dist-packages"


def test_sfepy_sees_the_rooms_and_solves(named_rooms, hold, tmp_path):
    assert SFEPY.is_dir(), "python3-sfepy is missing: tests/solvers unpacks it"
    file = named_rooms("rooms.mesh", "--for", "sfepy")
    script = programs.HERE / "see_sfepy.py"
    seen = programs.seen_json("/usr/bin/python3", script, file, folder=tmp_path, PYTHONPATH=SFEPY)
    at_points = {int(tag): points for tag, points in seen["at_points"].items()}
    hold(
        "SfePy", seen["version"], ".mesh", "sfepy", seen["points"], seen["triangles"],
        seen["groups"], seen["error"], at_points=at_points,
    )  # fmt: skip
