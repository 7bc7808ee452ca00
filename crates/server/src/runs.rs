//! Runs: how they begin, go on and are answered.

use crate::act_checks;
use crate::asker::Asker;
use crate::configure::MachineSettings;
use crate::file_kind::kind_of;
use crate::gate::{self, Demand};
use crate::hub::Hub;
use crate::interrupted;
use crate::job::Jobs;
use crate::job_findings;
use crate::loader::Loader;
use crate::locks::lock;
use crate::machine::{LastState, Link, Order, Planned};
use crate::open::{Open, hash_of};
use crate::orders::Orders;
use crate::part_files::PartFiles;
use crate::preview::Preview;
use crate::refusal::{not_open, problem};
use kerf_control::answers;
use kerf_import::job_file;
use kerf_machine::driver::Override;
use kerf_wire::{
    Act, Asked, Change, FileKind, FileParameters, Finding, JobChoice, Level, Mode, Overrides,
    Problem, State, Tone, Why,
};
use std::path::PathBuf;
use std::sync::{Arc, Mutex};

/// Starts files, jobs and typed lines, and answers what they ask.
pub struct Runs {
    pub hub: Arc<Hub>,
    pub link: Arc<Link>,
    pub left: Arc<Mutex<LastState>>,
    pub files: Arc<PartFiles>,
    pub orders: Arc<Orders>,
    pub settings: Arc<MachineSettings>,
    pub loader: Arc<Loader>,
    pub jobs: Arc<Jobs>,
}

impl Runs {
    /// Goes on after a hold, or after a stop by its question.
    ///
    /// # Errors
    /// Nothing is held, or somebody else drives.
    pub fn resume(&self, asker: &Asker) -> Result<(), Problem> {
        match self.hub.state() {
            State::Held => {
                self.orders.want_of(asker, Demand::GoOn, |wanted| wanted.resume = true)?
            }
            State::Stopped => {
                let number = self.hub.read(|now| now.asked.as_ref().map(|a| a.number));
                let resume = |number| self.answer(asker, number, "Resume".into());
                return number.map_or(Ok(()), resume);
            }
            _ => return Err(problem(Why::State, "nothing is held")),
        }
        Ok(())
    }

    /// Answers a question, the first counts; with a word after which the machine goes on only as whoever drives it
    /// still, and not where it was stopped meanwhile.
    pub fn answer(&self, asker: &Asker, question: u32, answer: String) -> Result<(), Problem> {
        let asked = self.hub.read(|now| now.asked.clone());
        let Some(asked) = asked.filter(|asked| asked.number == question) else {
            return Err(not_open());
        };
        check_answer(&asked, &answer)?;
        let act = Act::Answer { question, answer: answer.clone() };
        let counts = self
            .orders
            .want_of(asker, Demand::Act(&act), |wanted| wanted.give(question, answer))?;
        let late = || problem(Why::Late, "somebody else has answered this question");
        counts.then_some(()).ok_or_else(late)
    }

    /// Starts the open file, or goes on with the job that waits for Start.
    ///
    /// # Errors
    /// It is another file by now, has mistakes or no tool path, or may not begin.
    pub fn run(&self, asker: &Asker, hash: &str, step: bool) -> Result<(), Problem> {
        let open = self.loader.open.lock().clone();
        self.has_tool_path(&open)?;
        if open.name.is_empty() || open.hash != hash {
            return Err(problem(Why::Changed, "this is not the file that is open"));
        }
        if let Some(question) = self.waits_for_start(hash) {
            return self.answer(asker, question, "Resume".into());
        }
        if kind_of(&open.name) == FileKind::Job
            && self.hub.read(|now| now.machine.mode) == Mode::Preview
        {
            let text = "in preview only part files are drawn: choose Move mode before a job is cut";
            return Err(problem(Why::State, text));
        }
        let Some(preview) = open.preview.clone() else {
            return Err(problem(Why::State, "the preview is not ready"));
        };
        if preview.failed {
            return Err(problem(Why::Mistake, mistakes(&preview)));
        }
        self.unchanged(&open, &preview)?;
        let (work, planned) = (Box::new(self.loader.work(&open)?), preview.planned.clone());
        let parameters = act_checks::parameters(&open.parameters);
        let parameters = kerf_sbp::FileParameters { stepped: step, ..parameters };
        let taken = work.takes_origin(lock(&self.left).session.memory.position);
        let opened = self.settings.opened(&asker.who, None).is_ok();
        let noticed = self.noticed(&open);
        let Open { name, hash, .. } = open;
        let draws_only = self.hub.read(gate::draws_only);
        let taken = taken.map(|at| (hash.clone(), at));
        let order = Order::File { work, name, hash, planned, parameters, opened, draws_only };
        let before = std::mem::replace(&mut *self.jobs.taken.lock(), taken);
        // A job that runs keeps the origin that it took when somebody presses Start again.
        self.orders.order_of(asker, order).inspect_err(|_| *self.jobs.taken.lock() = before)?;
        noticed.into_iter().for_each(|text| self.hub.say(Tone::Warning, text));
        Ok(())
    }

    /// Warnings about the file of a job, which whoever starts it is told once more.
    fn noticed(&self, open: &Open) -> Vec<String> {
        match kind_of(&open.name) {
            FileKind::Job => {
                job_findings::warnings(&open.bytes, LastState::shaping(&self.left).factor)
            }
            _ => Vec::new(),
        }
    }

    /// Checks that what was previewed is what runs: the file, and those that it calls.
    fn unchanged(&self, open: &Open, preview: &Preview) -> Result<(), Problem> {
        let changed = |what: &str| {
            let text = format!("{what} was changed since it was previewed; open the file again");
            Err(problem(Why::Changed, text))
        };
        if !open.is_of(&self.files.folder.read(&open.name)?) {
            return changed("the file");
        }
        let other = |(path, bytes): &(&PathBuf, &Arc<[u8]>)| {
            std::fs::read(path).map_or(true, |now| now[..] != bytes[..])
        };
        match preview.called.iter().find(other) {
            Some((path, _)) => changed(&self.files.folder.name_of(&path.display().to_string())),
            None => Ok(()),
        }
    }

    /// Goes on with the run that was cut short.
    pub fn take_up(&self, asker: &Asker) -> Result<(), Problem> {
        let Some(interrupted) = self.hub.read(|now| now.interrupted.clone()) else {
            return Err(problem(Why::State, "no run was cut short"));
        };
        let hash = interrupted::hash_of_open(&interrupted, self.loader.open.lock().clone());
        let workspace = self.loader.preview_workspace().ok();
        let plan = self.loader.journal().zip(workspace);
        // Without a plan it runs as well; how far it is is not known then.
        let planned =
            plan.and_then(|(journal, mut workspace)| interrupted::plan(&journal, &mut workspace));
        self.orders.order_of(asker, Order::TakeUp { hash, planned: planned.unwrap_or_default() })
    }

    /// Carries out a typed line.
    ///
    /// # Errors
    /// It has a mistake, or may not begin.
    pub fn command(&self, asker: &Asker, line: String) -> Result<(), Problem> {
        if let Some(mistake) = typed(&line).diagnostics.iter().find(|found| found.is_error()) {
            let hint = &mistake.hint;
            let hint = if hint.is_empty() { String::new() } else { format!(" ({hint})") };
            return Err(problem(Why::Mistake, format!("{}{hint}", mistake.message)));
        }
        let opened = self.settings.opened(&asker.who, None).is_ok();
        let file = self.file_of_typed(&line);
        let draws_only = self.hub.read(gate::draws_only) && !typed(&line).moves_nothing();
        self.orders.order_of(asker, Order::Command { line, opened, file, draws_only })
    }

    /// Changes the speed of what runs, percent of what is programmed.
    ///
    /// # Errors
    /// The share is out of bounds.
    pub fn override_feed(&self, feed_percent: f64) -> Result<(), Problem> {
        if !(10.0..=200.0).contains(&feed_percent) {
            return Err(problem(Why::Malformed, "overrides are 10 to 200 percent"));
        }
        if self.hub.state() == State::Idle {
            let overrides = self.hub.read(|now| now.overrides);
            let overrides = Overrides { feed_percent, ..overrides };
            self.hub.change(vec![Change::Overrides { overrides }]);
        }
        self.link.want(|wanted| wanted.feed = Some((feed_percent / 100.0) as f32));
        Ok(())
    }

    /// Turns other overrides of the machine that runs.
    ///
    /// # Errors
    /// The machine does not have them, or a share is out of bounds.
    pub fn turn(&self, turns: impl Iterator<Item = Override> + Clone) -> Result<(), Problem> {
        let is_sound = |turned| match turned {
            Override::Rapid(percent) => (10..=100).contains(&percent),
            Override::Spindle(percent) => (10..=200).contains(&percent),
        };
        if !turns.clone().all(is_sound) {
            let why = "rapid moves are overridden by 10 to 100 percent, a spindle by 10 to 200";
            return Err(problem(Why::Malformed, why));
        }
        if turns.clone().next().is_some()
            && self.hub.read(|now| now.overrides.rapid_percent.is_none())
        {
            let why = "the machine overrides neither rapid moves nor its spindle";
            return Err(problem(Why::State, why));
        }
        self.link.want(|wanted| wanted.turns.extend(turns));
        Ok(())
    }

    /// Refuses to start where only a drawing is open.
    ///
    /// # Errors
    /// That.
    fn has_tool_path(&self, open: &Open) -> Result<(), Problem> {
        let draws = open.name.is_empty() && self.hub.read(|now| now.drawing.is_some());
        if draws || kind_of(&open.name) == FileKind::Drawing {
            let text = format!("{}: Machine makes it from the drawing", job_file::NO_TOOL_PATH);
            return Err(problem(Why::State, text));
        }
        Ok(())
    }

    /// The question of the job that runs, where Start answers it.
    fn waits_for_start(&self, hash: &str) -> Option<u32> {
        self.hub.read(|now| {
            let mine = now.job.as_ref().is_some_and(|job| job.hash.as_deref() == Some(hash));
            let stands = matches!(now.machine.state, State::Asking | State::Stopped);
            let asked = now.asked.as_ref().filter(|asked| asked.kind == "paused");
            asked.filter(|_| mine && stands).map(|asked| asked.number)
        })
    }

    /// The file of the part folder that a typed line runs, by its hash, and the plan of the one that is open: how it ran
    /// is how that file stands.
    pub fn file_of_typed(&self, line: &str) -> Option<(String, Planned)> {
        let name = runs_only(line)?;
        let folder = self.hub.read(|now| now.folder.name.clone());
        let name = if folder.is_empty() { name } else { format!("{folder}/{name}") };
        let bytes = self.files.folder.read(&name).ok()?;
        let open = self.loader.open.lock().clone();
        let is_open = open.name == name && open.is_of(&bytes);
        if is_open && open.parameters == FileParameters::default() {
            let planned = open.preview.map(|preview| preview.planned.clone());
            return Some((open.hash, planned.unwrap_or_default()));
        }
        let hash = hash_of(&name, &bytes, &FileParameters::default(), &JobChoice::default());
        Some((hash, Planned::default()))
    }
}

fn typed(lines: &str) -> kerf_sbp::Program {
    kerf_sbp::read_typed("command".into(), &format!("{lines}\n"))
}

/// The file that a typed line runs, where it does nothing else: FP with a name and no parameters.
fn runs_only(line: &str) -> Option<String> {
    let program = kerf_sbp::read_typed("command".into(), &format!("{}\n", line.trim()));
    let is_plain = line.trim().lines().count() == 1 && line.matches(',').count() <= 1;
    let fp = line.trim().get(..2).is_some_and(|letters| letters.eq_ignore_ascii_case("FP"));
    let named = program.named_files().into_iter().next()?;
    (is_plain && fp).then_some(named.request.name)
}

/// Says why a file that has mistakes is not started.
fn mistakes(preview: &Preview) -> String {
    let first = preview.findings.iter().find(|found| found.level == Level::Error);
    first.map_or("the file cannot run".into(), |Finding { line, message, .. }| {
        format!("the file has mistakes, the first in line {line}: {message}")
    })
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

#[cfg(test)]
mod tests {
    use super::runs_only;

    #[test]
    fn a_line_that_runs_a_file_and_nothing_else_is_that_file() {
        for (line, file) in [
            ("FP,a.sbp", Some("a.sbp")),
            (" fp, a.sbp ", Some("a.sbp")),
            ("FP,a.sbp,2", None),
            ("FP,a.sbp\nMX,1", None),
            ("IF 1=1 THEN FP,a.sbp", None),
            ("MX,1", None),
        ] {
            assert_eq!(runs_only(line).as_deref(), file, "{line}");
        }
    }
}
