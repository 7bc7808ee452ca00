//! A setting that a controller keeps by number.

/// A setting as the controller told it last.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ToldSetting {
    /// Its number.
    pub number: u16,
    /// Its value, as the controller writes it.
    pub value: String,
    /// Its name; empty where nobody knows it.
    pub name: String,
    /// The unit of its value; empty where it has none.
    pub unit: String,
    /// Least and greatest value, where there are such.
    pub bounds: (Option<f64>, Option<f64>),
    /// A sentence that explains it; empty where nobody knows.
    pub does: &'static str,
    /// The same as the controller itself tells it; empty where it does not.
    pub own: String,
}
