//! A text line by line.

use super::file::File;
use super::index::is_opensbp;
use super::labels::{is_label, single_blanks};
use super::line::{Line, Read};
use super::text::{after_line_end, blank, is_blank, line_end};
use super::{ends, moves, statements};
use crate::syntax::tree::{LineNode, Node, Span, Statement};
use kerf_diag::{Code, Diagnostic, SourcePlace};

/// Longer lines are refused; no person and no program writes them.
const MOST_LINE_BYTES: usize = 1_000_000;

/// Ctrl-Z, which ends a file of DOS.
pub(crate) const END_OF_FILE: char = '\u{1a}';

/// Reads every line of a text.
pub(super) fn read_all(file: &mut File, text: &str) {
    let bytes = text.as_bytes();
    file.program.lines.reserve(memchr::memchr_iter(b'\n', bytes).count() + 1);
    // A value of a move takes about eight characters, its comma included.
    file.program.numbers.reserve(bytes.len() / 8);
    let stop = memchr::memchr(END_OF_FILE as u8, bytes).unwrap_or(bytes.len());
    let last = memchr::memrchr2(b'\n', b'\r', &bytes[..stop]).map_or(0, |at| at + 1);
    let mut start = 0;
    while start < bytes.len() {
        let plain = || moves::read(bytes, start, &mut file.program.numbers);
        let ends = stop < bytes.len() && start >= last;
        let (node, next) = match (!file.gcode_first && !ends).then(plain).flatten() {
            Some((node, end)) => (node, after_line_end(bytes, end)),
            None => {
                let (end, next) = line_end(bytes, start);
                let line = text.get(start..end.min(stop));
                (line.map_or(Node::Comment, |line| read_line(file, line)), next)
            }
        };
        file.program.lines.push(LineNode { node, start: start as u32 });
        start = next;
    }
    tell_ignored(file, text, stop);
    file.program.numbers.shrink_to_fit();
}

/// Warns of text behind the end-of-file sign, which is not read.
fn tell_ignored(file: &mut File, text: &str, stop: usize) {
    let ignored = text.get(stop..).unwrap_or("");
    if ignored.chars().all(|c| blank(c) || c.is_whitespace()) {
        return;
    }
    let line = file.program.lines.partition_point(|line| line.start as usize <= stop);
    let begin = line.checked_sub(1).map_or(0, |last| file.program.lines[last].start as usize);
    let column = text[begin..stop].chars().count() as u32 + 1;
    let place =
        SourcePlace { file: file.program.name.clone(), line: line as u32, column, length: 1 };
    let message = "the file ends here with Ctrl-Z; the text behind it is not read";
    let hint = "take the sign with the code 26 out where the text is meant";
    file.program.diagnostics.push(Diagnostic::new(Code::TextAfterEnd, place, message).hint(hint));
}

fn read_line(file: &mut File, text: &str) -> Node {
    let first = text.bytes().find(|b| !is_blank(*b));
    match first {
        None => return Node::Blank,
        Some(b'\'') => return Node::Comment,
        _ => {}
    }
    if file.gcode_first && !is_opensbp(text, &file.commands) {
        file.program.statements.push(Statement::Gcode(text.trim_matches(blank).into()));
        return Node::Statement(file.program.statements.len() as u32 - 1);
    }
    let number = file.program.lines.len() as u32 + 1;
    if text.len() > MOST_LINE_BYTES {
        too_long(file, number);
        return Node::Bad;
    }
    let before = file.program.diagnostics.len();
    let node = read(&mut Line::new(file, text, number));
    file.bound_diagnostics(before);
    node.unwrap_or(Node::Bad)
}

/// Reports a line that is too long to be read.
fn too_long(file: &mut File, line: u32) {
    let message = format!("the line is longer than {MOST_LINE_BYTES} characters");
    let place = SourcePlace::line(file.program.name.clone(), line);
    let hint = "is this a part file? each command stands on a line of its own";
    let told = Diagnostic::new(Code::LineTooLong, place, message).hint(hint);
    file.program.diagnostics.push(told);
}

/// Reads the line.
fn read(l: &mut Line<'_, '_>) -> Read<Node> {
    l.skip_blanks();
    if is_remark(l) {
        return Ok(Node::Comment);
    }
    if let Some(node) = label(l)? {
        return Ok(node);
    }
    let statement = statements::statement(l, false)?;
    if matches!(statement, Statement::End | Statement::EndAll | Statement::ExitShopbot) {
        l.file.last_end.get_or_insert(l.number);
    }
    let index = l.file.program.statements.len() as u32;
    l.file.program.statements.push(statement);
    Ok(Node::Statement(index))
}

fn is_remark(l: &Line<'_, '_>) -> bool {
    l.text.get(l.at..l.at + 3).is_some_and(|w| w.eq_ignore_ascii_case("REM"))
        && l.text.as_bytes().get(l.at + 3).is_none_or(|b| is_blank(*b) || *b == b'\'')
}

/// A label: words alone on the line with a colon behind them.
fn label(l: &mut Line<'_, '_>) -> Read<Option<Node>> {
    if l.byte(l.end - 1) != b':' {
        return Ok(None);
    }
    let start = l.at;
    let written = l.slice(start, l.end - 1).trim_matches(blank);
    let span = Span { start: start as u32, end: l.end as u32 };
    if written.is_empty() {
        return Err(l.fault(Code::Syntax, span, "a label needs a name", ""));
    }
    if !is_label(written) || (written.contains(blank) && ends::is_statement(l)) {
        return Ok(None);
    }
    let line = l.number;
    let (number, first) = l.file.labels.add(written, line);
    if first != line {
        let name = single_blanks(written).to_uppercase();
        let message = format!("label {name} repeated at line {line}");
        let hint = format!("jumps go to line {first}");
        l.warn(Code::RepeatedLabel, span, message, hint);
    }
    l.file.last_end = None;
    Ok(Some(Node::Label(number)))
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
        assert_eq!(program.diagnostics.len(), super::super::file::MOST_DIAGNOSTICS + 1);
        let last = program.diagnostics.last().map(super::super::shown::finding);
        assert_eq!(last.as_deref(), Some("S004 50000:1+0 40000 more findings are not listed"));
        assert!(program.has_errors());
        let doubtful = crate::syntax::read("t".into(), "A:\n".repeat(20_000).as_bytes());
        assert_eq!(doubtful.diagnostics.len(), super::super::file::MOST_DIAGNOSTICS + 1);
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
