//! O-words: subroutines, branches and loops.

use super::expression::Reader;
use crate::syntax::expr::Expr;
use crate::syntax::gathered::Fault;
use crate::syntax::tree::{Flow, Keyword, Label};
use kerf_diag::Code;

/// The keywords as they are written, longer ones first.
const WRITTEN: [(&str, Keyword); 16] = [
    ("ENDWHILE", Keyword::Endwhile),
    ("ENDREPEAT", Keyword::Endrepeat),
    ("ENDSUB", Keyword::Endsub),
    ("ENDIF", Keyword::Endif),
    ("ELSEIF", Keyword::Elseif),
    ("ELSE", Keyword::Else),
    ("CONTINUE", Keyword::Continue),
    ("CALL", Keyword::Call),
    ("RETURN", Keyword::Return),
    ("REPEAT", Keyword::Repeat),
    ("BREAK", Keyword::Break),
    ("WHILE", Keyword::While),
    ("SUB", Keyword::Sub),
    ("DO", Keyword::Do),
    ("IF", Keyword::If),
    ("", Keyword::Program),
];

impl Reader<'_> {
    /// The rest of the line as an O-word.
    pub(super) fn flow(&mut self) -> Result<Flow, Fault> {
        let start = self.at;
        self.at += 1;
        let (label, computed) = self.label(start)?;
        let keyword = self.keyword(start)?;
        let mut values = Vec::new();
        while self.peek() == b'[' {
            values.push(self.bracket(0)?);
        }
        if !self.is_at_end() {
            let fault = self.fault_from(self.at, Code::BadFlow, "nothing may follow an O-word");
            return Err(fault.hint("values behind call, if, while and repeat stand in brackets"));
        }
        let span = self.span_from(start);
        let flow = Flow { label, computed, keyword, values, target: 0, end: 0, span };
        self.check_values(start, flow)
    }

    fn label(&mut self, start: usize) -> Result<(Option<Label>, Option<Expr>), Fault> {
        match self.peek() {
            b'<' => Ok((Some(Label::Name(self.bracketed_name()?.into())), None)),
            b'0'..=b'9' => {
                let digits =
                    self.compact.bytes[self.at..].iter().take_while(|b| b.is_ascii_digit());
                let count = digits.count();
                let text = String::from_utf8_lossy(&self.compact.bytes[self.at..self.at + count]);
                let Ok(number) = text.parse() else {
                    return Err(self.fault_from(start, Code::BadFlow, "the O number is too large"));
                };
                self.at += count;
                Ok((Some(Label::Number(number)), None))
            }
            b'#' | b'[' => Ok((None, Some(self.expect_primary(0)?))),
            _ => {
                let fault = self.fault_from(start, Code::BadFlow, "O without a number or name");
                Err(fault.hint("write O100 sub or O<name> sub"))
            }
        }
    }

    fn keyword(&mut self, start: usize) -> Result<Keyword, Fault> {
        let found = WRITTEN.into_iter().find(|(word, _)| self.eat(word));
        match found {
            Some((_, Keyword::Program)) if !self.is_at_end() => {
                let message = "no such O-word";
                let fault = self.fault_from(start, Code::BadFlow, message);
                let known = "sub endsub call return if elseif else endif while endwhile do repeat \
                             endrepeat break continue";
                Err(fault.hint(format!("O-words are {known}")))
            }
            Some((_, keyword)) => Ok(keyword),
            None => Ok(Keyword::Program),
        }
    }

    fn check_values(&self, start: usize, flow: Flow) -> Result<Flow, Fault> {
        let wanted = match flow.keyword {
            Keyword::If | Keyword::Elseif | Keyword::While | Keyword::Repeat => 1..=1,
            Keyword::Call => 0..=30,
            Keyword::Endsub | Keyword::Return => 0..=1,
            _ => 0..=0,
        };
        if wanted.contains(&flow.values.len()) {
            return Ok(flow);
        }
        let message = format!(
            "this O-word takes {} values in brackets, not {}",
            if wanted.start() == wanted.end() {
                wanted.start().to_string()
            } else {
                format!("up to {}", wanted.end())
            },
            flow.values.len()
        );
        Err(self.fault_from(start, Code::BadFlow, message))
    }
}
