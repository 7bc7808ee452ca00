//! The command table: one entry a command, with its effect as data.
//!
//! Each file of this folder holds the entries of one group. Adding a command is adding an entry here and a function to
//! `run::commands`, which carries out each [`Act`].

pub mod act;
mod cuts;
mod elsewhere;
pub mod fabmo;
mod files;
mod moves;
mod recorder;
mod setting;
mod settings;
mod settings_files;
mod settings_lines;
mod spec;
pub(crate) mod tools;
mod utilities;
mod values;
mod zero;

pub use act::Act;
pub use setting::Setting;
pub use settings_lines::settings_lines;
pub use spec::{Bound, CommandSpec, Default, Group, Kind, ParamSpec, Stack, Unit};
pub(crate) use values::{is_turn, set_axis_unit};

/// Every command, group by group.
pub fn commands() -> impl Iterator<Item = &'static CommandSpec> {
    let lists = [cuts::SPECS, files::SPECS, &moves::SPECS, &zero::SPECS];
    let more = [&utilities::SPECS[..], &elsewhere::SPECS, &recorder::SPECS, &tools::SPECS];
    let files = settings_files::SPECS.iter();
    let singles = [&moves::OTHERS[..], &settings::SPECS, &values::SPECS];
    lists
        .into_iter()
        .chain(more)
        .flatten()
        .chain(files)
        .chain(singles.into_iter().flatten().copied())
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

    /// Every command that the reference or the handbooks name, and the extensions of real files.
    #[test]
    fn every_command_of_the_manuals_is_here() {
        let named = "CA CC CG CP CR FC FE FG FN FP FS HA HB HC HE HN HQ HR HT HU HW \
             J2 J3 J4 J5 JA JB JH JS JX JY JZ M2 M3 M4 M5 MA MB MD MH MI MN MO MS MX MY MZ \
             RA RI RP RR RS RZ SA SC SF SI SK SL SM SO SP SR ST SV SW TC TD TF TH TI TS TT TU \
             UD UI UL UN UR US UU UV UZ VA VB VC VD VH VI VL VN VO VP VR VS VU VV \
             Z2 Z3 Z4 Z5 ZA ZB ZT ZX ZY ZZ";
        let extensions = "JC J6 MC M6 TM TP TR Z6 ZC";
        assert_eq!(named.split_whitespace().count(), 107);
        let mut wanted: Vec<_> = named.split_whitespace().chain(extensions.split(' ')).collect();
        let mut found: Vec<_> = commands().map(|c| c.letters).collect();
        wanted.sort_unstable();
        found.sort_unstable();
        assert_eq!(found, wanted);
    }
}
