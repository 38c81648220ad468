N10 G91.1
; expect refused-code 1:5 iso | ISO 6983 does not accept G91.1 (value G91.1); I, J and K are given from the start point of the arc
