//! G-code: words of control within each other, subprograms, cycles, turns of arcs.

use super::Dice;

const LINES: &[&str] = &[
    "G0 X# Y#",
    "G1 X# Y# Z# F100",
    "G2 X# Y# I# J# P@",
    "G3 X# Y# R#",
    "G2 X0 Y0 I# J0 Z# P@",
    "G81 X# Y# Z# R# L@ F50",
    "G83 X# Y# Z# R# Q# L@ F50",
    "G73 X# Z# R# Q#",
    "G80",
    "G90",
    "G91",
    "G20",
    "G21",
    "G17",
    "G18",
    "G19",
    "G4 P#",
    "M98 P100 L@",
    "#1=[#1+1]",
    "G1 X#1",
    "G41 D#",
    "G42 D1",
    "G40",
    "G92 X#",
    "G68 X0 Y0 R#",
    "G51 X0 Y0 Z0 P#",
    "M3 S#",
    "M5",
    "M8",
    "M6 T1",
    "G1 X1,5",
    "G33 Z# K#",
    "(MSG, x)",
    "G52 X#",
    "G10 L2 P1 X#",
    "G16",
    "G15",
    "M99",
    "G28 Z#",
    "G5.1 X# Y# I# J#",
    "G64 P#",
    "G93",
    "G94",
    "G76 P# Z# I# J# R# K# Q# H# E# L@",
];

pub fn program(dice: &mut Dice) -> String {
    let mut text = String::from("G21 G90 G17\n#1=0\n");
    block(dice, &mut text, 0, &mut 200);
    text += dice.one(&["M2\n", "M30\n", "M99\n", ""]);
    text + "O100\n" + &lines(dice) + "M99\n"
}

fn block(dice: &mut Dice, text: &mut String, depth: u32, words: &mut u32) {
    *words += 1;
    let word = *words;
    let (begin, end) = match dice.below(4) {
        0 => (format!("o{word} while [1]"), format!("o{word} endwhile")),
        1 => (format!("o{word} do"), format!("o{word} while [#1 LT {}]", dice.filled("@"))),
        2 => (format!("o{word} if [#1 LT {}]", dice.filled("@")), format!("o{word} endif")),
        _ => (format!("o{word} repeat [{}]", dice.filled("@")), format!("o{word} endrepeat")),
    };
    *text += &(begin + "\n");
    *text += &lines(dice);
    if depth < 3 && dice.below(3) > 0 {
        block(dice, text, depth + 1, words);
    }
    *text += &lines(dice);
    *text += &(end + "\n");
}

fn lines(dice: &mut Dice) -> String {
    (0..dice.below(4))
        .map(|_| {
            let form = dice.one(LINES);
            if form.contains("#1") { form.to_owned() + "\n" } else { dice.filled(form) + "\n" }
        })
        .collect()
}
