%
(Two rows of holes and a slot with round ends, inches)
(T1: 1/4 in end mill)
G20 G90 G17 G94
G54
T1 M6
M3 S16000
G0 Z0.5

(Toolpath: holes)
#<rows> = 2
#<row> = 0
O100 while [#<row> LT #<rows>]
  G99 G83 X1 Y[1+#<row>] Z-0.4 R0.1 Q0.15 F30
  X2
  X3
  X4
  G80
  #<row> = [#<row>+1]
O100 endwhile

(Toolpath: slot)
G0 Z0.5
G0 X1 Y3.25
O200 sub
  G1 Z[0-#1] F20
  G1 X4 F60
  G3 X4 Y3.75 J0.25
  G1 X1
  G3 X1 Y3.25 J-0.25
O200 endsub
O200 call [0.125]
O200 call [0.25]
G0 Z0.5

M5
(PRINT,%d#<rows> rows of 4 holes and a slot are cut)
G0 X0 Y0
M30
%
