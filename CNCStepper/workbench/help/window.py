# SPDX-License-Identifier: LGPL-2.1-or-later
"""The help window: a page of Markdown that Qt renders, with back, forward, contents and a search in the page.

Guides are read from docs/user-guide, pages of objects and codes are made at the moment, all in FreeCAD's language.
Where `make manual` has built the whole manual, the contents link to it; the system's browser opens that.
"""

from __future__ import annotations

import re
import threading
from pathlib import Path
from typing import Any

import FreeCADGui
from PySide import QtCore, QtGui

from CNCStepper.workbench import packages
from CNCStepper.workbench.help import object_pages
from CNCStepper.workbench.help.object_tables import classes_by_type, properties_of_type
from CNCStepper.workbench.help.topics import (
    CODE_OF_LANGUAGE,
    CODES,
    CONTENTS,
    GUIDES,
    OBJECTS_FOLDER,
    PROFILE,
    REFUSALS,
    TOPIC_OF,
    address_of,
    cycle_picture,
    guide_file,
    refusals_page,
    slug,
)
from CNCStepper.workbench.services.front_window import in_front
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

NAME = "CNCStepper_Help"
SIZE = (760, 640)
PICTURE_PX = 640  # as wide as one is shown at most
PICTURE = re.compile(r"(!\[[^\]]*\]\()([^)\s]+)(\))")
FILE_LINK = re.compile(r"[a-z]+://")
MANUALS = (packages.ROOT / "resources" / "manual", packages.ROOT / "build" / "manual")
WHOLE_MANUAL = later("[The whole manual]({0}) opens in the browser.")


class Page(QtGui.QTextBrowser):
    """The text of a page, with pictures no wider than it is."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self._shown: Any = None  # the document of the page; the empty one of the beginning is Qt's own

    def show_markdown(self, text: str) -> None:
        """Show another page; what is shown already Qt would lay out anew with each of the new lines, for 0.4 s."""
        before, document = self._shown, QtGui.QTextDocument(self)
        document.setUndoRedoEnabled(False)
        document.setDefaultFont(self.font())
        document.setMarkdown(text)
        self.setDocument(document)
        self._shown = document
        if before is not None:
            before.deleteLater()

    def loadResource(self, kind: int, url: Any) -> Any:
        """Return a picture as wide as it is shown; all else as Qt does."""
        if kind != QtGui.QTextDocument.ResourceType.ImageResource or not url.isLocalFile():
            return super().loadResource(kind, url)
        picture, widest_px = QtGui.QImage(url.toLocalFile()), round(PICTURE_PX * self.devicePixelRatioF())
        if picture.width() > widest_px:
            picture = picture.scaledToWidth(widest_px, QtCore.Qt.TransformationMode.SmoothTransformation)
            picture.setDevicePixelRatio(self.devicePixelRatioF())
        return picture


class HelpWindow(QtGui.QDialog):
    """See the module; `address` and `key` are what is shown, `trail` what was shown before."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(tr("CNCStepper help"))
        self.resize(*SIZE)
        self.address, self.key = "", ""
        self.trail: list[tuple[str, str]] = []
        self.ahead: list[tuple[str, str]] = []
        self.browser = Page(self)
        self.browser.setObjectName(f"{NAME}_text")
        self.browser.setAccessibleName(tr("CNCStepper help"))
        self.browser.setOpenLinks(False)
        self.browser.anchorClicked.connect(guarded(self._follow))
        self.search = QtGui.QLineEdit(self)
        self.search.setObjectName(f"{NAME}_search")
        self.search.setPlaceholderText(tr("Search in this page"))
        self.search.setAccessibleName(tr("Search in this page"))
        self.search.returnPressed.connect(guarded(self.find_next))
        self._arrange()
        threading.Thread(target=classes_by_type, daemon=True).start()  # for pages of objects that are not open

    def open(self, address: str, key: str = "") -> None:
        """Show a page and scroll to a field by its key, or to a heading by "#" and its name."""
        if self.address and (self.address, self.key) != (address, key):
            self.trail.append((self.address, self.key))
            self.ahead.clear()
        self._render(address, key)

    def go_back(self) -> None:
        """Show what was shown before."""
        if self.trail:
            self.ahead.append((self.address, self.key))
            self._render(*self.trail.pop())

    def go_forward(self) -> None:
        """Show what was left by going back."""
        if self.ahead:
            self.trail.append((self.address, self.key))
            self._render(*self.ahead.pop())

    def find_next(self) -> None:
        """Mark the next place of what stands in the search, from the top again after the last."""
        if not self.browser.find(self.search.text()):
            self.browser.moveCursor(QtGui.QTextCursor.MoveOperation.Start)
            self.browser.find(self.search.text())

    def _arrange(self) -> None:
        row = QtGui.QHBoxLayout()
        self.back = self._button("back", tr("Back"), self.go_back)
        self.forward = self._button("forward", tr("Forward"), self.go_forward)
        contents = self._button("contents", tr("Contents"), lambda: self.open(CONTENTS))
        for button in (self.back, self.forward, contents):
            row.addWidget(button)
        row.addWidget(self.search, 1)
        column = QtGui.QVBoxLayout(self)
        column.addLayout(row)
        column.addWidget(self.browser)

    def _button(self, name: str, text: str, act: Any) -> Any:
        button = QtGui.QPushButton(text, self)
        button.setObjectName(f"{NAME}_{name}")
        button.setAutoDefault(False)
        button.clicked.connect(guarded(lambda _=False: act()))
        return button

    def _render(self, address: str, key: str) -> None:
        if address != self.address:
            text, folder = page(address)
            self.browser.show_markdown(with_whole_addresses(text, folder))
        self.address, self.key = address, key
        self.back.setEnabled(bool(self.trail))
        self.forward.setEnabled(bool(self.ahead))
        self._scroll(key)

    def _scroll(self, key: str) -> None:
        """Bring the heading of a field or of "#name" to the top, and mark it."""
        block = _heading(self.browser.document(), key) if key else self.browser.document().begin()
        cursor = QtGui.QTextCursor(block)
        self.browser.moveCursor(QtGui.QTextCursor.MoveOperation.End)  # so that what is wanted comes to the top
        self.browser.setTextCursor(cursor)
        if key:
            cursor.movePosition(QtGui.QTextCursor.MoveOperation.EndOfBlock, QtGui.QTextCursor.MoveMode.KeepAnchor)
            self.browser.setTextCursor(cursor)
        bar = self.browser.verticalScrollBar()
        bar.setValue(bar.value() + self.browser.cursorRect(cursor).top())

    def _follow(self, url: Any) -> None:
        """Follow a link: to a page of the help here, to anything else with the system's own program."""
        text, _, name = url.toString().partition("#")
        address = self._address_of_link(text)
        if address:
            self.open(address, f"#{name}" if name else "")
        else:
            QtGui.QDesktopServices.openUrl(_absolute(url, _folder(self.address)))

    def _address_of_link(self, text: str) -> str:
        """Return the address of the page that a link names, "" where it names none of ours."""
        if not text or text in (CONTENTS, CODES, PROFILE, REFUSALS) or text.startswith(OBJECTS_FOLDER):
            return text or self.address
        if FILE_LINK.match(text):
            return ""
        return address_of((_folder(self.address) / text).resolve())


def open_help(address: str = CONTENTS, key: str = "") -> HelpWindow:
    """Open the help window of FreeCAD's window at a page and bring it to the front."""
    window = FreeCADGui.getMainWindow()
    shown = in_front(window.findChild(QtGui.QDialog, NAME) or HelpWindow(window))
    QtCore.QTimer.singleShot(0, guarded(lambda: shown.open(address, key)))  # the window is painted before
    return shown


def language() -> str:
    """Return the code of FreeCAD's language among those of the manual, "en" where it has none of its own."""
    return str(tr(CODE_OF_LANGUAGE).rpartition(" ")[2])


def page(address: str) -> tuple[str, Path]:
    """Return a page's Markdown in FreeCAD's language, and the folder that its addresses begin at."""
    if address == CODES:
        return object_pages.codes_page(tr, translated), GUIDES
    if address == REFUSALS:
        return refusals_page(language()), GUIDES
    if address == PROFILE:
        return _machine_page(), GUIDES
    if address.startswith(OBJECTS_FOLDER):
        return _object_page(address.removeprefix(OBJECTS_FOLDER)), GUIDES
    if address == CONTENTS:
        built = next((path for path in map(_built, MANUALS) if path.exists()), None)
        uri = "" if built is None else QtCore.QUrl.fromLocalFile(str(built)).toString()
        return object_pages.contents_page(tr, tr(WHOLE_MANUAL).format(uri) if uri else ""), GUIDES
    file = guide_file(address, language())
    return file.read_text("utf-8"), file.parent


def with_whole_addresses(text: str, folder: Path) -> str:
    """Return Markdown whose pictures have whole addresses: Qt looks for them beside no file of its own."""

    def whole(found: re.Match[str]) -> str:
        file = (folder / found[2]).resolve()
        return f"{found[1]}{QtCore.QUrl.fromLocalFile(str(file)).toString()}{found[3]}"

    return PICTURE.sub(whole, text)


def _object_page(type_name: str) -> str:
    topic = TOPIC_OF[type_name]
    address = f"../pictures/cycles/{cycle_picture(topic.picture, language())}" if topic.picture else ""
    return object_pages.object_page(topic, properties_of_type(type_name), tr, address, topic.guide)


def _machine_page() -> str:
    from CNCStepper.workbench.help.machine_page import machine_page  # loads pydantic, which may be missing

    packages.require()
    return machine_page(tr, "machines.md")


def _built(folder: Path) -> Path:
    return folder / language() / "index.html"


def _folder(address: str) -> Path:
    """Return the folder that the links of a page begin at."""
    return (GUIDES / address).parent if address.endswith(".md") else GUIDES


def _absolute(url: Any, folder: Path) -> Any:
    return QtCore.QUrl.fromLocalFile(str((folder / url.path()).resolve())) if url.isRelative() else url


def _heading(document: Any, key: str) -> Any:
    """Return the block of a field's heading, or of the heading "#name"; the first block where there is none."""
    heading, block = document.begin(), document.begin()
    quoted = re.compile(rf"(?<!\w){re.escape(key)}(?!\w)")
    while block.isValid():
        if block.blockFormat().headingLevel():
            heading = block
            if key.startswith("#") and slug(block.text()) == key[1:]:
                return block
        elif not key.startswith("#") and block.text().startswith(tr(object_pages.KEY)) and quoted.search(block.text()):
            return heading
        block = block.next()
    return document.begin()
