//! The parts of a program as they are gathered while its file is read.

use super::commands::CommandIndex;
use super::language::is_opensbp;
use super::line::{Line, Read};
use super::names::Names;
use super::text::{after_line_end, blank, is_blank, line_end};
use super::{MOST_DIAGNOSTICS, MOST_LINE_BYTES, moves};
use crate::syntax::tree::{
    Args, Label, LabelId, LabelName, Language, LineNode, NameId, Node, Program, Span, Statement,
};
use crate::syntax::{Dialect, Expressions};
use kerf_diag::{Code, Diagnostic, Place, Severity};
use std::borrow::Cow;
use std::sync::Arc;

/// A file while it is read.
#[derive(Debug)]
pub(super) struct File {
    pub(super) name: Arc<str>,
    pub(super) dialect: Dialect,
    pub(super) lines: Vec<LineNode>,
    pub(super) numbers: Vec<f64>,
    pub(super) statements: Vec<Statement>,
    pub(super) args: Args,
    pub(super) expressions: Expressions,
    labels: Vec<Label>,
    label_names: Names,
    /// The first line of each label, 0 for names that only jumps have.
    label_lines: Vec<u32>,
    names: Names,
    pub(super) diagnostics: Vec<Diagnostic>,
    pub(super) commands: CommandIndex,
    /// The line of an unconditional END with no label behind it.
    pub(super) last_end: Option<u32>,
    /// The file has the ending of G-code: a line is OpenSBP only where it can be nothing else.
    pub(super) gcode_first: bool,
    /// Number of diagnostics that were told but not kept, and whether errors are among them.
    untold: usize,
    untold_errors: bool,
}

/// Ctrl-Z, which ends a file of DOS.
pub(crate) const END_OF_FILE: char = '\u{1a}';

impl File {
    pub(super) fn new(name: Arc<str>, dialect: Dialect) -> Self {
        Self {
            name,
            dialect,
            lines: Vec::new(),
            numbers: Vec::new(),
            statements: Vec::new(),
            args: Args::default(),
            expressions: Expressions::default(),
            labels: Vec::new(),
            label_names: Names::default(),
            label_lines: Vec::new(),
            names: Names::default(),
            diagnostics: Vec::new(),
            commands: CommandIndex::new(dialect),
            last_end: None,
            gcode_first: false,
            untold: 0,
            untold_errors: false,
        }
    }

    /// Reads every line of a text.
    pub(super) fn read(&mut self, text: &str) {
        let bytes = text.as_bytes();
        self.lines.reserve(memchr::memchr_iter(b'\n', bytes).count() + 1);
        // A value of a move takes about eight characters, its comma included.
        self.numbers.reserve(bytes.len() / 8);
        let stop = memchr::memchr(END_OF_FILE as u8, bytes).unwrap_or(bytes.len());
        let last = memchr::memrchr2(b'\n', b'\r', &bytes[..stop]).map_or(0, |at| at + 1);
        let mut start = 0;
        while start < bytes.len() {
            let plain = || moves::read(bytes, start, &mut self.numbers);
            let ends = stop < bytes.len() && start >= last;
            let (node, next) = match (!self.gcode_first && !ends).then(plain).flatten() {
                Some((node, end)) => (node, after_line_end(bytes, end)),
                None => {
                    let (end, next) = line_end(bytes, start);
                    let read = |file: &mut Self| file.line(&text[start..end.min(stop)]);
                    (if start > stop { Node::Comment } else { read(self) }, next)
                }
            };
            self.lines.push(LineNode { node, start: start as u32 });
            start = next;
        }
        self.tell_ignored(text, stop);
        self.numbers.shrink_to_fit();
    }

    /// Warns of text behind the end-of-file sign, which is not read.
    fn tell_ignored(&mut self, text: &str, stop: usize) {
        let ignored = text.get(stop..).unwrap_or("");
        if ignored.chars().all(|c| blank(c) || c.is_whitespace()) {
            return;
        }
        let line = self.lines.partition_point(|line| line.start as usize <= stop);
        let begin = line.checked_sub(1).map_or(0, |last| self.lines[last].start as usize);
        let column = text[begin..stop].chars().count() as u32 + 1;
        let place = Place { file: self.name.clone(), line: line as u32, column, length: 1 };
        let message = "the file ends here with Ctrl-Z; the text behind it is not read";
        let hint = "take the sign with the code 26 out where the text is meant";
        self.diagnostics.push(Diagnostic::new(Code::TextAfterEnd, place, message).hint(hint));
    }

    fn line(&mut self, text: &str) -> Node {
        let first = text.bytes().find(|b| !is_blank(*b));
        match first {
            None => return Node::Blank,
            Some(b'\'') => return Node::Comment,
            _ => {}
        }
        if self.gcode_first && !is_opensbp(text, &self.commands) {
            self.statements.push(Statement::Gcode(text.trim_matches(blank).into()));
            return Node::Statement(self.statements.len() as u32 - 1);
        }
        let number = self.lines.len() as u32 + 1;
        if text.len() > MOST_LINE_BYTES {
            self.too_long(number);
            return Node::Bad;
        }
        let before = self.diagnostics.len();
        let node = Line::new(self, text, number).read();
        if before >= MOST_DIAGNOSTICS {
            self.untold += self.diagnostics.len() - before;
            self.untold_errors |= self.diagnostics[before..].iter().any(Diagnostic::is_error);
            self.diagnostics.truncate(before);
        }
        node.unwrap_or(Node::Bad)
    }

    fn too_long(&mut self, line: u32) {
        let message = format!("the line is longer than {MOST_LINE_BYTES} characters");
        let place = Place::line(self.name.clone(), line);
        let hint = "is this a part file? each command stands on a line of its own";
        self.diagnostics.push(Diagnostic::new(Code::LineTooLong, place, message).hint(hint));
    }

    /// The number of a variable's name, which is the same in any case.
    pub(super) fn name_id(&mut self, name: &str) -> NameId {
        NameId(self.names.id(name))
    }

    /// The number of a label's name: the same in any case, and however many blanks are in it.
    pub(super) fn label_id(&mut self, written: &str) -> LabelId {
        let id = self.label_names.id(&single_blanks(written));
        if self.label_lines.len() <= id as usize {
            self.label_lines.push(0);
        }
        LabelId(id)
    }

    /// Keeps a label; gives the first line that has it.
    fn add_label(&mut self, written: &str, line: u32) -> u32 {
        let name = self.label_id(written);
        self.labels.push(Label { name, line });
        let Some(first) = self.label_lines.get_mut(name.0 as usize) else { return line };
        if *first == 0 {
            *first = line;
        }
        *first
    }

    /// Makes warnings of the findings behind the last END: no run reaches them, so they are no reason not to run.
    ///
    /// Unless a jump misses its label: one of the lines may be that label, misspelt.
    fn soften_unreachable(&mut self) {
        let Some(end) = self.last_end else { return };
        if self.label_lines.contains(&0) {
            return;
        }
        for diagnostic in self.diagnostics.iter_mut().filter(|d| d.place.line > end) {
            diagnostic.severity = Severity::Warning;
            diagnostic.hint = format!("never reached: it stands behind line {end}");
        }
    }

    /// In the dialect `strict` old spellings are errors.
    fn refuse_old_spellings(&mut self) {
        if self.dialect != Dialect::Strict {
            return;
        }
        let old = [Code::DoubtfulSpelling, Code::RepeatedLabel, Code::TextAfterEnd];
        for diagnostic in self.diagnostics.iter_mut().filter(|d| old.contains(&d.code)) {
            diagnostic.severity = Severity::Error;
        }
    }

    /// Everything together; jumps find their labels.
    pub(super) fn finish(mut self, text: String) -> Program {
        if self.untold > 0 {
            let line = self.lines.len() as u32;
            let message = format!("{} more findings are not listed", self.untold);
            let place = Place::line(self.name.clone(), line);
            let severity = if self.untold_errors { Severity::Error } else { Severity::Warning };
            let last = Diagnostic::new(Code::Syntax, place, message).severity(severity);
            self.diagnostics.push(last);
        }
        self.refuse_old_spellings();
        self.soften_unreachable();
        Program {
            name: self.name,
            dialect: self.dialect,
            text: Arc::new(text),
            lines: self.lines,
            numbers: self.numbers,
            statements: self.statements,
            args: self.args,
            expressions: self.expressions,
            labels: self.labels,
            label_names: labels(self.label_names, &self.label_lines),
            names: self.names.into_list(),
            diagnostics: self.diagnostics,
            language: Language::OpenSbp,
        }
    }
}

/// The names of labels and the lines that have them.
fn labels(names: Names, lines: &[u32]) -> Vec<LabelName> {
    let line = |first: &u32| (*first > 0).then_some(*first);
    let named = names.into_list().into_iter().zip(lines);
    named.map(|(name, first)| LabelName { name, line: line(first) }).collect()
}

impl Line<'_, '_> {
    /// Reads the line.
    fn read(&mut self) -> Read<Node> {
        self.skip_blanks();
        if self.is_remark() {
            return Ok(Node::Comment);
        }
        if let Some(node) = self.label()? {
            return Ok(node);
        }
        let statement = self.statement(false)?;
        if matches!(statement, Statement::End | Statement::EndAll | Statement::ExitShopbot) {
            self.file.last_end.get_or_insert(self.number);
        }
        let index = self.file.statements.len() as u32;
        self.file.statements.push(statement);
        Ok(Node::Statement(index))
    }

    fn is_remark(&self) -> bool {
        self.text.get(self.at..self.at + 3).is_some_and(|w| w.eq_ignore_ascii_case("REM"))
            && self.text.as_bytes().get(self.at + 3).is_none_or(|b| is_blank(*b) || *b == b'\'')
    }

    /// A label: words alone on the line with a colon behind them.
    fn label(&mut self) -> Read<Option<Node>> {
        if self.byte(self.end - 1) != b':' {
            return Ok(None);
        }
        let start = self.at;
        let written = self.slice(start, self.end - 1).trim_matches(blank);
        let span = Span { start: start as u32, end: self.end as u32 };
        if written.is_empty() {
            return Err(self.fault(Code::Syntax, span, "a label needs a name", ""));
        }
        if !is_label(written) || (written.contains(blank) && self.is_statement()) {
            return Ok(None);
        }
        let line = self.number;
        let first = self.file.add_label(written, line);
        if first != line {
            let name = single_blanks(written).to_uppercase();
            let message = format!("label {name} repeated at line {line}");
            let hint = format!("jumps go to line {first}");
            self.warn(Code::RepeatedLabel, span, message, hint);
        }
        self.file.last_end = None;
        Ok(Some(Node::Label(self.file.labels.len() as u32 - 1)))
    }
}

/// True for text that can be the name of a label.
pub(super) fn is_label(text: &str) -> bool {
    !text.is_empty()
        && !text.bytes().any(|b| matches!(b, b',' | b'"' | b'=' | b'(' | b')' | b':' | b';'))
        && !text.starts_with(['&', '$', '%'])
}

/// A label's name with single blanks between its words.
fn single_blanks(written: &str) -> Cow<'_, str> {
    if !written.contains(blank) {
        return written.into();
    }
    let words: Vec<&str> = written.split(blank).filter(|word| !word.is_empty()).collect();
    words.join(" ").into()
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn ctrl_z_ends_the_file() {
        use super::super::shown::{findings, tree};
        let told = "W013 1:5+1 the file ends here with Ctrl-Z; the text behind it is not read";
        for (text, last, finding) in [
            ("MX,1⏎\u{1a}⏎MX,9", "comment", Some("W013 2:1")),
            ("MX,1\u{1a}MX,9", "MX 1", Some(told)),
            ("MX,1⏎GOTO A\u{1a}⏎⏎A:", "comment", Some("W013 2:7")),
            ("MX,1⏎\u{1a}\u{1a} ⏎⏎", "comment", None),
            ("MX,1\u{1a}", "MX 1", None),
        ] {
            assert_eq!(tree(text), last, "{text:?}");
            let found = findings(text);
            assert!(
                finding
                    .map_or(found.is_empty(), |start| found.iter().any(|f| f.starts_with(start))),
                "{text:?} {found:?}"
            );
        }
    }

    #[test]
    fn comments_and_blank_lines() {
        for text in ["'only text", "  ' MZ,-3 and END", "REM MX,5", "rem", "REM\tx", "''x"] {
            check(text, "comment");
        }
        for text in ["  ", "\t", " \u{1a}"] {
            check(text, "blank");
        }
        check("REMARK:", "label REMARK");
    }

    #[test]
    fn the_three_line_ends_give_the_same_nodes() {
        let lines = ["MX,1", "", "'c", "A:", "GOTO A", "&x=\"é\""];
        let nodes = |end: &str, mark: &str| {
            let text = format!("{mark}{}{end}", lines.join(end));
            let program = crate::syntax::read("t".into(), text.as_bytes());
            let lines = program.lines.iter().enumerate();
            lines.map(|(i, _)| super::super::shown::node(&program, i)).collect::<Vec<_>>()
        };
        let unix = nodes("\n", "");
        assert_eq!(unix.len(), lines.len());
        assert_eq!(unix[4], "goto A 4");
        for (end, mark) in [("\r\n", ""), ("\r", ""), ("\n", "\u{feff}")] {
            assert_eq!(nodes(end, mark), unix, "{end:?}");
        }
    }

    #[test]
    fn what_is_no_text_is_refused() {
        let program = crate::syntax::read("t".into(), b"MX,1\nMX\0,2");
        assert!(program.lines.is_empty() && program.has_errors());
        finds("MX,1\nMX\0,2", &["S001 2:1+0 not a text file"]);
    }

    #[test]
    fn endless_lines_are_refused_at_once() {
        let long = format!("MX,1\nMX,{}\nMY,2", "1+".repeat(5_000_000));
        finds(&long, &["S015 2:1+0 the line is longer than 1000000 characters"]);
        check(&long, "move MY 2");
        let commas = format!("MX,1{}2", ",".repeat(900_000));
        finds(&commas, &["S009 1:900005+1"]);
        finds(&format!("PRINT {}", "\"\";".repeat(300_000)), &["S009 1:3007+2"]);
        let quotes = "\"".repeat(900_001);
        finds(&quotes, &["S003 1:1+1"]);
        finds(&format!("MX,{quotes}"), &["S004 1:6+899999"]);
    }

    #[test]
    fn millions_of_mistakes_are_counted_and_not_kept() {
        let text = "QQ,1\n".repeat(50_000);
        let program = crate::syntax::read("t".into(), text.as_bytes());
        assert_eq!(program.diagnostics.len(), super::MOST_DIAGNOSTICS + 1);
        let last = program.diagnostics.last().map(super::super::shown::finding);
        assert_eq!(last.as_deref(), Some("S004 50000:1+0 40000 more findings are not listed"));
        assert!(program.has_errors());
        let doubtful = crate::syntax::read("t".into(), "A:\n".repeat(20_000).as_bytes());
        assert_eq!(doubtful.diagnostics.len(), super::MOST_DIAGNOSTICS + 1);
        assert!(!doubtful.has_errors());
    }

    #[test]
    fn mistakes_behind_the_last_end_are_warnings() {
        let reads = |text: &str| {
            let text = text.replace('⏎', "\n");
            !crate::syntax::read("t".into(), text.as_bytes()).has_errors()
        };
        assert!(reads("MX,1⏎END⏎____"));
        finds(
            "MX,1⏎END⏎____",
            &["S003 3:1+4 unknown statement ____ [never reached: it stands behind line 2]"],
        );
        assert!(!reads("MX,1⏎END⏎A:⏎____"));
        assert!(!reads("GOTO A⏎END⏎LABEL A⏎____"));
        assert!(!reads("MX,1⏎IF &a THEN END⏎____"));
        assert!(!reads("____⏎END"));
    }

    #[test]
    fn columns_count_characters() {
        finds("'é⏎MX,\"éé\" & QQ(1)", &["S008 2:11+2"]);
    }
}
