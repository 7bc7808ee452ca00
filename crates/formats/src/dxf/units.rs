//! The unit of a drawing (header variable `$INSUNITS`).

/// Millimetres in the unit of a code of `$INSUNITS`, and its name; nothing for no unit and for codes
/// that no workshop uses.
pub fn unit(code: i64) -> Option<(f64, &'static str)> {
    Some(match code {
        1 => (25.4, "inches"),
        2 => (304.8, "feet"),
        4 => (1.0, "millimetres"),
        5 => (10.0, "centimetres"),
        6 => (1000.0, "metres"),
        8 => (25.4e-6, "microinches"),
        9 => (0.0254, "mils"),
        10 => (914.4, "yards"),
        13 => (1e-3, "micrometres"),
        14 => (100.0, "decimetres"),
        _ => return None,
    })
}
