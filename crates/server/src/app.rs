//! Everything that requests share.

use crate::awaited::Works;
use crate::clock::Clock;
use crate::counted::Counted;
use crate::desk::Desk;
use crate::digested::hash;
use crate::draft;
use crate::files::PartFolder;
use crate::handconsole::Happening;
use crate::http::Bodies;
use crate::hub::Hub;
use crate::job_told;
use crate::kind::kind_of;
use crate::locks::lock;
use crate::machine::{Left, Link, Order};
use crate::memory::Memory;
use crate::open::{Open, hash_of, job_hash};
use crate::people::{Devices, Here, Pages, Tries};
use crate::pool::{KERF, Lane, Pool};
use crate::preview::{self, Charts, Preview};
use crate::protect::Unlocked;
use crate::reading::Readings;
use crate::refusal::problem;
use crate::saving::{Leave, Saves};
use crate::setup::{Builders, Options};
use crate::shop;
use crate::texts::Texts;
use crate::turn::Turn;
use kerf_control::Begun;
use kerf_control::Shelf;
use kerf_control::journal::Journal;
use kerf_sim::Change as InputChange;
use kerf_wire::preview::Timing;
use kerf_wire::{
    Change, FileKind, FileParameters, Finding, JobChoice, Opened, PreviewState, Problem, Tone, Why,
};
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, OnceLock};

/// Everything that requests share.
pub struct App {
    /// Options with which the server was started.
    pub options: Options,
    /// State that pages show.
    pub hub: Arc<Hub>,
    /// Wishes for the running machine.
    pub link: Arc<Link>,
    /// Its next orders.
    pub orders: Mutex<Sender<Order>>,
    /// The part folder.
    pub parts: PartFolder,
    /// The drawing that is not saved, in the data folder.
    pub draft: Counted,
    /// Writes files of the part folder.
    pub saves: Saves,
    /// Texts that are typed in the editor and not saved.
    pub texts: Texts,
    /// The file that is open.
    pub open: Mutex<Open>,
    /// The machine and its files as the last run left them.
    pub left: Arc<Mutex<Left>>,
    /// Key of the preview of the job that runs, and the origin that it took, X and Y from home, mm.
    pub taken: Mutex<Option<(String, [f64; 2])>>,
    /// Builds the shelf of previews.
    pub builders: Builders,
    /// Pages and scripts that gave the password of the settings.
    pub unlocked: Unlocked,
    /// Wrong passwords of the settings, by the device that they came from. It is held while one is tried: one at a
    /// time.
    pub passwords: Mutex<Tries<String>>,
    /// Paired devices.
    pub devices: Devices,
    /// Token of whoever sits at the machine, where others may connect as well.
    pub here: Option<Here>,
    /// Connected pages.
    pub pages: Pages,
    /// The turn at driving that goes on.
    pub turn: Turn,
    /// The clock by which all ends that has to end in time; pages reckon with it.
    pub clock: Clock,
    /// The drawing that is open.
    pub desk: Mutex<Desk>,
    /// The drawing that is being read to be opened.
    pub reading: Readings,
    /// Tells the thread that keeps drafts that the drawing changed.
    pub changed: OnceLock<Sender<()>>,
    /// The hand console: what happens to it.
    pub hand_console: OnceLock<Sender<Happening>>,
    /// The timing chart that is being made.
    pub charts: Charts,
    /// Does what takes longer than a moment.
    pub pool: Arc<Pool>,
    /// State of the memory: tight or not.
    pub memory: Memory,
    /// Room for what is sent.
    pub bodies: Bodies,
    /// Long work that somebody waits for.
    pub works: Works,
    previews: AtomicU32,
    leases: AtomicU32,
}

/// Parts that an app is made of, besides its options.
pub struct Parts {
    pub hub: Arc<Hub>,
    pub link: Arc<Link>,
    pub orders: Sender<Order>,
    pub left: Arc<Mutex<Left>>,
    pub builders: Builders,
}

impl App {
    /// Nothing is open, nobody is connected.
    ///
    /// # Errors
    /// The part folder or the list of devices cannot be read.
    pub fn new(options: Options, parts: Parts) -> std::io::Result<Self> {
        let Parts { hub, link, orders, left, builders } = parts;
        let clock = link.clock().clone();
        let (devices, told) = Devices::read(&options.data, clock.clone())?;
        told.into_iter().for_each(|told| hub.say(Tone::Warning, told));
        if let Err(error) = hub.ran.keep_in(&options.data) {
            hub.say(Tone::Warning, format!("when files ran last is not known any more: {error}"));
        }
        let here = options.lan.then(|| Here::of(&options.data)).transpose()?;
        let memory = Memory::default();
        Ok(Self {
            parts: PartFolder::new(&options.parts)?,
            draft: draft::file_in(&options.data),
            saves: Saves::new(&options.data),
            texts: Texts::new(&options.data),
            devices,
            here,
            passwords: Mutex::default(),
            pages: Pages::default(),
            turn: Turn::by(clock.clone()),
            unlocked: Unlocked::by(clock.clone()),
            clock,
            desk: Mutex::default(),
            reading: Readings::default(),
            changed: OnceLock::new(),
            hand_console: OnceLock::new(),
            open: Mutex::default(),
            taken: Mutex::default(),
            charts: Charts::default(),
            pool: Arc::new(Pool::begin(memory.clone())?),
            memory,
            bodies: Bodies::default(),
            works: Works::default(),
            previews: AtomicU32::new(0),
            leases: AtomicU32::new(0),
            orders: Mutex::new(orders),
            options,
            hub,
            link,
            left,
            builders,
        })
    }

    /// The number of the next lease.
    pub fn next_lease(&self) -> u32 {
        self.leases.fetch_add(1, Ordering::Relaxed) + 1
    }

    /// Opens a file of the part folder and begins its preview.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn open_file(self: &Arc<Self>, name: &str) -> Result<(), Problem> {
        self.open_with(name, FileParameters::default())
    }

    /// The same, to be run with these parameters.
    ///
    /// # Errors
    /// The file cannot be read, or a parameter makes no sense.
    pub fn open_with(
        self: &Arc<Self>,
        name: &str,
        parameters: FileParameters,
    ) -> Result<(), Problem> {
        self.open_for(name, parameters, None)
    }

    /// The same of a file that a typed line runs.
    ///
    /// # Errors
    /// The file cannot be read.
    pub fn open_called(
        self: &Arc<Self>,
        name: &str,
        parameters: FileParameters,
        run: u32,
    ) -> Result<(), Problem> {
        self.open_for(name, parameters, Some(run))
    }

    fn open_for(
        self: &Arc<Self>,
        name: &str,
        parameters: FileParameters,
        run: Option<u32>,
    ) -> Result<(), Problem> {
        shop::check(&parameters)?;
        let bytes: Arc<[u8]> = self.parts.read(name)?.into();
        if kind_of(name) == FileKind::Job {
            let damaged = kerf_toolpath::read_whole(&bytes).err();
            damaged.map_or(Ok(()), |why| Err(problem(Why::Mistake, format!("{name}: {why}"))))?;
        }
        let mut open = Open { name: name.into(), bytes, parameters, run, ..Open::default() };
        if kind_of(name) == FileKind::Job {
            open = self.with_added(open)?;
        }
        let hash = hash_of(&open.bytes, &parameters, &open.choice);
        self.show(Open { hash, ..open })
    }

    /// Runs the open file with other parameters.
    ///
    /// # Errors
    /// None is open, or a parameter makes no sense.
    pub fn run_with(self: &Arc<Self>, parameters: FileParameters) -> Result<(), Problem> {
        shop::check(&parameters)?;
        let open = lock(&self.open).clone();
        if open.name.is_empty() {
            return Err(problem(Why::State, "no file is open"));
        }
        let hash = hash_of(&open.bytes, &parameters, &open.choice);
        self.show(Open {
            hash,
            parameters,
            preview: None,
            run: None,
            given_up: Arc::default(),
            ..open
        })
    }

    /// Cuts the open job otherwise.
    ///
    /// # Errors
    /// Too much is being done already.
    pub fn cut_with(self: &Arc<Self>, open: Open, choice: JobChoice) -> Result<(), Problem> {
        let hash = hash_of(&open.bytes, &open.parameters, &choice);
        self.show(Open { hash, choice, preview: None, given_up: Arc::default(), ..open })
    }

    /// Makes the preview of the open file anew.
    pub fn preview_again(self: &Arc<Self>) {
        let open = lock(&self.open).clone();
        if !open.name.is_empty() {
            let before = Some(open.key.clone());
            // Where too much is being done the file is opened anew by hand.
            let waits = open.run.filter(|_| open.preview.is_none());
            let anew = Open { preview: None, run: waits, given_up: Arc::default(), ..open };
            drop(self.show_instead(before, anew));
        }
    }

    /// Closes the file that is open.
    pub fn close_file(&self) {
        let mut open = lock(&self.open);
        open.given_up.store(true, Ordering::Relaxed);
        self.charts.give_up();
        *open = Open::default();
        self.hub.change(vec![Change::Opened { opened: None }]);
    }

    fn show(self: &Arc<Self>, open: Open) -> Result<(), Problem> {
        self.hub.moves_on();
        self.show_instead(None, open)
    }

    /// Shows a file; if what is shown is to be that of a key, only while it still is.
    fn show_instead(
        self: &Arc<Self>,
        before: Option<String>,
        mut open: Open,
    ) -> Result<(), Problem> {
        let number = self.previews.fetch_add(1, Ordering::Relaxed);
        open.key = format!("{}-{number}", &open.hash[..16.min(open.hash.len())]);
        let opened = self.opened_of(&open);
        let mut present = lock(&self.open);
        if before.is_some_and(|key| key != present.key) {
            return Ok(());
        }
        present.given_up.store(true, Ordering::Relaxed);
        self.charts.give_up();
        *present = open.clone();
        self.hub.change(vec![Change::Opened { opened: Some(opened) }]);
        drop(present);
        let app = self.clone();
        self.pool.give(Lane::Long, KERF, move || app.preview(open))
    }

    /// Returns what pages are told of a file before its preview is there.
    fn opened_of(&self, open: &Open) -> Opened {
        let opened = Opened {
            name: open.name.clone(),
            hash: open.hash.clone(),
            content: hash(&open.bytes),
            kind: kind_of(&open.name),
            parameters: open.parameters,
            choice: open.choice,
            added: open.unsaved.len() as u32,
            ran: self.hub.ran.of(&open.hash),
            ..Opened::default()
        };
        match opened.kind {
            FileKind::Program => {}
            FileKind::Drawing => return opened,
            FileKind::Job => {
                let [origin, _] = self.lies(open);
                let opened = Opened { origin: Some([origin.x, origin.y]), ..opened };
                return job_told::with_file(opened, &open.bytes, self.shaping().factor);
            }
        }
        let text = String::from_utf8_lossy(&open.bytes);
        let header = kerf_sbp::Header::read(&text).map(|header| header.text);
        Opened { lines: text.lines().count() as u32, header, ..opened }
    }

    /// The program of an open file, named by its place on the disk.
    pub fn program(&self, open: &Open) -> kerf_part::Program {
        let name = self.parts.root().join(&open.name).display().to_string();
        kerf_part::read(name.into(), open.bytes.to_vec())
    }

    fn preview(&self, open: Open) {
        let session = lock(&self.left).session.clone();
        let made = match self.preview_shelf() {
            Err(error) => Err(error.to_string()),
            Ok(mut shelf) => self.work(&open).map_err(|problem| problem.text).map(|work| {
                let parameters = shop::parameters(&open.parameters);
                preview::make(work, parameters, session, &mut shelf, &open.given_up)
            }),
        };
        let state = match made {
            Ok(None) => return,
            Ok(Some(preview)) => Ok(Arc::new(preview)),
            Err(why) => Err(why),
        };
        self.previewed(&open, state);
    }

    /// The timing chart of the open file, with changes of the inputs; without any it is kept.
    pub fn timing(
        &self,
        key: &str,
        preview: &Preview,
        inputs: Vec<InputChange>,
        given_up: &Arc<AtomicBool>,
    ) -> preview::Answer {
        let other =
            || problem(Why::File, "another file, or another chart, was asked for meanwhile");
        let open =
            Some(lock(&self.open).clone()).filter(|open| open.key == key).ok_or_else(other)?;
        let session = lock(&self.left).session.clone();
        let begun = inputs.is_empty().then(|| Begun::of(&session));
        let shelf = self.preview_shelf();
        let mut shelf = shelf.map_err(|error| problem(Why::File, error.to_string()))?;
        let (work, parameters) = (self.work(&open)?, shop::parameters(&open.parameters));
        let made = preview::timing(work, parameters, inputs, session, &mut shelf, given_up);
        let made = Arc::new(made.ok_or_else(other)?);
        if let Some(begun) = begun {
            preview.keep_timing(begun, made.clone());
        }
        Ok(made)
    }

    /// The same without changes of the inputs, if it is known already.
    pub fn known_timing(&self, preview: &Preview) -> Option<Arc<Timing>> {
        preview.timing(&lock(&self.left).session)
    }

    /// Returns the journal of what survives, where there is one.
    pub fn journal(&self) -> Option<Journal> {
        lock(&self.left).journal.clone()
    }

    /// Files as the machine sees them, which nothing changes.
    pub fn preview_shelf(&self) -> std::io::Result<Shelf> {
        let mut shelf = (self.builders.preview)()?;
        let (folder, mask) = {
            let left = lock(&self.left);
            (left.folder.display().to_string(), left.mask.clone())
        };
        if shelf.enter(Some(&folder).filter(|f| !f.is_empty()).map(String::as_str)).is_ok() {
            shelf.set_mask(Some(&mask));
        }
        Ok(shelf)
    }

    /// The preview is there, unless another file was opened meanwhile.
    fn previewed(&self, open: &Open, made: Result<Arc<Preview>, String>) {
        let mut present = lock(&self.open);
        if present.key != open.key {
            return;
        }
        present.preview = made.as_ref().ok().cloned();
        if let Some(preview) = &present.preview {
            let own = hash_of(&present.bytes, &present.parameters, &present.choice);
            present.hash = job_hash(own, &preview.called);
        }
        let hash = present.hash.clone();
        let job = hash.clone();
        self.hub.changing(|now| {
            let Some(opened) = now.opened.clone() else { return Vec::new() };
            let opened = match &made {
                Ok(preview) => {
                    let ran = self.hub.ran.of(&job);
                    let opened = with_preview(opened, open, preview, &self.parts);
                    Opened { hash: job, ran, ..opened }
                }
                Err(why) => {
                    let preview = PreviewState::Failed { why: why.clone() };
                    Opened { preview, broken: true, ..opened }
                }
            };
            vec![Change::Opened { opened: Some(opened) }]
        });
        if let (Some(run), Ok(preview)) = (open.run, made) {
            self.follow(run, hash, &preview);
        }
    }

    /// A run is over. A file that a tool made is opened; a preview that no longer begins where the machine stands is made again.
    pub fn after_run(self: &Arc<Self>, made: Option<String>) {
        if let Some(name) = made {
            // It was written a moment ago; where it cannot be read nothing is opened.
            drop(self.open_file(&name));
        }
        self.keep_taken();
        let session = lock(&self.left).session.clone();
        let stale = lock(&self.open).preview.as_ref().is_some_and(|p| p.is_stale(&session));
        if stale {
            self.preview_again();
        }
        self.tell_drawing();
        self.files_changed();
    }

    /// Writes a file of the part folder, and tells pages; gives the hash of what lies there now.
    ///
    /// # Errors
    /// As of [`Saves::save`].
    pub fn save(&self, name: &str, bytes: &[u8], leave: &Leave) -> Result<String, Problem> {
        let saved = self.saves.save(&self.parts, name, bytes, leave)?;
        self.files_changed();
        Ok(saved)
    }

    /// Files of the part folder may have changed.
    pub fn files_changed(&self) {
        self.hub.changing(|now| vec![Change::Files { files: now.files + 1 }]);
    }
}

fn with_preview(opened: Opened, open: &Open, preview: &Preview, parts: &PartFolder) -> Opened {
    let named = |found: &Finding| Finding { file: parts.name_of(&found.file), ..found.clone() };
    // Of a job it is known already what was noticed while its file was read.
    let read = opened.findings.iter().cloned();
    Opened {
        preview: PreviewState::Ready { key: open.key.clone() },
        seconds: preview.info.seconds,
        findings: read.chain(preview.findings.iter().map(named)).collect(),
        broken: preview.failed,
        ..opened
    }
}
