# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs in which the state matters where they are restarted: (dialect, text) by what is in them."""

HEAD = "G21 G90 G17\nT1\nM3 S12000\nG4 P3\nG0 Z10\n"
END = "G0 Z10\nM5\nM2\n"

PROGRAMS = {
    "g92": (
        "grbl",
        HEAD + "G0 X5 Y5\nG1 Z-1 F200\nX40 F800\nG0 Z10\nG92 X0 Y0\nG0 X10 Y10\nG1 Z-1 F200\nX30 F700\nY20\n"
        "G92 Z0\nG1 X35\nZ-1\nY25\nG0 Z10\nG92.1\nG0 X0 Y0\nG1 Z-1 F200\nX-10\n" + END,
    ),
    "work systems": (
        "grbl",
        HEAD
        + "G0 X0 Y0\nG1 Z-1 F200\nX10 F800\nG0 Z10\nG55\nG0 X0 Y0\nG1 Z-1 F200\nX10 F800\nG10 L2 P2 X-70 Y-40 Z-20\n"
        "G1 Y10\nG59 X15\nG0 Z10\nG0 X0 Y0\nG1 Z-1 F200\nX10 F800\n" + END,
    ),
    "incremental": (
        "grbl",
        HEAD
        + "G0 X0 Y0\nG1 Z-1 F200\nG91\nX10 F800\nG2 X10 Y10 I10 J0\nG3 X5 Y5 R5\nG1 Y10\nG0 Z11\nX10\nG1 Z-11 F150\n"
        "X10\nY-10\nG90\nX0 Y0\n" + END,
    ),
    "inches": (
        "grbl",
        "G20 G90 G17\nT1\nM3 S12000\nG0 Z.4\nG0 X0 Y0\nG1 Z-.04 F8\nX1 F30\n"
        "G2 X1.5 Y.5 I0 J.5\nX2 Y1 I.5\nG21\nG1 X60 Y30 F700\n"
        "G20\nX1\n" + END.replace("Z10", "Z.4"),
    ),
    "planes": (
        "grbl",
        HEAD
        + "G0 X0 Y0\nG1 Z-1 F200\nG18\nG2 X10 Z-1 I5 K0 F500\nG1 X20\nG19 G3 Y10 Z-1 J5 K0\nG17 G1 X30\nG93\nX40 F2\n"
        "X50 F3\nG94 X60 F300\n" + END,
    ),
    "speeds and coolant": (
        "grbl",
        HEAD
        + "M8\nG0 X0 Y0\nG1 Z-1 F200\nX10 F800\nS9000 X20\nM9\nM5\nG4 P1\nM4 S5000\nG4 P2\nX30\nM7\nX40 F400 M0\nX50\n"
        + END,
    ),
    "laser": (
        "grbl",
        "G21 G90\nG0 X0 Y0\nM4 S500\nG1 X10 F1500\nY10\nS200\nX0\nG0 X20\nG1 Y0\nM5\n"
        "G0 X40 Y0\nM4 S800\nG3 X40 Y0 I5 J0\nM5\nM2\n",
    ),
    "tool lengths": (
        "grbl",
        HEAD + "G43.1 Z30\nG0 Z10\nG0 X0 Y0\nG1 Z-1 F200\nX10 F800\nG0 Z10\nM5\nM0\nT2\n"
        "G43.1 Z42.5\nM3 S8000\nG4 P3\nG0 Z10\n"
        "G0 X0 Y5\nG1 Z-1 F200\nX10 F800\nG49\nG1 X20\n" + END,
    ),
    "tool changes by M6": (
        "grblhal",
        "G21 G90 G17\nT1 M6\nM3 S9000\nG0 Z10\nG0 X0 Y0\nG1 Z-1 F200\nX10 F800\nT2\nX20\n"
        "G0 Z10\nM6\nM3 S8000\nG0 X0 Y5\nG1 Z-2 F200\n"
        "X10\n" + END,
    ),
    "subprograms": (
        "grblhal",
        "o100 sub\nG91\nG1 X10 F#1\nY5\nX-10\nG90\no100 endsub\n"
        + HEAD
        + "G0 X0 Y0\n#2=-1\no1 repeat [3]\nG1 Z#2 F200\n"
        "o100 call [500]\nG0 Z10\nX[5*#2] Y0\n#2=[#2-1]\no1 endrepeat\nG1 X50 F300\n" + END,
    ),
    "canned cycles": (
        "linuxcnc",
        HEAD + "G0 X0 Y0\nG98 G81 X10 Y0 Z-3 R2 F100\nX20\nX30 Z-4\nG99 G83 X40 Y5 Z-6 R2 Q2\nX50\nX60\nG80\nG0 Z10\n"
        "G91 G81 X5 Y5 Z-8 R-8 L3\nX5\nX5\nG80\nG90 G0 X0 Y0\nG82 X5 Z-2 R1 P0.5\nG1 Z-1 F100\nX20\n" + END,
    ),
    "radius compensation": (
        "linuxcnc",
        HEAD + "G0 X0 Y0\nG1 Z-1 F200\nX5 F500\nG41.1 D4\nG1 X20 Y10\nX40\nG3 X50 Y20 I0 J10\n"
        "G1 Y40\nG40 X60\nX70\nG0 Z10\nX0 Y0\n"
        "G1 Z-2\nX10\n" + END,
    ),
    "outputs and corners": (
        "linuxcnc",
        HEAD
        + "G64 P0.02\nM64 P1\nM68 E0 Q2.5\nG0 X0 Y0\nG1 Z-1 F200\nX10 F800\nM65 P1\nX20\nG61\nM49\nX30\nM48\nX40\n"
        + END,
    ),
    "machine coordinates": (
        "grbl",
        HEAD
        + "G0 X0 Y0\nG1 Z-1 F200\nX10 F800\nG53 G0 Z-5\nG0 X30\nZ5\nG1 Z-1\nY10\nG28.1\nG0 Z10\nX50\nG1 Z-1\nX60\n"
        + END,
    ),
    "a line that is skipped, numbers and marks": (
        "grbl",
        "%\nN10 G21 G90\nN20 T1 M3 S9000\nN30 G0 Z10\nN40 X0 Y0 (here)\nN50 G1 Z-1 F200\n"
        "/N55 X99\nN60 X10 F800\n(turn)\n"
        "N70 Y10\nN80 X0\nN90 G0 Z10\nN100 M30\n%\n",
    ),
}
