//! The custom cuts and sample part files that come with the program. A custom cut of the same name in the folder of custom cuts
//! is used instead.

/// A file that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shipped {
    /// Its name.
    pub name: &'static str,
    /// Its text.
    pub text: &'static str,
}

macro_rules! shipped {
    ($(#[$doc:meta])* $list:ident in $folder:literal: $($name:literal)*) => {
        $(#[$doc])*
        pub const $list: &[Shipped] = &[
            $(Shipped { name: $name, text: include_str!(concat!("../", $folder, "/", $name)) },)*
        ];
    };
}

shipped! {
    /// Part files to begin with.
    SAMPLES in "samples":
    "S_box.sbp" "S_circles.sbp" "S_holes.sbp" "S_sign.sbp" "S_wave.sbp"
}

shipped! {
    /// Custom cuts.
    SHIPPED in "custom":
    "Custom2.sbc" "Custom3.sbc" "Custom5.sbc" "Custom6.sbc" "Custom7.sbc" "Custom9.sbc"
    "Custom90.sbc" "Custom91.sbc" "my_variables.sbc"
}

shipped! {
    /// Settings of machines: part files that set how they are wired.
    MACHINES in "machines":
    "desktop-24x18.sbd" "metric-2440x1220.sbd" "prs.sbd" "prt.sbd" "simulated-96x48.sbd"
}

impl Shipped {
    /// The custom cut of a name, in any case.
    pub fn find(name: &str) -> Option<&'static Self> {
        SHIPPED.iter().find(|s| s.name.eq_ignore_ascii_case(name.trim()))
    }
}
