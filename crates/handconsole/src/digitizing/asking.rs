//! Questions while digitizing: a function, its numbers, whether points may be lost.

use super::table::{Does, Entry, FUNCTIONS};
use super::{Digitizing, heading, stand};
use crate::entry::Typed;
use crate::functions::{Stepping, function};
use crate::next::{Next, To};
use crate::{COLUMNS, Key, Screen, View};
use kerf_digitize::{Digitizer, Stand};

/// The open question, or the display.
#[derive(Clone, Debug, Default)]
pub(crate) enum Asks {
    /// Nothing: which point is current.
    #[default]
    Nothing,
    /// Nothing: where the tool is.
    Place,
    /// Which function.
    Function {
        /// Its number as far as it is typed.
        typed: Typed,
        /// Enter was pressed, and there is none.
        refused: bool,
    },
    /// The numbers of a function.
    Numbers(Stepping),
    /// Confirmation of something by which points are lost.
    Losing(Losing),
}

/// Act by which points are lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Losing {
    /// All are forgotten.
    Clear,
    /// Those of another shape take their place.
    Load,
    /// Digitizing ends.
    Exit,
}

impl Asks {
    /// The function entry, before anything is typed.
    pub fn function() -> Self {
        Self::Function { typed: Typed::default(), refused: false }
    }

    /// Returns `true` if keys are answers.
    pub const fn is_open(&self) -> bool {
        !matches!(self, Self::Nothing | Self::Place)
    }

    pub fn screen(&self, points: &Digitizer, view: &View) -> Option<Screen> {
        match self {
            Self::Nothing => None,
            Self::Place => Some(Screen::new(heading(points), place(&stand(view)))),
            Self::Function { typed, refused } => {
                let number = number(typed);
                let bottom = match entry(typed) {
                    Some(found) => format!("{number} {}", found.name),
                    None if *refused => format!("{number} ?"),
                    None => number,
                };
                Some(Screen::new("Enter function:", bottom))
            }
            Self::Numbers(stepping) => Some(stepping.screen(view)),
            Self::Losing(losing) => {
                let top = format!("Lose {} points?", points.points().len());
                let does = if *losing == Losing::Exit { "exit" } else { "yes" };
                Some(Screen::new(top, format!("Enter={does} Func=no")))
            }
        }
    }
}

impl Digitizing {
    /// A key answers what is asked.
    pub(super) fn answer(mut self, key: Key, view: &View) -> Next<Self> {
        match std::mem::take(&mut self.asks) {
            Asks::Function { typed, .. } => self.choose(typed, key, view),
            Asks::Numbers(stepping) => {
                let next = stepping.press(key, view);
                self.within(next)
            }
            Asks::Losing(losing) if key == Key::Enter => self.lose(losing, view),
            Asks::Losing(_) | Asks::Nothing | Asks::Place => self.stay(),
        }
    }

    fn choose(self, typed: Typed, key: Key, view: &View) -> Next<Self> {
        match key {
            Key::Func => self.stay(),
            Key::Enter => match entry(&typed) {
                Some(found) => self.run(found, view),
                None => self.ask(Asks::Function { typed, refused: true }).beep(),
            },
            Key::Digit(_) | Key::Stop => {
                self.ask(Asks::Function { typed: typed.press_whole(key), refused: false })
            }
            Key::File | Key::PlusMinus | Key::Start => {
                self.ask(Asks::Function { typed, refused: false })
            }
        }
    }

    fn run(self, entry: &Entry, view: &View) -> Next<Self> {
        let tool = stand(view);
        match entry.does {
            Does::Edit(edit) => self.edit(|points| edit(points, tool)),
            Does::Go(way) => match way(&self.points, &tool) {
                Ok(way) => self.go(way),
                Err(why) => self.stay().refused(why.to_string()),
            },
            Does::Save { closed } => self.save(closed, view),
            Does::Loses(losing) => {
                let (some, unsaved) = (!self.points.points().is_empty(), self.points.is_unsaved());
                match losing {
                    Losing::Clear if some => self.ask(Asks::Losing(losing)),
                    Losing::Load | Losing::Exit if unsaved => self.ask(Asks::Losing(losing)),
                    _ => self.lose(losing, view),
                }
            }
            Does::Looks(look) => self.stay().and([crate::ConsoleRequest::Look(look)]),
            Does::Place => self.ask(Asks::Place),
            Does::Moves { flat, in_space } => {
                let three = self.points.dimension() == kerf_digitize::Dimension::Three;
                let next = Stepping::begin(if three { in_space } else { flat }, view);
                self.within(next)
            }
            Does::AsAtRest(number) => match function(number) {
                Some(found) => {
                    let next = Stepping::begin(found, view);
                    self.within(next)
                }
                None => self.stay().beep(),
            },
        }
    }

    fn lose(mut self, losing: Losing, view: &View) -> Next<Self> {
        match losing {
            Losing::Clear => {
                self.points.clear();
                self.stay()
            }
            Losing::Load => self.load(view),
            Losing::Exit => Next::default(),
        }
    }

    /// A function of the console asks its numbers in here, and what it requests is done from here.
    fn within(self, next: Next<Stepping>) -> Next<Self> {
        next.within(|to| {
            let asks = match to {
                To::Stay(stepping) => Asks::Numbers(stepping),
                _ => Asks::Nothing,
            };
            To::Stay(Self { asks, ..self })
        })
    }
}

/// The number that is meant: 0 before anything is typed.
fn number(typed: &Typed) -> String {
    if typed.is_empty() { "0".into() } else { typed.to_string() }
}

fn entry(typed: &Typed) -> Option<&'static Entry> {
    let number: u32 = number(typed).parse().ok()?;
    FUNCTIONS.iter().find(|entry| entry.number == number)
}

/// A place with as many decimals as there is room for.
fn place(tool: &Stand) -> String {
    let [x, y, z] = [tool.at.x, tool.at.y, tool.z_mm];
    let shown = |decimals: usize| format!("{x:.decimals$} {y:.decimals$} {z:.decimals$}");
    let fits = |text: &String| text.len() <= COLUMNS;
    [2, 1].map(shown).into_iter().find(fits).unwrap_or_else(|| shown(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_fits_its_line() {
        let check = |x, y, z, expected: &str| {
            assert_eq!(place(&Stand::new(x, y, z)), expected);
            assert!(expected.len() <= COLUMNS);
        };
        check(10.0, 20.0, -5.0, "10.00 20.00 -5.00");
        check(1250.5, 800.25, -12.5, "1250.5 800.2 -12.5");
        check(-12500.5, -12500.5, -120.0, "-12500 -12500 -120");
    }

    #[test]
    fn every_function_fits_the_screen_and_has_one_number() {
        for (n, entry) in FUNCTIONS.iter().enumerate() {
            let line = format!("{} {}", entry.number, entry.name);
            assert!(line.len() <= COLUMNS, "{line}");
            assert!(FUNCTIONS[..n].iter().all(|other| other.number < entry.number), "{line}");
        }
    }
}
