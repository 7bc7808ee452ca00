//! Automatic height control (Profiler reference, "Automatic Height Control").

use super::words;

words! {
    /// Means by which the height is sensed.
    HeightMode {
        /// Two inputs, too high and too low.
        Simple = "simple",
        /// Readings 0 … 255 of a potentiometer.
        Proportional = "proportional",
    }
}

/// Settings of height control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightControl {
    /// Used for THRU shapes ("Do Height Control").
    pub on: bool,
    /// Means by which the height is sensed.
    pub mode: HeightMode,
    /// Highest speed of Z under height control, mm/s; at most that of the axis.
    pub speed_mm_s: f64,
    /// Highest acceleration of Z under height control, mm/s²; at most that of the axis.
    pub accel_mm_s2: f64,
    /// Acts above this share of the cutting speed, percent; 0 always.
    pub activation_percent: f64,
    /// Acts between THRU shapes too.
    pub between: bool,
    /// Reading wanted when cutting along X.
    pub x_set_point: u8,
    /// Reading wanted when cutting along Y.
    pub y_set_point: u8,
    /// Steps of the Z motor for one unit of the reading.
    pub k: f64,
    /// Millimetres for one unit of the reading.
    pub scale_mm: f64,
    /// Errors above this are drawn in another colour, mm.
    pub display_accuracy_mm: f64,
    /// A larger reading means a smaller gap.
    pub invert: bool,
    /// Serial port of the readings, 1 … 4.
    pub port: u8,
    /// Its speed, baud.
    pub baud: u32,
}

impl HeightControl {
    /// A first estimate of K for a Z axis: its steps for the millimetres of one unit. Half of it may follow
    /// more calmly ("HC Input (POT) scale").
    pub fn suggested_k(&self, steps_per_mm: f64) -> f64 {
        steps_per_mm.abs() * self.scale_mm
    }

    /// A difference of readings, mm.
    pub fn mm_of(&self, units: f64) -> f64 {
        units * self.scale_mm
    }

    /// Moves the set points of X and Y by a distance, mm. False where one was held at 0 or 255.
    pub fn adjust(&mut self, by_mm: [f64; 2]) -> bool {
        let mut free = true;
        for (point, by_mm) in [&mut self.x_set_point, &mut self.y_set_point].into_iter().zip(by_mm)
        {
            let wanted = (f64::from(*point) + by_mm / self.scale_mm).round();
            free &= (0.0..=255.0).contains(&wanted);
            *point = wanted.clamp(0.0, 255.0) as u8;
        }
        free
    }
}

impl Default for HeightControl {
    fn default() -> Self {
        Self {
            on: false,
            mode: HeightMode::Simple,
            speed_mm_s: 30.0,
            accel_mm_s2: 400.0,
            activation_percent: 0.0,
            between: false,
            x_set_point: 150,
            y_set_point: 150,
            k: 20.0,
            scale_mm: 0.038,
            display_accuracy_mm: 0.1,
            invert: false,
            port: 3,
            baud: 9600,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pro_height_prop_kform() {
        let with = |scale_mm| HeightControl { scale_mm, ..HeightControl::default() };
        assert!((with(0.04).suggested_k(250.0) - 10.0).abs() < 1e-9);
        assert!((with(0.038).suggested_k(250.0) - 9.5).abs() < 1e-9);
    }

    #[test]
    fn pro_height_prop_scale() {
        let mut height = HeightControl::default();
        assert!((height.mm_of(10.0) - 0.38).abs() < 1e-12);
        // Ten units up, and five down for Y alone.
        assert!(height.adjust([0.38, 0.38]) && height.adjust([0.0, -0.19]));
        assert_eq!((height.x_set_point, height.y_set_point), (160, 155));
        assert!(!height.adjust([9.0, 0.0]));
        assert_eq!((height.x_set_point, height.y_set_point), (255, 155));
    }
}
