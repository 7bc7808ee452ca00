//! The order of cutting: random plates and holes to drill.

use crate::bound::one_tree;
use crate::{plates, timed};
use kerf_drawing::{Drawing, Editor, Operation, Rapids, Search, Sequencing, travelled};
use kerf_geom::Point2;

/// Length only: what the bound and other programs tell.
const LENGTH: Rapids =
    Rapids { speed_mm_s: 1.0, accel_mm_s2: 0.0, lift_s: 0.0, tool_change_s: 0.0 };

pub fn measure() {
    for contours in [104, 311, 978] {
        let plate = plates::plate(contours, 1);
        let what = format!("travel, plate with {contours} contours");
        by(&what, "the manual's rule", &plate, &Sequencing::Auto(Point2::default()));
        let first = Search { tries: Some(0), ..search(Rapids::default()) };
        by(&what, "nearest with best places", &plate, &Sequencing::Travel(first));
        by(&what, "Kerf", &plate, &Sequencing::Travel(search(Rapids::default())));
    }
    let drilled = plates::drilled(1000, 1);
    let what = "travel, 1,000 places to drill";
    let length = by(what, "Kerf, least length", &drilled, &Sequencing::Travel(search(LENGTH)));
    let mut places = vec![Point2::default()];
    places.extend(drilled.shapes.iter().map(|shape| shape.start()));
    let (bound, ms) = timed(1, || one_tree(&places));
    let over = 100.0 * (length / bound - 1.0);
    println!("| {what} | 1-tree bound | {:.2} m; Kerf {over:.1} % above | {ms:.0} |", bound / 1e3);
}

fn search(rapids: Rapids) -> Search {
    Search { starts: true, rapids, ..Search::default() }
}

/// Sequences a drawing and gives the length of the way between the cuts, millimetres.
fn by(what: &str, who: &str, drawing: &Drawing, order: &Sequencing) -> f64 {
    let operation = Operation::Sequence { order: order.clone() };
    let (sequenced, ms) = timed(1, || {
        let mut editor = Editor::of(drawing.clone());
        // A refusal leaves the drawing as it was, which the length shows.
        let _ = editor.apply(&operation);
        editor.drawing
    });
    let way = travelled(&sequenced, Point2::default(), &Rapids::default());
    println!("| {what} | {who} | {:.2} m, {:.0} s | {ms:.0} |", way.length_mm / 1e3, way.seconds);
    way.length_mm
}
