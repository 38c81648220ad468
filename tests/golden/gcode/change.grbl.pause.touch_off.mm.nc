(Peca no 1)
G21 G17 G90 G91.1
G40 G49 G94
G54
(tool 1: flat 6 mm)
T1
M3 S10000
G4 P3
G0 Z10.000
(begin operation: peca no 1 [o.])
X0.000 Y0.000
Z2.000
G1 Z-1.000 F200
X10.000 F800
G3 X0.000 Y0.000 Z-2.000 I-5.000 J0.000
G2 X0.000 Y0.000 I5.000 J0.000
G2 X0.000 Y0.000 Z-2.667 I5.000 J0.000
G2 X0.000 Y0.000 Z-3.333 I5.000 J0.000
G2 X0.000 Y0.000 Z-4.000 I5.000 J0.000
G0 Z10.000
(finish operation: peca no 1 [o.])
M5
(MSG, change to tool 2: ball 2 mm, then set the Z zero with it)
M0
(tool 2: ball 2 mm)
T2
M3 S8000
G4 P3
G0 Z10.000
(begin operation: engrave)
X20.000 Y0.000
G1 Z-1.000 F100
G2 X20.000 Y10.000 I0.000 J5.000 F300
G19
G2 Y20.000 Z-1.000 J5.000 K0.000
G0 Z10.000
(finish operation: engrave)
M5
M9
M2
