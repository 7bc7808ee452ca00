//! The drawing that is not saved, kept in the data folder: who ends the server, or its computer, loses
//! what was drawn in the last half second. The next server begins with it.

use crate::app::{App, hash, lock};
use crate::desk::{Desk, drawing_in};
use crate::digested::{checked, with_digest};
use crate::priority::Yields;
use kerf_control::files::{Disk, RealDisk};
use kerf_formats::rsg;
use kerf_geom::Point2;
use kerf_wire::{Change, Tone};
use serde::{Deserialize, Serialize};
use std::fs;
use std::io;
use std::iter;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::thread;
use std::time::Duration;

/// It lies under this name in the data folder.
const FILE: &str = "drawing.draft";

/// It is written at once, and then not again for so long: with the way to the disk that stays below half a second.
const REST: Duration = Duration::from_millis(400);

/// What is told of it on the sheet.
const AGAIN: &str = "It was not saved when Kerf ended: here it is again.";

/// What is told where its file is another by now.
const CHANGED: &str = "Its file was changed since it was opened: Save asks before it is replaced.";

/// A drawing that is not saved.
#[derive(Serialize, Deserialize)]
struct Draft {
    /// The file it came from or was saved in last.
    name: Option<String>,
    /// Where the head goes when its job is done, mm from its origin; nothing for where the machine has it.
    finish: Option<[f64; 2]>,
    /// It as an RSG.
    drawing: String,
    /// The hash of its file as it was opened or saved.
    #[serde(default)]
    kept: Option<String>,
    /// The job whose paths are drawn on, as an RSM.
    #[serde(default)]
    job: Option<String>,
}

impl App {
    /// The draft of an earlier server lies on the desk; from now on there is one of what is drawn.
    pub fn keep_drafts(self: &Arc<Self>) {
        self.take_up_draft();
        let (changed, changes) = channel();
        if self.changed.set(changed).is_err() {
            return;
        }
        let app = Arc::downgrade(self);
        let mut failed = false;
        thread::spawn(move || {
            Yields::Aside.hold();
            while changes.recv().is_ok() {
                while changes.try_recv().is_ok() {}
                let Some(app) = app.upgrade() else { return };
                let kept = app.write_draft();
                if let (Err(error), false) = (&kept, failed) {
                    let text = format!("what is drawn is only kept until Kerf ends: {error}");
                    app.hub.say(Tone::Warning, text);
                }
                failed = kept.is_err();
                drop(app);
                thread::sleep(REST);
            }
        });
    }

    /// The drawing was changed, or saved.
    pub fn drawn(&self) {
        if let Some(changed) = self.changed.get() {
            // Where nobody listens any more the server ends, and writes it then.
            _ = changed.send(());
        }
    }

    /// Puts the present draft in place; none where everything is saved.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn write_draft(&self) -> io::Result<()> {
        let draft = lock(&self.desk).draft();
        let file = self.draft_file();
        match draft {
            Some(draft) => RealDisk.write(&file, &with_digest(&serde_json::to_vec(&draft)?)),
            None if file.is_file() => fs::remove_file(&file),
            None => Ok(()),
        }
    }

    fn draft_file(&self) -> PathBuf {
        self.options.data.join(FILE)
    }

    fn take_up_draft(&self) {
        let file = self.draft_file();
        if !file.is_file() {
            return;
        }
        let read =
            RealDisk.read(&file).and_then(|bytes| Ok(serde_json::from_slice(checked(&bytes)?)?));
        let Draft { name, finish, drawing, kept, job } = match read {
            Ok(draft) => draft,
            Err(error) => {
                let aside = file.with_extension("unread");
                let moved = fs::rename(&file, &aside).map_or(file, |()| aside);
                let text = format!(
                    "the drawing that was not saved cannot be read: {error}; it lies in {}",
                    moved.display()
                );
                return self.hub.say(Tone::Warning, text);
            }
        };
        let file = name.as_ref().and_then(|name| Some((name, self.parts.read(name).ok()?)));
        let changed = kept.is_some() && kept != file.as_ref().map(|(_, bytes)| hash(bytes));
        let saved = file.and_then(|(name, bytes)| drawing_in(name, &bytes).ok());
        let notes = iter::once(AGAIN).chain(changed.then_some(CHANGED)).map(Into::into).collect();
        let mut desk = lock(&self.desk);
        let drawing = rsg::read(drawing.as_bytes()).drawing;
        desk.notes = self.begin(&mut desk, drawing, name, notes);
        desk.saved = saved.map(|read| read.drawing).unwrap_or_default();
        desk.finish = finish.map(|[x, y]| Point2::new(x, y));
        (desk.kept, desk.job) = (kept, job.map(|job| kerf_toolpath::read(job.as_bytes()).0));
        let drawing = Some(desk.state(&self.heights()));
        self.hub.change(vec![Change::Drawing { drawing }]);
    }
}

impl Desk {
    /// What would be lost.
    fn draft(&self) -> Option<Draft> {
        let drawing = &self.editor.drawing;
        let finish = self.finish.map(|at| [at.x, at.y]);
        let draft = || Draft {
            name: self.name.clone(),
            finish,
            drawing: rsg::write(drawing),
            kept: self.kept.clone(),
            job: self.job.as_ref().map(kerf_toolpath::write),
        };
        (*drawing != self.saved).then(draft)
    }
}
