//! A watched input changed.

use super::{Core, Watch};
use kerf_program::Axes;

/// Takes the machine's position over and queues the handler's action; the handler is disarmed.
pub(super) fn arrive(core: &mut Core, watch: &Watch, position: Axes) {
    core.position = position;
    core.settled = true;
    // Moves that were still in the tab filter lie behind the interruption and are dropped.
    if let Some(tabs) = core.tabs.as_mut() {
        tabs.drop_buffered();
    }
    if let Some(index) = core.watches.iter().position(|h| h.watch == *watch) {
        let handler = core.watches.remove(index);
        core.fired.push(handler.at);
    }
}
