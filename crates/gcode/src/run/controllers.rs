//! The codes and words that the controllers of the dialects refuse: grbl 1.1, grblHAL, Mach3, LinuxCNC.
//!
//! grbl is as its parser has it (gcode.c of version 1.1h, built as it is shipped). Of grblHAL and Mach3 only what
//! their own lists of codes lack is refused.

use super::state::Plane;
use super::stop::{Refused, fail};
use crate::syntax::codes::{G_GROUPS, M_GROUPS, MOTION, ONCE, g_name};
use crate::syntax::dialect::Dialect;
use crate::syntax::gathered::{Gathered, letters};
use kerf_diag::Code;

/// The error of a thing that a controller does not have.
fn lacks(dialect: Dialect, what: &str, mend: &str) -> Refused {
    fail(Code::NotInDialect, format!("{} has no {what}", dialect.title()), mend)
}

pub(super) const EXPRESSIONS: &str = "expressions";
pub(super) const O_WORDS: &str = "O-words";
pub(super) const NUMBERED: &str = "parameters";
pub(super) const NAMED: &str = "named parameters";

const LINUXCNC: &str = "run it with --dialect linuxcnc";
const GRBLHAL: &str = "grblHAL has it: run it with --dialect grblhal";
const GENERIC: &str = "run it with --dialect generic";

/// Refuses words that a controller does not have: grbl itself has no expressions and no O-words, Mach3 no O-words.
pub(super) fn need_words(dialect: Dialect, what: &str) -> Result<(), Refused> {
    if lacks_words(dialect, what) { Err(lacks(dialect, what, LINUXCNC)) } else { Ok(()) }
}

/// Returns `true` if a controller has no such words.
fn lacks_words(dialect: Dialect, what: &str) -> bool {
    match dialect {
        Dialect::Grbl => true,
        Dialect::Mach3 => matches!(what, O_WORDS | NAMED),
        _ => false,
    }
}

/// The first thing of a block that a controller refuses, with the motion that it makes.
pub(super) fn refuses(
    dialect: Dialect,
    g: &Gathered,
    motion: Option<i32>,
    plane: Plane,
) -> Option<Refused> {
    if let Some(code) = g.cancels.filter(|_| !dialect.is_lenient()) {
        let mend = "it switches off what is never on: leave it out, or run the file with --dialect generic";
        return Some(lacks(dialect, &g_name(code), mend));
    }
    if !dialect.is_lenient() && g.g[MOTION].is_some_and(|m| m != 800) && g.goes_home() {
        let what = "G28 and G30 beside a motion need the axis words both";
        let mend =
            "write the motion on a line of its own; --dialect generic reads it as Fanuc does";
        return Some(fail(Code::ModalConflict, what, mend));
    }
    if let Some(lacking) = lacking_code(dialect, g) {
        let hal = dialect == Dialect::Grbl && lacking_code(Dialect::GrblHal, g).is_none();
        return Some(lacks(dialect, &lacking, if hal { GRBLHAL } else { LINUXCNC }));
    }
    if dialect == Dialect::Grbl { words_of_grbl(g, motion, plane) } else { None }
}

/// A function that returns `true` if a controller lacks a code.
type Lacks = fn(i32) -> bool;

/// The first code of a block that a controller does not have.
fn lacking_code(dialect: Dialect, g: &Gathered) -> Option<String> {
    let mut g_codes = (0..G_GROUPS).filter_map(|group| g.g[group]);
    let mut m_codes = (0..M_GROUPS).filter_map(|group| g.m[group]);
    let (lacks_g, lacks_m): (Lacks, Lacks) = match dialect {
        Dialect::Grbl => (|g| !grbl_has(g), |m| !matches!(m, 0..=5 | 8 | 9 | 30)),
        Dialect::GrblHal => {
            (|g| !(grbl_has(g) || hal_has(g)), |m| matches!(m, 10..=13 | 19 | 98 | 106 | 107))
        }
        Dialect::Mach3 => (mach_lacks, |m| matches!(m, 50..=53 | 60 | 62..=68 | 70..=73)),
        Dialect::LinuxCnc | Dialect::Generic => return None,
    };
    let g_code = g_codes.find(|code| lacks_g(*code)).map(g_name);
    g_code.or_else(|| m_codes.find(|code| lacks_m(*code)).map(|m| format!("M{m}")))
}

const fn grbl_has(code: i32) -> bool {
    let motion = matches!(code, 0 | 10 | 20 | 30 | 382..=385 | 800);
    let once = matches!(code, 40 | 100 | 280 | 281 | 300 | 301 | 530 | 920 | 921);
    let modes = matches!(code, 170 | 180 | 190 | 200 | 210 | 900 | 910 | 911 | 930 | 940 | 610);
    motion || once || modes || matches!(code, 400 | 431 | 490 | 540 | 550 | 560 | 570 | 580 | 590)
}

/// Returns `true` if grblHAL adds this code.
const fn hal_has(code: i32) -> bool {
    let motion = matches!(code, 50 | 51 | 730 | 810 | 820 | 830 | 850 | 860 | 890);
    motion || matches!(code, 430 | 591..=593 | 922 | 923 | 950 | 980 | 990)
}

const fn mach_lacks(code: i32) -> bool {
    matches!(code, 50..=53 | 382..=385 | 431 | 591..=593)
}

/// Words that grbl does not know or does not expect.
fn words_of_grbl(g: &Gathered, motion: Option<i32>, plane: Plane) -> Option<Refused> {
    let refused = |holds: bool, what: &str, mend| holds.then(|| lacks(Dialect::Grbl, what, mend));
    let arc = matches!(motion, Some(20 | 30));
    let [u, v, _] = plane.axes().map(|axis| letters(&[b"XYZ"[axis]]));
    refused(g.has_any(letters(b"@^")), "polar places (@ and ^)", GENERIC)
        .or_else(|| refused(g.has_any(letters(b"ABC")), "axes A, B and C", GRBLHAL))
        .or_else(|| {
            refused(
                arc && g.has(b'P'),
                "arcs of several turns (P)",
                "write each turn as an arc of its own",
            )
        })
        .or_else(|| {
            let endless = arc && g.g[MOTION].is_some() && !g.has_any(u | v);
            refused(
                endless,
                "arcs without an end in their plane",
                "name the end too, also where it is the beginning: G2 X0 Y0 I5",
            )
        })
        .or_else(|| {
            refused(g.beside_g80, "G80 beside another motion", "write G80 on a line of its own")
        })
        .or_else(|| {
            let by_p = g.g[ONCE] != Some(40) || g.has(b'P');
            refused(!by_p, "G4 without P", "G4 P1.5 waits for one and a half seconds")
        })
        .or_else(|| {
            let tools = g.g[ONCE] == Some(100) && !matches!(g.or_zero(b'L'), 2.0 | 20.0);
            refused(tools, "tools of G10 (L1, L10, L11)", GRBLHAL)
        })
        .or_else(|| {
            let turned = g.g[ONCE] == Some(100) && g.has(b'R');
            refused(turned, "turned coordinate systems (G10 L2 R)", LINUXCNC)
        })
}
