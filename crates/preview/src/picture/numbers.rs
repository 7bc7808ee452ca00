//! Numbers as people read them.

use crate::scene::Unit;

/// A count with thin spaces between thousands: `1 234 567`.
pub fn count(n: u64) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, c) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push('\u{2009}');
        }
        out.push(c);
    }
    out
}

/// A duration as `h:mm:ss`, with tenths below ten seconds; a dash when it is not known.
pub fn duration(seconds: f64) -> String {
    if !(0.0..1.0e12).contains(&seconds) {
        return "–".into();
    }
    if seconds < 9.95 {
        return format!("0:00:0{seconds:.1}");
    }
    let s = seconds.round() as u64;
    format!("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60)
}

/// A length in the user's unit with so many decimals, without the unit's sign.
pub fn decimal(mm: f64, unit: Unit, decimals: usize) -> String {
    let value = mm / unit.mm;
    if !value.is_finite() {
        return "–".into();
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|b| matches!(b, b'0' | b'.')) => rest.into(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

/// The same without zeros at its end.
pub fn short(mm: f64, unit: Unit, decimals: usize) -> String {
    let text = decimal(mm, unit, decimals);
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

/// A small length rounded up to two digits: `0.12`.
pub fn at_most(mm: f64, unit: Unit) -> String {
    let value = (mm / unit.mm).max(1e-9);
    let decimals = (1.0 - value.log10().floor()).clamp(0.0, 12.0);
    let factor = 10f64.powf(decimals);
    short((value * factor).ceil() / factor * unit.mm, unit, decimals as usize)
}

/// A length along a path with its unit: `12 345 mm`, `486.02 in`.
pub fn path_length(mm: f64, unit: Unit) -> String {
    let value = mm / unit.mm;
    if !(0.0..1.0e15).contains(&value) {
        return "–".into();
    }
    if value >= 10_000.0 {
        return format!("{} {}", count(value.round() as u64), unit.symbol);
    }
    format!("{} {}", decimal(mm, unit, if unit.mm > 2.0 { 2 } else { 1 }), unit.symbol)
}

/// Decimals that a coordinate needs when the whole is `size` units large: mm with two, inches with
/// three, more where the whole is small.
pub fn coordinate_decimals(size: f64, unit: Unit) -> usize {
    let usual = if unit.mm > 2.0 { 3 } else { 2 };
    let finer = (-(size.max(1.0e-6) / 0.5).log10()).ceil().clamp(0.0, 4.0);
    usual + finer as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        assert_eq!(count(1_234_567), "1\u{2009}234\u{2009}567");
        assert_eq!(count(12), "12");
        assert_eq!(duration(4.24), "0:00:04.2");
        assert_eq!(duration(3725.4), "1:02:05");
        assert_eq!(duration(f64::NAN), "–");
        assert_eq!(duration(-1.0), "–");
        assert_eq!(decimal(-0.0001, Unit::MM, 2), "0.00");
        assert_eq!(decimal(-25.4, Unit::INCH, 3), "−1.000");
        assert_eq!(short(6.35, Unit::INCH, 3), "0.25");
        assert_eq!(path_length(12_345.4, Unit::MM), "12\u{2009}345 mm");
        assert_eq!(path_length(254.0, Unit::INCH), "10.00 in");
        assert_eq!(
            (at_most(0.11022, Unit::MM), at_most(25.4, Unit::INCH)),
            ("0.12".into(), "1".into())
        );
        assert_eq!(path_length(f64::INFINITY, Unit::MM), "–");
        assert_eq!(
            (coordinate_decimals(100.0, Unit::MM), coordinate_decimals(0.05, Unit::MM)),
            (2, 3)
        );
    }
}
