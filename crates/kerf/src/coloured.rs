//! The colours of a picture of a job: those of its groups, of directions, or of depth.

use clap::ValueEnum;
use kerf_drawing::{Drawing, Group};
use kerf_geom::{Polyarc, Segment as Piece};
use kerf_preview::{Coloured, Scene, Segment, Shape};
use kerf_program::MoveKind;

/// What the colours of a picture tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Colours {
    /// The group of each path
    Group,
    /// Closed paths blue counter-clockwise and red clockwise, open ones green
    Direction,
    /// Depth of cut
    Depth,
}

/// The picture of a job in these colours, with the cutters of the groups of its drawing.
pub fn coloured(scene: &Scene, drawing: &Drawing, colours: Colours) -> Scene {
    let mut scene = scene.clone();
    let used = scene.toolpaths.iter().filter_map(|path| Group::named(&path.name));
    if let Some(width) =
        used.filter_map(|group| drawing.settings(group).width_mm()).reduce(f64::max)
    {
        (scene.cutter_mm, scene.cutter_known) = (width, true);
    }
    match colours {
        Colours::Depth => {}
        Colours::Group => by_group(&mut scene, drawing),
        Colours::Direction => by_direction(&mut scene),
    }
    scene
}

fn by_group(scene: &mut Scene, drawing: &Drawing) {
    scene.colours = Group::ALL
        .map(|group| {
            let settings = drawing.settings(group);
            let name = format!("{}, tool {}", group.name(), settings.tool);
            let width_mm = settings.width_mm().unwrap_or_default();
            Coloured { name, colour: colour(group), width_mm }
        })
        .to_vec();
    let group_at = |segment: usize| {
        let path = scene.toolpaths.iter().rev().find(|path| path.first_segment <= segment);
        path.and_then(|path| Group::named(&path.name)).unwrap_or_default().index()
    };
    scene.coloured = (0..scene.segments.len()).map(group_at).collect();
}

/// The group's colour as it can be seen on paper.
fn colour(group: Group) -> [u8; 3] {
    match group {
        Group::Black => [0x23, 0x26, 0x2b],
        Group::Blue => [0x1f, 0x5f, 0xc9],
        Group::Green => [0x1b, 0x8a, 0x3f],
        Group::Cyan => [0x08, 0x9b, 0xb0],
        Group::Red => [0xcf, 0x2e, 0x2e],
        Group::Magenta => [0xb8, 0x2f, 0xa8],
        Group::Brown => [0x8a, 0x56, 0x2a],
        Group::White => [0x9b, 0xa3, 0xab],
    }
}

const DIRECTIONS: [(&str, Group); 3] = [
    ("closed, counter-clockwise", Group::Blue),
    ("closed, clockwise", Group::Red),
    ("open", Group::Green),
];

fn by_direction(scene: &mut Scene) {
    let named = |(name, group): (&str, Group)| Coloured {
        name: name.into(),
        colour: colour(group),
        width_mm: 0.0,
    };
    scene.colours = DIRECTIONS.map(named).to_vec();
    let mut coloured = Vec::with_capacity(scene.segments.len());
    for cut in scene.segments.chunk_by(|a, b| a.kind == b.kind) {
        let direction = if cut[0].kind == MoveKind::Cut { direction(cut) } else { 0 };
        coloured.extend(cut.iter().map(|_| direction));
    }
    scene.coloured = coloured;
}

/// Which of [`DIRECTIONS`] a run of cuts has.
fn direction(cut: &[Segment]) -> usize {
    let pieces: Vec<Piece> = cut.iter().filter_map(piece).collect();
    let Some((first, last)) = pieces.first().zip(pieces.last()) else { return 2 };
    let closed = first.start().distance(last.end()) < kerf_geom::tol::JOIN_MM;
    match Polyarc::from_segments(&pieces, false).signed_area() {
        _ if !closed => 2,
        area if area < 0.0 => 1,
        _ => 0,
    }
}

/// A segment seen from above; nothing for one that goes straight down.
fn piece(segment: &Segment) -> Option<Piece> {
    let flat = |place: [f64; 3]| kerf_geom::Point2::new(place[0], place[1]);
    let (from, to) = (flat(segment.from), flat(segment.to));
    match segment.shape {
        Shape::Line => (from != to).then(|| Piece::line(from, to)),
        Shape::Arc { sweep_rad, .. } => Some(Piece::bulged(from, to, (0.25 * sweep_rad).tan())),
    }
}
