//! The `d` attribute: relative commands on a grid of decimals.
//!
//! Positions are rounded to the grid first and differences taken of the rounded ones, so that
//! rounding never adds up along a path.

use crate::sheet::{Op, Outline, arc_pieces};
use kerf_geom::{Point2, Vec2};
use std::fmt::Write as _;

/// Arcs are written in pieces of at most a third of a turn.
///
/// SVG gives an arc by its ends and radius; near a half turn the centre that follows from them
/// moves by the square root of the rounding (0.2 mm for a radius of 50 mm), at 120° by twice it.
const PIECE_RAD: f64 = std::f64::consts::TAU / 3.0;

/// Writes an outline relative to `origin` with so many decimals.
pub fn path_data(outline: &Outline, origin: Point2, decimals: u32) -> String {
    let mut data = PathData::new(origin, decimals);
    for op in &outline.ops {
        data.op(op);
    }
    data.out
}

/// A number without needless zeros: `0.5`, `-12`, `3.142`.
pub fn number(value: f64, decimals: u32) -> String {
    let mut out = String::new();
    push_grid(&mut out, on_grid(value, decimals), decimals);
    if out.starts_with('.') {
        out.insert(0, '0');
    } else if out.starts_with("-.") {
        out.insert(1, '0');
    }
    out
}

struct PathData {
    out: String,
    origin: Vec2,
    decimals: u32,
    /// Place of the pen, exactly and on the grid.
    pen: Point2,
    at: [i64; 2],
    start: [i64; 2],
    command: u8,
}

impl PathData {
    fn new(origin: Point2, decimals: u32) -> Self {
        let origin = origin - Point2::default();
        let (pen, at) = (Point2::default(), [0; 2]);
        Self { out: String::new(), origin, decimals, pen, at, start: at, command: 0 }
    }

    fn op(&mut self, op: &Op) {
        match *op {
            Op::Move(to) => {
                self.move_to(to);
                self.pen = to;
            }
            Op::Line(to) => {
                self.line_to(to);
                self.pen = to;
            }
            Op::Arc { centre, to, sweep_rad } => {
                self.arc(centre, to, sweep_rad);
                self.pen = to;
            }
            Op::Close => self.close(),
        }
    }

    fn grid(&self, p: Point2) -> [i64; 2] {
        let p = p - (Point2::default() + self.origin);
        [on_grid(p.x, self.decimals), on_grid(p.y, self.decimals)]
    }

    fn move_to(&mut self, to: Point2) {
        let to = self.grid(to);
        if self.out.is_empty() {
            self.command(b'M');
            self.pair(to);
        } else if to != self.at || self.command == b'z' {
            self.command(b'm');
            self.pair([to[0] - self.at[0], to[1] - self.at[1]]);
        }
        (self.at, self.start) = (to, to);
    }

    fn line_to(&mut self, to: Point2) {
        let to = self.grid(to);
        let by = [to[0] - self.at[0], to[1] - self.at[1]];
        match by {
            [0, 0] => return,
            [x, 0] => self.one(b'h', x),
            [0, y] => self.one(b'v', y),
            _ => {
                self.command(b'l');
                self.pair(by);
            }
        }
        self.at = to;
    }

    fn arc(&mut self, centre: Point2, to: Point2, sweep_rad: f64) {
        let flag = if sweep_rad < 0.0 { '0' } else { '1' };
        let mut from = self.pen;
        for (end, _) in arc_pieces(self.pen, centre, to, sweep_rad, PIECE_RAD) {
            let radius = 0.5 * (from.distance(centre) + end.distance(centre));
            from = end;
            let end = self.grid(end);
            let by = [end[0] - self.at[0], end[1] - self.at[1]];
            if by == [0, 0] {
                continue;
            }
            self.command(b'a');
            let radius = number(radius, self.decimals + 1);
            self.gap();
            let _ = write!(self.out, "{radius} {radius} 0 0 {flag}");
            self.pair(by);
            self.at = end;
        }
    }

    fn close(&mut self) {
        self.out.push('z');
        self.command = b'z';
        self.at = self.start;
    }

    fn one(&mut self, command: u8, by: i64) {
        self.command(command);
        self.gap();
        push_grid(&mut self.out, by, self.decimals);
    }

    fn pair(&mut self, by: [i64; 2]) {
        for value in by {
            self.gap();
            push_grid(&mut self.out, value, self.decimals);
        }
    }

    /// Writes a command letter, unless the last one still holds.
    fn command(&mut self, command: u8) {
        if self.command != command || command == b'm' {
            self.out.push(char::from(command));
            self.command = command;
        }
    }

    /// Parts numbers; a minus parts them by itself, but a space reads better and costs little.
    fn gap(&mut self) {
        if self.out.as_bytes().last().is_some_and(|b| !b.is_ascii_alphabetic()) {
            self.out.push(' ');
        }
    }
}

fn on_grid(value: f64, decimals: u32) -> i64 {
    (value * 10f64.powi(decimals as i32)).round() as i64
}

/// Writes a grid number as a decimal, shortest form, without a zero before the point.
fn push_grid(out: &mut String, value: i64, decimals: u32) {
    let unit = 10u64.pow(decimals);
    let (whole, mut part) = (value.unsigned_abs() / unit, value.unsigned_abs() % unit);
    if value < 0 {
        out.push('-');
    }
    if whole > 0 || part == 0 {
        let _ = write!(out, "{whole}");
    }
    if part == 0 {
        return;
    }
    let mut digits = decimals as usize;
    while part.is_multiple_of(10) {
        part /= 10;
        digits -= 1;
    }
    let _ = write!(out, ".{part:0digits$}");
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn check(draw: impl Fn(&mut Outline), expected: &str) {
        let mut outline = Outline::default();
        draw(&mut outline);
        assert_eq!(path_data(&outline, Point2::default(), 3), expected);
    }

    fn p(x: f64, y: f64) -> Point2 {
        Point2::new(x, y)
    }

    #[test]
    fn numbers_are_short() {
        for (v, text) in [
            (0.0, "0"),
            (-0.0001, "0"),
            (0.5, "0.5"),
            (-0.05, "-0.05"),
            (12.34, "12.34"),
            (-3.0, "-3"),
        ] {
            assert_eq!(number(v, 3), text);
        }
    }

    #[test]
    fn lines_are_relative_and_straight_ones_shorter() {
        check(
            |o| {
                o.move_to(p(10.0, 10.0));
                o.line_to(p(20.0, 10.0));
                o.line_to(p(20.0, 9.5));
                o.line_to(p(21.0, 8.5));
                o.line_to(p(22.0, 7.25));
                o.segment(p(0.0, 0.0), p(1.0, 0.0));
            },
            "M10 10h10v-.5l1 -1 1 -1.25m-22 -7.25h1",
        );
    }

    #[test]
    fn rounding_does_not_add_up() {
        check(
            |o| {
                o.move_to(p(0.0, 0.0));
                for i in 1..=9 {
                    o.line_to(p(f64::from(i) * 0.0004, 0.0));
                }
            },
            // 0.0036 in all, though no single step reaches the grid.
            "M0 0h.001 .001 .001 .001",
        );
    }

    #[test]
    fn half_turns_are_split_and_keep_their_direction() {
        check(
            |o| {
                o.move_to(p(10.0, 0.0));
                o.arc_to(p(0.0, 0.0), p(-10.0, 0.0), -PI);
            },
            "M10 0a10 10 0 0 0 -10 -10 10 10 0 0 0 -10 10",
        );
    }

    #[test]
    fn a_full_circle_comes_back() {
        check(
            |o| o.circle(p(0.0, 0.0), 10.0),
            "M10 0a10 10 0 0 1 -15 8.66 10 10 0 0 1 0 -17.32 10 10 0 0 1 15 8.66z",
        );
        let turns = arc_pieces(p(1.0, 0.0), p(0.0, 0.0), p(1.0, 0.0), 2.0 * TAU, PIECE_RAD);
        assert_eq!(turns.count(), 6);
    }

    #[test]
    fn the_origin_is_taken_off() {
        let mut outline = Outline::default();
        outline.segment(p(1e6, 1e6), p(1e6 + 1.0, 1e6));
        assert_eq!(path_data(&outline, p(1e6, 1e6), 3), "M0 0h1");
    }
}
