# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs whose way back is hard to tell: passes on top of each other, links, arcs, helices."""

BEGIN = "G21 G90\nG0 Z-2\nG0 X-5 Y-5\nM3 S8000\nG1 Z-5 F600\n"
ONE_PASS = "G1 X-9 F1200\nG2 X-10 Y-6 I0 J-1\nG1 Y-9\nG1 X-5\nG1 Y-5\n"
THRICE = BEGIN + 3 * ONE_PASS + "G0 Z-2\nM5\nM2\n"
PROGRAMS = {
    "contour cut three times": THRICE,
    "links of a pocket": BEGIN
    + "".join(
        f"G1 Z{z} F400\nG1 X-9 F1500\nG3 X-9 Y-5.5 J-.25 I0\nG1 X-6\nG2 X-6 Y-6 J-.25 I0\nG1 X-9\nG1 X-9 Y-8\nG1 X-5\n"
        "G1 X-5 Y-5 F2000\n"
        for z in (-5.5, -6.0, -6.5)
    )
    + "G0 Z-2\nM5\nM2\n",
    "arcs in all planes": "G21 G90\nG92 X1 Y2 Z3\nG43.1 Z1.5\n"
    + BEGIN
    + "G17 G2 X-5 Y-5 I-2 J0 F900\nX-5 I-2 J0\nX-5 I-2 J0\nG18 G3 X-9 Z-5 I-2 K0\nG19 G2 Y-9 Z-5 J-2 K0\n"
    + "G17 G91 G1 X1 F800\nG20 G1 X.05 Y-.04 F40\nG3 X.04 Y.04 I0 J.04\nG21 X-1 Y-.5 I-.5 J-.25\nG90 G1 X-6 Y-6 F1200\n"
    + "G0 Z-2\nM5\nM2\n",
    "helix": BEGIN
    + "G2 X-5 Y-5 I-1.5 Z-5.5 F700\nX-5 I-1.5 Z-6\nX-5 I-1.5 Z-6.5\nX-5 I-1.5\nG3 X-8 I-1.5 Z-5\nX-5 I1.5 Z-6\n"
    + "G1 Z-7 F300\nG2 X-5 I-1.5 F900\nX-5 I-1.5\nG0 Z-2\nM5\nM2\n",
}
