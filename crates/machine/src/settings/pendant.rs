//! The keys of a pendant, wired to inputs (command reference, VD "Keypad remote").

use kerf_program::AXES;

/// Which input each key is; 0 where there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pendant {
    /// The keys of X, Y, Z, A, B, C: forwards and backwards.
    pub axes: [[u8; 2]; AXES],
    /// With it held, the others move as fast as jogs are.
    pub fast: u8,
    /// It closes the keypad.
    pub close: u8,
}

impl Default for Pendant {
    fn default() -> Self {
        Self { axes: [[5, 6], [7, 8], [9, 10], [0; 2], [0; 2], [0; 2]], fast: 11, close: 12 }
    }
}

impl Pendant {
    /// The inputs of all its keys.
    pub fn inputs(&self) -> impl Iterator<Item = u8> + '_ {
        let keys = self.axes.iter().flatten().chain([&self.fast, &self.close]);
        keys.copied().filter(|input| *input != 0)
    }

    /// Which way the keys lead that are pressed: -1, 0 or 1 an axis.
    pub fn way(&self, pressed: impl Fn(u8) -> bool) -> [f64; AXES] {
        let share = |input: u8| f64::from(u8::from(input != 0 && pressed(input)));
        self.axes.map(|[plus, minus]| share(plus) - share(minus))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_against_each_other_lead_nowhere() {
        let pendant = Pendant::default();
        let way = |pressed: &[u8]| pendant.way(|input| pressed.contains(&input));
        assert_eq!(way(&[5, 8]), [1.0, -1.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!(way(&[5, 6, 10]), [0.0, 0.0, -1.0, 0.0, 0.0, 0.0]);
        assert_eq!(way(&[0, 11, 12]), [0.0; AXES]);
    }
}
