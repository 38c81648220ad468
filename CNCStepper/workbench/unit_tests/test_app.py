# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether drawings become checked programs in this FreeCAD; none of it needs a window."""

from __future__ import annotations

import tempfile
import unittest
from pathlib import Path

import FreeCAD
import Part

from CNCStepper.errors import JobError
from CNCStepper.workbench import api, packages

STOCK_MM = (100, 70, 20)


class InNewDocument(unittest.TestCase):
    """A case with an empty document, which it closes."""

    def setUp(self) -> None:
        """Make the document."""
        self.document = FreeCAD.newDocument("CNCStepperTest")
        self.name = self.document.Name

    def tearDown(self) -> None:
        """Close the document."""
        FreeCAD.closeDocument(self.name)


class TestPackages(unittest.TestCase):
    """The packages that the workbench takes."""

    def test_none_is_missing(self) -> None:
        """Name those that FreeCAD lacks."""
        self.assertEqual(list(packages.missing()), [], "use Install packages… in the message of the workbench")


class TestProgram(InNewDocument):
    """From objects to a program."""

    def setUp(self) -> None:
        """Make a job with a tool and a pocket."""
        super().setUp()
        self.job = api.new_job(self.document, machine="table-a", stock_size_mm=STOCK_MM)
        api.add_tool(self.job, number=1, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200)
        self.pocket = api.add_elliptical_pocket(self.job, radius_x_mm=40, radius_y_mm=25, depth_mm=10)
        self.document.recompute()

    def test_pocket_becomes_a_program(self) -> None:
        """The program cuts to the bottom of the pocket."""
        text = api.program_text(self.job)
        self.assertIn("G1", text)
        self.assertIn("Z-10", text)

    def test_tool_wider_than_the_pocket_is_refused(self) -> None:
        """No program is left that the drawing has outgrown."""
        api.edit(self.pocket, radius_y_mm=1)
        self.document.recompute()
        with self.assertRaises(JobError):
            api.program_text(self.job)

    def test_saved_document_opens_with_the_same_program(self) -> None:
        """Saving and opening changes nothing."""
        text, job_name = api.program_text(self.job), self.job.Name
        with tempfile.TemporaryDirectory() as folder:
            path = str(Path(folder) / "peça.FCStd")
            self.document.saveAs(path)
            FreeCAD.closeDocument(self.name)
            opened = FreeCAD.openDocument(path)
            self.name = opened.Name
            self.assertEqual(api.program_text(opened.getObject(job_name)), text)


class TestDrawing(InNewDocument):
    """From a drawn line to a program."""

    def test_contour_follows_its_drawing(self) -> None:
        """A drawing that moves makes the job's program another one."""
        circle = self.document.addObject("Part::Feature", "Circle")
        circle.Shape = Part.makeCircle(20)
        job = api.new_job(self.document, machine="table-a", stock_size_mm=STOCK_MM)
        api.add_tool(job, number=1, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200)
        api.add_engrave(job, circle, depth_mm=1)
        self.document.recompute()
        before = api.program_text(job)
        circle.Shape = Part.makeCircle(15)
        self.document.recompute()
        self.assertNotEqual(api.program_text(job), before)
