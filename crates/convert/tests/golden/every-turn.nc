(to: sbp linuxcnc grbl)
(Arcs, a helix of three turns, arcs in another plane, inverse time.)
G21 G90 G94 G17
M3 S12000
G4 P1.5
G0 X0 Y0 Z5
G1 Z-1 F300 (plunge)
F1200
G2 X20 Y0 I10 J0
G3 X20 Y0 I-10 J0
G3 X20 Y0 Z-4 I-5 J0 P3 (thread)
G1 X0 Z-1
G18 G2 X10 Z-1 I5 K0
G17
G93 G1 X20 F2
G94
M7 M8
G1 X30 F50
M9
G64 P0.05
M0 (turn the part)
T5 M6
G0 Z5
X0 Y0
(MSG,done)
M5
M30
