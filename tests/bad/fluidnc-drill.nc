G81 X1 Y1 Z-1 R1 F100
; expect refused-code 1:1 fluidnc | FluidNC does not accept G81 (value G81); FluidNC has no canned cycles: write the holes as plain moves; FluidNC answers error:20
