//! Files of a few hundred bytes that stand for more shapes than a memory holds: they are refused in words, and
//! any reading can be given up.

use kerf_formats::dxf::{Options, read, read_until};
use kerf_formats::{Ended, Imported, MOST_PLACED, Weight, svg};
use std::cell::Cell;

/// A DXF file of these blocks and entities; blanks and slashes part the pairs: `0 LINE/10 0/20 0`.
fn dxf_of(blocks: &str, entities: &str) -> Vec<u8> {
    let section = |name: &str, body: &str| format!("0 SECTION/2 {name}/{body}/0 ENDSEC/");
    let pairs = section("BLOCKS", blocks) + &section("ENTITIES", entities) + "0 EOF";
    let pairs = pairs.split('/').filter(|pair| !pair.is_empty());
    pairs.flat_map(|pair| (pair.trim().replacen(' ', "\n", 1) + "\n").into_bytes()).collect()
}

/// Blocks within each other, each 100 times 100 times the one before; the innermost holds this.
fn nested(body: &str, most_placed: u64) -> Imported {
    let block = |n: u32| {
        let insert = format!("0 INSERT/2 b{}/10 0/20 0/70 100/71 100/44 1/45 1/", n.max(1) - 1);
        let body = if n == 0 { body.into() } else { insert };
        format!("0 BLOCK/2 b{n}/10 0/20 0/{body}0 ENDBLK/")
    };
    let blocks = (0..6).map(block).collect::<String>();
    let options = Options { most_placed, ..Options::default() };
    read(&dxf_of(&blocks, "0 INSERT/2 b5/10 0/20 0"), &options)
}

#[test]
fn blocks_in_blocks_without_bound_are_refused_with_block_and_line() {
    for body in ["", "0 TEXT/1 x/", "0 LINE/10 0/20 0/11 5/21 0/"] {
        let read = nested(body, 1000);
        assert_eq!((read.drawing.shapes.len(), read.ended), (0, Some(Ended::TooMuch)), "{body}");
        let told: Vec<_> =
            read.findings.iter().filter(|found| found.weight == Weight::Warning).collect();
        let text = "INSERT of block `b5` comes to more than 1,000 shapes beyond those that the file writes: nothing \
            of the drawing is read; give it and the blocks within it fewer rows and columns, or draw the shapes \
            without blocks";
        assert_eq!(
            told.iter().map(|found| found.text.as_str()).collect::<Vec<_>>(),
            [text],
            "{body}"
        );
        assert!(told[0].line > 100);
    }
}

#[test]
fn blocks_that_are_large_multiply_no_memory() {
    let vertices: String = (0..10_000).map(|n| format!("10 {n}/20 {}/", n % 2)).collect();
    let read = nested(&format!("0 LWPOLYLINE/{vertices}"), MOST_PLACED);
    assert_eq!((read.drawing.shapes.len(), read.ended), (0, Some(Ended::TooMuch)));
    assert!(read.findings[0].text.contains("more than 5,000,000 vertices"), "{:?}", read.findings);
}

#[test]
fn as_many_shapes_as_a_file_writes_are_free() {
    let block = "0 BLOCK/2 b/10 0/20 0/0 POINT/10 1/20 2/0 ENDBLK/";
    let inserts = "0 INSERT/2 b/10 0/20 0/".repeat(500) + "0 POINT/10 1/20 1";
    let read = read(&dxf_of(block, &inserts), &Options { most_placed: 0, ..Options::default() });
    assert_eq!((read.drawing.shapes.len(), read.ended), (501, None));
}

#[test]
fn a_reading_is_given_up_in_the_middle() {
    let asked = Cell::new(0);
    let given_up = || {
        asked.set(asked.get() + 1);
        asked.get() > 3
    };
    let text = dxf_of("", &"0 POINT/10 1/20 2/".repeat(100));
    let read = read_until(&text, &Options::default(), &given_up);
    assert_eq!((read.drawing.shapes.len(), read.ended), (0, Some(Ended::GivenUp)));
    assert_eq!(asked.get(), 4);
}

/// Ten thousand millions of something.
fn used(what: &str) -> Imported {
    let tenfold = |n: usize| {
        let uses = format!("<use href='#a{}'/>", n - 1).repeat(10);
        format!("<g id='a{n}'>{uses}</g>")
    };
    let groups: String = (1..11).map(tenfold).collect();
    let body = format!("<defs><g id='a0'>{what}</g>{groups}</defs>\n<use href='#a10'/>");
    svg::read(format!("<svg xmlns='http://www.w3.org/2000/svg'>{body}</svg>").as_bytes())
}

#[test]
fn what_is_used_without_bound_is_refused() {
    for what in ["", "<text/>", "<rect width='5' height='5'/>"] {
        let read = used(what);
        assert_eq!((read.drawing.shapes.len(), read.ended), (0, Some(Ended::TooMuch)), "{what}");
        let text = "<use> of `a10` comes to more than 200,000 shapes beyond those that the file writes: nothing of \
            the drawing is read; use it fewer times, or draw the shapes without <use>";
        let told: Vec<_> = read.findings.iter().filter(|found| found.text == text).collect();
        assert_eq!(told.iter().map(|found| found.line).collect::<Vec<_>>(), [2], "{what}");
    }
}

#[test]
fn an_svg_is_given_up_in_the_middle() {
    let asked = Cell::new(0);
    let given_up = || {
        asked.set(asked.get() + 1);
        asked.get() > 3
    };
    let lines = "<path d='M0 0H9'/>".repeat(100);
    let text = format!("<svg xmlns='http://www.w3.org/2000/svg'>{lines}</svg>");
    let read = svg::read_until(text.as_bytes(), &given_up);
    assert_eq!((read.drawing.shapes.len(), read.ended), (0, Some(Ended::GivenUp)));
    assert_eq!(asked.get(), 4);
}
