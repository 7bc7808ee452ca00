//! Rows of the Profiler ledger that operations on a drawing show.

use kerf_drawing::{Choice, CutDepth, Drawing, Editor, Group, Kind, Shape, script};
use kerf_geom::{Point2, Polyarc, Vertex};

const SQ100: &str = "line 0,0 100,0 100,100 0,100 close";

/// An editor after these operations.
fn after(text: &str) -> Editor {
    let mut editor = Editor::default();
    run(&mut editor, text);
    editor
}

fn run(editor: &mut Editor, text: &str) -> Vec<String> {
    let ops = script(text).unwrap();
    let outcomes = ops.iter().map(|(n, op)| editor.apply(op).map_err(|e| format!("{n}: {e}")));
    outcomes.flat_map(|outcome| outcome.unwrap().warnings).collect()
}

fn refused(before: &str, text: &str) -> String {
    let mut editor = after(before);
    let was = editor.clone();
    let error = editor.apply(&script(text).unwrap()[0].1).unwrap_err().to_string();
    assert_eq!(editor, was, "{text} left something behind");
    error
}

fn shape(editor: &Editor, number: usize) -> &Shape {
    &editor.drawing.shapes[number - 1]
}

/// Vertices as `x,y` or `x,y,bulge`, rounded to the micrometre.
fn vertices(shape: &Shape) -> String {
    let round = |value: f64| (value * 1e6).round() / 1e6 + 0.0;
    let word = |v: &Vertex| {
        let at = format!("{},{}", round(v.at.x), round(v.at.y));
        if round(v.bulge) == 0.0 { at } else { format!("{at},{}", round(v.bulge)) }
    };
    let words: Vec<_> = shape.path.vertices.iter().map(word).collect();
    format!("{}{}", words.join(" "), if shape.is_closed() { " close" } else { "" })
}

fn bounds(drawing: &Drawing) -> String {
    let Some(bounds) = drawing.bounds() else { return "none".into() };
    let round = |value: f64| (value * 1e6).round() / 1e6 + 0.0;
    let (min, max) = (bounds.min, bounds.max);
    format!("{},{}..{},{}", round(min.x), round(min.y), round(max.x), round(max.y))
}

fn near(value: f64, expected: f64, within: f64) {
    assert!((value - expected).abs() <= within, "{value} is not {expected}");
}

#[test]
fn pro_draw_circle_type() {
    let editor = after("circle 50,50 25");
    let circle = shape(&editor, 1);
    assert_eq!(vertices(circle), "75,50,1 25,50,1 close");
    near(circle.path.signed_area(), 1963.495, 0.001);
    assert!(refused("", "circle 50,50 0").contains("the radius is 0: it must be above 0"));
}

#[test]
fn pro_draw_rect_type() {
    let editor = after("rect 10,10 60,40");
    assert_eq!(vertices(shape(&editor, 1)), "10,10 60,10 60,40 10,40 close");
}

#[test]
fn pro_draw_rect_wh() {
    let editor = after("rect 10,10 size 50,30");
    assert_eq!(bounds(&editor.drawing), "10,10..60,40");
    assert_eq!(shape(&editor, 1).start(), Point2::new(10.0, 10.0));
}

#[test]
fn pro_draw_rect_neg() {
    let editor = after("rect 60,40 size -50,-30");
    assert_eq!(bounds(&editor.drawing), "10,10..60,40");
    assert_eq!(shape(&editor, 1).start(), Point2::new(60.0, 40.0));
    assert!(refused("", "rect 0,0 size 0,5").contains("the width is 0"));
}

#[test]
fn pro_draw_point_type() {
    let editor = after("point 12.5,7");
    assert_eq!(shape(&editor, 1).kind(), Kind::Point);
    assert_eq!(vertices(shape(&editor, 1)), "12.5,7");
}

#[test]
fn pro_draw_line_type() {
    let editor = after("line 0,0 10,0 10,10");
    assert!(!shape(&editor, 1).is_closed());
    near(shape(&editor, 1).path.length(), 20.0, 1e-12);
}

#[test]
fn pro_draw_arc_type() {
    let editor = after("line 0,0,0.41421356237 10,0");
    let arc = shape(&editor, 1).path.segment(0).arc().unwrap();
    near(arc.radius(), 7.0711, 1e-4);
    near(shape(&editor, 1).path.bounds().min.y, -2.0711, 1e-4);
}

#[test]
fn pro_edit_select_first() {
    for op in [
        "move 1,1",
        "copy 1,1",
        "rotate 9",
        "scale 2",
        "mirror 0,0 0,1",
        "erase",
        "reverse",
        "group red",
        "clip",
        "pause on",
    ] {
        assert!(refused(SQ100, op).contains("no shapes selected"), "{op}");
    }
}

#[test]
fn pro_edit_move_rel() {
    let editor = after(&format!("{SQ100}; select all; move 30,-10"));
    assert_eq!(bounds(&editor.drawing), "30,-10..130,90");
    assert_eq!(shape(&editor, 1).start(), Point2::new(30.0, -10.0));
}

#[test]
fn pro_edit_copy() {
    let editor = after(&format!("{SQ100}; select all; group red; copy 200,0"));
    assert_eq!(editor.drawing.shapes.len(), 2);
    assert_eq!(vertices(shape(&editor, 1)), "0,0 100,0 100,100 0,100 close");
    assert_eq!(shape(&editor, 2).group, Group::Red);
    assert_eq!(bounds(&editor.drawing), "0,0..300,100");
}

#[test]
fn pro_edit_rotate_rel() {
    let editor = after(&format!("{SQ100}; select all; rotate 90"));
    assert_eq!(bounds(&editor.drawing), "-100,0..0,100");
}

#[test]
fn pro_edit_scale() {
    let editor = after(&format!("{SQ100}; select all; scale 2"));
    assert_eq!(bounds(&editor.drawing), "0,0..200,200");
    let made = format!("{SQ100}; select all");
    for wrong in ["scale 0", "scale -1"] {
        assert!(refused(&made, wrong).contains("it must be above 0"));
    }
}

#[test]
fn pro_edit_scale_all() {
    let text = format!("{SQ100}; circle 300,0 50; set black offset=3; select all; scale 0.5");
    let editor = after(&text);
    assert_eq!(bounds(&editor.drawing), "0,-25..175,50");
    assert_eq!(editor.drawing.settings(Group::Black).offset_mm, 3.0);
}

#[test]
fn pro_edit_mirror() {
    let mirrored = |line: &str| {
        let editor = after(&format!("line 10,5 20,5,0.5 20,9; select all; mirror {line}"));
        vertices(shape(&editor, 1))
    };
    assert_eq!(mirrored("0,0 0,1"), "-10,5 -20,5,-0.5 -20,9");
    assert_eq!(mirrored("0,0 1,1"), "5,10 5,20,-0.5 9,20");
    let square = |raw: &str| {
        let editor = after(&format!("{SQ100}; select all; mirror 0,0 0,1 {raw}"));
        shape(&editor, 1).path.signed_area()
    };
    assert_eq!((square(""), square("raw")), (10000.0, -10000.0));
}

#[test]
fn pro_edit_erase() {
    let editor = after("point 1,0; point 2,0; point 3,0; select 2; erase");
    let left: Vec<_> = editor.drawing.shapes.iter().map(|s| s.start().x).collect();
    assert_eq!(left, [1.0, 3.0]);
    assert_eq!(bounds(&editor.drawing), "1,0..3,0");
}

#[test]
fn pro_group_move() {
    let editor = after(&format!("{SQ100}; point 1,1; select 1; group red"));
    let groups: Vec<_> = editor.drawing.shapes.iter().map(|s| s.group).collect();
    assert_eq!(groups, [Group::Red, Group::Black]);
    assert_eq!(vertices(shape(&editor, 1)), "0,0 100,0 100,100 0,100 close");
}

#[test]
fn pro_group_copy() {
    let editor = after(&format!("{SQ100}; point 1,1; select 1; copy-to red"));
    assert_eq!(shape(&editor, 3).group, Group::Red);
    assert_eq!(vertices(shape(&editor, 3)), vertices(shape(&editor, 1)));
    assert_eq!(shape(&editor, 1).group, Group::Black);
}

#[test]
fn pro_group_multi_mmonly() {
    let error = refused(SQ100, "set red pass=4");
    assert!(error.contains("group red: multi-pass needs height type MM"), "{error}");
    let editor = after("set red height=-13 pass=4; set red height=thru");
    let red = editor.drawing.settings(Group::Red);
    assert_eq!((red.height, red.pass_mm), (CutDepth::Thru, None));
}

#[test]
fn pro_layout_left() {
    let editor = after("rect 30,-10 130,40; justify left");
    assert_eq!(bounds(&editor.drawing), "0,0..100,50");
}

fn solid() -> Editor {
    let path = Polyarc::lines([Point2::new(30.0, -10.0), Point2::new(130.0, 40.0)], false);
    Editor::of(Drawing::of([Shape::with_heights(path, vec![5.0, 12.0])]))
}

#[test]
fn pro_layout_surface3d() {
    let mut editor = solid();
    run(&mut editor, "justify surface");
    assert_eq!(shape(&editor, 1).z_mm, Some(vec![-7.0, 0.0]));
    assert_eq!(bounds(&editor.drawing), "0,0..100,50");
}

#[test]
fn pro_layout_bottom3d() {
    let mut editor = solid();
    run(&mut editor, "justify bottom -10");
    assert_eq!(shape(&editor, 1).z_mm, Some(vec![-10.0, -3.0]));
}

#[test]
fn pro_layout_no3d() {
    for op in ["justify surface", "justify bottom -10"] {
        let editor = after(&format!("rect 30,-10 130,40; {op}"));
        assert_eq!(bounds(&editor.drawing), "0,0..100,50");
        assert_eq!(shape(&editor, 1).z_mm, None);
    }
}

#[test]
fn pro_layout_rotate90() {
    let editor = after("line 0,0 200,0 200,100; rotate90");
    assert_eq!(vertices(shape(&editor, 1)), "100,0 100,200 0,200");
    assert_eq!(bounds(&editor.drawing), "0,0..100,200");
}

#[test]
fn pro_layout_rotate90x4() {
    let text = "line 30,-10 230,90,0.3 60,20";
    let turned = after(&format!("{text}; rotate90; rotate90; rotate90; rotate90"));
    let left = after(&format!("{text}; justify left"));
    assert_eq!(vertices(shape(&turned, 1)), vertices(shape(&left, 1)));
}

#[test]
fn pro_layout_mirror() {
    let editor = after("line 0,0 200,0,-0.5 200,50; mirror-drawing");
    assert_eq!(vertices(shape(&editor, 1)).split(' ').nth(1), Some("0,0,0.5"));
}

#[test]
fn pro_layout_mirrorx2() {
    let text = "line 30,-10 230,90,0.3 60,20 close";
    let twice = after(&format!("{text}; mirror-drawing; mirror-drawing"));
    let left = after(&format!("{text}; justify left"));
    assert_eq!(vertices(shape(&twice, 1)), vertices(shape(&left, 1)));
}

#[test]
fn pro_layout_origin_type() {
    let editor = after("line 30,40 50,50; origin 10,5");
    assert_eq!(vertices(shape(&editor, 1)), "20,35 40,45");
}

#[test]
fn pro_layout_cadorigin() {
    let text = "line 12,34 50,50; justify left; origin 3,4; origin -7,1";
    let editor = after(&format!("{text}; origin cad"));
    assert_eq!(shape(&editor, 1).start(), Point2::new(12.0, 34.0));
    let moved = after(&format!("{text}; select all; move 1,1; origin cad"));
    assert_eq!(shape(&moved, 1).start(), Point2::new(13.0, 35.0));
}

#[test]
fn pro_clipboard_copy() {
    let editor = after("point 1,0; point 2,0; point 3,0; select 1,3; group red; clip");
    assert_eq!((editor.clipboard.len(), editor.drawing.shapes.len()), (2, 3));
    assert!(editor.clipboard.iter().all(|shape| shape.group == Group::Red));
}

#[test]
fn pro_clipboard_clear() {
    let text = "point 1,0; select all; clip; clear-clipboard";
    assert!(refused(text, "paste 0,0").contains("clipboard empty"));
}

const CLIPPED: &str = "rect 30,40 80,60; select all; clip";

#[test]
fn pro_clipboard_paste() {
    let editor = after(&format!("{CLIPPED}; paste 0,0"));
    assert_eq!(shape(&editor, 2).path.bounds().max, Point2::new(50.0, 20.0));
    assert_eq!(editor.selection, [1]);
}

#[test]
fn pro_clipboard_paste_abs() {
    let pasted = |at: &str| {
        let editor = after(&format!("{CLIPPED}; paste absolute {at}; select 1; erase"));
        bounds(&editor.drawing)
    };
    assert_eq!(pasted("100,0"), "130,40..180,60");
    assert_eq!(pasted("0,0"), "30,40..80,60");
}

#[test]
fn pro_clipboard_paste_repeat() {
    let editor = after(&format!("{CLIPPED}; paste 0,0; paste 100,0"));
    assert_eq!(editor.drawing.shapes.len(), 3);
}

#[test]
fn pro_path_start_closed() {
    let editor = after(&format!("{SQ100}; start 1 50,-3"));
    assert_eq!(vertices(shape(&editor, 1)), "50,0 100,0 100,100 0,100 0,0 close");
    near(shape(&editor, 1).path.signed_area(), 10000.0, 1e-9);
    let again = after(&format!("{SQ100}; start 1 50,0; start 1 100,50"));
    assert_eq!(vertices(shape(&again, 1)), "100,50 100,100 0,100 0,0 100,0 close");
}

#[test]
fn pro_path_start_arc() {
    let editor = after("circle 0,0 25; start 1 0,25");
    let half = "0.414214";
    let expected = format!("0,25,{half} -25,0,1 25,0,{half} close");
    assert_eq!(vertices(shape(&editor, 1)), expected);
    let back = after("circle 0,0 25; start 1 0,25; start 1 25,0");
    assert_eq!(vertices(shape(&back, 1)), "25,0,1 -25,0,1 close");
}

#[test]
fn pro_path_start_open() {
    let start = |at: &str| {
        let editor = after(&format!("line 0,0 100,0; start 1 {at}"));
        shape(&editor, 1).start().x
    };
    assert_eq!((start("90,0"), start("10,0")), (100.0, 0.0));
}

#[test]
fn pro_path_reverse() {
    let once = after(&format!("{SQ100}; select all; reverse"));
    assert_eq!(vertices(shape(&once, 1)), "0,0 0,100 100,100 100,0 close");
    let arc = after("line 0,0,0.5 10,0; select all; reverse");
    assert_eq!(vertices(shape(&arc, 1)), "10,0,-0.5 0,0");
    let twice = after("line 0,0,0.5 10,0 20,7 close; select all; reverse; reverse");
    assert_eq!(vertices(shape(&twice, 1)), "0,0,0.5 10,0 20,7 close");
}

fn nest(sides: &[f64]) -> String {
    let square = |side: &f64| {
        let (a, b) = (50.0 - side / 2.0, 50.0 + side / 2.0);
        format!("line {a},{a} {a},{b} {b},{b} {b},{a} close")
    };
    sides.iter().map(square).collect::<Vec<_>>().join("; ")
}

fn areas(editor: &Editor) -> Vec<f64> {
    editor.drawing.shapes.iter().map(|shape| shape.path.signed_area()).collect()
}

#[test]
fn pro_path_autodir() {
    let editor = after(&format!("{}; directions auto", nest(&[100.0, 60.0])));
    assert_eq!(areas(&editor), [10000.0, -3600.0]);
    assert_eq!(shape(&editor, 2).start(), Point2::new(20.0, 20.0));
}

#[test]
fn pro_path_autodir_levels() {
    let editor = after(&format!("{}; directions auto", nest(&[100.0, 60.0, 20.0, 10.0])));
    assert_eq!(areas(&editor), [10000.0, -3600.0, 400.0, -100.0]);
}

#[test]
fn pro_path_autodir_open() {
    let editor = after(&format!("{}; line 30,40 70,40; directions auto", nest(&[100.0])));
    assert_eq!(vertices(shape(&editor, 2)), "30,40 70,40");
}

#[test]
fn pro_path_autodir_intersect() {
    let mut editor = after("rect 0,0 60,60; rect 50,50 99,99; select all; reverse");
    let warnings = run(&mut editor, "directions auto");
    assert_eq!(warnings, ["shapes 1 and 2 cross each other: check their directions"]);
    assert!(areas(&editor).iter().all(|area| *area > 0.0));
}

/// The x coordinates of starts, in cutting order.
fn order(editor: &Editor) -> String {
    let starts = editor.drawing.shapes.iter().map(|s| format!("{}", s.start().x));
    starts.collect::<Vec<_>>().join(" ")
}

#[test]
fn pro_sequence_full() {
    assert_eq!(order(&after("point 1,0; point 2,0; point 3,0; sequence 3,1,2")), "3 1 2");
}

#[test]
fn pro_sequence_full_deselect() {
    assert_eq!(order(&after("point 1,0; point 2,0; point 3,0; sequence 3,2")), "3 2 1");
}

const FOUR: &str = "point 1,0; point 2,0; point 3,0; point 4,0; select 2,4; group red";

#[test]
fn pro_sequence_group() {
    assert_eq!(order(&after(&format!("{FOUR}; sequence groups red,black"))), "2 4 1 3");
    // By any shape of each group: D, then A. Another of the same group changes nothing.
    for picked in ["4,1", "2,3", "4,2,1", "4"] {
        assert_eq!(order(&after(&format!("{FOUR}; sequence groups of {picked}"))), "2 4 1 3");
    }
    assert_eq!(order(&after(&format!("{FOUR}; sequence groups of 3,4"))), "1 3 2 4");
    assert!(refused(FOUR, "sequence groups of 5").contains("no shape 5"));
}

#[test]
fn pro_sequence_reverse() {
    let mut editor = after(&format!("{FOUR}; sequence reverse"));
    assert_eq!(order(&editor), "4 3 2 1");
    let selected: Vec<_> =
        editor.selection.iter().map(|n| shape(&editor, n + 1).start().x).collect();
    assert_eq!(selected, [4.0, 2.0]);
    editor = after(&nest(&[20.0, 100.0]));
    let told = run(&mut editor, "sequence reverse");
    assert_eq!(told, ["shape 1 is cut before shape 2, which lies in it"]);
}

#[test]
fn pro_sequence_auto_contain() {
    let text = nest(&[100.0, 20.0, 60.0]);
    for from in ["-1000,0", "1000,0", "0,1000", "50,50"] {
        let editor = after(&format!("{text}; sequence auto {from}"));
        assert_eq!(order(&editor), "40 20 0", "from {from}");
    }
}

fn grid() -> String {
    let at = |n: usize| (200 * (n % 3), 200 * (n / 3));
    let square = |n| {
        let (x, y) = at(n);
        format!("rect {x},{y} size 50,50")
    };
    (0..9).rev().map(square).collect::<Vec<_>>().join("; ")
}

fn auto(from: &str) -> String {
    let editor = after(&format!("{}; sequence auto {from}", grid()));
    let starts = editor.drawing.shapes.iter().map(|s| s.start());
    let words: Vec<_> = starts.map(|p| format!("{}{}", p.x / 200.0, p.y / 200.0)).collect();
    words.join(" ")
}

#[test]
fn pro_sequence_auto_s() {
    assert_eq!(auto("-1000,0"), "00 01 02 10 11 12 20 21 22");
}

#[test]
fn pro_sequence_auto_left() {
    assert_eq!(auto("-1000,0"), "00 01 02 10 11 12 20 21 22");
}

#[test]
fn pro_sequence_auto_right() {
    assert_eq!(auto("1000,0"), "20 21 22 10 11 12 00 01 02");
}

#[test]
fn pro_sequence_auto_bottom() {
    assert_eq!(auto("0,-1000"), "00 10 20 01 11 21 02 12 22");
}

#[test]
fn pro_sequence_auto_top() {
    assert_eq!(auto("0,1000"), "02 12 22 01 11 21 00 10 20");
}

#[test]
fn pro_sequence_auto_startpoint() {
    let text = "rect 0,0 100,100; rect 50,150 150,250; start 2 50,150; start 1 100,100";
    let editor = after(&format!("{text}; sequence auto 60,180"));
    assert_eq!(order(&editor), "50 100");
}

#[test]
fn pro_sequence_level() {
    // Two plates, holes 1, 2, 3 (with an island in 3) and 5, 6.
    let text = "rect 10,10 20,20; rect 30,10 40,20; rect 50,10 70,30; rect 55,15 60,20; \
        rect 0,0 100,100; rect 210,10 220,20; rect 230,10 240,20; rect 200,0 300,100";
    let editor = after(text);
    assert_eq!(order(&editor), "10 30 50 55 0 210 230 200");
    let moved = after(&format!("{text}; sequence level 3,1,2"));
    assert_eq!(order(&moved), "50 55 10 30 0 210 230 200");
    // The plates are a level of their own: each goes with all that lies in it.
    let plates = after(&format!("{text}; sequence level 8,5"));
    assert_eq!(order(&plates), "210 230 200 10 30 50 55 0");
    assert!(refused(text, "sequence level 1,6").contains("does not lie in the same shape"));
}

#[test]
fn pro_sequence_numbers() {
    let editor = after("point 1,0; point 2,0; sequence reverse; point 3,0");
    assert_eq!(order(&editor), "2 1 3");
}

#[test]
fn changes_are_undone_and_made_again() {
    let mut editor = after(&format!("{SQ100}; select all; move 5,0; erase"));
    let empty = editor.drawing.clone();
    editor.undo().unwrap();
    assert_eq!(bounds(&editor.drawing), "5,0..105,100");
    assert_eq!(editor.selection, [0]);
    editor.undo().unwrap();
    assert_eq!(bounds(&editor.drawing), "0,0..100,100");
    editor.redo().unwrap();
    editor.redo().unwrap();
    assert_eq!(editor.drawing, empty);
    assert!(editor.redo().is_err());
    editor.undo().unwrap();
    run(&mut editor, "move 1,0");
    assert!(editor.redo().is_err(), "a new change ends what could be made again");
}

#[test]
fn a_selection_follows_its_shapes() {
    let mut editor = after("point 1,0; point 2,0; point 3,0; select 1; select add 3");
    assert_eq!(editor.selection, [0, 2]);
    run(&mut editor, "select remove 1");
    assert_eq!(editor.selection, [2]);
    assert!(matches!(
        editor.apply(&kerf_drawing::Operation::Select {
            choice: Choice::Shapes(vec![9]),
            how: kerf_drawing::How::New
        }),
        Err(kerf_drawing::OpError::NoShape { number: 9, count: 3 })
    ));
}
