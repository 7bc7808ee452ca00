//! Points that are being digitized, kept in the data folder: who ends the server, or its computer, loses none
//! of them.

use crate::app::App;
use kerf_digitize::{Digitizer, Point};
use kerf_files::{Disk, RealDisk};
use kerf_wire::Tone;
use std::fs;
use std::io;
use std::path::PathBuf;

/// They lie under this name in the data folder.
const FILE: &str = "digitized.draft";

/// Note about them when the server begins.
const AGAIN: &str = "Points were being digitized when Kerf ended: function 70 goes on with them.";

/// The points that are kept.
#[derive(Debug, Default)]
pub struct KeptPoints {
    points: Vec<Point>,
    failed: bool,
}

impl KeptPoints {
    /// Those of an earlier server.
    pub fn take_up(&mut self, app: &App) -> Option<Digitizer> {
        let bytes = RealDisk.read(&file(app)).ok()?;
        match serde_json::from_slice::<Digitizer>(&bytes) {
            Ok(points) => {
                app.hub.say(Tone::Note, AGAIN);
                self.points = points.points().to_vec();
                Some(points)
            }
            Err(error) => {
                let text = format!("points that were being digitized cannot be read: {error}");
                app.hub.say(Tone::Warning, text);
                None
            }
        }
    }

    /// Keeps the points as they are now. Where there are none any more nothing is kept.
    pub fn keep(&mut self, app: &App, present: Option<&Digitizer>) {
        let points = present.map(Digitizer::points).unwrap_or_default();
        if points == self.points {
            return;
        }
        self.points = points.to_vec();
        let kept = write(&file(app), present.filter(|_| !points.is_empty()));
        if let (Err(error), false) = (&kept, self.failed) {
            let text = format!("what is digitized is only kept until Kerf ends: {error}");
            app.hub.say(Tone::Warning, text);
        }
        self.failed = kept.is_err();
    }
}

fn file(app: &App) -> PathBuf {
    app.options.data.join(FILE)
}

fn write(file: &std::path::Path, points: Option<&Digitizer>) -> io::Result<()> {
    match points {
        Some(points) => RealDisk.write(file, &serde_json::to_vec(points)?),
        None if file.is_file() => fs::remove_file(file),
        None => Ok(()),
    }
}
