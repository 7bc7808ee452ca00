//! Distances by which height control carries Z beside the plan over one move.

/// The distance that Z is carried at each moment; evenly between two moments, constant before the first and after the last.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lift {
    /// The distance before, mm.
    before_mm: f64,
    /// Seconds of machine time, and mm; none where nothing carries it on.
    moments: Vec<(f64, f64)>,
}

impl Lift {
    /// A lift that stays at a distance, mm.
    pub const fn still(before_mm: f64) -> Self {
        Self { before_mm, moments: Vec::new() }
    }

    /// Adds a distance at a moment of machine time later than those before.
    pub fn carry(&mut self, t_s: f64, mm: f64) {
        self.moments.push((t_s, mm));
    }

    /// True where the distance does not change.
    pub fn is_still(&self) -> bool {
        self.moments.iter().all(|(_, mm)| *mm == self.before_mm)
    }

    /// The distance at a moment of machine time, mm.
    pub fn at(&self, t_s: f64) -> f64 {
        let behind = self.moments.partition_point(|(moment_s, _)| *moment_s <= t_s);
        let before = behind.checked_sub(1).and_then(|i| self.moments.get(i));
        match (before, self.moments.get(behind)) {
            (Some(&(from_s, from)), Some(&(to_s, to))) => {
                from + (to - from) * (t_s - from_s) / (to_s - from_s)
            }
            (Some(&(_, mm)), None) => mm,
            (None, _) => self.before_mm,
        }
    }

    /// The distances when the move begins and when it ends, mm.
    pub fn ends(&self) -> [f64; 2] {
        [self.before_mm, self.moments.last().map_or(self.before_mm, |(_, mm)| *mm)]
    }

    /// The moment of the last distance, seconds of machine time; nothing where nothing carries it on.
    pub fn ends_s(&self) -> Option<f64> {
        self.moments.last().map(|(t_s, _)| *t_s)
    }

    /// The least and the greatest distance, mm.
    pub fn range(&self) -> [f64; 2] {
        let all = || self.moments.iter().map(|(_, mm)| *mm);
        [all().fold(self.before_mm, f64::min), all().fold(self.before_mm, f64::max)]
    }

    /// Moments at which Z turns round or comes to rest, and how far it is carried there, mm.
    pub fn turns(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        let turns = self.moments.windows(3).filter(|three| {
            let [before, after] = [three[1].1 - three[0].1, three[2].1 - three[1].1];
            before != 0.0 && before * after <= 0.0
        });
        turns.map(|three| three[1])
    }
}

/// A reading that height control took on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Its moment, seconds of machine time.
    pub t_s: f64,
    /// Height of the tool, Z of the machine frame, mm.
    pub z_mm: f64,
    /// Difference of the gap from the one that is wanted, mm.
    pub error_mm: f64,
    /// Reading of the sensor, 0 … 255.
    pub value: u8,
}

/// Height control's share in a move that was made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LiftOfMove {
    /// The way of Z beside the plan.
    pub lift: Lift,
    /// The readings behind it, in order of time.
    pub readings: Vec<Reading>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_goes_evenly_from_moment_to_moment() {
        let mut lift = Lift::still(0.5);
        lift.carry(1.0, 0.5);
        for (t_s, mm) in [(2.0, 1.5), (3.0, 1.5), (4.0, -0.5), (5.0, 0.0)] {
            lift.carry(t_s, mm);
        }
        let asked = [0.0, 1.0, 1.25, 2.0, 2.7, 3.5, 5.0, 9.0].map(|t_s| lift.at(t_s));
        assert_eq!(asked, [0.5, 0.5, 0.75, 1.5, 1.5, 0.5, 0.0, 0.0]);
        assert_eq!((lift.ends(), lift.range()), ([0.5, 0.0], [-0.5, 1.5]));
        assert_eq!(lift.turns().collect::<Vec<_>>(), [(2.0, 1.5), (4.0, -0.5)]);
        assert!(!lift.is_still() && Lift::still(2.0).is_still());
        assert_eq!((Lift::still(2.0).at(7.0), Lift::default().ends()), (2.0, [0.0; 2]));
    }
}
