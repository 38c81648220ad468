# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words of a machine's page: of its rows and choices, where a profile has keys; no Qt."""

from __future__ import annotations

from CNCStepper.workbench.machines.declaration import Path, Row
from CNCStepper.workbench.services.choice_labels import english_words_of
from CNCStepper.workbench.services.translation import later, tr

LABELS = {  # by key, or by table and key where the same key is two things
    "name": later("Name"),
    "controller": later("Controller"),
    "processes": later("Processes"),
    "feed_mm_min": later("Feed without F"),
    "rapid_mm_min": later("Rapid speed"),
    "tool_change": later("Tool change"),
    "tool_length": later("Tool length"),
    "retreat.outputs": later("Outputs during a retract"),
    "interpolation": later("Interpolation"),
    "junction_deviation_mm": later("Junction deviation"),
    "arc_tolerance_mm": later("Arc tolerance"),
    "look_ahead_blocks": later("Look-ahead"),
    "ramp": later("Ramp"),
    "table_ms": later("Step times"),
    "first_ms": later("First wait"),
    "change_ms": later("Change of wait"),
    "least_ms": later("Least wait"),
    "acceleration_steps_s2": later("Acceleration in steps"),
    "steps": later("Steps of the ramp"),
    "pull_in_ms": later("Start/stop wait"),
    "steps_per_mm": later("Steps per mm"),
    "max_rate_mm_min": later("Highest speed"),
    "acceleration_mm_s2": later("Acceleration"),
    "jerk_mm_s3": later("Jerk"),
    "backlash_mm": later("Backlash"),
    "travel_min_mm": later("Travel from"),
    "travel_max_mm": later("Travel to"),
    "homing": later("Homing switch"),
    "travel_per_turn_mm": later("Travel per turn"),
    "torque": later("Torque at speed"),
    "mass_kg": later("Moved mass"),
    "inertia_kg_m2": later("Inertia"),
    "force_n": later("Force"),
    "efficiency": later("Efficiency"),
    "steps_per_turn": later("Motor's steps"),
    "microsteps": later("Microsteps"),
    "gear_ratio": later("Gear ratio"),
    "screw_pitch_mm": later("Screw's pitch"),
    "belt_pitch_mm": later("Belt's pitch"),
    "pulley_teeth": later("Pulley's teeth"),
    "encoder_pulses_per_turn": later("Encoder's pulses"),
    "encoder_gear_ratio": later("Encoder's gear"),
    "currency": later("Currency"),
    "per_hour": later("Price per hour"),
    "per_metre": later("Price per metre cut"),
    "per_pierce": later("Price per pierce"),
    "per_sheet": later("Price per sheet"),
    "per_square_metre": later("Price per m² of material"),
    "min_rpm": later("Lowest speed"),
    "max_rpm": later("Highest spindle speed"),
    "preset_rpm": later("Preset speeds"),
    "spin_up_s": later("Spin-up time"),
    "power_w": later("Motor's power"),
    "spindle.laser": later("Laser (M4 with power)"),
    "coolant": later("Coolant"),
    "pulse_us": later("Pulse width"),
    "gap_us": later("Pause between pulses"),
    "direction_setup_us": later("Direction before step"),
    "enable_lead_us": later("Enable before step"),
    "motors": later("Motors"),
    "interval_ms": later("Interval of pulses"),
    "null_motor": later("Motor of a null pulse"),
    "ahead_s": later("Sent ahead at most"),
    "ahead_bytes": later("Bytes ahead at most"),
    "slower": later("Slower than published"),
    "base": later("Port's address"),
    "pin": later("Pin"),
    "act": later("Does"),
    "port": later("Port"),
    "level": later("Level"),
    "debounce_ms": later("Debounce"),
    "line": later("Line"),
    "release_line": later("Line at release"),
    "back_mm": later("Goes back by"),
    "device": later("Device"),
}
HINTS = {
    "preset_rpm": later("The speeds that a gear or a switch has, rising; none where any speed can be set"),
    "null_motor": later("For a board that receives bytes: 0 to 3, or unused for a motor without an axis"),
    "slower": later("By which share the lathe may be slower than its published step times"),
    "controller": later("Its language and its link: grbl, grblhal, fluidnc, linuxcnc, thesis-a …"),
    "feed_mm_min": later("The feed of a program without F, and the cutting speed of a language without F"),
    "rapid_mm_min": later("The speed of rapids, where the language leaves it to the machine"),
    "torque": later("Points of the pull-out curve, rpm and Nm: 0 1.2; 300 1.0"),
    "motors": later("The axis of each motor in order; -y is mounted the other way round: x y -y z"),
    "table_ms": later("The waits between steps from rest, in ms, none longer than the one before it"),
    "travel_min_mm": later("In machine coordinates"),
    "travel_max_mm": later("In machine coordinates"),
    "steps_per_mm": later("Left out, it follows from the drive"),
    "backlash_mm": later("Travel of the motor at a reversal before the axis moves"),
    "name": later("As people call the machine"),
}
CHOICES = {
    "tool_change.pause": later("pause, by hand"),
    "tool_change.split": later("a file for each tool"),
    "tool_change.m6": later("M6, by the machine"),
    "tool_length.touch_off": later("zero set with each tool"),
    "tool_length.table": later("offsets from a table"),
    "tool_length.none": later("all stand out equally"),
    "interpolation.planner": later("our planner"),
    "interpolation.dda": later("digital differential analyser"),
    "interpolation.published": later("as the thesis published it"),
    "ramp.trapezoid": later("constant acceleration"),
    "ramp.s_curve": later("S-curve"),
    "ramp.table": later("table of step times"),
    "homing.min": later("at the lower end"),
    "homing.max": later("at the upper end"),
    "homing.none": later("no switch"),
    "outputs.keep": later("stay on"),
    "outputs.off": later("off"),
    "act.start": later("start"),
    "act.pause": later("pause"),
    "act.back": later("back along the cut"),
    "act.stop": later("stop"),
    "act.flood": later("flood on/off"),
    "act.mist": later("mist on/off"),
    "act.spindle_stop": later("spindle stop"),
    "act.limit": later("limit switch"),
    "act.door": later("safety door"),
    "act.switch": later("switch by lines"),
    "level.high": later("on when pressed"),
    "level.low": later("off when pressed"),
    "device.spindle_cw": later("spindle, torch or beam (M3)"),
    "device.spindle_ccw": later("spindle reversed (M4)"),
    "device.mist": later("mist (M7)"),
    "device.flood": later("flood (M8)"),
    "device.output_0": later("output 0 (M64 P0)"),
    "device.output_1": later("output 1 (M64 P1)"),
    "device.output_2": later("output 2 (M64 P2)"),
    "device.output_3": later("output 3 (M64 P3)"),
}
SIGNAL_PARTS = {
    "step": later("{0} step"),
    "direction": later("{0} direction"),
    "enable": later("drives enabled"),
}
GROUPS = {
    "drive": later("Drive (steps per mm follow from it)"),
    "motor": later("Motor (its torque is checked)"),
    "waits": later("Step times"),
    "link": later("The mini-lathe's link"),
}


def label_of(path: Path) -> str:
    """Return the label of a row; of a key that has none the key itself, in words."""
    label = english_label_of(path)
    return tr(label) if label else path[-1].replace("_", " ")


def english_label_of(path: Path) -> str:
    """Return the English label of a row, "" for a key that has none."""
    return LABELS.get(".".join(path[-2:]), LABELS.get(path[-1], ""))


def label_with_unit(row: Row) -> str:
    """Return the label of a row with the unit of its value."""
    return f"{label_of(row.path)} ({row.unit})" if row.unit else label_of(row.path)


def hint_of(path: Path) -> str:
    """Return what is to be said of a row: a sentence, and the key of the profile."""
    hint = HINTS.get(path[-1], "")
    key = ".".join(path)
    return f"{tr(hint)}\n{key}" if hint else key


def choice_label(path: Path, choice: str) -> str:
    """Return the words of a choice."""
    words = english_choice_label(path, choice)
    return tr(words) if words else choice


def english_choice_label(path: Path, choice: str) -> str:
    """Return the English words of a choice, "" for one that is its own label."""
    return CHOICES.get(f"{path[-1]}.{choice}") or english_words_of(choice, path[-1])


def signal_label(name: str) -> str:
    """Return the words of a signal: "X step", "drives enabled"."""
    motor, _, what = name.rpartition("_")
    if what in SIGNAL_PARTS and (motor or what == "enable"):
        return tr(SIGNAL_PARTS[what]).format(motor.upper())
    return choice_label(("device",), name)
