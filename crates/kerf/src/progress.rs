//! The progress bar of a run.

use indicatif::{ProgressBar, ProgressStyle};
use kerf_trace::{Event, Sink};

/// Moves between two looks at the bar.
const MOVES_A_LOOK: u64 = 256;

/// Lines of the part file that have been reached, and machine time.
pub struct Progress {
    bar: ProgressBar,
    moves: u64,
}

impl Progress {
    /// A bar for a program of so many lines.
    pub fn new(lines: usize) -> Self {
        let bar = ProgressBar::new(lines as u64);
        let style = ProgressStyle::with_template("{bar:40} line {pos}/{len}  {msg}");
        Self {
            bar: bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())),
            moves: 0,
        }
    }

    /// Takes the bar away.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }
}

impl Sink for Progress {
    fn event(&mut self, event: &Event) {
        let made = match event {
            Event::Move(made) => made,
            Event::Arc(arc) => &arc.made,
            _ => return,
        };
        self.moves += 1;
        let long = made.t1 - made.t0 > 0.1;
        if long || self.moves.is_multiple_of(MOVES_A_LOOK) {
            self.bar.set_position(u64::from(made.line));
            self.bar.set_message(crate::out::duration(made.t0));
        }
    }
}
