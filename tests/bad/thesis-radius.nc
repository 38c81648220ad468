G0 X0 Y0
G2 X1 Y1 R1
; expect unknown-word 2:10 thesis-a | thesis A has no word R (value R1, limit F, I, J, K, N, X, Y, Z); give the arc's centre with I and J
