//! Numbers with so many decimals: as text, and on a grid.

/// A number as programs hold it: at most so many decimals, no needless zeros, never an exponent.
///
/// ```
/// assert_eq!(kerf_program::decimal(2.50, 3), "2.5");
/// assert_eq!(kerf_program::decimal(-0.0001, 3), "0");
/// assert_eq!(kerf_program::decimal(10.0, 3), "10");
/// ```
pub fn decimal(value: f64, places: usize) -> String {
    let text = format!("{value:.places$}");
    let text =
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".into() } else { text.into() }
}

/// Rounds a number to so many decimals, halves away from zero; zero has no sign.
///
/// ```
/// assert_eq!(kerf_program::rounded(333.3 - 300.0, 6), 33.3);
/// assert_eq!(kerf_program::rounded(-2.5, 0), -3.0);
/// assert!(kerf_program::rounded(-0.0001, 3).is_sign_positive());
/// ```
pub fn rounded(value: f64, places: i32) -> f64 {
    let unit = 10.0_f64.powi(places);
    (value * unit).round() / unit + 0.0
}
