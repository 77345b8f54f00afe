"""deal.II reads `.msh` 2.2 in a program that is compiled here."""

import programs


def test_dealii_sees_the_rooms_and_solves(named_rooms, hold, tmp_path):
    source = programs.HERE / "dealii"
    programs.execute("cmake", "-S", source, "-B", tmp_path, "-DCMAKE_BUILD_TYPE=Debug", folder=tmp_path)
    programs.execute("cmake", "--build", tmp_path, folder=tmp_path, timeout=900)
    file = named_rooms("rooms.msh", "--for", "dealii")
    text = programs.execute(tmp_path / "see_dealii", file, folder=tmp_path)
    version = programs.version("libdeal.ii-dev")
    hold("deal.II", version, ".msh 2.2", "dealii", *programs.seen_lines(text))
