//! Two-letter commands: looked up in the table, their values read by the kind of each parameter.

use super::line::{Failed, Line, Read, is_name};
use crate::syntax::Dialect;
use crate::syntax::expr::{Expr, ExprNode};
use crate::syntax::table::{self, CommandSpec, Default, Kind, ParamSpec};
use crate::syntax::tree::{Arg, ArgKind, ArgList, Span, Statement};
use kerf_diag::Code;

/// The commands by their letters, for one look instead of a search.
#[derive(Debug)]
pub(super) struct CommandIndex(Vec<Option<&'static CommandSpec>>);

impl CommandIndex {
    pub(super) fn new(dialect: Dialect) -> Self {
        let mut index = vec![None; 36 * 36];
        let own = table::fabmo::SPECS.iter().filter(|_| dialect == Dialect::Fabmo);
        for spec in table::tools::ADDED.iter().chain(table::commands()).chain(own) {
            let letters = spec.letters.as_bytes();
            if let (Some(a), Some(b)) = (letters.first(), letters.get(1))
                && let Some(slot) = slot(*a, *b)
            {
                index[slot] = Some(spec);
            }
        }
        // Both spellings of motors off are in use.
        if let (Some(zero), Some(letter)) = (slot(b'M', b'0'), slot(b'M', b'O')) {
            index[zero] = index[zero].or(index[letter]);
        }
        Self(index)
    }

    /// The command of a word, in any case.
    pub(super) fn find(&self, word: &str) -> Option<&'static CommandSpec> {
        let &[a, b] = word.as_bytes() else { return None };
        self.0[slot(a, b)?]
    }
}

fn slot(a: u8, b: u8) -> Option<usize> {
    let place = |byte: u8| match byte.to_ascii_uppercase() {
        letter @ b'A'..=b'Z' => Some(usize::from(letter - b'A')),
        digit @ b'0'..=b'9' => Some(usize::from(digit - b'0') + 26),
        _ => None,
    };
    Some(place(a)? * 36 + place(b)?)
}

impl Line<'_, '_> {
    /// The values of a command; the cursor stands right behind its letters.
    pub(super) fn command(&mut self, spec: &'static CommandSpec, start: usize) -> Read<Statement> {
        let head = self.span_from(start);
        if self.peek() == b',' {
            self.at += 1;
        }
        if spec.letters == "VV" {
            self.skip_blanks();
            if let sign @ (b'&' | b'$') = self.peek() {
                return self.assignment(sign == b'$');
            }
        }
        let (args, read) = self.arguments(spec);
        if !self.second_command {
            self.check_required(spec, args, head)?;
        }
        read?;
        let span = Span { start: start as u32, end: self.end as u32 };
        Ok(Statement::Command { spec, args, span })
    }

    /// Every field up to the end of the code, trailing blank ones left out; and whether all of them
    /// could be read.
    fn arguments(&mut self, spec: &CommandSpec) -> (ArgList, Read<()>) {
        let mut args = self.file.args.begin();
        let mut read = Ok(());
        while !self.at_end() && !self.second_command {
            let span = self.field();
            self.at += 1;
            match spec.params.get(args.len()) {
                Some(param) => {
                    let arg = self.argument(param, span).unwrap_or_else(|failed| {
                        read = Err(failed);
                        unreadable(span)
                    });
                    self.file.args.push(&mut args, arg);
                }
                None if span.start == span.end => {}
                None => {
                    read = Err(self.surplus(spec, span));
                    break;
                }
            }
        }
        self.at = self.end;
        self.file.args.trim(&mut args);
        (args, read)
    }

    fn argument(&mut self, param: &ParamSpec, span: Span) -> Read<Arg> {
        let kind = if span.start == span.end {
            ArgKind::Blank
        } else {
            match param.kind {
                Kind::Number(_) | Kind::NumberOrOff(_) | Kind::Whole | Kind::OneOf(_) => {
                    ArgKind::Expr(self.whole_expression(span)?)
                }
                Kind::Text => self.text_argument(span)?,
                Kind::File | Kind::Word(_) | Kind::AxisLetter | Kind::Obsolete => {
                    self.computed_argument(span)?
                }
            }
        };
        Ok(match kind {
            ArgKind::Expr(Expr { node: ExprNode::Word(word), .. }) => {
                let word = self.file.expressions[word].clone();
                Arg { span, kind: ArgKind::Word(word) }
            }
            kind => Arg { span, kind },
        })
    }

    /// Words and file names are taken as written unless they begin like something computed.
    fn computed_argument(&mut self, span: Span) -> Read<ArgKind> {
        let text = self.slice(span.start as usize, span.end as usize);
        if text.starts_with(['"', '&', '$', '%']) {
            return Ok(ArgKind::Expr(self.whole_expression(span)?));
        }
        Ok(ArgKind::Word(text.into()))
    }

    /// Text is computed where all of it can be, and taken as written otherwise.
    fn text_argument(&mut self, span: Span) -> Read<ArgKind> {
        let mark = self.mark();
        let computed = self.whole_expression(span);
        let text = self.slice(span.start as usize, span.end as usize);
        match computed {
            Ok(expr) if !self.file.expressions.has_words(&expr) => return Ok(ArgKind::Expr(expr)),
            // A number and then a command: a comma or a line end was forgotten.
            Err(failed) if self.second_command && !text.starts_with(char::is_alphabetic) => {
                return Err(failed);
            }
            _ => {}
        }
        self.forget(mark);
        self.second_command = false;
        Ok(ArgKind::Word(text.into()))
    }

    /// A field behind the last parameter may only be blank.
    fn surplus(&mut self, spec: &CommandSpec, span: Span) -> Failed {
        let takes = match spec.params.len() {
            0 => "no values".to_string(),
            1 => "1 value".to_string(),
            n => format!("{n} values"),
        };
        let message = format!("{} takes {takes}, this is one too many", spec.letters);
        self.fault(Code::TooManyParameters, span, message, "leave it out, or check the commas")
    }

    fn check_required(&mut self, spec: &CommandSpec, args: ArgList, head: Span) -> Read<()> {
        let mut result = Ok(());
        for (index, param) in spec.params.iter().enumerate() {
            let arg = self.file.args[args].get(index);
            let blank = arg.is_none_or(|a| a.kind == ArgKind::Blank);
            if blank && param.default == Default::Required {
                let message = format!("{} expected", param.name.to_lowercase());
                let span = arg.map_or(head, |a| a.span);
                let hint = format!("{} needs this value, it has no default", spec.letters);
                result = Err(self.fault(Code::MissingParameter, span, message, hint));
            }
        }
        result
    }

    /// Returns `true` if the code at the cursor begins with a command and its separator.
    pub(super) fn is_command(&self, at: usize) -> bool {
        let end = self.word_end(at);
        self.separated(end) && self.file.commands.find(self.slice(at, end)).is_some()
    }

    /// Behind a value: nothing may follow. Says what is wrong when something does.
    pub(super) fn expect_end(&mut self) -> Read<()> {
        self.skip_blanks();
        if self.at_end() {
            return Ok(());
        }
        let span = self.span_to_end();
        if self.is_command(self.at) || (is_name(self.peek()) && self.is_statement()) {
            self.second_command = true;
            let hint = "put it on a line of its own";
            return Err(self.fault(Code::OneCommandPerLine, span, "a second command", hint));
        }
        let found = self.slice(span.start as usize, span.end as usize);
        let shown: String = found.chars().take(20).collect();
        let hint = match found.as_bytes().first() {
            Some(b'0'..=b'9' | b'.' | b'&' | b'%' | b'-') => "values are separated by commas",
            Some(b';' | b'#' | b'/' | b'(') => "a comment begins with an apostrophe",
            _ if found.get(..4).is_some_and(|word| word.eq_ignore_ascii_case("ELSE")) => {
                "there is no ELSE: write another IF for the other case, or GOTO past it"
            }
            _ => "",
        };
        Err(self.fault(Code::Syntax, span, format!("'{shown}' does not belong here"), hint))
    }
}

/// Stands for an argument whose diagnostics are told already.
fn unreadable(span: Span) -> Arg {
    Arg { span, kind: ArgKind::Word("".into()) }
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn separators_follow_the_handbook() {
        for (text, tree) in [
            ("M2,  &a, 4.2", "M2 &A 4.2"),
            ("M2  &a, 4.2", "M2 &A 4.2"),
            ("M2\t&a,4", "M2 &A 4"),
            ("M2,, &a", "M2 _ &A"),
            ("M2 , &a", "M2 _ &A"),
            (
                "M2 ,, &a",
                "bad S009 1:7+2 M2 takes 2 values, this is one too many [leave it out, or check the commas]",
            ),
            ("M2, &a", "M2 &A"),
            ("M2 -&a,4", "M2 (-&A) 4"),
            ("m3,&a,,", "M3 &A"),
            ("ZX,", "ZX"),
            ("ZX , ,", "ZX"),
            ("  zx  'comment", "ZX"),
        ] {
            check(text, tree);
        }
    }

    #[test]
    fn too_many_and_too_few_values() {
        finds("ZX,1", &["S009 1:4+1 ZX takes no values, this is one too many"]);
        finds("MX,1,2", &["S009 1:6+1 MX takes 1 value, this is one too many"]);
        finds("MX,1,2,3", &["S009 1:6+1"]);
        finds("MX , 1", &["S009 1:6+1", "S010 1:1+2 value expected"]);
        finds("MX", &["S010 1:1+2 value expected"]);
        finds("MX,", &["S010 1:1+2 value expected"]);
    }

    #[test]
    fn vv_is_an_assignment() {
        check("VV,&a=5+1", "&A = (5 + 1)");
        check("vv $a := x", "$A := 'x'");
        finds("VV", &["S010 1:1+2 assignment expected"]);
    }

    #[test]
    fn one_command_a_line() {
        finds("MX,1 MY,2", &["S013 1:6+2 a second command"]);
        finds("MD,10,90 MX,1", &["S013 1:10+2 a second command"]);
        finds("M2,&a,1 GOTO X", &["S013 1:9+6 a second command"]);
        finds(
            "MX,1 ; up",
            &["S004 1:6+4 '; up' does not belong here [a comment begins with an apostrophe]"],
        );
        finds(
            "IF 1=1 THEN MX,1 ELSE JX,2",
            &[
                "S004 1:18+7 'ELSE JX' does not belong here [there is no ELSE: write another IF",
                "S009 1:26+1",
            ],
        );
        finds("M2 3 4", &["S004 1:6+1 '4' does not belong here [values are separated by commas]"]);
    }
}
