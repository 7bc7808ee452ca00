//! Machines that come ready made.

use crate::Configuration;
use crate::file;
use kerf_diag::Diagnostic;
use std::sync::Arc;

/// A machine that comes with Kerf.
#[derive(Clone, Copy, Debug)]
pub struct Profile {
    /// Name.
    pub name: &'static str,
    /// Its file: what differs from the defaults.
    pub text: &'static str,
}

macro_rules! profile {
    ($name:literal) => {
        Profile { name: $name, text: include_str!(concat!("../profiles/", $name, ".toml")) }
    };
}

/// Every profile.
pub const PROFILES: &[Profile] = &[
    profile!("router-96x48"),
    profile!("sim"),
    profile!("laser-pwm"),
    profile!("plasma"),
    profile!("knife"),
    profile!("router-5-axis"),
];

/// The profile of a name.
pub fn profile(name: &str) -> Option<&'static Profile> {
    PROFILES.iter().find(|it| it.name.eq_ignore_ascii_case(name))
}

impl Profile {
    /// Returns the description in the comment at its head.
    pub fn about(&self) -> String {
        let lines = self.text.lines().map_while(|line| line.strip_prefix('#'));
        lines.map(str::trim).collect::<Vec<_>>().join(" ")
    }

    /// The machine.
    ///
    /// # Errors
    /// Never, as a test holds; what a file is refused for.
    pub fn configuration(&self) -> Result<Configuration, Vec<Diagnostic>> {
        file::read(&Arc::from(self.name), self.text)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn every_profile_is_a_machine_and_says_what_it_is() {
        for profile in PROFILES {
            let configuration = profile.configuration().unwrap();
            let written = file::write(&configuration);
            assert_eq!(file::read(&Arc::from("again"), &written).unwrap(), configuration);
            assert!(profile.about().ends_with('.'), "{}", profile.name);
        }
        assert!(profile("SIM").is_some() && profile("lathe").is_none());
    }

    #[test]
    fn pro_misc_tools() {
        let named = |name| profile(name).unwrap().configuration().unwrap();
        assert!(!named("router-96x48").laser.use_laser);
        assert!(named("laser-pwm").laser.use_laser && named("laser-pwm").intensity.output);
        assert!(named("plasma").plasma.use_sequence && named("plasma").height.on);
        assert!(named("knife").misc.tangential);
    }
}
