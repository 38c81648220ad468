# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mouse and keys as the X server sends them (its XTEST extension): FreeCAD cannot tell them from a person's."""

from __future__ import annotations

import os

from Xlib import XK, X, display
from Xlib.ext import xtest
from Xlib.protocol import event

KEY_NAMES = {
    "Ctrl": "Control_L",
    "Shift": "Shift_L",
    "Alt": "Alt_L",
    "Esc": "Escape",
    "Enter": "Return",
    "Space": "space",
    "Backspace": "BackSpace",
    "PageUp": "Page_Up",
    "PageDown": "Page_Down",
    "-": "minus",
}
LEFT, MIDDLE, RIGHT, WHEEL_UP, WHEEL_DOWN = 1, 2, 3, 4, 5


class Keyboard:
    """The keys of the X server, by name ("Ctrl+Z") or by the letters they write."""

    def __init__(self, server: display.Display) -> None:
        self._server = server
        self.held: list[int] = []

    def down(self, name: str) -> None:
        """Press a key: "Ctrl", "Return", "F1", "a"."""
        code = self._code(KEY_NAMES.get(name, name))
        xtest.fake_input(self._server, X.KeyPress, code)
        self._server.sync()
        self.held.append(code)

    def up(self, name: str) -> None:
        """Release a key."""
        self._release(self._code(KEY_NAMES.get(name, name)))

    def _release(self, code: int) -> None:
        xtest.fake_input(self._server, X.KeyRelease, code)
        self._server.sync()
        self.held.remove(code)

    def release_all(self) -> None:
        """Release what is still held down."""
        for code in reversed(self.held[:]):
            self._release(code)

    def stroke(self, combination: str) -> None:
        """Press and release keys together: "Return", "Ctrl+Z", "Ctrl+Shift+S"."""
        names = combination.split("+") if combination != "+" else ["+"]
        for name in names:
            self.down(name)
        for name in reversed(names):
            self.up(name)

    def learn(self, text: str) -> None:
        """Give every letter of a text a key, before any of them is typed."""
        for letter in text:
            self._symbol_code(_symbol(letter))

    def write(self, letter: str) -> None:
        """Type one character, with Shift where it stands on the upper half of its key."""
        symbol = _symbol(letter)
        shifted = any(index == 1 for _, index in self._places(symbol)) and not any(
            index == 0 for _, index in self._places(symbol)
        )
        code = self._symbol_code(symbol)
        if shifted:
            self.down("Shift")
        xtest.fake_input(self._server, X.KeyPress, code)
        xtest.fake_input(self._server, X.KeyRelease, code)
        self._server.flush()
        if shifted:
            self.up("Shift")

    def _code(self, name: str) -> int:
        symbol = XK.string_to_keysym(name)
        assert symbol or len(name) == 1, f"no key is named {name!r}"
        return self._symbol_code(symbol or ord(name))

    def _places(self, symbol: int) -> list[tuple[int, int]]:
        return list(self._server.keysym_to_keycodes(symbol))

    def _symbol_code(self, symbol: int) -> int:
        places = self._places(symbol)
        return places[0][0] if places else self._bind(symbol)

    def _bind(self, symbol: int) -> int:
        """Put a letter that the keyboard lacks on a key that has none."""
        first, last = self._server.display.info.min_keycode, self._server.display.info.max_keycode
        mapping = self._server.get_keyboard_mapping(first, last - first + 1)
        code = first + max(index for index, symbols in enumerate(mapping) if not any(symbols))
        self._server.change_keyboard_mapping(code, [[symbol, symbol]])
        self._server.sync()
        changed = event.MappingNotify(request=X.MappingKeyboard, first_keycode=code, count=1)
        self._server.refresh_keyboard_mapping(changed)
        return code


def _symbol(letter: str) -> int:
    return ord(letter) if ord(letter) < 0x100 else 0x01000000 | ord(letter)


class Mouse:
    """The pointer of the X server; places are pixels of the screen. `presses` counts how often a button was pressed."""

    def __init__(self, server: display.Display) -> None:
        self._server = server
        self.held: list[int] = []
        self.presses = 0

    def move(self, x: float, y: float) -> None:
        """Put the pointer somewhere."""
        xtest.fake_input(self._server, X.MotionNotify, x=round(x), y=round(y))
        self._server.sync()

    def down(self, button: int = LEFT) -> None:
        """Press a button."""
        xtest.fake_input(self._server, X.ButtonPress, button)
        self._server.sync()
        self.held.append(button)
        self.presses += 1

    def up(self, button: int = LEFT) -> None:
        """Release a button."""
        xtest.fake_input(self._server, X.ButtonRelease, button)
        self._server.sync()
        self.held.remove(button)

    def release_all(self) -> None:
        """Release what is still held down."""
        for button in self.held[:]:
            self.up(button)


def connect() -> display.Display:
    """Return a connection of our own to the X server of this window."""
    return display.Display(os.environ["DISPLAY"])
