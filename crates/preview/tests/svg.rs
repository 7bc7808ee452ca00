//! The SVG read back: true to scale, arcs exact, nothing shown that should not be.

use crate::common;
use crate::common::{arc, cut, jog, scene};
use kerf_diag::Severity;
use kerf_preview::{Finding, Options, Scene, Segment, TableView, Unit, svg};
use roxmltree::{Document, Node};
use std::f64::consts::{PI, TAU};

fn draw(scene: &Scene) -> String {
    svg(scene, &Options::default())
}

fn layer<'a>(doc: &'a Document<'_>, id: &str) -> Option<Node<'a, 'a>> {
    doc.descendants().find(|n| n.attribute("id") == Some(id))
}

fn paths(doc: &Document<'_>, id: &str) -> Vec<String> {
    let Some(layer) = layer(doc, id) else { return Vec::new() };
    layer.descendants().filter_map(|n| n.attribute("d").map(str::to_owned)).collect()
}

fn words(doc: &Document<'_>) -> String {
    let texts = doc.descendants().filter(|n| n.has_tag_name("text"));
    texts.filter_map(|n| n.text()).collect::<Vec<_>>().join("\n")
}

/// Points of a path and, for arcs, the centre that its ends and radius give.
fn points(data: &str) -> Vec<([f64; 2], Option<[f64; 2]>)> {
    let spaced: String = data
        .chars()
        .flat_map(|c| if c.is_alphabetic() { vec![' ', c, ' '] } else { vec![c] })
        .collect();
    let mut words = spaced.split_whitespace().peekable();
    let (mut at, mut command, mut out) = ([0.0; 2], 'M', Vec::new());
    while let Some(word) = words.peek() {
        if let Some(letter) = word.chars().next().filter(char::is_ascii_alphabetic) {
            command = letter;
            words.next();
            if letter == 'z' {
                continue;
            }
        }
        let mut number = || words.next().unwrap().parse::<f64>().unwrap();
        let mut centre = None;
        let by = match command {
            'M' | 'm' | 'l' => [number(), number()],
            'h' => [number(), 0.0],
            'v' => [0.0, number()],
            'a' => {
                let (r, _, _, large, flag) = (number(), number(), number(), number(), number());
                assert_eq!(large, 0.0);
                let by = [number(), number()];
                centre = Some(centre_of(at, by, r, flag == 1.0));
                by
            }
            other => panic!("unexpected {other}"),
        };
        at = if command == 'M' { by } else { [at[0] + by[0], at[1] + by[1]] };
        out.push((at, centre));
    }
    out
}

/// SVG implementation notes, "conversion from endpoint to center", for equal radii.
fn centre_of(from: [f64; 2], by: [f64; 2], r: f64, positive: bool) -> [f64; 2] {
    let half = by[0].hypot(by[1]) / 2.0;
    let off = (r * r - half * half).max(0.0).sqrt() / (2.0 * half);
    let side = if positive { off } else { -off };
    [from[0] + by[0] / 2.0 - by[1] * side, from[1] + by[1] / 2.0 + by[0] * side]
}

fn near(a: [f64; 2], b: [f64; 2], within: f64) {
    assert!((a[0] - b[0]).hypot(a[1] - b[1]) <= within, "{a:?} is not {b:?}");
}

#[test]
fn one_user_unit_is_a_millimetre_on_paper() {
    let text = draw(&scene(vec![cut([0.0, 0.0, -1.0], [100.0, 50.0, -1.0])]));
    let doc = Document::parse(&text).unwrap();
    let root = doc.root_element();
    let view: Vec<f64> =
        root.attribute("viewBox").unwrap().split(' ').map(|v| v.parse().unwrap()).collect();
    for (name, size) in [("width", view[2]), ("height", view[3])] {
        let shown = root.attribute(name).unwrap().strip_suffix("mm").unwrap();
        assert_eq!(shown.parse::<f64>().unwrap(), size);
    }
    let cuts = layer(&doc, "cuts").unwrap().first_element_child().unwrap();
    assert_eq!(cuts.attribute("transform"), Some("scale(1 -1)"));
    assert_eq!(paths(&doc, "cuts"), ["M0 0l100 50"]);
}

/// Draws one arc and checks every piece of it against the true circle.
fn check_arc(start: [f64; 2], centre: [f64; 2], sweep: f64) {
    let segment = arc([start[0], start[1], -1.0], centre, sweep, -1.0);
    let end = [segment.to[0], segment.to[1]];
    let text = draw(&scene(vec![segment]));
    let doc = Document::parse(&text).unwrap();
    let points = points(&paths(&doc, "cuts")[0]);
    near(points[0].0, start, 1e-3);
    near(points.last().unwrap().0, end, 1e-3);
    for (_, found) in &points[1..] {
        near(found.unwrap(), centre, 4e-3);
    }
    let mut turned = 0.0;
    for pair in points.windows(2) {
        let [a, b] = [pair[0].0, pair[1].0].map(|p| [p[0] - centre[0], p[1] - centre[1]]);
        turned += (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
    }
    assert!((turned - sweep).abs() < 1e-3, "turned {turned} instead of {sweep}");
}

#[test]
fn arcs_are_exact() {
    check_arc([10.0, 0.0], [0.0, 0.0], PI / 2.0);
    check_arc([10.0, 0.0], [0.0, 0.0], -PI);
    check_arc([300.123, 45.678], [250.0, 77.7], 1.9 * PI);
    check_arc([130.0, 40.0], [50.0, 40.0], TAU);
    check_arc([53.0, 40.0], [50.0, 40.0], -2.5 * TAU);
}

#[test]
fn jogs_are_red_and_dashed_or_absent() {
    let mut scene = scene(vec![
        jog([0.0, 0.0, 5.0], [20.0, 10.0, 5.0]),
        cut([20.0, 10.0, 5.0], [20.0, 10.0, -1.0]),
        cut([20.0, 10.0, -1.0], [50.0, 10.0, -1.0]),
    ]);
    let text = draw(&scene);
    let doc = Document::parse(&text).unwrap();
    let path = layer(&doc, "jogs").unwrap().descendants().find(|n| n.has_tag_name("path")).unwrap();
    assert_eq!(
        (path.attribute("d"), path.attribute("stroke")),
        (Some("M0 0l20 10"), Some("#d62828"))
    );
    assert!(path.attribute("stroke-dasharray").is_some());
    scene.show_jogs = false;
    let text = draw(&scene);
    let doc = Document::parse(&text).unwrap();
    assert!(layer(&doc, "jogs").is_none() && !text.contains("#d62828"), "{text}");
    assert!(!words(&doc).contains("jog\n"));
}

#[test]
fn hidden_jogs_take_no_room() {
    let mut scene =
        scene(vec![cut([0.0; 3], [50.0, 50.0, 0.0]), jog([50.0, 50.0, 0.0], [900.0, 0.0, 9.0])]);
    let width = |scene: &Scene| {
        let text = draw(scene);
        let doc = Document::parse(&text).unwrap();
        doc.root_element()
            .attribute("width")
            .unwrap()
            .trim_end_matches("mm")
            .parse::<f64>()
            .unwrap()
    };
    assert!(width(&scene) > 900.0);
    scene.show_jogs = false;
    assert!(width(&scene) < 120.0);
}

/// Perceived lightness from 0 to 100.
fn lightness(hex: &str) -> f64 {
    let channel = |i: usize| {
        let v = f64::from(u8::from_str_radix(&hex[i..i + 2], 16).unwrap()) / 255.0;
        if v <= 0.040_45 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
    };
    116.0 * (0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5)).cbrt() - 16.0
}

#[test]
fn deeper_cuts_are_darker_and_lie_on_top() {
    // From the deepest up, so that the order on paper is not the order of the program.
    let at = |z: f64, y: f64| cut([0.0, y, z], [90.0, y, z]);
    let text = draw(&scene(vec![at(-12.0, 0.0), at(-8.0, 10.0), at(-4.0, 20.0), at(-1.0, 30.0)]));
    let doc = Document::parse(&text).unwrap();
    let drawn = layer(&doc, "cuts").unwrap();
    let strokes: Vec<&str> = drawn.descendants().filter_map(|n| n.attribute("stroke")).collect();
    assert_eq!(strokes.len(), 4);
    assert!(strokes.windows(2).all(|w| lightness(w[0]) > lightness(w[1]) + 5.0), "{strokes:?}");
    let last = paths(&doc, "cuts").pop().unwrap();
    assert_eq!(last, "M0 0h90");
}

#[test]
fn a_ramp_changes_its_shade_on_the_way() {
    let text = draw(&scene(vec![cut([0.0, 0.0, 2.0], [180.0, 0.0, -16.0])]));
    let doc = Document::parse(&text).unwrap();
    let drawn = paths(&doc, "cuts");
    assert_eq!(drawn.len(), 17, "above the surface and sixteen shades");
    assert_eq!((drawn[0].as_str(), drawn[16].as_str()), ("M0 0h20", "M170 0h10"));
}

#[test]
fn a_straight_plunge_is_a_dot_in_the_shade_of_its_depth() {
    let text = draw(&scene(vec![
        cut([5.0, 5.0, 5.0], [5.0, 5.0, -8.0]),
        cut([5.0, 5.0, -8.0], [5.0, 5.0, 5.0]),
        cut([50.0, 5.0, 5.0], [50.0, 5.0, -2.0]),
    ]));
    let doc = Document::parse(&text).unwrap();
    assert_eq!(paths(&doc, "plunges").len(), 2);
    assert!(layer(&doc, "cuts").is_none());
}

#[test]
fn table_and_grid_follow_vp() {
    let mut scene = scene(vec![cut([0.0, 0.0, -1.0], [500.0, 250.0, -1.0])]);
    scene.unit = Unit::INCH;
    let vp = |w: f64, h: f64, grid: f64| {
        Some(TableView {
            origin: [-10.0, -20.0],
            size_mm: [w * 25.4, h * 25.4, 101.6],
            grid_mm: grid * 25.4,
        })
    };
    let facts = |scene: &Scene| {
        let text = draw(scene);
        let doc = Document::parse(&text).unwrap();
        (
            paths(&doc, "table-edge")[0].clone(),
            paths(&doc, "grid").pop().unwrap().matches('m').count() + 1,
            words(&doc),
        )
    };
    scene.table = vp(24.0, 18.0, 6.0);
    let (edge, lines, words) = facts(&scene);
    assert_eq!(edge, "M-10 -437.2h609.6v457.2h-609.6z");
    assert_eq!(lines, 5 + 4);
    assert!(words.contains("24 × 18 × 4 in") && words.contains("\n6 in\n"), "{words}");
    scene.table = vp(24.0, 18.0, 12.0);
    assert_eq!(facts(&scene).1, 3 + 2);
}

#[test]
fn a_small_part_on_a_large_table_is_drawn_large() {
    let mut scene = scene(vec![cut([0.0, 0.0, -1.0], [50.0, 40.0, -1.0])]);
    scene.table =
        Some(TableView { origin: [0.0; 2], size_mm: [2438.4, 1219.2, 152.4], grid_mm: 152.4 });
    let text = draw(&scene);
    let doc = Document::parse(&text).unwrap();
    let width = doc.root_element().attribute("width").unwrap();
    assert!(width.trim_end_matches("mm").parse::<f64>().unwrap() < 120.0, "{width}");
}

#[test]
fn the_legend_says_what_the_program_does() {
    let mut scene = scene(vec![cut([0.0, 0.0, 0.0], [254.0, 127.0, -6.35])]);
    scene.unit = Unit::INCH;
    scene.duration_s = 3725.0;
    scene.cut_mm = 2540.0;
    scene.findings.push(Finding { severity: Severity::Warning, text: "deep".into(), line: 7 });
    let text = draw(&scene);
    let words = words(&Document::parse(&text).unwrap());
    for expected in
        ["1:02:05", "100.00 in", "1 warning", "• warning, line 7: deep", "10.000", "−0.250"]
    {
        assert!(words.contains(expected), "{expected} is missing in\n{words}");
    }
}

#[test]
fn titles_and_names_are_escaped() {
    let mut scene = scene(vec![cut([0.0; 3], [10.0, 0.0, 0.0])]);
    scene.title = "</title><script>\"A & B\"\u{7}\0".into();
    let text = draw(&scene);
    let doc = Document::parse(&text).unwrap();
    let title = doc.descendants().find(|n| n.has_tag_name("title")).unwrap();
    assert_eq!(title.text(), Some("</title><script>\"A & B\"\u{fffd}\u{fffd}"));
    assert!(!doc.descendants().any(|n| n.has_tag_name("script")));
}

#[test]
fn odd_numbers_and_empty_scenes_give_a_picture() {
    for text in [draw(&Scene::default()), draw(&common::odd())] {
        let doc = Document::parse(&text).unwrap();
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        assert!(layer(&doc, "legend").is_some());
    }
    let text = draw(&common::odd());
    let words = words(&Document::parse(&text).unwrap());
    assert!(words.contains(&format!("{} moves have no place on paper", common::ODD)), "{words}");
}

#[test]
fn a_part_far_away_keeps_its_precision() {
    let x = 5.0e6;
    let text = draw(&scene(vec![cut([x, 0.0, -1.0], [x + 4.125, 2.0, -1.0])]));
    let doc = Document::parse(&text).unwrap();
    let drawn = points(&paths(&doc, "cuts")[0]);
    assert!(drawn[0].0[0].abs() < 100.0, "{drawn:?}");
    near([drawn[1].0[0] - drawn[0].0[0], drawn[1].0[1]], [4.125, 2.0], 1e-9);
    assert!(text.contains("less 5000000, 0"));
}

/// A square spiral of many short moves with steps of a hair's breadth between them.
fn many(count: u32) -> Vec<Segment> {
    let place = |i: u32| {
        let a = f64::from(i) * 0.001;
        let r = 100.0 + 0.002 * a;
        [r * a.cos(), r * a.sin(), -1.0]
    };
    (0..count).map(|i| cut(place(i), place(i + 1))).collect()
}

#[test]
fn very_long_programs_are_simplified_within_the_stated_distance() {
    let options = Options { detail_limit: 1000, ..Options::default() };
    let text = svg(&scene(many(20_000)), &options);
    let doc = Document::parse(&text).unwrap();
    let drawn = points(&paths(&doc, "cuts")[0]);
    assert!(drawn.len() < 2000, "{}", drawn.len());
    assert!(words(&doc).contains("simplified, within"));
    let said = text.split("within ").nth(1).unwrap().split(' ').next().unwrap();
    let within: f64 = said.parse().unwrap();
    for pair in drawn.windows(2) {
        let middle = [0, 1].map(|i| (pair[0].0[i] + pair[1].0[i]) / 2.0);
        let off = 100.0 - middle[0].hypot(middle[1]);
        assert!((-0.1..within + 1e-3).contains(&off), "{off} of {within}");
    }
    let whole = draw(&scene(many(3000)));
    assert!(!whole.contains("simplified"));
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    assert_eq!(draw(&common::plate()), draw(&common::plate()));
}

#[test]
fn the_motion_of_a_plate_reads_as_expected() {
    let text = draw(&common::plate());
    let doc = Document::parse(&text).unwrap();
    let mut found = String::new();
    for id in ["cutter", "cuts", "jogs", "plunges", "ends"] {
        found += &format!("{id}\n");
        for node in layer(&doc, id).into_iter().flat_map(|l| l.descendants()) {
            let colour = node.attribute("stroke").or(node.attribute("fill")).unwrap_or_default();
            if let Some(data) = node.attribute("d") {
                found += &format!("  {colour} {data}\n");
            }
        }
    }
    common::golden("plate.txt", &found);
}
