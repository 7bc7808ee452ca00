//! The custom cuts that come with the program. A file of the same name in the folder of custom cuts
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
    ($($name:literal)*) => {
        /// Every file that comes with the program.
        pub const SHIPPED: &[Shipped] = &[
            $(Shipped { name: $name, text: include_str!(concat!("../../custom/", $name)) },)*
        ];
    };
}

shipped! {
    "Custom2.sbc" "Custom3.sbc" "Custom5.sbc" "Custom6.sbc" "Custom7.sbc" "Custom9.sbc"
    "Custom90.sbc" "Custom91.sbc" "my_variables.sbc"
}

impl Shipped {
    /// The shipped file of a name, in any case.
    pub fn find(name: &str) -> Option<&'static Self> {
        SHIPPED.iter().find(|s| s.name.eq_ignore_ascii_case(name.trim()))
    }
}
