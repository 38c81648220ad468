G21 G90 G0 X0 Y0 Z0 F100
G41.1 D4
G1 X10
G1 X11
G1 Y10
G1 X5
M2
; expect gouge 5:4 linuxcnc | the line in the concave corner cannot be reached by the tool without gouging (value Y10); use a smaller tool, or another contour
