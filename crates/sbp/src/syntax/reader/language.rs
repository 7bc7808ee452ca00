//! Which language a file is in: OpenSBP, G-code, or both, line by line.
//!
//! The ending decides what a line is that could be either: `M2` alone ends a G-code file and is a
//! move without values in a part file. A file that is wholly in the other language is run as what it
//! is, and told of.

use super::file::File;
use super::index::{CommandIndex, is_opensbp};
use super::text::{is_blank, line_end};
use crate::syntax::Dialect;
use crate::syntax::tree::{Language, Node, Program, Statement};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace};
use std::borrow::Cow;
use std::sync::Arc;

/// Endings of files in OpenSBP: part files, custom cuts, settings.
pub const PART_ENDINGS: [&str; 3] = ["sbp", "sbc", "sbd"];

/// Endings of G-code files.
pub const GCODE_ENDINGS: [&str; 6] = ["nc", "tap", "ngc", "gcode", "cnc", "gc"];

/// Returns `true` if the name of a file ends as those of G-code files do.
pub fn is_gcode_name(name: &str) -> bool {
    ends_in(name, &GCODE_ENDINGS)
}

/// Returns `true` if the name of a file ends as those of files in OpenSBP do.
pub fn is_part_name(name: &str) -> bool {
    ends_in(name, &PART_ENDINGS)
}

fn ends_in(name: &str, endings: &[&str]) -> bool {
    let file = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let ending = file.rsplit_once('.').map_or("", |(_, ending)| ending);
    endings.iter().any(|known| known.eq_ignore_ascii_case(ending))
}

/// Reads a part file in either language, or in both.
///
/// Of a file in G-code only the text is kept: [`Program::language`] tells, and `kerf-gcode` reads it.
pub fn read_part<'a>(name: Arc<str>, bytes: impl Into<Cow<'a, [u8]>>) -> Program {
    read_part_as(name, bytes, Dialect::Sb3)
}

/// The same, OpenSBP written in a dialect.
pub fn read_part_as<'a>(
    name: Arc<str>,
    bytes: impl Into<Cow<'a, [u8]>>,
    dialect: Dialect,
) -> Program {
    let bytes = bytes.into();
    if !is_gcode_name(&name) {
        return gcode_in_disguise(super::read_as(name, bytes, dialect));
    }
    let text = match kerf_diag::decode(bytes) {
        Ok(text) if text.len() < u32::MAX as usize => text,
        Ok(_) => return super::refused(name, 1, "the file is larger than 4 GB"),
        Err(line) => return super::refused(name, line, "not a text file"),
    };
    match contents(&text, dialect) {
        (_, false) => whole_gcode(name, text),
        (true, true) => mixed(name, text, dialect),
        (false, true) => part_file_in_disguise(name, text, dialect),
    }
}

/// Reads a text in a language that is known.
pub(crate) fn read_language(
    name: Arc<str>,
    text: String,
    language: Language,
    dialect: Dialect,
) -> Program {
    match language {
        Language::OpenSbp => super::read_as(name, text.into_bytes(), dialect),
        Language::Gcode => whole_gcode(name, text),
        Language::Mixed => mixed(name, text, dialect),
    }
}

/// A file in G-code.
fn whole_gcode(name: Arc<str>, text: impl Into<Arc<String>>) -> Program {
    Program { name, text: text.into(), language: Language::Gcode, ..Program::default() }
}

/// A G-code file with lines of OpenSBP.
fn mixed(name: Arc<str>, text: String, dialect: Dialect) -> Program {
    let mut file = File::new(name, dialect);
    file.gcode_first = true;
    super::lines::read_all(&mut file, &text);
    Program { language: Language::Mixed, ..file.finish(text) }
}

/// A part file with the ending of G-code files.
fn part_file_in_disguise(name: Arc<str>, text: String, dialect: Dialect) -> Program {
    let mut program = super::read_as(name, text.into_bytes(), dialect);
    let message = "this file is OpenSBP, not G-code; it is read as OpenSBP";
    disguised(&mut program, message, "give it the ending .sbp");
    program
}

/// A file of G-code with the ending of part files is read as G-code; other part files stay.
fn gcode_in_disguise(program: Program) -> Program {
    if !is_all_gcode(&program) {
        return program;
    }
    let mut program = whole_gcode(program.name, program.text);
    let message = "this file is G-code, not OpenSBP; it is read as G-code";
    disguised(&mut program, message, "give it the ending .nc");
    program
}

fn disguised(program: &mut Program, message: &str, hint: &str) {
    let place = SourcePlace::line(program.name.clone(), 1);
    let diagnostic = Diagnostic::new(Code::NotGcode, place, message).hint(hint);
    program.diagnostics.insert(0, diagnostic.severity(Severity::Warning));
}

/// Returns `true` if no line is surely OpenSBP and some have a G word.
fn is_all_gcode(program: &Program) -> bool {
    let foreign = |node: Node| match node {
        Node::Comment | Node::Label(_) => true,
        Node::Move { given, .. } => given != 0,
        Node::Statement(index) => {
            let statement = program.statements.get(index as usize);
            !statement.is_some_and(may_be_gcode)
        }
        Node::Blank | Node::Bad => false,
    };
    let has_g = |s: &Statement| matches!(s, Statement::Gcode(text) if text.contains(['G', 'g']));
    program.statements.iter().any(has_g) && !program.lines.iter().any(|l| foreign(l.node))
}

/// Returns `true` if a statement is G-code, or could be: a command whose letters stand alone, as M2.
fn may_be_gcode(statement: &Statement) -> bool {
    match statement {
        Statement::Gcode(_) => true,
        Statement::Command { args, .. } => args.is_empty(),
        _ => false,
    }
}

/// Tells whether a text with a G-code file's ending holds G-code, and whether it holds OpenSBP.
fn contents(text: &str, dialect: Dialect) -> (bool, bool) {
    let (mut gcode, mut opensbp) = (false, false);
    let mut commands = None;
    let bytes = text.as_bytes();
    let mut start = 0;
    while start < bytes.len() && !(gcode && opensbp) {
        let (end, next) = line_end(bytes, start);
        let line = text.get(start..end).unwrap_or_default();
        start = next;
        if line.bytes().all(is_blank) {
            continue;
        }
        let found = is_opensbp(line, commands.get_or_insert_with(|| CommandIndex::new(dialect)));
        opensbp |= found;
        gcode |= !found;
    }
    (gcode, opensbp)
}
