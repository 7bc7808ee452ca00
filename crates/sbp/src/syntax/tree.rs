//! The tree of a part file: one node a line.
//!
//! Most lines of a large file are moves with literal numbers. They become [`Node::Move`], eight
//! bytes that point into a pool of numbers; everything else becomes a [`Statement`].

use crate::syntax::table::CommandSpec;
use crate::syntax::{Dialect, Expr, Expressions, PathId};
use kerf_diag::{Diagnostic, SourcePlace};
use serde::{Deserialize, Serialize};
use std::ops::Index;
use std::sync::Arc;

/// A stretch of a line, in bytes from the start of the line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The whole line without blanks around it.
    pub const LINE: Self = Self { start: u32::MAX, end: u32::MAX };
}

/// Index into [`Program::names`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct NameId(pub u32);

/// A part file that was read.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Name shown to people.
    pub name: Arc<str>,
    /// The dialect it was read in.
    pub dialect: Dialect,
    /// The whole text, as it was read (line ends kept, byte-order mark removed).
    pub text: Arc<String>,
    /// One entry a line; line n of the file is `lines[n - 1]`.
    pub lines: Vec<LineNode>,
    /// The literal values of [`Node::Move`] lines, in order, only those given.
    pub numbers: Vec<f64>,
    /// Statements that [`Node::Statement`] points to.
    pub statements: Vec<Statement>,
    /// The values given to commands.
    pub args: Args,
    /// The operands of expressions.
    pub expressions: Expressions,
    /// Lines that are labels, in order.
    pub labels: Vec<Label>,
    /// The names of labels and of the targets of jumps.
    pub label_names: Vec<LabelName>,
    /// Variable names in capitals, without `&` or `$`.
    pub names: Vec<Arc<str>>,
    /// Everything wrong or doubtful, in order of lines.
    pub diagnostics: Vec<Diagnostic>,
    /// Language of its lines.
    pub language: Language,
}

/// Language of the lines of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Language {
    /// OpenSBP; single lines may be G-code.
    #[default]
    OpenSbp,
    /// G-code: only the name and the text are kept here.
    Gcode,
    /// G-code with lines of OpenSBP: a line that could be either is G-code.
    Mixed,
}

/// A line: what it is and where its text begins.
#[derive(Clone, Copy, Debug)]
pub struct LineNode {
    /// Kind of the line.
    pub node: Node,
    /// Byte offset of the line in [`Program::text`].
    pub start: u32,
}

/// Kind of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    /// Nothing.
    Blank,
    /// A full-line comment (`'` or REM).
    Comment,
    /// A label; index into [`Program::labels`].
    Label(u32),
    /// A move whose values are all literal numbers or blank.
    Move {
        /// Which one.
        command: MoveCommand,
        /// Bit i set: the i-th axis of the command has a value.
        given: u8,
        /// Index of its first value in [`Program::numbers`].
        first: u32,
    },
    /// Anything else; index into [`Program::statements`].
    Statement(u32),
    /// A line that cannot be read; its diagnostics say why.
    Bad,
}

impl Node {
    /// Returns `true` if it is a move of literal numbers.
    pub fn is_move(self) -> bool {
        matches!(self, Self::Move { .. })
    }
}

/// The commands that only move axes: MX … MC, M2 … M6 and their jogs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MoveCommand {
    /// Jog instead of move.
    pub jog: bool,
    /// First axis that takes a value.
    pub first: u8,
    /// Number of axes that take values.
    pub count: u8,
}

/// Index into [`Program::label_names`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LabelId(pub u32);

/// The name of a label, of a jump to it, or of both.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LabelName {
    /// In capitals, inner blanks single.
    pub name: Arc<str>,
    /// The first line with this label, from 1; `None` when no line has it.
    pub line: Option<u32>,
}

/// A line that is a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Label {
    /// Its name.
    pub name: LabelId,
    /// Its line, from 1.
    pub line: u32,
}

/// Target of a jump.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// The label.
    pub label: LabelId,
    /// Place of the name in its line.
    pub span: Span,
}

/// The values that stand behind a command: a stretch of [`Program::args`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ArgList {
    first: u32,
    count: u32,
}

/// The values given to all commands of a file.
#[derive(Clone, Debug, Default)]
pub struct Args(Vec<Arg>);

impl Args {
    /// Begins a list at the end.
    pub(crate) fn begin(&self) -> ArgList {
        ArgList { first: self.0.len() as u32, count: 0 }
    }

    /// Adds to the list begun last.
    pub(crate) fn push(&mut self, list: &mut ArgList, arg: Arg) {
        self.0.push(arg);
        list.count += 1;
    }

    /// Leaves blank values at the end of the list begun last out.
    pub(crate) fn trim(&mut self, list: &mut ArgList) {
        while list.count > 0 && self.0.last().is_some_and(|arg| arg.kind == ArgKind::Blank) {
            self.0.pop();
            list.count -= 1;
        }
    }
}

impl ArgList {
    /// Returns the number of values.
    pub fn len(self) -> usize {
        self.count as usize
    }

    /// True for no value.
    pub fn is_empty(self) -> bool {
        self.count == 0
    }
}

/// The values of a list; it must come from the same file.
impl Index<ArgList> for Args {
    type Output = [Arg];

    fn index(&self, list: ArgList) -> &[Arg] {
        &self.0[list.first as usize..][..list.count as usize]
    }
}

/// A value given to a command.
#[derive(Clone, Debug, PartialEq)]
pub struct Arg {
    /// Place of the value in its line.
    pub span: Span,
    /// The value as it was written.
    pub kind: ArgKind,
}

/// Value of a parameter as it was written.
#[derive(Clone, Debug, PartialEq)]
pub enum ArgKind {
    /// Nothing.
    Blank,
    /// An expression (also a single number or variable).
    Expr(Expr),
    /// A word or text as written, trimmed: a file name, `T`, `OFF`, `90R`, `3:00`.
    Word(Arc<str>),
}

/// Value of an assignment.
#[derive(Clone, Debug, PartialEq)]
pub enum Assigned {
    /// Nothing (`&x=`).
    Nothing,
    /// An expression.
    Expr(Expr),
    /// Unquoted text that is no expression, trimmed.
    Text(Arc<str>),
}

/// Manner in which the items of PRINT and WRITE are put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Separator {
    /// First separator is a comma (or there is none).
    Comma,
    /// First separator is a semicolon.
    Semicolon,
}

/// PRINT, PRINT #n and WRITE #n.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// File number for `#n`.
    pub file: Option<Expr>,
    /// WRITE instead of PRINT.
    pub write: bool,
    /// The items. In comma mode quoted text is already split at its commas.
    pub items: Vec<Expr>,
    /// Manner in which they are joined.
    pub separator: Separator,
    /// False after a trailing semicolon.
    pub newline: bool,
}

/// A part of dialog text: literal text or the value of a variable.
#[derive(Clone, Debug, PartialEq)]
pub enum TextPart {
    /// As written; `[&]` already replaced by `&`.
    Literal(Arc<str>),
    /// `&name` in the text; replaced when the variable is defined, else shown as written.
    Variable(NameId, Arc<str>),
}

/// Text of a dialog: an expression, or unquoted text with variables in it.
#[derive(Clone, Debug, PartialEq)]
pub enum DialogText {
    /// Quotes or a join: an expression.
    Expr(Expr),
    /// Unquoted text.
    Parts(Vec<TextPart>),
}

/// INPUT: text, default, variables.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Input {
    pub text: Option<Expr>,
    pub default: Option<Expr>,
    pub variables: Vec<NameId>,
    pub span: Span,
}

/// MSGBOX(body, style, title).
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct MsgBox {
    pub body: DialogText,
    pub style: DialogText,
    pub title: DialogText,
    pub span: Span,
}

/// SHELL, command line, display, ASYNC or SYNC.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Shell {
    pub line: DialogText,
    pub display: Option<Expr>,
    pub wait: bool,
    pub span: Span,
}

/// A box of FabMo's DIALOG and PAUSE.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Dialog {
    /// Its message.
    pub text: Expr,
    /// The variable that takes an answer.
    pub variable: Option<NameId>,
    /// TITLE, DETAIL, OKTEXT, CANCELTEXT: more words in it.
    pub title: Option<Expr>,
    pub detail: Option<Expr>,
    pub ok: Option<Expr>,
    pub cancel: Option<Expr>,
    /// TIMER: seconds after which it goes away by itself.
    pub seconds: Option<Expr>,
    pub span: Span,
}

/// The registry statements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Registry {
    SetUsrVal,
    SetUsrValClrd,
    SetSpindleStatus,
    GetUsrVal,
    GetUsrValClrd,
    GetSpindleStatus,
    GetUsrPath,
    GetAppPath,
    GetPartFileName,
}

/// Mode in which a file is opened; the same as [`kerf_program::FileMode`].
pub use kerf_program::FileMode;

/// Everything that is not a plain move.
///
/// Kept to a cache line: the large and rare ones are boxed.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub enum Statement {
    /// A two-letter command with its table entry.
    Command {
        spec: &'static CommandSpec,
        args: ArgList,
        span: Span,
    },
    /// `&a = …`, `$a = …`, `&a := …`.
    Assign {
        name: NameId,
        persistent: bool,
        only_if_undefined: bool,
        value: Assigned,
        span: Span,
    },
    /// `&a` alone on its line, which does nothing.
    Mention(Span),
    /// `&a[1].x = …` (FabMo).
    AssignMember {
        path: PathId,
        only_if_undefined: bool,
        value: Assigned,
        span: Span,
    },
    /// IF … THEN.
    If {
        condition: Expr,
        then: Box<Statement>,
    },
    Goto(Target),
    Gosub(Target),
    Return,
    End,
    EndAll,
    ExitShopbot,
    /// ON INPUT(switch, state) action.
    OnInput {
        switch: Expr,
        state: Expr,
        action: Option<Box<Statement>>,
    },
    /// PAUSE, PAUSE n.
    Pause {
        seconds: Option<Expr>,
    },
    PauseUntil {
        switch: Expr,
        state: Expr,
    },
    Output(Output),
    Input(Box<Input>),
    InputFile {
        file: Expr,
        variables: Vec<NameId>,
        span: Span,
    },
    MsgBox(Box<MsgBox>),
    Open {
        path: Expr,
        mode: FileMode,
        number: Expr,
    },
    Close(Option<Expr>),
    Play(DialogText),
    Shell(Box<Shell>),
    /// Set… with a value.
    Store {
        which: Registry,
        value: DialogText,
        span: Span,
    },
    /// Get… into a variable.
    Fetch {
        which: Registry,
        variable: NameId,
        span: Span,
    },
    WarningOff,
    /// DIALOG, or PAUSE with a text (FabMo).
    Dialog(Box<Dialog>),
    /// FAIL, FAIL text (FabMo).
    Fail(Option<Expr>),
    /// DATA_SEND and DATA_REQUEST, to a program beside the machine (FabMo).
    Data {
        request: bool,
        items: Vec<Expr>,
    },
    /// `C#,n`, `CN,n`, `Cn`: run CustomN.sbc.
    Custom {
        number: Expr,
        span: Span,
    },
    /// A line of G-code in a part file.
    Gcode(Arc<str>),
}

impl Program {
    /// The G-code among the lines, each at its place, everything else blank.
    pub fn gcode_text(&self) -> String {
        let mut text = String::with_capacity(self.text.len());
        for (node, number) in self.lines.iter().zip(1..) {
            if let Some(code) = self.gcode_of(node.node) {
                let line = self.line_text(number);
                let end = match self.language {
                    Language::Mixed => line.trim_end_matches(crate::syntax::reader::blank).len(),
                    _ => crate::syntax::reader::code_end(line.as_bytes()),
                };
                let before = line.get(..end.saturating_sub(code.len())).unwrap_or_default();
                text.extend(std::iter::repeat_n(' ', before.chars().count()));
                text.push_str(code);
            }
            text.push('\n');
        }
        text
    }

    /// Returns `true` if some lines are G-code.
    pub fn has_gcode(&self) -> bool {
        let gcode = |s: &Statement| matches!(s, Statement::Gcode(_));
        self.statements.iter().any(|s| s.with_inner().any(gcode))
    }

    fn gcode_of(&self, node: Node) -> Option<&str> {
        let Node::Statement(index) = node else { return None };
        self.statements.get(index as usize)?.with_inner().find_map(|s| match s {
            Statement::Gcode(code) => Some(&**code),
            _ => None,
        })
    }

    /// Text of a line without its line end.
    pub fn line_text(&self, line: u32) -> &str {
        let index = line.saturating_sub(1) as usize;
        let Some(this) = self.lines.get(index) else { return "" };
        let end = self.lines.get(index + 1).map_or(self.text.len(), |next| next.start as usize);
        self.text.get(this.start as usize..end).unwrap_or("").trim_end_matches(['\r', '\n'])
    }

    /// The name of a label.
    pub fn label_name(&self, label: LabelId) -> &str {
        self.label_names.get(label.0 as usize).map_or("", |label| &label.name)
    }

    /// The line that a jump goes to; `None` when no line has the label.
    pub fn line_of(&self, target: &Target) -> Option<u32> {
        self.label_names.get(target.label.0 as usize)?.line
    }

    /// The comment behind the code of a line; nothing for lines that are all comment.
    pub fn comment_beside(&self, line: u32) -> Option<&str> {
        let text = self.line_text(line);
        let (code, comment) =
            text.split_at_checked(crate::syntax::reader::code_end(text.as_bytes()))?;
        let comment = comment.trim().trim_start_matches('\'').trim();
        (!code.trim().is_empty() && !comment.is_empty()).then_some(comment)
    }

    /// The place of a span of a line, in characters.
    pub fn place(&self, line: u32, span: Span) -> SourcePlace {
        let text = self.line_text(line);
        let bytes = match span {
            Span::LINE => {
                (text.len() - text.trim_start().len()) as u32..text.trim_end().len() as u32
            }
            span => span.start..span.end,
        };
        SourcePlace::of_bytes(self.name.clone(), line, text, bytes)
    }

    /// True when something is wrong with the file.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(Diagnostic::is_error)
    }
}
