(to: sbp-kept)
(A grid of pockets: variables stay)
G21 G90 G17
#<pitch> = 30
#<depth> = -3
#<_turn> = 1
#1 = 0
S12000 M3
G4 P2
G0 Z5
O<ring> sub
  #3 = [#3 + 0]
  G0 X[#1 + 5] Y#2
  G1 Z#3 F300
  G3 I-5 F1200 (once round)
  G0 Z5
O<ring> endsub
O100 while [#1 LT 3]
  #2 = 0
  O110 repeat [2]
    O<ring> call [#1 * #<pitch>] [#2 * #<pitch>] [#<depth>]
    O120 if [#2 EQ 0]
      (PRINT,first row at #<_turn>)
    O120 else
      G0 Z8
    O120 endif
    #2 = [#2 + 1]
  O110 endrepeat
  #1 = [#1 + 1]
O100 endwhile
M5
G0 X0 Y0
M2
