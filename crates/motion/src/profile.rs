//! The speed profile of one move: a trapezoid in time, whose corners a model has chosen.
//!
//! ```text
//!  speed ▲        v_peak ___________
//!        │             ╱            ╲
//!        │   v_entry  ╱              ╲  v_exit
//!        │           │                │
//!        └───────────┴────────────────┴──► time
//!              start_s   rise  cruise  fall
//! ```

/// Start of a move and course of its speed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Profile {
    pub start_s: f64,
    pub v_entry: f64,
    pub v_peak: f64,
    pub v_exit: f64,
}

/// The three phases of a profile over a length, in seconds and mm.
pub(crate) struct Phases {
    entry: f64,
    peak: f64,
    accel: f64,
    rise_s: f64,
    cruise_s: f64,
    fall_s: f64,
    rise_mm: f64,
    cruise_mm: f64,
    length_mm: f64,
}

impl Profile {
    /// The phases over a reference length with an acceleration.
    pub fn phases(&self, length_mm: f64, accel: f64) -> Phases {
        let Self { v_entry, v_peak, v_exit, .. } = *self;
        let rise_s = (v_peak - v_entry) / accel;
        let fall_s = (v_peak - v_exit) / accel;
        let rise_mm = rise_s * 0.5 * (v_peak + v_entry);
        let fall_mm = fall_s * 0.5 * (v_peak + v_exit);
        // Rounding may leave a little less than nothing to cruise.
        let cruise_mm = (length_mm - rise_mm - fall_mm).max(0.0);
        let cruise_s = if cruise_mm > 0.0 { cruise_mm / v_peak } else { 0.0 };
        Phases {
            entry: v_entry,
            peak: v_peak,
            accel,
            rise_s,
            cruise_s,
            fall_s,
            rise_mm,
            cruise_mm,
            length_mm,
        }
    }
}

impl Phases {
    /// Time of the whole move, seconds.
    pub fn duration_s(&self) -> f64 {
        self.rise_s + self.cruise_s + self.fall_s
    }

    /// Ways on which speed rises, and stays.
    pub const fn ways_mm(&self) -> [f64; 2] {
        [self.rise_mm, self.cruise_mm]
    }

    /// Returns `true` if speed rises at a time since the start of the move.
    pub fn rises_at(&self, s: f64) -> bool {
        s < self.rise_s
    }

    /// Way made, speed and acceleration at a time since the start of the move.
    pub fn at(&self, s: f64) -> (f64, f64, f64) {
        let s = s.clamp(0.0, self.duration_s());
        if s < self.rise_s {
            let v = self.entry + self.accel * s;
            return (0.5 * (self.entry + v) * s, v, self.accel);
        }
        let s = s - self.rise_s;
        if s < self.cruise_s {
            return (self.rise_mm + self.peak * s, self.peak, 0.0);
        }
        let s = s - self.cruise_s;
        let v = self.peak - self.accel * s;
        let mm = self.rise_mm + self.cruise_mm + 0.5 * (self.peak + v) * s;
        (mm.min(self.length_mm), v, -self.accel)
    }

    /// Time since the start of the move at which a way has been made.
    pub fn time_at(&self, mm: f64) -> f64 {
        if mm <= 0.0 {
            return 0.0;
        }
        if mm >= self.length_mm {
            return self.duration_s();
        }
        if mm < self.rise_mm {
            let v = (self.entry * self.entry + 2.0 * self.accel * mm).sqrt();
            return 2.0 * mm / (self.entry + v);
        }
        let mm = mm - self.rise_mm;
        if mm < self.cruise_mm {
            return self.rise_s + mm / self.peak;
        }
        let mm = mm - self.cruise_mm;
        let v = (self.peak * self.peak - 2.0 * self.accel * mm).max(0.0).sqrt();
        let fall_s = if mm > 0.0 { 2.0 * mm / (self.peak + v) } else { 0.0 };
        self.rise_s + self.cruise_s + fall_s.min(self.fall_s)
    }
}
