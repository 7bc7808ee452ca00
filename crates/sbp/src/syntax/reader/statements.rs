//! Finds the kind of statement that a line is.

use super::did_you_mean;
use super::file::is_label;
use super::line::{Failed, Line, Read, is_name};
use super::text::blank;
use crate::syntax::table;
use crate::syntax::tree::{Span, Statement};
use kerf_diag::Code;

macro_rules! keywords {
    ($($name:ident $text:literal)*) => {
        /// The words that begin statements.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Keyword { $($name,)* }
        impl Keyword {
            /// Every one.
            pub(crate) const ALL: &[(&'static str, Self)] = &[$(($text, Self::$name),)*];
            /// The keyword of a word in capitals.
            fn exact(word: &[u8]) -> Option<Self> {
                $(if word == $text.as_bytes() { return Some(Self::$name); })*
                None
            }
        }
    };
}

keywords! {
    If "IF" On "ON" End "END" Goto "GOTO" Open "OPEN" Play "PLAY" Exit "EXIT" Gosub "GOSUB"
    Pause "PAUSE" Print "PRINT" Input "INPUT" Write "WRITE" Close "CLOSE" Shell "SHELL"
    EndAll "ENDALL" Return "RETURN" MsgBox "MSGBOX" Warning "WARNING" SetUsrVal "SETUSRVAL"
    GetUsrVal "GETUSRVAL" GetUsrPath "GETUSRPATH" GetAppPath "GETAPPPATH"
    SetUsrValClrd "SETUSRVALCLRD" GetUsrValClrd "GETUSRVALCLRD"
    SetSpindleStatus "SETSPINDLESTATUS" GetSpindleStatus "GETSPINDLESTATUS"
    GetPartFileName "GETPARTFILENAME"
}

/// The words that begin statements, for editors.
pub fn statement_words() -> impl Iterator<Item = &'static str> {
    Keyword::ALL.iter().map(|(word, _)| *word)
}

impl Keyword {
    /// The keyword of a word, in any case.
    pub(crate) fn find(word: &str) -> Option<Self> {
        let mut capitals = [0; 16];
        let capitals = capitals.get_mut(..word.len())?;
        capitals.copy_from_slice(word.as_bytes());
        capitals.make_ascii_uppercase();
        Self::exact(capitals)
    }
}

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

impl Line<'_, '_> {
    /// A statement at the cursor; `inner` behind THEN or ON INPUT.
    pub(super) fn statement(&mut self, inner: bool) -> Read<Statement> {
        self.skip_blanks();
        let start = self.at;
        match self.peek() {
            b'&' => return self.assignment(false),
            b'$' => return self.assignment(true),
            b'%' | b'(' | b';' => return self.percent_or_code(start),
            b'#' if self.is_gcode_setting(start) => return Ok(self.gcode()),
            _ => {}
        }
        let end = self.word_end(start);
        let word = self.slice(start, end);
        let separated = self.separated(end);
        if word.len() == 2
            && separated
            && let Some(spec) = self.file.commands.find(word)
            && !self.is_gcode_words(start, word)
        {
            self.at = end;
            return self.command(spec, start);
        }
        if let Some(failed) = self.wrong_separator(start, end) {
            return Err(failed);
        }
        if let Some(keyword) = Keyword::find(word) {
            self.at = end;
            return self.keyword(keyword, start, inner);
        }
        self.at = end;
        if let Some(read) = self.fabmo(word, start) {
            return read;
        }
        self.at = start;
        if let Some(custom) = self.custom(start, end)? {
            return Ok(custom);
        }
        if self.is_gcode(start) {
            return Ok(self.gcode());
        }
        Err(self.o_word(start).unwrap_or_else(|| self.unknown(start, end)))
    }

    fn keyword(&mut self, keyword: Keyword, start: usize, inner: bool) -> Read<Statement> {
        match keyword {
            Keyword::If => self.if_then(start, inner),
            Keyword::On => self.on_input(start, inner),
            Keyword::Goto => Ok(Statement::Goto(self.target(start)?)),
            Keyword::Gosub => Ok(Statement::Gosub(self.target(start)?)),
            Keyword::Return => Ok(self.ended(Statement::Return)),
            Keyword::End => self.end_statement(start),
            Keyword::EndAll => Ok(self.ended(Statement::EndAll)),
            Keyword::Exit => {
                self.expect_word("SHOPBOT", start)?;
                Ok(self.ended(Statement::ExitShopbot))
            }
            Keyword::Warning => {
                self.expect_word("OFF", start)?;
                Ok(self.ended(Statement::WarningOff))
            }
            Keyword::Pause => self.pause(start),
            Keyword::Print => self.output(false),
            Keyword::Write => self.output(true),
            Keyword::Input => self.input(start),
            Keyword::MsgBox => self.msgbox(start),
            Keyword::Open => self.open(start),
            Keyword::Close => self.close(),
            Keyword::Play => self.play(start),
            Keyword::Shell => self.shell(start),
            registry => self.registry(registry, start),
        }
    }

    fn expect_word(&mut self, word: &str, start: usize) -> Read<()> {
        if self.take_word(word) {
            return Ok(());
        }
        let first = self.slice(start, self.word_end(start)).to_uppercase();
        let span = self.span_to_end();
        let message = format!("{first} {word} expected");
        Err(self.fault(Code::UnknownStatement, span, message, format!("write {first} {word}")))
    }

    /// `%(1)=5`, or a line of G-code that begins with %, ( or ;.
    fn percent_or_code(&mut self, start: usize) -> Read<Statement> {
        if self.peek() == b'%' {
            self.at = self.until(start, b')') + 1;
            if self.take(b'=') {
                let span = self.span_from(start);
                let hint = "use VA for locations and VS for speeds";
                let message = "system variables are read-only; use VA";
                return Err(self.fault(Code::ReadOnlyVariable, span, message, hint));
            }
            self.at = start;
        }
        Ok(self.gcode())
    }

    /// A custom cut: `C#,n`, `CN,n` or `Cn`.
    fn custom(&mut self, start: usize, end: usize) -> Read<Option<Statement>> {
        let word = self.slice(start, end);
        if !word.starts_with(['C', 'c']) {
            return Ok(None);
        }
        let rest = &word[1..];
        let listed = rest.eq_ignore_ascii_case("N") || (rest.is_empty() && self.byte(end) == b'#');
        let plain = !rest.is_empty() && rest.len() <= 5 && rest.bytes().all(|b| b.is_ascii_digit());
        let found = listed || (plain && self.separated(end));
        if !found {
            return Ok(None);
        }
        // `C1 X2` is G-code: an axis word and another one.
        if plain && self.is_gcode(start) && self.gcode_words(start) > 1 {
            return Ok(None);
        }
        self.at = if plain { start + 1 } else { end + usize::from(rest.is_empty()) };
        let number = if plain {
            self.single_value()?
        } else {
            self.take(b',');
            self.expression()?
        };
        self.trailing_commas();
        self.expect_end()?;
        Ok(Some(Statement::Custom { number, span: self.span_from(start) }))
    }

    /// Skips empty fields at the end of the code.
    pub(super) fn trailing_commas(&mut self) {
        let start = self.at;
        while self.take(b',') {}
        self.skip_blanks();
        if !self.at_end() {
            self.at = start;
        }
    }

    /// Returns `true` if the words at the cursor begin a statement or a command.
    pub(super) fn is_statement(&self) -> bool {
        let word = self.slice(self.at, self.word_end(self.at));
        Keyword::find(word).is_some() || self.file.commands.find(word).is_some()
    }

    fn unknown(&mut self, start: usize, end: usize) -> Failed {
        let word = self.slice(start, end);
        if let Some(label) = self.label_with_text(start) {
            return label;
        }
        if word.is_empty() {
            return self.unknown_sign(start);
        }
        let name = word.to_uppercase();
        let foreign = foreign_hint(&name);
        if foreign.is_none()
            && let Some(failed) = self.missing_separator(start, end)
        {
            return failed;
        }
        let span = Span { start: start as u32, end: end as u32 };
        let hint = foreign.unwrap_or_else(|| nearest(&name));
        let (code, kind) = if name.len() <= 2 || self.byte(end) == b',' {
            (Code::UnknownCommand, "command")
        } else {
            (Code::UnknownStatement, "statement")
        };
        self.fault(code, span, format!("unknown {kind} {name}"), hint)
    }

    fn unknown_sign(&mut self, start: usize) -> Failed {
        let found = self.slice(start, self.end).chars().next().unwrap_or(' ');
        let span = Span { start: start as u32, end: start as u32 + found.len_utf8() as u32 };
        let message = format!("a line cannot begin with {found}");
        self.fault(Code::UnknownStatement, span, message, "a comment begins with an apostrophe")
    }

    /// `Start: MX,1`: a label does not share its line.
    fn label_with_text(&mut self, start: usize) -> Option<Failed> {
        let colon = self.until(start, b':');
        let written = self.slice(start, colon).trim_end_matches(blank);
        if colon >= self.end || !is_label(written) || written.contains([' ', '\t']) {
            return None;
        }
        let span = Span { start: colon as u32 + 1, end: self.end as u32 };
        let message = format!("the label {} shares its line", written.to_uppercase());
        let hint = "a label stands alone; put the rest on the next line";
        Some(self.fault(Code::OneCommandPerLine, span, message, hint))
    }

    /// `M3;1,2` and `C9;`: a command with a wrong separator, which would be G-code with a comment otherwise. A
    /// parenthesis is a comment of G-code that follows a word without a blank.
    fn wrong_separator(&mut self, start: usize, end: usize) -> Option<Failed> {
        if end != start + 2 || self.separated(end) || self.byte(end) == b'(' {
            return None;
        }
        let custom = matches!(self.slice(start, end).as_bytes(), [b'C' | b'c', b'0'..=b'9']);
        if !custom || self.byte(end) != b';' {
            return self.missing_separator(start, end);
        }
        let span = self.span_to_end();
        let word = self.slice(start, end).to_uppercase();
        let message = format!("{word} is followed by ; and not by a comma or a blank");
        let hint =
            format!("write {word} for the custom cut, or G1 {word} for the axis C in G-code");
        Some(self.fault(Code::UnknownCommand, span, message, hint))
    }

    /// `M23, 4.2` and `MX-5`: letters of a command with a value right behind.
    fn missing_separator(&mut self, start: usize, end: usize) -> Option<Failed> {
        let letters = self.slice(start, (start + 2).min(end));
        let spec = self.file.commands.find(letters)?;
        let behind = self.byte(start + 2);
        if is_name(behind) && !behind.is_ascii_digit() {
            return None;
        }
        let value = self.slice(start + 2, self.field_end(start + 2));
        let value = value.split([' ', '\t']).next().unwrap_or(value);
        let stop = (start + 2 + value.len()) as u32;
        let span = Span { start: start as u32, end: stop };
        let word = self.slice(start, stop as usize).to_uppercase();
        let message = format!("unknown command or missing separator: {word}");
        let rest = self.slice(start + 2, self.end).trim_start_matches([';', ':', '.']).trim();
        let rest = if rest.is_empty() { String::new() } else { format!(",{rest}") };
        let hint = format!("write {}{rest}", spec.letters);
        Some(self.fault(Code::UnknownCommand, span, message, hint))
    }
}

/// The hint for a word of another language or dialect.
fn foreign_hint(name: &str) -> Option<String> {
    let find = |list: &[(&str, &'static str)]| list.iter().find(|(w, _)| *w == name).map(|f| f.1);
    let fabmo = || find(FABMO).map(super::fabmo::or_else);
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
        did_you_mean(name, statements)
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
