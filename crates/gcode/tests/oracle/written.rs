//! Programs by hand: what dice seldom throw.

use super::generate::SCALE;

/// Subjects of the programs, and their blocks; lengths in mm of a part.
pub const WRITTEN: [(&str, &str); 10] = [
    (
        "arcs in three planes",
        "G2 X10 Y0 I5 J0
         G3 X0 Y0 R5
         G2 X10 Y0 Z-5 I5 J0 P3
         G18 G2 X0 Z-5 I-5 K0
         G3 X10 Z-5 R5
         G19 G2 Y10 Z-5 J5 K0
         G3 Y0 Z-5 R5.5
         G17 G90.1 G2 X20 Y0 I15 J0
         G91.1 G2 X30 Y0 I5
         G18 G2 X30 Z-5 I2 K0 Y4 P2
         G17 G3 X30 Y4 I1 J0 P4
         G91 G3 X-2 R1
         G2 X2 R-1.5",
    ),
    (
        "offsets",
        "G10 L2 P1 X10 Y10 Z0
         G54 G0 X0 Y0
         G10 L20 P2 X5 Y5
         G55 G0 X0 Y0
         G59.3 G0 X2
         G54 G92 X3 Y3
         G0 X0 Y0
         G92.2
         G0 X0 Y0
         G92.3
         G0 X1
         G92.1
         G52 X5
         G0 X0
         G52 X0
         G10 L2 P1 R[30]
         G0 X10 Y0
         G1 X0 Y5
         G2 X10 Y5 I5 J0
         G10 L2 P1 R[0]
         G53 G0 Z5",
    ),
    (
        "reference points and tool lengths",
        "G0 X7 Y8 Z9
         G28.1
         G0 X1 Y2 Z3
         G30.1
         G0 X70
         G28 Z20
         G30 X10
         G28
         G43.1 Z2
         G0 Z0
         G43.1 X1 Y-1 Z-2
         G1 X0 Y0 Z0
         G43 H3
         G0 Z0
         G49
         G0 Z0
         G10 L1 P5 Z4
         G43 H5
         G0 Z1
         G10 L10 P5 Z6
         G43
         G0 Z2",
    ),
    (
        "canned cycles",
        "G0 Z10
         G98 G81 X1 Y1 Z-1 R2
         X2
         G99 G82 X3 Z-1 R2 P0.2
         G83 X4 Z-3 R2 Q1
         G73 X5 Z-3 R2 Q1
         G84 X6 Z-1 R2
         G85 X7 Z-1 R2
         G86 X8 Z-1 R2 P0.1
         G89 X9 Z-1 R2 P0.1
         G91 G81 X1 Z-3 R1 L3
         G80
         G90 G0 Z10
         G18 G81 X1 Z1 Y-5 R1
         G19 G81 Y1 Z2 X-5 R1
         G80 G17 G0 X0",
    ),
    (
        "canned cycles that keep words, planes and heights, G98 and G99 in turn",
        "G0 Z10
         G99 G81 X1 Y1 Z-1 R2
         X2
         R1 Y3
         Z-2 X4 L2
         G0 Z10
         G98 G81 X5 Z-2 R1
         G83 X6 Z-3 R2 Q1
         Q2 X7
         G99 X8
         G80 G0 Z10
         G91 G98 G73 X1 Z-3 R-2 Q1 L3
         X1 Z-4
         G80 G0 Z4
         G99 G82 X1 Z-3 R-1 P0.1
         G90 G80 G0 Z10
         G18 G0 Y12
         G98 G85 X1 Z1 Y-5 R1
         X3
         G99 Z4 L2
         G80 G0 Y12
         G91 G83 X1 Z1 Y-4 R-2 Q1.5 L2
         G90 G80 G19 G0 X12
         G98 G89 Y1 Z2 X-5 R1 P0.1
         G99 G81 Z3 X-6 R0
         Y4
         R-1 Y5
         G80 G17 G0 X0",
    ),
    (
        "compensation to either side, and off",
        "G0 X-20 Y-20
         G41.1 D6
         G1 X0 Y0
         Y40
         G2 X10 Y50 I10 J0
         G1 X40
         Y0
         X0
         G40
         G0 X-20 Y-20
         G42.1 D6
         G1 X0 Y0
         X40
         G3 X50 Y10 I0 J10
         G1 Y50
         X0
         Z-2
         Y0
         G40
         G0 X0 Y-10",
    ),
    (
        "subroutines, branches and loops",
        "#<_global> = 5
         #<local> = 3
         o100 sub
           #<inner> = [#1 + #2]
           o101 if [#<inner> GT 5]
             G1 X[#<inner> * #<_mm>]
             o100 return [#<inner> * 2]
           o101 elseif [#<inner> EQ 5]
             G1 X5.5
           o101 else
             G1 X1
           o101 endif
         o100 endsub [7]
         o100 call [1] [2]
         G1 Y[#<_value> * #<_mm>]
         o100 call [2] [3]
         o100 call [3] [4]
         G1 Y[#<_value> * #<_mm>] Z[EXISTS[#<local>] * #<_mm>]
         #3 = 0
         o110 while [#3 LT 5]
           #3 = [#3 + 1]
           o111 if [#3 EQ 2]
             o110 continue
           o111 endif
           G1 X[#3 * #<_mm>]
         o110 endwhile
         o120 do
           #3 = [#3 - 1]
           G1 Z[0 - #3 * #<_mm>]
         o120 while [#3 GT 0]
         o130 repeat [2]
           G91 G1 X1
         o130 endrepeat
         G90",
    ),
    (
        "expressions and parameters",
        "#5 = [SIN[30] + COS[60] + TAN[45] + ASIN[1] + ACOS[0] + ATAN[1]/[1] + ABS[-1] + EXP[0]]
         #6 = [LN[1] + SQRT[4] + ROUND[1.5] + FIX[-1.5] + FUP[1.2] + 2**3**2 + 7 MOD 4 - 2 * 3 / 4]
         G1 X[#5 * #<_mm>] Y[#6 * #<_mm>]
         #7 = 5
         ##7 = 9
         G1 Z[#5 * #<_mm>]
         #8 = [[1 AND 0] + [1 OR 0] * 2 + [1 XOR 1] * 4 + [3 GE 3] * 8 + [3 NE 3] * 16]
         G1 X[#8 * #<_mm>]
         #8 = 1 #9 = #8
         G1 Y[#9 * #<_mm>]
         G1 X[#5421] Y[#5420] Z[#<_z> + #<_x>]
         G1 X-[#8] Y+#8 Z-#8",
    ),
    (
        "inverse time, units a turn and exact paths",
        "G93 G1 X10 F2
         X20 Y2 F4
         G94 F600 X30
         G95 S1000 M3 F0.1 X40
         G94 F600 M5
         G61
         G1 X10
         G61.1 Y10
         G64 P0.1 Q0.05 X30
         G4 P0.1
         G20 G1 Y1
         G21 Y30
         M48
         M49
         M50 P1
         M51 P1
         M53 P1
         M62 P0
         M64 P1
         M68 E0 Q0
         M70
         G91 G1 X1
         M72
         G1 X3",
    ),
    (
        "probing",
        "G38.2 Z-10
         G0 Z[#5063 + 5 * #<_mm>]
         G38.3 X3
         G0 X1 Z5
         G38.4 Z6
         G1 X2 Z0",
    ),
];

/// A program, so much larger than a part that four decimals tell a millionth of a millimetre.
pub fn whole(blocks: &str) -> String {
    let mut text = format!("G21 G90 G94 G17 F600 S100 M3\n#<_mm> = {SCALE}\nG0 X0 Y0 Z0\n");
    for line in blocks.lines() {
        text += &scaled(line.trim());
        text.push('\n');
    }
    text + "M2\n"
}

/// Numbers directly behind the letter of a length, made larger.
fn scaled(line: &str) -> String {
    let mut out = String::new();
    let mut rest = line;
    let is_length = !line.starts_with(['#', 'o']);
    while let Some(letter) = rest.chars().next() {
        out.push(letter);
        rest = &rest[1..];
        let is_number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | '+');
        let number = &rest[..rest.find(|c| !is_number(c)).unwrap_or(rest.len())];
        if let (true, true, Ok(value)) =
            (is_length, "XYZIJKRQD".contains(letter), number.parse::<f64>())
        {
            out += &(value * SCALE).to_string();
            rest = &rest[number.len()..];
        }
    }
    out
}
