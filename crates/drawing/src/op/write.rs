//! Operations in the words that [`super::script`] reads.

use super::{Change, How, Operation, Picking, Sequencing};
use crate::{ArrayLevel, Choice, CutDepth, Level, Search};
use kerf_geom::{Point2, Vec2, Vertex};
use kerf_program::job::Plunge;
use std::fmt::{Display, Formatter, Result, Write};

impl Display for Operation {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Select { choice, how } => select(f, choice, *how),
            Self::Move { by } => write!(f, "move {}", V(*by)),
            Self::Copy { by } => write!(f, "copy {}", V(*by)),
            Self::Rotate { angle_deg, about: at } => about(f, "rotate", angle_deg, *at),
            Self::Scale { factor, about: at } => about(f, "scale", factor, *at),
            Self::Mirror { a, b, raw } => spaced(f, "mirror", [P(*a), P(*b)], flag(*raw, " raw")),
            Self::Erase => f.write_str("erase"),
            Self::Fillet { radius_mm, at } => near(f, "fillet", *radius_mm, *at),
            Self::Chamfer { length_mm, at } => near(f, "chamfer", *length_mm, *at),
            Self::Offset { distance_mm, keep } => {
                write!(f, "offset {distance_mm}{}", flag(*keep, " keep"))
            }
            Self::Join { distance_mm, merge } => {
                spaced(f, "join", distance_mm, if *merge { " merge" } else { " keep" })
            }
            Self::Break { shape, at } => write!(f, "break {shape} {}", P(*at)),
            Self::Trim { at } => write!(f, "trim {}", P(*at)),
            Self::ArrayRect { rows, columns, gap } => {
                write!(f, "array rect {rows}x{columns} spacing {}", V(*gap))
            }
            Self::ArrayRound { count, centre } => about(f, "array round", count, *centre),
            Self::Bulge { shape, at, bulge } => write!(f, "bulge {shape} {} {bulge}", P(*at)),
            Self::Radius { shape, at, radius_mm: r } => write!(f, "radius {shape} {} {r}", P(*at)),
            Self::Vertex { shape, at, to } => write!(f, "vertex {shape} {} {}", P(*at), P(*to)),
            Self::Stretch { a, b, by } => write!(f, "stretch {} {} by {}", P(*a), P(*b), V(*by)),
            Self::StretchAt { at, by } => {
                spaced(f, "stretch at", at.iter().map(|at| P(*at)), &format!(" by {}", V(*by)))
            }
            Self::DeleteVertices { shape, at } => {
                spaced(f, &format!("delete-vertices {shape}"), at.iter().map(|at| P(*at)), "")
            }
            Self::Circle { centre, radius_mm } => write!(f, "circle {} {radius_mm}", P(*centre)),
            Self::Rectangle { a, b } => write!(f, "rect {} {}", P(*a), P(*b)),
            Self::Point { at } => write!(f, "point {}", P(*at)),
            Self::Polyarc { vertices, closed } => line(f, vertices, *closed),
            Self::SpaceLine { places, closed } => {
                let places = places.iter().map(|[x, y, z]| format!("{x},{y},{z}"));
                spaced(f, "line3d", places, flag(*closed, " close"))
            }
            Self::Reverse => f.write_str("reverse"),
            Self::Directions => f.write_str("directions auto"),
            Self::Start { shape, at } => write!(f, "start {shape} {}", P(*at)),
            Self::Pause { on } => write!(f, "pause {}", on_off(*on)),
            Self::Group { group } => write!(f, "group {group}"),
            Self::CopyToGroup { group } => write!(f, "copy-to {group}"),
            Self::Set { group, changes } => spaced(f, &format!("set {group}"), changes, ""),
            Self::Pocket { clearing, pattern } => write!(f, "pocket {clearing}{pattern}"),
            Self::Engrave(clearing) => write!(f, "engrave {clearing}"),
            Self::Pick { picking } => write!(f, "pick {picking}"),
            Self::Sequence { order } => write!(f, "sequence {order}"),
            Self::Array { level, array } => levels(f, *level, array),
            Self::JustifyLeft => f.write_str("justify left"),
            Self::JustifySurface => f.write_str("justify surface"),
            Self::JustifyBottom { bottom_mm } => write!(f, "justify bottom {bottom_mm}"),
            Self::Rotate90 => f.write_str("rotate90"),
            Self::MirrorDrawing => f.write_str("mirror-drawing"),
            Self::Origin { at } => write!(f, "origin {}", P(*at)),
            Self::CadOrigin => f.write_str("origin cad"),
            Self::Clip => f.write_str("clip"),
            Self::LoadClipboard { file, .. } => write!(f, "load-clipboard {file}"),
            Self::ClearClipboard => f.write_str("clear-clipboard"),
            Self::Paste { at, absolute } => {
                write!(f, "paste {}{}", flag(*absolute, "absolute "), P(*at))
            }
            Self::Comment { lines } => write!(f, "comment {}", lines.join(" | ")),
        }
    }
}

/// Writes what is done by a value about a place.
fn about(f: &mut Formatter<'_>, word: &str, value: impl Display, at: Point2) -> Result {
    write!(f, "{word} {value} about {}", P(at))
}

/// A word where something is so.
const fn flag(is_so: bool, word: &str) -> &str {
    if is_so { word } else { "" }
}

/// Writes words with a blank before each, between a head and a tail.
fn spaced(
    f: &mut Formatter<'_>,
    head: &str,
    words: impl IntoIterator<Item = impl Display>,
    tail: &str,
) -> Result {
    f.write_str(head)?;
    words.into_iter().try_for_each(|word| write!(f, " {word}"))?;
    f.write_str(tail)
}

/// A place as `x,y`.
struct P(Point2);

impl Display for P {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{},{}", self.0.x, self.0.y)
    }
}

/// A displacement as `x,y`.
struct V(Vec2);

impl Display for V {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "{},{}", self.0.x, self.0.y)
    }
}

/// An operation with a length, on one corner or on all.
fn near(f: &mut Formatter<'_>, name: &str, length: f64, at: Option<Point2>) -> Result {
    write!(f, "{name} {length}")?;
    at.map_or(Ok(()), |at| write!(f, " at {}", P(at)))
}

fn on_off(on: bool) -> &'static str {
    if on { "on" } else { "off" }
}

fn list<T: Display>(f: &mut Formatter<'_>, items: &[T]) -> Result {
    for (n, item) in items.iter().enumerate() {
        if n > 0 {
            f.write_char(',')?;
        }
        write!(f, "{item}")?;
    }
    Ok(())
}

fn select(f: &mut Formatter<'_>, choice: &Choice, how: How) -> Result {
    f.write_str(match how {
        How::New => "select ",
        How::Add => "select add ",
        How::Remove => "select remove ",
    })?;
    match choice {
        Choice::All => f.write_str("all"),
        Choice::None => f.write_str("none"),
        Choice::Shapes(numbers) => list(f, numbers),
        Choice::Group(group) => write!(f, "group {group}"),
        Choice::Window(a, b) => write!(f, "window {} {}", P(*a), P(*b)),
        Choice::Crossing(a, b) => write!(f, "crossing {} {}", P(*a), P(*b)),
    }
}

fn line(f: &mut Formatter<'_>, vertices: &[Vertex], closed: bool) -> Result {
    f.write_str("line")?;
    for vertex in vertices {
        write!(f, " {}", P(vertex.at))?;
        if vertex.bulge != 0.0 {
            write!(f, ",{}", vertex.bulge)?;
        }
    }
    f.write_str(if closed { " close" } else { "" })
}

fn levels(f: &mut Formatter<'_>, level: Level, array: &ArrayLevel) -> Result {
    let level = match level {
        Level::Block => "block",
        Level::Job => "job",
    };
    let ArrayLevel { rows, columns, row_gap_mm, column_gap_mm, start, order } = array;
    write!(
        f,
        "array {level} {rows}x{columns} gap {column_gap_mm},{row_gap_mm} start {} order {}",
        start.name(),
        order.name()
    )
}

impl Display for Sequencing {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::Full(numbers) => list(f, numbers),
            Self::Groups(groups) => {
                f.write_str("groups ")?;
                list(f, groups)
            }
            Self::GroupsOf(numbers) => {
                f.write_str("groups of ")?;
                list(f, numbers)
            }
            Self::Picked => f.write_str("picked"),
            Self::Reverse => f.write_str("reverse"),
            Self::Auto(from) => write!(f, "auto {}", P(*from)),
            Self::Level(numbers) => {
                f.write_str("level ")?;
                list(f, numbers)
            }
            Self::Travel(search) => travel(f, search),
        }
    }
}

impl Display for Picking {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::None => f.write_str("none"),
            Self::Shapes(numbers) => list(f, numbers),
            Self::Groups(groups) => {
                f.write_str("groups ")?;
                list(f, groups)
            }
            Self::Remove(numbers) => {
                f.write_str("remove ")?;
                list(f, numbers)
            }
        }
    }
}

fn travel(f: &mut Formatter<'_>, search: &Search) -> Result {
    let Search { from, starts, rapids, tries } = search;
    write!(f, "travel from {}{}", P(*from), if *starts { " starts" } else { "" })?;
    write!(f, " speed={} accel={}", rapids.speed_mm_s, rapids.accel_mm_s2)?;
    write!(f, " lift={} tool-change={}", rapids.lift_s, rapids.tool_change_s)?;
    tries.map_or(Ok(()), |tries| write!(f, " tries={tries}"))
}

impl Display for Change {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Self::On(on) => write!(f, "on={}", on_off(*on)),
            Self::Traversal(on) => write!(f, "traversal={}", on_off(*on)),
            Self::Tool(tool) => write!(f, "tool={tool}"),
            Self::Cut(cut) => write!(f, "cut={cut}"),
            Self::Speed(Some(speed)) => write!(f, "speed={speed}"),
            Self::Speed(None) => f.write_str("speed=max"),
            Self::Height(CutDepth::Thru) => f.write_str("height=thru"),
            Self::Height(CutDepth::ThreeD) => f.write_str("height=3d"),
            Self::Height(CutDepth::Mm(depth)) => write!(f, "height={depth}"),
            Self::Pass(Some(pass)) => write!(f, "pass={pass}"),
            Self::Pass(None) => f.write_str("pass=off"),
            Self::Offset(offset) => write!(f, "offset={offset}"),
            Self::Rough(rough) => write!(f, "rough={rough}"),
            Self::DoubleLine(on) => write!(f, "double={}", on_off(*on)),
            Self::Tag(tag) => write!(f, "tag={tag}"),
            Self::LeadIn(lead) => write!(f, "lead-in={},{}", lead.radius_mm, lead.angle_deg),
            Self::LeadOut(lead) => write!(f, "lead-out={},{}", lead.radius_mm, lead.angle_deg),
            Self::Plunge(Plunge::Straight) => f.write_str("plunge=straight"),
            Self::Plunge(Plunge::Ramp { angle_deg }) => write!(f, "plunge=ramp,{angle_deg}"),
            Self::Plunge(Plunge::Helix { radius_mm, angle_deg }) => {
                write!(f, "plunge=helix,{radius_mm},{angle_deg}")
            }
            Self::Cutter(Some(cutter)) => write!(f, "cutter={cutter}"),
            Self::Cutter(None) => f.write_str("cutter=auto"),
        }
    }
}
