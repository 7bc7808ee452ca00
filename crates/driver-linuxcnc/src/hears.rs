//! The receiving side of the driver: what follows from what the bridge tells.

use crate::check;
use crate::driver::{LinuxCnc, Phase, with};
use crate::piece::{Kind, Piece};
use crate::status::{Doing, PROBE_INPUT, Status, facts};
use crate::zeros::Zeros;
use kerf_machine::driver::{Axes, Garbled, Hold, Order, Reply, Ticket, Trouble, way_mm};

/// A place that is farther than this from the one that was ordered is another, mm: LinuxCNC cuts no corner at the end of
/// a piece.
const ELSEWHERE_MM: f64 = 0.05;

/// The speed at which it goes back to where the probe had contact, mm/min.
const BACK_MM_MIN: u32 = 300;

impl LinuxCnc {
    pub(crate) fn line(&mut self, line: &[u8], shares_are_new: bool) {
        let Some(text) = check::text(line) else { return self.replies.push(Err(Garbled)) };
        if let Some(told) = facts(text) {
            return self.learns(told);
        }
        if let Some(zeros) = Zeros::read(text) {
            self.zeros = zeros;
            return;
        }
        match Status::read(text) {
            Some(status) => self.follows(status, shares_are_new),
            None => self.replies.push(Err(Garbled)),
        }
    }

    fn learns(&mut self, told: Result<kerf_machine::driver::Facts, &'static str>) {
        match told {
            Ok(facts) => self.told = Some(facts),
            Err(why) => self.trouble = Some(Trouble::Unfit { why }),
        }
    }

    fn follows(&mut self, status: Status, shares_are_new: bool) {
        if status.greeting != self.greeting {
            return;
        }
        self.tell_inputs(status.inputs);
        if shares_are_new {
            self.shares = status.shares;
        }
        // A bridge to which a line came garbled waits for none.
        let is_old = status.next < self.acts && status.next != 0;
        let doing = if is_old { self.status.doing } else { status.doing };
        self.status = Status { doing, ..status };
        match self.phase {
            _ if is_old => {}
            Phase::Silent if self.told.is_some() && self.trouble.is_none() => {
                self.begin();
                self.heeds_locks();
            }
            Phase::Ready => self.is_at_work(),
            Phase::Stopping if self.status.doing == Doing::Stopped => self.has_stopped(),
            Phase::Silent | Phase::Stopping | Phase::Stopped => {}
        }
        self.replies.push(Ok(Reply::State(self.standing())));
    }

    /// It stands after a stop. One that was stopped before it told of itself is asked now.
    fn has_stopped(&mut self) {
        self.on = self.status.outputs;
        if self.facts.is_some() {
            self.phase = Phase::Stopped;
        } else {
            self.phase = Phase::Silent;
            self.greets();
        }
    }

    fn is_at_work(&mut self) {
        self.follows_hold();
        if !self.status.why.is_empty() {
            return self.has_failed();
        }
        if self.making.is_none() {
            return self.heeds_locks();
        }
        if self.status.piece != self.piece {
            return;
        }
        self.is_done(self.status.done);
        if self.status.is_over {
            self.ends_piece();
        }
    }

    fn has_failed(&mut self) {
        if self.is_in_trouble() {
            return;
        }
        self.trouble = None;
        let why = self.status.why.clone().into();
        let homes = self.making.as_ref().is_some_and(|piece| piece.kind == Kind::Home);
        let lost = homes || self.status.doing == Doing::Gone;
        self.fail(Trouble::Alarm { number: 0, why, lost });
    }

    /// Follows the hold that was ordered: what moves again behind it was had to go on at the panel.
    const fn follows_hold(&mut self) {
        self.hold = match (self.hold, self.status.doing) {
            (Hold::Ordered, Doing::Held) => Hold::Stands,
            (Hold::Stands, Doing::Run) => Hold::WentOn,
            (hold, _) => hold,
        };
    }

    /// Tells why it takes no orders, while none is under way; the reason may end at its panel.
    pub(crate) fn heeds_locks(&mut self) {
        if self.is_in_trouble() {
            return;
        }
        let why = match (self.status.doing, self.status.is_homed) {
            (Doing::Estop, _) => {
                "its emergency stop is pressed: release it, then switch it on at its panel, or unlock it (--unlock)"
            }
            (Doing::Gone, _) => "LinuxCNC has ended: start it again",
            (Doing::Off, _) => {
                "it is switched off: switch it on at its panel, or unlock it (--unlock)"
            }
            (_, false) => "home it first (--home)",
            (_, true) => {
                self.trouble = None;
                // Somebody at its panel may have moved it.
                if self.open.is_empty() && !self.status.moves {
                    self.planned = self.status.position;
                }
                return;
            }
        };
        self.trouble = Some(Trouble::Locked { why });
    }

    /// Orders up to this are made.
    fn is_done(&mut self, ticket: Ticket) {
        while let Some(first) = self.open.front().copied().filter(|first| first.ticket <= ticket) {
            self.open.pop_front();
            self.done = first.ticket;
            if let Order::Output { line, on } = first.order {
                self.on = with(self.on, line, on);
            }
            self.replies.push(Ok(Reply::Done(self.done)));
        }
    }

    fn ends_piece(&mut self) {
        let Some(piece) = self.making.take() else { return };
        match piece.kind {
            Kind::Home | Kind::Unlock => {
                self.planned = self.status.position;
                self.trouble = None;
            }
            Kind::Probe if self.status.contact.is_some() && self.contact.is_none() => {
                return self.has_contact(piece);
            }
            Kind::Path | Kind::Probe => {
                if way_mm(self.status.position, piece.to) > ELSEWHERE_MM {
                    let why =
                        "it stands elsewhere than it was told to: somebody stopped it at its panel"
                            .into();
                    return self.fail(Trouble::Alarm { number: 0, why, lost: false });
                }
            }
        }
        let probed = self.open.front().copied().filter(|_| piece.kind == Kind::Probe);
        self.is_done(piece.last);
        if let (Some(Order::Probe { active, .. }), Some(_)) =
            (probed.map(|it| it.order), self.contact)
        {
            self.tell_input(PROBE_INPUT, active);
        }
        self.heeds_locks();
    }

    /// Behind a contact it stands at the end of its ramp: it goes back to where the contact was.
    fn has_contact(&mut self, piece: Piece) {
        let Some(contact) = self.status.contact else { return };
        (self.contact, self.planned) = (Some(contact), contact);
        let words = |(letter, mm): (char, f64)| format!(" {letter}{mm:.5}");
        let axes = self.facts.as_ref().map_or(0, |facts| facts.axes);
        let places: String = "XYZABC".chars().zip(contact.0).take(axes).map(words).collect();
        let line = (piece.last, format!("G53 G1{places} F{BACK_MM_MIN}"));
        self.pieces.push_front(Piece { lines: vec![line], to: contact, ..piece });
    }

    fn tell_input(&mut self, line: u8, on: bool) {
        let was = self.inputs;
        self.inputs = with(self.inputs, line, on);
        if self.inputs != was {
            self.replies.push(Ok(Reply::Input { line, on }));
        }
    }

    /// Tells inputs that changed; the probe behind the order that it ends.
    fn tell_inputs(&mut self, inputs: u32) {
        let probes = self.open.iter().any(|sent| matches!(sent.order, Order::Probe { .. }));
        let first = if probes { PROBE_INPUT + 1 } else { PROBE_INPUT };
        for line in first..=u32::BITS as u8 {
            self.tell_input(line, inputs >> (line - 1) & 1 == 1);
        }
    }

    /// The line was gone: the bridge has stopped at once what was under way.
    pub(crate) fn is_back(&mut self) {
        let worked = !self.open.is_empty() || self.on != 0;
        self.greets();
        if worked {
            let why = "LinuxCNC was stopped by its bridge where it was, its outputs off";
            self.fail(Trouble::Gap { why });
        }
    }

    /// Returns the place that it told last.
    pub fn position(&self) -> Axes {
        self.status.position
    }
}
