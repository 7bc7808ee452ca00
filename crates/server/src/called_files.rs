//! Files that a typed line runs (FP, FG), shown as the file on the screen: name, lines, picture, progress.

use crate::loader::Loader;
use crate::locks::lock;
use crate::machine::CalledFile;
use crate::open::Open;
use crate::preview::Preview;
use kerf_wire::{Change, CurrentRun, Motion, Tone};
use std::sync::Arc;

impl Loader {
    /// Shows the file of a typed line, which runs.
    pub fn show_called(self: &Arc<Self>, called: CalledFile) {
        if let Some((hash, preview)) = self.present_of(&called) {
            return self.follow(called.run, hash, &preview);
        }
        let CalledFile { run, name, parameters } = called;
        let shown = self.nothing_unsaved().and_then(|()| self.open_called(&name, parameters, run));
        if let Err(why) = shown {
            self.hub.say(Tone::Note, format!("{name} runs and is not on the screen: {}", why.text));
        }
    }

    /// The preview of that file, where it is on the screen already as it runs now.
    fn present_of(
        &self,
        CalledFile { name, parameters, .. }: &CalledFile,
    ) -> Option<(String, Arc<Preview>)> {
        let Open { name: open, parameters: with, hash, preview, bytes, .. } =
            self.open.lock().clone();
        let session = lock(&self.left).session.clone();
        let preview = preview.filter(|preview| !preview.is_stale(&session))?;
        let same = open == *name && with == *parameters;
        let unchanged = same && self.files.folder.read(name).is_ok_and(|now| now[..] == bytes[..]);
        unchanged.then_some((hash, preview))
    }

    /// The run of a typed line is that of the file on the screen, by its plan.
    pub fn follow(&self, run: u32, hash: String, preview: &Preview) {
        let planned = &preview.planned;
        self.link.plans(run, planned.clone());
        let mut ended = None;
        self.hub.changing(|now| {
            let unplanned = |job: &CurrentRun| job.run == run && job.seconds <= 0.0;
            let Some(job) = now.job.clone().filter(unplanned) else { return Vec::new() };
            let job = CurrentRun { hash: Some(hash), seconds: planned.seconds(), ..job };
            ended = Some(job.clone()).filter(|job| job.ended.is_some());
            let whole = job.ended.as_deref() == Some("ok");
            let progress = if whole { 1.0 } else { planned.share(now.motion.made) };
            let motion = Motion { progress, ..now.motion };
            vec![Change::Motion { motion }, Change::Job { job: Some(job) }]
        });
        if let Some(job) = ended {
            self.hub.ended(job);
        }
    }
}
