//! Finds the kind of statement that a line is.

use super::keywords::Keyword;
use super::labels::is_label;
use super::line::{Failed, Line, Read, is_name};
use super::text::blank;
use super::{
    assign, commands, dialog, ends, expression, fabmo, files, flow, gcode, members, output,
};
use crate::syntax::table;
use crate::syntax::tree::{Span, Statement};
use kerf_diag::Code;

/// Words of FabMo's dialect, and what does the same here.
const FABMO: &[(&str, &str)] = &[
    ("DIALOG", "MSGBOX or INPUT"),
    ("FAIL", "MSGBOX and ENDALL"),
    ("DATA_SEND", "WRITE"),
    ("DATA_REQUEST", "INPUT"),
    ("SU", "VD,,,0 sets inches, VD,,,1 millimetres"),
    ("PX", PROBE),
    ("PY", PROBE),
    ("PZ", PROBE),
    ("PA", PROBE),
    ("PB", PROBE),
    ("PC", PROBE),
    ("P2", PROBE),
    ("P3", PROBE),
    ("P4", PROBE),
    ("P5", PROBE),
];

const PROBE: &str = "ON INPUT(switch, 1) and a move";

/// Words of other BASICs, and what to write instead.
const FOREIGN: &[(&str, &str)] = &[
    ("ELSE", "use a second IF, or IF ... THEN GOTO"),
    ("ELSEIF", "use a second IF, or IF ... THEN GOTO"),
    ("ENDIF", "an IF ends with its line"),
    ("FOR", "count a variable and use IF ... THEN GOTO"),
    ("NEXT", "count a variable and use IF ... THEN GOTO"),
    ("WHILE", "use a label and IF ... THEN GOTO"),
    ("WEND", "use a label and IF ... THEN GOTO"),
    ("DO", "use a label and IF ... THEN GOTO"),
    ("LOOP", "use a label and IF ... THEN GOTO"),
    ("LET", "write &name = value"),
    ("DIM", "variables need no declaration"),
    ("LABEL", "a label is a name alone on its line and a colon behind it"),
];

/// A statement at the cursor; `inner` behind THEN or ON INPUT.
pub(super) fn statement(l: &mut Line<'_, '_>, inner: bool) -> Read<Statement> {
    l.skip_blanks();
    let start = l.at;
    match l.peek() {
        b'&' => return assign::assignment(l, false),
        b'$' => return assign::assignment(l, true),
        b'%' | b'(' | b';' => return percent_or_code(l, start),
        b'#' if gcode::is_gcode_setting(l, start) => return Ok(gcode::gcode(l)),
        _ => {}
    }
    let end = l.word_end(start);
    let word = l.slice(start, end);
    let separated = l.separated(end);
    if word.len() == 2
        && separated
        && let Some(spec) = l.file.commands.find(word)
        && !gcode::is_gcode_words(l, start, word)
    {
        l.at = end;
        return commands::command(l, spec, start);
    }
    if let Some(failed) = wrong_separator(l, start, end) {
        return Err(failed);
    }
    if let Some(keyword) = Keyword::find(word) {
        l.at = end;
        return behind_keyword(l, keyword, start, inner);
    }
    l.at = end;
    if let Some(read) = fabmo::fabmo(l, word, start) {
        return read;
    }
    l.at = start;
    if let Some(custom) = custom(l, start, end)? {
        return Ok(custom);
    }
    if gcode::is_gcode(l, start) {
        return Ok(gcode::gcode(l));
    }
    Err(gcode::o_word(l, start).unwrap_or_else(|| unknown(l, start, end)))
}

fn behind_keyword(
    l: &mut Line<'_, '_>,
    keyword: Keyword,
    start: usize,
    inner: bool,
) -> Read<Statement> {
    match keyword {
        Keyword::If => flow::if_then(l, start, inner),
        Keyword::On => flow::on_input(l, start, inner),
        Keyword::Goto => Ok(Statement::Goto(flow::target(l, start)?)),
        Keyword::Gosub => Ok(Statement::Gosub(flow::target(l, start)?)),
        Keyword::Return => Ok(flow::ended(l, Statement::Return)),
        Keyword::End => flow::end_statement(l, start),
        Keyword::EndAll => Ok(flow::ended(l, Statement::EndAll)),
        Keyword::Exit => {
            expect_word(l, "SHOPBOT", start)?;
            Ok(flow::ended(l, Statement::ExitShopbot))
        }
        Keyword::Warning => {
            expect_word(l, "OFF", start)?;
            Ok(flow::ended(l, Statement::WarningOff))
        }
        Keyword::Pause => flow::pause(l, start),
        Keyword::Print => output::output(l, false),
        Keyword::Write => output::output(l, true),
        Keyword::Input => dialog::input(l, start),
        Keyword::MsgBox => dialog::msgbox(l, start),
        Keyword::Open => files::open(l, start),
        Keyword::Close => files::close(l),
        Keyword::Play => dialog::play(l, start),
        Keyword::Shell => dialog::shell(l, start),
        registry => dialog::registry(l, registry, start),
    }
}

fn expect_word(l: &mut Line<'_, '_>, word: &str, start: usize) -> Read<()> {
    if l.take_word(word) {
        return Ok(());
    }
    let first = l.slice(start, l.word_end(start)).to_uppercase();
    let span = l.span_to_end();
    let message = format!("{first} {word} expected");
    Err(l.fault(Code::UnknownStatement, span, message, format!("write {first} {word}")))
}

/// `%(1)=5`, or a line of G-code that begins with %, ( or ;.
fn percent_or_code(l: &mut Line<'_, '_>, start: usize) -> Read<Statement> {
    if l.peek() == b'%' {
        l.at = l.until(start, b')') + 1;
        if l.take(b'=') {
            let span = l.span_from(start);
            let hint = "use VA for locations and VS for speeds";
            let message = "system variables are read-only; use VA";
            return Err(l.fault(Code::ReadOnlyVariable, span, message, hint));
        }
        l.at = start;
    }
    Ok(gcode::gcode(l))
}

/// A custom cut: `C#,n`, `CN,n` or `Cn`.
fn custom(l: &mut Line<'_, '_>, start: usize, end: usize) -> Read<Option<Statement>> {
    let word = l.slice(start, end);
    if !word.starts_with(['C', 'c']) {
        return Ok(None);
    }
    let rest = &word[1..];
    let listed = rest.eq_ignore_ascii_case("N") || (rest.is_empty() && l.byte(end) == b'#');
    let plain = !rest.is_empty() && rest.len() <= 5 && rest.bytes().all(|b| b.is_ascii_digit());
    let found = listed || (plain && l.separated(end));
    if !found {
        return Ok(None);
    }
    // `C1 X2` is G-code: an axis word and another one.
    if plain && gcode::is_gcode(l, start) && gcode::gcode_words(l, start) > 1 {
        return Ok(None);
    }
    l.at = if plain { start + 1 } else { end + usize::from(rest.is_empty()) };
    let number = if plain {
        output::single_value(l)?
    } else {
        l.take(b',');
        expression::expression(l)?
    };
    ends::trailing_commas(l);
    ends::expect_end(l)?;
    Ok(Some(Statement::Custom { number, span: l.span_from(start) }))
}

fn unknown(l: &mut Line<'_, '_>, start: usize, end: usize) -> Failed {
    let word = l.slice(start, end);
    if let Some(label) = label_with_text(l, start) {
        return label;
    }
    if word.is_empty() {
        return unknown_sign(l, start);
    }
    let name = word.to_uppercase();
    let foreign = foreign_hint(&name);
    if foreign.is_none()
        && let Some(failed) = missing_separator(l, start, end)
    {
        return failed;
    }
    let span = Span { start: start as u32, end: end as u32 };
    let hint = foreign.unwrap_or_else(|| nearest(&name));
    let (code, kind) = if name.len() <= 2 || l.byte(end) == b',' {
        (Code::UnknownCommand, "command")
    } else {
        (Code::UnknownStatement, "statement")
    };
    l.fault(code, span, format!("unknown {kind} {name}"), hint)
}

fn unknown_sign(l: &mut Line<'_, '_>, start: usize) -> Failed {
    let found = l.slice(start, l.end).chars().next().unwrap_or(' ');
    let span = Span { start: start as u32, end: start as u32 + found.len_utf8() as u32 };
    let message = format!("a line cannot begin with {found}");
    l.fault(Code::UnknownStatement, span, message, "a comment begins with an apostrophe")
}

/// `Start: MX,1`: a label does not share its line.
fn label_with_text(l: &mut Line<'_, '_>, start: usize) -> Option<Failed> {
    let colon = l.until(start, b':');
    let written = l.slice(start, colon).trim_end_matches(blank);
    if colon >= l.end || !is_label(written) || written.contains([' ', '\t']) {
        return None;
    }
    let span = Span { start: colon as u32 + 1, end: l.end as u32 };
    let message = format!("the label {} shares its line", written.to_uppercase());
    let hint = "a label stands alone; put the rest on the next line";
    Some(l.fault(Code::OneCommandPerLine, span, message, hint))
}

/// `M3;1,2` and `C9;`: a command with a wrong separator, which would be G-code with a comment otherwise. A
/// parenthesis is a comment of G-code that follows a word without a blank.
fn wrong_separator(l: &mut Line<'_, '_>, start: usize, end: usize) -> Option<Failed> {
    if end != start + 2 || l.separated(end) || l.byte(end) == b'(' {
        return None;
    }
    let custom = matches!(l.slice(start, end).as_bytes(), [b'C' | b'c', b'0'..=b'9']);
    if !custom || l.byte(end) != b';' {
        return missing_separator(l, start, end);
    }
    let span = l.span_to_end();
    let word = l.slice(start, end).to_uppercase();
    let message = format!("{word} is followed by ; and not by a comma or a blank");
    let hint = format!("write {word} for the custom cut, or G1 {word} for the axis C in G-code");
    Some(l.fault(Code::UnknownCommand, span, message, hint))
}

/// `M23, 4.2` and `MX-5`: letters of a command with a value right behind.
fn missing_separator(l: &mut Line<'_, '_>, start: usize, end: usize) -> Option<Failed> {
    let letters = l.slice(start, (start + 2).min(end));
    let spec = l.file.commands.find(letters)?;
    let behind = l.byte(start + 2);
    if is_name(behind) && !behind.is_ascii_digit() {
        return None;
    }
    let value = l.slice(start + 2, l.field_end(start + 2));
    let value = value.split([' ', '\t']).next().unwrap_or(value);
    let stop = (start + 2 + value.len()) as u32;
    let span = Span { start: start as u32, end: stop };
    let word = l.slice(start, stop as usize).to_uppercase();
    let message = format!("unknown command or missing separator: {word}");
    let rest = l.slice(start + 2, l.end).trim_start_matches([';', ':', '.']).trim();
    let rest = if rest.is_empty() { String::new() } else { format!(",{rest}") };
    let hint = format!("write {}{rest}", spec.letters);
    Some(l.fault(Code::UnknownCommand, span, message, hint))
}

/// The hint for a word of another language or dialect.
fn foreign_hint(name: &str) -> Option<String> {
    let find = |list: &[(&str, &'static str)]| list.iter().find(|(w, _)| *w == name).map(|f| f.1);
    let fabmo = || find(FABMO).map(members::or_else);
    find(FOREIGN).map(str::to_owned).or_else(fabmo)
}

/// A hint for an unknown word: signs that look alike first, then the nearest name.
fn nearest(name: &str) -> String {
    let alike = name.replace('0', "O").replace('1', "I");
    if alike != name && table::find(&alike).is_some() {
        return format!("did you mean {alike}?");
    }
    let statements = Keyword::ALL.iter().map(|(text, _)| *text).chain(["REM"]);
    let near = if name.len() == 2 {
        let swapped: String = name.chars().rev().collect();
        table::find(&swapped).map(|spec| format!("did you mean {}?", spec.letters))
    } else {
        kerf_diag::did_you_mean(name, statements)
    };
    near.unwrap_or_else(|| "a command has two letters and then a comma or a blank".into())
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn unknown_words_get_a_hint() {
        for (text, finding) in [
            (
                "QQ,1",
                "S002 1:1+2 unknown command QQ [a command has two letters and then a comma or a blank]",
            ),
            (
                "Q0,1",
                "S002 1:1+2 unknown command Q0 [a command has two letters and then a comma or a blank]",
            ),
            ("XM,1", "S002 1:1+2 unknown command XM [did you mean MX?]"),
            ("M23, 4.2", "S002 1:1+3 unknown command or missing separator: M23 [write M2,3, 4.2]"),
            ("MX;1", "S002 1:1+4 unknown command or missing separator: MX;1 [write MX,1]"),
            ("M3;1,2,3", "S002 1:1+4 unknown command or missing separator: M3;1 [write M3,1,2,3]"),
            ("M2;3;4", "S002 1:1+6 unknown command or missing separator: M2;3;4 [write M2,3;4]"),
            ("m5;", "S002 1:1+3 unknown command or missing separator: M5; [write M5]"),
            ("M2:3", "S002 1:1+4 unknown command or missing separator: M2:3 [write M2,3]"),
            ("M2.5", "S002 1:1+4 unknown command or missing separator: M2.5 [write M2,5]"),
            ("J2;1;1", "S002 1:1+6 unknown command or missing separator: J2;1;1 [write J2,1;1]"),
            (
                "C9;1",
                "S002 1:1+4 C9 is followed by ; and not by a comma or a blank [write C9 for the custom cut, or G1 C9",
            ),
            ("MX-5", "S002 1:1+4 unknown command or missing separator: MX-5 [write MX,-5]"),
            ("JZ&up", "S002 1:1+5 unknown command or missing separator: JZ&UP [write JZ,&up]"),
            ("REMARK,1", "S002 1:1+6 unknown command REMARK"),
            ("GOTTO Done", "S003 1:1+5 unknown statement GOTTO [did you mean GOTO?]"),
            ("ELSE", "S003 1:1+4 unknown statement ELSE [use a second IF, or IF ... THEN GOTO]"),
            ("END IF", "S003 1:1+6 unknown statement END IF"),
            (
                "PZ,-1,2,3",
                "S002 1:1+2 unknown command PZ [this is FabMo's dialect: --dialect fabmo; here ON INPUT(switch, 1)",
            ),
            ("EXIT", "S003 1:5+0 EXIT SHOPBOT expected"),
            ("WARNING ON", "S003 1:9+2 WARNING OFF expected"),
            ("!FABMO!", "S003 1:1+1 a line cannot begin with !"),
            ("= 5", "S003 1:1+1 a line cannot begin with ="),
            ("%(1)=5", "S014 1:1+5 system variables are read-only; use VA"),
            ("Start: MX,1", "S013 1:7+5 the label START shares its line [a label stands alone"),
            ("___", "S003 1:1+3 unknown statement ___"),
        ] {
            finds(text, &[finding]);
        }
    }

    #[test]
    fn custom_cuts_have_three_spellings() {
        for text in ["C#,90", "C# 90", "CN,90", "CN 90", "cn, 90", "C90", "c90 'load", "CN,90,"] {
            check(text, "custom 90");
        }
        check("CN,&n+1", "custom (&N + 1)");
        finds("C9 &x", &["S004 1:4+2 '&x' does not belong here"]);
        finds("C3,1", &["S004 1:3+2 ',1' does not belong here"]);
    }

    #[test]
    fn gcode_lines_are_kept_as_they_are() {
        for line in [
            "G1X0.3Y-2.4F90",
            "G1 Z0.8 F60",
            "N10 G0 X1",
            "( New Path )",
            "%",
            "; text",
            "M30",
            "T1 M6",
            "X1 Y2",
            "S12000",
            "F60",
            "M3(spindle on)",
            "G0;rapid",
            "M30;end",
            "X1;2",
        ] {
            check(line, &format!("gcode {line}"));
        }
    }

    #[test]
    fn some_letters_do_not_begin_gcode() {
        finds("I5 J2", &["S002 1:1+2 unknown command I5"]);
        finds("MX1 Y2", &["S002 1:1+3 unknown command or missing separator: MX1"]);
    }

    #[test]
    fn case_and_blanks_mean_nothing() {
        check("  goto   done ⏎DONE:⏎ Goto Done", "goto DONE 2");
        check("eND", "end");
        check("End All", "endall");
        check("Exit ShopBot", "exitshopbot");
        check("warning OFF", "warningoff");
    }
}
