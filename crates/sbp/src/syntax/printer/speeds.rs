//! Feeds as speeds of VS, those of jogs among them.
//!
//! A feed v counts along the path. VS gives XY a vector speed and Z one of its own, and the move is
//! as fast as both allow. Equal speeds v give the feed for moves in XY and for plunges; on a slope
//! they would be faster than v, by 41 % at 45°. There the leading axes get just the speed that makes
//! the move take as long as the feed says. Slopes up to about 5°, where that is less than half a
//! percent, stay at v, so that a shallow relief is not a list of speeds.

use super::file::SbpPrinter;
use super::places::fields;
use super::written_speeds::{GROUPS, Written};
use kerf_program::settings::MM_PER_INCH;
use kerf_program::{Axes, Axis, Feed, MoveKind, decimal};

/// Times that differ by less than this share count as equal.
const SAME_SHARE: f64 = 0.005;
/// VS takes no linear speed below this, mm/s.
const SLOWEST_MM_S: f64 = 0.05 * MM_PER_INCH;

/// Writes the speeds that a move needs; `xy` is the length of its path in XY.
pub(super) fn speed(p: &mut SbpPrinter<'_>, kind: MoveKind, feed: Feed, xy: f64, delta: Axes) {
    let distances = [xy, delta[Axis::Z].abs(), delta[Axis::A].abs(), delta[Axis::B].abs()];
    if delta[Axis::C] != 0.0 && distances == [0.0; 4] {
        return p.unsaid("the speed of C");
    }
    let space = xy.hypot(delta[Axis::Z]);
    let turned = delta[Axis::A].hypot(delta[Axis::B]).hypot(delta[Axis::C]);
    let time = match feed {
        Feed::Path(speed) => (if space > 0.0 { space } else { turned }) / speed,
        Feed::Time(seconds) => seconds,
        Feed::Axis => return axis_speeds(p, kind, &distances),
    };
    let same = |t: f64| (t / time - 1.0).abs() <= SAME_SHARE;
    if p.written(kind).time(&distances).is_some_and(same) {
        return;
    }
    let along = if space > 0.0 { space } else { turned } / time;
    let mut wanted = Written(distances.map(|d| (d > 0.0).then_some(along)));
    if !wanted.time(&distances).is_some_and(same) {
        let linear = if space > 0.0 { 2 } else { 4 };
        let leading = (0..linear).rev().max_by(|a, b| distances[*a].total_cmp(&distances[*b]));
        for (group, distance) in distances.iter().enumerate() {
            // Rotary axes beside linear ones keep pace; of linear ones the longer way leads.
            if *distance > 0.0 && (Some(group) == leading || group >= 2) {
                wanted.0[group] = Some(distance / time);
            }
        }
    }
    write_speeds(p, kind, &wanted);
}

/// Moves without a feed of their own: the speeds of the settings. Jogs have those of the machine until the file
/// says others.
fn axis_speeds(p: &mut SbpPrinter<'_>, kind: MoveKind, distances: &[f64; 4]) {
    let settings = match kind {
        MoveKind::Cut => p.settings.speeds.cut,
        MoveKind::Jog => p.settings.speeds.jog,
    };
    let written = p.written(kind).0;
    let mut wanted = Written::default();
    for (i, axis) in GROUPS.into_iter().enumerate() {
        let speed = settings.of(axis);
        let unsaid = kind == MoveKind::Jog && written[i].is_none();
        if distances[i] > 0.0 && written[i] != Some(speed) && !unsaid {
            wanted.0[i] = Some(speed);
        }
    }
    write_speeds(p, kind, &wanted);
}

fn write_speeds(p: &mut SbpPrinter<'_>, kind: MoveKind, wanted: &Written) {
    let mut named: [Option<String>; 4] = Default::default();
    for (i, axis) in GROUPS.into_iter().enumerate() {
        let Some(speed) = wanted.0[i] else { continue };
        let scale = if i < 2 { p.printing.unit.mm() } else { p.settings.axis_scale(axis) };
        let linear = i < 2 || scale != 1.0;
        let speed = if linear && speed < SLOWEST_MM_S * (1.0 - 1e-9) {
            p.unsaid(format!("{} mm/s: VS begins at 1.27", decimal(speed, 3)));
            SLOWEST_MM_S
        } else {
            speed
        };
        p.written(kind).0[i] = Some(speed);
        named[i] = Some(decimal(speed / scale, 6));
    }
    if named.iter().any(Option::is_some) {
        // Behind the speeds of moves stand those of jogs.
        let command = if kind == MoveKind::Cut { "VS" } else { "VS,,,," };
        let text = fields(command, &named);
        p.line(&text);
    }
}
