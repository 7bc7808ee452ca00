//! Z that follows the sheet: the controller's side of automatic height control, tick by tick
//! (Profiler reference, "Automatic Height Control"; readings, Height control).

use kerf_motion::{Move, Path};
use kerf_program::{Axis, Gauge, HeightLaw, MoveKind};

/// Time from one look to the next, seconds.
pub const TICK_S: f64 = 0.001;

/// Without a reading for so long the sensor counts as lost, seconds (readings, P-84).
pub const SILENCE_S: f64 = 0.1;

/// Tells whether Z follows during a move: a cut whose Z is the plan's own, or a jog in the plane where the law is for
/// travel.
pub fn acts_in(law: &HeightLaw, made: &Move) -> bool {
    let wanted = if law.raised_mm.is_some() { MoveKind::Jog } else { MoveKind::Cut };
    made.kind == wanted && made.from[Axis::Z] == made.to[Axis::Z]
}

/// Tells whether a move goes along X or Y.
pub fn in_plane(made: &Move) -> bool {
    let moves = |axis: Axis| made.from[axis] != made.to[axis];
    matches!(made.path, Path::Arc { .. }) || moves(Axis::X) || moves(Axis::Y)
}

/// Tells whether readings are awaited during a move on which Z is the plan's own: the way down to the sheet.
pub fn listens_in(law: &HeightLaw, made: &Move) -> bool {
    matches!(law.gauge, Gauge::Proportional { .. }) && goes_down(law, made)
}

/// Tells whether a move is the way down to the sheet.
pub fn goes_down(law: &HeightLaw, made: &Move) -> bool {
    let cuts = law.raised_mm.is_none() && made.kind == MoveKind::Cut;
    cuts && made.to[Axis::Z] < made.from[Axis::Z]
}

/// Tells whether a reading says that the head is above the band it is to keep.
pub fn is_above_band(law: &HeightLaw, reading: f64) -> bool {
    let Gauge::Proportional { gain_mm, set_points, .. } = law.gauge else { return false };
    (reading - set_points[0]) * gain_mm.signum() >= 1.0
}

/// State that the head senses.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sensed {
    /// Distance of the sensor to the sheet, mm, when there is one: less what a way between paths is higher than a
    /// cut.
    pub gap_mm: Option<f64>,
    /// The sensor sends nothing.
    pub silent: bool,
    /// The inputs of simple control.
    pub high: bool,
    /// Too low.
    pub low: bool,
    /// Direction of travel.
    pub way: [f64; 2],
    /// Fast enough for height control to act.
    pub active: bool,
}

/// A reading of the sensor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Value of the reading, 0 … 255.
    pub value: u8,
    /// Difference of the gap from the one that is wanted, mm.
    pub error_mm: f64,
}

/// Distance that Z has been carried beside the plan, and its motion.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Follower {
    /// Distance from the plan, mm.
    pub offset_mm: f64,
    mm_s: f64,
    /// Distance from the plan to which it is to go, mm.
    target_mm: f64,
    /// Time of the next reading, seconds of machine time.
    reading_s: f64,
    /// For how long a reading has been missing, seconds.
    silent_s: f64,
}

impl Follower {
    /// Z that stands, carried by a distance, mm.
    pub fn standing(offset_mm: f64) -> Self {
        Self { offset_mm, target_mm: offset_mm, ..Self::default() }
    }

    /// One tick; `z_mm` is the planned height. Tells the reading that came.
    pub fn tick(
        &mut self,
        t_s: f64,
        z_mm: f64,
        law: &HeightLaw,
        sensed: &Sensed,
    ) -> Option<Reading> {
        let reading = self.read(t_s, law, sensed);
        let wanted_mm_s = match law.gauge {
            Gauge::Simple { .. } => simple(law, sensed),
            Gauge::Proportional { .. } => self.towards(law, TICK_S),
        };
        self.go(z_mm, law, wanted_mm_s, TICK_S);
        reading
    }

    /// Goes on for a time towards a speed, mm/s, no quicker than the law's acceleration allows; before its heights end it slows
    /// down, and stands there. `z_mm` is the planned height.
    pub fn go(&mut self, z_mm: f64, law: &HeightLaw, wanted_mm_s: f64, time_s: f64) {
        let change = law.accel_mm_s2 * time_s;
        let (low, high) = (law.floor_mm - z_mm, law.ceiling_mm - z_mm);
        let low = low.min(high);
        // From v to rest within a way s, a part of it still in this time: v·t + v²/2a = s.
        let most_mm_s = |way_mm: f64| {
            let (half, way_mm) = (0.5 * change, way_mm.max(0.0));
            (half * half + 2.0 * law.accel_mm_s2 * way_mm).sqrt() - half
        };
        let [down, up] = [self.offset_mm - low, high - self.offset_mm].map(most_mm_s);
        let wanted_mm_s = wanted_mm_s.max(-down).min(up);
        self.mm_s += (wanted_mm_s - self.mm_s).clamp(-change, change);
        let goes_mm = self.offset_mm + self.mm_s * time_s;
        self.offset_mm = goes_mm.min(high).max(low);
        if self.offset_mm != goes_mm {
            self.mm_s = 0.0;
        }
    }

    /// Z is to go to where a reading says, which was taken while it was carried by a distance, mm: `error` is the
    /// reading less the one that is wanted.
    pub fn aim(&mut self, law: &HeightLaw, offset_mm: f64, error: f64) {
        if let Gauge::Proportional { gain_mm, .. } = law.gauge {
            self.target_mm = offset_mm - error * gain_mm;
        }
    }

    /// Z is to go to where it is carried by a distance, mm.
    pub const fn aim_at(&mut self, offset_mm: f64) {
        self.target_mm = offset_mm;
    }

    /// Z stays where it is, as soon as it can stand.
    pub const fn stay(&mut self) {
        self.aim_at(self.offset_mm);
    }

    /// It stands.
    pub fn stands(&self) -> bool {
        self.mm_s == 0.0
    }

    /// One tick in which a reading is missing, or not.
    pub fn listen(&mut self, missing: bool) {
        self.silent_s = if missing { self.silent_s + TICK_S } else { 0.0 };
    }

    /// Tells whether readings have been missing for too long.
    pub fn is_lost(&self) -> bool {
        self.silent_s > SILENCE_S - 1e-9
    }

    /// Takes the reading that is due.
    fn read(&mut self, t_s: f64, law: &HeightLaw, sensed: &Sensed) -> Option<Reading> {
        let Gauge::Proportional { interval_s, .. } = law.gauge else {
            return None;
        };
        self.listen(sensed.silent && sensed.active);
        let here = !sensed.silent && t_s + 1e-9 >= self.reading_s;
        let gap_mm = sensed.gap_mm.filter(|_| here)?;
        // The line is never idle: a reading that was taken late does not put off the next.
        let late_s = t_s - self.reading_s;
        self.reading_s = interval_s + if late_s < interval_s { self.reading_s } else { t_s };
        let reading = law.reading(gap_mm).round().clamp(0.0, 255.0);
        let set_point = law.set_point(sensed.way[0], sensed.way[1]);
        let error = if sensed.active { reading - set_point } else { 0.0 };
        self.aim(law, self.offset_mm, error);
        let error_mm = gap_mm - law.gap_mm(set_point);
        Some(Reading { value: reading as u8, error_mm })
    }

    /// The speed that comes to rest at the target, and no further than that in a time, mm/s.
    pub fn towards(&self, law: &HeightLaw, time_s: f64) -> f64 {
        let way_mm = self.target_mm - self.offset_mm;
        let stopping = (2.0 * law.accel_mm_s2 * way_mm.abs()).sqrt();
        way_mm.signum() * stopping.min(law.speed_mm_s).min(way_mm.abs() / time_s)
    }
}

/// The inputs say which way.
const fn simple(law: &HeightLaw, sensed: &Sensed) -> f64 {
    match (sensed.active, sensed.high, sensed.low) {
        (true, true, false) => -law.speed_mm_s,
        (true, false, true) => law.speed_mm_s,
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> HeightLaw {
        let (set_points, gain_mm, scale_mm) = ([150.0; 2], 10.0 / 250.0, 0.038);
        HeightLaw {
            gauge: Gauge::Proportional { set_points, gain_mm, scale_mm, interval_s: 0.004 },
            speed_mm_s: 30.0,
            accel_mm_s2: 400.0,
            activation: 0.0,
            ceiling_mm: 0.0,
            floor_mm: -30.0,
            raised_mm: None,
        }
    }

    fn over(gap_mm: f64) -> Sensed {
        Sensed { gap_mm: Some(gap_mm), way: [1.0, 0.0], active: true, ..Sensed::default() }
    }

    #[test]
    fn pro_height_prop_k() {
        for (reading, steps) in [(160.0, -100.0), (140.0, 100.0), (150.0, 0.0)] {
            let mut z = Follower::default();
            let told = z.tick(0.0, -14.0, &law(), &over(reading * 0.038)).map(|it| it.value);
            assert_eq!(told, Some(reading as u8));
            assert!((z.target_mm * 250.0 - steps).abs() < 1e-9, "{reading}: {}", z.target_mm);
            // One reading, and nothing more of it: Z goes so far and stands.
            let deaf = Sensed { silent: true, ..over(0.0) };
            for ms in 1..200 {
                z.tick(f64::from(ms) * 1e-3, -14.0, &law(), &deaf);
            }
            assert!((z.offset_mm * 250.0 - steps).abs() < 0.01, "{reading}: {}", z.offset_mm);
        }
    }

    /// Returns the steps of Z from one millisecond to the next while an input is on and after, mm.
    fn ways(low: bool, on_ms: u32) -> Vec<f64> {
        let gauge = Gauge::Simple { high: 17, low: 20 };
        let (law, mut z) = (HeightLaw { gauge, ..law() }, Follower::default());
        let mut heights = vec![0.0];
        for ms in 0..on_ms + 200 {
            let on = ms < on_ms;
            let active = true;
            let sensed = Sensed { high: on && !low, low: on && low, active, ..Sensed::default() };
            z.tick(f64::from(ms) * 1e-3, -14.0, &law, &sensed);
            heights.push(z.offset_mm);
        }
        heights.windows(2).map(|pair| pair[1] - pair[0]).collect()
    }

    #[test]
    fn pro_height_maxacc() {
        let up = ways(true, 200);
        // 30 mm/s after 0.075 s, and from there to rest in 0.075 s and 1.125 mm.
        assert!((up[73] - 0.0296).abs() < 1e-9 && (up[74] - 0.030).abs() < 1e-9, "{up:?}");
        assert!(up.iter().all(|way| *way <= 0.030 + 1e-12));
        let stopping: f64 = up[200..].iter().sum();
        assert!((stopping - 1.125).abs() < 0.03, "{stopping} mm to rest");
        assert!(up[273] > 0.0 && up[275..].iter().all(|way| *way == 0.0));
        assert!(up.windows(2).all(|pair| (pair[1] - pair[0]).abs() <= 0.0004 + 1e-12), "400 mm/s²");
    }

    #[test]
    fn pro_height_simple_low() {
        let (up, down) = (ways(true, 100), ways(false, 100));
        assert!(up[0] > 0.0 && up[..100].iter().all(|way| *way > 0.0), "from the first tick");
        assert!(up[180..].iter().all(|way| *way == 0.0), "it stops");
        assert!(up.iter().zip(&down).all(|(up, down)| (up + down).abs() < 1e-12));
    }

    /// A sensor whose reading falls as the gap grows leads to the gap that belongs to its set point.
    #[test]
    fn an_inverted_sensor_is_followed_to_its_gap() {
        let Gauge::Proportional { set_points, gain_mm, scale_mm, interval_s } = law().gauge else {
            unreachable!()
        };
        for sign in [1.0, -1.0] {
            let gauge =
                Gauge::Proportional { set_points, gain_mm: sign * gain_mm, scale_mm, interval_s };
            let law = HeightLaw { gauge, ..law() };
            let wanted_mm = if sign > 0.0 { 150.0 * 0.038 } else { 105.0 * 0.038 };
            let (mut z, sheet_mm) = (Follower::default(), -20.0);
            let mut last = None;
            for ms in 0..2000 {
                let gap_mm = -14.0 + z.offset_mm - sheet_mm;
                last = z.tick(f64::from(ms) * 1e-3, -14.0, &law, &over(gap_mm)).or(last);
            }
            let gap_mm = -14.0 + z.offset_mm - sheet_mm;
            assert!((gap_mm - wanted_mm).abs() < 0.038, "{sign}: {gap_mm}, not {wanted_mm}");
            let last = last.expect("readings came");
            assert!(
                last.error_mm.abs() < 0.038 && last.value.abs_diff(150) <= 1,
                "{sign}: {last:?}"
            );
        }
    }

    #[test]
    fn readings_are_bytes() {
        let read = |gap_mm| Follower::default().tick(0.0, 0.0, &law(), &over(gap_mm));
        let value = |gap_mm| read(gap_mm).map(|it| it.value);
        assert_eq!([value(-1.0), value(5.7), value(20.0)], [Some(0), Some(150), Some(255)]);
    }
}
