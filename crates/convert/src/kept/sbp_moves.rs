//! Moves, arcs, speeds and outputs of a part file that keeps its variables.

use super::Unkept;
use super::sbp_lines::Keeper;
use kerf_sbp::tree::{Arg, ArgKind, MoveCommand};

/// A value in brackets.
fn bracketed(value: &str) -> String {
    if value.starts_with('[') { value.into() } else { format!("[{value}]") }
}

impl Keeper<'_> {
    pub(super) fn literal_move(
        &mut self,
        line: u32,
        (command, given, first): (MoveCommand, u8, u32),
    ) -> Result<(), Unkept> {
        let mut values: [Option<String>; 3] = Default::default();
        let mut numbers = self.program.numbers.iter().skip(first as usize);
        for i in (0..command.count).filter(|i| given & (1 << i) != 0) {
            let axis = usize::from(command.first + i);
            let Some(value) = values.get_mut(axis) else {
                return Err(Unkept::new(line, "axes beside X, Y and Z"));
            };
            *value = numbers.next().map(|n| format!("{n}"));
        }
        self.move_to(command.jog, &values);
        Ok(())
    }

    /// A move to places, or a jog.
    fn move_to(&mut self, jog: bool, values: &[Option<String>; 3]) {
        let words = || {
            let given = ["X", "Y", "Z"].iter().zip(values);
            given.filter_map(|(l, v)| Some(format!(" {l}{}", v.as_ref()?))).collect::<String>()
        };
        let text = match values {
            [None, None, None] => return,
            _ if jog => format!("G0{}", words()),
            [_, _, None] => format!("G1{} F#<_feed_xy>", words()),
            [None, None, Some(_)] => format!("G1{} F#<_feed_z>", words()),
            [x, y, Some(z)] => {
                self.slopes = true;
                let place = |v: &Option<String>, n: u32| v.clone().unwrap_or(format!("#{n}"));
                let (x, y) = (place(x, 5420), place(y, 5421));
                let [x, y, z] = [&x, &y, z].map(|v| bracketed(v));
                self.line(&format!("O<slope> call {x} {y} {z}"));
                format!("G1{} F#<_feed_slope>", words())
            }
        };
        self.line(&text);
    }

    pub(super) fn command(&mut self, line: u32, letters: &str, args: &[Arg]) -> Result<(), Unkept> {
        let number = |index: usize| self.argument(line, args, index);
        match letters.as_bytes() {
            [kind @ (b'M' | b'J'), axis @ (b'X' | b'Y' | b'Z')] => {
                let mut values: [Option<String>; 3] = Default::default();
                values[usize::from(axis - b'X')] = number(0)?;
                self.move_to(*kind == b'J', &values);
            }
            [kind @ (b'M' | b'J'), b'2' | b'3'] => {
                let z = if letters.ends_with('3') { number(2)? } else { None };
                let values = [number(0)?, number(1)?, z];
                self.move_to(*kind == b'J', &values);
            }
            b"VS" | b"MS" => {
                for (index, name) in ["#<_feed_xy>", "#<_feed_z>"].into_iter().enumerate() {
                    if let Some(speed) = self.argument(line, args, index)? {
                        self.line(&format!("{name} = [{speed} * 60]"));
                    }
                }
            }
            b"JS" | b"SA" => {}
            // The cutter's diameter; its trigger would switch outputs.
            b"VC" if args.len() <= 7 => {}
            b"SO" => self.output(line, args)?,
            b"TR" => {
                let speed = number(0)?.unwrap_or_default();
                self.line(&format!("S{speed}"));
            }
            b"CG" => self.arc(line, args)?,
            b"ZX" | b"ZY" | b"ZZ" | b"Z2" | b"Z3" => {
                let place = match letters {
                    "ZX" => "X0",
                    "ZY" => "Y0",
                    "ZZ" => "Z0",
                    "Z2" => "X0 Y0",
                    _ => "X0 Y0 Z0",
                };
                self.line(&format!("G92 {place}"));
            }
            _ => return Err(Unkept::new(line, format!("the command {letters}"))),
        }
        Ok(())
    }

    fn argument(&self, line: u32, args: &[Arg], index: usize) -> Result<Option<String>, Unkept> {
        match args.get(index).map(|arg| &arg.kind) {
            None | Some(ArgKind::Blank) => Ok(None),
            Some(ArgKind::Expr(expr)) => self.words(line).value(expr).map(Some),
            Some(ArgKind::Word(word)) => Err(Unkept::new(line, format!("the word {word}"))),
        }
    }

    fn output(&mut self, line: u32, args: &[Arg]) -> Result<(), Unkept> {
        let literal = |index: usize| match args.get(index).map(|arg| &arg.kind) {
            Some(ArgKind::Expr(expr)) => match expr.node {
                kerf_sbp::ExprNode::Number(n) => Some(n),
                _ => None,
            },
            _ => None,
        };
        let text = match (literal(0), literal(1)) {
            (Some(1.0), Some(1.0)) => "M3".into(),
            (Some(1.0), Some(0.0)) => "M5".into(),
            (Some(n), Some(on)) if on == 0.0 || on == 1.0 => {
                format!("M6{} P{}", if on == 1.0 { 4 } else { 5 }, n - 1.0)
            }
            _ => return Err(Unkept::new(line, "an output whose number or state is computed")),
        };
        self.line(&text);
        Ok(())
    }

    /// CG by its centre, once, without anything special.
    fn arc(&mut self, line: u32, args: &[Arg]) -> Result<(), Unkept> {
        let number = |index: usize| self.argument(line, args, index);
        let side = args.get(5).is_none_or(|arg| match &arg.kind {
            ArgKind::Blank => true,
            ArgKind::Word(word) => word.eq_ignore_ascii_case("T"),
            ArgKind::Expr(_) => false,
        });
        let turn = match number(6)?.as_deref() {
            None | Some("1") => "G2",
            Some("-1") => "G3",
            Some(_) => return Err(Unkept::new(line, "an arc whose direction is computed")),
        };
        let plain = args.len() <= 7 && side && number(0)?.is_none();
        let (Some(i), Some(j)) = (number(3)?, number(4)?) else {
            return Err(Unkept::new(line, "an arc without its centre"));
        };
        if !plain {
            return Err(Unkept::new(line, "an arc with plunges or another side"));
        }
        let place = |letter: &str, value: Option<String>| {
            value.map_or_else(String::new, |v| format!(" {letter}{v}"))
        };
        let (x, y) = (place("X", number(1)?), place("Y", number(2)?));
        self.line(&format!("{turn}{x}{y} I{i} J{j} F#<_feed_xy>"));
        Ok(())
    }
}
