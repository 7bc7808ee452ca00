//! SVG read and written.

use kerf_drawing::{Drawing, Editor, Group, Kind, script};
use kerf_formats::{Imported, svg};

/// An SVG of 100 × 50 mm, a unit a millimetre.
fn file(body: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" \
         viewBox=\"0 0 100 50\">{body}</svg>"
    )
}

fn drawn(body: &str) -> Imported {
    svg::read(file(body).as_bytes())
}

/// Vertices as `x,y` or `x,y,bulge`, a shape a word list.
fn shapes(drawing: &Drawing) -> Vec<String> {
    let round = |value: f64| (value * 1e3).round() / 1e3 + 0.0;
    let vertex = |v: &kerf_geom::Vertex| {
        let at = format!("{},{}", round(v.at.x), round(v.at.y));
        if round(v.bulge) == 0.0 { at } else { format!("{at},{}", round(v.bulge)) }
    };
    let shape = |shape: &kerf_drawing::Shape| {
        let words: Vec<_> = shape.path.vertices.iter().map(vertex).collect();
        format!("{}{}", words.join(" "), if shape.is_closed() { " close" } else { "" })
    };
    drawing.shapes.iter().map(|s| shape(s)).collect()
}

fn check(body: &str, expected: &[&str]) {
    let read = drawn(body);
    assert_eq!(read.findings, [], "{body}");
    assert_eq!(shapes(&read.drawing), expected, "{body}");
}

#[test]
fn y_is_turned_up_and_the_lower_edge_is_zero() {
    check("<line x1=\"1\" y1=\"50\" x2=\"10\" y2=\"40\"/>", &["1,0 10,10"]);
}

#[test]
fn basic_shapes_are_drawn() {
    check(
        "<rect x=\"10\" y=\"10\" width=\"20\" height=\"30\"/>",
        &["10,40 30,40 30,10 10,10 close"],
    );
    check("<circle cx=\"50\" cy=\"25\" r=\"5\"/>", &["55,25,1 45,25,1 close"]);
    check("<polyline points=\"0,50 10,50 10,40\"/>", &["0,0 10,0 10,10"]);
    check("<polygon points=\"0,50 10,50 10,40\"/>", &["0,0 10,0 10,10 close"]);
    let round = drawn("<rect width=\"20\" height=\"10\" rx=\"2\"/>");
    assert_eq!(round.drawing.shapes[0].path.vertices.len(), 8);
    let ellipse = drawn("<ellipse cx=\"50\" cy=\"25\" rx=\"20\" ry=\"10\"/>");
    let area = ellipse.drawing.shapes[0].path.signed_area();
    assert!((area - 200.0 * std::f64::consts::PI).abs() < 0.05, "{area}");
}

#[test]
fn path_data_of_every_kind() {
    check("<path d=\"M0 50 h10 v-10 H0 z\"/>", &["0,0 10,0 10,10 0,10 close"]);
    check("<path d=\"m10 50 l5 0 m5 0 l5 0\"/>", &["10,0 15,0", "20,0 25,0"]);
    // A quarter turn that is counter-clockwise once Y is up.
    check("<path d=\"M10 50 A10 10 0 0 0 0 40\"/>", &["10,0,0.414 0,10"]);
    check("<path d=\"M10 50 A10 10 0 1 0 0 40\"/>", &["10,0,0.668 17.071,17.071,0.668 0,10"]);
    let curve = drawn("<path d=\"M0 50 C0 40 20 40 20 50 S40 60 40 50\"/>");
    let path = &curve.drawing.shapes[0].path;
    let bounds = path.bounds();
    assert!((bounds.max.y - 7.5).abs() < 1e-2 && (bounds.min.y + 7.5).abs() < 1e-2, "{bounds:?}");
    let quadratic = drawn("<path d=\"M0 50 Q10 30 20 50 T40 50\"/>");
    assert!((quadratic.drawing.shapes[0].path.bounds().min.y + 10.0).abs() < 1e-2);
}

#[test]
fn arcs_of_ellipses_are_as_long_in_either_direction() {
    for (large, length) in [(0, 5.539), (1, 91.345)] {
        for sweep in [0, 1] {
            let arc = format!("<path d=\"M50,25 A20,10 30 {large} {sweep} 55.5,25.5\"/>");
            let read = drawn(&arc);
            let path = &read.drawing.shapes[0].path;
            assert!((path.length() - length).abs() < 0.01, "{arc}: {}", path.length());
            assert!(path.vertices.len() < 150, "{arc}: {}", path.vertices.len());
        }
    }
}

#[test]
fn transforms_are_done_from_the_inside_out() {
    let line = "<line x1=\"0\" y1=\"0\" x2=\"1\" y2=\"0\"";
    check(&format!("{line} transform=\"translate(10 20)\"/>"), &["10,30 11,30"]);
    check(
        &format!("<g transform=\"translate(10 20)\">{line} transform=\"scale(2)\"/></g>"),
        &["10,30 12,30"],
    );
    check(&format!("{line} transform=\"translate(10 20) rotate(90)\"/>"), &["10,30 10,29"]);
    check("<circle r=\"5\" transform=\"translate(50 25) scale(2)\"/>", &["60,25,1 40,25,1 close"]);
}

#[test]
fn what_is_used_is_drawn_where_it_is_used() {
    let body = "<defs><circle id=\"hole\" cx=\"5\" cy=\"5\" r=\"2\"/></defs>\
        <use href=\"#hole\"/><use href=\"#hole\" x=\"10\"/>";
    check(body, &["7,45,1 3,45,1 close", "17,45,1 13,45,1 close"]);
}

#[test]
fn the_size_of_the_page_is_the_scale() {
    let line = "<line x2=\"96\" y2=\"0\"/>";
    let long = |head: &str| {
        let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" {head}>{line}</svg>");
        svg::read(text.as_bytes()).drawing.shapes[0].path.length()
    };
    let near = |head: &str, expected: f64| {
        let found = long(head);
        assert!((found - expected).abs() < 1e-9, "{head}: {found}");
    };
    near("", 25.4);
    near("width=\"10in\" viewBox=\"0 0 960 960\"", 25.4);
    near("width=\"96mm\" viewBox=\"0 0 96 96\"", 96.0);
    near("viewBox=\"0 0 10 10\"", 25.4);
}

#[test]
fn a_view_is_fitted_into_its_room_as_the_file_says() {
    let line = "<line x2=\"100\" y2=\"0\"/>";
    let fitted = |aspect: &str, expected: &str| {
        let head = format!("width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 100\" {aspect}");
        let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" {head}>{line}</svg>");
        assert_eq!(shapes(&svg::read(text.as_bytes()).drawing), [expected], "{aspect}");
    };
    fitted("", "25,50 75,50");
    fitted("preserveAspectRatio=\"xMinYMin\"", "0,50 50,50");
    fitted("preserveAspectRatio=\"xMaxYMax meet\"", "50,50 100,50");
    fitted("preserveAspectRatio=\"none\"", "0,50 100,50");
    fitted("preserveAspectRatio=\"xMidYMid slice\"", "0,75 100,75");
    let rect = "<rect width=\"10\" height=\"10\"/>";
    let symbol = format!(
        "<symbol id=\"s\" viewBox=\"0 0 10 10\">{rect}</symbol>\
         <use href=\"#s\" x=\"5\" y=\"5\" width=\"20\" height=\"20\"/>"
    );
    check(&symbol, &["5,45 25,45 25,25 5,25 close"]);
    let within = "<svg x=\"5\" y=\"5\" width=\"20\" height=\"20\" viewBox=\"10 0 10 10\">\
        <rect x=\"10\" width=\"10\" height=\"10\"/></svg>";
    check(within, &["5,45 25,45 25,25 5,25 close"]);
}

#[test]
fn segments_without_length_are_told() {
    let read = drawn("<polygon points=\"0,0 0,0 10,0 10,10\"/>\n<path d=\"M0 0h0h5v0v5\"/>");
    let told: Vec<_> = read.findings.iter().map(|it| (it.line, it.text.as_str())).collect();
    let expected =
        ["polygon", "path"].map(|name| format!("<{name}>: segments without length left out: "));
    assert_eq!(told, [(1, &*format!("{}1", expected[0])), (2, &*format!("{}2", expected[1]))]);
}

#[test]
fn layers_and_what_is_left_out_are_told() {
    let read = drawn(
        "<g id=\"cuts\"><line x2=\"1\"/></g><g id=\"holes\"><circle r=\"1\"/><text>a</text></g>\
         <g display=\"none\"><line x2=\"1\"/></g><circle r=\"0\"/>",
    );
    let layers: Vec<_> =
        read.layers.iter().map(|(name, shapes)| (name.as_str(), shapes.len())).collect();
    assert_eq!(layers, [("cuts", 1), ("holes", 1)]);
    assert_eq!(read.skipped.as_deref(), Some("skipped: (hidden) 1, <text> 1"));
    let told: Vec<_> = read.findings.iter().map(|it| (it.column, it.text.as_str())).collect();
    assert_eq!(
        told[1..3].iter().map(|it| it.1).collect::<Vec<_>>(),
        ["<g> is hidden (display: none): left out", "<circle> without a size: left out",]
    );
}

#[test]
fn what_is_no_svg_is_told() {
    let told = |bytes: &[u8]| svg::read(bytes).findings[0].text.clone();
    assert!(told(b"\x89PNG").starts_with("the file is no SVG"));
    assert!(told(b"<html/>").starts_with("the file is no SVG"));
    let read = drawn("<path d=\"M0 50 L10 50 oops\"/><g id=\"me\"><use href=\"#me\"/></g>");
    assert_eq!(read.drawing.shapes.len(), 1, "what comes before a mistake is kept");
    let told: Vec<_> = read.findings.iter().map(|finding| finding.text.as_str()).collect();
    assert_eq!(told[0], "<path>: unexpected data at position 14: the rest is left out");
    assert!(told[1].starts_with("elements within elements, more than 200, or one within itself"));
}

#[test]
fn a_drawing_comes_back_from_svg() {
    let text = "circle 50,50 25; line 0,0,0.3 10,1 20,5 close; line -5,5 9,9,-0.7 9,20; point -7,-3; select 1,2; group red";
    let mut editor = Editor::default();
    for (_, op) in script(text).unwrap() {
        editor.apply(&op).unwrap();
    }
    let written = svg::write(&editor.drawing);
    let back = svg::read(written.as_bytes());
    assert_eq!(back.findings, []);
    // Groups come one after the other.
    let mut old = editor.drawing.clone();
    old.shapes.sort_by_key(|shape| shape.group);
    assert_eq!(shapes(&back.drawing), shapes(&old));
    assert_eq!(back.drawing.shapes[1].kind(), Kind::Point);
    assert!(back.layers.iter().any(|(name, _)| name == Group::Red.name()));
}
