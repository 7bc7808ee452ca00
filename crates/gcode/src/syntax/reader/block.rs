//! One block: its words, the parameters it sets, its O-word.

use super::compact::Compact;
use super::expression::Reader;
use super::file::File;
use super::foreign::{looks_like_fanuc, looks_like_opensbp};
use crate::syntax::gathered::{Fault, Gathered};
use crate::syntax::tree::{Block, Extra, Node, Setting, Span, Target, Value, Word};
use kerf_diag::{Code, Severity};

impl File {
    /// Reads a line that is no plain move.
    pub(super) fn block(&mut self, compact: &mut Compact, text: &str) -> Node {
        let first = self.words.len();
        match self.read_block(compact) {
            Ok((delete, extra)) => {
                self.doubt(compact);
                self.keep(compact, first, delete, extra)
            }
            Err(fault) => {
                self.words.truncate(first);
                self.bad(fault, text)
            }
        }
    }

    fn bad(&mut self, mut fault: Fault, text: &str) -> Node {
        let fanuc = looks_like_fanuc(text.trim_start_matches(['/', ' ', '\t']));
        if fanuc {
            fault.message = "this is Fanuc's macro language".into();
            fault.hint = "Kerf knows LinuxCNC's: O100 while [#1 LT 5] … O100 endwhile, O101 if [#1 EQ 2] … O101 endif".into();
        } else if looks_like_opensbp(text) {
            self.is_foreign();
            fault.hint = "this looks like a line of OpenSBP; part files end in .sbp".into();
        }
        self.fault(fault);
        Node::Bad
    }

    fn read_block(&mut self, compact: &mut Compact) -> Result<(u8, Extra), Fault> {
        let comments = std::mem::take(&mut compact.comments);
        let mut extra = Extra { comments, ..Extra::default() };
        let mut reader = Reader::new(compact, self);
        let delete = reader.block_delete();
        while !reader.is_at_end() {
            match reader.peek() {
                b'O' if reader.file.words_are_only_n(reader.first_word) => {
                    extra.flow = Some(reader.flow()?);
                    break;
                }
                b'#' => extra.settings.push(reader.setting()?),
                _ => reader.word()?,
            }
        }
        Ok((delete, extra))
    }

    fn words_are_only_n(&self, first: usize) -> bool {
        self.words.get(first..).unwrap_or_default().iter().all(|w| w.letter == b'N')
    }

    fn keep(&mut self, compact: &Compact, first: usize, delete: u8, extra: Extra) -> Node {
        let words = self.words.get(first..).unwrap_or_default().to_vec();
        let computed = words.iter().any(|w| matches!(w.value, Value::Computed(_)));
        let mut faults = Vec::new();
        let unknown = |word: &Word| match word.value {
            Value::Number(n) => Ok(n),
            Value::Computed(_) => Ok(f64::NAN),
        };
        let gathered = Gathered::of(&words, unknown, |f| faults.push(f));
        gathered.needs(compact.whole(), &mut |f| faults.push(f));
        if !faults.is_empty() {
            faults.into_iter().for_each(|f| self.fault(f));
            self.words.truncate(first);
            return Node::Bad;
        }
        let held = !extra.comments.is_empty() || !extra.settings.is_empty() || extra.flow.is_some();
        let extra = held.then(|| {
            self.extras.push(extra);
            self.extras.len() as u32 - 1
        });
        let words = (first as u32, self.words.len() as u32);
        self.blocks.push(Block { words, extra, delete, computed });
        Node::Block(self.blocks.len() as u32 - 1)
    }

    /// Reports what is accepted, but may not be meant.
    fn doubt(&mut self, compact: &Compact) {
        if let Some(at) = compact.gap {
            let span = Span { start: at, end: at + 1 };
            let message = "a number goes on behind a blank or a comment";
            let hint = "blanks mean nothing in G-code; is a letter missing here?";
            self.fault(Fault::new(Code::BlankInNumber, span, message).hint(hint));
        }
        if let Some(at) = compact.nested {
            let span = Span { start: at, end: at + 1 };
            let message = "a comment within a comment";
            let hint = "most controllers end the comment at the first )";
            let fault = Fault::new(Code::DoubtfulSpelling, span, message).hint(hint);
            self.note(fault, Severity::Warning);
        }
    }
}

impl Reader<'_> {
    /// `/` at the start of the line, perhaps with a level.
    fn block_delete(&mut self) -> u8 {
        if self.peek() != b'/' {
            return 0;
        }
        self.at += 1;
        let digit = self.peek();
        if digit.is_ascii_digit() && !self.peek_at(1).is_ascii_digit() {
            self.at += 1;
            return (digit - b'0').max(1);
        }
        1
    }

    /// A letter and its value.
    fn word(&mut self) -> Result<(), Fault> {
        let start = self.at;
        let letter = self.peek();
        if !(letter.is_ascii_uppercase() || matches!(letter, b'@' | b'^' | b'$')) {
            let message = if letter.is_ascii_graphic() {
                format!("'{}' begins no word", letter as char)
            } else {
                "this character begins no word".into()
            };
            let decimal = letter == b','
                && start > 0
                && self.compact.byte(start - 1).is_ascii_digit()
                && self.peek_at(1).is_ascii_digit();
            let hint = if decimal {
                "decimals stand behind a point: write 1.5 for 1,5"
            } else {
                "a block is made of letters with numbers, as in G1 X10.5"
            };
            return Err(self.fault_from(start, Code::BadBlock, message).hint(hint));
        }
        if letter == b'O' {
            let message = "an O-word stands alone on its line";
            return Err(self.fault_from(start, Code::BadFlow, message));
        }
        self.at += 1;
        let Some(value) = self.value()? else {
            let message = format!("{} without a number", letter as char);
            let fault = self.fault_from(start, Code::NoNumber, message);
            return Err(
                fault.hint("a letter is followed by a number, a parameter or [an expression]")
            );
        };
        self.no_exponent(letter, start)?;
        let span = self.compact.span(start, self.at);
        self.file.words.push(Word { letter, span, value });
        Ok(())
    }

    /// Numbers have no exponents: X1e-5 would be X1, with an E that nobody asked for.
    fn no_exponent(&mut self, letter: u8, start: usize) -> Result<(), Fault> {
        let is_number = self.compact.byte(self.at.wrapping_sub(1)).is_ascii_digit();
        let sign = usize::from(matches!(self.peek_at(1), b'-' | b'+'));
        let exponent = self.peek() == b'E' && self.peek_at(1 + sign).is_ascii_digit();
        if !(is_number && exponent && b"XYZABCIJKRFS".contains(&letter)) {
            return Ok(());
        }
        let place = self.compact.span(self.at, self.at + 1).start;
        if place > self.compact.span(self.at - 1, self.at).end {
            self.at += 2 + sign;
            let message = "E behind a blank is neither an exponent nor a word of a cut";
            let hint = "printers have E for their plastic; Kerf does not run their files";
            return Err(self.fault_from(start, Code::BadBlock, message).hint(hint));
        }
        self.at += 2 + sign;
        let fault = self.fault_from(start, Code::BadBlock, "a number with an exponent");
        Err(fault.hint("G-code has none: write 0.00001 for 1e-5"))
    }

    /// `#… = …`
    fn setting(&mut self) -> Result<Setting, Fault> {
        let start = self.at;
        self.at += 1;
        let target = match self.parameter_name()? {
            Some(id) => Target::Named(id),
            None => Target::Numbered(self.expect_primary(0)?),
        };
        if self.peek() != b'=' {
            let fault = self.fault_from(start, Code::BadBlock, "= expected behind the parameter");
            return Err(fault.hint("a parameter alone on a line means nothing; write #1=5"));
        }
        self.at += 1;
        let value = self.expect_primary(0)?;
        if !self.is_at_end() && matches!(self.peek(), b'+' | b'-' | b'*' | b'/') {
            let fault = self.fault_from(start, Code::BadBlock, "a calculation without brackets");
            return Err(fault.hint("calculations stand in brackets: #1 = [#1 + 1]"));
        }
        Ok(Setting { target, value, span: self.compact.span(start, self.at) })
    }
}
