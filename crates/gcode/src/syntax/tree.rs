//! The tree of a G-code file: one node a line.
//!
//! Most lines of a large file are moves with literal numbers. Of these hardly more than the text is kept: it
//! is read again ([`Program::move_of`]) when the move is made. Everything else becomes a [`Block`].

use super::codes;
use super::expr::Expr;
use super::lines::Lines;
use super::moves;
use super::text::next_line;
use kerf_diag::{Diagnostic, SourcePlace};
use std::collections::BTreeMap;
use std::sync::Arc;

pub use super::node::{LineNode, Node};
pub use super::plain_move::PlainMove;

/// A stretch of a line, in bytes from the start of the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

/// A G-code file that was read.
#[derive(Debug, Default)]
pub struct Program {
    /// Name shown to people.
    pub name: Arc<str>,
    /// The whole text, as it was read (line ends kept, byte-order mark removed).
    pub text: Arc<String>,
    /// Kinds and beginnings of all lines: see [`Program::line`].
    pub(crate) lines: Lines,
    /// Blocks that [`Node::Block`] points to.
    pub blocks: Vec<Block>,
    /// The words of all blocks, in order.
    pub words: Vec<Word>,
    /// Parts of blocks beside words.
    pub extras: Vec<Extra>,
    /// Expressions that words point to.
    pub exprs: Vec<Expr>,
    /// Names of parameters, in small letters.
    pub names: Vec<Arc<str>>,
    /// Subroutines: the line (from 1) that defines each.
    pub subs: BTreeMap<Label, u32>,
    /// Everything wrong or doubtful, in order of lines.
    pub diagnostics: Vec<Diagnostic>,
}

/// A block: a line of words.
#[derive(Clone, Copy, Debug)]
pub struct Block {
    /// Its words in [`Program::words`].
    pub words: (u32, u32),
    /// Index into [`Program::extras`].
    pub extra: Option<u32>,
    /// Level of block delete, 0 for none.
    pub delete: u8,
    /// Some word is an expression.
    pub computed: bool,
}

/// A letter and its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Word {
    /// The letter, a capital, or `@`, `^` or `$`.
    pub letter: u8,
    /// Place of the word in its line.
    pub span: Span,
    /// Its value.
    pub value: Value,
}

/// The value of a word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// As written.
    Number(f64),
    /// Index into [`Program::exprs`].
    Computed(u32),
}

/// Parts of a block beside words.
#[derive(Clone, Debug, Default)]
pub struct Extra {
    /// Parameters that are set after everything was read.
    pub settings: Vec<Setting>,
    /// The O-word.
    pub flow: Option<Flow>,
    /// Comments in order.
    pub comments: Vec<Comment>,
}

/// `#… = …`
#[derive(Clone, Debug)]
pub struct Setting {
    /// The parameter that is set.
    pub target: Target,
    /// The new value.
    pub value: Expr,
    /// Its place in the line.
    pub span: Span,
}

/// A parameter that can be set.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// By number.
    Numbered(Expr),
    /// By name; index into [`Program::names`].
    Named(u32),
}

/// A comment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Comment {
    /// Its request.
    pub kind: CommentKind,
    /// Its text.
    pub text: Arc<str>,
}

/// Request that a comment makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommentKind {
    /// Nothing.
    Plain,
    /// Shown to the operator as it is.
    Msg,
    /// Printed, parameters replaced.
    Print,
    /// Shown to the operator, parameters replaced.
    Debug,
    /// Ends the program as a mistake does; the text is the reason, parameters replaced.
    Abort,
    /// For a log file: not carried out.
    Log,
}

/// The name of a subroutine or a loop.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Label {
    /// A number.
    Number(u32),
    /// A name in small letters.
    Name(Arc<str>),
}

/// An O-word.
#[derive(Clone, Debug)]
pub struct Flow {
    /// Its label; `None` when computed.
    pub label: Option<Label>,
    /// The expression of a computed label.
    pub computed: Option<Expr>,
    /// Its effect.
    pub keyword: Keyword,
    /// Values in brackets behind it.
    pub values: Vec<Expr>,
    /// Line (from 1) where this goes when it does not go on; 0 for none. See [`Keyword`].
    pub target: u32,
    /// For `elseif` and `else`: the line of `endif`. For `break`: the last line of its loop.
    pub end: u32,
    /// Its place in the line.
    pub span: Span,
}

/// Effect of an O-word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keyword {
    /// Begins a subroutine; target: its `endsub`.
    Sub,
    /// Ends a subroutine.
    Endsub,
    /// Calls a subroutine.
    Call,
    /// Leaves a subroutine.
    Return,
    /// Begins a loop; target: its `endwhile`.
    While,
    /// Ends a loop; target: its `while`.
    Endwhile,
    /// Begins a loop that runs at least once.
    Do,
    /// Ends a `do`; target: its `do`.
    DoWhile,
    /// Target: the next branch, or `endif`.
    If,
    /// Target: the next branch, or `endif`.
    Elseif,
    /// Target: `endif`.
    Else,
    /// Ends an `if`.
    Endif,
    /// Begins a counted loop; target: its `endrepeat`.
    Repeat,
    /// Ends a counted loop; target: its `repeat`.
    Endrepeat,
    /// Leaves a loop; target: its first line, end: its last.
    Break,
    /// Goes on with a loop's next turn; target: its first line, end: its last.
    Continue,
    /// `O12` alone: the name of a program or of a subroutine for M98.
    Program,
}

impl Keyword {
    /// As it is written; nothing for the name of a program.
    pub const fn written(self) -> &'static str {
        match self {
            Self::Sub => "sub",
            Self::Endsub => "endsub",
            Self::Call => "call",
            Self::Return => "return",
            Self::While | Self::DoWhile => "while",
            Self::Endwhile => "endwhile",
            Self::Do => "do",
            Self::If => "if",
            Self::Elseif => "elseif",
            Self::Else => "else",
            Self::Endif => "endif",
            Self::Repeat => "repeat",
            Self::Endrepeat => "endrepeat",
            Self::Break => "break",
            Self::Continue => "continue",
            Self::Program => "",
        }
    }
}

impl Program {
    /// Returns the number of lines of the file.
    pub const fn line_count(&self) -> u32 {
        self.lines.len()
    }

    /// A line, counted from 1.
    pub fn line(&self, line: u32) -> Option<LineNode> {
        self.lines.get(&self.text, line.checked_sub(1)?)
    }

    /// The text of a line, counted from 1, without its line end.
    pub fn line_text(&self, line: u32) -> &str {
        let Some(node) = self.line(line) else { return "" };
        let end = next_line(self.text.as_bytes(), node.start as usize);
        let whole = self.text.get(node.start as usize..end).unwrap_or_default();
        whole.trim_end_matches(['\r', '\n'])
    }

    /// The code of a line, counted from 1: blanks around it left out.
    pub(crate) fn code_of(&self, line: u32) -> Span {
        let text = self.line_text(line);
        let code = text.trim_start();
        Span { start: (text.len() - code.len()) as u32, end: text.trim_end().len() as u32 }
    }

    /// The move of a line, counted from 1, that is a [`Node::Move`].
    pub fn move_of(&self, line: u32) -> Option<PlainMove> {
        let node = self.line(line).filter(|l| l.node() == Node::Move)?;
        let mut found = PlainMove::default();
        moves::read(self.text.as_bytes(), node.start as usize, &mut found)?;
        Some(found)
    }

    /// The place of a stretch of a line.
    pub fn place(&self, line: u32, span: Span) -> SourcePlace {
        SourcePlace::of_bytes(self.name.clone(), line, self.line_text(line), span.start..span.end)
    }

    /// Returns `true` if a line (from 1) lies between the first and the last of a subroutine.
    pub fn is_in_subroutine(&self, line: u32) -> bool {
        let end_of = |first: u32| {
            let Node::Block(index) = self.line(first)?.node() else {
                return None;
            };
            let extra = self.extra_of(self.blocks.get(index as usize)?)?;
            extra.flow.as_ref().filter(|f| f.keyword == Keyword::Sub).map(|f| f.target)
        };
        let holds = |first: &u32| *first < line && end_of(*first).is_some_and(|end| line <= end);
        self.subs.values().any(holds)
    }

    /// True when something is wrong with the file.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }

    /// Returns `true` if it says somewhere that its numbers are inches or millimetres.
    pub fn says_its_unit(&self) -> bool {
        self.words.iter().any(|word| match word.value {
            Value::Number(code) if word.letter == b'G' => {
                codes::g_group((code * 10.0).round() as i32) == Some(codes::UNITS)
            }
            _ => false,
        })
    }

    /// The words of a block.
    pub fn words_of(&self, block: &Block) -> &[Word] {
        self.words.get(block.words.0 as usize..block.words.1 as usize).unwrap_or_default()
    }

    /// Returns the parts of a block beside words.
    pub fn extra_of(&self, block: &Block) -> Option<&Extra> {
        self.extras.get(block.extra? as usize)
    }
}

impl std::fmt::Display for Label {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(n) => write!(f, "O{n}"),
            Self::Name(name) => write!(f, "O<{name}>"),
        }
    }
}
