//! Options that describe another controller.

use crate::exit::Usage;
use crate::parse;
use anyhow::{Result, bail};
use clap::{Args, ValueEnum};
use kerf_motion::controllers::{Controller, Grbl, Link, LinuxCnc, Release};
use kerf_program::Dynamics;

/// The controllers whose times can be told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// grbl 1.1 and its family: junction deviation, short look-ahead, a serial line
    Grbl,
    /// LinuxCNC with G64 P: corners rounded within a tolerance
    Linuxcnc,
}

/// The versions of LinuxCNC whose times differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum LinuxCncRelease {
    /// 2.9 and before
    #[value(name = "2.9")]
    V2_9,
    /// 2.10
    #[value(name = "2.10")]
    V2_10,
}

/// Another controller and its settings.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Another controller; --axis-speed and --accel are its axes")]
pub struct ControllerArgs {
    /// Estimates the time that this controller takes for the same moves
    #[arg(long, value_enum)]
    pub controller: Option<Kind>,
    /// grbl: $11, mm [default: 0.01]
    #[arg(long, value_name = "MM", value_parser = parse::not_negative)]
    junction_deviation: Option<f64>,
    /// grbl: $12, how far the chords of an arc may leave it, mm [default: 0.002]
    #[arg(long, value_name = "MM", value_parser = parse::positive)]
    arc_tolerance: Option<f64>,
    /// grbl: blocks of the planner's buffer [default: 16]
    #[arg(long, value_name = "BLOCKS")]
    look_ahead: Option<usize>,
    /// grbl: rate of its serial line, baud; 0 for a link without delay
    /// [default: 115200]
    #[arg(long, value_name = "BAUD", value_parser = parse::not_negative)]
    baud: Option<f64>,
    /// grbl: bytes of its receive buffer [default: 128]
    #[arg(long, value_name = "BYTES")]
    receive_buffer: Option<usize>,
    /// linuxcnc: G64 P, how far corners may be rounded, mm; 0 for exact stop [default: 0.05]
    #[arg(long, value_name = "MM", value_parser = parse::not_negative)]
    blend: Option<f64>,
    /// linuxcnc: its version [default: 2.9]
    #[arg(long, value_enum, value_name = "VERSION")]
    release: Option<LinuxCncRelease>,
}

impl ControllerArgs {
    /// The controller with axes that can do so much; `None` when none is asked for.
    ///
    /// # Errors
    /// Options that do not belong to the controller.
    pub fn controller(&self, axes: &Dynamics) -> Result<Option<Box<dyn Controller>>> {
        if let Some(name) = self.foreign_option() {
            let whose = match self.controller {
                None => "no controller is named; see --controller",
                Some(Kind::Grbl) => "it does not belong to --controller grbl",
                Some(Kind::Linuxcnc) => "it does not belong to --controller linuxcnc",
            };
            bail!(Usage(format!("{name}: {whose}")));
        }
        Ok(match self.controller {
            None => None,
            Some(Kind::Grbl) => Some(Box::new(self.grbl(axes))),
            Some(Kind::Linuxcnc) => Some(Box::new(self.linuxcnc(axes))),
        })
    }

    fn linuxcnc(&self, axes: &Dynamics) -> LinuxCnc {
        let blend_mm = self.blend.unwrap_or(0.05);
        LinuxCnc {
            release: match self.release {
                None | Some(LinuxCncRelease::V2_9) => Release::V2_9,
                Some(LinuxCncRelease::V2_10) => Release::V2_10,
            },
            speed_mm_s: axes.speed_mm_s,
            accel_mm_s2: axes.accel_mm_s2,
            blend_mm,
            same_line_mm: blend_mm,
        }
    }

    fn grbl(&self, axes: &Dynamics) -> Grbl {
        let usual = Grbl::new(axes.speed_mm_s, axes.accel_mm_s2);
        let link = Link::default();
        let baud = self.baud.unwrap_or(link.baud);
        let buffer = self.receive_buffer.unwrap_or(link.buffer);
        Grbl {
            junction_deviation_mm: self.junction_deviation.unwrap_or(usual.junction_deviation_mm),
            arc_tolerance_mm: self.arc_tolerance.unwrap_or(usual.arc_tolerance_mm),
            blocks: self.look_ahead.unwrap_or(usual.blocks),
            link: (baud > 0.0).then_some(Link { baud, buffer }),
            ..usual
        }
    }

    fn foreign_option(&self) -> Option<&'static str> {
        let (grbl, linuxcnc) =
            (self.controller == Some(Kind::Grbl), self.controller == Some(Kind::Linuxcnc));
        let options = [
            ("--junction-deviation", self.junction_deviation.is_some(), grbl),
            ("--arc-tolerance", self.arc_tolerance.is_some(), grbl),
            ("--look-ahead", self.look_ahead.is_some(), grbl),
            ("--baud", self.baud.is_some(), grbl),
            ("--receive-buffer", self.receive_buffer.is_some(), grbl),
            ("--blend", self.blend.is_some(), linuxcnc),
            ("--release", self.release.is_some(), linuxcnc),
        ];
        options.into_iter().find(|(_, given, fits)| *given && !fits).map(|(name, ..)| name)
    }
}
