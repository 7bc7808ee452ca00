//! Drawings: shapes, groups, arrays, and every operation on them.
//!
//! ```text
//!  Operation ──► Editor::apply ──► Drawing     one value, whoever sends it: the command line,
//!      ▲              │                        a console, a test, undo and redo
//!      │              └──► Outcome, OpError    what was noticed, or why nothing was changed
//!  "rotate 30 about 0,0"
//! ```
//!
//! A [`Drawing`] holds [`Shape`]s in cutting order: polyarcs in millimetres, each in one of eight
//! [`Group`]s whose [`GroupSettings`] say how it is cut. [`Arrays`] repeat the whole. An
//! [`Operation`] changes a drawing or leaves it as it was; there is no half of one.
//!
//! Directions: X to the right, Y upwards, counter-clockwise is positive. Heights of a 3D shape are
//! measured from ZSurface. The operations are those of the Profiler reference (chapters Draw, Edit,
//! Layout, Clipboard, Path, Sequence), read as `docs/readings.md` says where it contradicts itself.

mod apply;
mod array;
mod drawing;
mod editor;
mod group;
mod nesting;
mod op;
mod selection;
mod settings;
mod shape;
mod space;
mod travel;

pub use array::{ArrayLevel, Arrays, Corner, GapError, Level, Order};
pub use drawing::{CommentError, Drawing, MAX_COMMENT_LENGTH, MAX_COMMENTS, bounds_of};
pub use editor::Editor;
pub use group::Group;
pub use nesting::{Nesting, crosses, inside_first};
pub use op::{
    Change, ClauseError, Clearing, ENTRIES, Entry, How, OpError, Operation, Outcome, Part, Pattern,
    Picking, Picks, Sequencing, Value, Variant, script, spot,
};
pub use selection::Choice;
pub use settings::{CutDepth, GroupSettings, Lead, SettingsError};
pub use shape::{Kind, Shape};
pub use space::{Heightened, heighten};
pub use travel::{EXACT_STOPS, Rapids, Search, Travelled, travelled};
