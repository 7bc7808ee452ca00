//! A part file while it is written.

use super::places::Places;
use super::printing::Printing;
use super::written_speeds::Written;
use crate::syntax::table::settings_lines;
use kerf_program::settings::LinearUnit;
use kerf_program::{At, Changing, Lost, MoveKind, Printer as _, Settings};
use std::sync::Arc;

/// A part file while it is written.
#[derive(Debug)]
pub struct SbpPrinter<'a> {
    pub(super) printing: &'a Printing,
    pub(super) text: String,
    pub(super) lost: Vec<Lost>,
    /// The line of the source that is being written.
    pub(super) at: At,
    /// Comments that stand behind the next line.
    pub(super) beside: Option<String>,
    pub(super) settings: Arc<Settings>,
    /// Settings that hold from here on and are not written yet.
    pub(super) changed: Option<Arc<Settings>>,
    pub(super) places: Places,
    pub(super) speeds: Written,
    pub(super) jog_speeds: Written,
    pub(super) coolant: [bool; 2],
    pub(super) changing: Changing,
    /// A comment that names a tool path was written for this line already.
    pub(super) named: Option<At>,
    pub(super) path_control_told: bool,
}

impl<'a> SbpPrinter<'a> {
    /// Begins a part file.
    pub fn new(printing: &'a Printing) -> Self {
        let mut printer = Self {
            printing,
            text: String::new(),
            lost: Vec::new(),
            at: At::default(),
            beside: None,
            settings: printing.settings.clone(),
            changed: None,
            places: Places::new(printing),
            speeds: Written::default(),
            jog_speeds: Written::default(),
            coolant: [false; 2],
            changing: Changing::default(),
            named: None,
            path_control_told: false,
        };
        printer.begin();
        printer
    }

    fn begin(&mut self) {
        if let Some(title) = &self.printing.title {
            self.comment(title);
        }
        // A machine set to the other unit cuts nothing.
        let (name, wrong) = match self.printing.unit {
            LinearUnit::Inch => ("INCHES", 1),
            LinearUnit::Mm => ("MM", 0),
        };
        self.comment(&format!("UNITS: {name}"));
        self.line(&format!("IF %(25) = {wrong} THEN GOTO UNIT_ERROR"));
        if self.printing.declare_axes {
            let line = settings_lines(&self.settings).into_iter().find(|l| l.starts_with("VD"));
            let fields: Vec<_> = line.iter().flat_map(|l| l.split(',')).take(6).collect();
            if let [_, _, axes, _, a, b] = fields[..] {
                self.line(&format!("VD,,{axes},,{a},{b}"));
            }
        }
        self.line("SA");
    }

    /// Writes a line, and behind it the comment that waits for one.
    pub(super) fn line(&mut self, text: &str) {
        self.text.push_str(text);
        if let Some(comment) = self.beside.take() {
            self.text.push_str(" '");
            self.text.push_str(&comment);
        }
        self.text.push('\n');
    }

    /// Writes a comment that waits for a line into one of its own.
    pub(super) fn flush(&mut self) {
        if let Some(comment) = self.beside.take() {
            self.line(&format!("'{comment}"));
        }
    }

    /// The speeds that the file has said for moves of a kind.
    pub(super) const fn written(&mut self, kind: MoveKind) -> &mut Written {
        match kind {
            MoveKind::Cut => &mut self.speeds,
            MoveKind::Jog => &mut self.jog_speeds,
        }
    }

    pub(super) fn unsaid(&mut self, what: impl Into<String>) {
        self.lose(Lost { at: self.at, what: what.into(), is_motion: false });
    }

    pub(super) fn unsaid_motion(&mut self, what: impl Into<String>) {
        self.lose(Lost { at: self.at, what: what.into(), is_motion: true });
    }
}
