(to: sbp grbl)
(A grid of holes: O-words, parameters, a canned cycle.)
G20 G90
#<pitch> = 0.5
F20 S10000 M3
G0 Z0.25
#1 = 0
O100 while [#1 LT 2]
  #2 = 0
  O110 repeat [2]
    G81 X[#1 * #<pitch>] Y[#2 * #<pitch>] Z-0.125 R0.1
    #2 = [#2 + 1]
  O110 endrepeat
  #1 = [#1 + 1]
O100 endwhile
G80
G92 X0 Y0
G0 X1
G53 G0 Z0
M5
M2
