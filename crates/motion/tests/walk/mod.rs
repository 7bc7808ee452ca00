//! Stacks of moves made at random.

use kerf_motion::{Move, Mover};
use kerf_program::{Arc, At, Axes, Feed, Line, MoveKind, Settings};

/// Lines and arcs of all sizes, smooth and rough stretches, changes of speed, plunges and jogs.
pub fn moves(count: usize, mut seed: u64) -> Vec<Move> {
    let mut random = move || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 40) as f64 / (1u64 << 24) as f64
    };
    let mut settings = Settings::default();
    let mut mover = Mover::new(Axes::default(), &settings);
    let (mut heading, mut made) = (0.0, Vec::new());
    while made.len() < count {
        let [x, y, z] = mover.position().first3();
        let rough = if made.len() / 500 % 2 == 0 { 0.03 } else { 1.5 };
        heading += (random() - 0.5) * rough;
        let (sin, cos) = f64::sin_cos(heading);
        let step = if made.len() / 2000 % 2 == 0 { 0.02 } else { 3.0 } * random();
        let choice = random();
        if choice < 0.002 {
            settings.speeds.cut.xy = 5.0 + 300.0 * random();
            mover.settings(&settings);
        }
        let kind = if choice > 0.9995 { MoveKind::Jog } else { MoveKind::Cut };
        let next = if choice < 0.05 {
            let (radius, sweep_rad) = (step + 0.1, (random() - 0.5) * 4.0);
            let centre = [x - radius * sin, y + radius * cos];
            let (s, c) = f64::sin_cos(heading + sweep_rad);
            heading += sweep_rad;
            let to = Axes::xyz(centre[0] + radius * s, centre[1] - radius * c, z);
            let feed = Feed::Axis;
            mover.arc(
                At::default(),
                &Arc { kind, centre, sweep_rad, to, feed, chords: 8, small: false },
            )
        } else {
            let plunge = choice > 0.998;
            let [dx, dy] = if plunge { [0.0; 2] } else { [step * cos, step * sin] };
            let to = Axes::xyz(x + dx, y + dy, z + if plunge { 0.5 } else { 0.0 });
            mover.line(At::default(), &Line { kind, to, feed: Feed::Axis })
        };
        made.extend(next);
    }
    made
}
