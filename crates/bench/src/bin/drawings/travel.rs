//! The order of cutting: random plates and holes to drill.

use crate::bound::one_tree;
use crate::plates;
use crate::row::Row;
use crate::timed::timed;
use kerf_drawing::{Drawing, Editor, Nesting, Operation, Rapids, Search, Sequencing, travelled};
use kerf_geom::Point2;

/// Length only: what the bound and other programs tell.
const LENGTH: Rapids =
    Rapids { speed_mm_s: 1.0, accel_mm_s2: 0.0, lift_s: 0.0, tool_change_s: 0.0 };

/// Plates by their contours, with the way between the cuts that is asked for, metres.
const PLATES: [(usize, f64); 3] = [(104, 2.5), (311, 8.1), (978, 27.5)];
/// Greatest excess of a way to drill over the bound, percent.
const OVER: f64 = 5.0;

pub fn measure() -> Vec<Row> {
    let mut rows = Vec::new();
    for (contours, goal_m) in PLATES {
        let plate = plates::plate(contours, 1);
        let what = format!("travel, plate with {contours} contours");
        let rule = Sequencing::Auto(Point2::default());
        rows.push(by(&what, "the manual's rule", &plate, &rule).0);
        let first = Search { tries: Some(0), ..search(Rapids::default()) };
        rows.push(by(&what, "nearest with best places", &plate, &Sequencing::Travel(first)).0);
        let whole = Sequencing::Travel(search(Rapids::default()));
        let (row, way) = by(&what, "Kerf", &plate, &whole);
        let met = way.length_mm <= goal_m * 1e3 && row.ms <= 1000.0 && way.late == 0;
        rows.push(row.asked(format!("≤ {goal_m} m in 1 s, none late"), met));
    }
    rows.extend(drilled());
    rows.push(few());
    rows
}

/// Plates of few shapes that are compared with the best of all orders.
const FEW: u64 = 40;

/// Plates of 4 to 12 shapes, starts as they are: how many have the shortest way there is. The shortest is found
/// apart from Kerf's own search, over all subsets.
fn few() -> Row {
    let (mut exact, mut all_ms) = (0, 0.0f64);
    for seed in 0..FEW {
        let plate = plates::plate(4 + (seed % 9) as usize, seed);
        let search = Search { rapids: LENGTH, ..Search::default() };
        let (row, way) = by("", "", &plate, &Sequencing::Travel(search));
        all_ms += row.ms;
        exact += u64::from((way.length_mm - least(&plate)).abs() < 1e-6);
    }
    let result = format!("{exact} of {FEW} exact");
    let row = Row::new("travel, plates of 4 to 12 shapes", "Kerf", result, all_ms / FEW as f64);
    row.asked("the shortest of all", exact == FEW)
}

/// The least length of a way from the origin through all shapes and back, what lies inside first (Held and Karp
/// 1962).
fn least(plate: &Drawing) -> f64 {
    let count = plate.shapes.len();
    let nesting = Nesting::of(&plate.shapes);
    let mut before = vec![0usize; count];
    for n in 0..count {
        if let Some(outer) = nesting.parent(n) {
            before[outer] |= 1 << n;
        }
    }
    let at = |n: usize| plate.shapes[n].start();
    let mut best = vec![f64::INFINITY; count << count];
    for n in (0..count).filter(|n| before[*n] == 0) {
        best[(1 << n) * count + n] = Point2::default().distance(at(n));
    }
    for done in 1..1usize << count {
        for (last, next) in (0..count).flat_map(|last| (0..count).map(move |next| (last, next))) {
            let so_far = best[done * count + last];
            if so_far < f64::INFINITY && done & (1 << next) == 0 && before[next] & !done == 0 {
                let slot = (done | 1 << next) * count + next;
                best[slot] = best[slot].min(so_far + at(last).distance(at(next)));
            }
        }
    }
    let all = ((1usize << count) - 1) * count;
    let home = |last: usize| best[all + last] + at(last).distance(Point2::default());
    (0..count).map(home).fold(f64::INFINITY, f64::min)
}

fn drilled() -> [Row; 2] {
    let drilled = plates::drilled(1000, 1);
    let what = "travel, 1,000 places to drill";
    let (row, way) = by(what, "Kerf, least length", &drilled, &Sequencing::Travel(search(LENGTH)));
    let mut places = vec![Point2::default()];
    places.extend(drilled.shapes.iter().map(|shape| shape.start()));
    let (bound, ms) = timed(1, || one_tree(&places));
    let over = 100.0 * (way.length_mm / bound - 1.0);
    let row = Row { result: format!("{}, {over:.1} % above the bound", row.result), ..row };
    let bound = Row::new(what, "1-tree bound", format!("{:.2} m", bound / 1e3), ms);
    [row.asked("≤ 5 % above", over <= OVER), bound]
}

fn search(rapids: Rapids) -> Search {
    Search { starts: true, rapids, ..Search::default() }
}

/// The way between the cuts of a drawing.
struct Way {
    length_mm: f64,
    /// Shapes that are cut after what lies around them.
    late: usize,
}

/// Sequences a drawing.
fn by(what: &str, who: &'static str, drawing: &Drawing, order: &Sequencing) -> (Row, Way) {
    let operation = Operation::Sequence { order: order.clone() };
    let (sequenced, ms) = timed(1, || {
        let mut editor = Editor::of(drawing.clone());
        // A refusal leaves the drawing as it was, which the length shows.
        let _ = editor.apply(&operation);
        editor.drawing
    });
    let way = travelled(&sequenced, Point2::default(), &Rapids::default());
    let nesting = Nesting::of(&sequenced.shapes);
    let is_late = |n: &usize| nesting.parent(*n).is_some_and(|outer| outer < *n);
    let late = (0..sequenced.shapes.len()).filter(is_late).count();
    let result = format!("{:.2} m, {:.0} s, {late} late", way.length_mm / 1e3, way.seconds);
    (Row::new(what, who, result, ms), Way { length_mm: way.length_mm, late })
}

#[cfg(test)]
mod tests {
    #[test]
    fn plates_of_few_shapes_are_travelled_the_shortest_way() {
        assert_eq!(super::few().goal.map(|(_, met)| met), Some(true));
    }
}
