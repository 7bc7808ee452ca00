//! The form in which numbers are shown.

/// The shortest decimal form with at most 7 significant digits, without an exponent below 1e15.
///
/// ```
/// assert_eq!(kerf_sbp::format_number(2.50), "2.5");
/// assert_eq!(kerf_sbp::format_number(1.0 / 3.0), "0.3333333");
/// assert_eq!(kerf_sbp::format_number(-0.0), "0");
/// ```
pub fn format_number(n: f64) -> String {
    if !n.is_finite() {
        return format!("{n}");
    }
    let magnitude = n.abs();
    if magnitude != 0.0 && !(1e-7..1e15).contains(&magnitude) {
        return format!("{n:.6e}");
    }
    let before = if magnitude < 1.0 { 0 } else { magnitude.log10().floor() as usize + 1 };
    // Zeros right after the point are not significant, so small numbers get more places.
    let leading = if magnitude > 0.0 && magnitude < 1.0 {
        (-magnitude.log10()).ceil() as usize - 1
    } else {
        0
    };
    let places = (7 + leading).saturating_sub(before);
    let fixed = if before > 7 {
        let unit = 10f64.powi(before as i32 - 7);
        format!(
            "{:.0}",
            if n.fract() == 0.0 && magnitude < 16_777_217.0 {
                n
            } else {
                (n / unit).round() * unit
            }
        )
    } else {
        format!("{n:.places$}")
    };
    let shown = if fixed.contains('.') {
        fixed.trim_end_matches('0').trim_end_matches('.')
    } else {
        &fixed
    };
    if shown.trim_start_matches('-').chars().all(|c| c == '0') {
        "0".into()
    } else {
        shown.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::format_number;

    #[test]
    fn seven_digits_and_no_more() {
        for (n, text) in [
            (100_000.0, "100000"),
            (9.55, "9.55"),
            (std::f64::consts::FRAC_PI_4, "0.7853982"),
            (0.001_234_567_89, "0.001234568"),
            (16_777_216.0, "16777216"),
            (1.000_001, "1.000001"),
            (-2.5, "-2.5"),
            (0.1 + 0.2, "0.3"),
            (999_999.96, "1000000"),
            (123_456_789.0, "123456800"),
        ] {
            assert_eq!(format_number(n), text);
        }
    }
}
