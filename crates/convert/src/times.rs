//! The time that a program cuts, and the things it switches.

use crate::item::{Item, Passage};
use kerf_program::{Axes, Axis, Command, Feed, MoveKind, Settings};

/// Computes how long its cuts take at their feeds, seconds, without ramps; changes of tools left out.
pub fn cutting_s(passage: &Passage, settings: &Settings) -> f64 {
    let (mut here, mut speeds, mut total, mut changing) =
        (passage.start, settings.speeds, 0.0, false);
    for sourced in passage.commands() {
        let (kind, to, feed, xy) = match &sourced.command {
            Command::Line(line) => {
                let xy = (line.to.0[0] - here.0[0]).hypot(line.to.0[1] - here.0[1]);
                (line.kind, line.to, line.feed, xy)
            }
            Command::Arc(arc) => {
                let radius = (arc.centre[0] - here.0[0]).hypot(arc.centre[1] - here.0[1]);
                (arc.kind, arc.to, arc.feed, radius * arc.sweep_rad.abs())
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
        if kind == MoveKind::Cut && !changing {
            total += seconds(feed, &speeds.cut, xy, delta);
        }
    }
    total
}

fn seconds(feed: Feed, speeds: &kerf_program::settings::PerGroup, xy: f64, delta: Axes) -> f64 {
    let space = xy.hypot(delta[Axis::Z]);
    let turned = delta[Axis::A].hypot(delta[Axis::B]).hypot(delta[Axis::C]);
    match feed {
        Feed::Path(speed) => (if space > 0.0 { space } else { turned }) / speed,
        Feed::Time(seconds) => seconds,
        Feed::Axis => {
            let others = Axis::ALL[2..].iter().map(|a| delta[*a].abs() / speeds.of(*a));
            others.fold(xy / speeds.xy, f64::max)
        }
    }
}

/// Lists what it switches, waits for and asks, in order. What happens while a tool is changed is each
/// machine's own.
pub(crate) fn switched(passage: &Passage) -> Vec<String> {
    let mut changing = false;
    let words = |item: &Item| {
        if let Item::Command(sourced) = item
            && let Command::ToolChange { begin } = sourced.command
        {
            changing = begin;
            return begin.then(|| "tool".into());
        }
        if changing { None } else { switching(item) }
    };
    passage.items.iter().filter_map(words).collect()
}

fn switching(item: &Item) -> Option<String> {
    match item {
        Item::Command(sourced) => match &sourced.command {
            Command::Output { number, on } => Some(format!("output {number} {on}")),
            Command::Wait { seconds } => Some(format!("wait {seconds:.3}")),
            Command::Spindle { rpm, .. } => Some(format!("speed {rpm:.3}")),
            _ => None,
        },
        Item::Hold(_) => Some("hold".into()),
        _ => None,
    }
}
