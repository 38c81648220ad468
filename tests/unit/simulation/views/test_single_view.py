# SPDX-License-Identifier: LGPL-2.1-or-later
"""The views against stored pictures, and what they must show: the moment, the tool to size, the limits, the colours."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_rgb
from matplotlib.image import imread
from PIL import Image

from CNCStepper.errors import JobError
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.removal.timeline import Timeline
from CNCStepper.simulation.stock import Cylinder, Stock
from CNCStepper.simulation.views import animation
from CNCStepper.simulation.views.animation import save_animation
from CNCStepper.simulation.views.isometric_view import surface
from CNCStepper.simulation.views.path_lines import Until, drawn_path
from CNCStepper.simulation.views.picture_style import COLOURS, GROUND
from CNCStepper.simulation.views.scene import Scene, scene_at
from CNCStepper.simulation.views.single_view import VIEWS, draw_view, save_view, view_figure
from CNCStepper.toolpath import ARC_CCW
from helpers.simulation.programs import FLAT, begun

STOCK = Stock((60, 50, 20))
CELL_MM = 0.25
BALL = Tool(number=1, shape="ball", diameter_mm=8)
SOME_VIEWS = [view if view == "isometric" else pytest.param(view, marks=pytest.mark.slow) for view in VIEWS]


def program(depth_mm: float = 6.0):
    """Return a slot, an arc, a ramp and a hole, with rapids between them."""
    made = begun().feed(-20, -15, 5).feed(-20, -15, -depth_mm).feed(8, -15, -depth_mm)
    made.arc(ARC_CCW, (8, 15, -depth_mm), (8, 0, -depth_mm)).feed(-10, 15, -1).rapid(-10, 15, 5).rapid(-15, 0, 5)
    return made.feed(-15, 0, -12).rapid(-15, 0, 5)


def scene_of(time_s: float | None = None, tool=FLAT, stock=STOCK, depth_mm: float = 6.0, machine=None) -> Scene:
    toolpath = program(depth_mm).toolpath()
    ends_s = np.cumsum(np.full(len(toolpath), 2.0))
    if time_s is None:
        return scene_at(toolpath, ends_s, height_map(toolpath, tool, stock, CELL_MM), tool, machine=machine)
    timeline = Timeline(toolpath, ends_s, tool, stock, CELL_MM)
    return scene_at(toolpath, ends_s, timeline.at(time_s), tool, timeline.moment(time_s), machine)


def drawn(tmp_path: Path, view: str, scene: Scene) -> np.ndarray:
    """Return the view as it is seen, uint8[rows, columns, 3]."""
    path = tmp_path / f"{view}.png"
    save_view(path, view, scene, "slot.nc", ["tool flat 6 mm"])
    return np.rint(imread(path)[..., :3] * 255).astype(np.uint8)


def pixels(picture: np.ndarray, name: str, near: int = 6) -> np.ndarray:
    """Return where a picture has the colour of that name, bool[rows, columns]; above the legend."""
    colour = np.rint(np.array(to_rgb(COLOURS[name])) * 255)
    found = (np.abs(picture.astype(int) - colour) <= near).all(axis=2)
    found[-70:] = False
    return found


def tinted(picture: np.ndarray, name: str) -> np.ndarray:
    """Return where a thin line of the colour of that name is blended with the ground, bool[rows, columns]."""
    ground, colour = (np.array(to_rgb(one)) * 255 for one in (GROUND, COLOURS[name]))
    share = (picture - ground) @ (colour - ground) / ((colour - ground) ** 2).sum()
    rest = np.abs(picture - ground - share[..., None] * (colour - ground)).max(axis=2)
    found = (share > 0.3) & (rest < 12)
    found[-70:] = False
    return found


@pytest.mark.slow
@pytest.mark.parametrize("view", SOME_VIEWS)
def test_views_are_as_stored(view: str, tmp_path: Path, stored_picture: Callable[[str, np.ndarray], None]) -> None:
    stored_picture(f"view-{view}", drawn(tmp_path, view, scene_of(11.3, BALL)))


@pytest.mark.slow
@pytest.mark.parametrize("view", SOME_VIEWS)
@pytest.mark.parametrize(
    "other",
    [{"time_s": 10.9}, pytest.param({"tool": BALL.model_copy(update={"diameter_mm": 7.0})}, marks=pytest.mark.slow)],
    ids=["earlier", "thinner"],
)
def test_the_comparison_fails_for_another_picture(
    view: str, other: dict, tmp_path: Path, differs: Callable[[str, np.ndarray], bool]
) -> None:
    assert differs(f"view-{view}", drawn(tmp_path, view, scene_of(**({"time_s": 11.3, "tool": BALL} | other))))


@pytest.mark.slow
def test_nothing_is_cut_off_and_the_same_scene_is_the_same_picture(tmp_path: Path) -> None:
    for view in VIEWS:
        one = drawn(tmp_path, view, scene_of())
        assert (np.concatenate([one[0], one[-1], one[:, 0], one[:, -1]]) == 255).all()
        assert (one == drawn(tmp_path, view, scene_of())).all()


@pytest.mark.slow
def test_the_tool_is_drawn_to_size(tmp_path: Path) -> None:
    """The outline of a tool of 8 mm is as long, beside the stock of 60 mm, as it is in truth."""
    for view, whole_mm, axis in (("xy", 60.0, 1), ("zy", 50.0, 1)):
        with_tool, without = scene_of(11.3, BALL), scene_of(11.3, BALL)
        object.__setattr__(without, "outlines", None)
        both = [drawn(tmp_path, view, scene)[:-70].astype(int) for scene in (with_tool, without)]
        changed = np.flatnonzero((np.abs(both[0] - both[1]).max(axis=2) > 30).any(axis=1 - axis))
        picture = both[1]
        stock = np.flatnonzero((np.abs(picture - (243, 234, 215)).max(axis=2) < 8).any(axis=1 - axis))
        if view == "zy":  # the stock's own edge lines, for its face is covered by its deepest cut
            stock = np.flatnonzero((np.abs(picture - (224, 207, 166)).max(axis=2) < 8).any(axis=1 - axis))
        scale = (stock[-1] - stock[0] + 1) / whole_mm
        assert (changed[-1] - changed[0] + 1) / scale == pytest.approx(8.0, abs=0.3)


@pytest.mark.slow
def test_rapids_feeds_arcs_and_plunges_have_their_colours(tmp_path: Path) -> None:
    for view in ("isometric", "xy", "zy"):
        picture = drawn(tmp_path, view, scene_of())
        for name in ("rapids", "feeds", "arcs", "plunges"):
            assert (pixels(picture, name, 40) | tinted(picture, name)).sum() > 5, (view, name)
    assert not tinted(drawn(tmp_path, "zy", scene_of(5.0)), "rapids").any()
    begins = drawn(tmp_path, "xy", scene_of(5.0))  # the first feeds alone
    assert not pixels(begins, "arcs").any() and not pixels(begins, "rapids").any()


@pytest.mark.slow
def test_limits_are_shown_where_the_work_zero_is_known(tmp_path: Path) -> None:
    machine = load_machine("table-a")
    for view in ("isometric", "xy", "zy"):
        assert pixels(drawn(tmp_path, view, scene_of(machine=machine)), "limits").sum() > 300
    assert not pixels(drawn(tmp_path, "xy", scene_of()), "limits").any()
    low, high = scene_of(machine=machine).limits_mm
    assert (high - low).tolist() == [axis.travel_max_mm - axis.travel_min_mm for axis in machine.axes]


@pytest.mark.slow
def test_a_cylinder_is_round_and_a_hole_is_seen_through(tmp_path: Path) -> None:
    block, round_ = (drawn(tmp_path, "depth", scene_of(stock=stock)) for stock in (STOCK, Cylinder((60, 60, 20))))
    assert (round_[200, 110:170] != block[200, 110:170]).any()
    for depth_mm, open_share in ((19.0, 0.0), (21.0, 0.16)):
        *_, colours = surface(scene_of(depth_mm=depth_mm).part, lambda z: np.ones((*z.shape, 4)), (1.0,) * 4)
        assert (colours[..., 3] == 0.0).mean() == pytest.approx(open_share, abs=0.02)


@pytest.mark.slow
def test_before_the_first_move_there_is_neither_path_nor_tool(tmp_path: Path) -> None:
    scene = scene_of(0.0)
    assert scene.tip_mm is None and not len(scene.path((0, 1)).points_mm)
    assert scene.part.removed_volume_mm3 == 0.0
    drawn(tmp_path, "isometric", scene)


def test_the_path_ends_where_the_tip_is() -> None:
    for time_s in (4.9, 7.0, 9.31, 11.5):
        scene = scene_of(time_s)
        points = scene.path((0, 1, 2)).points_mm
        assert np.linalg.norm(points - scene.tip_mm, axis=1).min() < 1e-9
    toolpath = program().toolpath()
    whole = Until(len(toolpath) - 1, 1.0, np.zeros(3))
    assert len(drawn_path(toolpath, (0, 1, 2), whole).points_mm) == len(drawn_path(toolpath, (0, 1, 2)).points_mm)


@pytest.mark.slow
def test_svg_is_the_same_bytes_each_time(tmp_path: Path) -> None:
    for name in ("a.svg", "b.svg"):
        save_view(tmp_path / name, "zy", scene_of(9.0), "p", [])
    text = (tmp_path / "a.svg").read_text("utf-8")
    assert text == (tmp_path / "b.svg").read_text("utf-8") and text.startswith("<?xml")


@pytest.mark.slow
@pytest.mark.parametrize("ending", [".gif", ".apng"])
def test_an_animation_shows_every_moment_to_one_scale(ending: str, tmp_path: Path) -> None:
    path = tmp_path / f"p{ending}"
    save_animation(path, "xy", ((scene_of(time_s), []) for time_s in (1.0, 6.0, 9.0)), "p")
    with Image.open(path) as movie:
        assert movie.n_frames == 3
        frames = []
        for number in range(3):
            movie.seek(number)
            frames.append(np.asarray(movie.convert("RGB")).astype(int))
    assert not (frames[0] == frames[1]).all() and not (frames[1] == frames[2]).all()
    assert (np.abs(frames[0][:90, :] - frames[2][:90, :]) < 10).all()


def test_without_an_encoder_there_is_a_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Missing:
        isAvailable = staticmethod(lambda: False)

    monkeypatch.setitem(animation.MOVIES, ".mp4", Missing)
    with pytest.raises(JobError, match=r"end it in \.gif"):
        save_animation(tmp_path / "p.mp4", "xy", iter([(scene_of(), [])]), "p")


@pytest.mark.slow
def test_seen_from_the_side_the_cutter_is_shown_whole(tmp_path: Path) -> None:
    """On its way out, 5 mm over the stock, it is as high in the picture as its three diameters."""
    for time_s in (None, 11.3):
        with_tool, without = scene_of(time_s, BALL), scene_of(time_s, BALL)
        object.__setattr__(without, "outlines", None)
        both = [drawn(tmp_path, "zy", scene)[:-70].astype(int) for scene in (with_tool, without)]
        assert scene_of(time_s, BALL).tallest_mm == 24.0
        rows = np.flatnonzero((np.abs(both[0] - both[1]).max(axis=2) > 30).any(axis=1))
        stock = np.flatnonzero((np.abs(both[1] - (224, 207, 166)).max(axis=2) < 8).any(axis=0))
        assert (rows[-1] - rows[0] + 1) / ((stock[-1] - stock[0] + 1) / 50.0) >= 24.0


def test_the_depth_map_names_the_limits_only_where_one_is_seen(tmp_path: Path) -> None:
    machine = load_machine("table-a")
    for zero_x_mm, seen in ((-200.0, False), (-29.0, True)):
        scene = scene_of(machine=machine)
        scene.limits_mm[:, 0] = (-400 - zero_x_mm, -zero_x_mm)
        figure = view_figure("depth", scene)
        draw_view(figure, "depth", scene, "p", [])
        texts = [text.get_text() for one in figure.legends for text in one.get_texts()]
        assert ("limits of travel" in texts) is seen
