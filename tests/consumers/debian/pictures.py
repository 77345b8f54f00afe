"""Pictures in which one unit is 350 pixels, 840 by 560 of them, and what their pixels tell."""

import numpy as np
from PIL import Image

import answers

SCALE, WIDTH, HEIGHT = 350, 840, 560
WHITE = (255, 255, 255)


def shares(file):
    """How many pixels have each colour."""
    image = Image.open(file).convert("RGB")
    assert image.size == (WIDTH, HEIGHT)
    colors, counts = np.unique(np.array(image).reshape(-1, 3), axis=0, return_counts=True)
    return {tuple(color): int(count) for color, count in zip(colors.tolist(), counts)}


def show_the_rooms(file, colors, width):
    """Asserts that regions fill their areas with their colours, that boundaries are lines of their
    colours of this width, and that all the rest is white. `colors`: by dimension and number."""
    found = shares(file)
    lengths = {tag: length * SCALE for tag, length in answers.LENGTHS.items()}
    lines = sum(lengths.values()) * width
    for tag, area in answers.AREAS.items():
        pixels = found.get(colors[2, tag], 0)
        assert area * SCALE**2 - lines < pixels < area * SCALE**2 + lines, (tag, pixels)
    for tag, length in lengths.items():
        pixels = found.get(colors[1, tag], 0)
        assert 0.6 * length * min(width, 1) < pixels < 1.5 * length * max(width, 1), (tag, pixels)
    free = WIDTH * HEIGHT - sum(answers.AREAS.values()) * SCALE**2
    assert free - lines < found[WHITE] < free + lines
    told = sum(found.get(color, 0) for color in {*colors.values(), WHITE})
    assert WIDTH * HEIGHT - told < 0.5 * lines, "colours that are no group's"
