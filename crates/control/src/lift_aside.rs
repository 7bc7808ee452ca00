//! A tool that the operator takes out of the cut while a program waits for him: a part is turned, a tool is
//! changed, a clamp is in the way.
//!
//! ```text
//!  PAUSE: tool in the cut ─► lift: what turns stops, up to Safe-Z ─► jog … ─► OK: spindle, over it, down
//! ```
//!
//! The way back is that from a stop. A program whose question is answered with a refusal most often ends there:
//! then the tool stays away, and goes back only when the program moves on.

use crate::by_hand::Jog;
use crate::runner::{Over, Runner};
use kerf_machine::state::{Effect, State};
use kerf_program::{Answer, Axis, Button, Interpreter, QuestionKind};

/// The word that takes the tool out of the cut while a program asks.
pub const LIFT: &str = "lift";

/// Move of the tool by the operator while a program waits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Aside {
    /// Out of the cut, what turns stops.
    Lift,
    /// By hand.
    Jog(Jog),
}

impl Aside {
    /// Reads `lift`, or a jog.
    pub fn read(words: &str) -> Option<Self> {
        if words.trim().eq_ignore_ascii_case(LIFT) {
            return Some(Self::Lift);
        }
        Jog::read(words).map(Self::Jog)
    }

    /// Returns `true` if a question of a kind leaves the tool to the operator: a program waits for him, and goes on
    /// where it was.
    pub const fn is_for(kind: QuestionKind) -> bool {
        matches!(kind, QuestionKind::Pause | QuestionKind::Msgbox)
    }
}

/// Returns `true` if a program that gets this answer goes on, as far as its buttons say.
const fn goes_on(answer: &Answer) -> bool {
    !matches!(answer, Answer::Button(Button::Cancel | Button::Abort | Button::No))
}

impl<I: Interpreter> Runner<'_, I> {
    /// The tool is moved while a program waits; where it comes back to is kept. What ends the run meanwhile is told
    /// by [`Runner::heeded`].
    pub(crate) fn set_aside(&mut self, aside: Aside) {
        if self.world.machine.draws() {
            return;
        }
        let ahead = self.mover.position();
        // A stop on the way ends it there: the question that is open says what follows.
        let state = std::mem::replace(&mut self.state, State::Paused);
        if !std::mem::replace(&mut self.away, true) {
            self.carry_out(Effect::KeepPlace);
            self.carry_out(Effect::Halt);
        }
        match aside {
            Aside::Lift => {
                self.carry_out(Effect::SpindleOff);
                self.world.tell_log();
                self.carry_out(Effect::Raise);
            }
            Aside::Jog(jog) => self.jog(jog),
        }
        self.come_back_over();
        // The program is still where it waits.
        if self.state == State::Paused {
            self.state = state;
        }
        self.mover.set_position(ahead);
    }

    /// A question that left the tool to the operator is answered.
    pub(crate) fn goes_back_after(&mut self) -> Result<(), Over> {
        let goes_on = self.world.answer.as_ref().is_some_and(goes_on);
        if goes_on { self.back_in_the_cut() } else { Ok(()) }
    }

    /// The tool goes back to where the program left it, if it was taken away.
    pub(crate) fn back_in_the_cut(&mut self) -> Result<(), Over> {
        if !std::mem::take(&mut self.away) {
            return Ok(());
        }
        let ahead = self.mover.position();
        self.carry_out(Effect::ComeBack);
        self.mover.set_position(ahead);
        self.heeded()
    }

    /// The way back is no lower than Safe-Z, nor than where the tool is.
    fn come_back_over(&mut self) {
        let safe_mm = self.lift_mm().unwrap_or(f64::NEG_INFINITY);
        self.kept.lifted_mm = safe_mm.max(self.world.machine.position()[Axis::Z]);
    }
}
