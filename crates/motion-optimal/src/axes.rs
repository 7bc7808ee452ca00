//! Values of so many axes.

/// The same with zeros for the axes that stood still.
pub(crate) fn padded<const N: usize, const M: usize>(v: &[f64; N]) -> [f64; M] {
    std::array::from_fn(|k| v.get(k).copied().unwrap_or(0.0))
}
