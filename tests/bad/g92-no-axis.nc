G92
; expect missing-axis 1:1
