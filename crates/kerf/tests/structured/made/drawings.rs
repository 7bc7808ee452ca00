//! Drawings: blocks in blocks, `use` in `use`, plotters, operations that copy.

use super::Dice;

const ENTITIES: &[&str] = &[
    "0 LINE/10 #/20 #/11 #/21 #/31 #",
    "0 CIRCLE/10 #/20 #/40 #",
    "0 ARC/10 #/20 #/40 #/50 #/51 #",
    "0 POINT/10 #/20 #",
    "0 ELLIPSE/10 #/20 #/11 #/21 #/40 .001/41 0/42 6",
    "0 TEXT/1 x/10 #/20 #",
    "0 LWPOLYLINE/70 1/10 #/20 #/42 #/10 #/20 #/42 1/10 #/20 #",
    "0 SPLINE/71 3/40 0/40 0/40 0/40 0/40 1/40 1/40 1/40 1/10 #/20 #/10 #/20 #/10 #/20 #/10 #/20 #",
    "0 SPLINE/71 @/11 #/21 #/11 #/21 #/11 #/21 #",
    "0 CIRCLE/10 #/20 #/40 #/210 #/220 #/230 1",
];

const INSERT: &str = "0 INSERT/2 bBLOCK/10 #/20 #/41 #/42 1/50 #/70 @/71 @/44 #/45 #";

pub fn dxf(dice: &mut Dice) -> String {
    let count = 1 + dice.below(8);
    let blocks: String = (0..count).map(|n| block(dice, n)).collect();
    let entities: String = (0..=dice.below(6)).map(|_| entity(dice, count)).collect();
    let pairs = format!(
        "0 SECTION/2 BLOCKS/{blocks}0 ENDSEC/0 SECTION/2 ENTITIES/{entities}0 ENDSEC/0 EOF"
    );
    pairs.split('/').map(|pair| pair.replacen(' ', "\n", 1) + "\n").collect()
}

fn block(dice: &mut Dice, number: u64) -> String {
    let body: String = (0..dice.below(4)).map(|_| entity(dice, number)).collect();
    format!("0 BLOCK/2 b{number}/10 0/20 0/{body}0 ENDBLK/")
}

fn entity(dice: &mut Dice, blocks: u64) -> String {
    if blocks > 0 && dice.below(2) == 0 {
        let of = dice.below(blocks).to_string();
        return dice.filled(INSERT).replace("BLOCK", &of) + "/";
    }
    let form = dice.one(ENTITIES);
    dice.filled(form) + "/"
}

const ELEMENTS: &[&str] = &[
    "<rect width='#' height='#' rx='#'/>",
    "<circle r='#'/>",
    "<ellipse rx='#' ry='#'/>",
    "<path d='M0 0 C# # # # # #A# # 0 1 1 # #Z'/>",
    "<polyline points='# # # # # #'/>",
    "<line x1='#' y2='#'/>",
    "<text>x</text>",
    "<path d='M0 0' transform='scale(#)'/>",
    "<svg viewBox='0 0 # #' width='#' height='#'><rect width='1' height='#'/></svg>",
];

pub fn svg(dice: &mut Dice) -> String {
    let count = 1 + dice.below(12);
    let groups: String = (0..count).map(|n| group(dice, n)).collect();
    let last = count - 1;
    format!(
        "<svg xmlns='http://www.w3.org/2000/svg'><style>g g {{fill:red}} rect,#a1 {{stroke:none}}</style>\
         <defs>{groups}</defs><use href='#a{last}'/><use href='#a{last}' x='3'/></svg>"
    )
}

fn group(dice: &mut Dice, number: u64) -> String {
    let body: String = (0..dice.below(12)).map(|_| element(dice, number)).collect();
    let turned = dice.filled("rotate(#) translate(# #)");
    let (open, close) = if dice.below(4) == 0 { ("symbol", "symbol") } else { ("g", "g") };
    format!("<{open} id='a{number}' transform='{turned}'>{body}</{close}>")
}

fn element(dice: &mut Dice, groups: u64) -> String {
    if groups > 0 && dice.below(4) > 0 {
        return format!("<use href='#a{}'/>", dice.below(groups));
    }
    let form = dice.one(ELEMENTS);
    dice.filled(form)
}

const INSTRUCTIONS: &[&str] = &[
    "PU#,#;",
    "PD#,#;",
    "PA#,#;",
    "PR#,#;",
    "AA#,#,#;",
    "AR#,#,#;",
    "CI#;",
    "EA#,#;",
    "EW#,#,#;",
    "PM0;",
    "PM1;",
    "PM2;",
    "EP;",
    "SC#,#,#,#;",
    "IP#,#,#,#;",
    "SP@;",
    "RO90;",
    "AT#,#,#,#;",
    "PE<=!2~x;",
    "IN;",
    "LBtext\u{3}",
    "FP;",
    "RR#,#;",
];

pub fn hpgl(dice: &mut Dice) -> String {
    let instructions = (0..5 + dice.below(200)).map(|_| {
        let form = dice.one(INSTRUCTIONS);
        dice.filled(form)
    });
    "IN;SP1;".to_owned() + &instructions.collect::<String>()
}

const CLAUSES: &[&str] = &[
    "circle #,# #",
    "rect #,# #,#",
    "line #,#,# #,# #,#,1 close",
    "select all",
    "array rect @x@",
    "array rect @x@ spacing #,#",
    "array round @ about #,#",
    "array block @x@ gap #,#",
    "array job @x@ gap #,#",
    "copy #,#",
    "copy-to red",
    "scale #",
    "rotate #",
    "clip",
    "paste #,#",
    "offset # keep",
    "join #",
    "fillet #",
    "pocket all tool=# group=blue",
    "engrave all tool=#",
    "group green",
    "set green height=-# pass=# offset=#",
    "sequence auto 0,0",
    "directions auto",
    "mirror #,# #,#",
    "reverse",
    "pocket all tool=# zigzag=# group=cyan",
    "chamfer #",
    "origin #,#",
    "move #,#",
    "sequence travel from 0,0",
];

/// Operations of which those after the first may be refused: a refusal ends the script.
pub fn script(dice: &mut Dice) -> String {
    let begin = ["circle 0,0 5", "select all"].map(str::to_owned);
    let more = (0..1 + dice.below(6)).map(|_| {
        let form = dice.one(CLAUSES);
        dice.filled(form)
    });
    begin.into_iter().chain(more).collect::<Vec<_>>().join("; ")
}
