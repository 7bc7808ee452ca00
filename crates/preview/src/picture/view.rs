//! Which part of the plane a picture shows, and how large its letters are.

use super::extent::Extent;
use crate::scene::{FARTHEST_MM, Scene, TableView};
use crate::sheet::Rect;
use kerf_geom::Point2;

/// The table is drawn whole when the motion is at least this share of its length; below it the
/// picture shows the motion large and the table in a small map.
const SHARE_OF_TABLE: f64 = 0.3;
/// The shorter side of the drawing is at least this share of the longer one.
const SLIMMEST: f64 = 0.22;
/// Empty border around what is shown, as a share of the longer side.
const BORDER: f64 = 0.05;
/// Em heights along the longer side of the drawing.
const EMS: f64 = 66.0;
/// Side of the picture when there is nothing to show, mm.
const NOTHING_MM: f64 = 100.0;
/// The smallest thing that is drawn as more than a point, mm.
const SMALLEST_MM: f64 = 0.001;
/// From so many times the picture's size away, coordinates are written relative to a near place:
/// browsers draw with single precision, 7 digits of which 4 are wanted inside the picture.
const FAR: f64 = 1000.0;

/// The frame of the drawing and the sizes that follow from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The drawing's frame, page coordinates.
    pub panel: Rect,
    /// Height of normal text, mm.
    pub em: f64,
    /// The table is shown in a map beside the drawing instead of in full.
    pub map: bool,
    /// The table, if it is one that can be drawn.
    pub table: Option<TableView>,
    /// See [`crate::sheet::Sheet::origin`].
    pub origin: Point2,
    /// Decimals of coordinates.
    pub decimals: u32,
}

impl View {
    /// Chooses the view for a scene.
    pub fn of(scene: &Scene, extent: &Extent, cutter_mm: f64) -> Self {
        let table = scene.table.filter(drawable);
        let drawn = drawn_rect(extent, cutter_mm);
        let (shown, map) = choose(drawn, table.map(|t| table_rect(&t)));
        let panel = roomy(shown);
        let decimals = decimals(panel.longer());
        Self { panel, em: panel.longer() / EMS, map, table, origin: origin(panel), decimals }
    }
}

/// The table in page coordinates.
pub fn table_rect(table: &TableView) -> Rect {
    let [w, h, _] = table.size_mm;
    Rect { x: table.origin[0], y: -table.origin[1] - h, w, h }
}

/// Returns `true` if a table has a size and a place.
pub fn drawable(table: &TableView) -> bool {
    let near = |v: &f64| v.abs() <= FARTHEST_MM;
    table.origin.iter().all(near)
        && table.size_mm.iter().all(near)
        && table.size_mm[0] > SMALLEST_MM
        && table.size_mm[1] > SMALLEST_MM
}

/// Returns the box of what moves, with half a cutter around the cuts and zero where it is not far off.
fn drawn_rect(extent: &Extent, cutter_mm: f64) -> Option<Rect> {
    if extent.drawn.is_empty() {
        return None;
    }
    let mut rect = page_rect(extent.drawn.min, extent.drawn.max);
    if !extent.cut.is_empty() {
        rect = rect.around(&page_rect(extent.cut.min, extent.cut.max).grown(0.5 * cutter_mm));
    }
    let with_zero = rect.around(&Rect::default());
    let zero_is_near = with_zero.longer() <= 1.5 * rect.longer().max(SMALLEST_MM);
    Some(if zero_is_near { with_zero } else { rect })
}

fn page_rect(min: [f64; 3], max: [f64; 3]) -> Rect {
    Rect { x: min[0], y: -max[1], w: max[0] - min[0], h: max[1] - min[1] }
}

fn choose(drawn: Option<Rect>, table: Option<Rect>) -> (Rect, bool) {
    match (drawn, table) {
        (None, None) => (Rect { x: 0.0, y: -NOTHING_MM, w: NOTHING_MM, h: NOTHING_MM }, false),
        (None, Some(table)) => (table, false),
        (Some(drawn), None) => (drawn, false),
        (Some(drawn), Some(table)) => {
            let both = drawn.around(&table);
            let whole = drawn.longer() >= SHARE_OF_TABLE * both.longer();
            if whole { (both, false) } else { (drawn, true) }
        }
    }
}

/// With a border, and neither side too short.
fn roomy(shown: Rect) -> Rect {
    let long = shown.longer().max(SMALLEST_MM);
    let short = SLIMMEST * long;
    let (dx, dy) = ((short - shown.w).max(0.0), (short - shown.h).max(0.0));
    Rect { x: shown.x - 0.5 * dx, y: shown.y - 0.5 * dy, w: shown.w + dx, h: shown.h + dy }
        .grown(BORDER * long)
}

/// 0.001 mm, finer in pictures of less than a centimetre.
fn decimals(long_mm: f64) -> u32 {
    let finer = (1.0 - long_mm.log10()).ceil().clamp(0.0, 4.0);
    3 + finer as u32
}

fn origin(panel: Rect) -> Point2 {
    let far = panel.x.abs().max(panel.y.abs());
    if far < FAR * panel.longer() {
        return Point2::default();
    }
    let step = 10f64.powf(panel.longer().log10().ceil());
    // Adding zero turns a negative zero into a plain one.
    let near = |v: f64| (v / step).round() * step + 0.0;
    Point2::new(near(panel.x), near(-panel.bottom()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Segment, Shape};
    use kerf_program::MoveKind;

    fn view(from: [f64; 2], to: [f64; 2], table: Option<[f64; 2]>) -> View {
        let segment = Segment {
            kind: MoveKind::Cut,
            from: [from[0], from[1], 0.0],
            to: [to[0], to[1], 0.0],
            shape: Shape::Line,
            line: 1,
        };
        let table = table.map(|[w, h]| TableView {
            origin: [0.0; 2],
            size_mm: [w, h, 100.0],
            grid_mm: 100.0,
        });
        let scene = Scene { segments: vec![segment], table, ..Scene::default() };
        View::of(&scene, &Extent::of(&scene), 0.0)
    }

    #[test]
    fn a_large_part_is_shown_on_its_table_and_a_small_one_beside_it() {
        let large = view([0.0, 0.0], [800.0, 500.0], Some([2400.0, 1200.0]));
        assert!(!large.map && large.panel.w > 2400.0);
        let small = view([0.0, 0.0], [80.0, 50.0], Some([2400.0, 1200.0]));
        assert!(small.map && small.panel.w < 100.0);
    }

    #[test]
    fn zero_is_shown_when_it_is_near() {
        assert!(view([10.0, 10.0], [60.0, 60.0], None).panel.x < 0.0);
        assert!(view([1000.0, 10.0], [1060.0, 60.0], None).panel.x > 900.0);
    }

    #[test]
    fn slim_parts_get_room_and_tiny_ones_decimals() {
        let slim = view([0.0, 0.0], [1000.0, 0.0], None);
        assert!(slim.panel.h > 220.0);
        assert_eq!((slim.decimals, view([0.0; 2], [0.05, 0.02], None).decimals), (3, 6));
        let point = view([5.0, 5.0], [5.0, 5.0], None);
        assert!(point.panel.w > 0.0 && point.em > 0.0);
    }

    #[test]
    fn a_part_far_away_is_written_from_a_near_place() {
        assert_eq!(view([0.0, 0.0], [800.0, 500.0], None).origin, Point2::default());
        let far = view([2.0e6, 0.0], [2.0e6 + 5.0, 5.0], None);
        assert_eq!(far.origin, Point2::new(2.0e6, 0.0));
    }
}
