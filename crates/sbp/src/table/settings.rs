//! The commands of this group.

use super::CommandSpec;

pub(super) static SPECS: &[CommandSpec] = &[];
