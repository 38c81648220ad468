g0 x#<_hal[pin]>
m2
; expect unknown-parameter 1:5 linuxcnc | the pins of the machine are not known to this reader (value #<_HAL[PIN]>); write the value itself
