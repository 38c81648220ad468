# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of the libraries' columns; those of tools are the tool object's own. No Qt."""

from __future__ import annotations

from CNCStepper.machine.libraries.table_draft import Column
from CNCStepper.workbench.features.cut_values import CUT_VALUES
from CNCStepper.workbench.features.tool import Tool
from CNCStepper.workbench.services.translation import later, tr

LABELS = {
    **{entry.key: entry.label for entry in (*CUT_VALUES, *Tool.PROPERTIES)},
    "name": later("Name"),
    "key": later("Name in jobs"),
    "title": later("Title"),
    "source": later("Source"),
    "plunge_factor": later("Share of the feed straight down"),
    "stepdown": later("Depth per pass in diameters"),
    "stepover": later("Width per pass in diameters"),
    "carbide_speed_m_min": later("Carbide: surface speed"),
    "carbide_chip_load_mm": later("Carbide: feed a tooth"),
    "hss_speed_m_min": later("HSS: surface speed"),
    "hss_chip_load_mm": later("HSS: feed a tooth"),
    "turning_force_n_mm2": later("Turning: cutting force"),
    "turning_exponent": later("Turning: exponent"),
    "turning_elasticity_n_mm2": later("Turning: elasticity"),
    "material": later("Material"),
    "thickness_mm": later("Thickness"),
    "consumable": later("Consumable"),
    "kerf_by_feed": later("Kerf by feed"),
    "puddle_jump_height_percent": later("Puddle jump height"),
    "puddle_jump_delay_s": later("Puddle jump delay"),
    "lead_in_mm": later("Lead-in"),
    "passes": later("Passes"),
    "power": later("Power (S)"),
    "volts": later("Arc voltage"),
    "pressure_bar": later("Pressure"),
    "pause_at_end_s": later("Pause at the end"),
    "cut_mode": later("Cut mode"),
    "thc": later("Height control"),
    "blade_offset_mm": later("Blade offset"),
}
UNITS = {
    "_mm_min": "mm/min",
    "_m_min": "m/min",
    "_n_mm2": "N/mm²",
    "_mm": "mm",
    "_deg": "°",
    "_rpm": "rpm",
    "_s": "s",
    "_percent": "%",
    "_bar": "bar",
    "amperes": "A",
    "volts": "V",
}
ROWS_OF = {  # how a cell of several lists of numbers is written
    "carbide_speed_m_min": later("least and most: 180 500"),
    "hss_speed_m_min": later("least and most: 180 500"),
    "carbide_chip_load_mm": later("diameter, least and most: 5 0.03 0.07; 8 0.05 0.09"),
    "hss_chip_load_mm": later("diameter, least and most: 5 0.03 0.07; 8 0.05 0.09"),
    "kerf_by_feed": later("feed and kerf: 150 1.8; 300 1.2"),
}


def heading_of(column: Column) -> str:
    """Return the heading of a column: its label, below it the unit."""
    unit = next((unit for end, unit in UNITS.items() if column.key.endswith(end)), "")
    label = tr(LABELS[column.key])
    return f"{label}\n{unit}" if unit else label


def hint_of(column: Column) -> str:
    """Return how a column's cells are written, and its key in files."""
    hint = tr(ROWS_OF[column.key]) if column.key in ROWS_OF else ", ".join(column.choices)
    return f"{column.key}: {hint}" if hint else column.key
