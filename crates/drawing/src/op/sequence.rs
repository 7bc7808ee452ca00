//! The order in which shapes are cut (Profiler reference, "Sequencing").

use super::words::{WordError, Words, number, numbers};
use super::{OpError, Outcome, path};
use crate::travel::{self, Search, travelled};
use crate::{Drawing, Editor, Group, Nesting, Picks, Shape};
use kerf_geom::Point2;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// A way to order shapes. What is not named keeps its old order, after what is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Sequencing {
    /// Shapes in this order, by number.
    Full(Vec<usize>),
    /// Groups in this order.
    Groups(Vec<Group>),
    /// The groups of these shapes in this order, by number.
    GroupsOf(Vec<usize>),
    /// Shapes or groups that were picked, in the order in which they were; then nothing is picked any more.
    Picked,
    /// The old order backwards.
    Reverse,
    /// Inner shapes first; side by side by the distance of starts from a place.
    Auto(Point2),
    /// Shapes that lie side by side within one shape, in this order; what lies in them goes along.
    Level(Vec<usize>),
    /// Inner shapes first; else with the least time between the cuts.
    Travel(Search),
}

pub(super) fn order(draft: &mut Editor, sequencing: &Sequencing) -> Result<Outcome, OpError> {
    let drawing = &draft.drawing;
    let mut notes = Vec::new();
    if let Sequencing::Groups(groups) = sequencing {
        notes.extend(without_shapes(drawing, groups));
    }
    let order = match sequencing {
        Sequencing::Travel(search) => by_travel(draft, search, &mut notes)?,
        Sequencing::Full(numbers) => named_first(draft, numbers)?,
        Sequencing::Groups(groups) => by_group(drawing, groups),
        Sequencing::GroupsOf(numbers) => by_group(drawing, &groups_of(draft, numbers)?),
        Sequencing::Picked => by_picks(draft)?,
        Sequencing::Reverse => (0..drawing.shapes.len()).rev().collect(),
        Sequencing::Auto(from) => by_distance(&drawing.shapes, *from),
        Sequencing::Level(numbers) => within_level(draft, numbers)?,
    };
    reorder(draft, &order);
    draft.drawing.ordered_by_hand = true;
    if *sequencing == Sequencing::Picked {
        draft.picks = Picks::default();
    }
    Ok(Outcome { warnings: outer_before_inner(&draft.drawing), notes })
}

/// The trip with the least time between the cuts, then what is not cut. It is told what it saves.
fn by_travel(
    draft: &mut Editor,
    search: &Search,
    notes: &mut Vec<String>,
) -> Result<Vec<usize>, OpError> {
    search.check()?;
    let before = travelled(&draft.drawing, search.from, &search.rapids);
    let trip = travel::trip(&draft.drawing, search);
    for (shape, start) in &trip.starts {
        path::start(draft, shape + 1, *start)?;
    }
    let order = named_first(draft, &trip.order.iter().map(|n| n + 1).collect::<Vec<_>>())?;
    let shapes = order.iter().map(|n| draft.drawing.shapes[*n].clone()).collect();
    let after = travelled(&draft.drawing.with_shapes(shapes), search.from, &search.rapids);
    notes.push(format!("travel {before}, now {after}"));
    Ok(order)
}

fn reorder(draft: &mut Editor, order: &[usize]) {
    let old = &draft.drawing.shapes;
    let shapes: Vec<Arc<Shape>> = order.iter().map(|n| old[*n].clone()).collect();
    let chosen = |(_, n): &(usize, &usize)| draft.selection.binary_search(n).is_ok();
    draft.selection = order.iter().enumerate().filter(chosen).map(|(new, _)| new).collect();
    draft.drawing.shapes = shapes;
}

fn named_first(draft: &Editor, numbers: &[usize]) -> Result<Vec<usize>, OpError> {
    let mut taken = vec![false; draft.drawing.shapes.len()];
    let mut order = Vec::with_capacity(taken.len());
    for number in numbers {
        let (place, _) = draft.shape(*number)?;
        if std::mem::replace(&mut taken[place], true) {
            return Err(OpError::NamedTwice(*number));
        }
        order.push(place);
    }
    order.extend((0..taken.len()).filter(|place| !taken[*place]));
    Ok(order)
}

fn by_picks(draft: &Editor) -> Result<Vec<usize>, OpError> {
    match &draft.picks {
        picks if picks.is_empty() => Err(OpError::NothingPicked),
        Picks::Shapes(places) => {
            named_first(draft, &places.iter().map(|n| n + 1).collect::<Vec<_>>())
        }
        Picks::Groups(groups) => Ok(by_group(&draft.drawing, groups)),
    }
}

fn by_group(drawing: &Drawing, groups: &[Group]) -> Vec<usize> {
    let rank = |n: &usize| {
        let group = drawing.shapes[*n].group;
        groups.iter().position(|g| *g == group).unwrap_or(groups.len())
    };
    let mut order: Vec<usize> = (0..drawing.shapes.len()).collect();
    order.sort_by_key(rank);
    order
}

/// The groups of shapes, in their order; a second shape of a group changes nothing.
fn groups_of(draft: &Editor, numbers: &[usize]) -> Result<Vec<Group>, OpError> {
    let group = |number: &usize| Ok(draft.drawing.shapes[draft.shape(*number)?.0].group);
    numbers.iter().map(group).collect()
}

/// Tells groups that are named but have no shapes.
pub(super) fn without_shapes(drawing: &Drawing, groups: &[Group]) -> Vec<String> {
    let empty = |group: &&Group| drawing.shapes.iter().all(|shape| shape.group != **group);
    groups.iter().filter(empty).map(|group| format!("group {group} has no shapes")).collect()
}

fn by_distance(shapes: &[Arc<Shape>], from: Point2) -> Vec<usize> {
    let far: Vec<f64> = shapes.iter().map(|shape| shape.start().distance(from)).collect();
    Nesting::of(shapes).inside_first(|level| level.sort_by(|a, b| far[*a].total_cmp(&far[*b])))
}

/// The places that the shapes of one level and all inside them have in the sequence are filled
/// again, with the shapes in the new order, each with what lies in it.
fn within_level(draft: &Editor, numbers: &[usize]) -> Result<Vec<usize>, OpError> {
    let shapes = &draft.drawing.shapes;
    let nesting = Nesting::of(shapes);
    let (mut level, mut named) = (Vec::new(), vec![false; shapes.len()]);
    for number in numbers {
        let (place, _) = draft.shape(*number)?;
        if std::mem::replace(&mut named[place], true) {
            return Err(OpError::NamedTwice(*number));
        }
        level.push(place);
    }
    let Some(parent) = level.first().map(|first| nesting.parent(*first)) else {
        return Ok((0..shapes.len()).collect());
    };
    if let Some(other) = level.iter().find(|n| nesting.parent(**n) != parent) {
        let why = format!("it does not lie in the same shape as shape {}", level[0] + 1);
        return Err(OpError::Shape { shape: other + 1, at: None, why });
    }
    level.extend(nesting.children(parent).filter(|n| !named[*n]));
    let tops: Vec<_> = (0..shapes.len()).map(|n| ancestor_in(&nesting, n, parent)).collect();
    let mut of_head = vec![Vec::new(); shapes.len()];
    tops.iter().enumerate().for_each(|(n, top)| {
        top.iter().for_each(|head| of_head[*head].push(n));
    });
    let mut filled = level.iter().flat_map(|head| of_head[*head].iter().copied());
    let refill = |n: usize| tops[n].and_then(|_| filled.next()).unwrap_or(n);
    Ok((0..shapes.len()).map(refill).collect())
}

/// The shape directly inside `parent` in which a shape lies, or which it is.
fn ancestor_in(nesting: &Nesting, shape: usize, parent: Option<usize>) -> Option<usize> {
    std::iter::successors(Some(shape), |n| nesting.parent(*n))
        .find(|n| nesting.parent(*n) == parent)
}

/// Warns of shapes that are cut before what lies in them: the part may come loose. Shapes of groups that are
/// off are not cut.
fn outer_before_inner(drawing: &Drawing) -> Vec<String> {
    let shapes = &drawing.shapes;
    let nesting = Nesting::of(shapes);
    let is_cut = |n: usize| {
        let settings = drawing.settings(shapes[n].group);
        settings.on && !settings.traversal
    };
    let outer = |n: usize| {
        let around = std::iter::successors(nesting.parent(n), |outer| nesting.parent(*outer));
        around.into_iter().find(|outer| is_cut(*outer))
    };
    let late = |n: usize| {
        let before = outer(n).filter(|outer| *outer < n && is_cut(n));
        before.map(|outer| (outer, n))
    };
    let warn = |(outer, inner): (usize, usize)| {
        format!("shape {} is cut before shape {}, which lies in it", outer + 1, inner + 1)
    };
    (0..shapes.len()).filter_map(late).map(warn).collect()
}

/// The words of `sequence`.
pub(super) fn read(w: &mut Words) -> Result<Sequencing, WordError> {
    Ok(match () {
        () if w.takes("reverse") => Sequencing::Reverse,
        () if w.takes("auto") => Sequencing::Auto(w.point("the place to begin near")?),
        () if w.takes("level") => Sequencing::Level(numbers(w)?),
        () if w.takes("travel") => Sequencing::Travel(search(w)?),
        () if w.takes("groups") => by_groups(w)?,
        () if w.takes("picked") => Sequencing::Picked,
        () => Sequencing::Full(numbers(w)?),
    })
}

/// `red,black`, or `of 4,1`.
fn by_groups(w: &mut Words) -> Result<Sequencing, WordError> {
    if w.takes("of") {
        Ok(Sequencing::GroupsOf(numbers(w)?))
    } else {
        Ok(Sequencing::Groups(groups(w)?))
    }
}

/// `red,black`.
pub(super) fn groups(w: &mut Words) -> Result<Vec<Group>, WordError> {
    w.read("the list of groups", "a list of groups such as red,black", |word| {
        word.split(',').map(Group::named).collect()
    })
}

fn search(w: &mut Words) -> Result<Search, WordError> {
    let mut search = Search::default();
    if w.takes("from") {
        search.from = w.point("where the head comes from")?;
    }
    search.starts = w.takes("starts");
    while w.peek().is_some() {
        search = w.read("a setting of the search", SEARCH, |word| search_word(search, word))?;
    }
    Ok(search)
}

const SEARCH: &str = "starts, speed=MM/S, accel=MM/S2, lift=S, tool-change=S or tries=N";

fn search_word(mut search: Search, word: &str) -> Option<Search> {
    let (key, value) = word.split_once('=')?;
    let rapids = &mut search.rapids;
    match key.to_ascii_lowercase().as_str() {
        "speed" => rapids.speed_mm_s = number(value)?,
        "accel" => rapids.accel_mm_s2 = number(value)?,
        "lift" => rapids.lift_s = number(value)?,
        "tool-change" => rapids.tool_change_s = number(value)?,
        "tries" => search.tries = Some(value.parse().ok()?),
        _ => return None,
    }
    Some(search)
}
