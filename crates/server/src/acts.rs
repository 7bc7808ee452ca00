//! What pages ask for: who may, when, and what is done.

use crate::app::{App, Open, lock, problem};
use crate::asker::Asker;
use crate::machine::link::{Held, Wanted};
use crate::machine::{Order, reach};
use crate::preview::Preview;
use crate::shop;
use kerf_control::{Jog, LIFT, answers};
use kerf_program::{Axes, Axis};
use kerf_wire::{
    Act, Change, Lease, Machine, Overrides, Problem, Role, Snapshot, StartUp, State, Who, Why,
};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

/// What came of an act: what was noticed, or why it was not done.
pub type Done = Result<Vec<String>, Problem>;

/// What an act needs.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Need {
    role: Role,
    /// Number of the lease that it carries.
    lease: Option<u32>,
    /// The machine has to be armed.
    armed: bool,
}

const fn need(role: Role) -> Need {
    Need { role, lease: None, armed: false }
}

const fn drive(lease: u32) -> Need {
    Need { role: Role::Operator, lease: Some(lease), armed: true }
}

const fn holding(lease: u32) -> Need {
    Need { role: Role::Operator, lease: Some(lease), armed: false }
}

/// Stop of the hand console.
const STOP_KEY: char = kerf_handconsole::Key::Stop.character();

/// What is said where the machine is left alone.
const DRAWING_ONLY: &str =
    "this is not available in the editing version: only drawings are worked on here";

/// The questions of programs in which the tool may be lifted and moved, and goes back by itself.
const PROGRAM_ASKS: [&str; 2] = ["pause", "msgbox"];

/// Whether an act leaves the machine alone: it is about drawings and files, or it only stops.
const fn is_of_drawings(act: &Act) -> bool {
    matches!(
        act,
        Act::Ping
            | Act::Stop
            | Act::Hold
            | Act::Disarm
            | Act::JogStop { .. }
            | Act::Draw { .. }
            | Act::Open { .. }
            | Act::Parameters { .. }
            | Act::Close
            | Act::ClearPrinted
            | Act::SheetDone
            | Act::Unlock { .. }
            | Act::Protect { .. }
    )
}

/// What is said where only files are run.
const FILES_ONLY: &str = "Kerf was started for files only: no commands, no keypad";

/// Whether an act is refused where only files are run.
fn is_by_hand(act: &Act) -> bool {
    match act {
        Act::Command { line, .. } => {
            let letters: String = line.trim().chars().take(2).collect();
            line.lines().count() != 1 || !letters.eq_ignore_ascii_case("FP")
        }
        Act::JogStart { .. }
        | Act::JogRenew { .. }
        | Act::Lift { .. }
        | Act::Nudge { .. }
        | Act::Key { .. } => true,
        _ => false,
    }
}

/// What an act needs. This is the one list.
fn needs(act: &Act) -> Need {
    match act {
        Act::Key { key: STOP_KEY, .. } => need(Role::Observer),
        Act::Stop | Act::Hold | Act::Disarm | Act::JogStop { .. } | Act::Ping => {
            need(Role::Observer)
        }
        Act::Resume { lease }
        | Act::Run { lease, .. }
        | Act::TakeUp { lease }
        | Act::JogStart { lease, .. }
        | Act::JogRenew { lease, .. }
        | Act::Lift { lease, .. }
        | Act::Nudge { lease, .. } => drive(*lease),
        Act::Command { lease, line } if changes_settings(line) => {
            Need { role: Role::Setter, ..drive(*lease) }
        }
        Act::Command { lease, .. } => drive(*lease),
        Act::GiveLease { lease }
        | Act::Arm { lease }
        | Act::Override { lease, .. }
        | Act::Key { lease, .. }
        | Act::Input { lease, .. } => holding(*lease),
        Act::Set { lease, .. } => Need { role: Role::Setter, ..holding(*lease) },
        Act::Protect { .. } | Act::Unlock { .. } => need(Role::Setter),
        Act::Answer { .. }
        | Act::TakeLease { .. }
        | Act::Open { .. }
        | Act::Parameters { .. }
        | Act::Choose { .. }
        | Act::KeepOrigin
        | Act::SaveJob
        | Act::TakeShapeBack
        | Act::Machine { .. }
        | Act::Folder { .. }
        | Act::Record { .. }
        | Act::Watch { .. }
        | Act::Close
        | Act::ClearPrinted
        | Act::SheetDone
        | Act::Acknowledge
        | Act::Draw { .. } => need(Role::Operator),
    }
}

/// Whether lines change what the machine is set to: the V commands and others that set it.
fn changes_settings(lines: &str) -> bool {
    typed(lines).sets_machine()
}

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
        if self.options.drawing_only && !is_of_drawings(&act) {
            return Err(problem(Why::State, DRAWING_ONLY));
        }
        let files_only = self.options.start.as_ref().is_some_and(|start| start.display == 9);
        if files_only && is_by_hand(&act) {
            return Err(problem(Why::State, FILES_ONLY));
        }
        self.allow(who, needs(&act))?;
        if matches!(&act, Act::Command { line, .. } if changes_settings(line)) {
            self.opened(who, None)?;
        }
        match act {
            Act::Ping => {}
            Act::Stop => self.link.stop(),
            Act::Hold => self.link.hold(),
            Act::Disarm => self.disarm("disarmed at a page"),
            Act::Resume { .. } => self.resume(asker)?,
            Act::Answer { question, answer } => self.answer(None, question, answer)?,
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
            Act::Machine { drawing, anew } => return self.machine(drawing.as_deref(), anew),
            Act::Folder { name, mask } => self.choose_folder(&name, mask)?,
            Act::Record { line } => self.record(line)?,
            Act::Watch { names } => self.watch(names)?,
            Act::Input { number, on, .. } => self.press(number, on)?,
            Act::Set { key, value, .. } => {
                self.opened(who, None)?;
                self.configure(&key, &value)?;
            }
            Act::Close => {
                self.nothing_unsaved()?;
                self.close_file();
            }
            Act::Run { hash, step, .. } => self.run(asker, &hash, step)?,
            Act::TakeUp { .. } => self.take_up(asker)?,
            Act::Command { line, .. } => self.command(asker, line)?,
            Act::JogStart { seq, direction, distance, speed_share: speed, .. } => {
                let order = Order::Jog { direction, distance, speed };
                if !makes_sense(&order) {
                    let text = "a jog has a direction, a share of the speed above 0, and perhaps a distance";
                    return Err(problem(Why::Malformed, text));
                }
                self.jog(asker, seq, order)?;
            }
            Act::JogRenew { seq, .. } => self.renew(who, seq)?,
            Act::Lift { question, .. } => self.lift(asker, question)?,
            Act::JogStop { seq } => self.jog_stop(who, seq),
            Act::Key { seq, key, .. } => self.press_key(asker, seq, key)?,
            Act::Nudge { axis, distance, .. } => self.nudge(asker, axis, distance)?,
            Act::Override { feed_percent, .. } => self.override_feed(feed_percent)?,
            Act::SheetDone => self.sheet_done(),
            Act::ClearPrinted => self.hub.change(vec![Change::ClearPrinted]),
            Act::Acknowledge => self.acknowledge(),
            Act::Draw { op } => return self.draw(op),
            Act::Protect { password, new } => self.protect(who, password.as_deref(), new)?,
            Act::Unlock { password } => self.unlock(who, &password)?,
        }
        Ok(Vec::new())
    }

    /// Whether somebody drives the machine, which is armed; gives the number of the lease.
    ///
    /// # Errors
    /// Somebody else drives, or nobody, or the machine is disarmed.
    pub fn drives(&self, who: &Who) -> Result<u32, Problem> {
        self.hub.read(|now| drives(now, who))
    }

    /// Whether whoever drives may change settings of the machine.
    ///
    /// # Errors
    /// As [`App::drives`]; or the role is another, or a password protects them.
    pub fn sets(&self, who: &Who) -> Result<(), Problem> {
        let lease = self.drives(who)?;
        self.allow(who, Need { role: Role::Setter, ..drive(lease) })?;
        self.opened(who, None)
    }

    fn allow(&self, who: &Who, need: Need) -> Result<(), Problem> {
        self.hub.read(|now| allowed(now, who, need))
    }

    pub fn state(&self) -> State {
        self.hub.read(|now| now.machine.state)
    }

    /// Nothing begins any more, and what has begun is stopped.
    fn disarm(&self, why: &str) {
        self.hub.changing(|now| {
            self.link.stop();
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
    fn drop_lease(&self, is_it: impl FnOnce(&Lease) -> bool, why: &str) {
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
            State::Held => self.want_of(asker, |wanted| wanted.resume = true)?,
            State::Stopped => {
                let number = self.hub.read(|now| now.asked.as_ref().map(|a| a.number));
                let resume = |number| self.answer(Some(asker), number, "Resume".into());
                return number.map_or(Ok(()), resume);
            }
            _ => return Err(problem(Why::State, "nothing is held")),
        }
        Ok(())
    }

    /// Answers a question: anybody may, but for answers that stand for an act of somebody who drives.
    fn answer(&self, driver: Option<&Asker>, question: u32, answer: String) -> Result<(), Problem> {
        let asked = self.hub.read(|now| now.asked.clone());
        let Some(asked) = asked.filter(|asked| asked.number == question) else {
            return Err(problem(Why::Late, "this question is not open any more"));
        };
        let button = |word: &String| word.eq_ignore_ascii_case(answer.trim());
        let free = asked.entry || ["hold", "step", "paused"].contains(&asked.kind.as_str());
        if asked.kind == "paused" && !answers::is_word(&answer) {
            let text = format!("'{answer}' is nothing that a job that waits could be told");
            return Err(problem(Why::Mistake, text));
        }
        if !free && !asked.buttons.iter().any(button) {
            let text = format!("answer one of {}", asked.buttons.join(", "));
            return Err(problem(Why::Mistake, text));
        }
        let give = |wanted: &mut Wanted| wanted.give(question, answer);
        let counts = match driver {
            Some(driver) => self.want_of(driver, give)?,
            None => self.link.want(give),
        };
        // The first counts.
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
            return self.answer(Some(asker), question, "Resume".into());
        }
        let Some(preview) = open.preview.clone() else {
            return Err(problem(Why::State, "the preview is not ready"));
        };
        if preview.failed {
            return Err(problem(Why::Mistake, "the file has mistakes; see its messages"));
        }
        self.unchanged(&open, &preview)?;
        let (work, planned) = (Box::new(self.work(&open)?), preview.planned.clone());
        let parameters = shop::parameters(&open.parameters);
        let parameters = kerf_sbp::FileParameters { stepped: step, ..parameters };
        let taken = work.takes_origin(lock(&self.left).session.memory.position);
        let Open { name, hash, key, .. } = open;
        let opened = self.opened(&asker.who, None).is_ok();
        let order = Order::File { work, name, hash, planned, parameters, opened };
        let taken = taken.map(|at| (key, at));
        let before = std::mem::replace(&mut *lock(&self.taken), taken);
        // A job that runs keeps the origin that it took when somebody presses Start again.
        self.order_of(asker, order).inspect_err(|_| *lock(&self.taken) = before)
    }

    /// What was previewed is what runs: the file, and those that it calls.
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
        if self.hub.read(|now| now.interrupted.is_none()) {
            return Err(problem(Why::State, "no run was cut short"));
        }
        self.order_of(asker, Order::TakeUp)
    }

    fn command(&self, asker: &Asker, line: String) -> Result<(), Problem> {
        if let Some(mistake) = typed(&line).diagnostics.iter().find(|found| found.is_error()) {
            let hint = &mistake.hint;
            let hint = if hint.is_empty() { String::new() } else { format!(" ({hint})") };
            return Err(problem(Why::Mistake, format!("{}{hint}", mistake.message)));
        }
        let opened = self.opened(&asker.who, None).is_ok();
        self.order_of(asker, Order::Command { line, opened })
    }

    fn nudge(&self, asker: &Asker, axis: char, distance: f64) -> Result<(), Problem> {
        let Some(axis) = Axis::from_letter(axis).filter(|_| distance.is_finite()) else {
            return Err(problem(Why::Malformed, "an axis and a distance are needed"));
        };
        self.order_of(asker, Order::Nudge(axis, distance))
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

    /// Begins a jog, unless its own stop came before.
    pub fn jog(&self, asker: &Asker, seq: u32, order: Order) -> Result<(), Problem> {
        let who = &asker.who;
        if !self.pages.may_start(who.client, seq) {
            return Err(problem(Why::Late, "this jog is over already"));
        }
        if self.link.lock().jog.is_some() {
            return Err(problem(Why::State, "another jog is not over yet"));
        }
        let held = Held::pressed(who.client, seq);
        match self.question_for_hands() {
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
        let counts = open && self.want_of(asker, |wanted| wanted.give(question, LIFT.into()))?;
        let late = || problem(Why::Late, "no program asks this any more: nothing is lifted");
        counts.then_some(()).ok_or_else(late)
    }

    /// The question that lets the tool be moved while it is open: the keypad, the one after a stop, or one of a program
    /// that waits.
    fn question_for_hands(&self) -> Option<u32> {
        self.hub.read(|now| {
            let stands = matches!(now.machine.state, State::Asking | State::Stopped);
            let asked = now.asked.as_ref().filter(|_| stands)?;
            let kind = asked.kind.as_str();
            let hands =
                ["keypad", "hold", "paused"].contains(&kind) || PROGRAM_ASKS.contains(&kind);
            hands.then_some(asked.number)
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
        let counts = self.want_of(asker, |wanted| {
            let counts = wanted.jog.is_none() && wanted.give(question, jog.to_string());
            if counts {
                wanted.jog = Some(held);
            }
            counts
        })?;
        let late = || problem(Why::Late, "this question is not open any more");
        counts.then_some(()).ok_or_else(late)
    }

    pub fn renew(&self, who: &Who, seq: u32) -> Result<(), Problem> {
        let renewed = self.link.want(|wanted| {
            let held = wanted.jog.as_mut()?;
            let same = held.seq == seq && held.client == who.client && !held.is_over();
            same.then(|| held.renewed = Instant::now())
        });
        renewed.ok_or_else(|| problem(Why::Late, "this jog is over"))
    }

    fn jog_stop(&self, who: &Who, seq: u32) {
        self.pages.jog_over(who.client, seq);
        self.link.release(|held| held.client == who.client && held.seq == seq);
    }
}

/// Whether somebody may do what takes so much.
///
/// # Errors
/// Why not.
fn allowed(now: &Snapshot, who: &Who, need: Need) -> Result<(), Problem> {
    if who.role < need.role {
        let text = format!("this needs the role {:?}, this device is {:?}", need.role, who.role);
        return Err(problem(Why::Role, text.to_lowercase()));
    }
    if let Some(number) = need.lease {
        match &now.lease {
            Some(lease) if lease.number == number && lease.client == who.client => {}
            Some(lease) if lease.client == who.client => {
                return Err(problem(Why::Lease, "this belongs to an older turn at driving"));
            }
            Some(lease) => return Err(driven_by(lease)),
            None => return Err(problem(Why::Lease, "take the machine first")),
        }
    }
    if need.armed && !now.machine.armed {
        return Err(problem(Why::Disarmed, "the machine is disarmed: arm it first"));
    }
    Ok(())
}

/// Whether somebody drives the machine, which is armed; the number of the lease.
///
/// # Errors
/// As [`App::drives`].
pub fn drives(now: &Snapshot, who: &Who) -> Result<u32, Problem> {
    let lease = now.lease.as_ref().map_or(0, |lease| lease.number);
    allowed(now, who, drive(lease)).map(|()| lease)
}

/// The machine is disarmed from now on. The reason of an alarm is what a person has to know, whoever comes or goes.
fn disarmed(machine: &Machine, why: &str) -> Change {
    let alarm = machine.why.clone().filter(|_| machine.state == State::Alarm);
    let why = alarm.or_else(|| Some(why.to_owned()));
    Change::Machine { machine: Machine { armed: false, why, ..machine.clone() } }
}

/// Who has the machine, and how it is had from there.
fn driven_by(Lease { device, .. }: &Lease) -> Problem {
    let who = if device.is_empty() { "another page" } else { device };
    let text = format!(
        "somebody else drives: {who}. Press Give up control there, or close that page; another page \
         takes it with Take control"
    );
    problem(Why::Lease, text)
}

/// Whether a jog goes anywhere.
fn makes_sense(order: &Order) -> bool {
    let Order::Jog { direction, distance, speed } = order else { return false };
    let goes = direction.iter().any(|way| *way != 0.0);
    let bounded = direction.iter().all(|share| share.abs() <= 1.0);
    goes && bounded
        && *speed > 0.0
        && *speed <= 1.0
        && distance.is_none_or(|mm| mm > 0.0 && mm.is_finite())
}
