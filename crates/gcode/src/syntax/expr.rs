//! Expressions and how they are calculated.

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Expr {
    /// A number.
    Number(f64),
    /// `#…`: a parameter by number.
    Numbered(Box<Expr>),
    /// `#<…>`: a parameter by name; index into [`Program::names`](crate::syntax::tree::Program::names).
    Named(u32),
    /// `EXISTS[#<…>]`
    Exists(u32),
    /// A function of one value.
    Call(Function, Box<Expr>),
    /// `ATAN[y]/[x]`
    Atan(Box<Expr>, Box<Expr>),
    /// Two values and an operator.
    Binary(Operator, Box<Expr>, Box<Expr>),
}

/// Functions of one value; angles are degrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Function {
    Negate,
    Abs,
    Acos,
    Asin,
    Cos,
    Exp,
    Fix,
    Fup,
    Ln,
    Round,
    Sin,
    Sqrt,
    Tan,
}

impl Function {
    /// The functions by name.
    pub const NAMED: [(&'static str, Self); 12] = [
        ("ABS", Self::Abs),
        ("ACOS", Self::Acos),
        ("ASIN", Self::Asin),
        ("COS", Self::Cos),
        ("EXP", Self::Exp),
        ("FIX", Self::Fix),
        ("FUP", Self::Fup),
        ("LN", Self::Ln),
        ("ROUND", Self::Round),
        ("SIN", Self::Sin),
        ("SQRT", Self::Sqrt),
        ("TAN", Self::Tan),
    ];

    /// Its value; not finite where it has none.
    pub fn of(self, x: f64) -> f64 {
        match self {
            Self::Negate => -x,
            Self::Abs => x.abs(),
            Self::Acos => x.acos().to_degrees(),
            Self::Asin => x.asin().to_degrees(),
            Self::Cos => x.to_radians().cos(),
            Self::Exp => x.exp(),
            Self::Fix => x.floor(),
            Self::Fup => x.ceil(),
            Self::Ln => x.ln(),
            Self::Round => x.round(),
            Self::Sin => x.to_radians().sin(),
            Self::Sqrt => x.sqrt(),
            Self::Tan => x.to_radians().tan(),
        }
    }
}

/// Operators of two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Operator {
    Power,
    Times,
    Over,
    Mod,
    Plus,
    Minus,
    Eq,
    Ne,
    Gt,
    Ge,
    Lt,
    Le,
    And,
    Or,
    Xor,
}

/// Values closer than this count as equal in EQ and NE (LinuxCNC's tolerance).
const SAME: f64 = 1e-6;

impl Operator {
    /// The operators as they are written, longer ones first.
    pub const WRITTEN: [(&'static str, Self); 15] = [
        ("**", Self::Power),
        ("MOD", Self::Mod),
        ("AND", Self::And),
        ("XOR", Self::Xor),
        ("OR", Self::Or),
        ("EQ", Self::Eq),
        ("NE", Self::Ne),
        ("GT", Self::Gt),
        ("GE", Self::Ge),
        ("LT", Self::Lt),
        ("LE", Self::Le),
        ("*", Self::Times),
        ("/", Self::Over),
        ("+", Self::Plus),
        ("-", Self::Minus),
    ];

    /// Returns the strength with which it binds, from 1.
    pub const fn strength(self) -> u8 {
        match self {
            Self::And | Self::Or | Self::Xor => 1,
            Self::Eq | Self::Ne | Self::Gt | Self::Ge | Self::Lt | Self::Le => 2,
            Self::Plus | Self::Minus => 3,
            Self::Times | Self::Over | Self::Mod => 4,
            Self::Power => 5,
        }
    }

    /// Its value; not finite where it has none.
    pub fn of(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Power => a.powf(b),
            Self::Times => a * b,
            Self::Over => a / b,
            Self::Mod => a.rem_euclid(b),
            Self::Plus => a + b,
            Self::Minus => a - b,
            Self::Eq => truth((a - b).abs() < SAME),
            Self::Ne => truth((a - b).abs() >= SAME),
            Self::Gt => truth(a > b),
            Self::Ge => truth(a >= b),
            Self::Lt => truth(a < b),
            Self::Le => truth(a <= b),
            Self::And => truth(a != 0.0 && b != 0.0),
            Self::Or => truth(a != 0.0 || b != 0.0),
            Self::Xor => truth((a != 0.0) != (b != 0.0)),
        }
    }
}

fn truth(holds: bool) -> f64 {
    f64::from(u8::from(holds))
}
