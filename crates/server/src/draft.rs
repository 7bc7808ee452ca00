//! The drawing that is not saved, kept in the data folder: who ends the server, or its computer, loses
//! what was drawn in the last half second. The next server begins with it.

use crate::counted::{Counted, Found};
use crate::desk::{DrawingDesk, OpenDrawing, drawing_in};
use crate::digested::hash;
use crate::machine::LastState;
use crate::priority::Yields;
use kerf_formats::rsg;
use kerf_geom::Point2;
use kerf_wire::{Change, Tone};
use serde::{Deserialize, Serialize};
use std::io;
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::thread;
use std::time::Duration;

/// It lies under this name in the data folder.
const FILE: &str = "drawing.draft";

/// Shortest time between two writes of the draft: a change is on the disk within half a second.
const REST: Duration = Duration::from_millis(400);

/// Note about it on the sheet.
const AGAIN: &str = "It was not saved when Kerf ended: here it is again.";

/// Note where the draft is not the one that was written last.
const OLDER: &str = "The drawing that was not saved is an older copy, without what was drawn since. Its file \
                     (drawing.draft in the data folder) was replaced.";

/// Note where there is none and should be one.
const GONE: &str = "The drawing that was not saved is gone: its file (drawing.draft) was taken out of the data folder.";

/// Note where its file is another by now.
const CHANGED: &str = "Its file was changed since it was opened: Save asks before it is replaced.";

/// A drawing that is not saved.
#[derive(Serialize, Deserialize)]
struct Draft {
    /// The file it came from or was saved in last.
    name: Option<String>,
    /// Place to which the head goes when its job is done, mm from its origin; nothing for that of the machine.
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

impl DrawingDesk {
    /// The draft of an earlier server lies on the desk; from now on there is one of what is drawn.
    pub fn keep_drafts(self: &Arc<Self>) {
        self.take_up_draft();
        let (changed, changes) = channel();
        if self.changed.set(changed).is_err() {
            return;
        }
        let drawing = Arc::downgrade(self);
        let mut failed = false;
        thread::spawn(move || {
            Yields::Aside.hold();
            while changes.recv().is_ok() {
                while changes.try_recv().is_ok() {}
                let Some(drawing) = drawing.upgrade() else { return };
                let kept = drawing.write_draft();
                if let (Err(error), false) = (&kept, failed) {
                    let text = format!("what is drawn is only kept until Kerf ends: {error}");
                    drawing.hub.say(Tone::Warning, text);
                }
                failed = kept.is_err();
                drop(drawing);
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
        let draft = self.desk.lock().draft();
        match draft {
            Some(draft) => self.draft.write(&serde_json::to_vec(&draft)?),
            None => self.draft.remove(),
        }
    }

    fn take_up_draft(&self) {
        let (read, older) = match self.draft.read() {
            Ok(Found::Nothing) => return,
            Ok(Found::Gone) => return self.hub.say(Tone::Warning, GONE),
            Ok(Found::Newest(bytes)) => (serde_json::from_slice(&bytes).map_err(Into::into), false),
            Ok(Found::Older(bytes)) => (serde_json::from_slice(&bytes).map_err(Into::into), true),
            Err(error) => (Err(error), false),
        };
        let Draft { name, finish, drawing, kept, job } = match read {
            Ok(draft) => draft,
            Err(error) => return self.put_draft_aside(&error),
        };
        let file = name.as_ref().and_then(|name| Some((name, self.files.folder.read(name).ok()?)));
        let changed = kept.is_some() && kept != file.as_ref().map(|(_, bytes)| hash(bytes));
        let saved = file.and_then(|(name, bytes)| drawing_in(name, &bytes).ok());
        let notes = [Some(AGAIN), older.then_some(OLDER), changed.then_some(CHANGED)];
        let notes = notes.into_iter().flatten().map(Into::into).collect();
        let mut desk = self.desk.lock();
        let drawing = rsg::read(drawing.as_bytes()).drawing;
        desk.notes = self.begin(&mut desk, drawing, name, notes);
        desk.saved = saved.map(|read| read.drawing).unwrap_or_default();
        desk.finish = finish.map(|[x, y]| Point2::new(x, y));
        (desk.kept, desk.job) = (kept, job.map(|job| kerf_toolpath::read(job.as_bytes()).0));
        let drawing = Some(desk.state(&LastState::heights(&self.left)));
        self.hub.change(vec![Change::Drawing { drawing }]);
        if older {
            self.hub.say(Tone::Warning, OLDER);
        }
    }

    fn put_draft_aside(&self, error: &io::Error) {
        let aside = self.draft.path().with_extension("unread");
        let moved = self.draft.put_aside(&aside);
        let lies = if moved.is_ok() { &aside } else { self.draft.path() };
        let text = format!(
            "the drawing that was not saved cannot be read: {error}; it lies in {}",
            lies.display()
        );
        self.hub.say(Tone::Warning, text);
    }
}

/// The draft in a data folder.
pub fn file_in(data: &Path) -> Counted {
    Counted::new(data.join(FILE))
}

impl OpenDrawing {
    /// Returns the draft of what would be lost.
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
