//! The card of the controller, as pages work it.
//!
//! Each task has a thread of its own: it reads, converts and looks through files, and asks the machine's thread for what is
//! said to the controller. So STOP is heard whatever the file is like.

use crate::asker::Asker;
use crate::file_kind::kind_of;
use crate::hub::Hub;
use crate::loader::Loader;
use crate::locks::lock;
use crate::machine::Order;
use crate::machine::{CardOrder, LastState, Link};
use crate::orders::Orders;
use crate::preview::{self, Until};
use crate::refusal::problem;
use crate::saving::Leave;
use kerf_control::answers::Answers;
use kerf_control::controller::dry_run;
use kerf_import::card_file;
use kerf_journal::{RunOptions, Work};
use kerf_machine::driver;
use kerf_machine::driver::CardAnswer;
use kerf_wire::{
    CardAct, CardFile, CardLook, CardTask, CardTaskKind, Change, ControllerCard, FileKind, Finding,
    Level, Problem, Snapshot, State, Why,
};
use kerf_workspace::Workspace;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex};
use std::thread::Builder;

/// Reasons that are told of a file that is refused, at most.
const MOST_TOLD: usize = 12;

/// Said where a task was given up.
const GIVEN_UP: &str = "it was given up before it was done";

/// The card, for pages.
pub struct CardDesk {
    hub: Arc<Hub>,
    link: Arc<Link>,
    left: Arc<Mutex<LastState>>,
    orders: Arc<Orders>,
    loader: Arc<Loader>,
    /// Gives the task under way up.
    given_up: Mutex<Arc<AtomicBool>>,
}

/// A task on the card, on its thread.
struct Task {
    hub: Arc<Hub>,
    left: Arc<Mutex<LastState>>,
    orders: Arc<Orders>,
    loader: Arc<Loader>,
    asker: Asker,
    given_up: Arc<AtomicBool>,
}

/// Reasons why a task was not done.
#[derive(Default)]
struct Refused {
    why: Vec<String>,
    /// The file that it would have written over.
    replaces: Option<String>,
    /// The file that it could not read back.
    unread: Option<String>,
}

impl From<String> for Refused {
    fn from(why: String) -> Self {
        Self { why: vec![why], ..Self::default() }
    }
}

impl From<Problem> for Refused {
    fn from(problem: Problem) -> Self {
        problem.text.into()
    }
}

/// Returns the estimated time of a file of the card, seconds; nothing where its text is not known.
pub fn seconds_of(now: &Snapshot, name: &str) -> Option<f64> {
    let files = now.controller_card.files.iter().flatten();
    files.filter(|file| file.name == name).find_map(|file| Some(file.looked.as_ref()?.seconds))
}

impl CardDesk {
    /// Nothing is done on the card.
    pub fn new(
        (hub, link, left): (Arc<Hub>, Arc<Link>, Arc<Mutex<LastState>>),
        orders: Arc<Orders>,
        loader: Arc<Loader>,
    ) -> Self {
        Self { hub, link, left, orders, loader, given_up: Mutex::default() }
    }

    /// Does what a page asks for; how that goes is told to all pages.
    ///
    /// # Errors
    /// There is no card, a task is under way, the machine is busy, or a file was not looked through that is to run.
    pub fn hears(&self, asker: &Asker, act: CardAct) -> Result<(), Problem> {
        if act == CardAct::Cancel {
            lock(&self.given_up).store(true, Ordering::Relaxed);
            self.link.wake();
            return Ok(());
        }
        self.begins(&act)?;
        let given_up = Arc::<AtomicBool>::default();
        *lock(&self.given_up) = given_up.clone();
        let task = Task {
            hub: self.hub.clone(),
            left: self.left.clone(),
            orders: self.orders.clone(),
            loader: self.loader.clone(),
            asker: asker.clone(),
            given_up,
        };
        let spawned = Builder::new().name("card".into()).spawn(move || {
            let refused = task.does(act).err().unwrap_or_default();
            ends(&task.hub, refused);
        });
        spawned.map(drop).map_err(|why| {
            ends(&self.hub, Refused::default());
            problem(Why::Server, format!("no thread for it: {why}"))
        })
    }

    /// A task begins, unless something else is under way.
    fn begins(&self, act: &CardAct) -> Result<(), Problem> {
        let mut begun = Ok(());
        self.hub.changing(|now| {
            begun = may_begin(now, act);
            if begun.is_err() {
                return Vec::new();
            }
            let card = ControllerCard {
                task: Some(task_of(now, act)),
                refused: Vec::new(),
                replaces: None,
                unread: None,
                kept: None,
                notes: Vec::new(),
                ..now.controller_card.clone()
            };
            vec![Change::ControllerCard { controller_card: card }]
        });
        begun
    }
}

fn may_begin(now: &Snapshot, act: &CardAct) -> Result<(), Problem> {
    let card = &now.controller_card;
    let refused = |text: &str| Err(problem(Why::State, text));
    if !card.has {
        let why = if card.why.is_empty() {
            "this machine has no controller with a card"
        } else {
            &card.why
        };
        return refused(why);
    }
    if card.task.is_some() {
        return refused("something is done on the card already: wait for its end, or cancel it");
    }
    if now.machine.state != State::Idle {
        return refused("the machine is busy");
    }
    match act {
        CardAct::Run { name, unseen } if seconds_of(now, name).is_none() => {
            let is_unread = card.unread.as_ref() == Some(name);
            match is_unread && *unseen {
                true => Ok(()),
                false => refused("the file was not looked through: look through it first"),
            }
        }
        _ => Ok(()),
    }
}

/// The task as pages see it.
fn task_of(now: &Snapshot, act: &CardAct) -> CardTask {
    let (kind, name) = match act {
        CardAct::List | CardAct::Cancel => (CardTaskKind::List, ""),
        CardAct::Look { name } => (CardTaskKind::Look, &**name),
        CardAct::Upload { file, .. } => (CardTaskKind::Upload, &**file),
        CardAct::Run { name, .. } => (CardTaskKind::Run, &**name),
        CardAct::Delete { name } => (CardTaskKind::Delete, &**name),
        CardAct::Keep { name, .. } => (CardTaskKind::Keep, &**name),
    };
    let reads = matches!(kind, CardTaskKind::Look | CardTaskKind::Keep);
    let mut files = now.controller_card.files.iter().flatten();
    let all = files.find(|file| reads && file.name == name).map_or(0, |file| file.bytes);
    CardTask { kind, name: name.to_owned(), done: 0, all }
}

/// A task is over.
fn ends(hub: &Hub, Refused { why, replaces, unread }: Refused) {
    hub.changing(|now| {
        let card = now.controller_card.clone();
        let card = ControllerCard { task: None, refused: why, replaces, unread, ..card };
        vec![Change::ControllerCard { controller_card: card }]
    });
}

impl Task {
    fn does(&self, act: CardAct) -> Result<(), Refused> {
        match act {
            CardAct::List => Ok(self.lists()?),
            CardAct::Look { name } => {
                let text = self.reads(&name)?;
                let looked = self.looks_through(&name, text.as_bytes())?;
                self.lists()?;
                self.has_looked(&name, None, looked);
                Ok(())
            }
            CardAct::Upload { file, replaces } => self.uploads(&file, replaces),
            CardAct::Run { name, .. } => {
                self.asks(driver::CardTask::Run(name))?;
                Ok(())
            }
            CardAct::Delete { name } => {
                self.asks(driver::CardTask::Delete(name))?;
                Ok(self.lists()?)
            }
            CardAct::Keep { name, replaces } => self.keeps(&name, replaces),
            CardAct::Cancel => Ok(()),
        }
    }

    /// Has something done on the card, and waits for it.
    fn asks(&self, task: driver::CardTask) -> Result<CardAnswer, String> {
        if self.given_up.load(Ordering::Relaxed) {
            return Err(GIVEN_UP.into());
        }
        let (tells, told) = channel();
        let order = Order::Card(CardOrder { task, given_up: self.given_up.clone(), tells });
        self.orders.order_of(&self.asker, order).map_err(|why| why.text)?;
        told.recv().map_err(|_| "Kerf ends".to_owned())?
    }

    /// Reads the text of a file back.
    fn reads(&self, name: &str) -> Result<String, Refused> {
        let told = self.asks(driver::CardTask::Show(name.to_owned()));
        let unread = || (!self.given_up.load(Ordering::Relaxed)).then(|| name.to_owned());
        told.map(|answer| answer.text).map_err(|why| Refused {
            why: vec![why],
            unread: unread(),
            replaces: None,
        })
    }

    /// Lists the files; what was found out of one that is the same by name and size stays.
    fn lists(&self) -> Result<(), String> {
        let listed = self.asks(driver::CardTask::List)?.files;
        self.hub.changing(|now| {
            let before = now.controller_card.files.iter().flatten();
            let looked = |name: &str, bytes: u64| {
                before.clone().find(|file| file.name == name && file.bytes == bytes)?.looked.clone()
            };
            let files = listed.into_iter().map(|driver::CardFile { name, bytes }| {
                let looked = looked(&name, bytes);
                CardFile { name, bytes, looked }
            });
            let files = Some(files.collect());
            let card = ControllerCard { files, ..now.controller_card.clone() };
            vec![Change::ControllerCard { controller_card: card }]
        });
        Ok(())
    }

    /// A file of the list was looked through; of so many bytes, where it was put there.
    fn has_looked(&self, name: &str, bytes: Option<u64>, looked: CardLook) {
        self.hub.changing(|now| {
            let mut card = now.controller_card.clone();
            let same = |file: &&mut CardFile| {
                file.name == name && bytes.is_none_or(|bytes| bytes == file.bytes)
            };
            let file = card.files.iter_mut().flatten().find(same);
            file.into_iter().for_each(|file| file.looked = Some(looked.clone()));
            vec![Change::ControllerCard { controller_card: card }]
        });
    }

    fn uploads(&self, file: &str, replaces: bool) -> Result<(), Refused> {
        let folder = &self.loader.files.folder;
        let (bytes, path) = (folder.read(file)?, folder.find(file)?);
        let mut workspace = self.files()?;
        let session = lock(&self.left).session.clone();
        let (settings, machine) = (session.memory.settings.clone(), session.configuration());
        let path = path.display().to_string();
        // What is wrong with a part file is told at its own lines, not at those of its G-code.
        if kind_of(file) == FileKind::Program {
            self.lacks(kerf_part::read(path.as_str().into(), bytes.clone()).into())?;
        }
        let made = card_file::for_card(&path, &bytes, (&settings, &machine), &mut workspace)
            .map_err(|why| folder.named_in(&why))?;
        let card_file::CardFile { name, content, notes } = made;
        let looked = self.looks_through(&name, &content)?;
        self.notes(notes.iter().map(|note| folder.named_in(note)).collect());
        self.lists()?;
        let is_there = |now: &Snapshot| {
            now.controller_card.files.iter().flatten().any(|file| file.name == name)
        };
        if !replaces && self.hub.read(is_there) {
            let why = vec![format!("{name} is on the card already")];
            return Err(Refused { why, replaces: Some(name), unread: None });
        }
        let size = content.len() as u64;
        self.asks(driver::CardTask::Upload { name: name.clone(), content })?;
        self.lists()?;
        self.has_looked(&name, Some(size), looked);
        Ok(())
    }

    fn notes(&self, notes: Vec<String>) {
        self.hub.changing(|now| {
            let card = ControllerCard { notes, ..now.controller_card.clone() };
            vec![Change::ControllerCard { controller_card: card }]
        });
    }

    /// Copies a file into the part folder; folders of the card are none there.
    fn keeps(&self, name: &str, replaces: bool) -> Result<(), Refused> {
        let bare = Path::new(name).file_name().unwrap_or_default().to_string_lossy();
        let files = &self.loader.files;
        if !replaces && files.folder.present(&bare)?.is_some() {
            let why = vec![format!("{bare} is in the part folder already")];
            return Err(Refused { why, replaces: Some(bare.into_owned()), unread: None });
        }
        let text = self.reads(name)?;
        let leave = if replaces { Leave::Anything } else { Leave::Nothing };
        files.save(&bare, text.as_bytes(), &leave)?;
        self.hub.changing(|now| {
            let kept = Some(bare.into_owned());
            let card = ControllerCard { kept, ..now.controller_card.clone() };
            vec![Change::ControllerCard { controller_card: card }]
        });
        Ok(())
    }

    /// Holds G-code against the limits of the controller, and estimates its time.
    fn looks_through(&self, name: &str, content: &[u8]) -> Result<CardLook, Refused> {
        let read =
            || kerf_part::read_as(name.into(), content.to_vec(), kerf_sbp::Dialect::default());
        let mut warnings = self.lacks(read().into())?;
        let session = lock(&self.left).session.clone();
        let parameters = kerf_sbp::FileParameters::default();
        let work = read().into();
        let made = preview::make(work, parameters, session, &mut self.files()?, &self.given_up);
        let made = made.ok_or_else(|| GIVEN_UP.to_owned())?;
        let found = made.findings.iter();
        let found = found.filter(|it| matches!(it.level, Level::Error | Level::Warning));
        warnings.extend(sound(found.map(|it| {
            let Finding { level, file, line, message, hint, .. } = it;
            (*level == Level::Error, placed((file, *line), message, hint))
        }))?);
        Ok(CardLook { seconds: made.info.seconds, warnings })
    }

    /// Holds a part file or a job against the limits of the controller; returns what it does otherwise.
    fn lacks(&self, work: Work) -> Result<Vec<String>, Refused> {
        let (session, limits) = {
            let left = lock(&self.left);
            (left.session.clone(), left.limits.clone())
        };
        let limits =
            limits.ok_or_else(|| "the controller has not told its limits yet".to_owned())?;
        let (mut answers, mut until) = (Answers::default(), Until(&self.given_up));
        let (options, mut files) = (RunOptions::default(), self.files()?);
        let lent = (&mut answers as _, &mut until as _);
        let found = dry_run(limits, &work, (&session, &options), &mut files, lent);
        let folder = &self.loader.files.folder;
        sound(found.iter().map(|it| {
            let file = folder.name_of(&it.place.file);
            (it.is_error(), placed((&file, it.place.line), &it.message, &it.hint))
        }))
    }

    /// The files of a dry run, which changes none.
    fn files(&self) -> Result<Workspace, String> {
        (self.loader.builders.preview)().map_err(|why| why.to_string())
    }
}

/// Returns the warnings of what was found, where none of it is an error.
fn sound(found: impl Iterator<Item = (bool, String)>) -> Result<Vec<String>, Refused> {
    let (why, warnings): (Vec<_>, Vec<_>) = found.partition(|(is_error, _)| *is_error);
    let [why, warnings] =
        [why, warnings].map(|all| all.into_iter().map(|(_, text)| text).collect());
    let mut why: Vec<String> = why;
    let more = why.len().saturating_sub(MOST_TOLD);
    why.truncate(MOST_TOLD);
    why.extend((more > 0).then(|| format!("{more} more are wrong in the same file")));
    if why.is_empty() { Ok(warnings) } else { Err(Refused { why, ..Refused::default() }) }
}

/// A sentence with its place.
fn placed((file, line): (&str, u32), message: &str, hint: &str) -> String {
    let place = if line > 0 { format!("{file}:{line}: ") } else { String::new() };
    let hint = if hint.is_empty() { String::new() } else { format!("; {hint}") };
    format!("{place}{message}{hint}")
}
