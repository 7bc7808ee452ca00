//! Progress of a run, and the place where it was given up.

use super::Tape;
use super::lag::Lag;
use crate::progress::Progress;
use crate::reached::Reached;
use crate::{Hurry, Placed};

impl Tape {
    /// Returns `true` if what is made goes on record.
    pub const fn is_written(&self) -> bool {
        self.writing.is_some()
    }

    /// A move was made; the machine is there.
    pub fn made(&mut self, file: &str, line: u32, place: Placed) {
        if self.writing.is_none() {
            return;
        }
        let reached = &mut self.reached;
        (reached.made, reached.within) = (reached.made + 1, 0.0);
        (reached.line, reached.place) = (line, place);
        if reached.file != file {
            file.clone_into(&mut reached.file);
        }
        let made = self.reached.made;
        if let Some(lag) = &mut self.lag {
            lag.tells((made, 0.0));
        }
        let sure = self.sure();
        if !self.silent
            && let Some(progress) = &mut self.writing
        {
            progress.pass(sure.as_ref().unwrap_or(&self.reached));
        }
    }

    /// The run tells of moves so long before they are made, seconds: what is on record lags behind by as much.
    pub fn lags(&mut self, leads_s: f64) {
        self.lag = Some(Lag::new(leads_s, (self.reached.made, self.reached.within)));
    }

    /// Machine time has come to a moment of a move.
    pub fn comes_to(&mut self, now_s: f64) {
        if let Some(lag) = &mut self.lag {
            lag.comes_to(now_s);
        }
    }

    /// The machine stands: what was told is made.
    pub(super) fn comes_to_rest(&mut self) {
        if let Some(lag) = &mut self.lag {
            lag.stands((self.reached.made, self.reached.within));
        }
    }

    /// Returns the progress that is sure, where the run tells of moves before they are made.
    fn sure(&self) -> Option<Reached> {
        let (made, within) = self.lag.as_ref()?.sure();
        Some(Reached { made, within, ..self.reached.clone() })
    }

    /// Notes how much of the move under way is made, and the machine's place.
    pub fn makes(&mut self, share: f64, place: Placed) {
        (self.reached.within, self.reached.place) = (share, place);
        if let Some(lag) = &mut self.lag {
            lag.tells((self.reached.made, share));
        }
        self.write();
    }

    /// The machine was stopped; of the move made last so much is made.
    pub fn stood(&mut self, share: f64) {
        let partly = share > 0.0 && share < 1.0;
        let made = self.reached.made;
        self.stood = Some(if partly { (made.saturating_sub(1), share) } else { (made, 0.0) });
    }

    /// The machine was stopped at a moment that is not long past, and is not moved on: the run can be taken up from there,
    /// whatever was told of moves behind it.
    pub fn broke_off(&mut self, at_s: f64, place: Placed) {
        self.stood = self.lag.as_ref().map(|lag| lag.made_until(at_s));
        self.given_up(place);
    }

    /// The operator stopped the run and gives it up: it can be taken up as if he had not.
    pub fn given_up(&mut self, place: Placed) {
        let Some(progress) = &mut self.writing else { return };
        let (request, stood) = match self.back {
            Some((reentry, stood)) => (Some(reentry), Some(stood)),
            None => (self.request, self.stood),
        };
        if let Some(request) = request {
            progress.drop_steps(request);
        }
        let reached = &mut self.reached;
        (reached.stopped, reached.moving, reached.place) = (true, false, place);
        (reached.made, reached.within) = stood.unwrap_or((reached.made, 0.0));
        self.comes_to_rest();
        self.write();
        self.settle();
        // What is told from here on belongs to giving up, and is not played when it is taken up.
        self.writing = None;
    }

    /// The operator gives a job up that waits: it can be taken up as if he had not answered, which is the last
    /// that was told.
    pub fn given_up_by_answer(&mut self, place: Placed) {
        self.request = self.writing.as_ref().and_then(Progress::last_step);
        (self.back, self.stood) = (None, Some((self.reached.made, 0.0)));
        self.given_up(place);
    }

    /// Returns `true` if a move was made.
    pub const fn has_moved(&self) -> bool {
        self.reached.made > 0
    }

    /// Returns the progress of a run that was given up.
    pub(crate) fn left_at(&self) -> Option<&Reached> {
        self.reached.stopped.then_some(&self.reached)
    }

    /// The machine sets off from a place, or stands there.
    pub fn moves(&mut self, moving: bool, place: Placed) {
        (self.reached.moving, self.reached.place) = (moving, place);
        if !moving {
            self.comes_to_rest();
        }
        if self.silent {
            return;
        }
        let sure = self.sure();
        match &mut self.writing {
            Some(progress) if moving => progress.set_off(sure.as_ref().unwrap_or(&self.reached)),
            Some(progress) => progress.pass(sure.as_ref().unwrap_or(&self.reached)),
            None => {}
        }
    }

    /// Sets the flags that tell where the run stands.
    pub const fn stands(&mut self, status: u8) {
        self.reached.live.status = status;
    }

    /// Which inputs and outputs are on.
    pub const fn switches(&mut self, inputs: u16, outputs: u16) {
        (self.reached.live.inputs, self.reached.live.outputs) = (inputs, outputs);
    }

    /// Hands writing to a thread: the machine's thread waits for no disk from now on.
    pub fn writes_behind(&mut self, hurry: Option<Hurry>) {
        if let Some(progress) = &mut self.writing {
            progress.writes_behind(hurry);
        }
    }

    /// Everything up to here is on record, where the disk keeps up; no longer than until the machine is to stop.
    pub fn settle(&self) {
        if let Some(progress) = self.writing.as_ref().filter(|_| !self.silent) {
            progress.settle();
        }
    }

    /// Everything up to here has to be in the file, now or soon.
    pub fn write(&mut self) {
        let sure = self.sure();
        if !self.silent
            && let Some(progress) = &mut self.writing
        {
            progress.write(sure.as_ref().unwrap_or(&self.reached));
        }
    }

    /// Returns why nothing can be written, when that was not told yet.
    pub fn new_trouble(&mut self) -> Option<String> {
        self.writing.as_mut()?.new_trouble()
    }
}
