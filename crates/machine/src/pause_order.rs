//! The operator's orders in a pause.

use kerf_program::Axis;

/// One order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PauseOrder {
    /// The job goes on.
    Continue,
    /// The job is given up.
    Abort,
    /// The machine's cutting speed, mm/s.
    CutSpeed(f64),
    /// The plunging speed, mm/s.
    PlungeSpeed(f64),
    /// ZBottom by a distance, mm, negative down.
    AdjustBottom(f64),
    /// The shape to begin with, counted from 1.
    Shape(usize),
    /// The next shape to begin with.
    Next,
    /// The one before.
    Previous,
    /// The set points of height control along X and Y by distances, mm.
    AdjustHeight([f64; 2]),
    /// The tool rises in pauses, or does not.
    Raise(bool),
    /// An axis moves by a distance, mm or degrees.
    Move(Axis, f64),
}

/// Seconds in a minute: speeds are typed in mm/min.
const PER_MIN: f64 = 60.0;

impl PauseOrder {
    /// Returns `true` if something moves or comes on when it is obeyed.
    pub const fn moves(self) -> bool {
        match self {
            Self::Continue | Self::Shape(_) | Self::Next | Self::Previous | Self::Move(..) => true,
            Self::Abort
            | Self::CutSpeed(_)
            | Self::PlungeSpeed(_)
            | Self::AdjustBottom(_)
            | Self::AdjustHeight(_)
            | Self::Raise(_) => false,
        }
    }

    /// Reads an order: `continue`, `abort`, `cut 3000` and `plunge 600` (mm/min), `zbottom -0.5`,
    /// `height 0.38` and `height x -0.1` (mm), `raise yes`, `move y 200`; before the start `next`, `previous` or the number of a shape.
    pub fn read(text: &str) -> Option<Self> {
        let text = text.to_ascii_lowercase();
        let words: Vec<&str> = text.split_whitespace().collect();
        let number = |word: &str| word.parse::<f64>().ok().filter(|value| value.is_finite());
        let speed = |word: &str| number(word).filter(|v| *v > 0.0).map(|v| v / PER_MIN);
        match words.as_slice() {
            [first] => match *first {
                "continue" | "resume" | "start" | "ok" | "acknowledge" => Some(Self::Continue),
                "abort" | "quit" | "end" | "cancel" => Some(Self::Abort),
                "next" | "+" => Some(Self::Next),
                "previous" | "-" => Some(Self::Previous),
                number => number.parse().ok().filter(|n| *n > 0).map(Self::Shape),
            },
            [first, value] => match *first {
                "cut" => Some(Self::CutSpeed(speed(value)?)),
                "plunge" => Some(Self::PlungeSpeed(speed(value)?)),
                "height" => number(value).map(|by| Self::AdjustHeight([by, by])),
                "zbottom" => Some(Self::AdjustBottom(number(value)?)),
                "raise" => match *value {
                    "yes" | "1" | "on" => Some(Self::Raise(true)),
                    "no" | "0" | "off" => Some(Self::Raise(false)),
                    _ => None,
                },
                _ => None,
            },
            ["height", "x", by] => Some(Self::AdjustHeight([number(by)?, 0.0])),
            ["height", "y", by] => Some(Self::AdjustHeight([0.0, number(by)?])),
            [first, axis, by] if *first == "move" => {
                let mut letters = axis.chars();
                let axis = letters.next().and_then(Axis::from_letter)?;
                letters.next().is_none().then_some(Self::Move(axis, number(by)?))
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_are_read() {
        let check = |text: &str, expected| assert_eq!(PauseOrder::read(text), expected, "{text}");
        check("Resume", Some(PauseOrder::Continue));
        check("abort", Some(PauseOrder::Abort));
        check("cut 3000", Some(PauseOrder::CutSpeed(50.0)));
        check("plunge 600", Some(PauseOrder::PlungeSpeed(10.0)));
        check("zbottom -0.5", Some(PauseOrder::AdjustBottom(-0.5)));
        check("height 0.38", Some(PauseOrder::AdjustHeight([0.38; 2])));
        check("height y -0.1", Some(PauseOrder::AdjustHeight([0.0, -0.1])));
        check("raise no", Some(PauseOrder::Raise(false)));
        check("move y 200", Some(PauseOrder::Move(Axis::Y, 200.0)));
        for wrong in ["", "cut 0", "cut fast", "move q 1", "move xy 1", "zbottom nan"] {
            check(wrong, None);
        }
    }
}
