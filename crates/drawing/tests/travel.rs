//! The order of cutting with the least time between the cuts.

use crate::plates;
use kerf_drawing::{
    Drawing, Editor, Group, Operation, Rapids, Search, Sequencing, Shape, script, travelled,
};
use kerf_geom::{Point2, Polyarc, Position};

fn sequenced(drawing: &Drawing, words: &str) -> Drawing {
    let mut editor = Editor::of(drawing.clone());
    for (_, operation) in script(words).unwrap() {
        editor.apply(&operation).unwrap();
    }
    editor.drawing
}

fn drawn(words: &str) -> Drawing {
    sequenced(&Drawing::default(), words)
}

fn seconds(drawing: &Drawing) -> f64 {
    travelled(drawing, Point2::default(), &Rapids::default()).seconds
}

fn starts(drawing: &Drawing) -> String {
    let word = |shape: &Shape| format!("{},{}", shape.start().x, shape.start().y);
    drawing.shapes.iter().map(|shape| word(shape)).collect::<Vec<_>>().join(" ")
}

/// Pairs of shapes of which the outer is cut before the inner one, found place by place.
fn violations(drawing: &Drawing) -> usize {
    let shapes = &drawing.shapes;
    let inside = |inner: &Polyarc, outer: &Polyarc| {
        outer.closed && inner.vertices.iter().all(|v| outer.position(v.at) == Position::Inside)
    };
    let late = |n: usize| (0..n).filter(|m| inside(&shapes[n].path, &shapes[*m].path)).count();
    (0..shapes.len()).map(late).sum()
}

#[test]
fn plates_are_cut_inside_first_with_less_travel() {
    for (contours, share) in [(104, 0.9), (311, 0.9)] {
        let plate = plates::plate(contours, 1);
        let nearest = sequenced(&plate, "sequence travel starts tries=0");
        let sought = sequenced(&plate, "sequence travel starts tries=2000");
        let length = |drawing| travelled(drawing, Point2::default(), &Rapids::default()).length_mm;
        assert_eq!((violations(&nearest), violations(&sought)), (0, 0));
        assert!(length(&sought) < share * length(&nearest), "{} contours", contours);
        assert!(seconds(&sought) < seconds(&nearest));
        assert!(seconds(&nearest) < seconds(&sequenced(&plate, "sequence auto 0,0")));
    }
}

/// The least seconds of all orders that cut what lies inside first.
fn least_of_all_orders(drawing: &Drawing) -> f64 {
    let mut least = f64::INFINITY;
    let mut order = drawing.shapes.clone();
    permute(&mut order, 0, &mut |shapes| {
        let candidate = drawing.with_shapes(shapes.to_vec());
        if violations(&candidate) == 0 {
            least = least.min(seconds(&candidate));
        }
    });
    least
}

fn permute<T>(list: &mut [T], from: usize, visit: &mut impl FnMut(&[T])) {
    if from + 1 >= list.len() {
        return visit(list);
    }
    for n in from..list.len() {
        list.swap(from, n);
        permute(list, from + 1, visit);
        list.swap(from, n);
    }
}

#[test]
fn few_shapes_are_sequenced_exactly() {
    for seed in 0..8 {
        let mut drawing = plates::plate(6, seed);
        drawing.add(Shape::flat(Polyarc::lines(
            [Point2::new(-40.0, 5.0), Point2::new(-10.0, 60.0)],
            false,
        )));
        let sought = sequenced(&drawing, "sequence travel");
        let least = least_of_all_orders(&drawing);
        assert!((seconds(&sought) - least).abs() < 1e-9, "{} {least}", seconds(&sought));
        assert!(seconds(&sequenced(&drawing, "sequence travel starts")) <= least + 1e-9);
    }
}

#[test]
fn more_tries_are_never_worse() {
    let plate = plates::plate(40, 3);
    let of = |tries: u32| seconds(&sequenced(&plate, &format!("sequence travel tries={tries}")));
    let times: Vec<f64> = [0, 1, 100, 1000].map(of).to_vec();
    assert!(times.is_sorted_by(|a, b| *b <= a + 1e-9), "{times:?}");
}

#[test]
fn the_same_drawing_gives_the_same_order() {
    let plate = plates::plate(40, 5);
    let once = sequenced(&plate, "sequence travel starts tries=300");
    assert_eq!(once, sequenced(&plate, "sequence travel starts tries=300"));
}

#[test]
fn starts_and_directions_stay_unless_asked() {
    let plate = plates::plate(20, 2);
    let sought = sequenced(&plate, "sequence travel");
    assert!(sought.shapes.iter().all(|shape| plate.shapes.contains(shape)));
    assert_eq!(sought.shapes.len(), plate.shapes.len());
}

#[test]
fn closed_shapes_begin_where_the_way_is_shortest() {
    let drawing = drawn("rect 10,-5 20,5; sequence travel starts");
    assert_eq!(starts(&drawing), "10,0");
    let between = drawn("rect 10,20 30,40; rect 50,0 70,20; sequence travel from 40,30 starts");
    let far = travelled(&between, Point2::new(40.0, 30.0), &Rapids::default()).length_mm;
    // From (40,30) to the edge at x 30, to the edge at y 20, and back.
    assert!(far < 20.0 + 2.0 * 200f64.sqrt(), "{far}");
}

#[test]
fn a_lead_is_not_put_at_a_corner() {
    let set = "group red; set red lead-in=3,90 offset=2";
    let drawing = drawn(&format!("rect 10,10 20,20; select all; {set}; sequence travel starts"));
    assert!(["10,15", "15,10"].contains(&starts(&drawing).as_str()), "{}", starts(&drawing));
}

#[test]
fn open_shapes_are_turned_only_where_nothing_lies_on_one_side() {
    let lines = "line 100,0 0,0; line 0,10 100,10; line 100,20 0,20";
    let plain = drawn(&format!("{lines}; sequence travel starts"));
    let length = travelled(&plain, Point2::default(), &Rapids::default()).length_mm;
    assert!((length - 20.0 - 10400f64.sqrt()).abs() < 1e-9, "{length}");
    let offset = drawn(&format!("{lines}; set black offset=1; sequence travel starts"));
    let all: Vec<_> = drawn(lines).shapes;
    assert!(offset.shapes.iter().all(|shape| all.contains(shape)));
}

#[test]
fn tools_are_changed_as_seldom_as_can_be() {
    let points = "point 10,0; point 20,0; point 30,0; point 40,0";
    let groups = "select 2,4; group red; set red tool=2; sequence travel";
    let changes =
        |words: &str| travelled(&drawn(words), Point2::default(), &Rapids::default()).tool_changes;
    assert_eq!(changes(&format!("{points}; {groups}")), 1);
    assert_eq!(changes(&format!("{points}; {groups} tool-change=0")), 3);
}

#[test]
fn what_is_not_cut_comes_last() {
    let points = "point 10,0; point 20,0; point 30,0";
    let drawing = drawn(&format!("{points}; select 1; group red; set red on=off; sequence travel"));
    assert_eq!(drawing.shapes[2].group, Group::Red);
}

#[test]
fn heights_and_pauses_go_with_their_shapes() {
    let mut drawing = plates::plate(14, 7);
    let marked = Shape { pause: true, ..drawing.shapes[3].as_ref().clone() };
    let vertices = marked.path.vertices.len();
    drawing.shapes[3] = Shape { z_mm: Some(vec![-2.0; vertices]), ..marked }.into();
    let sought = sequenced(&drawing, "sequence travel starts tries=200");
    let found = sought.shapes.iter().find(|shape| shape.pause).unwrap();
    let heights = found.z_mm.as_ref().unwrap();
    assert_eq!(heights.len(), found.path.vertices.len());
    assert!(heights.iter().all(|z| *z == -2.0));
}

#[test]
fn what_is_saved_is_told() {
    let mut editor = Editor::of(drawn("point 100,0; point 0,0; point 100,0"));
    let order = Sequencing::Travel(Search {
        rapids: Rapids { lift_s: 0.0, ..Rapids::default() },
        ..Search::default()
    });
    let outcome = editor.apply(&Operation::Sequence { order }).unwrap();
    assert_eq!(outcome.notes, ["travel 400.0 mm in 3.9 s, now 200.0 mm in 1.9 s"]);
}

#[test]
fn speeds_that_cannot_be_are_refused() {
    let refused = |words: &str| {
        let operation = &script(words).unwrap()[0].1;
        Editor::of(drawn("point 1,1")).apply(operation).unwrap_err().to_string()
    };
    assert_eq!(refused("sequence travel speed=0"), "the speed is 0: it must be above 0");
    assert_eq!(
        refused("sequence travel lift=-1"),
        "the time of a lift is -1: it must be 0 or more"
    );
    assert!(script("sequence travel soon").is_err());
}

#[test]
fn nothing_and_one_shape_need_no_search() {
    assert_eq!(drawn("sequence travel starts").shapes.len(), 0);
    assert_eq!(starts(&drawn("point 3,4; sequence travel starts")), "3,4");
}
