//! OPEN, CLOSE and reading from files.

use super::line::{Line, Read};
use crate::syntax::expr::{Expr, ExprNode};
use crate::syntax::tree::{FileMode, NameId, Span, Statement};
use kerf_diag::Code;

/// INPUT asks for, or reads, at most this many values.
const MOST_VARIABLES: usize = 10;

impl Line<'_, '_> {
    /// OPEN path FOR mode AS #n.
    pub(super) fn open(&mut self, start: usize) -> Read<Statement> {
        self.take(b',');
        let path = self.open_path(start)?;
        let mode = self.file_mode(start)?;
        if !self.take_word("AS") {
            return Err(self.open_form(start, "AS #n expected"));
        }
        self.take(b'#');
        let number = self.single_value()?;
        self.check_file_number(&number)?;
        self.expect_end()?;
        Ok(Statement::Open { path, mode, number })
    }

    fn open_form(&mut self, start: usize, message: &str) -> super::line::Failed {
        let span = Span { start: start as u32, end: self.end as u32 };
        let hint = "write OPEN \"name\" FOR OUTPUT AS #1";
        self.fault(Code::Syntax, span, message, hint)
    }

    /// A computed path, or one written without quotes up to FOR.
    fn open_path(&mut self, start: usize) -> Read<Expr> {
        self.skip_blanks();
        if matches!(self.peek(), b'"' | b'&' | b'$') {
            return self.expression();
        }
        let from = self.at;
        let rest = self.slice(from, self.end).to_ascii_uppercase();
        let Some(length) = rest.rfind(" FOR ") else {
            return Err(self.open_form(start, "FOR expected"));
        };
        self.at = from + length;
        let span = self.span_from(from);
        let text = self.slice(from, span.end as usize);
        Ok(self.text_at(text, span))
    }

    fn file_mode(&mut self, start: usize) -> Read<FileMode> {
        if !self.take_word("FOR") {
            return Err(self.open_form(start, "FOR expected"));
        }
        let modes = [
            ("INPUT", FileMode::Input),
            ("OUTPUT", FileMode::Output),
            ("APPEND", FileMode::Append),
        ];
        for (word, mode) in modes {
            if self.take_word(word) {
                return Ok(mode);
            }
        }
        Err(self.open_form(start, "INPUT, OUTPUT or APPEND expected"))
    }

    fn check_file_number(&mut self, number: &Expr) -> Read<()> {
        match number.node {
            ExprNode::Number(n) if n.fract() != 0.0 || !(1.0..=9.0).contains(&n) => {
                let message = "file numbers are 1 to 9";
                Err(self.fault(Code::FileNumber, number.span, message, "use a number from 1 to 9"))
            }
            _ => Ok(()),
        }
    }

    /// CLOSE, CLOSE #n.
    pub(super) fn close(&mut self) -> Read<Statement> {
        self.take(b',');
        self.take(b'#');
        self.skip_blanks();
        if self.at_end() {
            return Ok(Statement::Close(None));
        }
        let number = self.single_value()?;
        self.check_file_number(&number)?;
        self.trailing_commas();
        self.expect_end()?;
        Ok(Statement::Close(Some(number)))
    }

    /// INPUT #n, &a, &b; the cursor stands behind `#`.
    pub(super) fn input_file(&mut self, start: usize) -> Read<Statement> {
        let file = self.single_value()?;
        self.check_file_number(&file)?;
        if !self.take(b',') {
            self.take(b';');
        }
        let variables = self.variable_list(start, usize::MAX)?;
        Ok(Statement::InputFile { file, variables, span: self.span_from(start) })
    }

    /// `&a, &b …` up to the end of the code; at least one.
    pub(super) fn variable_list(&mut self, start: usize, most: usize) -> Read<Vec<NameId>> {
        let mut names = Vec::new();
        loop {
            while self.take(b',') {}
            self.skip_blanks();
            if self.at_end() {
                break;
            }
            let from = self.at;
            let name = self.variable_name()?;
            if names.len() == most.min(MOST_VARIABLES) && most != usize::MAX {
                let span = self.span_from(from);
                let message = "INPUT takes at most ten variables";
                let hint = "use a second INPUT";
                return Err(self.fault(Code::TooManyParameters, span, message, hint));
            }
            names.push(name);
            self.skip_blanks();
            if !self.at_end() && self.peek() != b',' {
                self.expect_end()?;
            }
        }
        if names.is_empty() {
            let span = self.span_from(start);
            let message = "a variable is expected";
            let hint = "name the variable that takes the value, as in INPUT \"Depth?\" &d";
            return Err(self.fault(Code::MissingParameter, span, message, hint));
        }
        Ok(names)
    }

    /// `&name`.
    pub(super) fn variable_name(&mut self) -> Read<NameId> {
        self.skip_blanks();
        let start = self.at;
        let end = self.word_end(start + 1);
        if self.peek() != b'&' || end == start + 1 {
            let span = self.span_to_end();
            let found: String = self.slice(start, self.end).chars().take(20).collect();
            let message = format!("a variable is expected, not '{found}'");
            return Err(self.fault(Code::Syntax, span, message, "variables begin with &"));
        }
        self.at = end;
        Ok(self.name(start + 1, end))
    }
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn files_are_opened_by_number() {
        for (text, tree) in [
            ("OPEN \"myfile.sbp\" FOR OUTPUT as #1", "open \"myfile.sbp\" Output 1"),
            ("OPEN &f for input AS #2", "open &F Input 2"),
            ("OPEN &p & \"\\out.txt\" FOR APPEND AS #&n", "open (&P & \"\\out.txt\") Append &N"),
            ("OPEN my file.txt FOR OUTPUT AS 3", "open \"my file.txt\" Output 3"),
            ("CLOSE", "close _"),
            ("CLOSE #1", "close 1"),
            ("close 2", "close 2"),
            ("INPUT #1, &a, &b", "input #1 &A &B"),
        ] {
            check(text, tree);
        }
        for (text, finding) in [
            ("OPEN \"a\" FOR OUTPUT AS #10", "F007 1:25+2 file numbers are 1 to 9"),
            ("OPEN \"a\" FOR OUTPUT AS #0", "F007 1:25+1"),
            ("OPEN \"a\" FOR OUTPUT", "S004 1:1+19 AS #n expected"),
            ("OPEN \"a\" FOR READING AS #1", "S004 1:1+26 INPUT, OUTPUT or APPEND expected"),
            ("OPEN \"a\" AS #1", "S004 1:1+14 FOR expected"),
            ("OPEN a AS #1", "S004 1:1+12 FOR expected"),
            ("CLOSE #x", "S004 1:8+1 a number is expected here"),
            ("INPUT #1", "S010 1:1+8 a variable is expected"),
        ] {
            finds(text, &[finding]);
        }
    }
}
