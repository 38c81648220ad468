# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of tolerances: how near two places, heights or angles must be to count as the same.

Each is declared here once, with what it is for; modules import it (tests/unit/test_tolerances.py). Tolerances of
another kind, such as how far chords may leave an arc, belong to the module that makes the chords. The virtual
controllers have their own, as they must be able to disagree.
"""

# calculated numbers, smallest first: what rounding may leave between two results that are meant to be equal
SAME_MATRIX_SCALE = 1e-12  # scales of an edit in three directions: its matrix turns and scales, nothing else
COINCIDENT_MM = 1e-9  # ends of curves' pieces that are one point
SAME_ANGLE_RAD = 1e-9  # an arc that begins on an axis, so that the extreme there is behind it
SAME_SCALE = 1e-9  # scales of an arc or a transform in two directions, by their share
WHOLE_TURNS = 1e-9  # turns of an arc above a whole number that are rounding
NO_AREA_MM2 = 1e-9  # a loop that encloses less is none
NO_RING_MM2 = 1e-8  # a ring of a pocket that encloses less is none
OFFSET_ROUNDING_MM = 1e-8  # how much too near an offset piece may be to the curve
SAME_SUM_MM = 1e-7  # places that differ by what adding up a text's numbers leaves; two places of a motor
FULL_CIRCLE_RAD = 5e-7  # an arc of at most this angle is a full circle, as in grbl
SAME_MM = 1e-6  # places or heights, calculated in different ways
TOUCHING_PARTS_MM = 1e-6  # nested parts that lie closer than that, or that deep in each other, touch
NO_MATERIAL_MM = 1e-6  # material that is thinner is none
NO_LENGTH_MM = 1e-6  # a move that is shorter has no direction
SAME_SHARE = 1e-6  # areas and feeds, by their share; angles of two arcs, in radians or degrees
SAME_COUNT = 1e-6  # places on the grid of a text, in units of its last digit
SAME_PROFILE_POINT = 1e-6  # points of a turned profile, in units of the text
SAME_RESTART_FEED = 1e-6  # feeds of a restart and of its program, by their share
SAME_OUTLINE_SHARE = 1e-3  # of the area: outlines of a part in two rotations that differ by less are one
SAME_ENTRY_MM = 1e-5  # a restart's entry and the point of the path at which it ends
SAME_PIECE_MM = 1e-5  # middles of two pieces of curves between the same nodes: one piece

# what a person or another program has drawn or written
JOINED_ENDS_MM = 1e-4  # ends of drawn lines that join, centres of drawn circles that are one
SAME_CUT_MM = 1e-4  # cuts of a sheet's parts that are drawn twice
SAME_HEIGHT_MM = 1e-4  # heights of a drawing, of a tip or of a cut level
SAME_NUMBER = 1e-4  # numbers that EQ and NE of RS274/NGC compare
WHOLE_NUMBER = 1e-4  # a value of RS274/NGC that is so near to a whole number is one
TANGENT_ENTRY = 1e-4  # cosine of an angle so near to a right one: the entry arc of cutter compensation would be a line
SAME_TEXT_PLACE = 1e-4  # places along X or Z of a lathe profile, in units of the text
SAME_WRITTEN_VALUE = 0.0006  # speeds in rpm and dwells in s that a text has with three decimals
SAME_SURFACE_SPEED = 1e-3  # surface speeds that a text has in other units, by their share
SAME_TRANSLATED_FEED = 0.001  # feeds of a program and of its translation, in mm/min and by their share
SAME_CURVE_MM = 1e-3  # curves that are nearer than this everywhere are one that is drawn twice
SAME_HOLE_MM = 1e-3  # centres of two holes of a pattern that are one hole
TOUCHING_MM = 1e-3  # a point that is nearer to a boundary is on neither side of it
COMMON_LINE_MM = 0.002  # edges of nested parts that face each other a kerf apart, so that one cut serves both
SAME_THICKNESS_MM = 0.005  # thicknesses of a cut chart and of a job
CLOSED_CONTOUR_MM = 0.002  # begin and end of a contour that is closed
SAME_CONVERTED_FEED = 0.0051  # feeds of a program and of its conversion, by their share: a rounded last digit
LEAD_ROUNDING_MM = 0.002  # what flattened outlines and rounding may add to the area that a lead covers
SAME_TEXT_RADIUS = 0.01  # radii of an arc at its two ends for cutter compensation, in units of the text
CUT_TOUCHES_MM = 0.02  # a face of a sheet belongs to a cut whose band comes so near
SAME_PASS_MM = 0.05  # a pass of a jet begins where the one before did
SAME_PATH_MM = 0.02  # places of two compared tool paths: arcs and the chords that CAM programs make of them are one
SAME_CROSSING_MM = 0.01  # crossings of a drawing that are reported as one
PICKED_MM = 0.01  # pieces of a path that are as near to a picked point as that lie above each other
SAME_EDGE_DEG = 0.01  # an insert's edge and a wall of a profile that it just reaches
SAME_ARC_RAD = 0.02  # sweeps of two arcs that are large enough to have one

# what a machine reports or a judgement finds
WORST_PLACE_MM = 0.0003  # a piece that comes this near to the worst place of a gouge has cut it too
REPORTED_MM = 0.005  # a reported place: rounded, in inches to 0.0025 mm
REPORTED_OFFSET_MM = 0.006  # a reported offset: three decimals, in inches four
