//! Rows of the Profiler ledger about engraving, and what a person may get wrong with it.

use crate::check::look;
use kerf_drawing::{CutDepth, Editor, Group, Shape, script};
use kerf_geom::{Bounds2, Point2, Polyarc};
use std::f64::consts::PI;

const PLATE: &str = "line 0,0 100,0 100,60 0,60 close";
const ENGRAVE: &str = "engrave all tool=5 overlap=0.1 depth=2";

fn run(editor: &mut Editor, text: &str) -> Vec<String> {
    let ops = script(text).unwrap();
    let outcomes = ops.iter().map(|(n, op)| editor.apply(op).map_err(|e| format!("{n}: {e}")));
    outcomes.flat_map(|outcome| outcome.unwrap().warnings).collect()
}

fn after(text: &str) -> Editor {
    let mut editor = Editor::default();
    assert_eq!(run(&mut editor, text), Vec::<String>::new());
    editor
}

/// The paths that an engraving of shapes adds.
fn engraved(shapes: &str, engrave: &str) -> Vec<Polyarc> {
    let before = after(shapes).drawing.shapes.len();
    let editor = after(&format!("{shapes}; {engrave}"));
    editor.drawing.shapes[before..].iter().map(|shape| shape.path.clone()).collect()
}

fn refused(before: &str, text: &str) -> String {
    let mut editor = after(before);
    let was = editor.clone();
    let error = editor.apply(&script(text).unwrap()[0].1).unwrap_err().to_string();
    assert_eq!(editor, was, "{text} left something behind");
    error
}

/// The closed loops that a path goes round, in its order: as soon as it comes back to a place it was
/// at, what lies between is a loop or a way there and back.
fn rings(path: &Polyarc) -> Vec<Polyarc> {
    let mut way: Vec<kerf_geom::Vertex> = Vec::new();
    let mut found = Vec::new();
    for vertex in &path.vertices {
        let at = way.iter().position(|v| v.at.distance(vertex.at) < 1e-6);
        if let Some(at) = at {
            let ring = Polyarc::closed(way.split_off(at));
            if ring.signed_area().abs() > 1e-3 {
                found.push(ring);
            }
        }
        way.push(*vertex);
    }
    found
}

fn plate() -> Polyarc {
    Polyarc::rectangle(Point2::new(0.0, 0.0), Point2::new(100.0, 60.0))
}

#[test]
fn pro_engrave_all() {
    let editor = after(&format!("{PLATE}; set green offset=3; {ENGRAVE} group=green"));
    let shapes = &editor.drawing.shapes;
    assert_eq!(shapes[0].path, plate());
    assert!(shapes.len() > 1 && shapes[1..].iter().all(|s| s.group == Group::Green));
    let inside = Bounds2::of(Point2::new(2.499, 2.499), Point2::new(97.501, 57.501));
    assert!(shapes[1..].iter().all(|s| inside.holds_box(&s.path.bounds())));
    assert_eq!(editor.drawing.settings(Group::Green).offset_mm, 0.0);
}

#[test]
fn pro_engrave_selected() {
    let two = format!("{PLATE}; line 200,0 300,0 300,60 200,60 close");
    let paths = engraved(&two, "select 1; engrave tool=5 overlap=0.1 depth=2");
    assert_eq!(paths.iter().map(|path| rings(path).len()).collect::<Vec<_>>(), [6]);
    assert!(paths.iter().all(|path| path.bounds().max.x < 100.0));
    assert!(refused(PLATE, "engrave tool=5").contains("no shapes selected"));
}

#[test]
fn pro_engrave_tool_overlap() {
    let mut insets: Vec<f64> =
        engraved(PLATE, ENGRAVE).iter().flat_map(rings).map(|ring| ring.bounds().min.x).collect();
    insets.sort_by(f64::total_cmp);
    let expected = [2.5, 7.4, 12.3, 17.2, 22.1, 27.0];
    assert_eq!(insets.len(), expected.len());
    assert!(insets.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-3), "{insets:?}");
}

/// Area that a tool leaves in four square corners.
fn corners(radius: f64) -> f64 {
    4.0 * radius * radius * (1.0 - PI / 4.0)
}

#[test]
fn pro_engrave_coverage() {
    let (region, paths) = ([plate()], engraved(PLATE, ENGRAVE));
    let seen = look(&region, &paths, 2.5, 400);
    assert!(seen.uncut_mm2 < 0.05 && seen.out_mm < 1e-3, "{seen:?}");
    // What can be reached is all but the corners; 0.25 mm are between the places that are looked at.
    assert!((seen.reached_mm2 - (6000.0 - corners(2.5))).abs() < 4.0, "{seen:?}");
    let rings: Vec<Polyarc> = paths.iter().flat_map(rings).collect();
    let without = look(&region, &rings, 2.5, 400);
    // Twenty cusps of 0.945 and the strip in the middle.
    assert!((without.uncut_mm2 - (20.0 * 0.945 + 41.0)).abs() < 1.5, "{without:?}");
}

#[test]
fn pro_engrave_holes() {
    let shapes = "line 0,0 100,0 100,100 0,100 close; line 30,30 30,70 70,70 70,30 close";
    let paths = engraved(shapes, ENGRAVE);
    let drawing = after(shapes).drawing;
    for path in &paths {
        for k in 0..5000 {
            let at = path.place_after(path.length() * f64::from(k) / 5000.0).unwrap().at;
            let near = |shape: &Shape| shape.path.nearest(at).unwrap().1;
            assert!(drawing.shapes.iter().all(|shape| near(shape) >= 2.499), "{at:?}");
            assert_eq!(drawing.shapes[1].path.winding(at), 0);
        }
    }
    let region: Vec<Polyarc> = drawing.shapes.iter().map(|shape| shape.path.clone()).collect();
    assert!(look(&region, &paths, 2.5, 300).uncut_mm2 < 0.05);
}

#[test]
fn pro_engrave_directions() {
    let wrong = "line 0,0 0,60 100,60 100,0 close";
    let told = refused(wrong, ENGRAVE);
    assert!(told.starts_with("shape 1 at 0,0: directions not set"), "{told}");
    assert_eq!(engraved(wrong, &format!("directions auto; {ENGRAVE}")).len(), 1);
    let hole = refused(&format!("{PLATE}; circle 50,30 10"), ENGRAVE);
    assert!(
        hole.starts_with("shape 2 at 60,30: directions not set: a hole must run clockwise"),
        "{hole}"
    );
}

#[test]
fn pro_engrave_reversal() {
    let shapes = "line 0,0 100,0 100,100 0,100 close; line 30,30 30,70 70,70 70,30 close";
    let editor = after(&format!("{shapes}; {ENGRAVE}"));
    let area = |n: usize| editor.drawing.shapes[n].path.signed_area();
    assert_eq!((area(0), area(1)), (10_000.0, -1600.0));
    let rings: Vec<Polyarc> = engraved(shapes, ENGRAVE).iter().flat_map(rings).collect();
    let wide = |ring: &Polyarc| ring.bounds().size().x;
    let outermost = rings.iter().max_by(|a, b| wide(a).total_cmp(&wide(b))).unwrap();
    assert!(outermost.signed_area() < 0.0 && wide(outermost) > 94.0);
    let round_hole = rings.iter().find(|ring| (wide(ring) - 45.0).abs() < 1e-2).unwrap();
    assert!(round_hole.signed_area() > 0.0);
}

#[test]
fn what_bounds_no_area_is_told() {
    let mut editor = after(&format!("{PLATE}; line 10,10 20,20; point 5,5; circle 200,0 1"));
    let told = run(&mut editor, "engrave all tool=5 overlap=0.1 depth=2 group=red");
    let left_out = "only closed flat shapes bound an area; it is left out";
    let expected = [
        format!("shape 2 at 10,10: {left_out}"),
        format!("shape 3 at 5,5: {left_out}"),
        "shape 4: a tool of 5 mm does not fit into it".into(),
    ];
    assert_eq!(told, expected);
}

/// Notes on an engraving of shapes, and the drawing.
fn told(text: &str) -> (Vec<String>, Editor) {
    let (before, last) = text.rsplit_once("; ").unwrap();
    let mut editor = after(before);
    let outcome = editor.apply(&script(last).unwrap()[0].1).unwrap();
    ([outcome.warnings, outcome.notes].concat(), editor)
}

/// Group and depth of each cut.
fn cut(editor: &Editor) -> Vec<(Group, CutDepth)> {
    let drawing = &editor.drawing;
    let of = |shape: &std::sync::Arc<Shape>| (shape.group, *drawing.settings(shape.group));
    let on = drawing.shapes.iter().map(of).filter(|(_, settings)| settings.on);
    on.map(|(group, settings)| (group, settings.height)).collect()
}

#[test]
fn outlines_of_what_is_cleared_are_not_cut_unless_asked() {
    let deep = CutDepth::Mm(-2.0);
    for op in ["engrave all tool=5 depth=2 group=red", "pocket all tool=5 depth=2 group=red"] {
        let (told_of, mut editor) = told(&format!("{PLATE}; {op}"));
        assert_eq!(cut(&editor), [(Group::Red, deep)], "{op}");
        let expected = "outline 1 is in group white now, which is off: only the area is cut; cut-outlines cuts them too";
        assert_eq!(told_of, [expected]);
        editor.undo().unwrap();
        assert_eq!(cut(&editor), [(Group::Black, CutDepth::Thru)]);
        let (told_of, editor) = told(&format!("{PLATE}; {op} cut-outlines"));
        assert_eq!(cut(&editor), [(Group::Black, CutDepth::Thru), (Group::Red, deep)]);
        assert_eq!(told_of, Vec::<String>::new());
    }
    // A group that is off already takes them; what is too narrow keeps its outline.
    let two = format!("{PLATE}; circle 200,0 1; set green on=off");
    let (told_of, editor) = told(&format!("{two}; engrave all tool=5 depth=2"));
    let groups: Vec<Group> = editor.drawing.shapes.iter().map(|shape| shape.group).collect();
    assert_eq!(groups, [Group::Green, Group::Black, Group::Blue]);
    assert!(told_of[1].starts_with("outline 1 is in group green now"), "{told_of:?}");
    // What is drawn twice is not cut a second time either.
    let (_, editor) = told("circle 0,0 20; circle 0,0 20; engrave all tool=5 depth=2");
    assert_eq!(cut(&editor), [(Group::Blue, deep)]);
}

#[test]
fn nothing_is_cleared_through_the_sheet_unless_said() {
    let height = |words: &str| {
        let (told_of, editor) = told(&format!("{PLATE}; engrave all tool=5{words}"));
        let deep = cut(&editor).iter().map(|(_, height)| *height).collect::<Vec<_>>();
        (deep, told_of.len())
    };
    assert_eq!(height(" depth=2"), (vec![CutDepth::Mm(-2.0)], 1));
    assert_eq!(height(" depth=thru"), (vec![CutDepth::Thru], 1));
    assert_eq!(height(""), (vec![CutDepth::Mm(0.0)], 2));
    let (told_of, _) = told(&format!("{PLATE}; engrave all tool=5"));
    assert!(told_of[0].starts_with("how deep is not said: the paths of group blue only touch"));
    let set = format!("{PLATE}; set red height=-3 pass=1");
    let (_, editor) = told(&format!("{set}; engrave all tool=5 group=red"));
    assert_eq!(cut(&editor), [(Group::Red, CutDepth::Mm(-3.0))]);
    let (_, editor) = told(&format!("{set}; engrave all tool=5 group=red depth=thru"));
    assert_eq!(editor.drawing.settings(Group::Red).check(), Ok(()));
    // Shapes of a group keep their depth.
    let red = "circle 200,0 20; select 1; group red; line 0,0 100,0 100,60 0,60 close; select 2";
    let why = refused(red, "engrave tool=5 group=red");
    assert!(why.starts_with("group red has shapes that are cut through the sheet"), "{why}");
    let why = refused(red, "engrave tool=5 group=red depth=2");
    assert!(why.starts_with("group red has shapes of another height"), "{why}");
    let words = script("engrave all tool=5 depth=-2").unwrap_err().to_string();
    assert!(words.contains("depth=2 (millimetres below ZSurface)"), "{words}");
}

#[test]
fn outlines_need_a_group_that_is_off() {
    let groups = ["blue", "green", "cyan", "red", "magenta", "brown", "white"];
    let in_group = |(n, name)| format!("point 0,0; select {n}; group {name}");
    let points: Vec<String> = (1..).zip(groups).map(in_group).collect();
    let full = format!("{}; {PLATE}; set blue height=-1; select 8", points.join("; "));
    let why = refused(&full, "engrave tool=5 group=blue");
    assert!(why.starts_with("all eight groups have shapes and are on"), "{why}");
}

#[test]
fn what_cannot_be_engraved_is_refused() {
    assert!(refused(PLATE, "engrave all tool=5 overlap=5").contains("the overlap is 5 mm"));
    let used = refused(&format!("{PLATE}; set black offset=3"), &format!("{ENGRAVE} group=black"));
    assert!(used.starts_with("group black has shapes and an offset"), "{used}");
    assert!(
        script("engrave all").unwrap_err().to_string().contains("diameter of the tool is missing")
    );
}

/// The area that an engraving of shapes clears, and what is told of it.
fn cleared(shapes: &str) -> (f64, Vec<String>) {
    let mut editor = after(shapes);
    let first = editor.drawing.shapes.len();
    let told = run(&mut editor, "engrave all tool=1 overlap=0.2 depth=2");
    let paths: Vec<Polyarc> =
        editor.drawing.shapes[first..].iter().map(|s| s.path.clone()).collect();
    let whole = [Polyarc::rectangle(Point2::new(-50.0, -50.0), Point2::new(50.0, 50.0))];
    let seen = look(&whole, &paths, 0.5, 500);
    (seen.reached_mm2 - seen.uncut_mm2, told)
}

#[test]
fn shapes_that_cross_are_one_area() {
    let (area, told) = cleared("circle 0,0 20; circle 20,0 20");
    assert_eq!(told, ["shapes 1 and 2 cross each other: their areas are one"]);
    let two_circles = 2.0 * 400.0 * (PI * 2.0 / 3.0 + 3.0_f64.sqrt() / 4.0);
    assert!((area - two_circles).abs() < 10.0, "{area} {two_circles}");
}

#[test]
fn the_loops_of_a_shape_that_crosses_itself_are_engraved() {
    let (area, told) = cleared("line 0,0 20,20 20,0 0,21 close; select all; directions auto");
    assert_eq!(told, ["shape 1 at 0,0 crosses itself"]);
    assert!((area - 205.0).abs() < 10.0, "{area}");
}

#[test]
fn a_shape_drawn_twice_is_one_area() {
    let (area, told) = cleared("circle 0,0 20; circle 0,0 20");
    assert_eq!(told, ["shape 2 lies on shape 1: it is left out"]);
    assert!((area - 400.0 * PI).abs() < 10.0, "{area}");
}

#[test]
fn a_hole_may_touch_its_shape() {
    let (area, told) = cleared("line 0,0 20,0 20,20 0,20 close; line 0,10 5,15 10,10 5,5 close");
    assert_eq!(told, Vec::<String>::new());
    assert!((area - 350.0).abs() < 10.0, "{area}");
}

fn pocket(words: &str) -> Vec<Polyarc> {
    let shapes = "line 0,0 60,0 60,40 0,40 close; circle 30,20 8; directions auto";
    let paths = engraved(shapes, &format!("pocket all tool=5 depth=2 {words}"));
    let region: Vec<Polyarc> =
        after(shapes).drawing.shapes.iter().map(|shape| shape.path.clone()).collect();
    let seen = look(&region, &paths, 2.5, 300);
    assert!(seen.uncut_mm2 < 0.05 && seen.out_mm < 1e-3, "{words}: {seen:?}");
    paths
}

#[test]
fn pockets_leave_nothing() {
    for words in ["overlap=0.5 zigzag=20", "overlap=2 zigzag=90 finish=0.4 climb"] {
        pocket(words);
    }
    // Which way the tool goes along the lower wall, and whether it does so in the first half.
    let wall = |words: &str| {
        let path = pocket(words).remove(0);
        let low = |s: &kerf_geom::Segment| s.at(0.5).y < 2.6 && s.length() > 20.0;
        let at = path.segments().position(|segment| low(&segment)).unwrap();
        (path.segment(at).direction(0.5).x > 0.0, at < path.segment_count() / 2)
    };
    // Counter-clockwise along the wall, and the wall among the first.
    assert_eq!(wall("overlap=1"), (false, true));
    assert_eq!(wall("overlap=1 climb"), (true, true));
    assert_eq!(wall("overlap=1 climb outward"), (true, false));
    assert_eq!(wall("overlap=1 outward"), (false, false));
}

#[test]
fn patterns_that_cannot_be_are_refused() {
    let told = |text: &str| script(text).unwrap_err().to_string();
    assert!(
        told("pocket tool=5 finish=1").contains("zigzag=ANGLE, which finish= needs, is missing")
    );
    assert!(told("pocket tool=5 zigzag=0 outward").contains("`outward` is one word too many"));
    assert!(refused(PLATE, "pocket all tool=5 zigzag=0 finish=3").contains("the finish is 3 mm"));
}
