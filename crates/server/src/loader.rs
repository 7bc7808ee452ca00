//! Loads files: the one that is open, and its preview.

use crate::act_checks;
use crate::digested::hash;
use crate::file_kind::kind_of;
use crate::files::PartFolder;
use crate::hub::Hub;
use crate::job_findings;
use crate::locks::{Lock, OPEN, lock};
use crate::machine::{LastState, Link};
use crate::open::{Open, hash_of};
use crate::part_files::PartFiles;
use crate::pool::{KERF, Lane, Pool};
use crate::preview::Basis;
use crate::preview::{self, Charts, Preview};
use crate::refusal::problem;
use crate::setup::Builders;
use crate::thumbnails::Thumbnails;
use crate::unsaved_shapes::UnsavedShapes;
use kerf_journal::Journal;
use kerf_model::Change as InputChange;
use kerf_wire::preview::Timing;
use kerf_wire::{
    Change, FileKind, FileParameters, Finding, JobChoice, Opened, PreviewState, Problem, Tone, Why,
};
use kerf_workspace::Workspace;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex};

/// Loads the file that is to run, and previews it.
pub struct Loader {
    pub hub: Arc<Hub>,
    pub link: Arc<Link>,
    pub left: Arc<Mutex<LastState>>,
    pub files: Arc<PartFiles>,
    pub pool: Arc<Pool>,
    /// Builds the workspace of previews.
    pub builders: Builders,
    /// The file that is open.
    pub open: Lock<OPEN, Open>,
    /// The timing chart that is being made.
    pub charts: Charts,
    /// Shapes that are not saved.
    pub added: UnsavedShapes,
    /// Small pictures of files that were previewed.
    pub thumbnails: Thumbnails,
    /// Number of the next preview.
    pub previews: AtomicU32,
}

impl Loader {
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
        act_checks::check(&parameters)?;
        let bytes: Arc<[u8]> = self.files.folder.read(name)?.into();
        if kind_of(name) == FileKind::Job {
            let damaged = kerf_toolpath::read_whole(&bytes).err();
            damaged.map_or(Ok(()), |why| Err(problem(Why::Mistake, format!("{name}: {why}"))))?;
        }
        let mut open = Open { name: name.into(), bytes, parameters, run, ..Open::default() };
        if kind_of(name) == FileKind::Job {
            open = self.added.restore(open)?;
        }
        let hash = hash_of(&open.name, &open.bytes, &parameters, &open.choice);
        self.show(Open { hash, ..open })
    }

    /// Runs the open file with other parameters.
    ///
    /// # Errors
    /// None is open, or a parameter makes no sense.
    pub fn run_with(self: &Arc<Self>, parameters: FileParameters) -> Result<(), Problem> {
        act_checks::check(&parameters)?;
        let open = self.open.lock().clone();
        if open.name.is_empty() {
            return Err(problem(Why::State, "no file is open"));
        }
        let hash = hash_of(&open.name, &open.bytes, &parameters, &open.choice);
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
        let hash = hash_of(&open.name, &open.bytes, &open.parameters, &choice);
        self.show(Open { hash, choice, preview: None, given_up: Arc::default(), ..open })
    }

    /// Makes the preview of the open file anew.
    pub fn preview_again(self: &Arc<Self>) {
        let open = self.open.lock().clone();
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
        let mut open = self.open.lock();
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
        let mut present = self.open.lock();
        if before.is_some_and(|key| key != present.key) {
            return Ok(());
        }
        present.given_up.store(true, Ordering::Relaxed);
        self.charts.give_up();
        *present = open.clone();
        self.hub.change(vec![Change::Opened { opened: Some(opened) }]);
        drop(present);
        let loader = self.clone();
        self.pool.give(Lane::Long, KERF, move || loader.preview(open))
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
            ran: self.hub.last_run(&open.name, |name| open.hash_as(name)),
            ..Opened::default()
        };
        match opened.kind {
            FileKind::Program => {}
            FileKind::Drawing => return opened,
            FileKind::Job => {
                let [origin, _] = self.lies(open);
                let opened = Opened { origin: Some([origin.x, origin.y]), ..opened };
                return job_findings::with_file(
                    opened,
                    &open.bytes,
                    LastState::shaping(&self.left).factor,
                );
            }
        }
        let text = String::from_utf8_lossy(&open.bytes);
        let header = kerf_sbp::Header::read(&text).map(|header| header.text);
        Opened { lines: text.lines().count() as u32, header, ..opened }
    }

    fn preview(self: &Arc<Self>, open: Open) {
        let session = lock(&self.left).session.clone();
        let begun = session.clone();
        let made = match self.preview_workspace() {
            Err(error) => Err(error.to_string()),
            Ok(mut workspace) => self.work(&open).map_err(|problem| problem.text).map(|work| {
                let parameters = act_checks::parameters(&open.parameters);
                preview::make(work, parameters, session, &mut workspace, &open.given_up)
            }),
        };
        let state = match made {
            Ok(None) => return,
            Ok(Some(preview)) => Ok(Arc::new(preview)),
            Err(why) => Err(why),
        };
        self.previewed(&open, state.clone());
        if let Ok(preview) = state {
            self.keep_thumbnail(&open, &preview);
            let now = lock(&self.left).session.clone();
            // The machine was set otherwise while it was made, and nobody has seen then that it is stale.
            let is_late = preview.is_stale(&now) && !preview.is_stale(&begun);
            if is_late && self.open.lock().key == open.key {
                self.preview_again();
            }
        }
    }

    /// Keeps a small picture of a file that is run as it is.
    fn keep_thumbnail(&self, open: &Open, preview: &Preview) {
        let usual = open.parameters == FileParameters::default();
        let Some(path) = preview.paths.last().filter(|_| usual && !preview.failed) else { return };
        let kept = self.thumbnails.keep(&self.files.folder, &open.name, &preview::thumbnail(path));
        if let Err(error) = kept {
            let text = format!("the small picture of {} is not kept: {error}", open.name);
            self.hub.say(Tone::Warning, text);
        }
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
            Some(self.open.lock().clone()).filter(|open| open.key == key).ok_or_else(other)?;
        let session = lock(&self.left).session.clone();
        let basis = inputs.is_empty().then(|| Basis::of(&session));
        let workspace = self.preview_workspace();
        let mut workspace = workspace.map_err(|error| problem(Why::File, error.to_string()))?;
        let (work, parameters) = (self.work(&open)?, act_checks::parameters(&open.parameters));
        let made = preview::timing(work, parameters, inputs, session, &mut workspace, given_up);
        let made = Arc::new(made.ok_or_else(other)?);
        if let Some(basis) = basis {
            preview.keep_timing(basis, made.clone());
        }
        Ok(made)
    }

    /// The same without changes of the inputs, if it is known already.
    pub fn known_timing(&self, preview: &Preview) -> Option<Arc<Timing>> {
        let session = lock(&self.left).session.clone();
        preview.timing(&session)
    }

    /// Returns `true` for the key of a preview that was begun before the one that is shown now.
    pub fn was_shown(&self, key: &str) -> bool {
        let number = key.rsplit_once('-').and_then(|(_, number)| number.parse::<u32>().ok());
        number.is_some_and(|number| number < self.previews.load(Ordering::Relaxed))
    }

    /// Returns the journal of what survives, where there is one.
    pub fn journal(&self) -> Option<Journal> {
        lock(&self.left).journal.clone()
    }

    /// Files as the machine sees them, which nothing changes.
    pub fn preview_workspace(&self) -> std::io::Result<Workspace> {
        let mut workspace = (self.builders.preview)()?;
        let (folder, mask) = {
            let left = lock(&self.left);
            (left.folder.display().to_string(), left.mask.clone())
        };
        if workspace.enter(Some(&folder).filter(|f| !f.is_empty()).map(String::as_str)).is_ok() {
            workspace.set_mask(Some(&mask));
        }
        Ok(workspace)
    }

    /// The preview is there, unless another file was opened meanwhile.
    fn previewed(&self, open: &Open, made: Result<Arc<Preview>, String>) {
        let mut present = self.open.lock();
        if present.key != open.key {
            return;
        }
        present.preview = made.as_ref().ok().cloned();
        if present.preview.is_some() {
            present.hash = present.hash_as(&present.name);
        }
        let hash = present.hash.clone();
        let job = hash.clone();
        self.hub.changing(|now| {
            let Some(opened) = now.opened.clone() else { return Vec::new() };
            let opened = match &made {
                Ok(preview) => {
                    let ran = self.hub.last_run(&present.name, |name| present.hash_as(name));
                    let opened = with_preview(opened, open, preview, &self.files.folder);
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

    /// Refuses what would lose shapes that were added to the open job.
    ///
    /// # Errors
    /// There are such shapes.
    pub fn nothing_unsaved(&self) -> Result<(), Problem> {
        let open = self.open.lock().clone();
        match open.unsaved.len() {
            0 => Ok(()),
            added => {
                let shapes = if added == 1 { "a digitized shape" } else { "digitized shapes" };
                let name = open.name;
                let text = format!(
                    "{name} has {shapes} more than its file: save the job, or take them back"
                );
                Err(problem(Why::State, text))
            }
        }
    }
}

fn with_preview(opened: Opened, open: &Open, preview: &Preview, parts: &PartFolder) -> Opened {
    let named = |found: &Finding| Finding { file: parts.name_of(&found.file), ..found.clone() };
    // Of a job it is known already what was noticed while its file was read.
    let read = opened.findings.iter().cloned();
    Opened {
        preview: PreviewState::Ready { key: open.key.clone() },
        seconds: preview.info.seconds,
        samples: preview.samples.clone(),
        findings: read.chain(preview.findings.iter().map(named)).collect(),
        broken: preview.failed,
        ..opened
    }
}
