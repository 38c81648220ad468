# SPDX-License-Identifier: LGPL-2.1-or-later
"""Switching in a program for QtPlasmaC, which pierces, moves Z and has feeds by its material.

(o=0, na=mild-steel 3 mm 45A, ...)     the material: temporary, or M190 P7 and M66 P3 L3 Q1 for a numbered one
F#<_hal[plasmac.cut-feed-rate]>
G0 X Y
M3 $0 S1                               no G4 behind it: the pierce delay is the material's
G1 ... M67 E3 Q60 ... G3 ...           slower moves are a share of the material's feed
M62 P3  G3 ...  M63 P3                 moves without power that continue along the cut
M67 E3 Q0
M5 $0                                  before the rapid
"""

from __future__ import annotations

from CNCStepper.errors import Text
from CNCStepper.gcode.syntax.material_comments import MaterialComment, comment_of, read_material_comment
from CNCStepper.gcode.writer.block_emitter import BlockEmitter
from CNCStepper.gcode.writer.state_changes import Switches, tool_comment
from CNCStepper.gcode.writer.write_options import WriteOptions
from CNCStepper.state import State
from CNCStepper.toolpath import RAPID

SCRIBE = 1  # of $; the scribe is tool 1 of LinuxCNC's table, the torch tool 0


class PlasmaSwitches(Switches):
    """Writes QtPlasmaC's words where other controllers have spindle, dwell and tool change."""

    def __init__(self, page: BlockEmitter, options: WriteOptions, own_lengths: bool = False):
        super().__init__(page, options, own_lengths=False)
        self._runs: int | None = None  # the tool that M3 has started
        self._is_cut_off = False
        self._has_scribe = False
        self._material = ""

    @property
    def own_events(self) -> tuple[str, ...]:
        """No event before a tool is the tool's own."""
        return ()

    def begin(self) -> None:
        """Write which tools the program is for, and the material of the options, if there is one."""
        for tool, description in self.options.tools.items():
            self.page.comment(tool_comment(tool, description), own=True)
        if self.options.cut_data is not None:
            self._take(comment_of(self.options.cut_data))

    def material(self, text: str) -> None:
        """Write a change of material, unless it is the one in force."""
        known = read_material_comment(text, "mm")
        if known is not None:
            self._take(known)
            return
        self._material = text
        self._change(text)
        self.page.use_cut_feed(0.0)

    def _take(self, known: MaterialComment) -> None:
        text = known.text(self.options.units)
        if text == self._material:
            return
        self.page.raw(text)
        if known.option in (1, 2):  # goes into QtPlasmaC's file; another line chooses it
            return
        self._material = text
        if known.option is None:
            self._change(f"M190 P{known.number}")
        self.page.use_cut_feed(known.feed_mm_min)

    def _change(self, words: str) -> None:
        self.page.line(words)
        self.page.line("M66", "P3", "L3", "Q1")

    def before_move(self, kind: int) -> None:
        """Stop the tool before a rapid after a cut without power."""
        if self._is_cut_off and kind == RAPID:
            self._stop()

    def load(self, tool: int, message: str, length_mm: float, first: bool) -> None:
        """Note the tool: the torch is QtPlasmaC's, and the scribe is chosen where it starts."""
        self.tool = tool

    def dwell(self, seconds: float) -> None:
        """Wait; not behind M3, where the pierce delay is the material's."""
        if not self.page.has_just_started:
            super().dwell(seconds)

    def _turn_spindle(self, state: State) -> None:
        if state.spindle != "off":
            self._start(state.spindle_number)
        elif self._runs is not None and not self._is_cut_off:
            if self.goes_on:
                self.page.line("M62", "P3")
                self._is_cut_off = True
            else:
                self._stop()

    def _start(self, number: int) -> None:
        if self._runs == number and not self._is_cut_off:
            return
        self._stop()
        self._choose(number == SCRIBE)
        self.page.line("M3", f"${number}", "S1")
        self._runs = number

    def _stop(self) -> None:
        """Release the torch, bring the whole feed back and stop the tool that runs."""
        if self._is_cut_off:
            self.page.line("M63", "P3")
        self._is_cut_off = False
        if self._runs is not None:
            self.page.share_feed(1.0)
            self.page.line("M5", f"${self._runs}")
        self._runs = None

    def _choose(self, scribe: bool) -> None:
        """Take the offsets of scribe or torch, and bring that one to the place."""
        if scribe == self._has_scribe:
            return
        self._has_scribe = scribe
        self.page.line(f"T{int(scribe)}", "M6")
        self.page.line("G43", "H0")
        x, y, _ = self.page.at
        self.page.forget()
        self.page.move(RAPID, [x, y, None])
        what = "the scribe is tool {number} of LinuxCNC's table, whose X and Y are its place beside the torch"
        self.page.notes.once(Text(what, number=SCRIBE))

    def before_end(self) -> None:
        """Stop the tool, and go back to the torch."""
        self._stop()
        self._choose(False)
