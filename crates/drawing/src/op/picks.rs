//! A new order that is being picked, shape by shape or group by group (Profiler reference, "Full
//! Manual Sequencing", "Group Manual Sequencing").

use super::sequence::{groups, without_shapes};
use super::words::{WordError, Words, numbers};
use super::{OpError, Picks};
use crate::{Editor, Group};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// A step of picking.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Picking {
    /// These shapes come next, by number.
    Shapes(Vec<usize>),
    /// These groups come next.
    Groups(Vec<Group>),
    /// These shapes are taken back, or the groups that they belong to.
    Remove(Vec<usize>),
    /// Everything is taken back.
    None,
}

/// Groups without shapes are told.
pub(super) fn pick(draft: &mut Editor, picking: &Picking) -> Result<Vec<String>, OpError> {
    let (mut picks, mut notes) = (draft.picks.clone(), Vec::new());
    match picking {
        Picking::None => picks = Picks::default(),
        Picking::Shapes(numbers) => {
            let places = places(draft, numbers)?;
            match &mut picks {
                Picks::Shapes(picked) => extend(picked, places),
                Picks::Groups(_) => picks = Picks::Shapes(places),
            }
        }
        Picking::Groups(groups) => {
            notes = without_shapes(&draft.drawing, groups);
            let mut picked = match picks {
                Picks::Groups(picked) => picked,
                Picks::Shapes(_) => Vec::new(),
            };
            extend(&mut picked, groups.clone());
            picks = Picks::Groups(picked);
        }
        Picking::Remove(numbers) => {
            let gone = places(draft, numbers)?;
            let group = |n: &usize| draft.drawing.shapes[*n].group;
            match &mut picks {
                Picks::Shapes(picked) => {
                    let gone: BTreeSet<usize> = gone.into_iter().collect();
                    let picked_now: BTreeSet<usize> = picked.iter().copied().collect();
                    if let Some(other) = gone.difference(&picked_now).next() {
                        return Err(OpError::NotPicked(other + 1));
                    }
                    picked.retain(|n| !gone.contains(n));
                }
                Picks::Groups(picked) => {
                    if let Some(other) = gone.iter().find(|n| !picked.contains(&group(n))) {
                        return Err(OpError::NotPicked(other + 1));
                    }
                    picked.retain(|it| !gone.iter().any(|n| group(n) == *it));
                }
            }
        }
    }
    draft.picks = picks;
    Ok(notes)
}

/// Adds what is not there yet.
fn extend<T: Ord + Copy>(picked: &mut Vec<T>, more: Vec<T>) {
    let mut there: BTreeSet<T> = picked.iter().copied().collect();
    picked.extend(more.into_iter().filter(|it| there.insert(*it)));
}

/// The places of shapes, each once.
fn places(draft: &Editor, numbers: &[usize]) -> Result<Vec<usize>, OpError> {
    let mut places = Vec::with_capacity(numbers.len());
    let all = numbers.iter().map(|number| draft.shape(*number).map(|(place, _)| place));
    extend(&mut places, all.collect::<Result<Vec<_>, _>>()?);
    Ok(places)
}

/// The words of `pick`.
pub(super) fn read(w: &mut Words) -> Result<Picking, WordError> {
    Ok(match () {
        () if w.takes("none") => Picking::None,
        () if w.takes("groups") => Picking::Groups(groups(w)?),
        () if w.takes("remove") => Picking::Remove(numbers(w)?),
        () => Picking::Shapes(numbers(w)?),
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::{Editor, script};

    /// Shapes at x = 1, 2, …; A and C are black, B and D red.
    const FOUR: &str = "point 1,0; point 2,0; point 3,0; point 4,0; select 2,4; group red";

    fn after(clauses: &str) -> Editor {
        let mut editor = Editor::default();
        for (_, operation) in script(&format!("{FOUR}; {clauses}")).unwrap() {
            editor.apply(&operation).unwrap();
        }
        editor
    }

    /// The labels of A, B, C, D: what comes first, second …
    fn labels(editor: &Editor) -> String {
        let picked = editor.picks.shapes(&editor.drawing);
        let label = |n| picked.iter().position(|it| *it == n).map_or(0, |at| at + 1);
        (0..editor.drawing.shapes.len()).map(|n| label(n).to_string()).collect()
    }

    fn order(editor: &Editor) -> String {
        editor.drawing.shapes.iter().map(|shape| shape.start().x.to_string()).collect()
    }

    #[test]
    fn pro_sequence_full_show() {
        let editor = after("pick 3; pick 1");
        assert_eq!(labels(&editor), "2010");
        assert_eq!(editor.picks.shapes(&editor.drawing), [2, 0], "C, A");
        // Nothing is ordered before the end is told; what was not picked follows in its old order.
        assert_eq!(order(&editor), "1234");
        assert_eq!(order(&after("pick 3; pick 1; sequence picked")), "3124");
        assert_eq!(order(&after("pick 3,1,2; pick remove 1; pick 1; sequence picked")), "3214");
        assert!(after("pick 3; sequence picked").picks.is_empty());
    }

    #[test]
    fn pro_sequence_group_show() {
        let editor = after("pick groups red; pick groups black; pick remove 2; pick groups red");
        // Black, red: A, C, then B, D.
        assert_eq!(labels(&editor), "1324");
        assert_eq!(order(&after("pick groups red; pick groups black; sequence picked")), "2413");
        let again =
            "pick groups red; pick groups black; pick remove 2; pick groups red; sequence picked";
        assert_eq!(order(&after(again)), "1324");
    }

    #[test]
    fn picks_end_when_the_drawing_changes() {
        assert!(after("pick 3; select 1; erase").picks.is_empty());
        assert_eq!(labels(&after("pick 3; select 1")), "0010");
        let mut editor = after("pick none");
        let error = editor.apply(&script("sequence picked").unwrap()[0].1).unwrap_err();
        assert_eq!(
            error.to_string(),
            "nothing was picked: choose shapes or groups with `pick` first"
        );
        editor.apply(&script("pick 2").unwrap()[0].1).unwrap();
        editor.undo().unwrap();
        assert!(editor.picks.is_empty());
    }
}
