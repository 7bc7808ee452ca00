//! Carries out what pages ask for; the [gate](crate::gate) says who may.

use crate::act_checks;
use crate::app::App;
use crate::asker::Asker;
use crate::gate::{Demand, STOP_KEY, open_here, pass};
use crate::hands::makes_sense;
use crate::height_map;
use crate::machine::Order;
use crate::people::Grip;
use crate::refusal::{Done, problem};
use crate::stop::StopPress;
use crate::tools;
use kerf_machine::driver::Override;
use kerf_wire::{Act, Change, Problem, StartUp, State, Tone, Who, Why};
use std::sync::Arc;

impl App {
    /// Somebody asks for something, which has arrived this moment.
    pub fn hears(&self, who: &Who) -> Asker {
        Asker::of(who, self.link.stops())
    }

    /// Decides whether somebody may have something done.
    ///
    /// # Errors
    /// Why not.
    pub fn gate(&self, who: &Who, demand: Demand<'_>) -> Result<(), Problem> {
        if let Demand::Act(act) = demand {
            open_here(&self.options, act)?;
        }
        let need = self.hub.read(|now| pass(now, who, demand))?;
        if need.is_protected() { self.settings.opened(who, None) } else { Ok(()) }
    }

    /// Does what a page asks for, if it may.
    ///
    /// # Errors
    /// Why not.
    pub fn act(self: &Arc<Self>, asker: &Asker, act: Act) -> Done {
        let who = &asker.who;
        self.gate(who, Demand::Act(&act))?;
        self.driving.hears_driver(who);
        match act {
            Act::Ping => {}
            Act::GiveUp => self.works.give_up(who.client),
            Act::Stop | Act::Hold | Act::Disarm | Act::JogStop { .. } => self.halt(who, &act),
            Act::Resume { .. } => self.runs.resume(asker)?,
            Act::Answer { question, answer } => self.runs.answer(asker, question, answer)?,
            Act::TakeLease { force } => self.driving.take_lease(who, force)?,
            Act::GiveLease { .. } => self.give_lease(who),
            Act::Arm { .. } => self.driving.arm()?,
            Act::Open { name, parameters } => self.open_file(&name, parameters)?,
            Act::Parameters { parameters } => self.loader.run_with(parameters)?,
            Act::Choose { choice } => self.jobs.choose(choice)?,
            Act::KeepOrigin => self.jobs.keep_origin()?,
            Act::SaveJob => self.jobs.save_job()?,
            Act::TakeShapeBack => self.jobs.take_shape_back()?,
            Act::Machine { drawing, anew } => {
                return self.jobs.machine(drawing.as_deref(), anew, &asker.awaited);
            }
            Act::Folder { name, mask } => {
                act_checks::choose_folder(&self.orders, &self.files.folder, &name, mask)?
            }
            Act::Record { line } => act_checks::record(&self.orders, line)?,
            Act::Watch { names } => act_checks::watch(&self.orders, &self.link, names)?,
            Act::Input { number, on, lease } => self.press(asker, (lease, number, on))?,
            Act::Set { key, value, .. } => self.settings.configure(who, &key, &value)?,
            Act::Close => self.close_file()?,
            Act::Run { hash, step, .. } => self.runs.run(asker, &hash, step)?,
            Act::TakeUp { .. } => self.runs.take_up(asker)?,
            Act::Command { line, .. } => self.type_line(asker, line)?,
            Act::JogStart { seq, clock_ms, direction, distance, speed_share: speed, .. } => {
                self.jog(asker, (seq, clock_ms), Order::Jog { direction, distance, speed })?;
            }
            Act::JogRenew { seq, clock_ms, .. } => self.hands.renew_at(who, (seq, clock_ms))?,
            Act::Key { seq, key, clock_ms, .. } => self.press_key(asker, (seq, clock_ms), key)?,
            Act::Lift { question, .. } => self.hands.lift(asker, question)?,
            Act::Nudge { axis, distance, .. } => self.hands.nudge(asker, axis, distance)?,
            Act::Go { way, .. } => self.hands.go(asker, way)?,
            Act::Bit { name, on, .. } => self.hands.switch_bit(asker, &name, on)?,
            Act::Step { motor, forward, .. } => self.hands.step_motor(asker, &motor, forward)?,
            Act::Zero { name, change, .. } => self.hands.zero(asker, name, change)?,
            Act::ForgetPace { .. } => self.orders.order_of(asker, Order::ForgetPace)?,
            act @ (Act::Tool { .. }
            | Act::ToolIn { .. }
            | Act::TouchOff { .. }
            | Act::ControllerSteps { .. }) => tools::hears(self, asker, act)?,
            Act::ControllerCard { task, .. } => self.card.hears(asker, task)?,
            Act::HeightMap { change, .. } => height_map::change(self, asker, change)?,
            act @ (Act::Wire { .. } | Act::WireLook { .. } | Act::WireAnswer { .. }) => {
                self.wirings.hears(asker, act)?;
            }
            Act::Override { feed_percent, rapid_percent, spindle_percent, .. } => {
                self.turn_overrides(feed_percent, [rapid_percent, spindle_percent])?;
            }
            Act::SheetDone => self.sheet_done(),
            Act::ClearPrinted => self.hub.change(vec![Change::ClearPrinted]),
            Act::Acknowledge => self.driving.acknowledge(),
            Act::Draw { op } => return self.drawing.draw(op, &asker.awaited),
            Act::Protect { password, new } => {
                self.settings.protect(who, password.as_deref(), new)?
            }
            Act::Unlock { password } => self.settings.unlock(who, &password)?,
        }
        Ok(Vec::new())
    }

    /// Moves a switch of a machine whose switches are moved on a page: the turn at driving, its number, whether it is on.
    fn press(&self, asker: &Asker, pressed: (u32, u8, bool)) -> Result<(), Problem> {
        act_checks::press(&self.orders, &self.hands.pins_moved_here()?, asker, pressed)
    }

    /// Carries out a line that was typed: a setting of the controller (`$120=300`), a question for it (`$I`), else a line of
    /// OpenSBP.
    fn type_line(&self, asker: &Asker, line: String) -> Result<(), Problem> {
        if self.hands.keep_setting(asker, &line)? || self.hands.ask_controller(asker, &line)? {
            return Ok(());
        }
        self.runs.command(asker, line)
    }

    /// Opens a file, with nothing of the one before unsaved.
    fn open_file(&self, name: &str, parameters: kerf_wire::FileParameters) -> Result<(), Problem> {
        self.loader.nothing_unsaved()?;
        self.look_beside(name)?;
        self.loader.open_with(name, parameters)
    }

    /// Closes the open file, with nothing of it unsaved.
    fn close_file(&self) -> Result<(), Problem> {
        self.loader.nothing_unsaved()?;
        self.loader.close_file();
        Ok(())
    }

    /// Looks for the next part files where one is opened. While something runs it goes on with the folder that it has.
    fn look_beside(&self, name: &str) -> Result<(), Problem> {
        let folder = name.rsplit_once('/').map_or("", |(folder, _)| folder);
        let now = self.hub.now();
        if now.folder.name == folder || now.machine.state != State::Idle {
            return Ok(());
        }
        act_checks::choose_folder(&self.orders, &self.files.folder, folder, None)
    }

    fn give_lease(&self, who: &Who) {
        self.driving.drop_lease(|lease| lease.client == who.client, "nobody drives");
    }

    fn halt(&self, who: &Who, act: &Act) {
        if let Some(halt) = StopPress::of(act) {
            halt.press(self, who.client);
            halt.settle(self);
        }
    }

    /// Begins a jog by a key that was pressed at a moment of the page's clock.
    fn jog(&self, asker: &Asker, (seq, clock_ms): (u64, f64), order: Order) -> Result<(), Problem> {
        if !makes_sense(&order) {
            let text =
                "a jog has a direction, a share of the speed above 0, and perhaps a distance";
            return Err(problem(Why::Malformed, text));
        }
        self.hands.jog(asker, self.hands.grip(&asker.who, seq, clock_ms)?, order)
    }

    /// Passes on a key of the hand console; its STOP key is heard however late it comes.
    fn press_key(
        &self,
        asker: &Asker,
        (seq, clock_ms): (u64, Option<f64>),
        key: char,
    ) -> Result<(), Problem> {
        let stamp = clock_ms.filter(|_| key != STOP_KEY);
        let now = || Ok(Grip { seq, at: self.clock.now() });
        let grip = stamp.map_or_else(now, |ms| self.hands.grip(&asker.who, seq, ms))?;
        self.keys.press(asker, grip, key)
    }

    /// Turns the overrides that are given: of the feed, of rapid moves and of the spindle, percent.
    fn turn_overrides(
        &self,
        feed: Option<f64>,
        [rapid, spindle]: [Option<u8>; 2],
    ) -> Result<(), Problem> {
        feed.map_or(Ok(()), |percent| self.runs.override_feed(percent))?;
        let rapid = rapid.map(Override::Rapid);
        self.runs.turn(rapid.into_iter().chain(spindle.map(Override::Spindle)))
    }

    /// Carries out what the start-up line says, for whoever started Kerf here.
    pub fn start_up(&self) {
        let lines = self.options.begin_with.clone();
        if !lines.is_empty() {
            let sent = self.orders.send(Order::StartUp { lines, since: self.link.stops() });
            sent.unwrap_or_else(|why| self.hub.say(Tone::Error, why.text));
        }
    }

    /// Closes the sheet of the start-up line on every page.
    fn sheet_done(&self) {
        self.hub.changing(|now| match &now.start {
            Some(start) if start.sheet => {
                let start = Some(StartUp { sheet: false, ..start.clone() });
                vec![Change::Start { start }]
            }
            _ => Vec::new(),
        });
    }
}
