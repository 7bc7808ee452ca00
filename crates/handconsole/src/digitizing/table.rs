//! The digitizing functions (Profiler reference, table 27).

use super::asking::Losing;
use super::stand;
use crate::functions::{Done, Function, Step};
use crate::{ConsoleRequest, View};
use kerf_digitize::{Digitizer, Dimension, Leg, Refusal, Stand};
use kerf_geom::{Point2, Segment};
use kerf_machine::{Errand, Stretch};
use kerf_wire::Look;

/// A digitizing function.
#[derive(Debug)]
pub struct Entry {
    /// Its number.
    pub number: u32,
    /// Its name: with the number and a blank 20 characters at most.
    pub name: &'static str,
    /// Its effect, for the book.
    pub doc: &'static str,
    pub(super) does: Does,
}

/// Effect of a function.
#[derive(Debug)]
pub(super) enum Does {
    /// It changes the points.
    Edit(fn(&mut Digitizer, Stand) -> Result<(), Refusal>),
    /// It moves the tool to one of them.
    Go(fn(&Digitizer, &Stand) -> Result<Vec<Leg>, Refusal>),
    /// It makes a shape of them.
    Save { closed: bool },
    /// It loses them, after a confirmation.
    Loses(Losing),
    /// It changes what pages have in sight.
    Looks(Look),
    /// It shows where the tool is.
    Place,
    /// It moves the tool to a place that is typed, in 2D or in 3D.
    Moves { flat: &'static Function, in_space: &'static Function },
    /// It does what the function of this number does outside of digitizing.
    AsAtRest(&'static str),
}

const fn entry(number: u32, name: &'static str, doc: &'static str, does: Does) -> Entry {
    Entry { number, name, doc, does }
}

/// Every function, in the order of their numbers.
pub const FUNCTIONS: &[Entry] = &[
    entry(
        0,
        "Insert after",
        "adds a point behind the current one, which it becomes",
        Does::Edit(Digitizer::insert_after),
    ),
    entry(
        1,
        "Insert before",
        "adds a point before the current one, which it becomes",
        Does::Edit(Digitizer::insert_before),
    ),
    entry(
        2,
        "Delete point",
        "takes the current point out; the next one becomes current, or else the last",
        Does::Edit(|points, _| points.delete()),
    ),
    entry(
        3,
        "Modify point",
        "puts the current point where the tool is, with the kind that is chosen",
        Does::Edit(Digitizer::modify),
    ),
    entry(
        4,
        "Move to end",
        "follows the path from the current point to the last",
        Does::Go(|points, tool| Ok(points.way_to(tool, points.points().len()))),
    ),
    entry(
        5,
        "Move to start",
        "follows the path from the current point to the first",
        Does::Go(|points, tool| Ok(points.way_to(tool, 1))),
    ),
    entry(
        6,
        "Move to current",
        "goes straight to the current point",
        Does::Go(Digitizer::way_to_current),
    ),
    entry(
        7,
        "Move to nearest",
        "goes straight to the nearest point, which becomes current",
        Does::Go(Digitizer::way_to_nearest),
    ),
    entry(8, "Save open", "adds an open shape to the drawing or job", Does::Save { closed: false }),
    entry(
        9,
        "Save closed",
        "adds a closed shape to the drawing or job",
        Does::Save { closed: true },
    ),
    entry(
        10,
        "Load nearest",
        "replaces the points by those of the shape nearest to the tool",
        Does::Loses(Losing::Load),
    ),
    entry(
        11,
        "Dimension 2D",
        "shapes are saved without heights",
        Does::Edit(|points, _| points.set_dimension(Dimension::Two)),
    ),
    entry(
        12,
        "Dimension 3D",
        "shapes are saved with the height of each point; there are no arcs",
        Does::Edit(|points, _| points.set_dimension(Dimension::Three)),
    ),
    entry(
        15,
        "Clear all points",
        "forgets all points; shapes that were saved stay",
        Does::Loses(Losing::Clear),
    ),
    entry(
        20,
        "Move to",
        "goes to a place from the job origin",
        Does::Moves { flat: &TO, in_space: &TO_IN_SPACE },
    ),
    entry(
        21,
        "Move by",
        "goes so far from where the tool is",
        Does::Moves { flat: &BY, in_space: &BY_IN_SPACE },
    ),
    entry(30, "Draw shape", "shows the points on the screen", Does::Looks(Look::Digitized)),
    entry(31, "Data limits", "shows all shapes on the screen", Does::Looks(Look::Data)),
    entry(
        32,
        "Machine limits",
        "shows the machine's bounds and all shapes on the screen",
        Does::Looks(Look::Machine),
    ),
    entry(33, "Zoom out", "shows twice as much on the screen", Does::Looks(Look::Out)),
    entry(38, "Arrow speed %", "the speed of the digit keys", Does::AsAtRest("38")),
    entry(39, "Arrow accel %", "the acceleration of the digit keys", Does::AsAtRest("39")),
    entry(40, "Show position", "shows where the tool is until the next key", Does::Place),
    entry(99, "Exit", "ends digitizing", Does::Loses(Losing::Exit)),
];

const fn asks(prompt: &'static str, now: fn(&View) -> Option<f64>) -> Step {
    Step::Number { prompt, now }
}

const fn moves(
    name: &'static str,
    steps: &'static [Step],
    does: fn(&[f64], &View) -> Result<Done, String>,
) -> Function {
    Function { number: "", name, doc: "", steps, does }
}

const TO_STEPS: &[Step] = &[
    asks("Move to X mm:", |view| Some(stand(view).at.x)),
    asks("Move to Y mm:", |view| Some(stand(view).at.y)),
    asks("Move to Z mm:", |view| Some(stand(view).z_mm)),
];
const BY_STEPS: &[Step] = &[
    asks("Move by X mm:", |_| Some(0.0)),
    asks("Move by Y mm:", |_| Some(0.0)),
    asks("Move by Z mm:", |_| Some(0.0)),
];

static TO: Function = moves("Move to", TO_STEPS.split_at(2).0, to);
static TO_IN_SPACE: Function = moves("Move to", TO_STEPS, to);
static BY: Function = moves("Move by", BY_STEPS.split_at(2).0, by);
static BY_IN_SPACE: Function = moves("Move by", BY_STEPS, by);

fn to(typed: &[f64], view: &View) -> Result<Done, String> {
    Ok(straight(view, typed, Stand::default()))
}

fn by(typed: &[f64], view: &View) -> Result<Done, String> {
    Ok(straight(view, typed, stand(view)))
}

/// Straight to a place as it is seen from another; without a third number Z stays.
fn straight(view: &View, typed: &[f64], from: Stand) -> Done {
    let end = Point2::new(from.at.x + typed[0], from.at.y + typed[1]);
    let path = Segment::line(stand(view).at, end);
    let z_mm = typed.get(2).map(|z| from.z_mm + z);
    vec![ConsoleRequest::Go(Errand::Along([Stretch { path, z_mm }].into()))].into()
}
