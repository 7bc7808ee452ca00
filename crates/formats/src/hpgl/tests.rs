use super::*;
use kerf_drawing::{Group, Shape};
use kerf_geom::Polyarc;

fn shapes(text: &str) -> Vec<Shape> {
    let drawing = read(text.as_bytes()).drawing;
    drawing.shapes.iter().map(|shape| shape.as_ref().clone()).collect()
}

/// Vertices in plotter units, closed paths with a Z at the end.
fn told(path: &Polyarc) -> String {
    let unit = |mm: f64| (mm * 40.0 * 1e3).round() / 1e3 + 0.0;
    let word = |v: &kerf_geom::Vertex| {
        let at = format!("{},{}", unit(v.at.x), unit(v.at.y));
        if v.bulge == 0.0 { at } else { format!("{at}~{:.3}", v.bulge) }
    };
    let words: Vec<_> = path.vertices.iter().map(word).collect();
    format!("{}{}", words.join(" "), if path.closed { " Z" } else { "" })
}

fn check(text: &str, expected: &str) {
    let all: Vec<_> = shapes(text).iter().map(|shape| told(&shape.path)).collect();
    assert_eq!(all.join(" | "), expected, "{text}");
}

#[test]
fn runs_with_the_pen_down_are_shapes() {
    check("IN;SP1;PU0,0;PD1016,0;PD1016,1016;PU;", "0,0 1016,0 1016,1016");
    check("PU0 0PD10-5 20,7.5PU", "0,0 10,-5 20,7.5");
    check("PA;PU1,1;PR;PD5,0,0,5;PU;", "1,1 6,1 6,6");
    check("PU0,0;PD9,0,9,9,0,0;PU5,5;PD6,5;", "0,0 9,0 9,9 Z | 5,5 6,5");
    check("PU5,5;PD;PU;PU7,7;PD;PD;PU", "5,5 | 7,7");
    check("", "");
}

#[test]
fn pens_are_groups() {
    let read = shapes("SP1;PU0,0PD9,0;SP2;PD9,9;PU;SP0;PU1,1;PD2,2;PU;SP9PD3,3PU");
    let groups: Vec<_> = read.iter().map(|shape| shape.group).collect();
    assert_eq!(groups, [Group::Black, Group::Blue, Group::Black]);
    let layers = super::read(b"SP1;PU0,0PD9,0;SP3;PD9,9;PU").layers;
    assert_eq!(layers, [("pen 1".into(), vec![0]), ("pen 3".into(), vec![1])]);
}

#[test]
fn arcs_stay_arcs() {
    check("PU10,0;PD;AA0,0,90;PU", "10,0~0.414 0,10");
    check("PU10,0;PD;AR-10,0,-180;PU", "10,0~-1.000 -10,0");
    check("PU10,0;PD;AT0,10,-10,0;PU", "10,0~1.000 -10,0");
    check("PU10,0;PD;RT-10,-10,-20,0;PU", "10,0~-1.000 -10,0");
    check("PU0,0;PD;AT5,0,9,0;PU", "0,0 9,0");
    check("PU20,20;CI10;PD30,20;PU", "30,20~1.000 10,20~1.000 Z | 20,20 30,20");
    check("PU0,0;WG10,0,90;", "0,0 10,0~0.414 0,10 Z");
    check("PU1,2;EA5,7;", "1,2 5,2 5,7 1,7 Z");
    check("PU1,2;ER5,7;", "1,2 6,2 6,9 1,9 Z");
}

#[test]
fn scales_are_followed() {
    check("IP0,0,1000,2000;SC0,10,0,10;PU1,1;PD9,9;PU", "100,200 900,1800");
    check("IP0,0,1000,2000;SC0,10,0,10,1;PU0,0;PD10,10;PU", "0,500 1000,1500");
    check("IP0,0,1,1;SC0,2,0,2,2;PU1,1;PD5,5;PU", "2,2 10,10");
    check("SC0,0,0,0;PU1,1;PD5,5;PU", "1,1 5,5");
    check("RO90;PU1,2;PD5,2;PU", "-2,1 -2,5");
    check("IP0,0,100,100;SC10,0,0,10;PU5,0;PD;AA0,0,90;PU", "50,0~-0.414 100,50");
    let told = read(b"IP0,0,100,200;SC0,10,0,10;PU5,5;CI5").findings;
    assert!(told[0].text.contains("chords"), "{told:?}");
}

#[test]
fn polygons_are_outlined() {
    check("PU0,0;PM0;PD9,0,9,9;PM1;PU1,1;PD2,1,2,2;PM2;FP;", "0,0 9,0 9,9 Z | 1,1 2,1 2,2 Z");
    check("PU0,0;PM0;PD9,0,9,9;PM2;EP;PU20,20;PD30,30;PU", "0,0 9,0 9,9 Z | 20,20 30,30");
    check("PU0,0;PM0;CI5;PM2;EP;", "5,0~1.000 -5,0~1.000 Z");
}

/// The number in the digits of PE.
fn packed(mut value: i64) -> Vec<u8> {
    let mut rest = (value.unsigned_abs() << 1) | u64::from(value < 0);
    value = 0;
    let mut digits = Vec::new();
    while rest >= 64 {
        digits.push(63 + (rest % 64) as u8);
        rest /= 64;
    }
    digits.push(191 + rest as u8 + value as u8);
    digits
}

#[test]
fn packed_polylines_are_read() {
    let mut text = b"PE<=".to_vec();
    for value in [100, -2000] {
        text.extend(packed(value));
    }
    for value in [31, 32, -40, 5] {
        text.extend(packed(value));
    }
    text.extend(b";PU");
    let read = read(&text).drawing;
    assert_eq!(told(&read.shapes[0].path), "100,-2000 131,-1968 91,-1963");
    // Seven bits, in digits of base 32; a fraction of one bit.
    let seven = read_one(b"PE7>a<=ccgg;PU");
    assert_eq!(seven, "1,1 3,3");
}

#[test]
fn what_lies_too_far_away_is_told_and_left_out() {
    let read = read(b"SP1;PU0,0;PD400,0;PU;\nPU0,0;PD99999999999999,0;PU;\nSP2;PU0,0;PD0,400;PU;");
    let lengths: Vec<f64> = read.drawing.shapes.iter().map(|shape| shape.path.length()).collect();
    assert_eq!(lengths, [10.0, 10.0]);
    let told: Vec<_> = read.findings.iter().map(|f| (f.line, f.text.as_str())).collect();
    assert_eq!(told, [(2, "vertex 1: farther than a million metres from the origin: left out")]);
    assert_eq!(read.layers, [("pen 1".into(), vec![0]), ("pen 2".into(), vec![1])]);
}

fn read_one(bytes: &[u8]) -> String {
    read(bytes).drawing.shapes.iter().map(|shape| told(&shape.path)).collect()
}

#[test]
fn what_is_no_path_is_told() {
    let read = read(b"IN;DT#;LBPD1,1#;LT2;PU0,0;ZZ1,2;PD9,9;CI;PU\x1b.(;\x1b%0BPD;");
    let told: Vec<_> = read.findings.iter().map(|f| f.text.as_str()).collect();
    assert_eq!(told.len(), 2, "{told:?}");
    assert_eq!(told[0], "numbers are missing: the instruction is left out");
    assert_eq!(told[1], "skipped: ZZ 1, lettering 1");
    let empty = super::read(b"Dear Sir,").findings;
    assert!(empty.iter().any(|finding| finding.text.starts_with("nothing is drawn")));
}
