# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random programs as text, the shapes that they are to cut, and one fault planted into a copy at a known line.

A stock of four fields, a block, a cylinder or a block with a valley; in each field a pocket, a round pocket or a
slot, cut by a mill that goes straight down, by one with a core that goes down on a helix or a ramp, or by that one in
a hole drilled before. Between them rapids go round the stock's rim, through its valley and to the ends of the travel
under another work offset, and G92 moves the zero.
"""

from __future__ import annotations

import copy
import math
import random
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
import shapely
from shapely import affinity

from CNCStepper.cycles.cycle import Removal
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.stock import Cylinder, HeightField, Stock
from CNCStepper.state import WORK_SYSTEMS, Start

MACHINE = load_machine("table-a")
VALLEY_MM = (6.0, 8.0, 12.0)  # half its width at its floor and at its top, and its depth; it runs along Y
_ACROSS = np.interp(np.abs(np.linspace(-50, 50, 101)), VALLEY_MM[:2], [20 - VALLEY_MM[2], 20])
STOCKS = [
    Stock((100, 80, 20)),
    Cylinder((120, 120, 20)),
    HeightField((100, 80, 20), heights_mm=np.tile(_ACROSS, (3, 1))),
]
IN_VALLEY = 9  # the side of a rapid that goes there
FIELDS = [(-25, -20), (25, -20), (-25, 20), (25, 20)]
MM_AN_INCH = 25.4
SAFE_MM, NEAR_MM = 10.0, 1.0  # heights of rapids, and from which the tool feeds
GOUGE_MM, CORNER_MM, BEYOND_MM = 0.02, 1.0, 0.01  # the sizes of the faults
RUB_MM = 0.02
SOLID, DRILL, CORED, WRONG = 1, 2, 3, 4  # tool numbers

Point = tuple[float, float]


@dataclass(eq=False)
class Block:
    """A line of the program: words in stock coordinates, or text; what it is part of and which role it has there."""

    code: str
    words: dict[str, float] = field(default_factory=dict)
    shift_mm: Point = (0.0, 0.0)  # the program's coordinates minus those of the stock
    section: int = 0
    feature: int = -1
    level: int = -1
    role: str = ""
    side: int = -1


@dataclass
class Program:
    """Blocks, and all that a check is given besides the text."""

    blocks: list[Block]
    tools: dict[int, Tool]
    removals: list[Removal]
    start: Start
    inch: bool
    stock: Stock

    @property
    def text(self) -> str:
        """The program as a file."""
        return "".join(f"{self._line(block)}\n" for block in self.blocks)

    def lines(self, wanted: Callable[[Block], bool]) -> set[int]:
        """Return the numbers of the lines whose block is wanted."""
        return {number for number, block in enumerate(self.blocks, start=1) if wanted(block)}

    def find(self, **like) -> list[Block]:
        """Return the blocks with these values."""
        return [block for block in self.blocks if all(getattr(block, key) == value for key, value in like.items())]

    def _line(self, block: Block) -> str:
        scale, digits = (1 / MM_AN_INCH, 6) if self.inch else (1.0, 4)
        shift = {"X": block.shift_mm[0], "Y": block.shift_mm[1]}
        words = [
            f"{letter}{(value + shift.get(letter, 0)) * scale:.{digits}f}" for letter, value in block.words.items()
        ]
        return " ".join([block.code, *words])


@dataclass
class Fault:
    """A fault in a program, the codes under which it may be found and the lines that are right."""

    kind: str
    program: Program
    codes: set[str]
    lines: set[int]


class Maker:
    """Makes one program from one seed."""

    def __init__(self, seed: int):
        self.random = random.Random(seed)
        pick = self.random
        self.stock = pick.choice(STOCKS)
        self.blocks: list[Block] = []
        self.removals: list[Removal] = []
        self.zero = (pick.uniform(-260, -140), pick.uniform(-260, -140), pick.uniform(-45, -30))
        self.systems = pick.sample(WORK_SYSTEMS[:6], 2)
        self.other_zero = (pick.uniform(-300, -100), pick.uniform(-300, -100), self.zero[2])
        self.shift = (0.0, 0.0)
        self.section, self.feature, self.level = 0, -1, -1
        diameter = round(pick.uniform(4, 8), 1)
        wrong = diameter + pick.choice([-1, 1]) * round(pick.uniform(0.1, 1.0), 2)
        self.tools = {
            SOLID: Tool(number=SOLID, shape="flat", diameter_mm=diameter),
            DRILL: Tool(number=DRILL, shape="drill", diameter_mm=round(diameter * pick.uniform(0.5, 0.9), 1)),
            CORED: Tool(number=CORED, shape="flat", diameter_mm=diameter, core_diameter_mm=diameter / 4),
            WRONG: Tool(number=WRONG, shape="flat", diameter_mm=wrong),
        }
        self.radius = diameter / 2

    def program(self) -> Program:
        """Return the program."""
        pick = self.random
        inch = pick.random() < 0.3
        self.add(f"G90 G17 {'G20' if inch else 'G21'} {self.systems[0]}")
        places = pick.sample(FIELDS, pick.randint(1, 4))
        ways = [pick.choice(["straight", "straight", "helix", "ramp", "drilled"]) for _ in places]
        shapes = [self._shape(place, way) for place, way in zip(places, ways, strict=True)]
        for tool, mine in ((DRILL, ["drilled"]), (SOLID, ["straight"]), (CORED, ["helix", "ramp", "drilled"])):
            todo = [k for k, way in enumerate(ways) if way in mine]
            if todo:
                self._section(tool, [(k, shapes[k], ways[k]) for k in todo])
        self.add("M5")
        self.add("M2")
        start = Start(
            work_offsets_mm={self.systems[0]: self.zero, self.systems[1]: self.other_zero},
            zero_known=True,
        )
        return Program(self.blocks, self.tools, self.removals, start, inch, self.stock)

    def add(self, code: str, role: str = "", side: int = -1, **words: float) -> None:
        self.blocks.append(
            Block(code, words, self.shift, self.section, self.feature, self.level, role, side),
        )

    def _section(self, tool: int, todo: list) -> None:
        pick = self.random
        if self.section:
            self.add("M5")
            self.add("M0")
        self.section += 1
        self.add(f"T{tool}", "tool")
        self.add("M3 S9000", "spindle")
        self.add("G4 P3")
        self.add("G0", Z=SAFE_MM)
        for k, shape, way in todo:
            between = pick.choice(["", "corner", "travel", "shift"])
            if between == "corner":
                self._round_a_corner(self.tools[tool].radius_mm)
            elif between == "travel" and self._placed():
                self._visit()
            elif between == "shift" and self._placed():
                self._move_zero()
            if tool == DRILL:
                self._drill(shape)
            else:
                self.feature = k
                shape(way)
                self.add("G0", Z=SAFE_MM)
                self.feature = self.level = -1

    def _placed(self) -> bool:
        """Say whether the stock's frame is given: the first move has named its offset."""
        return any("X" in block.words for block in self.blocks)

    def _shape(self, place: Point, way: str):
        pick, r = self.random, self.radius
        depth = round(pick.uniform(1, 8), 2)
        levels = pick.randint(1, 3)
        heights = [-depth * (k + 1) / levels for k in range(levels)]
        angle = pick.uniform(0, 180)
        kind = pick.choice(["pocket", "round", "slot"] if way == "straight" else ["pocket", "round"])
        if kind == "slot":
            half = pick.uniform(3, 12)
            ends = [_turned((x, 0), angle, place) for x in (-half, half)]
            self.removals.append(Removal(shapely.LineString(ends).buffer(r, quad_segs=128), 0, heights[-1]))
            cut = lambda way: self._slot(ends, heights)  # noqa: E731
        elif kind == "round":
            wide = r + pick.uniform(0.7 * r, 11)
            self.removals.append(Removal(shapely.Point(place).buffer(wide, quad_segs=256), 0, heights[-1]))
            cut = lambda way: self._round(place, wide - r, heights, way)  # noqa: E731
        else:
            long, short = sorted((pick.uniform(0.7 * r, 8), pick.uniform(0.7 * r, 8)), reverse=True)
            region = affinity.rotate(shapely.box(-long, -short, long, short).buffer(r, quad_segs=128), angle, (0, 0))
            self.removals.append(Removal(affinity.translate(region, *place), 0, heights[-1]))
            cut = lambda way: self._pocket(place, long, short, angle, heights, way)  # noqa: E731
        cut.place, cut.depth = place, depth
        return cut

    def _drill(self, shape) -> None:
        x, y = shape.place
        drill = self.tools[DRILL]
        deep = shape.depth + drill.radius_mm / math.tan(math.radians(59)) + 0.1
        hole = shapely.Point(x, y).buffer(drill.radius_mm, quad_segs=128)
        self.removals.append(Removal(hole, 0, -deep, reachable=shapely.Point(x, y).buffer(0.005)))
        self.add("G0", X=x, Y=y)
        self.add("G0", Z=NEAR_MM)
        self.add("G1", "drilled", Z=-deep, F=100)
        self.add("G0", Z=SAFE_MM)

    def _enter(self, place: Point, before: float, z: float, way: str) -> None:
        """Go down in the middle from `before` to z, straight or by a helix."""
        radius = 0.6 * self.radius
        if way == "ramp":
            self._ramp(place, radius, before, z)
            return
        if way != "helix":
            self.add("G1", "entry", Z=z, F=150)
            return
        turns = math.ceil((before - z) / (2 * math.pi * radius * math.tan(math.radians(4))))
        self.add("G1", X=place[0] + radius, Y=place[1], F=600)
        for k in range(1, turns + 1):
            self.add(
                "G3", "entry", X=place[0] + radius, Y=place[1], Z=before + (z - before) * k / turns, I=-radius, J=0
            )
        self.add("G3", "turn", X=place[0] + radius, Y=place[1], I=-radius, J=0)
        self.add("G1", X=place[0], Y=place[1])

    def _ramp(self, place: Point, out: float, before: float, z: float) -> None:
        """Go down to and fro, then once more level; end in the middle."""
        legs = math.ceil((before - z) / (2 * out * math.tan(math.radians(self.random.uniform(3, 9)))))
        self.add("G1", X=place[0] + out, Y=place[1], F=600)
        for k in range(1, legs + 1):
            side = -1 if k % 2 else 1
            self.add("G1", "entry", X=place[0] + side * out, Y=place[1], Z=before + (z - before) * k / legs)
        for side in (-1, 1):
            self.add("G1", "turn", X=place[0] + side * out, Y=place[1])
        self.add("G1", X=place[0], Y=place[1])

    def _levels(self, place: Point, heights: list[float], way: str):
        """Yield each level, entered in the middle."""
        self.add("G0", X=place[0], Y=place[1])
        self.add("G0", Z=NEAR_MM)
        for number, (before, z) in enumerate(zip([NEAR_MM, *heights], heights, strict=False)):
            self.level = number
            self._enter(place, before, z, way)
            yield number

    def _pocket(self, place: Point, long: float, short: float, angle: float, heights: list[float], way: str) -> None:
        rings = math.ceil(short / (self.random.uniform(0.5, 1.2) * self.radius))
        for _ in self._levels(place, heights, way):
            for x in (long - short, short - long, long - short):
                self._feed((x, 0), angle, place)
            for k in range(1, rings + 1):
                b = short * k / rings
                a = long - short + b
                for side, point in enumerate(((a, 0), (a, b), (-a, b), (-a, -b), (a, -b), (a, 0))):
                    self._feed(point, angle, place, "wall" if k == rings else "ring", side)
            self._feed((0, 0), angle, place)

    def _round(self, place: Point, out: float, heights: list[float], way: str) -> None:
        rings = math.ceil(out / (self.random.uniform(0.5, 1.5) * self.radius))
        sense = self.random.choice(["G2", "G3"])
        for _ in self._levels(place, heights, way):
            for k in range(1, rings + 1):
                arm, role = out * k / rings, "wall" if k == rings else "ring"
                self.add("G1", role, 0, X=place[0] + arm, Y=place[1], F=800)
                self.add(sense, role, 1, X=place[0] + arm, Y=place[1], I=-arm, J=0)
            self.add("G1", X=place[0], Y=place[1])

    def _slot(self, ends: list[Point], heights: list[float]) -> None:
        self.add("G0", X=ends[0][0], Y=ends[0][1])
        self.add("G0", Z=NEAR_MM)
        for number, z in enumerate(heights):
            self.level = number
            self.add("G1", "entry", Z=z, F=150)
            there = ends[(number + 1) % 2]
            self.add("G1", "wall", 0, X=there[0], Y=there[1], F=500)

    def _feed(self, point: Point, angle: float, place: Point, role: str = "", side: int = -1) -> None:
        x, y = _turned(point, angle, place)
        self.add("G1", role, side, X=x, Y=y, F=800)

    def _round_a_corner(self, radius: float) -> None:
        """Rapids beside the stock, a twentieth of a millimetre off its rim towards a corner, or through its valley."""
        pick = self.random
        if isinstance(self.stock, HeightField) and pick.random() < 0.5:
            self._through_the_valley(radius)
            return
        u = (pick.choice([-1, 1]), pick.choice([-1, 1]))
        z = -pick.uniform(0.5, 6)
        for role, along, height in (("", -12, SAFE_MM), ("", -12, z), ("corner", 12, z), ("", 12, SAFE_MM)):
            x, y = _beside_corner(self.stock, u, radius + 0.05, along)
            if role or (height == SAFE_MM and along < 0):
                self.add("G0", role, X=x, Y=y)
            else:
                self.add("G0", Z=height)
            self.blocks[-1].side = 2 * (u[0] > 0) + (u[1] > 0)

    def _through_the_valley(self, radius: float) -> None:
        x = self.random.choice([-1, 1]) * (VALLEY_MM[0] - radius - 0.05)
        z = -self.random.uniform(4, VALLEY_MM[2] - 0.05)
        self.add("G0", X=x, Y=-50)
        self.add("G0", Z=z)
        self.add("G0", "corner", IN_VALLEY, X=x, Y=50)
        self.add("G0", Z=SAFE_MM)

    def _visit(self) -> None:
        """A rapid to one end of the travel, a hundredth within it, under the other work offset."""
        pick = self.random
        axis, low = pick.choice([0, 1]), pick.random() < 0.5
        profile = MACHINE.axes[axis]
        end = profile.travel_min_mm + 0.01 if low else profile.travel_max_mm - 0.01
        before = self.shift
        self.add(self.systems[1])
        self.shift = tuple(before[k] + self.zero[k] - self.other_zero[k] for k in range(2))
        self.add("G0", "travel", -1 if low else 1, **{"XY"[axis]: end - self.zero[axis]})
        self.shift = before
        self.add(self.systems[0])

    def _move_zero(self) -> None:
        """G92: from here on the program counts from elsewhere."""
        pick = self.random
        x, y = pick.uniform(-40, 40), pick.uniform(-30, 30)
        self.add("G0", X=x, Y=y)
        self.shift = (pick.uniform(-50, 50), pick.uniform(-50, 50))
        self.add("G92", X=x, Y=y)


def _turned(point: Point, angle_deg: float, place: Point) -> Point:
    turn = math.radians(angle_deg)
    x = point[0] * math.cos(turn) - point[1] * math.sin(turn)
    return x + place[0], point[0] * math.sin(turn) + point[1] * math.cos(turn) + place[1]


def _beside_corner(stock: Stock, u: tuple[int, int], out_mm: float, along_mm: float) -> Point:
    """Return a point on the line across the diagonal of the stock's rim in the direction u."""
    s = math.sqrt(0.5)
    share = s if isinstance(stock, Cylinder) else 1.0
    corner = (u[0] * share * stock.size_mm[0] / 2, u[1] * share * stock.size_mm[1] / 2)
    return corner[0] + u[0] * s * (out_mm - along_mm), corner[1] + u[1] * s * (out_mm + along_mm)


def clean_program(seed: int) -> Program:
    """Return the program of a seed, without a fault."""
    return Maker(seed).program()


def faults_of(clean: Program, seed: int) -> list[Fault]:
    """Return one fault of each kind that the program has room for, each in a copy of its own."""
    made = [plant(copy.deepcopy(clean), random.Random(f"{seed} {kind}")) for kind, plant in FAULTS.items()]
    return [fault for fault in made if fault is not None]


def _gouge(program: Program, pick: random.Random) -> Fault | None:
    """The tool 0.02 mm too far into a wall, or too deep."""
    entries = _last_entries(program)
    if pick.random() < 0.3:
        low = pick.choice(entries)
        low.words["Z"] -= GOUGE_MM
        wrong = program.lines(lambda block: (block.feature, block.level) == (low.feature, low.level))
        return Fault("gouge", program, {"gouge"}, wrong)
    some = pick.choice(entries)
    level = pick.choice(range(some.level + 1))
    wall = program.find(feature=some.feature, level=level, role="wall")
    changed = _outwards(wall, _before(program, wall[0]), pick)
    if changed is None:
        return None
    first = min(_numbers(program, changed))
    return Fault("gouge", program, {"gouge"}, set(range(first, max(_numbers(program, changed)) + 2)))


def _outwards(wall: list[Block], before: Block, pick: random.Random) -> list[Block] | None:
    """Move one side of a pocket, a circle or the end of a slot outwards."""
    if len(wall) == 1:
        dx, dy = (wall[0].words[key] - before.words[key] for key in "XY")
        _move(wall, dx, dy)
        return wall
    if len(wall) == 2:
        arm = -wall[1].words["I"]
        wall[0].words["X"] += GOUGE_MM
        wall[1].words["X"] += GOUGE_MM
        wall[1].words["I"] = -arm - GOUGE_MM
        return wall
    side = pick.choice([(1, 2), (2, 3), (3, 4)])
    one, other, next_ = (wall[side[0]].words, wall[side[1]].words, wall[(side[1] + 1)].words)
    _move([wall[k] for k in side], other["X"] - next_["X"], other["Y"] - next_["Y"])
    return [wall[k] for k in side] if one else None


def _move(blocks: list[Block], dx: float, dy: float) -> None:
    length = math.hypot(dx, dy)
    for block in blocks:
        block.words["X"] += dx / length * GOUGE_MM
        block.words["Y"] += dy / length * GOUGE_MM


def _corner(program: Program, pick: random.Random) -> Fault | None:
    """A rapid 1 mm through a corner of the stock, or through the side of its valley."""
    rapids = program.find(role="corner")
    if not rapids:
        return None
    rapid = pick.choice(rapids)
    tool = program.tools[int(program.find(section=rapid.section, role="tool")[0].code[1:])]
    number = program.blocks.index(rapid)
    if rapid.side == IN_VALLEY:
        x = math.copysign(VALLEY_MM[1] - tool.radius_mm + CORNER_MM, rapid.words["X"])
        rapid.words["X"] = program.blocks[number - 2].words["X"] = x
        return Fault("corner", program, {"rapid-in-stock"}, {number + 1})
    u = (1 if rapid.side // 2 else -1, 1 if rapid.side % 2 else -1)
    for block, along in ((program.blocks[number - 2], -12), (rapid, 12)):
        block.words["X"], block.words["Y"] = _beside_corner(program.stock, u, tool.radius_mm - CORNER_MM, along)
    return Fault("corner", program, {"rapid-in-stock"}, {number + 1})


def _missing(program: Program, pick: random.Random) -> Fault | None:
    """The pass along the wall left out at the last level."""
    last = pick.choice(_last_entries(program))
    gone = program.find(feature=last.feature, level=last.level, role="wall")
    program.blocks = [block for block in program.blocks if not any(block is one for one in gone)]
    return Fault("missing", program, {"left-over"}, program.lines(lambda block: block.feature == last.feature))


def _wrong_tool(program: Program, pick: random.Random) -> Fault | None:
    """Another mill than the one that the program was made for."""
    words = [block for block in program.find(role="tool") if block.code != f"T{DRILL}"]
    word = pick.choice(words)
    word.code = f"T{WRONG}"
    return Fault(
        "wrong tool", program, {"gouge", "left-over"}, program.lines(lambda block: block.section == word.section)
    )


def _spindle_off(program: Program, pick: random.Random) -> Fault | None:
    """No M3 at the begin of a section, or an M5 before one of its features."""
    if pick.random() < 0.5:
        word = pick.choice(program.find(role="spindle"))
        word.code = "M5"
        cuts = [block for block in program.blocks if block.section == word.section and block.words.get("Z", 0) < 0]
        cuts = [block for block in cuts if block.role in ("entry", "drilled")]
    else:
        cuts = [block for block in program.find(role="entry") if block.words["Z"] < 0]
        chosen = pick.choice(cuts)
        cuts = [block for block in program.find(feature=chosen.feature, role="entry") if block.words["Z"] < 0]
        number = next(k for k, block in enumerate(program.blocks) if block.feature == chosen.feature)
        program.blocks.insert(number, Block("M5", section=chosen.section))
    first = 1 if cuts[0].words["Z"] < -RUB_MM else 2  # a first turn that only rubs cuts nothing
    return Fault("spindle off", program, {"spindle-off"}, _numbers(program, cuts[:first]))


def _beside_hole(program: Program, pick: random.Random) -> Fault | None:
    """A mill with a core goes straight down beside the hole that was drilled for it."""
    if not program.find(role="drilled"):
        return None
    cored = program.find(role="tool", code=f"T{CORED}")[0]
    entries = [block for block in program.find(section=cored.section, role="entry", level=0) if "X" not in block.words]
    entry = pick.choice(entries)
    number = program.blocks.index(entry)
    drill, mill = program.tools[DRILL], program.tools[CORED]
    angle, out = pick.uniform(0, 2 * math.pi), drill.radius_mm - mill.core_diameter_mm / 2 + pick.uniform(0.1, 0.5)
    place = program.blocks[number - 2].words
    place["X"] += out * math.cos(angle)
    place["Y"] += out * math.sin(angle)
    return Fault("beside hole", program, {"plunge"}, {number + 1})


def _travel(program: Program, pick: random.Random) -> Fault | None:
    """The end of the travel passed by a hundredth, under another work offset."""
    visits = program.find(role="travel")
    if not visits:
        return None
    visit = pick.choice(visits)
    (letter,) = visit.words
    visit.words[letter] += visit.side * (0.01 + BEYOND_MM)
    return Fault("travel", program, {"travel"}, _numbers(program, [visit]))


def _last_entries(program: Program) -> list[Block]:
    """Return the last block of the way down to the last level of each feature."""
    last: dict[int, Block] = {}
    for block in program.find(role="entry"):
        last[block.feature] = block
    return list(last.values())


def _before(program: Program, block: Block) -> Block:
    """Return the last block before this one that names X."""
    number = next(k for k, one in enumerate(program.blocks) if one is block)
    return next(one for one in reversed(program.blocks[:number]) if "X" in one.words)


def _numbers(program: Program, wanted: list[Block]) -> set[int]:
    return program.lines(lambda block: any(block is one for one in wanted))


FAULTS: dict[str, Callable[[Program, random.Random], Fault | None]] = {
    "gouge": _gouge,
    "corner": _corner,
    "missing": _missing,
    "wrong tool": _wrong_tool,
    "spindle off": _spindle_off,
    "beside hole": _beside_hole,
    "travel": _travel,
}
