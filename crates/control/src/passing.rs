//! Machine time as it passes for a run: the operator is heard, what is made goes on record.

use crate::OperatorRequest;
use crate::drive::Heard;
use crate::interruption::{Interruption, link_lost};
use crate::station::Station;
use kerf_journal::{AnswerSource, Kind, Placed};
use kerf_machine::state::RELEASE_S;
use kerf_machine::{Going, Watch};
use kerf_model::{Change, HaltCause, Watched};
use kerf_motion::Move;
use kerf_program::Interpreter;
use kerf_trace::{Event, flag};

/// Interval at which the progress of a move goes on record, seconds.
const RECORDED_EVERY_S: f64 = 0.02;

/// A machine that cuts the power of its motors does it so long after the emergency stop, seconds
/// (command reference, alpha tools).
const POWER_S: f64 = 5.0;

/// A way to let time pass that heeds the operator: also what he asked for before, or only what he asks for now.
pub(crate) type Ask<S> = fn(&mut S, f64, f64, Option<&Going<'_>>) -> Option<(f64, Heard)>;

impl<I: Interpreter> Station<'_, I> {
    /// Lets machine time pass. What was made before it is on record; while the machine moves, soon. A switch that the
    /// operator moves is told by the machine.
    pub(crate) fn pass(
        &mut self,
        from_s: f64,
        to_s: f64,
        going: Option<&Going<'_>>,
    ) -> Option<(f64, Heard)> {
        if to_s > from_s && self.drive.in_real_time() {
            self.world.workspace.tape.write();
            // What moves waits for no disk.
            if going.is_none() {
                self.world.workspace.tape.settle();
            }
        }
        loop {
            let heard = self.hear(to_s, |run, is_kept| {
                if is_kept {
                    run.watch_writing(from_s, to_s, going)
                } else {
                    run.watch(from_s, to_s, going)
                }
            });
            let (t_s, Heard::Operator(OperatorRequest::Input { number, on })) = heard? else {
                return heard;
            };
            if !self.press(number, on, t_s) {
                return Some((t_s, Heard::Input { number, on }));
            }
        }
    }

    /// Lets time pass up to a moment, unless an input that stops the machine or the operator comes before. The moment of
    /// the input may be over.
    pub(crate) fn meet(
        &mut self,
        end_s: f64,
        watched: &[Watched],
        going: Option<&Going<'_>>,
        ask: Ask<Self>,
    ) -> Option<(f64, Interruption)> {
        let now_s = self.world.now();
        // What was told on the way to a moment that the operator interrupted still stops the machine.
        let mut looked_s = self.world.model.told_s();
        loop {
            let machine = &self.world.model;
            let halt = match going {
                Some(_) => machine.halted(looked_s, watched),
                None => machine.halted_at_rest(looked_s, watched),
            };
            let level_s = next_level_s(watched, looked_s, end_s);
            let until_s = halt.map_or(level_s.unwrap_or(end_s), |halt| halt.t_s);
            match ask(self, now_s, until_s.max(now_s), going) {
                Some((t_s, Heard::Input { number, on })) => {
                    self.world.tracked().learn(number, on, t_s);
                    looked_s = looked_s.max(t_s);
                }
                Some((t_s, Heard::Operator(request))) => {
                    return Some((t_s, Interruption::Operator(request)));
                }
                None if self.drive.fault().is_some() => {
                    return Some((now_s, Interruption::Input(link_lost(now_s))));
                }
                None => match (halt, level_s) {
                    (Some(halt), _) => return Some((halt.t_s, Interruption::Input(halt))),
                    (None, Some(level_s)) => looked_s = level_s,
                    (None, None) => return None,
                },
            }
        }
    }

    /// Lets time pass; inputs that change meanwhile are noted, and only the operator ends it.
    fn pass_learning(
        &mut self,
        from_s: f64,
        to_s: f64,
        going: Option<&Going<'_>>,
    ) -> Option<(f64, OperatorRequest)> {
        loop {
            match self.pass(from_s, to_s, going)? {
                (t_s, Heard::Input { number, on }) => self.world.tracked().learn(number, on, t_s),
                (t_s, Heard::Operator(request)) => return Some((t_s, request)),
            }
        }
    }

    /// Returns what the tape tells, else what the world does; that is kept where there is a tape.
    fn hear(
        &mut self,
        to_s: f64,
        world: impl FnOnce(&mut Self, bool) -> Option<(f64, Heard)>,
    ) -> Option<(f64, Heard)> {
        match self.world.workspace.tape.turn(Kind::Request) {
            AnswerSource::Recorded(Some((t_s, request))) => {
                self.world.workspace.tape.write();
                Some((t_s, Heard::Operator(request)))
            }
            AnswerSource::Recorded(None) if self.world.model.draws() => None,
            AnswerSource::Recorded(None) => {
                self.drive.repeat(to_s, &self.world.model.settings().io)
            }
            AnswerSource::Live => world(self, false),
            AnswerSource::Open(call) => {
                let heard = world(self, true);
                self.keep(call, heard);
                heard
            }
        }
    }

    /// Keeps what was heard on the tape. A machine that repeats what it does tells its inputs once more instead.
    fn keep(&mut self, call: u64, heard: Option<(f64, Heard)>) {
        let request = heard.and_then(|(t_s, heard)| match heard {
            Heard::Operator(request) => Some((t_s, request)),
            Heard::Input { .. } if self.drive.repeats() => None,
            Heard::Input { number, on } => Some((t_s, OperatorRequest::Input { number, on })),
        });
        let tape = &mut self.world.workspace.tape;
        tape.heard(Kind::Request, call, request.as_ref());
        match request {
            Some((_, OperatorRequest::Stop | OperatorRequest::Hold)) => tape.stops(),
            Some((_, OperatorRequest::Input { number, .. })) => tape.presses(number),
            _ => {}
        }
        if request.is_some() {
            tape.write();
        }
    }

    fn watch(&mut self, from_s: f64, to_s: f64, going: Option<&Going<'_>>) -> Option<(f64, Heard)> {
        self.world.pass(&mut self.drive, from_s, to_s, going, self.feed)
    }

    /// While time passes as it does in the world, how far a move has come is on record: what is made
    /// of it when the power fails is not cut again.
    fn watch_writing(
        &mut self,
        from_s: f64,
        to_s: f64,
        going: Option<&Going<'_>>,
    ) -> Option<(f64, Heard)> {
        let Some(under_way) = going.filter(|_| self.drive.in_real_time()) else {
            return self.watch(from_s, to_s, going);
        };
        let slices = ((to_s - from_s) / RECORDED_EVERY_S).ceil().max(1.0) as u64;
        let moment = |n: u64| from_s + (to_s - from_s) * n as f64 / slices as f64;
        for slice in 1..=slices {
            let (begin_s, end_s) = (moment(slice - 1), moment(slice));
            let request = self.watch(begin_s, end_s, going);
            if request.is_some() || slice == slices {
                return request;
            }
            // A way that is looked through again after something happened is on record already.
            if end_s <= self.recorded_s {
                continue;
            }
            self.recorded_s = end_s;
            let state = under_way.at(end_s);
            if state.move_index == under_way.index {
                let place = Placed { position: state.position, ..self.world.placed() };
                self.world.workspace.tape.comes_to(end_s);
                self.world.workspace.tape.makes(state.share * under_way.part, place);
            }
        }
        None
    }

    /// Returns what comes before a moment: a request of the operator, one that was postponed first, or an input.
    pub(crate) fn ask_pace(
        &mut self,
        from_s: f64,
        to_s: f64,
        going: Option<&Going<'_>>,
    ) -> Option<(f64, Heard)> {
        let Some((t_s, request)) = self.requests.pop_front() else {
            return self.pass(from_s, to_s, going);
        };
        let postponed = (t_s.clamp(from_s, to_s.max(from_s)), Heard::Operator(request));
        let heard = self.hear(to_s, |_, _| Some(postponed));
        if !matches!(heard, Some((_, Heard::Operator(_)))) {
            // Not yet, where this has happened before.
            self.requests.push_front((t_s, request));
        }
        heard
    }

    /// Takes the request off the record and queues it again; it is recorded when it is carried out.
    fn put_off(&mut self, request: (f64, OperatorRequest)) {
        self.world.workspace.tape.unhear_request();
        self.postpone(request);
    }

    /// Drops the stop that was recorded last: an input has stopped the machine already, or slows it down, and the
    /// operator is asked when it stands.
    fn forgo(&mut self) {
        self.world.workspace.tape.unhear_request();
        self.drive.heard();
    }

    /// Keeps a request that cannot be fulfilled now.
    pub(crate) fn postpone(&mut self, request: (f64, OperatorRequest)) {
        if !self.requests.iter().any(|(_, other)| *other == request.1) {
            self.requests.push_back(request);
        }
    }

    /// Does what another feed asks for where the plan stays what it is: the machine changes the speed by itself, or the
    /// request waits until nothing is watched. Returns `false` where the plan is made anew.
    pub(crate) fn leaves_plan(&mut self, share: f32, watches: &[Watch]) -> bool {
        if self.drive.overrides() {
            self.override_feed(share);
            return true;
        }
        let waits = !watches.is_empty() && self.drive.feed_waits();
        if waits {
            self.world.workspace.tape.unhear_request();
            self.world.workspace.tape.asks_again();
            if self.waiting_feed.replace(share).is_none() {
                let text =
                    "while an input is watched the speed stays: it changes at the next stand";
                self.world.tell(&Event::Message { text: text.into(), t: self.world.now() });
            }
        }
        waits
    }

    /// The feed that waited is asked for now.
    pub(crate) fn take_waiting_feed(&mut self) {
        if let Some(share) = self.waiting_feed.take() {
            self.postpone((self.world.now(), OperatorRequest::Feed(share)));
        }
    }

    /// The switch of an input is moved at a moment that is still to come, or in the next: the machine tells that it
    /// changes. Returns `false` where nobody moves switches but the machine.
    pub(crate) fn press(&mut self, input: u8, on: bool, at_s: f64) -> bool {
        let at_s = at_s.max(self.world.now().next_up());
        self.world.hands.press(Change { input, on, at_s })
    }

    /// Sets the feed override: cuts run at this share of their speed.
    pub(crate) fn override_feed(&mut self, share: f32) {
        let (least, most) = Move::FEEDS;
        let share = if share.is_nan() { 1.0 } else { share.clamp(least, most) };
        if self.drive.overrides() {
            self.drive.feed(share);
        } else {
            self.feed = share;
        }
        let percent = (f64::from(share) * 1e3).round() / 10.0;
        self.world.tell(&Event::Override { percent, t: self.world.now() });
    }

    /// Time passes and nothing moves.
    pub(crate) fn stand_until(&mut self, end_s: f64) {
        let begin_s = self.world.now();
        let end_s = end_s.max(begin_s);
        self.world.tracked().advance(end_s);
        self.world.tally.waited(end_s - begin_s);
        self.world.tell_log();
    }

    /// Lets time pass while the machine slows down, to the end of a part of its way: it stands no sooner, whatever is told
    /// meanwhile. What the operator wants comes next; a switch that is moved is so at once.
    pub(crate) fn slow_down(&mut self, why: Interruption, end_s: f64, going: Going<'_>) {
        let mut from_s = self.world.now();
        let mut before = None;
        while let Some(told) = self.pass_learning(from_s, end_s, Some(&going)) {
            let (t_s, request) = told;
            // Whoever tells the same at the same moment goes on doing so until the machine stands.
            let repeats = before.replace(told) == Some(told);
            match request {
                OperatorRequest::End => {}
                OperatorRequest::Stop if why.is_stop() => {}
                _ if repeats => self.world.workspace.tape.unhear_request(),
                OperatorRequest::Stop | OperatorRequest::Hold if why.asks() => {
                    self.forgo();
                    self.world.workspace.tape.asks_again();
                }
                _ => {
                    self.put_off(told);
                    self.world.workspace.tape.asks_again();
                }
            }
            if repeats {
                break;
            }
            from_s = t_s;
        }
    }

    /// Has a machine that holds by itself do so on its path until the operator resumes: the plan stays what it is. Returns
    /// what is left to be answered; nothing where the run goes on.
    pub(crate) fn hold_on_path(
        &mut self,
        turn: Interruption,
        going: &Going<'_>,
    ) -> Option<Interruption> {
        if !matches!(turn, Interruption::Operator(OperatorRequest::Hold)) || !self.drive.holds() {
            return Some(turn);
        }
        let drive = &mut self.drive;
        let stands_s = self.world.workspace.tape.hear_rarely(Kind::Stood, || drive.hold(going));
        let Some(t) = stands_s else { return Some(turn) };
        self.world.shows(going, t, self.feed);
        self.world.tell(&Event::Hold { t });
        self.tell_standing(flag::PAUSED);
        if self.resumes(t).is_none() {
            return Some(Interruption::Operator(OperatorRequest::GiveUp));
        }
        if !self.world.silent {
            self.drive.goes_on();
        }
        self.world.workspace.tape.goes_on();
        self.world.tell(&Event::Resume { t });
        None
    }

    /// Waits until the operator has a held machine go on; tells when, or nothing when the run is given up.
    pub(crate) fn resumes(&mut self, held_s: f64) -> Option<f64> {
        let resumed = if self.is_open_for_take_up() {
            Some(held_s)
        } else {
            let drive = &mut self.drive;
            self.world.workspace.tape.change(Kind::Resume, || drive.resumes(held_s))
        };
        // The power went before the run was given up.
        resumed.or_else(|| self.is_open_for_take_up().then_some(held_s))
    }

    /// Has a machine that slows down by itself do so; tells the moment of the plan at which it stands.
    pub(crate) fn brake(&mut self, going: &Going<'_>) -> Option<f64> {
        let drive = &mut self.drive;
        self.world.workspace.tape.hear_rarely(Kind::Stood, || drive.brake(going))
    }

    /// Lets the warning pass. What stops the machine meanwhile is told.
    pub(crate) fn warn(&mut self, watched: &[Watched]) -> Option<Interruption> {
        let until_s = self.world.model.warn();
        self.world.tell_log();
        while self.world.now() < until_s {
            let turn = self.meet(until_s, watched, None, Self::pass);
            if self.drive.fault().is_some() {
                return turn.map(|(_, turn)| turn);
            }
            if let Some((t_s, Interruption::Operator(request @ OperatorRequest::Feed(_)))) = turn {
                self.postpone((t_s, request));
                continue;
            }
            self.stand_until(turn.map_or(until_s, |(t_s, _)| t_s));
            if turn.is_some() {
                return turn.map(|(_, turn)| turn);
            }
        }
        None
    }

    /// The machine stands.
    pub(crate) fn stand(&mut self) {
        self.drive.stands();
        self.world.model.rest();
        self.take_waiting_feed();
        self.world.tell_log();
        self.world.workspace.tape.moves(false, self.world.placed());
    }

    /// Tells whether a stop input forbids what the operator wants; he is told, and asked again in a moment.
    pub(crate) fn is_forbidden(&mut self) -> bool {
        let Some(active) = self.world.model.stop_input() else { return false };
        let t = self.world.now();
        let text = format!("stop input {active} is active: nothing moves before it is released");
        self.world.tell(&Event::Message { text: text.into(), t });
        match self.pass_learning(t, t + RELEASE_S, None) {
            Some((_, OperatorRequest::Stop | OperatorRequest::Hold)) => self.forgo(),
            request => request.into_iter().for_each(|request| self.put_off(request)),
        }
        self.stand_until(t + RELEASE_S);
        true
    }

    /// The motors keep the axes for a moment, then nothing does.
    pub(crate) fn cut_power(&mut self) {
        let t = self.world.now();
        self.world.tell_log();
        self.pass_learning(t, t + POWER_S, None).into_iter().for_each(drop);
        self.stand_until(t + POWER_S);
        self.world.model.motors_off();
    }

    /// The first stop of a machine that is held until a moment, and when it came.
    pub(crate) fn stops_held(&mut self, until_s: f64) -> Option<(f64, HaltCause)> {
        let active = self.world.model.stop_input();
        let active = active.map(|n| (self.world.now(), HaltCause::Stop(n)));
        active.or_else(|| {
            let watched = self.watched_at_rest();
            self.world.tracked().learn_until(until_s);
            let halt = self.world.model.halted_at_rest(until_s, watched.as_slice())?;
            matches!(halt.cause, HaltCause::Stop(_) | HaltCause::Watch(_))
                .then_some((halt.t_s, halt.cause))
        })
    }
}

/// Returns the next moment, up to another, from which on a state that is watched stops the machine.
fn next_level_s(watched: &[Watched], from_s: f64, end_s: f64) -> Option<f64> {
    let levels = watched.iter().filter_map(|watch| watch.level_from_s);
    levels.filter(|s| *s > from_s && *s <= end_s).min_by(f64::total_cmp)
}
