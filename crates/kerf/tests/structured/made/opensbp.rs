//! OpenSBP: loops by labels, subroutines, files within files, cuts in many passes.

use super::Dice;

const LINES: &[&str] = &[
    "MX,#",
    "M3,#,#,#",
    "J2,#,#",
    "MZ,#",
    "CC,#,O,1,0,360,#,@",
    "CC,#,I,1,0,360,#,@,1,1",
    "CP,#,#,#,T,1,0,360,#,@",
    "CR,#,#,O,1,1,#,@",
    "CR,#,#,I,1,1,#,@,1",
    "CG,,#,#,#,#,T,1,#,@",
    "CA,#,#,T,1",
    "VC,#",
    "VS,#,#",
    "VL,0,#,0,#",
    "VU,#",
    "SF,1",
    "SA",
    "SR",
    "PAUSE .1",
    "SO,1,1",
    "SO,1,0",
    "&a=&a+1",
    "&a=&a*2",
    "&b=\"x\" & &b & &b",
    "PRINT &b",
    "MX,&a",
    "C6",
    "'TOOLPATH NAME = &a",
    "VR,#,#",
    "FP,b.sbp,#,#,#,@",
    "FP,a.sbp",
    "GOSUB Sub",
    "OPEN \"o\" FOR OUTPUT AS #1",
    "WRITE #1; &b",
    "CLOSE #1",
    "ON INPUT(1,1) GOTO Sub",
    "SP",
    "VD,,#",
    "MD,#,#",
];

pub fn program(dice: &mut Dice) -> String {
    let mut text = String::from("&a=1\n&b=\"x\"\n");
    block(dice, &mut text, 0, &mut 0);
    text + "END\nSub:\n" + &lines(dice) + "RETURN\n"
}

/// Lines within a loop of so many turns, and loops within it.
fn block(dice: &mut Dice, text: &mut String, depth: u32, labels: &mut u32) {
    *labels += 1;
    let label = format!("L{labels}");
    let turns = dice.filled("@");
    *text += &format!("&n{label}=0\n{label}:\n");
    *text += &lines(dice);
    if depth < 3 && dice.below(3) > 0 {
        block(dice, text, depth + 1, labels);
    }
    *text += &lines(dice);
    *text += &match dice.below(4) {
        0 => format!("GOTO {label}\n"),
        _ => format!("&n{label}=&n{label}+1\nIF &n{label} < {turns} THEN GOTO {label}\n"),
    };
}

fn lines(dice: &mut Dice) -> String {
    (0..dice.below(4))
        .map(|_| {
            let form = dice.one(LINES);
            dice.filled_numbered(form) + "\n"
        })
        .collect()
}

impl Dice {
    /// As [`Dice::filled`], for forms that have file numbers.
    fn filled_numbered(&mut self, form: &str) -> String {
        if form.contains("#1") { form.into() } else { self.filled(form) }
    }
}
