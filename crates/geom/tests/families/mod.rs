//! Families of shapes that are hard to offset, each shape made from a seed, and the shapes of the
//! benchmarks.
#![allow(dead_code)]

use kerf_geom::{Point2, Polyarc, Vec2, Vertex};

/// A small generator of numbers that look random (SplitMix64), the same on every machine.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(0x1234_5678_9ABC_DEF1))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    pub fn whole(&mut self, low: i64, high: i64) -> i64 {
        low + (self.next() % (high - low + 1) as u64) as i64
    }

    pub fn one_of(&mut self, list: &[f64]) -> f64 {
        list[self.whole(0, list.len() as i64 - 1) as usize]
    }
}

/// A closed counter-clockwise shape and by how much to offset it.
pub type Case = (Polyarc, f64);

/// A name, and what makes a case from a seed.
pub type Family = (&'static str, fn(u64) -> Case);

/// All families.
pub const FAMILIES: &[Family] = &[
    ("skyline", skyline),
    ("filleted", filleted),
    ("smooth 500", |seed| smooth(seed, 500)),
    ("smooth 5000", |seed| smooth(seed, 5000)),
    ("noisy 300", |seed| noisy(seed, 300)),
    ("noisy 1000", |seed| noisy(seed, 1000)),
    ("polyarc", polyarc),
    ("comb", comb),
    ("cracks", cracks),
];

fn signed(dice: &mut Dice, size: f64) -> f64 {
    if dice.share() < 0.5 { -size } else { size }
}

/// Steps up and down on a grid above a straight base, cut by a distance of the same grid.
pub fn skyline(seed: u64) -> Case {
    let mut dice = Dice::new(seed);
    let places = steps(&mut dice);
    let distance = dice.one_of(&[0.25, 0.5, 1.0, 1.5]);
    (Polyarc::lines(places, true), signed(&mut dice, distance))
}

fn steps(dice: &mut Dice) -> Vec<Point2> {
    let count = dice.whole(3, 20);
    let (mut x, mut places) = (0.0, Vec::new());
    for _ in 0..count {
        let y = dice.whole(-20, -2) as f64;
        places.push(Point2::new(x, y));
        x += dice.whole(1, 4) as f64;
        places.push(Point2::new(x, y));
    }
    places.push(Point2::new(x, 20.0));
    places.push(Point2::new(0.0, 20.0));
    places.dedup();
    places
}

/// The same with rounded corners whose radius is often the distance.
pub fn filleted(seed: u64) -> Case {
    let mut dice = Dice::new(seed);
    let places = steps(&mut dice);
    let radius = dice.one_of(&[0.25, 0.4, 0.5]);
    let distance = dice.one_of(&[0.25, 0.5, 1.0, 1.5]);
    (rounded(&places, radius), signed(&mut dice, distance))
}

/// Right-angled corners replaced by quarter circles.
fn rounded(places: &[Point2], radius: f64) -> Polyarc {
    let count = places.len();
    let mut vertices = Vec::new();
    for k in 0..count {
        let (before, at, after) =
            (places[(k + count - 1) % count], places[k], places[(k + 1) % count]);
        let u = (at - before).normalized().unwrap_or_default();
        let v = (after - at).normalized().unwrap_or_default();
        let turn = u.cross(v);
        if turn.abs() < 0.5 {
            vertices.push(Vertex { at, bulge: 0.0 });
            continue;
        }
        let bulge = (std::f64::consts::PI / 8.0).tan() * turn.signum();
        vertices.push(Vertex { at: at - u * radius, bulge });
        vertices.push(Vertex { at: at + v * radius, bulge: 0.0 });
    }
    Polyarc::closed(vertices).tidied()
}

/// A round shape with waves, as splines come out of drawing programs.
pub fn smooth(seed: u64, count: usize) -> Case {
    let mut dice = Dice::new(seed);
    let waves: Vec<(f64, f64, f64)> = (0..5)
        .map(|_| (dice.whole(2, 14) as f64, dice.between(0.0, 0.12), dice.between(0.0, 6.3)))
        .collect();
    let radius =
        |t: f64| 50.0 * (1.0 + waves.iter().map(|w| w.1 * (w.0 * t + w.2).cos()).sum::<f64>());
    let distance = dice.between(0.3, 12.0);
    (round(count, radius), signed(&mut dice, distance))
}

/// A circle with every vertex off by up to half a millimetre.
pub fn noisy(seed: u64, count: usize) -> Case {
    let mut dice = Dice::new(seed);
    let size = count as f64 * 0.02;
    let places: Vec<f64> = (0..count).map(|_| size + dice.between(-0.5, 0.5)).collect();
    let distance = dice.between(0.2, 3.0);
    let step = count as f64 / std::f64::consts::TAU;
    let radius = |t: f64| places[((t * step).round() as usize) % count];
    (round(count, radius), signed(&mut dice, distance))
}

pub fn round(count: usize, radius: impl Fn(f64) -> f64) -> Polyarc {
    let angle = |k: usize| k as f64 * std::f64::consts::TAU / count as f64;
    let place = |k: usize| Point2::default() + Vec2::from_angle(angle(k)) * radius(angle(k));
    Polyarc::lines((0..count).map(place), true)
}

/// Lines and arcs of all kinds round a middle; arcs small enough not to cross their neighbours.
pub fn polyarc(seed: u64) -> Case {
    let mut dice = Dice::new(seed);
    let count = dice.whole(5, 60) as usize;
    let mut shape = round(count, |_| 0.0);
    for (k, v) in shape.vertices.iter_mut().enumerate() {
        let turn = (k as f64 + dice.between(-0.2, 0.2)) * std::f64::consts::TAU / count as f64;
        v.at = Point2::default() + Vec2::from_angle(turn) * dice.between(20.0, 40.0);
        v.bulge = if dice.share() < 0.4 { 0.0 } else { dice.between(-0.3, 0.3) };
    }
    while !shape.self_crossings().is_empty() {
        shape.vertices.iter_mut().for_each(|v| v.bulge *= 0.6);
    }
    let distance = dice.between(0.1, 6.0);
    (shape, signed(&mut dice, distance))
}

/// A comb whose slots are exactly, or all but exactly, as wide as the cutter.
pub fn comb(seed: u64) -> Case {
    let mut dice = Dice::new(seed);
    let distance = dice.one_of(&[0.5, 1.0, 1.5, 3.0]);
    let mut places = Vec::new();
    let mut x = 0.0;
    for _ in 0..dice.whole(2, 12) {
        let depth = -dice.between(5.0, 20.0);
        let near = dice.one_of(&[0.0, 0.0, 0.0, 1e-10, -1e-10, 1e-8, -1e-8, 1e-6, -1e-6, 1e-3]);
        let lean = dice.one_of(&[0.0, 0.0, 1e-7, -1e-6, 1e-3]);
        places.push(Point2::new(x, 0.0));
        places.push(Point2::new(x + lean, depth));
        x += 2.0 * distance + near;
        places.push(Point2::new(x + lean, depth));
        places.push(Point2::new(x, 0.0));
        x += 2.0 * distance + dice.one_of(&[0.0, 0.0, 1e-9, -1e-7, 2.5]);
    }
    places.push(Point2::new(x, 5.0));
    places.push(Point2::new(x + 5.0, 5.0));
    places.push(Point2::new(x + 5.0, -30.0));
    places.push(Point2::new(-5.0, -30.0));
    places.push(Point2::new(-5.0, 5.0));
    places.push(Point2::new(0.0, 5.0));
    (Polyarc::lines(places, true), signed(&mut dice, distance))
}

/// A star with cracks and needles, as a logo drawn twice has them: some wider than what can be told apart,
/// some narrower than what is checked.
pub fn cracks(seed: u64) -> Case {
    let mut dice = Dice::new(seed);
    let count = dice.whole(5, 30) as usize;
    let step = std::f64::consts::TAU / count as f64;
    let place = |dice: &mut Dice, k: usize| {
        let turn = (k as f64 + dice.between(-0.2, 0.2)) * step;
        Point2::default() + Vec2::from_angle(turn) * dice.between(20.0, 40.0)
    };
    let corners: Vec<Point2> = (0..count).map(|k| place(&mut dice, k)).collect();
    let mut places = Vec::new();
    for k in 0..count {
        places.push(corners[k]);
        if dice.share() < 0.3 {
            let edge = corners[(k + 1) % count] - corners[k];
            let width = 10f64.powf(dice.between(-6.5, -1.5));
            let mouth = corners[k] + edge * dice.between(0.2, 0.8);
            let tip = Point2::default() + (mouth - Point2::default()) * dice.between(0.3, 1.4);
            let across = edge * (width / edge.length());
            places.push(mouth);
            places.push(tip + across * dice.between(0.0, 0.9));
            places.push(mouth + across);
        }
    }
    let distance = dice.one_of(&[0.1, 0.5, 1.0, 3.0]);
    (Polyarc::lines(places, true), signed(&mut dice, distance))
}

/// A row of half circles, their ends tangent to their neighbours but for a few hundredths of a micrometre.
pub fn half_circles() -> Polyarc {
    let vertices = [
        (0.0, -4.693692801761129e-10, -0.9999978703082116),
        (7.999998817561451, -1.9862415488713198e-8, 0.0),
        (10.000012474950232, 4.544012039229742e-6, -0.9999884341781161),
        (22.00001238378335, -4.987893009887867e-8, 0.0),
        (24.00002238669153, 0.0, 0.9999249822540573),
        (26.00002238672019, 1.0595553506701436e-10, -1.0),
        (30.00002238431726, -2.8100488923811173e-10, -1.0),
        (42.00002662292809, 0.0, 1.0),
        (46.00003263815931, 0.0, 0.0),
        (46.00003263815931, 40.0, 0.0),
        (0.0, 40.0, 0.0),
    ];
    Polyarc::closed(vertices.map(|(x, y, bulge)| Vertex::new(x, y, bulge)).to_vec())
}

/// The same by dice: half circles up and down on a line that they are tangent to but for 1e-11 to 1e-4 mm.
pub fn cusps(seed: u64) -> Case {
    let mut dice = Dice::new(seed);
    let (mut x, mut vertices) = (0.0, Vec::new());
    for _ in 0..dice.whole(2, 9) {
        if dice.share() < 0.4 {
            vertices.push(Vertex::new(x, tiny(&mut dice), 0.0));
            x += dice.whole(1, 3) as f64 * 2.0 + tiny(&mut dice);
        }
        let bulge = dice.one_of(&[1.0, -1.0]) * (1.0 - tiny(&mut dice).abs());
        vertices.push(Vertex::new(x, tiny(&mut dice), bulge));
        x += dice.one_of(&[2.0, 4.0, 8.0, 12.0]) + tiny(&mut dice);
    }
    let corners = [(x, tiny(&mut dice)), (x, 40.0), (0.0, 40.0)];
    vertices.extend(corners.map(|(x, y)| Vertex::new(x, y, 0.0)));
    let distance = dice.one_of(&[0.5, 1.0, 2.0, 3.0]);
    (Polyarc::closed(vertices), signed(&mut dice, distance))
}

/// Nothing, or a length of 1e-11 to 1e-4 mm to either side.
fn tiny(dice: &mut Dice) -> f64 {
    let size = 10f64.powf(dice.between(-11.0, -4.0));
    if dice.share() < 0.4 { 0.0 } else { signed(dice, size) }
}

/// Fifty teeth: rise, tip arc, fall, root arc.
pub fn gear() -> Polyarc {
    let teeth = 50;
    let step = std::f64::consts::TAU / f64::from(teeth * 4);
    let at = |radius: f64, turn: f64| Point2::default() + Vec2::from_angle(turn * step) * radius;
    let bulge = (step * 0.25).tan();
    let tooth = |k: i32| {
        let t = f64::from(k * 4);
        let v = |radius, turn, bulge| Vertex { at: at(radius, turn), bulge };
        [v(90.0, t, 0.0), v(100.0, t + 1.0, bulge), v(100.0, t + 2.0, 0.0), v(90.0, t + 3.0, bulge)]
    };
    Polyarc::closed((0..teeth).flat_map(tooth).collect())
}

/// Ten thousand places on seven lobes.
pub fn smooth_10_000() -> Polyarc {
    round(10_000, |t| 100.0 * (1.0 + 0.15 * (7.0 * t).cos() + 0.04 * (23.0 * t + 1.0).sin()))
}

/// A circle with ten thousand vertices, every one off by up to half a millimetre.
pub fn noisy_10_000() -> Polyarc {
    let mut dice = Dice::new(7);
    let radii: Vec<f64> = (0..10_000).map(|_| 100.0 + dice.between(-0.5, 0.5)).collect();
    round(10_000, |t| radii[((t * 10_000.0 / std::f64::consts::TAU).round() as usize) % 10_000])
}
