//! Tools of G-code by their numbers: lengths that are set once hold for every program.

use crate::shop::Shop;

fn shop() -> Shop {
    Shop::new(&[("long.nc", "G21 G43 H3\nG0 Z5\n"), ("measures.nc", "G21 G10 L1 P7 Z30 R2\n")])
}

#[test]
fn a_length_is_kept_and_taken_by_its_number() {
    let shop = shop();
    shop.kerf("machine tools").exits(0).says("no tool is known");
    shop.kerf("run long.nc").exits(0).complains("the length of tool 3 is not known");
    shop.kerf("machine tools set 3 --diameter 6 --length -12.5").exits(0);
    shop.kerf("machine tools").exits(0).says("T3     diameter        6 mm  length     -12.5 mm");
    let ran = shop.kerf("run long.nc --trace t.jsonl");
    ran.exits(0);
    assert!(!ran.err().contains("is not known"));
    // The tool before stands at 5 mm, where this one reads 17.5 mm.
    let trace = shop.read("t.jsonl");
    assert!(trace.contains("\"set\":{\"z\":0.688976378}"), "{trace}");
    shop.kerf("machine tools set 3 --length 1").exits(0);
    shop.kerf("machine tools").exits(0).says("T3     diameter        6 mm  length         1 mm");
    shop.kerf("machine tools clear 3").exits(0);
    shop.kerf("run long.nc").exits(0).complains("the length of tool 3 is not known");
}

#[test]
fn tools_that_a_program_measured_are_listed() {
    let shop = shop();
    shop.kerf("run measures.nc").exits(0);
    shop.kerf("machine tools").exits(0).says("T7     diameter        4 mm  length        30 mm");
}

#[test]
fn what_makes_no_sense_is_refused() {
    let shop = shop();
    shop.kerf("machine tools set 3").exits(2).complains("--diameter, --length or both");
    shop.kerf("machine tools set 0 --length 1").exits(2);
    shop.kerf("machine tools set 3 --diameter -1").exits(2);
    shop.kerf("machine tools clear 3").exits(2).complains("tool 3 is not known");
}
