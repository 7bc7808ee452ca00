//! The operations by name: how their words are read, and what is told of them.
//!
//! The help of `kerf draw`, the reference page and the reader of clauses are made from this table.

use super::clear;
use super::words::{WordError, Words, number, numbers, pair};
use super::{Change, How, Operation, form};
use crate::{ArrayLevel, Choice, Corner, CutDepth, Group, Lead, Level, Order};
use kerf_geom::{Point2, Vec2, Vertex};
use kerf_program::job::Plunge;

/// An operation as a person writes it.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its first word.
    pub name: &'static str,
    /// Its words; brackets hold what may be left out.
    pub form: &'static str,
    /// Description of what it does.
    pub doc: &'static str,
    pub(super) read: fn(&mut Words) -> Read,
}

pub(super) type Read = Result<Operation, WordError>;

#[track_caller]
const fn entry(
    name: &'static str,
    form: &'static str,
    doc: &'static str,
    read: fn(&mut Words) -> Read,
) -> Entry {
    form::check(form);
    Entry { name, form, doc, read }
}

/// Every operation, by chapter.
pub const ENTRIES: &[Entry] = &[
    entry(
        "select",
        "select [add|remove] all|none | select [add|remove] SHAPES | select [add|remove] group COLOUR | \
         select [add|remove] window X,Y X,Y | select [add|remove] crossing X,Y X,Y",
        "chooses the shapes that the next operations act on",
        select,
    ),
    entry(
        "move",
        "move X,Y | move from X,Y to X,Y",
        "moves the selected shapes by a distance, or from a base point to another",
        |w| Ok(Operation::Move { by: distance(w)? }),
    ),
    entry(
        "copy",
        "copy X,Y | copy from X,Y to X,Y",
        "adds moved copies of the selected shapes",
        |w| Ok(Operation::Copy { by: distance(w)? }),
    ),
    entry(
        "rotate",
        "rotate ANGLE [about X,Y] | rotate to ANGLE from X,Y X,Y",
        "turns the selected shapes counter-clockwise, about the origin if nothing else is said; `to` \
         turns them so that the line between two points gets the angle",
        rotate,
    ),
    entry(
        "scale",
        "scale FACTOR [about X,Y] | scale to LENGTH from X,Y X,Y",
        "makes the selected shapes larger; 25.4 turns inches into millimetres; `to` scales so that the \
         line between two points gets the length",
        scale,
    ),
    entry(
        "mirror",
        "mirror X,Y X,Y [raw]",
        "mirrors the selected shapes at a line; closed ones keep their cutting direction unless raw",
        |w| {
            let (a, b) = (w.point("a point of the line")?, w.point("a second point of the line")?);
            Ok(Operation::Mirror { a, b, raw: w.takes("raw") })
        },
    ),
    entry("erase", "erase", "removes the selected shapes", |_| Ok(Operation::Erase)),
    entry(
        "fillet",
        "fillet RADIUS [at X,Y]",
        "rounds the corners of the selected shapes, or the one nearest to a place",
        |w| Ok(Operation::Fillet { radius_mm: w.number("the radius")?, at: at(w)? }),
    ),
    entry(
        "chamfer",
        "chamfer LENGTH [at X,Y]",
        "cuts the corners of the selected shapes off, or the one nearest to a place",
        |w| Ok(Operation::Chamfer { length_mm: w.number("the length")?, at: at(w)? }),
    ),
    entry(
        "offset",
        "offset DISTANCE [keep]",
        "replaces the selected shapes by paths to the right of travel, negative to the left",
        |w| {
            let distance_mm = w.number("the distance")?;
            Ok(Operation::Offset { distance_mm, keep: w.takes("keep") })
        },
    ),
    entry(
        "join",
        "join [DISTANCE] [keep|merge]",
        "joins the selected open shapes at ends that near, by a line or by making them one point",
        join,
    ),
    entry(
        "break",
        "break SHAPE X,Y",
        "opens a closed shape there, makes two of an open one",
        |w| Ok(Operation::Break { shape: w.shape()?, at: w.point("the place")? }),
    ),
    entry(
        "trim",
        "trim X,Y",
        "takes the part of a shape there out, between its meetings with the selected shapes",
        |w| Ok(Operation::Trim { at: w.point("the part to be taken out")? }),
    ),
    entry(
        "bulge",
        "bulge SHAPE X,Y B",
        "gives the segment there another bulge; 0 is a line",
        |w| {
            let (shape, at) = (w.shape()?, w.point("the segment")?);
            Ok(Operation::Bulge { shape, at, bulge: w.number("the bulge")? })
        },
    ),
    entry("radius", "radius SHAPE X,Y RADIUS", "gives the segment there another radius", |w| {
        let (shape, at) = (w.shape()?, w.point("the segment")?);
        Ok(Operation::Radius { shape, at, radius_mm: w.number("the radius")? })
    }),
    entry("vertex", "vertex SHAPE X,Y X,Y", "moves the vertex nearest to a place", |w| {
        let (shape, at) = (w.shape()?, w.point("the vertex")?);
        Ok(Operation::Vertex { shape, at, to: w.point("where it goes")? })
    }),
    entry(
        "stretch",
        "stretch X,Y X,Y by X,Y | stretch at X,Y [X,Y …] by X,Y",
        "moves the vertices of the selected shapes that lie in a window, or those nearest to places",
        |w| {
            if w.takes("at") {
                let mut at = vec![w.point("a vertex")?];
                while !w.takes("by") {
                    at.push(w.point("a vertex")?);
                }
                return Ok(Operation::StretchAt { at, by: w.vector("the distance")? });
            }
            let (a, b) = (w.point("a corner")?, w.point("the opposite corner")?);
            w.keyword("by", ())?;
            Ok(Operation::Stretch { a, b, by: w.vector("the distance")? })
        },
    ),
    entry(
        "delete-vertices",
        "delete-vertices SHAPE X,Y …",
        "takes the vertices nearest to places out of a flat shape",
        |w| {
            let (shape, mut at) = (w.shape()?, vec![w.point("a vertex")?]);
            while w.peek().is_some() {
                at.push(w.point("a vertex")?);
            }
            Ok(Operation::DeleteVertices { shape, at })
        },
    ),
    entry("circle", "circle X,Y RADIUS", "adds a circle", |w| {
        Ok(Operation::Circle { centre: w.point("the centre")?, radius_mm: w.number("the radius")? })
    }),
    entry(
        "rect",
        "rect X,Y X,Y | rect X,Y size W,H",
        "adds a rectangle that begins at the first corner",
        rectangle,
    ),
    entry("point", "point X,Y", "adds a place to drill", |w| {
        Ok(Operation::Point { at: w.point("the place")? })
    }),
    entry(
        "line",
        "line X,Y,B X,Y,B … [close]",
        "adds lines, closed by `close`; with a bulge B the segment after a point is an arc, X,Y alone begins a line",
        line,
    ),
    entry(
        "line3d",
        "line3d X,Y,Z X,Y,Z … [close]",
        "adds straight lines with the height of each point above ZSurface, closed by `close`",
        space_line,
    ),
    entry("reverse", "reverse", "turns the cutting direction of the selected shapes", |_| {
        Ok(Operation::Reverse)
    }),
    entry(
        "directions",
        "directions auto",
        "makes outer shapes counter-clockwise and those within clockwise",
        |w| w.keyword("auto", Operation::Directions),
    ),
    entry("start", "start SHAPE X,Y", "lets the cut of a shape begin at its nearest place", |w| {
        Ok(Operation::Start { shape: w.shape()?, at: w.point("the place")? })
    }),
    entry("pause", "pause on|off", "lets the machine halt before the selected shapes", |w| {
        Ok(Operation::Pause { on: w.read("on or off", "on or off", on_off)? })
    }),
    entry("group", "group COLOUR", "puts the selected shapes into a group", |w| {
        Ok(Operation::Group { group: group(w)? })
    }),
    entry("copy-to", "copy-to COLOUR", "adds copies of the selected shapes in a group", |w| {
        Ok(Operation::CopyToGroup { group: group(w)? })
    }),
    entry(
        "set",
        "set COLOUR [on=on|off] [traversal=on|off] [double=on|off] [tool=N] [cut=N] [speed=N|max] \
         [height=thru|3d|Z] [pass=MM|off] [offset=MM] [rough=MM] [tag=MM] [lead-in=R,A] [lead-out=R,A] \
         [plunge=straight|ramp,A|helix,R,A] [cutter=MM|auto]",
        "changes how a group is cut; millimetres, mm/min, degrees",
        set,
    ),
    entry(
        "engrave",
        "engrave [all] tool=D depth=MM|thru [overlap=MM] [group=COLOUR] [cut-outlines]",
        "adds paths that clear the areas of the selected or all shapes with a tool of that diameter, \
         holes left out, so far below ZSurface; the paths go to a group that cuts them as they are, the outlines to \
         one that is off, unless they are to be cut too",
        |w| Ok(Operation::Engrave(clear::read_engrave(w)?)),
    ),
    entry(
        "pocket",
        "pocket [all] tool=D depth=MM|thru [overlap=MM] [group=COLOUR] [cut-outlines] [climb] [outward] | \
         pocket [all] tool=D depth=MM|thru [overlap=MM] [group=COLOUR] [cut-outlines] [climb] zigzag=ANGLE \
         [finish=MM]",
        "as engrave, the other way round with climb, from the middle to the wall with outward; with zigzag \
         in lines at an angle, and then along the walls, where they leave so much to finish",
        pocket,
    ),
    entry(
        "sequence",
        "sequence SHAPES | sequence groups COLOURS | sequence groups of SHAPES | sequence picked | sequence reverse | sequence auto X,Y | \
         sequence level SHAPES | sequence travel [from X,Y] [starts] [speed=MM/S] [accel=MM/S2] \
         [lift=S] [tool-change=S] [tries=N]",
        "changes the order in which shapes are cut; travel seeks the least time between the cuts, and with \
         starts also where closed shapes begin",
        |w| Ok(Operation::Sequence { order: super::sequence::read(w)? }),
    ),
    entry(
        "pick",
        "pick SHAPES | pick groups COLOURS | pick remove SHAPES | pick none",
        "begins a new order, shape by shape or group by group, or goes on with it; removing a shape of a \
         picked group takes the group back; `sequence picked` puts what was picked first",
        |w| Ok(Operation::Pick { picking: super::picks::read(w)? }),
    ),
    entry(
        "array",
        "array rect RxC [spacing X,Y] | array round N about X,Y | \
         array block|job RxC [gap X,Y] [start bl|br|tr|tl] [order row|column|row-snake|column-snake]",
        "adds the selected shapes again in rows and columns or round a centre; block and job repeat the \
         whole drawing when the tool paths are made",
        array,
    ),
    entry(
        "justify",
        "justify left | justify surface | justify bottom Z",
        "moves the drawing to the origin; with its 3D shapes below ZSurface or on ZBottom",
        justify,
    ),
    entry("rotate90", "rotate90", "turns the drawing by a quarter and left-justifies it", |_| {
        Ok(Operation::Rotate90)
    }),
    entry(
        "mirror-drawing",
        "mirror-drawing",
        "mirrors the drawing from left to right and left-justifies it",
        |_| Ok(Operation::MirrorDrawing),
    ),
    entry(
        "origin",
        "origin X,Y | origin cad",
        "makes a place the origin, or gives back the one the drawing was read with",
        |w| {
            if w.takes("cad") {
                return Ok(Operation::CadOrigin);
            }
            Ok(Operation::Origin { at: w.point("the new origin")? })
        },
    ),
    entry("clip", "clip", "puts copies of the selected shapes onto the clipboard", |_| {
        Ok(Operation::Clip)
    }),
    entry(
        "load-clipboard",
        "load-clipboard FILE",
        "puts the shapes of a .dxf, .svg, .rsg or .rsm file onto the clipboard; the drawing stays as it is",
        |w| {
            let file = w.rest();
            if file.is_empty() {
                return Err(WordError::Missing("the file"));
            }
            Ok(Operation::LoadClipboard { file, shapes: None })
        },
    ),
    entry("clear-clipboard", "clear-clipboard", "empties the clipboard", |_| {
        Ok(Operation::ClearClipboard)
    }),
    entry(
        "paste",
        "paste [absolute] X,Y",
        "adds the shapes of the clipboard, their lower left at the place; absolute: their origin",
        |w| {
            let absolute = w.takes("absolute");
            Ok(Operation::Paste { at: w.point("the place")?, absolute })
        },
    ),
    entry(
        "comment",
        "comment WORDS",
        "sets the comments of the drawing, lines divided by |",
        |w| {
            let text = w.rest();
            let lines = text.split('|').map(|line| line.trim().to_owned());
            let lines = if text.is_empty() { Vec::new() } else { lines.collect() };
            Ok(Operation::Comment { lines })
        },
    ),
];

fn select(w: &mut Words) -> Read {
    let how = match () {
        () if w.takes("add") => How::Add,
        () if w.takes("remove") => How::Remove,
        () => How::New,
    };
    let choice = match () {
        () if w.takes("all") => Choice::All,
        () if w.takes("none") => Choice::None,
        () if w.takes("group") => Choice::Group(group(w)?),
        () if w.takes("window") => Choice::Window(w.point("a corner")?, w.point("a corner")?),
        () if w.takes("crossing") => Choice::Crossing(w.point("a corner")?, w.point("a corner")?),
        () => Choice::Shapes(numbers(w)?),
    };
    Ok(Operation::Select { choice, how })
}

fn about(w: &mut Words) -> Result<Point2, WordError> {
    if w.takes("about") { w.point("the centre") } else { Ok(Point2::default()) }
}

/// `at X,Y`, where it stands.
fn at(w: &mut Words) -> Result<Option<Point2>, WordError> {
    if w.takes("at") { w.point("the place").map(Some) } else { Ok(None) }
}

/// A distance, or the way from a base point to another.
fn distance(w: &mut Words) -> Result<Vec2, WordError> {
    if !w.takes("from") {
        return w.vector("the distance");
    }
    let base = w.point("the base point")?;
    w.keyword("to", ())?;
    Ok(w.point("where it goes")? - base)
}

/// `from X,Y X,Y`: a base point and the line from it.
fn base_line(w: &mut Words) -> Result<(Point2, Vec2), WordError> {
    w.keyword("from", ())?;
    let base = w.point("the base point")?;
    let elsewhere =
        |word: &str| pair(word).map(|(x, y)| Point2::new(x, y)).filter(|at| *at != base);
    let end = "an end of the base line as x,y, other than its beginning";
    Ok((base, w.read("the end of the base line", end, elsewhere)? - base))
}

fn rotate(w: &mut Words) -> Read {
    if !w.takes("to") {
        return Ok(Operation::Rotate { angle_deg: w.number("the angle")?, about: about(w)? });
    }
    let wanted = w.number("the angle")?;
    let (about, line) = base_line(w)?;
    Ok(Operation::Rotate { angle_deg: wanted - line.angle().to_degrees(), about })
}

fn scale(w: &mut Words) -> Read {
    if !w.takes("to") {
        return Ok(Operation::Scale { factor: w.number("the factor")?, about: about(w)? });
    }
    let wanted = w.number("the length")?;
    let (about, line) = base_line(w)?;
    Ok(Operation::Scale { factor: wanted / line.length(), about })
}

fn join(w: &mut Words) -> Read {
    let says_how = matches!(w.peek(), None | Some("keep" | "merge"));
    let distance_mm = if says_how { None } else { Some(w.number("the distance")?) };
    let merge = w.takes("merge");
    if !merge {
        w.takes("keep");
    }
    Ok(Operation::Join { distance_mm, merge })
}

pub(super) fn group(w: &mut Words) -> Result<Group, WordError> {
    w.read("the group", "a group: black blue green cyan red magenta brown white", Group::named)
}

fn pocket(w: &mut Words) -> Read {
    let (clearing, pattern) = clear::read_pocket(w)?;
    Ok(Operation::Pocket { clearing, pattern })
}

fn rectangle(w: &mut Words) -> Read {
    let a = w.point("a corner")?;
    let b =
        if w.takes("size") { a + w.vector("the size")? } else { w.point("the opposite corner")? };
    Ok(Operation::Rectangle { a, b })
}

fn line(w: &mut Words) -> Read {
    let mut vertices = vec![w.read("the first point", "a point as x,y or x,y,bulge", vertex)?];
    vertices.push(w.read("the second point", "a point as x,y or x,y,bulge", vertex)?);
    loop {
        let closed = w.takes("close");
        if closed || w.peek().is_none() {
            return Ok(Operation::Polyarc { vertices, closed });
        }
        vertices.push(w.read("a point", "a point as x,y or x,y,bulge", vertex)?);
    }
}

fn space_line(w: &mut Words) -> Read {
    const PLACE: &str = "a point as x,y,z";
    let mut places = vec![w.read("the first point", PLACE, triple)?];
    loop {
        let closed = w.takes("close");
        if closed || w.peek().is_none() {
            return Ok(Operation::SpaceLine { places, closed });
        }
        places.push(w.read("a point", PLACE, triple)?);
    }
}

fn triple(word: &str) -> Option<[f64; 3]> {
    let values: Option<Vec<f64>> = word.split(',').map(number).collect();
    values?.try_into().ok()
}

fn vertex(word: &str) -> Option<Vertex> {
    let mut values = word.split(',').map(number);
    let (x, y) = (values.next()??, values.next()??);
    let bulge = values.next().unwrap_or(Some(0.0))?;
    values.next().is_none().then(|| Vertex::new(x, y, bulge))
}

fn set(w: &mut Words) -> Read {
    let group = group(w)?;
    let mut changes = vec![w.read("a setting", SETTING, change)?];
    while w.peek().is_some() {
        changes.push(w.read("a setting", SETTING, change)?);
    }
    Ok(Operation::Set { group, changes })
}

const SETTING: &str = "a setting of a group with its value, such as offset=3 or lead-in=5,90";

fn change(word: &str) -> Option<Change> {
    let (key, value) = word.split_once('=')?;
    Some(match key.to_ascii_lowercase().as_str() {
        "on" => Change::On(on_off(value)?),
        "traversal" => Change::Traversal(on_off(value)?),
        "tool" => Change::Tool(value.parse().ok()?),
        "cut" => Change::Cut(value.parse().ok()?),
        "speed" => Change::Speed(number_or(value, "max")?),
        "height" => Change::Height(height(value)?),
        "pass" => Change::Pass(number_or(value, "off")?),
        "offset" => Change::Offset(number(value)?),
        "rough" => Change::Rough(number(value)?),
        "double" => Change::DoubleLine(on_off(value)?),
        "tag" => Change::Tag(number(value)?),
        "lead-in" => Change::LeadIn(lead(value)?),
        "lead-out" => Change::LeadOut(lead(value)?),
        "plunge" => Change::Plunge(plunge(value)?),
        "cutter" => Change::Cutter(number_or(value, "auto")?),
        _ => return None,
    })
}

fn on_off(word: &str) -> Option<bool> {
    match word {
        "on" => Some(true),
        "off" => Some(false),
        _ => None,
    }
}

fn number_or(word: &str, none: &str) -> Option<Option<f64>> {
    if word == none { Some(None) } else { number(word).map(Some) }
}

fn height(word: &str) -> Option<CutDepth> {
    match word {
        "thru" => Some(CutDepth::Thru),
        "3d" => Some(CutDepth::ThreeD),
        depth => number(depth).map(CutDepth::Mm),
    }
}

fn lead(word: &str) -> Option<Lead> {
    pair(word).map(|(radius_mm, angle_deg)| Lead { radius_mm, angle_deg })
}

fn plunge(word: &str) -> Option<Plunge> {
    match word.split_once(',') {
        None if word == "straight" => Some(Plunge::Straight),
        Some(("ramp", angle)) => Some(Plunge::Ramp { angle_deg: number(angle)? }),
        Some(("helix", circle)) => {
            pair(circle).map(|(radius_mm, angle_deg)| Plunge::Helix { radius_mm, angle_deg })
        }
        _ => None,
    }
}

fn array(w: &mut Words) -> Read {
    if w.takes("rect") {
        let (rows, columns) = rows_and_columns(w)?;
        let gap = if w.takes("spacing") { w.vector("the gaps")? } else { Vec2::default() };
        return Ok(Operation::ArrayRect { rows, columns, gap });
    }
    if w.takes("round") {
        let count = w.read("how many", "a number of copies", |word| word.parse().ok())?;
        return Ok(Operation::ArrayRound { count, centre: about(w)? });
    }
    levels(w)
}

fn rows_and_columns(w: &mut Words) -> Result<(u32, u32), WordError> {
    w.read("rows x columns", "rows x columns such as 2x3", |word| {
        let (rows, columns) = word.split_once('x')?;
        Some((rows.parse().ok()?, columns.parse().ok()?))
    })
}

fn levels(w: &mut Words) -> Read {
    let level =
        w.read("rect, round, block or job", "rect, round, block or job", |word| match word {
            "block" => Some(Level::Block),
            "job" => Some(Level::Job),
            _ => None,
        })?;
    let (rows, columns) = rows_and_columns(w)?;
    let mut array = ArrayLevel { rows, columns, ..ArrayLevel::default() };
    while w.peek().is_some() {
        array_word(w, &mut array)?;
    }
    Ok(Operation::Array { level, array })
}

fn array_word(w: &mut Words, array: &mut ArrayLevel) -> Result<(), WordError> {
    if w.takes("gap") {
        let gap = w.vector("the gaps between columns and rows")?;
        (array.column_gap_mm, array.row_gap_mm) = (gap.x, gap.y);
    } else if w.takes("start") {
        array.start = w.read("the corner", "a corner: bl br tr tl", Corner::named)?;
    } else if w.takes("order") {
        array.order =
            w.read("the order", "row, column, row-snake or column-snake", Order::named)?;
    } else {
        w.end()?;
    }
    Ok(())
}

fn justify(w: &mut Words) -> Read {
    let which = w.read("left, surface or bottom", "left, surface or bottom", |word| {
        ["left", "surface", "bottom"].into_iter().position(|name| name == word)
    })?;
    Ok(match which {
        0 => Operation::JustifyLeft,
        1 => Operation::JustifySurface,
        _ => Operation::JustifyBottom { bottom_mm: w.number("ZBottom above ZSurface")? },
    })
}
