//! Acts that are done at once, and those that take a turn in the [pool](crate::pool).

use crate::pool::Lane;
use kerf_wire::Act;

/// Longest line that is read in a moment, bytes.
const LINE: usize = 4096;

/// Sorts acts by how long they take.
pub trait Lanes {
    /// In which lane it is done; nothing for what is done at once. This is the list of what is fast: what is not on
    /// it is not.
    fn lane(&self) -> Option<Lane>;
}

impl Lanes for Act {
    fn lane(&self) -> Option<Lane> {
        match self {
            // They look at the snapshot and change it, or tell the machine's thread something.
            Self::Stop
            | Self::Hold
            | Self::Disarm
            | Self::JogStop { .. }
            | Self::Ping
            | Self::GiveUp
            | Self::Resume { .. }
            | Self::Answer { .. }
            | Self::TakeLease { .. }
            | Self::GiveLease { .. }
            | Self::Arm { .. }
            | Self::JogStart { .. }
            | Self::JogRenew { .. }
            | Self::Lift { .. }
            | Self::Key { .. }
            | Self::Nudge { .. }
            | Self::Override { .. }
            | Self::Input { .. }
            | Self::SheetDone
            | Self::ClearPrinted
            | Self::Acknowledge
            | Self::Watch { .. } => None,
            Self::Command { line, .. } | Self::Record { line } if line.len() <= LINE => {
                Some(Lane::Short)
            }
            Self::Run { .. }
            | Self::Set { .. }
            | Self::Folder { .. }
            | Self::ControllerCard { .. } => Some(Lane::Short),
            _ => Some(Lane::Long),
        }
    }
}
