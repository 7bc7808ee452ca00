//! Random part files. They stay mostly on the table: a move that would leave it ends the run.

use crate::simulated::dice::Dice;

/// A file that programs call, with what they leave in its loop.
pub const SUB: &str = "SA\nM2,2,1\nM3,3,2,-.2\nCC,1,T,1,0,360,,1\nM2,1,3\nJZ,.3\n";

/// A value on the table, rarely beside it.
fn place(dice: &mut Dice) -> String {
    let (low, high) = if dice.in_percent(1) { (-3.0, 13.0) } else { (0.2, 9.5) };
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

/// Lines of which the first generation knows nothing: other frames, files within files, previews, axes beside
/// the others. What they change they change back, so that the rest stays on the table.
fn wider_line(dice: &mut Dice) -> String {
    let (x, y) = (place(dice), place(dice));
    let small = format!("{:.3}", dice.between(-0.15, 0.15));
    match dice.below(20) {
        0 => format!("SR\nM2,{small},.1\nM2,-{small},-.1\nSA").replace("--", ""),
        1 => format!("M2,{x},{y}\n&x0 = %(1)\nVA,&x0 + {small}\nMX,{x}\nVA,%(1) - {small}"),
        2 => format!("M2,4,4\nZ2\nM2,{small},1\nM2,0,0\nVA,4,4"),
        3 => format!("FP,sub.sbp,{:.2},1,1,2", dice.between(0.5, 1.5)),
        4 => format!("M2,{x},{y}\nM2,4,4\nFP,sub.sbp,1,1,1,1,2"),
        5 => "FP,sub.sbp,1,1,1,2,0,-.1".into(),
        6 => format!("SP\nM2,{x},{y}\nSO,2,1\nSM"),
        7 => "SO,1,1\nTR,9000".into(),
        8 => "SO,1,0".into(),
        9 => format!("VR,{:.2},{:.2},,,4", dice.between(0.5, 4.0), dice.between(0.5, 4.0)),
        10 => "M2,5,5\nCC,2,T,1,0,360,0,-.1,3,1".into(),
        11 => "M2,4,4\nCR,1.5,1,I,1,1,0,-.1,2,,1,1".into(),
        12 => "VD,,5\nMI,B,1,30\nM2,3,3".into(),
        13 => "VD,,5\nMI,B,1,0\nM2,4,3".into(),
        14 => format!("VD,,5\nM5,{x},{y},-.1,{small},20"),
        15 => "JH\nMH".into(),
        16 => format!("GOSUB Aside\nMX,{x}"),
        17 => format!("VZ,,.1\nMX,{x}\nVC,,,.5"),
        18 => "IF INP(1) = 0 THEN GOSUB Aside\nPAUSE UNTIL 12,0".into(),
        _ => format!("PAUSE .3\n&c = &b * 2\nJX,{x}\nMZ,-.1"),
    }
}

fn wider_word(dice: &mut Dice) -> String {
    let (x, y) = (place(dice), place(dice));
    match dice.below(10) {
        0 => "G91\nG1 X.2 Y.1 F60\nG1 X-.2 Y-.1\nG90".into(),
        1 => format!("G10 L2 P2 X.1 Y.1\nG55\nG1 X{x} F90\nG54"),
        2 => format!("G92 X{x}\nG92.1"),
        3 => format!("G81 X{x} Y{y} Z-.2 R.1 F50\nG80"),
        4 => format!("G83 X{x} Y{y} Z-.3 R.1 Q.1 F50\nG80"),
        5 => "M64 P2\nG4 P.2\nM65 P2".into(),
        6 => "M68 E1 Q40\nG4 P.1\nM68 E1 Q0".into(),
        7 => "M0".into(),
        8 => format!("#1 = [{x} / 2 + 1]\nG1 X#1 F80"),
        _ => "G18 G2 X5 Z.3 I.4 K0\nG17".replace("G18 G2", "G1 X5 F80\nG18 G2"),
    }
}

/// The program with lines of the second generation between its own.
pub fn wider(text: &str, gcode: bool, dice: &mut Dice) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let begins = |line: &String| line.starts_with("AGAIN:") || line.starts_with("M3 S");
    let ends = |line: &String| line.starts_with("&n=&n+1") || line == "M5";
    let from = lines.iter().position(begins).map_or(0, |at| at + 1);
    for _ in 0..=dice.below(4) {
        let to = lines.iter().position(ends).unwrap_or(from);
        let more = if gcode { wider_word(dice) } else { wider_line(dice) };
        lines.insert(from + dice.below(to - from + 1), more);
    }
    lines.join("\n") + "\n"
}
