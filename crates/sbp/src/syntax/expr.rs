//! Expressions as trees, their nodes side by side in one list a file.
//!
//! A statement holds the root of its expression; what stands inside lies in [`Expressions`] and is
//! pointed to by number. So reading an expression allocates nothing of its own, and a file is dropped
//! at once however many it has.

use crate::syntax::tree::{NameId, Span};
use std::ops::Index;
use std::sync::Arc;

/// Index of an operand in [`Expressions`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExprId(u32);

/// Index of a text in [`Expressions`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TextId(u32);

/// Index of a path in [`Expressions`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PathId(u32);

/// The operands and texts of all expressions of a file.
#[derive(Clone, Debug, Default)]
pub struct Expressions {
    operands: Vec<Expr>,
    texts: Vec<Arc<str>>,
    paths: Vec<Path>,
}

impl Expressions {
    /// Keeps an operand.
    pub(crate) fn add(&mut self, operand: Expr) -> ExprId {
        self.operands.push(operand);
        ExprId(self.operands.len() as u32 - 1)
    }

    /// Keeps a text.
    pub(crate) fn add_text(&mut self, text: &str) -> TextId {
        self.texts.push(text.into());
        TextId(self.texts.len() as u32 - 1)
    }

    /// Keeps a path.
    pub(crate) fn add_path(&mut self, path: Path) -> PathId {
        self.paths.push(path);
        PathId(self.paths.len() as u32 - 1)
    }
}

/// An operand; its number must come from the same file.
impl Index<ExprId> for Expressions {
    type Output = Expr;

    fn index(&self, id: ExprId) -> &Expr {
        &self.operands[id.0 as usize]
    }
}

/// A text; its number must come from the same file.
impl Index<TextId> for Expressions {
    type Output = Arc<str>;

    fn index(&self, id: TextId) -> &Arc<str> {
        &self.texts[id.0 as usize]
    }
}

/// A path; its number must come from the same file.
impl Index<PathId> for Expressions {
    type Output = Path;

    fn index(&self, id: PathId) -> &Path {
        &self.paths[id.0 as usize]
    }
}

/// An expression and where it stands in its line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Expr {
    /// Kind of the expression.
    pub node: ExprNode,
    /// Place of the expression in its line.
    pub span: Span,
}

/// The kinds of expressions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ExprNode {
    /// A literal number.
    Number(f64),
    /// Text in quotes.
    Text(TextId),
    /// A bare word: text without quotes.
    Word(TextId),
    /// A user variable, `&name`.
    Variable(NameId),
    /// A persistent variable, `$name`.
    Persistent(NameId),
    /// A system variable, `%(n)`.
    System(ExprId),
    /// One operand.
    Unary(UnaryOp, ExprId),
    /// Two operands.
    Binary(BinaryOp, ExprId, ExprId),
    /// A function of one argument; RND needs none.
    Call(Function, Option<ExprId>),
    /// A part of an array or object, `&a[n].name` (FabMo).
    Member(PathId),
}

/// Way to a part of an array or object (FabMo).
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// `$name` instead of `&name`.
    pub persistent: bool,
    /// The name before the first bracket or dot.
    pub name: NameId,
    /// Steps behind the name.
    pub steps: Vec<PathStep>,
}

/// One step of a [`Path`].
#[derive(Clone, Debug, PartialEq)]
pub enum PathStep {
    /// `[n]`
    Index(Expr),
    /// `[]`: the value for inches and the one for millimetres, `[0]` and `[1]`.
    BothUnits,
    /// `.name`, in capitals.
    Field(Arc<str>),
}

/// Operators with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum UnaryOp {
    Minus,
    Plus,
    Not,
}

/// Operators with two operands, tightest first (BASIC; all associate to the left).
///
/// `^`, unary minus, `* /`, `\`, `MOD`, `+ -`, `&` (join), comparisons, NOT, AND, OR.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum BinaryOp {
    Power,
    Multiply,
    Divide,
    IntegerDivide,
    Modulo,
    Add,
    Subtract,
    Join,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    And,
    Or,
}

impl BinaryOp {
    /// Returns the strength with which it binds; larger binds tighter. Unary minus stands at 9, NOT at 3.
    pub const fn precedence(self) -> u8 {
        match self {
            Self::Power => 10,
            Self::Multiply | Self::Divide => 8,
            Self::IntegerDivide => 7,
            Self::Modulo => 6,
            Self::Add | Self::Subtract => 5,
            Self::Join => 4,
            Self::Equal
            | Self::NotEqual
            | Self::Less
            | Self::LessEqual
            | Self::Greater
            | Self::GreaterEqual => 3,
            Self::And => 1,
            Self::Or => 0,
        }
    }

    /// Returns the operator as it is written.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Power => "^",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::IntegerDivide => "\\",
            Self::Modulo => "MOD",
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Join => "&",
            Self::Equal => "=",
            Self::NotEqual => "<>",
            Self::Less => "<",
            Self::LessEqual => "<=",
            Self::Greater => ">",
            Self::GreaterEqual => ">=",
            Self::And => "AND",
            Self::Or => "OR",
        }
    }
}

macro_rules! functions {
    ($($name:ident $text:literal $doc:literal;)*) => {
        /// The functions; angles are radians.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Function { $(#[doc = $doc] $name,)* }
        impl Function {
            /// Every function.
            pub const ALL: &[Self] = &[$(Self::$name,)*];
            /// Returns the function's name as it is written.
            pub const fn name(self) -> &'static str { match self { $(Self::$name => $text,)* } }
            /// Describes the value that it gives.
            pub const fn doc(self) -> &'static str { match self { $(Self::$name => $doc,)* } }
        }
    };
}

functions! {
    Sqr "SQR" "Square root.";
    Abs "ABS" "Value without its sign.";
    Int "INT" "Largest whole number not above the value.";
    Fix "FIX" "The whole part, towards zero.";
    Sgn "SGN" "-1, 0 or 1.";
    Exp "EXP" "e raised to the value.";
    Log "LOG" "Natural logarithm.";
    Sin "SIN" "Sine of an angle in radians.";
    Cos "COS" "Cosine of an angle in radians.";
    Tan "TAN" "Tangent of an angle in radians.";
    Atn "ATN" "Angle in radians whose tangent is the value.";
    Asin "ASIN" "Angle in radians whose sine is the value. An extension.";
    Acos "ACOS" "Angle in radians whose cosine is the value. An extension.";
    Atan "ATAN" "The same as ATN. An extension.";
    Sqrt "SQRT" "The same as SQR. An extension.";
    Round "ROUND" "Nearest whole number, halves away from 0. An extension.";
    Floor "FLOOR" "The same as INT. An extension.";
    Ceil "CEIL" "Smallest whole number not below the value. An extension.";
    Pi "PI" "The ratio of a circle's circumference to its diameter; it takes no value. An extension.";
    Rnd "RND" "A random number from 0 up to 1; the same sequence in every run.";
}

impl Function {
    /// The function of a name, in any case.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|f| f.name().eq_ignore_ascii_case(name))
    }
}
