//! Random part files. They stay mostly on the table: a move that would leave it ends the run.

use crate::dice::Dice;

/// A file that programs call, with what they leave in its loop.
pub const SUB: &str = "SA\nM2,2,1\nM3,3,2,-.2\nCC,1,T,1,0,360,,1\nM2,1,3\nJZ,.3\n";

/// A value on the table, rarely beside it.
fn place(dice: &mut Dice) -> String {
    let (low, high) = if dice.happens(1) { (-3.0, 13.0) } else { (0.2, 9.5) };
    format!("{:.3}", dice.between(low, high))
}

fn line(dice: &mut Dice) -> String {
    let (x, y) = (place(dice), place(dice));
    let z = format!("{:.3}", dice.between(-0.5, 0.4));
    let speed = format!("{:.2}", dice.between(0.2, 6.0));
    match dice.below(26) {
        0..=5 => format!("M2,{x},{y}"),
        6..=8 => format!("M3,{x},{y},{z}"),
        9 => format!("MX,{x}"),
        10 => format!("MZ,{z}"),
        11 => format!("JZ,{z}\nJ2,{x},{y}"),
        12 => format!("J3,{x},{y},{z}"),
        13 => format!("M2,5,5\nCC,{:.2},T,{},0,{}", dice.between(0.2, 3.0), dice.of(&[1, -1]), 360),
        14 => format!("M2,5,5\nCG,,6,{:.3},.5,0,T,{}", dice.between(4.0, 6.0), dice.of(&[1, -1])),
        15 => "M2,4,4\nCR,2,1.5,T,1,1".into(),
        16 => format!("VS,{speed},{speed},,,{speed},{speed}"),
        17 => format!("MS,{speed},{speed}"),
        18 => format!("SO,{},{}", dice.of(&[2, 3, 5]), dice.of(&[0, 1])),
        19 => format!("PAUSE {}", dice.of(&[".2", "1"])),
        20 => "FP,sub.sbp".into(),
        21 => "&b = &b + 1\nPRINT &b, %(1)".into(),
        22 => "INPUT \"how much\" &c\nM2,&c,&c".into(),
        23 => "MSGBOX(Go on?,YesNo,Ask)".into(),
        24 => "SetUsrVal, &b\n$kept = &b".into(),
        _ => "OPEN \"o.txt\" FOR APPEND AS #1\nWRITE #1; &b\nCLOSE #1".into(),
    }
}

/// An OpenSBP program: lines, a loop, sometimes a handler.
pub fn sbp(dice: &mut Dice) -> String {
    let handler = match dice.below(6) {
        0 => "ON INPUT(1,1) GOTO Done\n",
        1 => "ON INPUT(2,1) GOSUB Aside\n",
        _ => "",
    };
    let lines = 3 + dice.below(12);
    let body: Vec<String> = (0..lines).map(|_| line(dice)).collect();
    let turns = dice.of(&[0, 0, 0, 2]);
    format!(
        "SA\n&n=0\n&b=0\n{handler}JZ,.3\nAGAIN:\n{}\n&n=&n+1\nIF &n < {turns} THEN GOTO AGAIN\n\
         Done:\nJZ,.3\nJ2,0,0\nEND\nAside:\nJZ,.4\nRETURN\n",
        body.join("\n")
    )
}

/// A G-code program.
pub fn gcode(dice: &mut Dice) -> String {
    let mut text = String::from("G20 G90 G17\nG0 Z.3\nM3 S9000\n");
    for _ in 0..3 + dice.below(15) {
        let (x, y) = (place(dice), place(dice));
        let z = format!("{:.3}", dice.between(-0.5, 0.4));
        let feed = dice.between(10.0, 200.0);
        text += &match dice.below(9) {
            0..=3 => format!("G1 X{x} Y{y} F{feed}\n"),
            4 => format!("G1 Z{z} F{feed}\n"),
            5 => format!("G0 Z.3\nG0 X{x} Y{y}\n"),
            6 => format!("G1 X5 Y5 F{feed}\nG{} X6 Y5 I.5 J0\n", dice.of(&[2, 3])),
            7 => format!("G4 P{}\n", dice.of(&["0.2", "1"])),
            _ => format!("G1 X{x} Y{y} Z{z} F{feed}\n"),
        };
    }
    text + "G0 Z.3\nM5\nM30\n"
}
