N1 G0 X1*5
; expect checksum 1:9 marlin | the checksum is wrong (value *5); it should be *97
