//! The command table: one entry a command, with its effect.
//!
//! Each file of this folder holds the commands of one group: their entries, the functions that
//! carry them out and their tests. Adding a command is adding one entry and one function.

mod cuts;
mod elsewhere;
mod files;
mod moves;
mod setting;
mod settings;
mod spec;
mod utilities;
mod values;
mod zero;

pub use setting::Setting;
pub use spec::{Bound, CommandSpec, Default, Effect, Group, Kind, ParamSpec, Stack, Unit};
pub use utilities::settings_lines;

/// Every command, group by group.
pub fn commands() -> impl Iterator<Item = &'static CommandSpec> {
    let lists = [cuts::SPECS, files::SPECS, &moves::SPECS, &zero::SPECS];
    let more = [&utilities::SPECS[..], &elsewhere::SPECS];
    let singles = [&moves::OTHERS[..], &settings::SPECS, &values::SPECS];
    lists.into_iter().chain(more).flatten().chain(singles.into_iter().flatten().copied())
}

/// The command of two letters, in any case.
pub fn find(letters: &str) -> Option<&'static CommandSpec> {
    commands().find(|c| c.letters.eq_ignore_ascii_case(letters))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_are_unique_and_parameters_documented() {
        let mut seen = std::collections::BTreeSet::new();
        for c in commands() {
            assert!(seen.insert(c.letters), "{} twice", c.letters);
            assert!(!c.doc.is_empty() && !c.name.is_empty(), "{}", c.letters);
            for p in c.params {
                assert!(!p.name.is_empty(), "{} {}", c.letters, p.name);
            }
        }
    }
}
