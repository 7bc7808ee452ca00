//! Rows of the Profiler ledger about editing shapes.

use kerf_drawing::{Drawing, Editor, Group, Shape, script};
use kerf_geom::{Point2, Polyarc, Vertex};

const SQ100: &str = "line 0,0 100,0 100,100 0,100 close";

fn after(text: &str) -> Editor {
    let mut editor = Editor::default();
    for (n, op) in script(text).unwrap() {
        editor.apply(&op).unwrap_or_else(|error| panic!("clause {n} {op}: {error}"));
    }
    editor
}

fn refused(before: &str, text: &str) -> String {
    let mut editor = after(before);
    let was = editor.clone();
    let error = editor.apply(&script(text).unwrap()[0].1).unwrap_err().to_string();
    assert_eq!(editor, was, "{text} left something behind");
    error
}

fn round(value: f64) -> f64 {
    (value * 1e4).round() / 1e4 + 0.0
}

/// Vertices as `x,y` or `x,y,bulge`, rounded.
fn vertices(shape: &Shape) -> String {
    let word = |v: &Vertex| {
        let at = format!("{},{}", round(v.at.x), round(v.at.y));
        if round(v.bulge) == 0.0 { at } else { format!("{at},{}", round(v.bulge)) }
    };
    let words: Vec<_> = shape.path.vertices.iter().map(word).collect();
    format!("{}{}", words.join(" "), if shape.is_closed() { " close" } else { "" })
}

fn check(text: &str, expected: &[&str]) {
    let editor = after(text);
    let shapes: Vec<_> = editor.drawing.shapes.iter().map(|shape| vertices(shape)).collect();
    assert_eq!(shapes, expected, "{text}");
}

fn area(text: &str) -> f64 {
    round(after(text).drawing.shapes[0].path.signed_area())
}

#[test]
fn pro_edit_move_abs() {
    check(
        &format!("{SQ100}; select all; move from 100,100 to 150,120"),
        &["50,20 150,20 150,120 50,120 close"],
    );
}

#[test]
fn pro_edit_rotate_abs() {
    check("line 0,0 100,100; select all; rotate to 90 from 0,0 100,100", &["0,0 0,141.4214"]);
}

#[test]
fn pro_edit_scale_ref() {
    check("line 0,0 50,0; select all; scale to 75 from 0,0 50,0", &["0,0 75,0"]);
}

#[test]
fn pro_edit_fillet() {
    let made = "line 0,0 100,0 100,100; select all; fillet 10";
    check(made, &["0,0 90,0,0.4142 100,10 100,100"]);
    check(
        &format!("{SQ100}; select all; fillet 10 at 99,2"),
        &["0,0 90,0,0.4142 100,10 100,100 0,100 close"],
    );
    let all = after(&format!("{SQ100}; select all; fillet 10"));
    assert_eq!(all.drawing.shapes[0].path.vertices.len(), 8);
    assert_eq!(
        area(&format!("{SQ100}; select all; fillet 10")),
        round(10000.0 - 400.0 + 100.0 * std::f64::consts::PI)
    );
}

#[test]
fn pro_edit_fillet_limit() {
    let error = refused("line 0,0 9,0 9,9; select all", "fillet 10");
    assert!(
        error.contains("shape 1 at 0,0: a segment is shorter than the fillet needs"),
        "{error}"
    );
    // A corner of 60 degrees: the trim of 17.32 is longer than its 15 mm.
    let sharp = "line 0,0 15,0 7.5,12.990381; select all";
    assert!(refused(sharp, "fillet 10").contains("shorter"));
    assert!(refused(sharp, "fillet 0").contains("above 0"));
}

#[test]
fn corners_are_cut_off() {
    check("line 0,0 100,0 100,100; select all; chamfer 10", &["0,0 90,0 100,10 100,100"]);
}

#[test]
fn pro_edit_bulge_type() {
    let editor = after("line 0,0 10,0; bulge 1 5,0 -0.25");
    let arc = editor.drawing.shapes[0].path.segment(0).arc().unwrap();
    assert_eq!(
        (round(arc.radius()), round(arc.centre.x), round(arc.centre.y)),
        (10.625, 5.0, -9.375)
    );
    check("line 0,0 10,0; bulge 1 5,0 -0.25; bulge 1 5,1 0", &["0,0 10,0"]);
}

#[test]
fn pro_edit_radius_type() {
    check("line 0,0 10,0; radius 1 5,0 5", &["0,0,1 10,0"]);
    check("line 0,0,-0.2 10,0; radius 1 5,0 7.071068", &["0,0,-0.4142 10,0"]);
    let error = refused("line 0,0 10,0", "radius 1 5,0 4");
    assert!(error.contains("a radius of 4 is less than half of the chord, 5"), "{error}");
}

#[test]
fn pro_edit_vertex_move() {
    check(&format!("{SQ100}; vertex 1 99,99 120,110"), &["0,0 100,0 120,110 0,100 close"]);
}

#[test]
fn pro_edit_vertex_arc() {
    check("line 0,0,1 10,0; vertex 1 10,0 10,-5", &["0,0,0.4142 10,-5"]);
}

#[test]
fn pro_edit_stretch() {
    check(
        &format!("{SQ100}; select all; stretch 90,-10 110,110 by 20,0"),
        &["0,0 120,0 120,100 0,100 close"],
    );
}

/// One after the other, and then all at once: a vertex that came to where another was is not moved again.
#[test]
fn pro_edit_stretch__single_vertices() {
    check(
        &format!("{SQ100}; select all; stretch at 99,1 100,99 by 20,0"),
        &["0,0 120,0 120,100 0,100 close"],
    );
    check(
        &format!("{SQ100}; select all; stretch at 0,0 100,0 by 100,0"),
        &["100,0 200,0 100,100 0,100 close"],
    );
    check(
        "line 0,0,1 10,0 20,0; line 10,0 10,50; select all; stretch at 10,0 by 0,-5",
        &["0,0,1 10,-5 20,0", "10,-5 10,50"],
    );
    assert!(refused("line 0,0 10,0; select none", "stretch at 0,0 by 1,0").contains("select"));
}

#[test]
fn pro_edit_stretch_one() {
    let one = ["0,0 100,-10 100,100 0,100 close"];
    check(&format!("{SQ100}; select all; stretch 90,-10 110,10 by 0,-10"), &one);
    check(&format!("{SQ100}; select all; stretch at 100,0 by 0,-10"), &one);
}

#[test]
fn pro_edit_stretch_arc() {
    check("line 0,0,1 10,0; select all; stretch 9,-1 11,1 by 10,0", &["0,0,1 20,0"]);
}

#[test]
fn pro_edit_delvert() {
    check(&format!("{SQ100}; delete-vertices 1 100,100"), &["0,0 100,0 0,100 close"]);
    check(
        "line 0,0 10,0 20,5 30,0 40,0 close; delete-vertices 1 30,0 10,0 29,1",
        &["0,0 20,5 40,0 close"],
    );
    assert!(refused("line 0,0 10,0", "delete-vertices 1 0,0").contains("too few"));
    let path = Polyarc::lines([0.0, 1.0, 2.0].map(|x| Point2::new(x, 0.0)), false);
    let mut solid = Editor::of(Drawing::of([Shape::with_heights(path, vec![0.0, 1.0, 2.0])]));
    let error = solid.apply(&script("delete-vertices 1 1,0").unwrap()[0].1).unwrap_err();
    assert!(error.to_string().contains("flat shapes only"));
}

#[test]
fn pro_edit_delvert_arc() {
    check("line 0,0,1 10,0 20,0; delete-vertices 1 10,0", &["0,0,1 20,0"]);
}

const GAP: &str = "line 0,0 10,0; line 10.3,0 20,0; select all";

#[test]
fn pro_edit_join_line() {
    check(&format!("{GAP}; join 0.5 keep"), &["0,0 10,0 10.3,0 20,0"]);
}

#[test]
fn pro_edit_join_merge() {
    check(&format!("{GAP}; join 0.5 merge"), &["0,0 10.3,0 20,0"]);
}

#[test]
fn pro_edit_join_merge_arc() {
    let text = "line 0,0,1 10,0; line 10.2,0 20,0; select all; join 0.5 merge";
    check(text, &["0,0,0.9806 10.2,0 20,0"]);
}

#[test]
fn pro_edit_join_repeat() {
    let sides = "line 0.2,0 100,0; line 100,0.2 100,100; line 99.8,100 0,100; line 0,99.8 0,0; \
        select all";
    let joined = |distance: f64| {
        let editor = after(&format!("{sides}; join {distance}"));
        let closed = editor.drawing.shapes.iter().filter(|shape| shape.is_closed()).count();
        (editor.drawing.shapes.len(), closed)
    };
    assert_eq!((joined(0.5), joined(0.1)), ((1, 1), (4, 0)));
}

#[test]
fn pro_edit_join_default() {
    let editor = after(&format!("{GAP}; join 0.7"));
    assert_eq!(editor.join_mm, 0.7);
    check(
        &format!("{GAP}; join 0.2; join 0.7; line 0,5 10,5; line 10.6,5 20,5; select 2,3; join"),
        &["0,0 10,0 10.3,0 20,0", "0,5 10,5 10.6,5 20,5"],
    );
}

#[test]
fn pro_edit_break_closed() {
    check(&format!("{SQ100}; break 1 50,0"), &["50,0 100,0 100,100 0,100 0,0 50,0"]);
}

#[test]
fn pro_edit_break_open() {
    check("line 0,0 100,0; point 5,5; break 1 30,0", &["0,0 30,0", "30,0 100,0", "5,5"]);
    // A quarter circle of radius 10 about the origin, broken at 30 degrees.
    let arc = "line 10,0,0.41421356237 0,10; break 1 8.660254,5";
    check(arc, &["10,0,0.1317 8.6603,5", "8.6603,5,0.2679 0,10"]);
}

#[test]
fn pro_edit_break_erase() {
    let text = "line 0,0 100,0; break 1 40,0; break 2 45,0; select 2; erase";
    check(text, &["0,0 40,0", "45,0 100,0"]);
}

const CROSSED: &str = "line 20,-50 20,50; line 80,-50 80,50; line 0,0 100,0; select 1,2";

#[test]
fn pro_edit_trim() {
    let editor = after(&format!("{CROSSED}; trim 50,0"));
    let shapes: Vec<_> =
        editor.drawing.shapes.iter().skip(2).map(|shape| vertices(shape)).collect();
    assert_eq!(shapes, ["0,0 20,0", "80,0 100,0"]);
    assert_eq!(editor.selection, [0, 1]);
}

#[test]
fn pro_edit_trim_none() {
    let error = refused("line 20,-50 20,50; line 30,500 70,500; select 1", "trim 50,500");
    assert!(error.contains("no intersection"), "{error}");
}

#[test]
fn pro_edit_trim_self() {
    let text = "line 0,0 100,0 100,50 50,50 50,-50; select 1; trim 100,25";
    check(text, &["0,0 50,0 50,-50"]);
}

#[test]
fn pro_edit_offset() {
    assert_eq!(area(&format!("{SQ100}; select all; offset 5")), 12078.5398);
    check(&format!("{SQ100}; select all; offset -5"), &["5,5 95,5 95,95 5,95 close"]);
    let editor = after(&format!("{SQ100}; set black offset=3; select all; offset 5 keep"));
    assert_eq!(editor.drawing.shapes.len(), 2);
    assert_eq!(editor.drawing.settings(Group::Black).offset_mm, 3.0);
    assert!(refused(&format!("{SQ100}; select all"), "offset -60").contains("nothing is left"));
}

#[test]
fn pro_array_sel_rect() {
    let editor = after("rect 0,0 10,10; select all; array rect 2x3 spacing 5,8");
    let corners: Vec<_> =
        editor.drawing.shapes.iter().map(|s| (s.start().x, s.start().y)).collect();
    let row = |y: f64| [0.0, 15.0, 30.0].map(|x| (x, y));
    assert_eq!(corners, [row(0.0), row(18.0)].concat());
    assert!(refused("rect 0,0 1,1; select all", "array rect 0x3").contains("1 to 200,000"));
    assert!(refused("rect 0,0 1,1; select all", "array rect 9999x9999").contains("1 to 200,000"));
}

#[test]
fn pro_array_sel_circ() {
    let editor = after("point 50,0; select all; array round 6 about 0,0");
    let angles: Vec<_> = editor
        .drawing
        .shapes
        .iter()
        .map(|s| round((s.start() - Point2::default()).angle().to_degrees().rem_euclid(360.0)))
        .collect();
    assert_eq!(angles, [0.0, 60.0, 120.0, 180.0, 240.0, 300.0]);
}

#[test]
fn operations_of_one_hand_are_one_change() {
    let mut editor = after(SQ100);
    let was = editor.clone();
    let steps = script("select 1; move from 0,0 to 10,0; rotate 90 about 10,0").unwrap();
    editor.apply_all(&steps).unwrap();
    assert_ne!(editor.drawing, was.drawing);
    editor.undo().unwrap();
    assert_eq!(editor.drawing, was.drawing, "both are taken back at once");

    let mistaken = script("select 1; move 1,0; fillet 5000").unwrap();
    let before = editor.clone();
    let (number, _) = editor.apply_all(&mistaken).unwrap_err();
    assert_eq!(number, 3);
    assert_eq!(editor, before, "nothing is half done");
}

#[test]
fn what_would_change_nothing_is_told() {
    let told = |before: &str, text: &str, why: &str| {
        assert_eq!(refused(before, text), why, "{before}; {text}");
    };
    let square = format!("{SQ100}; select all");
    let no_corner = "no corner in the selected shapes: nothing would change";
    told("circle 0,0 5; select all", "fillet 1", no_corner);
    told("circle 0,0 5; select all", "chamfer 1 at 5,0", no_corner);
    let no_vertex = "no vertex of the selected shapes in the window: nothing would change";
    told(&square, "stretch 200,200 300,300 by 1,1", no_vertex);
    let line = "line 0,0 10,0";
    told(line, "break 1 0,0", "shape 1 at 0,0: it ends there: there is nothing to break");
    told("point 3,4", "break 1 3,4", "shape 1 at 3,4: it is a point: there is nothing to break");
    told(&square, "offset 0", "the distance is 0: it must be other than 0");
    told(&square, "justify bottom 5", "ZBottom above ZSurface is 5: it must be 0 or below");
    told(&square, "sequence 1,1", "shape 1 is named twice");
    told(&square, "sequence level 1,1", "shape 1 is named twice");
    told(&square, "pick remove 1", "shape 1 is not picked");
    told("point 0,0; pick groups red", "pick remove 1", "shape 1 is not picked");
    let tangle = "line 0,0 100,100 100,0 0,100 close; select all";
    told(tangle, "offset 3", "shape 1 at 0,0: it crosses itself at 50.000, 50.000");
    let base = |text: &str| script(text).unwrap_err().to_string();
    for text in ["rotate to 5 from 1,1 1,1", "scale to 5 from 1,1 1,1"] {
        let why = "`1,1` is not an end of the base line as x,y, other than its beginning";
        assert!(base(text).contains(why), "{}", base(text));
    }
}

/// Notes of the last clause.
fn notes(text: &str) -> Vec<String> {
    let (before, last) = text.rsplit_once("; ").unwrap_or(("", text));
    let outcome = after(before).apply(&script(last).unwrap()[0].1).unwrap();
    [outcome.warnings, outcome.notes].concat()
}

#[test]
fn groups_without_shapes_and_segments_without_length_are_told() {
    assert_eq!(notes("point 0,0; sequence groups red,black"), ["group red has no shapes"]);
    assert_eq!(notes("point 0,0; pick groups red,black"), ["group red has no shapes"]);
    let told = ["shape 1: a segment without length at 10,0 is left out"];
    assert_eq!(notes("line 0,0 10,0 10,0 10,5"), told);
    assert_eq!(notes("line 0,0 10,0 10,0"), Vec::<String>::new(), "the line ends there");
    check("line 0,0 10,0 10,0 10,5", &["0,0 10,0 10,5"]);
}

#[test]
fn lines_that_come_back_to_their_beginning_are_closed() {
    check("line 25,0,1 -25,0,1 25,0", &["25,0,1 -25,0,1 close"]);
    check("line 0,0 10,0 10,10 0,0", &["0,0 10,0 10,10 close"]);
    check("line 0,0 10,0 0,0", &["0,0 10,0 0,0"]);
    check("line 0,0,1 10,0 0,0", &["0,0,1 10,0 close"]);
}

#[test]
fn a_level_takes_along_what_lies_in_its_shapes() {
    let nest =
        "rect 0,0 100,100; rect 10,10 40,40; rect 50,10 90,40; rect 20,20 30,30; rect 60,20 70,30";
    let starts = |text: &str| {
        let shapes = after(text).drawing.shapes;
        shapes.iter().map(|shape| shape.start().x).collect::<Vec<_>>()
    };
    let level = format!("{nest}; sequence level 3,2");
    assert_eq!(starts(&level), [0.0, 50.0, 60.0, 10.0, 20.0]);
}

#[test]
fn only_shapes_that_are_cut_are_told_to_be_cut_too_early() {
    let nest = "rect 0,0 100,100; rect 10,10 90,90; rect 20,20 30,30; sequence 1,2,3";
    let late = |outer: usize, inner: usize| {
        format!("shape {outer} is cut before shape {inner}, which lies in it")
    };
    assert_eq!(notes(nest), [late(1, 2), late(2, 3)]);
    let off = nest.replace("; sequence", "; select 2; group red; set red on=off; sequence");
    assert_eq!(notes(&off), [late(1, 3)]);
    assert_eq!(notes(&off.replace("select 2", "select 3")), [late(1, 2)]);
    assert_eq!(notes(&off.replace("on=off", "traversal=on")), [late(1, 3)]);
}

#[test]
fn a_group_that_gets_another_cutter_is_told() {
    let two = "rect 0,0 60,40; rect 100,0 160,40; select 1; pocket tool=6 overlap=2 group=red depth=2; select 2";
    let told = "group red was cut by a cutter of 6 mm, now of 3 mm";
    for op in ["pocket tool=3 overlap=1 group=red", "engrave tool=3 overlap=1 group=red"] {
        assert_eq!(notes(&format!("{two}; {op} cut-outlines")), [told], "{op}");
    }
    let none = Vec::<String>::new();
    assert_eq!(notes(&format!("{two}; pocket tool=6 group=red cut-outlines")), none);
    assert_eq!(notes(&format!("{two}; pocket tool=3 group=blue depth=1 cut-outlines")), none);
}

#[test]
fn a_line_with_heights_keeps_every_point_but_repeated_ones() {
    let mut editor = Editor::default();
    let mut draw = |text: &str| {
        editor.apply(&script(text).unwrap()[0].1)?;
        Ok::<_, kerf_drawing::OpError>((**editor.drawing.shapes.last().unwrap()).clone())
    };
    let down = draw("line3d 0,0,0 10,0,-3 10,0,-5 10,0,-5").unwrap();
    assert_eq!((down.path.vertices.len(), down.z_mm), (3, Some(vec![0.0, -3.0, -5.0])));
    let round = draw("line3d 0,0,1 10,0,2 10,10,3 0,0,1 close").unwrap();
    assert_eq!((round.path.closed, round.z_mm), (true, Some(vec![1.0, 2.0, 3.0])));
    let told = draw("line3d 1,1,1 1,1,1").unwrap_err().to_string();
    assert_eq!(told, "all points of the line are the same place");
}
