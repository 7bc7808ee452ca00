//! The levels of arrays of a drawing (Profiler reference, "Arrays").

use super::OpError;
use crate::{ArrayLevel, Editor, Level};

/// The most blocks that a level may have: more are no job that a shop cuts.
const MOST_BLOCKS: f64 = 1e6;

pub(super) fn set(draft: &mut Editor, level: Level, array: ArrayLevel) -> Result<(), OpError> {
    for (what, count) in
        [("the number of rows", array.rows), ("the number of columns", array.columns)]
    {
        if count == 0 {
            return Err(OpError::Bound { what, value: 0.0, bound: "1 or more" });
        }
    }
    let value = f64::from(array.rows) * f64::from(array.columns);
    if value > MOST_BLOCKS {
        let (what, bound) = ("the number of blocks", "a million at the most");
        return Err(OpError::Bound { what, value, bound });
    }
    *draft.drawing.arrays.level_mut(level) = array;
    if let Some(bounds) = draft.drawing.bounds() {
        draft.drawing.arrays.check(bounds.size())?;
    }
    Ok(())
}
