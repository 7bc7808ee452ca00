//! Ten DXF files with a mistake each, as they come out of broken programs and broken disks: what is read of
//! them and what is told, with its line.

use kerf_formats::dxf::{Options, read};

/// Pairs of lines, parted by slashes: `0 LINE/10 0/20 0`.
fn lines(pairs: &str) -> String {
    pairs.split('/').map(|pair| pair.trim().replacen(' ', "\n", 1) + "\n").collect()
}

const BEGIN: &str = "0 SECTION/2 ENTITIES";
const END: &str = "0 ENDSEC/0 EOF";
const LINE: &str = "0 LINE/8 0/10 1.5/20 0.5/11 9.5/21 0.5";
const CIRCLE: &str = "0 CIRCLE/8 0/10 5.5/20 5.5/40 2.5";

/// The lengths of what is read, and what is told as `line: text`.
fn seen(text: &str) -> (Vec<f64>, Vec<String>) {
    let read = read(text.as_bytes(), &Options::default());
    let lengths = read.drawing.shapes.iter().map(|shape| shape.path.length().round());
    let told = read.findings.iter().map(|found| format!("{}: {}", found.line, found.text));
    (lengths.collect(), told.collect())
}

#[track_caller]
fn check(text: &str, lengths: &[f64], told: &[&str]) {
    let found = seen(text);
    assert_eq!(found.1, told, "{text}");
    assert_eq!(found.0, lengths, "{text}");
}

#[test]
fn a_word_in_place_of_a_number() {
    let text = lines(&format!("{BEGIN}/{LINE}/0 LINE/10 0/20 eight/11 9/21 9/{CIRCLE}/{END}"));
    check(&text, &[8.0, 16.0], &["22: LINE: `eight` is no number (group code 20): left out"]);
}

#[test]
fn a_file_that_breaks_off_in_a_polyline() {
    let vertices = "0 POLYLINE/66 1/70 0/0 VERTEX/10 0/20 0/0 VERTEX/10 4/20 0/0 VERTEX/10 4";
    let told = [
        "38: the file breaks off within a section: what came after this line is lost",
        "36: VERTEX without the value of group code 20: left out",
        "18: POLYLINE without SEQEND: it may be longer",
        "18: POLYLINE with a broken vertex: left out, since its form is not known",
    ];
    check(&lines(&format!("{BEGIN}/{LINE}/{vertices}")), &[8.0], &told);
}

#[test]
fn a_file_without_a_byte() {
    check("", &[], &["1: the file is empty"]);
    check("999\na comment\n", &[], &[]);
}

#[test]
fn a_line_that_is_missing() {
    let text = lines(&format!("{BEGIN}/{LINE}/{CIRCLE}/{LINE}/{END}"));
    // The radius of the circle.
    let mut all: Vec<&str> = text.lines().collect();
    assert_eq!(all.remove(25), "2.5");
    let told = [
        "27: `LINE` stands where a group code should: a line before it is missing, or one too many",
        "18: CIRCLE of radius 0: left out",
    ];
    check(&all.join("\n"), &[8.0, 8.0], &told);
}

#[test]
fn a_line_too_many() {
    let text = lines(&format!("{BEGIN}/{LINE}/{CIRCLE}/{LINE}/{END}"));
    let mut all: Vec<&str> = text.lines().collect();
    all.insert(20, "@@@");
    check(
        &all.join("\n"),
        &[8.0, 16.0, 8.0],
        &["21: `@@@` is no group code; the line is passed over"],
    );
}

#[test]
fn a_name_that_nobody_knows() {
    let text = lines(&format!("{BEGIN}/{LINE}/0 CIRKLE/10 5/20 5/40 2/{CIRCLE}/0 TEXT/1 x/{END}"));
    let told = ["18: `CIRKLE` is no entity that DXF has: left out", "0: skipped: TEXT 1"];
    check(&text, &[8.0, 16.0], &told);
}

#[test]
fn a_section_without_its_end() {
    let text = lines(&format!("{BEGIN}/{LINE}/0 SECTION/2 ENTITIES/{CIRCLE}/{END}"));
    check(&text, &[8.0, 16.0], &["18: the section before this one has no ENDSEC"]);
}

#[test]
fn blocks_that_are_not_there_or_within_themselves() {
    let blocks =
        "0 SECTION/2 BLOCKS/0 BLOCK/2 A/10 0/20 0/0 INSERT/2 A/10 0/20 0/0 ENDBLK/0 ENDSEC";
    let inserts = "0 INSERT/2 B/10 0/20 0/0 INSERT/2 A/10 0/20 0";
    let told = [
        "30: INSERT of block `B`, which the file does not have: left out",
        "14: block A is placed within itself, or too deep: left out",
        "0: skipped: INSERT 1",
    ];
    check(&lines(&format!("{blocks}/{BEGIN}/{inserts}/{LINE}/{END}")), &[8.0], &told);
}

#[test]
fn numbers_that_are_none() {
    let text = lines(&format!(
        "{BEGIN}/0 CIRCLE/10 nan/20 0/40 1/0 CIRCLE/10 0/20 0/40 -1/0 ARC/10 0/20 0/40 1/50 0/\
         0 LWPOLYLINE/90 2/10 0/20 0/10 1e999/20 0/0 POINT/10 1.#QNAN/20 0/0 LINE/10 1,5/20 0/11 3,5/21 0/{END}"
    ));
    let told = [
        "8: CIRCLE: `nan` is no number (group code 10): left out",
        "14: CIRCLE of radius -1: left out",
        "22: ARC without the value of group code 51: left out",
        "40: LWPOLYLINE: `1e999` is no number",
        "32: LWPOLYLINE with a broken vertex: left out, since its form is not known",
        "46: POINT: `1.#QNAN` is no number (group code 10): left out",
    ];
    check(&text, &[2.0], &told);
}

#[test]
fn a_spline_and_an_ellipse_that_cannot_be() {
    let spline = "0 SPLINE/71 3/40 0/40 0/40 1/40 1/10 0/20 0/10 1/20 1/10 2/20 0/10 3/20 1";
    let text = lines(&format!("{BEGIN}/{spline}/0 ELLIPSE/10 0/20 0/11 0/21 0/40 1/{LINE}/{END}"));
    let told = [
        "6: SPLINE: 4 knots for 4 control points of degree 3: 8 are needed: left out",
        "34: ELLIPSE without a size: left out",
    ];
    check(&text, &[8.0], &told);
}

#[test]
fn bytes_of_something_else() {
    let text = lines(&format!("{BEGIN}/{LINE}/{CIRCLE}/{END}"));
    let mut all: Vec<&str> = text.lines().collect();
    all.splice(16..16, ["\u{1}\u{2}\0PNG", "€€€ €€€"]);
    let told = [
        "17: `\u{1}\u{2}\0PNG` is no group code; the line is passed over",
        "18: `€€€ €€€` is no group code; the line is passed over",
    ];
    check(&all.join("\r\n"), &[8.0, 16.0], &told);
}
