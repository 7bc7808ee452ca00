//! Z that follows the sheet: the controller's side of automatic height control, tick by tick
//! (Profiler reference, "Automatic Height Control"; ledger notes 3.12).

use kerf_program::{Gauge, HeightLaw};

/// Time from one look to the next, seconds.
pub(crate) const TICK_S: f64 = 0.001;

/// What the head senses.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sensed {
    /// Distance to the sheet, mm, when there is one.
    pub gap_mm: Option<f64>,
    /// The inputs of simple control.
    pub high: bool,
    /// Too low.
    pub low: bool,
    /// Direction of travel.
    pub way: [f64; 2],
    /// Fast enough for height control to act.
    pub active: bool,
}

/// How far Z has been carried beside the plan, and how it moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Follower {
    /// How far, mm.
    pub offset_mm: f64,
    mm_s: f64,
    /// Where it is to go.
    target_mm: f64,
    /// When the next reading comes, seconds of machine time.
    reading_s: f64,
}

impl Follower {
    /// One tick; `z_mm` is the planned height. Tells the error of a reading that came, mm.
    pub fn tick(&mut self, t_s: f64, z_mm: f64, law: &HeightLaw, sensed: &Sensed) -> Option<f64> {
        let error_mm = self.read(t_s, law, sensed);
        let wanted_mm_s = match law.gauge {
            Gauge::Simple { .. } => simple(law, sensed),
            Gauge::Proportional { .. } => self.towards(law),
        };
        let change = law.accel_mm_s2 * TICK_S;
        self.mm_s += (wanted_mm_s - self.mm_s).clamp(-change, change);
        let (low, high) = (law.floor_mm - z_mm, law.ceiling_mm - z_mm);
        self.offset_mm = (self.offset_mm + self.mm_s * TICK_S).min(high).max(low.min(high));
        error_mm
    }

    /// Takes the reading that is due.
    fn read(&mut self, t_s: f64, law: &HeightLaw, sensed: &Sensed) -> Option<f64> {
        let Gauge::Proportional { gain_mm, scale_mm, interval_s, .. } = law.gauge else {
            return None;
        };
        let gap_mm = sensed.gap_mm.filter(|_| t_s + 1e-9 >= self.reading_s)?;
        self.reading_s = t_s.max(self.reading_s + interval_s);
        let reading = (gap_mm / scale_mm).round().clamp(0.0, 255.0);
        let error = reading - law.set_point(sensed.way[0], sensed.way[1]);
        self.target_mm = self.offset_mm - if sensed.active { error * gain_mm } else { 0.0 };
        Some(gap_mm - law.set_point(sensed.way[0], sensed.way[1]) * scale_mm)
    }

    /// The speed that comes to rest at the target.
    fn towards(&self, law: &HeightLaw) -> f64 {
        let way_mm = self.target_mm - self.offset_mm;
        let stopping = (2.0 * law.accel_mm_s2 * way_mm.abs()).sqrt();
        // No further than the target in one tick.
        way_mm.signum() * stopping.min(law.speed_mm_s).min(way_mm.abs() / TICK_S)
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
