# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bracket in CadQuery: a plate with four holes and a slot, and a web along one side. bracket.step is its export."""

import cadquery as cq

plate = cq.Workplane("XY").box(80, 50, 6, centered=(True, True, False)).edges("|Z").fillet(8)
plate = plate.faces(">Z").workplane().rect(60, 30, forConstruction=True).vertices().hole(5.5)
plate = plate.faces(">Z").workplane().slot2D(24, 8).cutThruAll()
web = cq.Workplane("XY").box(80 - 16, 4, 20, centered=(True, True, False)).translate((0, 23, 0))
result = plate.union(web)
