//! Axes that each kind of finding places.

/// The axes whose place a kind finds, by their letters.
pub fn axes(kind: &str, direction: &str) -> &'static str {
    match kind {
        "plate" => "Z",
        "outside-corner" => "XYZ",
        "inside-corner" | "bore" | "boss" => "XY",
        "edge" | "slot" if direction.starts_with('X') => "X",
        "edge" | "slot" => "Y",
        _ => "",
    }
}

/// Those of the axes found whose zero is set; nothing where another one is asked for.
pub fn chosen<'a>(finds: &'a str, asked: &'a str) -> Option<&'a str> {
    match asked {
        "all" => Some(finds),
        "none" => Some(""),
        _ => asked.chars().all(|axis| finds.contains(axis)).then_some(asked),
    }
}
