//! A tool that is touched off by the controller itself.

/// The touch-off that a controller makes by itself while it waits for a tool.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum TouchOff {
    /// The tool has to be touched off before the controller goes on.
    #[default]
    Wanted,
    /// The tool is on its way to the plate.
    Going,
    /// The tool is touched off.
    Done {
        /// No tool was touched off before: the next ones are measured against this one.
        is_reference: bool,
    },
    /// The tool is not touched off, for a reason.
    Failed(String),
}
