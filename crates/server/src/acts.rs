//! Carries out what pages ask for; the [gate](crate::gate) says who may.

use crate::app::App;
use crate::asker::Asker;
use crate::gate::{STOP_KEY, Way, driven_by};
use crate::interrupted;
use crate::job_told;
use crate::kind::kind_of;
use crate::locks::lock;
use crate::machine::link::{Held, Wanted};
use crate::machine::{Order, reach};
use crate::open::Open;
use crate::people::{Grip, GripError};
use crate::preview::Preview;
use crate::refusal::{Done, problem};
use crate::shop;
use crate::stop::Halt;
use kerf_control::{Jog, LIFT, Nudge, answers};
use kerf_program::{Axes, Axis};
use kerf_wire::{
    Act, Asked, Change, FileKind, Finding, Lease, Level, Machine, Overrides, Problem, StartUp,
    State, Tone, Who, Why,
};
use std::path::PathBuf;
use std::sync::Arc;

/// The questions of programs in which the tool may be lifted and moved, and goes back by itself.
const PROGRAM_ASKS: [&str; 2] = ["pause", "msgbox"];

fn typed(lines: &str) -> kerf_sbp::Program {
    kerf_sbp::read_typed("command".into(), &format!("{lines}\n"))
}

impl App {
    /// Does what a page asks for, if it may.
    ///
    /// # Errors
    /// Why not.
    pub fn act(self: &Arc<Self>, asker: &Asker, act: Act) -> Done {
        let who = &asker.who;
        self.gate(who, Way::Act(&act))?;
        self.hears_driver(who);
        match act {
            Act::Ping => {}
            Act::GiveUp => self.works.give_up(who.client),
            Act::Stop | Act::Hold | Act::Disarm | Act::JogStop { .. } => {
                if let Some(halt) = Halt::of(&act) {
                    halt.press(self, who.client);
                    halt.settle(self);
                }
            }
            Act::Resume { .. } => self.resume(asker)?,
            Act::Answer { question, answer } => self.answer(asker, question, answer)?,
            Act::TakeLease { force } => self.take_lease(who, force)?,
            Act::GiveLease { .. } => {
                self.drop_lease(|lease| lease.client == who.client, "nobody drives");
            }
            Act::Arm { .. } => self.arm()?,
            Act::Open { name, parameters } => {
                self.nothing_unsaved()?;
                self.open_with(&name, parameters)?;
            }
            Act::Parameters { parameters } => self.run_with(parameters)?,
            Act::Choose { choice } => self.choose(choice)?,
            Act::KeepOrigin => self.keep_origin()?,
            Act::SaveJob => self.save_job()?,
            Act::TakeShapeBack => self.take_shape_back()?,
            Act::Machine { drawing, anew } => {
                return self.machine(drawing.as_deref(), anew, &asker.awaited);
            }
            Act::Folder { name, mask } => self.choose_folder(&name, mask)?,
            Act::Record { line } => self.record(line)?,
            Act::Watch { names } => self.watch(names)?,
            Act::Input { number, on, lease } => self.press(asker, lease, number, on)?,
            Act::Set { key, value, .. } => self.configure(&key, &value)?,
            Act::Close => {
                self.nothing_unsaved()?;
                self.close_file();
            }
            Act::Run { hash, step, .. } => self.run(asker, &hash, step)?,
            Act::TakeUp { .. } => self.take_up(asker)?,
            Act::Command { line, .. } => self.command(asker, line)?,
            Act::JogStart { seq, clock_ms, direction, distance, speed_share: speed, .. } => {
                let order = Order::Jog { direction, distance, speed };
                if !makes_sense(&order) {
                    let text = "a jog has a direction, a share of the speed above 0, and perhaps a distance";
                    return Err(problem(Why::Malformed, text));
                }
                self.jog(asker, self.grip(who, seq, clock_ms)?, order)?;
            }
            Act::JogRenew { seq, clock_ms, .. } => {
                self.renew(who, self.grip(who, seq, clock_ms)?)?;
            }
            Act::Key { seq, key, clock_ms, .. } => {
                let stamp = clock_ms.filter(|_| key != STOP_KEY);
                let grip = stamp
                    .map_or(Ok(Grip { seq, at: self.clock.now() }), |ms| self.grip(who, seq, ms))?;
                self.press_key(asker, grip, key)?;
            }
            Act::Lift { question, .. } => self.lift(asker, question)?,
            Act::Nudge { axis, distance, .. } => self.nudge(asker, axis, distance)?,
            Act::Go { way, .. } => self.go(asker, way)?,
            Act::Bit { name, on, .. } => self.switch_bit(asker, &name, on)?,
            Act::Step { motor, forward, .. } => self.step_motor(asker, &motor, forward)?,
            Act::Override { feed_percent, .. } => self.override_feed(feed_percent)?,
            Act::SheetDone => self.sheet_done(),
            Act::ClearPrinted => self.hub.change(vec![Change::ClearPrinted]),
            Act::Acknowledge => self.acknowledge(),
            Act::Draw { op } => return self.draw(op, &asker.awaited),
            Act::Protect { password, new } => self.protect(who, password.as_deref(), new)?,
            Act::Unlock { password } => self.unlock(who, &password)?,
        }
        Ok(Vec::new())
    }

    pub fn state(&self) -> State {
        self.hub.read(|now| now.machine.state)
    }

    /// Carries out what the start-up line says, for whoever started Kerf here.
    pub fn start_up(&self) {
        let lines = self.options.begin_with.clone();
        if !lines.is_empty() {
            let sent = self.send(Order::StartUp { lines, since: self.link.stops() });
            sent.unwrap_or_else(|why| self.hub.say(Tone::Error, why.text));
        }
    }

    /// The machine is disarmed, whose stop has come already.
    pub fn tell_disarmed(&self, why: &str) {
        self.hub.changing(|now| {
            self.link.arrived().disarmed();
            vec![disarmed(&now.machine, why)]
        });
    }

    fn arm(&self) -> Result<(), Problem> {
        let mut alarm = false;
        self.hub.changing(|now| {
            alarm = now.machine.state == State::Alarm;
            let machine = Machine { armed: true, why: None, ..now.machine.clone() };
            if alarm { Vec::new() } else { vec![Change::Machine { machine }] }
        });
        if alarm { Err(problem(Why::State, "take note of the alarm first")) } else { Ok(()) }
    }

    fn acknowledge(&self) {
        self.hub.changing(|now| {
            if now.machine.state != State::Alarm {
                return Vec::new();
            }
            let machine = Machine { state: State::Idle, armed: false, ..now.machine.clone() };
            vec![Change::Machine { machine }]
        });
    }

    fn take_lease(&self, who: &Who, force: bool) -> Result<(), Problem> {
        let mut taken = Ok(());
        self.hub.changing(|now| {
            let jogs = now.machine.state == State::Jogging;
            match &now.lease {
                Some(lease) if lease.client == who.client => return Vec::new(),
                Some(lease) if !force || jogs => {
                    taken = Err(driven_by(lease));
                    return Vec::new();
                }
                Some(_) => self.link.forestall(),
                None => {}
            }
            let (number, device) = (self.next_lease(), who.device.clone());
            self.turn.heard();
            let lease = Some(Lease { number, client: who.client, device });
            // Whoever drives now has not armed it.
            let armed = now.machine.armed && now.lease.is_none();
            let machine = Machine { armed, ..now.machine.clone() };
            vec![Change::Lease { lease }, Change::Machine { machine }]
        });
        taken
    }

    /// No page opens the sheet of the start-up line any more.
    fn sheet_done(&self) {
        self.hub.changing(|now| match &now.start {
            Some(start) if start.sheet => {
                let start = Some(StartUp { sheet: false, ..start.clone() });
                vec![Change::Start { start }]
            }
            _ => Vec::new(),
        });
    }

    /// Nobody drives any more: nothing moves before somebody arms the machine again. A job goes on.
    pub fn drop_lease(&self, is_it: impl FnOnce(&Lease) -> bool, why: &str) {
        self.hub.changing(|now| {
            if !now.lease.as_ref().is_some_and(is_it) {
                return Vec::new();
            }
            self.link.forestall();
            self.link.release(|_| true);
            vec![Change::Lease { lease: None }, disarmed(&now.machine, why)]
        });
    }

    /// Somebody has connected or gone.
    pub fn tell_clients(&self) {
        self.hub.change(vec![Change::Clients { clients: self.pages.list() }]);
    }

    /// A page has gone: its jog ends, and its turn at driving.
    pub fn gone(&self, client: u32) {
        self.link.release(|held| held.client == client);
        self.drop_lease(|lease| lease.client == client, "the page that drove has gone");
    }

    fn resume(&self, asker: &Asker) -> Result<(), Problem> {
        match self.state() {
            State::Held => self.want_of(asker, Way::GoOn, |wanted| wanted.resume = true)?,
            State::Stopped => {
                let number = self.hub.read(|now| now.asked.as_ref().map(|a| a.number));
                let resume = |number| self.answer(asker, number, "Resume".into());
                return number.map_or(Ok(()), resume);
            }
            _ => return Err(problem(Why::State, "nothing is held")),
        }
        Ok(())
    }

    /// Answers a question, the first counts; with a word behind which the machine goes on only as whoever drives it
    /// still, and not where it was stopped meanwhile.
    fn answer(&self, asker: &Asker, question: u32, answer: String) -> Result<(), Problem> {
        let asked = self.hub.read(|now| now.asked.clone());
        let Some(asked) = asked.filter(|asked| asked.number == question) else {
            return Err(not_open());
        };
        check_answer(&asked, &answer)?;
        let act = Act::Answer { question, answer: answer.clone() };
        let counts = self.want_of(asker, Way::Act(&act), |wanted| wanted.give(question, answer))?;
        let late = || problem(Why::Late, "somebody else has answered this question");
        counts.then_some(()).ok_or_else(late)
    }

    fn run(&self, asker: &Asker, hash: &str, step: bool) -> Result<(), Problem> {
        let open = lock(&self.open).clone();
        self.has_tool_path(&open)?;
        if open.name.is_empty() || open.hash != hash {
            return Err(problem(Why::Changed, "this is not the file that is open"));
        }
        if let Some(question) = self.waits_for_start(hash) {
            return self.answer(asker, question, "Resume".into());
        }
        let Some(preview) = open.preview.clone() else {
            return Err(problem(Why::State, "the preview is not ready"));
        };
        if preview.failed {
            return Err(problem(Why::Mistake, mistakes(&preview)));
        }
        self.unchanged(&open, &preview)?;
        let (work, planned) = (Box::new(self.work(&open)?), preview.planned.clone());
        let parameters = shop::parameters(&open.parameters);
        let parameters = kerf_sbp::FileParameters { stepped: step, ..parameters };
        let taken = work.takes_origin(lock(&self.left).session.memory.position);
        let opened = self.opened(&asker.who, None).is_ok();
        let noticed = self.noticed(&open);
        let Open { name, hash, key, .. } = open;
        let order = Order::File { work, name, hash, planned, parameters, opened };
        let taken = taken.map(|at| (key, at));
        let before = std::mem::replace(&mut *lock(&self.taken), taken);
        // A job that runs keeps the origin that it took when somebody presses Start again.
        self.order_of(asker, order).inspect_err(|_| *lock(&self.taken) = before)?;
        noticed.into_iter().for_each(|text| self.hub.say(Tone::Warning, text));
        Ok(())
    }

    /// Warnings about the file of a job, which whoever starts it is told once more.
    fn noticed(&self, open: &Open) -> Vec<String> {
        match kind_of(&open.name) {
            FileKind::Job => job_told::warnings(&open.bytes, self.shaping().factor),
            _ => Vec::new(),
        }
    }

    /// Checks that what was previewed is what runs: the file, and those that it calls.
    fn unchanged(&self, open: &Open, preview: &Preview) -> Result<(), Problem> {
        let changed = |what: &str| {
            let text = format!("{what} was changed since it was previewed; open the file again");
            Err(problem(Why::Changed, text))
        };
        if !open.is_of(&self.parts.read(&open.name)?) {
            return changed("the file");
        }
        let other = |(path, bytes): &(&PathBuf, &Arc<[u8]>)| {
            std::fs::read(path).map_or(true, |now| now[..] != bytes[..])
        };
        match preview.called.iter().find(other) {
            Some((path, _)) => changed(&self.parts.name_of(&path.display().to_string())),
            None => Ok(()),
        }
    }

    /// Goes on with the run that was cut short.
    fn take_up(&self, asker: &Asker) -> Result<(), Problem> {
        let Some(interrupted) = self.hub.read(|now| now.interrupted.clone()) else {
            return Err(problem(Why::State, "no run was cut short"));
        };
        let hash = interrupted::hash_of_open(&interrupted, lock(&self.open).clone());
        let workspace = self.preview_workspace().ok();
        let plan = self.journal().zip(workspace);
        // Without a plan it runs as well; how far it is is not known then.
        let planned =
            plan.and_then(|(journal, mut workspace)| interrupted::plan(&journal, &mut workspace));
        self.order_of(asker, Order::TakeUp { hash, planned: planned.unwrap_or_default() })
    }

    fn command(&self, asker: &Asker, line: String) -> Result<(), Problem> {
        if let Some(mistake) = typed(&line).diagnostics.iter().find(|found| found.is_error()) {
            let hint = &mistake.hint;
            let hint = if hint.is_empty() { String::new() } else { format!(" ({hint})") };
            return Err(problem(Why::Mistake, format!("{}{hint}", mistake.message)));
        }
        let opened = self.opened(&asker.who, None).is_ok();
        let file = self.file_of_typed(&line);
        self.order_of(asker, Order::Command { line, opened, file })
    }

    fn nudge(&self, asker: &Asker, axis: char, distance: f64) -> Result<(), Problem> {
        let Some(axis) = Axis::from_letter(axis).filter(|_| distance.is_finite()) else {
            return Err(problem(Why::Malformed, "an axis and a distance are needed"));
        };
        match self.question_for_hands("hold") {
            Some(question) => self.nudge_in_question(asker, question, axis, distance),
            None => self.order_of(asker, Order::Nudge(axis, distance)),
        }
    }

    /// A nudge is an answer to the question after a stop, in the unit of the axis.
    fn nudge_in_question(
        &self,
        asker: &Asker,
        question: u32,
        axis: Axis,
        distance: f64,
    ) -> Result<(), Problem> {
        let units = self.hub.read(|now| now.units.axes.clone());
        let unit = units.iter().find(|unit| unit.letter == axis.letter());
        let nudge = Nudge { axis, distance: distance / unit.map_or(1.0, |unit| unit.scale) };
        let give = |wanted: &mut Wanted| wanted.give(question, nudge.to_string());
        let counts = self.want_of(asker, Way::GoOn, give)?;
        counts.then_some(()).ok_or_else(not_open)
    }

    fn override_feed(&self, feed_percent: f64) -> Result<(), Problem> {
        if !(10.0..=200.0).contains(&feed_percent) {
            return Err(problem(Why::Malformed, "overrides are 10 to 200 percent"));
        }
        if self.state() == State::Idle {
            let overrides = Overrides { feed_percent };
            self.hub.change(vec![Change::Overrides { overrides }]);
        }
        self.link.want(|wanted| wanted.feed = Some((feed_percent / 100.0) as f32));
        Ok(())
    }

    /// Begins a jog, unless its own stop came before, or it came so late that nobody knows whether it is held.
    pub fn jog(&self, asker: &Asker, grip: Grip, order: Order) -> Result<(), Problem> {
        let who = &asker.who;
        let held = Held::pressed(who.client, self.pages.jog_begins(who.client, grip)?);
        if held.is_over(self.clock.now()) {
            let text = "the key was pressed too long ago: the link is slow; press it anew";
            return Err(problem(Why::Late, text));
        }
        if self.link.lock().jog.is_some() {
            return Err(problem(Why::State, "another jog is not over yet"));
        }
        match self.question_for_hands("keypad hold paused pause msgbox") {
            Some(question) => self.jog_in_question(asker, question, held, &order),
            None => self.order_held(asker, order, held),
        }
    }

    /// Lifting is an answer to a question of the program; afterwards it is asked again.
    fn lift(&self, asker: &Asker, question: u32) -> Result<(), Problem> {
        let open = self.hub.read(|now| {
            let asked = now.asked.as_ref().filter(|asked| asked.number == question);
            asked.is_some_and(|asked| PROGRAM_ASKS.contains(&asked.kind.as_str()))
        });
        let counts =
            open && self.want_of(asker, Way::GoOn, |wanted| wanted.give(question, LIFT.into()))?;
        let late = || problem(Why::Late, "no program asks this any more: nothing is lifted");
        counts.then_some(()).ok_or_else(late)
    }

    /// The number of the question that lets the tool be moved while it is open, where it is of one of these kinds.
    fn question_for_hands(&self, kinds: &str) -> Option<u32> {
        self.hub.read(|now| {
            let stands = matches!(now.machine.state, State::Asking | State::Stopped);
            let asked = now.asked.as_ref().filter(|_| stands)?;
            kinds.split(' ').any(|kind| asked.kind == kind).then_some(asked.number)
        })
    }

    /// A jog is an answer to the question; afterwards it is asked again.
    fn jog_in_question(
        &self,
        asker: &Asker,
        question: u32,
        held: Held,
        order: &Order,
    ) -> Result<(), Problem> {
        let Order::Jog { direction, distance, speed } = order else {
            return Err(problem(Why::State, "the machine is busy"));
        };
        let base = Axes(self.hub.read(|now| now.motion.at.base));
        let far = reach(&lock(&self.left).session.memory.settings, base, *direction, *distance);
        let jog = Jog { by: Axes(direction.map(|way| way * far)), speed: *speed };
        let counts = self.want_of(asker, Way::GoOn, |wanted| {
            let counts = wanted.jog.is_none() && wanted.give(question, jog.to_string());
            if counts {
                wanted.jog = Some(held);
            }
            counts
        })?;
        counts.then_some(()).ok_or_else(not_open)
    }

    /// A sign of the hand of a page, stamped with the clock of the server, ms.
    fn grip(&self, who: &Who, seq: u64, clock_ms: f64) -> Result<Grip, Problem> {
        Ok(self.pages.grip(who.client, seq, clock_ms, self.clock.now())?)
    }

    pub fn renew(&self, who: &Who, grip: Grip) -> Result<(), Problem> {
        self.pages.jog_holds(who.client, grip);
        let now = self.clock.now();
        let renews = |held: &mut Held| held.renew(who.client, grip, now);
        let renewed = self.link.want(|wanted| wanted.jog.as_mut().is_some_and(renews));
        if renewed { Ok(()) } else { Err(problem(Why::Late, "this jog is over")) }
    }

    /// Lets go of a key of a page; of whatever is held where no jog is named.
    pub fn release_jog(&self, client: u32, seq: Option<u64>) {
        let Some(seq) = seq else { return self.link.release(|_| true) };
        self.pages.jog_over(client, seq);
        self.link.release(|held| held.client == client && held.seq == seq);
    }
}

/// Says why a file that has mistakes is not started.
fn mistakes(preview: &Preview) -> String {
    let first = preview.findings.iter().find(|found| found.level == Level::Error);
    first.map_or("the file cannot run".into(), |Finding { line, message, .. }| {
        format!("the file has mistakes, the first in line {line}: {message}")
    })
}

/// The machine is disarmed from now on. The reason of an alarm is what a person has to know, whoever comes or goes.
fn disarmed(machine: &Machine, why: &str) -> Change {
    let alarm = machine.why.clone().filter(|_| machine.state == State::Alarm);
    let why = alarm.or_else(|| Some(why.to_owned()));
    Change::Machine { machine: Machine { armed: false, why, ..machine.clone() } }
}

/// Looks whether an answer means something to a question.
fn check_answer(asked: &Asked, answer: &str) -> Result<(), Problem> {
    let button = |word: &String| word.eq_ignore_ascii_case(answer.trim());
    let free = asked.entry || ["hold", "step", "paused"].contains(&asked.kind.as_str());
    if asked.kind == "paused" && !answers::is_word(answer) {
        let text = format!("'{answer}' is nothing that a job that waits could be told");
        return Err(problem(Why::Mistake, text));
    }
    if !free && !asked.buttons.iter().any(button) {
        let text = format!("answer one of {}", asked.buttons.join(", "));
        return Err(problem(Why::Mistake, text));
    }
    Ok(())
}

fn not_open() -> Problem {
    problem(Why::Late, "this question is not open any more")
}

impl From<GripError> for Problem {
    fn from(error: GripError) -> Self {
        let why = if error == GripError::Far { Why::Malformed } else { Why::Late };
        problem(why, error.to_string())
    }
}

/// Returns `true` if a jog goes somewhere and its numbers are within bounds.
fn makes_sense(order: &Order) -> bool {
    let Order::Jog { direction, distance, speed } = order else { return false };
    let goes = direction.iter().any(|way| *way != 0.0);
    let bounded = direction.iter().all(|share| share.abs() <= 1.0);
    goes && bounded
        && *speed > 0.0
        && *speed <= 1.0
        && distance.is_none_or(|mm| mm > 0.0 && mm.is_finite())
}
