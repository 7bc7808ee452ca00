//! Conversions in memory.

#![allow(dead_code)]

#[path = "../../../gcode/tests/support/mod.rs"]
mod quiet;

use kerf_convert::{Conversion, Converted, Language, Passage, Source, convert, passage};
use kerf_gcode::Dialect;
use kerf_program::settings::LinearUnit;
use kerf_program::{Axes, Axis, Command, Feed, MoveKind, Settings};
use std::path::PathBuf;

pub const LINUXCNC: Language = Language::Gcode(Dialect::LinuxCnc);
pub const GRBL: Language = Language::Gcode(Dialect::Grbl);
pub const GENERIC: Language = Language::Gcode(Dialect::Generic);
pub const SBP: Language = Language::OpenSbp;

/// A conversion without anything special, on a machine in a unit.
pub fn plain(from: Language, to: Language, unit: LinearUnit) -> Conversion {
    let mut settings = Settings::default();
    settings.use_linear_unit(unit);
    Conversion {
        from,
        to,
        settings,
        sbp: kerf_sbp::Options { max_lines: 1_000_000, ..kerf_sbp::Options::default() },
        variables: kerf_sbp::Variables::default(),
        coolant_outputs: [0, 0],
        title: String::new(),
    }
}

/// Converts a text; files it names lie in a folder.
pub fn converted(name: &str, bytes: &[u8], how: &Conversion, folder: PathBuf) -> Converted {
    let source = Source { name: name.into(), bytes, language: how.from };
    convert(&source, how, &mut |follow| follow(&mut quiet::Quiet(folder.clone())))
}

/// Follows a text from zero.
pub fn followed(name: &str, bytes: &[u8], how: &Conversion, folder: PathBuf) -> Passage {
    let source = Source { name: name.into(), bytes, language: how.from };
    let mut hosts = |follow: &mut dyn FnMut(&mut dyn kerf_program::Host) -> Passage| {
        follow(&mut quiet::Quiet(folder.clone()))
    };
    passage(&source, how, &mut hosts, Axes::default())
}

/// How long its cuts take at their feeds, seconds, without ramps; changes of tools left out.
pub fn cutting_s(passage: &Passage, settings: &Settings) -> f64 {
    let (mut here, mut speeds, mut total, mut changing) =
        (passage.start, settings.speeds, 0.0, false);
    for sourced in passage.commands() {
        let (kind, to, feed, xy) = match &sourced.command {
            Command::Line(l) => {
                (l.kind, l.to, l.feed, (l.to.0[0] - here.0[0]).hypot(l.to.0[1] - here.0[1]))
            }
            Command::Arc(a) => {
                let radius = (a.centre[0] - here.0[0]).hypot(a.centre[1] - here.0[1]);
                (a.kind, a.to, a.feed, radius * a.sweep_rad.abs())
            }
            Command::Settings(settings) => {
                speeds = settings.speeds;
                continue;
            }
            Command::ToolChange { begin } => {
                changing = *begin;
                continue;
            }
            _ => continue,
        };
        let delta = to.minus(std::mem::replace(&mut here, to));
        if kind == MoveKind::Jog || changing {
            continue;
        }
        let space = xy.hypot(delta[Axis::Z]);
        let turned = delta[Axis::A].hypot(delta[Axis::B]).hypot(delta[Axis::C]);
        total += match feed {
            Feed::Path(speed) => (if space > 0.0 { space } else { turned }) / speed,
            Feed::Time(seconds) => seconds,
            Feed::Axis => Axis::ALL[2..]
                .iter()
                .map(|a| delta[*a].abs() / speeds.cut.of(*a))
                .fold(xy / speeds.cut.xy, f64::max),
        };
    }
    total
}

/// Real files of a kind, by name; nothing where they are not beside the checkout. They are looked for
/// in `shared/corpus` beside it or beside one of its parents; `KERF_SHARED` names another place.
pub fn corpus(kind: &str) -> Option<(PathBuf, Vec<String>)> {
    let named = std::env::var_os("KERF_SHARED").map(PathBuf::from);
    let here = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let around = here.ancestors().map(|parent| parent.join("shared"));
    let mut folders = named.into_iter().chain(around).map(|s| s.join("corpus").join(kind));
    let folder = folders.find(|folder| folder.is_dir())?;
    let names =
        std::fs::read_dir(&folder).ok()?.filter_map(|e| e.ok()?.file_name().into_string().ok());
    let mut names: Vec<String> = names.collect();
    names.sort();
    Some((folder, names))
}
