"""FreeFEM reads Medit's format."""

import shutil

import programs


def test_freefem_sees_the_rooms_and_solves(named_rooms, hold, tmp_path):
    shutil.copy(named_rooms("rooms.mesh", "--for", "freefem"), tmp_path)
    programs.execute("FreeFem++", "-v", "0", "-nw", programs.HERE / "freefem.edp", folder=tmp_path)
    points, triangles, groups, error = programs.seen_lines((tmp_path / "seen.txt").read_text())
    version = programs.version("freefem++")
    hold("FreeFEM", version, ".mesh", "freefem", points, triangles, groups, error)
