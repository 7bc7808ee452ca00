//! DXF read: rows of the Profiler ledger, and files made to hurt.

use kerf_drawing::{Group, Kind, Shape};
use kerf_formats::Imported;
use kerf_formats::dxf::{Options, read};

/// A file of these entities; blanks and slashes part the pairs: `0 LINE/10 0/20 0`.
fn file(entities: &str) -> String {
    let pairs = entities.split('/').map(|pair| pair.trim().replacen(' ', "\n", 1) + "\n");
    let body: String = pairs.collect();
    format!("0\nSECTION\n2\nENTITIES\n{body}0\nENDSEC\n0\nEOF\n")
}

fn drawn(entities: &str) -> Imported {
    read(file(entities).as_bytes(), &Options::default())
}

fn told(read: &Imported) -> Vec<String> {
    read.findings.iter().map(|finding| finding.text.clone()).collect()
}

/// The only shape; nothing to tell but that its group is 3D where it is.
fn only(entities: &str) -> Shape {
    let read = drawn(entities);
    assert_eq!(read.drawing.shapes.len(), 1);
    let three_d = "group black is 3D now: its shapes have heights of their own";
    let expected = read.drawing.shapes[0].z_mm.iter().map(|_| three_d.to_owned());
    assert_eq!(told(&read), expected.collect::<Vec<_>>());
    read.drawing.shapes[0].as_ref().clone()
}

fn near(value: f64, expected: f64, within: f64) {
    assert!((value - expected).abs() <= within, "{value} is not {expected}");
}

const HEAD: &str = "0 POLYLINE/8 0/66 1";

fn polyline(flags: i32, vertices: &[(f64, f64, f64, f64)]) -> String {
    let vertex = |(x, y, z, bulge): &(f64, f64, f64, f64)| {
        format!("/0 VERTEX/8 0/10 {x}/20 {y}/30 {z}/42 {bulge}")
    };
    let vertices: String = vertices.iter().map(vertex).collect();
    format!("{HEAD}/70 {flags}{vertices}/0 SEQEND")
}

#[test]
fn pro_import_dxf_open() {
    let corners = [(0.0, 0.0), (100.0, 0.0), (100.0, 50.0), (0.0, 50.0)];
    let text = polyline(1, &corners.map(|(x, y)| (x, y, 0.0, 0.0)));
    let header = "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n";
    let read = read((header.to_owned() + &file(&text)).as_bytes(), &Options::default());
    let bounds = read.drawing.bounds().unwrap();
    assert_eq!((bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y), (0.0, 0.0, 100.0, 50.0));
    assert_eq!(read.drawing.shapes.len(), 1);
}

#[test]
fn pro_import_dxf_polyline() {
    let circle = only(&polyline(1, &[(0.0, 0.0, 0.0, 1.0), (10.0, 0.0, 0.0, 1.0)]));
    assert!(circle.is_closed() && circle.path.vertices.len() == 2);
    near(circle.path.signed_area(), 78.540, 1e-3);
    assert!(!only(&polyline(0, &[(0.0, 0.0, 0.0, 0.0), (10.0, 0.0, 0.0, 0.0)])).is_closed());
    let solid = only(&polyline(8, &[(0.0, 0.0, 1.0, 0.0), (10.0, 0.0, -2.5, 0.0)]));
    assert_eq!(solid.z_mm, Some(vec![1.0, -2.5]));
}

#[test]
fn pro_import_dxf_lwpolyline() {
    let light = only("0 LWPOLYLINE/90 3/70 0/10 0/20 0/10 100/20 0/42 0.414214/10 100/20 100");
    let arc = light.path.segment(1).arc().unwrap();
    near(arc.radius(), 70.711, 1e-3);
    near(arc.centre.x, 50.0, 1e-3);
    near(arc.centre.y, 50.0, 1e-3);
    let old = only(&polyline(
        0,
        &[(0.0, 0.0, 0.0, 0.0), (100.0, 0.0, 0.0, 0.414214), (100.0, 100.0, 0.0, 0.0)],
    ));
    assert_eq!(light.path, old.path);
}

const LINE: &str = "0 LINE/8 0/10 0/20 0/11 30/21 40";

#[test]
fn pro_import_dxf_line() {
    let line = only(LINE);
    assert!(!line.is_closed());
    near(line.path.length(), 50.0, 1e-12);
    assert_eq!(drawn(&format!("{LINE}/0 LINE/10 30/20 40/11 1/21 1")).drawing.shapes.len(), 2);
    let sloping = only("0 LINE/10 0/20 0/30 1/11 3/21 0/31 2");
    assert_eq!(sloping.z_mm, Some(vec![1.0, 2.0]));
}

#[test]
fn pro_import_dxf_point() {
    let point = only("0 POINT/10 12/20 34");
    assert_eq!(point.kind(), Kind::Point);
    assert_eq!((point.start().x, point.start().y, point.path.length()), (12.0, 34.0, 0.0));
}

#[test]
fn pro_import_dxf_circle() {
    let circle = only("0 CIRCLE/10 50/20 50/40 25");
    assert_eq!((circle.start().x, circle.start().y), (75.0, 50.0));
    assert_eq!(circle.path.vertices.len(), 2);
    near(circle.path.signed_area(), 1963.495, 1e-3);
}

#[test]
fn pro_import_dxf_arc() {
    let arc = only("0 ARC/10 0/20 0/40 10/50 0/51 90");
    near(arc.path.vertices[0].bulge, 0.414214, 1e-6);
    near(arc.path.length(), 15.708, 1e-3);
    near(arc.path.end().unwrap().y, 10.0, 1e-12);
    near(only("0 ARC/10 0/20 0/40 10/50 350/51 10").path.length(), 3.4907, 1e-4);
}

#[test]
fn pro_import_dxf_ellipse() {
    let ellipse = |to: &str| only(&format!("0 ELLIPSE/10 0/20 0/11 50/21 0/40 0.5/41 0/42 {to}"));
    let whole = ellipse("6.283185307179586");
    assert!(whole.is_closed());
    near(whole.path.signed_area(), 3926.99, 0.5);
    let half = ellipse("3.141592653589793");
    assert!(!half.is_closed());
    near(half.path.end().unwrap().x, -50.0, 1e-9);
}

#[test]
fn pro_import_dxf_other() {
    let read = drawn(&format!("0 TEXT/1 hello/0 HATCH/2 SOLID/0 INSERT/2 NONE/10 0/20 0/{LINE}"));
    assert_eq!(read.drawing.shapes.len(), 1);
    assert_eq!(read.skipped.as_deref(), Some("skipped: HATCH 1, INSERT 1, TEXT 1"));
}

#[test]
fn pro_import_dxf_group() {
    let read = drawn("0 LINE/8 cuts/62 1/10 0/20 0/11 1/21 1/0 POINT/8 holes/10 3/20 3");
    assert!(read.drawing.shapes.iter().all(|shape| shape.group == Group::Black));
    assert_eq!(read.drawing.arrays, kerf_drawing::Arrays::default());
    assert_eq!(read.layers, [("cuts".into(), vec![0]), ("holes".into(), vec![1])]);
}

fn with_block(block: &str, entities: &str) -> Imported {
    let pairs = |text: &str| -> String {
        text.split('/').map(|pair| pair.trim().replacen(' ', "\n", 1) + "\n").collect()
    };
    let blocks = format!("0\nSECTION\n2\nBLOCKS\n{}0\nENDSEC\n", pairs(block));
    read((blocks + &file(entities)).as_bytes(), &Options::default())
}

const BLOCK: &str = "0 BLOCK/8 0/2 part/10 1/20 0/0 CIRCLE/8 0/10 2/20 0/40 1/0 ENDBLK";

fn boxes(read: &Imported) -> Vec<String> {
    let round = |v: f64| (v * 1e3).round() / 1e3 + 0.0;
    let shown = |shape: &Shape| {
        let bounds = shape.path.bounds();
        let (min, max) = (bounds.min, bounds.max);
        format!("{},{}..{},{}", round(min.x), round(min.y), round(max.x), round(max.y))
    };
    read.drawing.shapes.iter().map(|shape| shown(shape)).collect()
}

#[test]
fn blocks_are_placed_scaled_turned_and_repeated() {
    let placed = |insert: &str| with_block(BLOCK, &format!("0 INSERT/8 cuts/2 PART/{insert}"));
    assert_eq!(boxes(&placed("10 10/20 20")), ["10,19..12,21"]);
    assert_eq!(boxes(&placed("10 0/20 0/41 2/42 2")), ["0,-2..4,2"]);
    assert_eq!(boxes(&placed("10 0/20 0/50 90")), ["-1,0..1,2"]);
    assert_eq!(boxes(&placed("10 0/20 0/41 2")), ["0,-1..4,1"]);
    assert_eq!(boxes(&placed("10 0/20 0/41 -1")), ["-2,-1..0,1"]);
    let grid = boxes(&placed("10 0/20 0/70 2/71 2/44 10/45 20"));
    assert_eq!(grid, ["0,-1..2,1", "10,-1..12,1", "0,19..2,21", "10,19..12,21"]);
    assert_eq!(placed("10 0/20 0").layers[0].0, "cuts");
    let unequal = &placed("10 0/20 0/41 2").drawing.shapes[0];
    assert!(unequal.is_closed());
    near(unequal.path.signed_area(), 2.0 * std::f64::consts::PI, 0.01);
}

#[test]
fn blocks_nest_but_not_in_themselves() {
    let nest = format!(
        "{BLOCK}/0 BLOCK/2 twice/10 0/20 0/0 INSERT/2 part/10 5/20 0/0 INSERT/2 \
        TWICE/10 0/20 0/0 ENDBLK"
    );
    let read = with_block(&nest, "0 INSERT/2 twice/10 100/20 0");
    assert_eq!(boxes(&read), ["105,-1..107,1"]);
    assert_eq!(told(&read), ["block TWICE is placed within itself, or too deep: left out"]);
}

#[test]
fn the_extrusion_downwards_mirrors() {
    let arc = only("0 ARC/10 10/20 0/40 5/50 0/51 90/210 0/220 0/230 -1");
    let (start, end) = (arc.path.start().unwrap(), arc.path.end().unwrap());
    near(start.x, -15.0, 1e-9);
    near(end.x, -10.0, 1e-9);
    near(end.y, 5.0, 1e-9);
    assert!(arc.path.vertices[0].bulge < 0.0);
}

#[test]
fn units_of_the_header_are_taken_into_account_and_told() {
    let text = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n".to_owned() + &file(LINE);
    let scaled = read(text.as_bytes(), &Options::default());
    near(scaled.drawing.shapes[0].path.length(), 1270.0, 1e-9);
    assert_eq!(told(&scaled), ["drawn in inches: scaled by 25.4"]);
    let plain = read(text.as_bytes(), &Options { scale: false, ..Options::default() });
    near(plain.drawing.shapes[0].path.length(), 50.0, 1e-12);
}

#[test]
fn splines_become_arcs() {
    let knots = "40 0/40 0/40 0/40 0/40 1/40 1/40 1/40 1";
    let points = "10 0/20 0/10 0/20 10/10 20/20 10/10 20/20 0";
    let spline = only(&format!("0 SPLINE/70 8/71 3/{knots}/{points}"));
    near(spline.path.end().unwrap().x, 20.0, 1e-9);
    near(spline.path.bounds().max.y, 7.5, 0.01);
    let sloping = points.replacen("20 10", "20 10/30 4", 1);
    assert!(only(&format!("0 SPLINE/71 3/{knots}/{sloping}")).z_mm.is_some());
}

fn broken(entities: &str, finding: &str) {
    let read = drawn(&format!("{entities}/{LINE}"));
    assert_eq!(read.drawing.shapes.len(), 1, "{entities}: only the good line is drawn");
    assert_eq!(told(&read), [finding]);
}

#[test]
fn what_is_broken_is_told_and_left_out() {
    broken("0 LINE/10 x/20 0/11 1/21 1", "LINE: `x` is no number (group code 10): left out");
    broken("0 LINE/10 0/20 0/11 1", "LINE without the value of group code 21: left out");
    broken("0 LINE/10 0/20 0/11 nan/21 1", "LINE: `nan` is no number (group code 11): left out");
    broken("0 LINE/10 5/20 5/11 5/21 5", "LINE without length: left out");
    broken("0 CIRCLE/10 0/20 0/40 -3", "CIRCLE of radius -3: left out");
    broken(
        "0 LWPOLYLINE/90 1/10 0/20 0",
        "LWPOLYLINE with fewer than two different points: left out",
    );
    let told = "SPLINE: 2 knots for 4 control points of degree 3: 8 are needed: left out";
    broken("0 SPLINE/71 3/40 0/40 1/10 0/20 0/10 1/20 0/10 2/20 0/10 3/20 0", told);
    broken(
        "0 CIRCLE/10 1e12/20 0/40 3",
        "CIRCLE: vertex 0: farther than a million metres from the origin: left out",
    );
}

#[test]
fn what_nobody_can_see_is_not_drawn() {
    let doubled = only("0 LWPOLYLINE/90 4/70 0/10 0/20 0/10 0/20 1e-9/10 5/20 0/10 9/20 9");
    assert_eq!(doubled.path.vertices.len(), 3);
    let back = only("0 LWPOLYLINE/90 4/70 0/10 0/20 0/10 5/20 0/10 5/20 5/10 0/20 1e-9");
    assert!(back.is_closed() && back.path.vertices.len() == 3);
    let knots = "40 0/40 0/40 1/40 1";
    broken(
        &format!("0 SPLINE/71 1/{knots}/10 3/20 3/10 3/20 3"),
        "SPLINE without length: left out",
    );
}

/// Lengths of what is drawn of entities in a file with layers, a layer as `name colour flags`, and what is told.
fn on_layers(
    layers: &[&str],
    blocks: &str,
    entities: &str,
    options: Options,
) -> (Vec<f64>, Vec<String>) {
    let layer = |words: &&str| {
        let words: Vec<_> = words.split(' ').collect();
        format!("0 LAYER/2 {}/62 {}/70 {}/", words[0], words[1], words[2])
    };
    let table: String = layers.iter().map(layer).collect();
    let sections = [("TABLES", &*table), ("BLOCKS", blocks), ("ENTITIES", entities)];
    let section = |(name, body): (&str, &str)| format!("0 SECTION/2 {name}/{body}/0 ENDSEC/");
    let pairs = sections.map(section).concat() + "0 EOF";
    let pairs = pairs.split('/').filter(|pair| !pair.is_empty());
    let text: String = pairs.map(|pair| pair.trim().replacen(' ', "\n", 1) + "\n").collect();
    let read = read(text.as_bytes(), &options);
    (read.drawing.shapes.iter().map(|shape| shape.path.length()).collect(), told(&read))
}

fn line_on(layer: &str, length: u32) -> String {
    format!("0 LINE/8 {layer}/10 0/20 0/11 {length}/21 0/")
}

const SOME_LAYERS: [&str; 4] = ["cut 7 64", "guides -3 64", "Old 7 1", "both -7 5"];

#[test]
fn layers_that_are_not_seen_are_not_drawn_and_told() {
    let layers = ["cut", "guides", "GUIDES", "old", "both", "new"];
    let lines: String = (1..).zip(layers).map(|(n, layer)| line_on(layer, n)).collect();
    let corners =
        "0 POLYLINE/8 old/66 1/0 VERTEX/8 old/10 0/20 0/0 VERTEX/8 old/10 7/20 0/0 SEQEND";
    let all = lines + corners;
    let (drawn, told) = on_layers(&SOME_LAYERS, "", &all, Options::default());
    assert_eq!(drawn, [1.0, 6.0]);
    let expected = [
        "1 entity left out: layer `GUIDES` is off in the drawing",
        "1 entity left out: layer `both` is frozen in the drawing",
        "1 entity left out: layer `guides` is off in the drawing",
        "2 entities left out: layer `old` is frozen in the drawing",
    ];
    assert_eq!(told, expected);
    let unseen = Options { unseen: true, ..Options::default() };
    assert_eq!(
        on_layers(&SOME_LAYERS, "", &all, unseen),
        ((1..8).map(f64::from).collect(), vec![])
    );
}

#[test]
fn invisible_entities_are_not_drawn_and_told() {
    let hidden = line_on("cut", 1) + "60 1/" + &line_on("cut", 2) + "60 0/";
    let (drawn, told) = on_layers(&SOME_LAYERS, "", &hidden, Options::default());
    assert_eq!(drawn, [2.0]);
    assert_eq!(told, ["1 entity left out: marked as invisible (group code 60)"]);
}

/// Shapes of a block on layer 0 go with the layer of its INSERT; the rest goes with its own, unless that of the
/// INSERT is frozen.
#[test]
fn blocks_on_layers_that_are_not_seen() {
    let lines = line_on("0", 1) + &line_on("cut", 2) + &line_on("old", 3);
    let blocks = format!("0 BLOCK/2 b/10 0/20 0/{lines}/0 ENDBLK");
    let placed = |layer: &str, more: &str| {
        let insert = format!("0 INSERT/2 b/8 {layer}/10 0/20 0/{more}");
        on_layers(&SOME_LAYERS, &blocks, &insert, Options::default()).0
    };
    assert_eq!(placed("cut", ""), [1.0, 2.0]);
    assert_eq!(placed("guides", ""), [2.0]);
    assert_eq!(placed("old", ""), [0.0; 0]);
    assert_eq!(placed("cut", "60 1"), [0.0; 0]);
}

#[test]
fn no_bytes_make_it_panic() {
    let whole =
        file(&format!("{LINE}/{}", polyline(1, &[(0.0, 0.0, 0.0, 1.0), (9.0, 0.0, 0.0, 1.0)])));
    for end in 0..whole.len() {
        read(&whole.as_bytes()[..end], &Options::default());
    }
    for at in 0..whole.len() {
        let mut bytes = whole.clone().into_bytes();
        bytes[at] ^= 0x15;
        read(&bytes, &Options::default());
    }
}

/// The curve that ezdxf lays through these places is 124.2301 mm long (`fit_points_to_cad_cv`).
#[test]
fn a_spline_given_by_the_points_it_goes_through_is_the_curve_of_drawing_programs() {
    let places = "11 0/21 0/11 10/21 20/11 30/21 0/11 50/21 10/11 70/21 -30";
    let read = drawn(&format!("0 SPLINE/70 8/71 3/74 5/{places}"));
    let note =
        "SPLINE given only by points it goes through: drawn as the cubic spline through them";
    assert_eq!(told(&read), [note]);
    let path = &read.drawing.shapes[0].path;
    near(path.length(), 124.2301, 2e-3);
    for at in [(0.0, 0.0), (10.0, 20.0), (30.0, 0.0), (50.0, 10.0), (70.0, -30.0)] {
        let far = path.nearest(kerf_geom::Point2::new(at.0, at.1)).unwrap().1;
        assert!(far <= 2e-3, "{far} from {at:?}");
    }
    let closed = drawn(&format!("0 SPLINE/70 9/71 3/{places}"));
    assert!(closed.drawing.shapes[0].is_closed());
    broken(
        "0 SPLINE/71 3/11 1/21 1/11 1/21 1",
        "SPLINE with fewer than two different points: left out",
    );
}

#[test]
fn segments_without_length_are_told_with_their_place() {
    let read =
        drawn("0 LWPOLYLINE/70 1/10 0/20 0/10 0/20 0/10 10/20 5/10 10/20 5/10 5/20 9/10 0/20 0");
    let note = "LWPOLYLINE: segments without length left out: 2, the first at 0, 0";
    assert_eq!(told(&read), [note]);
    assert_eq!(read.drawing.shapes[0].path.vertices.len(), 3);
}

/// The bulge that a rounded number leaves of a line: the radius would be 200 km.
#[test]
fn arcs_that_nobody_can_tell_from_lines_are_lines() {
    let bulge = |bulge: f64| {
        let text = format!("0 LWPOLYLINE/70 0/10 0/20 0/42 {bulge}/10 16/20 0");
        drawn(&text).drawing.shapes[0].path.vertices[0].bulge
    };
    assert_eq!(bulge(2e-8), 0.0);
    assert_eq!(bulge(-2e-8), 0.0);
    assert_eq!(bulge(1e-5), 1e-5);
}
