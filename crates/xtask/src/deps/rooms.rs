//! The levels of the house: one table, and the rules about arrows between its rows.

/// Which half of the house a crate belongs to. The halves share only the rooms under both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// Below both halves.
    Shared,
    /// Programs, motion, machines.
    Machine,
    /// Drawings and what is made from them.
    Drawing,
    /// Above both halves.
    Edge,
}

/// A crate's place in the house.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room {
    /// Package name.
    pub name: &'static str,
    /// Arrows point only to lower levels. Halves stand for a crate between two levels.
    pub level: f32,
    /// Its half of the house.
    pub half: Half,
}

/// From this level on crates may touch files, clocks, threads and terminals.
pub const OUTSIDE: f32 = 6.0;

const fn at(level: f32, half: Half, name: &'static str) -> Room {
    Room { name, level, half }
}

/// Every room that is or will be.
pub const ROOMS: &[Room] = &[
    at(0.0, Half::Shared, "kerf-geom"),
    at(0.0, Half::Shared, "kerf-diag"),
    at(1.0, Half::Shared, "kerf-program"),
    // Between `program` and `sbp`: the interpreter asks it for the moves of a Cut command.
    at(1.5, Half::Machine, "kerf-cut"),
    // It writes part files and reads none.
    at(1.5, Half::Machine, "kerf-tools"),
    at(2.0, Half::Machine, "kerf-sbp"),
    at(2.0, Half::Machine, "kerf-gcode"),
    // Both languages meet here, and only here.
    at(2.5, Half::Machine, "kerf-part"),
    // Between `geom` and `drawing`, as `cut` lies between `program` and `sbp`.
    at(1.5, Half::Drawing, "kerf-pocket"),
    at(2.0, Half::Drawing, "kerf-drawing"),
    at(2.5, Half::Drawing, "kerf-digitize"),
    at(2.5, Half::Drawing, "kerf-formats"),
    at(3.0, Half::Drawing, "kerf-toolpath"),
    // Below `motion`, which makes plans of what it finds.
    at(2.5, Half::Machine, "kerf-motion-optimal"),
    at(3.0, Half::Machine, "kerf-motion"),
    at(3.0, Half::Machine, "kerf-convert"),
    at(4.0, Half::Machine, "kerf-machine"),
    // Beside `part` in what it is, an interpreter; above the machine, whose table of states it goes by.
    at(4.5, Half::Machine, "kerf-sequence"),
    at(4.0, Half::Machine, "kerf-preview"),
    // What is believed of a machine; the simulated one stands above it, like every other.
    at(4.5, Half::Machine, "kerf-model"),
    at(5.0, Half::Machine, "kerf-sim"),
    // Bytes in and out; it knows nothing of who speaks.
    at(6.0, Half::Edge, "kerf-transport"),
    // Files that programs name, and where they may be.
    at(6.0, Half::Edge, "kerf-files"),
    // What a run tells; it knows nothing of runs.
    at(6.0, Half::Edge, "kerf-trace"),
    // What survives a run, and what a run is begun from.
    at(6.2, Half::Edge, "kerf-journal"),
    // Everything on disk that a program may reach; what it hears of it is on record.
    at(6.3, Half::Edge, "kerf-workspace"),
    // Files of other kinds, made ready for the machine; no run.
    at(6.4, Half::Edge, "kerf-import"),
    at(6.5, Half::Edge, "kerf-control"),
    at(7.0, Half::Edge, "kerf-wire"),
    // Between `wire` and whoever serves editors.
    at(7.5, Half::Edge, "kerf-language"),
    // It knows the messages and the machine, and has no thread and no clock.
    at(7.5, Half::Edge, "kerf-handconsole"),
    at(8.0, Half::Edge, "kerf-server"),
    at(8.0, Half::Edge, "kerf-lsp"),
    at(8.0, Half::Edge, "kerf-ledger"),
    at(8.0, Half::Edge, "kerf-bench"),
    at(8.0, Half::Edge, "xtask"),
    // The command line starts the server.
    at(9.0, Half::Edge, "kerf"),
];

const DRIVER: Room = at(5.0, Half::Machine, "kerf-driver-*");

/// The room of a package, or nothing when the table lacks it.
pub fn room(package: &str) -> Option<Room> {
    if package.starts_with("kerf-driver-") {
        return Some(DRIVER);
    }
    ROOMS.iter().copied().find(|r| r.name == package)
}

/// Checks that `from` may depend on `to`; the error tells which rule forbids it.
pub fn may_know(from: &Room, to: &Room) -> Result<(), &'static str> {
    if to.level >= from.level {
        return Err("arrows point only downwards");
    }
    if *from == DRIVER && to.name != "kerf-machine" {
        return Err("drivers see only kerf-machine and what it hands them");
    }
    let separate = |half| half == Half::Machine || half == Half::Drawing;
    if separate(from.half) && separate(to.half) && from.half != to.half {
        return Err("the drawing half and the machine half share only geom, diag and program");
    }
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn check(from: &str, to: &str, allowed: bool) {
        let answer = may_know(&room(from).unwrap(), &room(to).unwrap());
        assert_eq!(answer.is_ok(), allowed, "{from} -> {to}: {answer:?}");
    }

    #[test]
    fn arrows_point_downwards() {
        check("kerf-sbp", "kerf-cut", true);
        check("kerf-control", "kerf-sbp", true);
        check("kerf", "kerf-server", true);
        check("kerf-sbp", "kerf-motion", false);
        check("kerf-sbp", "kerf-gcode", false);
        check("kerf-sbp", "kerf-machine", false);
        check("kerf-geom", "kerf-diag", false);
    }

    #[test]
    fn the_halves_do_not_know_each_other() {
        check("kerf-toolpath", "kerf-drawing", true);
        check("kerf-toolpath", "kerf-program", true);
        check("kerf-toolpath", "kerf-sbp", false);
        check("kerf-machine", "kerf-toolpath", false);
        check("kerf-control", "kerf-toolpath", true);
    }

    #[test]
    fn drivers_see_only_the_machine() {
        check("kerf-driver-grbl", "kerf-machine", true);
        check("kerf-driver-grbl", "kerf-motion", false);
        check("kerf-driver-grbl", "kerf-program", false);
    }
}
