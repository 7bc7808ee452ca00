//! Settings of the family (`$$`) with their names, units and bounds. A board may have others, which have no name here.

/// A setting.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// Its number behind `$`.
    pub number: u16,
    /// Its name.
    pub name: &'static str,
    /// The unit of its value; empty where it has none.
    pub unit: &'static str,
    /// Least and greatest value.
    pub bounds: (f64, f64),
}

const fn row(
    number: u16,
    name: &'static str,
    unit: &'static str,
    least: f64,
    most: f64,
) -> Setting {
    Setting { number, name, unit, bounds: (least, most) }
}

/// Any number above zero.
const ANY: f64 = f64::INFINITY;

/// The settings of grbl 1.1, which grblHAL has, too, and of which FluidNC tells those of the axes.
pub const SETTINGS: &[Setting] = &[
    row(0, "step pulse", "µs", 1.0, 1000.0),
    row(1, "motors stay on after a move", "ms", 0.0, 65_535.0),
    row(2, "step pins inverted, a bit an axis", "", 0.0, 255.0),
    row(3, "direction pins inverted, a bit an axis", "", 0.0, 255.0),
    row(4, "enable pins inverted", "", 0.0, 255.0),
    row(5, "limit pins inverted", "", 0.0, 255.0),
    row(6, "probe pin inverted", "", 0.0, 1.0),
    row(10, "fields of a status report, a bit each", "", 0.0, 65_535.0),
    row(11, "junction deviation", "mm", 0.0, ANY),
    row(12, "arc tolerance", "mm", 0.0, ANY),
    row(13, "reports in inches", "", 0.0, 1.0),
    row(20, "soft limits", "", 0.0, 7.0),
    row(21, "hard limits", "", 0.0, 7.0),
    row(22, "homing", "", 0.0, 255.0),
    row(23, "home at the low end, a bit an axis", "", 0.0, 255.0),
    row(24, "homing, slow feed", "mm/min", 0.0, ANY),
    row(25, "homing, feed to the switch", "mm/min", 0.0, ANY),
    row(26, "homing, debounce", "ms", 0.0, 65_535.0),
    row(27, "homing, way off the switch", "mm", 0.0, ANY),
    row(30, "greatest spindle speed", "rpm", 0.0, ANY),
    row(31, "least spindle speed", "rpm", 0.0, ANY),
    row(32, "mode: router, laser, lathe", "", 0.0, 2.0),
    row(100, "X steps", "steps/mm", 0.0, ANY),
    row(101, "Y steps", "steps/mm", 0.0, ANY),
    row(102, "Z steps", "steps/mm", 0.0, ANY),
    row(103, "A steps", "steps/°", 0.0, ANY),
    row(104, "B steps", "steps/°", 0.0, ANY),
    row(105, "C steps", "steps/°", 0.0, ANY),
    row(110, "X greatest speed", "mm/min", 0.0, ANY),
    row(111, "Y greatest speed", "mm/min", 0.0, ANY),
    row(112, "Z greatest speed", "mm/min", 0.0, ANY),
    row(113, "A greatest speed", "°/min", 0.0, ANY),
    row(114, "B greatest speed", "°/min", 0.0, ANY),
    row(115, "C greatest speed", "°/min", 0.0, ANY),
    row(120, "X acceleration", "mm/s²", 0.0, ANY),
    row(121, "Y acceleration", "mm/s²", 0.0, ANY),
    row(122, "Z acceleration", "mm/s²", 0.0, ANY),
    row(123, "A acceleration", "°/s²", 0.0, ANY),
    row(124, "B acceleration", "°/s²", 0.0, ANY),
    row(125, "C acceleration", "°/s²", 0.0, ANY),
    row(130, "X travel", "mm", 0.0, ANY),
    row(131, "Y travel", "mm", 0.0, ANY),
    row(132, "Z travel", "mm", 0.0, ANY),
    row(133, "A travel", "°", 0.0, ANY),
    row(134, "B travel", "°", 0.0, ANY),
    row(135, "C travel", "°", 0.0, ANY),
];

/// Returns what is known of a setting.
pub fn setting(number: u16) -> Option<&'static Setting> {
    SETTINGS.iter().find(|setting| setting.number == number)
}

impl Setting {
    /// Tells why a value cannot be one of it, in words.
    pub fn refuses(&self, value: &str) -> Option<String> {
        let (least, most) = self.bounds;
        match value.parse::<f64>() {
            Ok(number) if number >= least && number <= most => None,
            Ok(_) if most.is_infinite() => Some(format!("${} is {least} or more", self.number)),
            Ok(_) => Some(format!("${} is from {least} to {most}", self.number)),
            Err(_) => Some(format!("${} is a number, and '{value}' is none", self.number)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_go_up_and_are_named_once() {
        assert!(SETTINGS.is_sorted_by(|a, b| a.number < b.number));
        assert!(SETTINGS.iter().all(|it| !it.name.is_empty() && it.bounds.0 <= it.bounds.1));
    }

    #[test]
    fn what_is_out_of_bounds_is_refused() {
        let check = |number, value: &str, why: Option<&str>| {
            let refused = setting(number).and_then(|it| it.refuses(value));
            assert_eq!(refused.as_deref(), why, "${number}={value}");
        };
        check(13, "1", None);
        check(13, "2", Some("$13 is from 0 to 1"));
        check(110, "-1", Some("$110 is 0 or more"));
        check(110, "fast", Some("$110 is a number, and 'fast' is none"));
    }
}
