//! Zero points that LinuxCNC keeps, as the bridge tells them.

use crate::status::{axes, number, words};
use kerf_machine::driver::{Zero, ZeroChange};

/// News of the bridge about them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Zeros {
    /// Number of the greeting since which it tells, and that of the next line that it waits for.
    pub greeting: u32,
    pub next: u32,
    pub told: Vec<Zero>,
    /// Those that are turned about Z, too: Kerf's own zero cannot follow them.
    turned: Vec<String>,
}

impl Zeros {
    /// Reads a line without its check number.
    pub fn read(text: &str) -> Option<Self> {
        let words = words(text.strip_prefix("z ")?);
        let system = words.get("holds")?;
        let zero = |name: &&str| {
            let at = axes(words.get(name)?)?;
            let zero = Zero { name: (*name).to_owned(), at, holds: name == system };
            Some(Zero { holds: zero.holds || zero.is_shift(), ..zero })
        };
        let names = Zero::SYSTEMS.iter().chain(&[Zero::SHIFT, Zero::TOOL]);
        let turned = words.get("turned").map_or("", |names| names);
        Some(Self {
            greeting: number(&words, "hi")?,
            next: number(&words, "next")?,
            told: names.filter_map(zero).collect(),
            turned: turned.split(',').map(str::to_owned).collect(),
        })
    }

    /// Returns the line by which one of so many axes is changed; nothing where it is not kept, or cannot be changed so.
    pub fn line(&self, name: &str, change: ZeroChange, axes: usize) -> Option<String> {
        let is_kept = self.told.iter().any(|zero| zero.name == name);
        let is_turned = self.turned.iter().any(|turned| turned == name);
        if is_kept && !is_turned { change.line(name, axes) } else { None }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kerf_machine::driver::{AXES, Axes};

    #[test]
    fn zero_points_are_read_and_one_that_is_turned_is_left_alone() {
        let text = "z hi=1 next=4 holds=G55 G54=0,0,0 G55=50,20.5,-3 G56=1,2,3 G92=0,0,1 TLO=0,0,12.5 turned=G56";
        let read = Zeros::read(text).expect("zero points");
        let named = |name| read.told.iter().find(|zero| zero.name == name).expect(name);
        assert_eq!((named("G55").at, named("G55").holds), (Axes::xyz(50.0, 20.5, -3.0), true));
        assert_eq!(
            (named("G54").holds, named("G92").holds, named("TLO").at.0[2]),
            (false, true, 12.5)
        );
        let lies = ZeroChange::Lies([Some(1.5); AXES]);
        assert_eq!(read.line("G54", lies, 3).as_deref(), Some("G10L2P1X1.500Y1.500Z1.500"));
        for name in ["G56", "G57", "TLO"] {
            assert_eq!(read.line(name, lies, 3), None, "{name}");
        }
        assert_eq!(Zeros::read(&text.replace("next=4", "next=x")), None);
    }
}
