//! Chores of the machine's owner besides moving it: its files, recorder, switches, configuration.

use super::arrived::StopCount;
use super::owner::Owner;
use super::tool_length::{ZeroOfTool, zero_of_tool};
use crate::configure::changes_through;
use crate::gate::{self, Demand};
use crate::handconsole::Happening;
use crate::locks::lock;
use crate::setup::Workshop;
use crate::to_wire;
use kerf_control::AtRest;
use kerf_journal::{CutShort, Journal, JournalError};
use kerf_machine::Configuration;
use kerf_machine::table::Setting;
use kerf_program::{Axis, rounded};
use kerf_wire::{
    Change, CurrentRun, Folder, Interrupted, Machine, NamedValue, Recorder, SettingChange, State,
    Tone, ToolChange, Who,
};
use kerf_workspace::command_passing;
use kerf_workspace::height_map::{take_height_map_off, use_height_map};
use std::path::Path;
use std::sync::mpsc::Sender;

/// Said of what moves the machine and nobody at a page asked for.
const PASSED_IN: &str = "passed in by a program on this computer (uCommand)";

impl Owner {
    /// A command that other software passed in (`uCommand`), when it may be carried out now. It is
    /// taken away in any case: one that was left would surprise whoever arms the machine.
    pub(super) fn passed_in(&mut self) -> Option<String> {
        // It came since it was not there: a stop since then came behind it, for all anybody knows.
        let stops = self.link.stops();
        let arrived = self.looked.replace(stops).unwrap_or(stops);
        let journal = self.workshop.workspace.journal()?;
        let taken = journal.registry.take_in().and_then(|()| command_passing::take(journal));
        let told = match taken {
            Ok(None) => return None,
            Ok(Some(Ok(line))) => match self.may_run(Demand::PassedIn, arrived) {
                Ok(()) => {
                    let text = format!("{PASSED_IN}: {line}");
                    self.hub.say(Tone::Note, text);
                    return Some(line);
                }
                Err(why) => format!("{line} was passed in and not carried out: {why}"),
            },
            Ok(Some(Err(why))) => why,
            Err(error) => error.to_string(),
        };
        self.log_refused(&told);
        self.hub.say(Tone::Warning, format!("{}: {told}", command_passing::COMMAND));
        None
    }

    /// Notes that a command passed in from now on, if found when something else is over, came after every stop so far.
    pub(super) fn look_for_passed_in(&mut self) {
        let stops = self.link.stops();
        let journal = self.workshop.workspace.journal();
        let nothing = |journal: &Journal| {
            let registry = &journal.registry;
            registry
                .take_in()
                .and_then(|()| registry.value(command_passing::COMMAND))
                .is_ok_and(|it| it.is_none())
        };
        if journal.is_some_and(nothing) {
            self.looked = Some(stops);
        }
    }

    /// Enters in the system log that a command was refused.
    pub(super) fn log_refused(&mut self, told: &str) {
        let Workshop { session, workspace, .. } = &mut self.workshop;
        let (settings, draws) = (&session.memory.settings, session.is_in_preview());
        command_passing::log_refused(workspace, settings, draws, told);
    }

    /// Another Kerf may have had the machine: it stands elsewhere, and whoever armed it here looks first.
    pub(super) fn catch_up(&mut self) {
        let Workshop { session, workspace, kept, .. } = &mut self.workshop;
        let caught = if *kept { session.catch_up(workspace) } else { Ok(false) };
        match caught {
            Ok(false) => {}
            Ok(true) => {
                self.hub.say(Tone::Warning, "another Kerf has run the machine: it is disarmed");
                self.hub.changing(|now| {
                    // What began at this very moment is stopped.
                    self.link.stop();
                    let machine = Machine { armed: false, ..now.machine.clone() };
                    vec![Change::Machine { machine }]
                });
                self.begin();
            }
            // What cannot be read is told when something is to move.
            Err(_) => {}
        }
    }

    /// Carries out the start-up line. What a stop ends, or comes before, ends all of it.
    pub(super) fn start_up(&mut self, lines: &[String], since: StopCount) {
        for line in lines {
            if let Err(why) = self.may_run(Demand::StartUp, since) {
                let told = format!("{line} of the start-up line is not carried out: {why}");
                self.log_refused(&told);
                return self.hub.say(Tone::Warning, format!("{told}; start it here"));
            }
            self.command(line, false, None, false);
        }
    }

    /// The machine is busy from now on, where nobody at a page asked for it and it may move all the same; otherwise why
    /// not.
    fn may_run(&self, demand: Demand<'_>, arrived: StopCount) -> Result<(), String> {
        let mut may = Ok(());
        self.hub.changing(|now| {
            may = gate::pass(now, &Who::default(), demand).map(drop).map_err(|why| why.text);
            if may.is_ok() && now.machine.state != State::Idle {
                may = Err("the machine is busy".into());
            } else if may.is_ok() && !self.link.begin(Some(arrived), None) {
                may = Err("the machine was stopped meanwhile".into());
            }
            let machine = Machine { state: State::Running, why: None, ..now.machine.clone() };
            if may.is_ok() { vec![Change::Machine { machine }] } else { Vec::new() }
        });
        may
    }

    /// Moves the switches of the machine, which stands, that nothing which ran has moved. Whether there were any. It
    /// stays what it is: an alarm stands, and what has begun begins.
    pub(super) fn move_switches(&mut self) -> bool {
        let presses = std::mem::take(&mut self.link.lock().presses);
        for press in &presses {
            AtRest(&mut self.workshop.session).press(*press, &mut self.workshop.workspace);
        }
        if !presses.is_empty() {
            self.settle(Machine::clone);
        }
        !presses.is_empty()
    }

    /// The machine stands and was stopped, or nobody has armed it: what a stop switches off is off.
    pub(super) fn stop_at_rest(&mut self) {
        let (pressed, stopped) = self.hub.read(|now| {
            let stands = matches!(now.machine.state, State::Idle | State::Alarm);
            let pressed = self.link.lock().hear_stop_at_rest(stands);
            (pressed, pressed || stands && !now.machine.armed)
        });
        let driven = self.driven();
        if pressed && driven.borrow_mut().waits_for_tool() {
            driven.borrow_mut().gives_tool_up();
            let text = "the controller does not wait for a tool any more: it was stopped, and has given the change up";
            self.hub.say(Tone::Note, text);
        }
        if pressed {
            self.stop_card();
        }
        let Workshop { session, workspace, .. } = &mut self.workshop;
        if stopped && AtRest(session).stop(workspace, &driven) {
            self.settle(Machine::clone);
            self.hub.say(Tone::Note, "outputs are off: the machine was stopped or disarmed");
        }
    }

    /// Chooses the part folder.
    pub(super) fn enter(&mut self, path: &Path, mask: Option<&str>) {
        let workspace = &mut self.workshop.workspace;
        if let Err(error) = workspace.enter(Some(&path.display().to_string())) {
            self.hub.say(Tone::Error, format!("{} cannot be used: {error:?}", path.display()));
        } else if mask.is_some() {
            workspace.set_mask(mask);
        }
        self.rest(State::Idle, None);
    }

    /// Puts a line at the end of the recorder's list.
    pub(super) fn record(&mut self, line: &str) {
        self.workshop.workspace.record(line);
    }

    /// Takes a file of heights into force, or the map off.
    pub(super) fn take_height_map(&mut self, text: Option<&str>) {
        let workspace = &mut self.workshop.workspace;
        let kept = match text {
            Some(text) => use_height_map(workspace, text).map(drop),
            None => take_height_map_off(workspace),
        };
        if let Err(why) = kept {
            self.hub.say(Tone::Error, format!("the height map stays as it was: {why}"));
        }
        self.rest(State::Idle, None);
    }

    /// Changes a tool that is known by its number, and keeps it.
    pub(super) fn change_tool(&mut self, number: u32, change: &ToolChange) {
        self.catch_up();
        let Workshop { session, workspace, kept, .. } = &mut self.workshop;
        let mut zero = None;
        match change {
            ToolChange::Is { name, diameter, length } => {
                zero = zero_of_tool(session, workspace, number, *length);
                let tool = session.gcode.tools.entry(number).or_default();
                tool.name = (!name.is_empty()).then(|| name.as_str().into());
                (tool.diameter_mm, tool.offset[Axis::Z]) = (*diameter, *length);
            }
            ToolChange::Gone => drop(session.gcode.tools.remove(&number)),
            ToolChange::In => session.gcode.tool = number,
        }
        let unkept = if *kept { session.keep_place(workspace).err() } else { None };
        self.rest(State::Idle, None);
        if let Some(error) = unkept {
            let why = format!("the tools hold until Kerf ends, they cannot be kept: {error}");
            self.hub.say(Tone::Error, why);
        }
        match zero {
            None => {}
            Some(ZeroOfTool::Goes(by_mm, line)) => {
                let by = rounded(by_mm, 3);
                let text =
                    format!("Z zero goes up by {by} mm with the length of the tool in the spindle");
                self.hub.say(Tone::Note, text);
                self.command(&line, false, None, false);
            }
            Some(ZeroOfTool::Stays) => self.hub.say(
                Tone::Note,
                "Z zero stays: it was set since the change of tools, with the tool in the spindle",
            ),
        }
    }

    /// Has another configuration from now on, keeps what is new of it, and tells whether that is on the disk.
    pub(super) fn configure(
        &mut self,
        setting: &'static Setting,
        wanted: Configuration,
        change: Option<&SettingChange>,
        tells: &Sender<Result<(), String>>,
    ) {
        let Workshop { session, workspace, .. } = &mut self.workshop;
        let kept = session.configure(setting, wanted, workspace).map_err(|why| {
            format!("{} holds until Kerf ends, it cannot be kept: {why}", setting.key)
        });
        if let Err(why) = &kept {
            self.hub.say(Tone::Warning, why.clone());
        }
        // Pages that hear of other settings read the history: the change is in it by then.
        let entered = kept.is_err() || change.is_none_or(|change| self.changes.add(change));
        if !entered {
            let key = setting.key;
            let text =
                format!("{key} is changed, but not in the history of changes: the disk refuses");
            self.hub.say(Tone::Warning, text);
        }
        self.rest(State::Idle, None);
        // The machine's state first: whoever asked may ask for the next thing at once. Some do not wait.
        drop(tells.send(kept));
    }

    /// Has another configuration until Kerf ends, and tells when it holds: as [`Owner::keep`].
    pub(super) fn hold(&mut self, wanted: Configuration, tells: &Sender<Happening>) {
        self.workshop.session.hold(wanted);
        self.rest(State::Idle, None);
        drop(tells.send(Happening::Outcome(Ok(String::new()))));
    }

    /// Keeps the configuration that holds, and tells how many settings were not kept yet. Keys wait for that: when it
    /// is told the machine has to stand.
    pub(super) fn keep(&mut self, tells: &Sender<Happening>) {
        let Workshop { session, workspace, .. } = &self.workshop;
        let kept = session.keep_configuration(workspace);
        self.rest(State::Idle, None);
        let outcome = kept.map(|count| match count {
            1 => "1 setting saved".into(),
            count => format!("{count} settings saved"),
        });
        // Nobody waits for it where the server is closing.
        drop(tells.send(Happening::Outcome(outcome.map_err(|why| why.to_string()))));
    }

    /// The run that can be taken up, where runs are on record.
    pub(super) fn cut_short(&self) -> Result<Option<CutShort>, JournalError> {
        let journal = self.workshop.workspace.journal().filter(|_| self.workshop.kept);
        journal.map_or(Ok(None), |journal| journal.runs.cut_short())
    }

    /// The same as pages show it. A journal that cannot be read was told when it was opened.
    fn interrupted(&self) -> Option<Interrupted> {
        // What ran on another machine is taken up there.
        let here = |cut: &CutShort| cut.controller() == self.controller_name();
        let cut = self.cut_short().ok().flatten().filter(here)?;
        let name = |path: &str| self.parts.name_of(path);
        Some(Interrupted {
            file: name(cut.file()),
            hash: (!cut.is_job()).then(|| cut.run.hash().to_owned()),
            line: cut.last_move().1,
            text: cut.sentence_by(name),
            stopped: cut.stopped(),
            moved: cut.moved(),
        })
    }

    /// Tells what the workspace holds: recorder, folder, watched variables; and that settings are others. Whoever then
    /// asks for them gets them: the copy of the session is left before.
    pub(super) fn tell_workspace(&mut self) {
        let workspace = &mut self.workshop.workspace;
        let (on, lines) = workspace.recorder();
        let recorder = Recorder { on, lines };
        let name = self.parts.name_of(&workspace.part_folder().display().to_string());
        let folder = Folder { name, mask: workspace.mask().to_owned() };
        let height_map = to_wire::height_map(&self.workshop.workspace);
        let tools = to_wire::tools(&self.workshop.session, &self.workshop.workspace);
        let watched = self.watched();
        let setup = crate::configure::setup(&self.workshop.session);
        let interrupted = self.interrupted();
        let other = {
            let (before, now) = (&crate::locks::lock(&self.left).session, &self.workshop.session);
            before.memory.settings != now.memory.settings || before.machine_is != now.machine_is
        };
        self.leave();
        self.hub.changing(|now| {
            let mut changes = Vec::new();
            let mut put = |differs: bool, change: Change| changes.extend(differs.then_some(change));
            put(now.recorder != recorder, Change::Recorder { recorder });
            put(now.folder != folder, Change::Folder { folder });
            put(now.interrupted != interrupted, Change::Interrupted { interrupted });
            put(now.tools != tools, Change::Tools { tools });
            put(now.height_map != height_map, Change::HeightMap { height_map });
            put(now.watched != watched, Change::Watched { watched });
            put(now.setup != setup, Change::Setup { setup });
            put(other, Change::Settings { settings: now.settings.wrapping_add(1) });
            changes
        });
    }

    /// Enters in the history which settings the run has made others, by whoever drives.
    pub(super) fn note_settings(&self, job: &CurrentRun) {
        let (before, after) =
            (lock(&self.left).session.configuration(), self.workshop.session.configuration());
        let by = self.hub.read(|now| now.lease.as_ref().map(|lease| lease.device.clone()));
        let through = job.command.as_ref().unwrap_or(&job.file);
        let made = changes_through(through, &by.unwrap_or_default(), [&before, &after]);
        if !made.iter().all(|change| self.changes.add(change)) {
            let text = format!(
                "settings that {through} changed are not in their history: the disk refuses"
            );
            self.hub.say(Tone::Warning, text);
        }
    }

    /// The watched variables as the last run left them.
    fn watched(&self) -> Vec<NamedValue> {
        let Workshop { session, workspace, .. } = &self.workshop;
        let value = |name: &String| {
            let variable = session.memory.variables.get(name.trim_start_matches('&'));
            let kept = || workspace.stored.get(name).map(str::to_owned);
            let value = variable.map(kerf_sbp::Value::display).or_else(kept)?;
            Some((name.clone(), value))
        };
        to_wire::named(self.link.watched().iter().filter_map(value))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::files::PartFolder;
    use crate::hub::Hub;
    use crate::machine::{Link, Order, Screen};
    use crate::setting_changes::SettingChanges;
    use kerf_control::{RunContext, Session};
    use kerf_files::{Folders, RealDisk};
    use kerf_journal::{Press, RunOptions};
    use kerf_wire::Snapshot;
    use kerf_workspace::{Workspace, stored::Stored};
    use std::sync::Arc;
    use std::sync::mpsc::{TryRecvError, channel};
    use std::time::{Duration, Instant};

    fn owner(folder: &Path, link: &Arc<Link>) -> Owner {
        let stored = Stored::in_memory(Default::default());
        let folders = Folders::new(folder.to_owned(), Vec::new(), Vec::new());
        let workspace = Workspace::new(Box::new(RealDisk), folders, stored, folder.join("data"));
        Owner {
            hub: Arc::new(Hub::new(Snapshot::default())),
            link: link.clone(),
            workshop: Workshop {
                session: Session::default(),
                workspace,
                controller: None,
                told: Default::default(),
                kept: false,
                started: || None,
            },
            parts: PartFolder::new(folder).unwrap(),
            left: Arc::default(),
            rate: 1.0,
            done: Box::new(drop),
            changes: Arc::new(SettingChanges::new(folder)),
            screen: Screen(Arc::new(drop)),
            closing: None,
            asked: 0,
            run: 0,
            looked: None,
            locked: None,
            waits: None,
            previews: Arc::new(|| Err(std::io::ErrorKind::Unsupported.into())),
        }
    }

    #[test]
    fn switches_that_a_run_left_are_moved_when_it_is_over() {
        let (folder, link) = (tempfile::tempdir().unwrap(), Arc::<Link>::default());
        let owner = owner(folder.path(), &link);
        let hub = owner.hub.clone();
        for (number, on) in [(1, true), (2, true), (1, false)] {
            link.want(|wanted| wanted.presses.push_back(Press { number, on }));
        }
        // Something else began behind them.
        assert!(link.begin(None, None));
        let (orders, waiting) = channel();
        orders.send(Order::Switches).unwrap();
        drop(orders);
        owner.work(&waiting);
        let on = hub.read(|now| now.io.inputs.iter().filter(|lamp| lamp.on).count());
        let second = hub.read(|now| now.io.inputs[1].on);
        assert_eq!((on, second), (1, true), "the last of the first counts");
    }

    #[test]
    fn who_is_told_that_settings_are_others_reads_the_new_ones() {
        let (folder, link) = (tempfile::tempdir().unwrap(), Arc::<Link>::default());
        let mut owner = owner(folder.path(), &link);
        owner.workshop.session.memory.settings.linear_unit = kerf_program::settings::LinearUnit::Mm;
        owner.tell_workspace();
        assert_eq!(owner.hub.read(|now| now.settings), 1);
        let left = crate::locks::lock(&owner.left).session.memory.settings.clone();
        assert_eq!(left, owner.workshop.session.memory.settings);
    }

    #[test]
    fn a_change_of_a_setting_is_in_the_history_before_anybody_is_told_of_it() {
        let (folder, link) = (tempfile::tempdir().unwrap(), Arc::<Link>::default());
        let mut owner = owner(folder.path(), &link);
        let setting = kerf_machine::table::setting("cutter.diameter_mm").unwrap();
        let mut wanted = owner.workshop.session.configuration();
        setting.set(&mut wanted, &kerf_machine::Value::Number(7.0)).unwrap();
        let before = owner.workshop.session.configuration();
        let [change] = &crate::configure::changes_through("", "", [&before, &wanted])[..] else {
            panic!("one")
        };
        let (tells, told) = channel();
        owner.configure(setting, wanted.clone(), Some(change), &tells);
        assert_eq!(told.recv(), Ok(Ok(())));
        assert_eq!(owner.changes.list().unwrap(), std::slice::from_ref(change));
        // A disk that refuses shows what came first.
        let history = folder.path().join("setting-changes.jsonl");
        std::fs::remove_file(&history).unwrap();
        std::fs::create_dir(&history).unwrap();
        let (_, mut heard) = owner.hub.listen();
        owner.configure(setting, before, Some(change), &tells);
        let texts = std::iter::from_fn(|| heard.try_recv().ok()).map(|it| it.text().to_string());
        let texts: Vec<String> = texts.collect();
        let at = |word: &str| texts.iter().position(|text| text.contains(word)).unwrap();
        assert!(at("not in the history") < at("\"settings\""), "{texts:#?}");
    }

    /// The machine stands with an output on, and looks for orders every hour; whatever happens then switches it off.
    #[track_caller]
    fn switches_off(happens: impl FnOnce(&Link, &Hub) + Send) {
        let (folder, link) = (tempfile::tempdir().unwrap(), Arc::<Link>::default());
        let mut owner = owner(folder.path(), &link);
        let hub = owner.hub.clone();
        let armed = |armed| Change::Machine { machine: Machine { armed, ..Machine::default() } };
        hub.change(vec![armed(true)]);
        let Workshop { session, workspace, .. } = &mut owner.workshop;
        let context = RunContext {
            sink: &mut (),
            operator: &mut (),
            requests: &mut (),
            machine: kerf_control::simulated(),
        };
        let program = kerf_sbp::read_typed("on".into(), "SO,7,1\n");
        let mut options = RunOptions::default();
        options.program.typed = true;
        session.run(program, options, workspace, context);
        owner.settle(Machine::clone);
        let is_on = || hub.read(|now| now.io.outputs[6].on);
        assert!(is_on());
        let (orders, waiting) = channel::<Order>();
        link.wakes_this_thread();
        let off = std::thread::scope(|threads| {
            let watcher = threads.spawn(|| {
                // The machine's thread sleeps by then.
                std::thread::sleep(Duration::from_millis(50));
                happens(&link, &hub);
                let begun = Instant::now();
                while is_on() && begun.elapsed() < PATIENCE {
                    std::thread::sleep(Duration::from_millis(1));
                }
                let off = !is_on();
                link.leave();
                off
            });
            assert!(matches!(owner.next(&waiting, HOUR), Err(TryRecvError::Empty)));
            watcher.join().unwrap()
        });
        drop(orders);
        assert!(off, "the machine's thread sleeps on");
    }

    const HOUR: Duration = Duration::from_secs(3600);
    const PATIENCE: Duration = Duration::from_secs(10);

    #[test]
    fn what_is_stopped_or_disarmed_at_rest_is_off_at_once() {
        switches_off(|link, _| _ = link.stop());
        switches_off(|link, hub| {
            link.disarm();
            hub.changing(|now| {
                link.arrived().disarmed();
                vec![Change::Machine { machine: Machine { armed: false, ..now.machine.clone() } }]
            });
        });
        // Whoever drove has gone.
        switches_off(|link, hub| {
            hub.changing(|now| {
                link.forestall();
                vec![Change::Machine { machine: Machine { armed: false, ..now.machine.clone() } }]
            });
        });
    }

    #[test]
    fn a_switch_leaves_the_machine_what_it_is() {
        for state in [State::Alarm, State::Idle, State::Running] {
            let (folder, link) = (tempfile::tempdir().unwrap(), Arc::<Link>::default());
            let mut owner = owner(folder.path(), &link);
            let was = Machine {
                state,
                armed: true,
                why: Some("a limit".into()),
                ..owner.hub.read(|now| now.machine.clone())
            };
            owner.hub.change(vec![Change::Machine { machine: was.clone() }]);
            link.want(|wanted| wanted.presses.push_back(Press { number: 2, on: true }));
            assert!(owner.move_switches());
            assert!(owner.hub.read(|now| now.io.inputs[1].on), "{state:?}");
            let machine = owner.hub.read(|now| now.machine.clone());
            assert_eq!((machine.state, machine.armed, machine.why), (was.state, true, was.why));
        }
    }
}
