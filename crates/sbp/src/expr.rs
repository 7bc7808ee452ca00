//! Expressions as trees.

use crate::tree::{NameId, Span};
use std::sync::Arc;

/// An expression and where it stands in its line.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub node: ExprNode,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of expressions.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprNode {
    /// A literal number.
    Number(f64),
    /// Text in quotes.
    Text(Arc<str>),
    /// A bare word: text without quotes.
    Word(Arc<str>),
    /// A user variable, `&name`.
    Variable(NameId),
    /// A persistent variable, `$name`.
    Persistent(NameId),
    /// A system variable, `%(n)`.
    System(Box<Expr>),
    /// One operand.
    Unary(UnaryOp, Box<Expr>),
    /// Two operands.
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// A function of one argument; RND needs none.
    Call(Function, Option<Box<Expr>>),
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
    /// How tightly it binds; larger binds tighter. Unary minus stands at 9, NOT at 3.
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

    /// How it is written.
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
            /// How it is written.
            pub const fn name(self) -> &'static str { match self { $(Self::$name => $text,)* } }
            /// What it gives.
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
    Rnd "RND" "A random number from 0 up to 1; the same sequence in every run.";
}

impl Function {
    /// The function of a name, in any case.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|f| f.name().eq_ignore_ascii_case(name))
    }
}
