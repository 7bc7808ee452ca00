//! Tools by their numbers: lengths that are set or measured once hold for every program.

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
    shop.kerf("machine tools set 3").exits(2).complains("--name, --diameter, --length or several");
    shop.kerf("machine tools set 0 --length 1").exits(2);
    shop.kerf("machine tools set 3 --diameter -1").exits(2);
    shop.kerf("machine tools clear 3").exits(2).complains("tool 3 is not known");
}

/// A machine with a sensor for tools, with Z zero at its home, where a tool's tip meets the sensor 10 mm below, or 7 mm.
fn measuring() -> Shop {
    let scene = |z: f64| format!("input 1 on in box 40,10,-30 60,30,{z}\n");
    let measure = "&Tool = 1\n&tool_measure = 1\nC9\n";
    let program = "G21 G90 F600\nT2 M6\nG43 H2\nG0 Z0\n";
    let back = "G21 G90 F600\nT1 M6\nG0 Z0\n";
    let shop = Shop::new(&[
        ("short.txt", &scene(-10.0)),
        ("long.txt", &scene(-7.0)),
        ("measure.sbp", measure),
        ("part.nc", program),
        ("back.nc", back),
        ("where.sbp", "PRINT \"stands at \";INT((%(3) + %(8)) * 2540 + .5) / 100\n"),
    ]);
    for (key, value) in [
        ("m6_runs_c9", "true"),
        ("tool_change.place_x", "100"),
        ("tool_change.place_y", "0"),
        ("tool_change.sensor_x", "50"),
        ("tool_change.sensor_y", "20"),
        ("tool_change.sensor_input", "1"),
    ] {
        shop.kerf(&format!("machine set {key} {value}")).exits(0);
    }
    shop.kerf("machine tools set 2 --diameter 6 --name end-mill").exits(0);
    shop.kerf("run measure.sbp --script short.txt").exits(0);
    shop
}

#[test]
fn a_tool_that_is_measured_is_kept_by_its_number_and_z_zero_goes_with_it() {
    let shop = measuring();
    let measured = "T1     diameter        0 mm  length       -10 mm  measured  in the spindle";
    shop.kerf("machine tools").exits(0).says(measured);
    let ran = shop.kerf("run part.nc --script long.txt --trace t.jsonl");
    ran.exits(0);
    let trace = shop.read("t.jsonl");
    assert!(trace.contains("Put in tool 2 (6 mm end-mill) and press OK."), "{trace}");
    // The tool is changed at its place, with nothing turning.
    let asked = trace.lines().position(|line| line.contains("Put in tool 2")).unwrap();
    let went = trace.lines().take(asked).filter(|line| line.contains("\"e\":\"move\"")).last();
    assert!(went.is_some_and(|line| line.contains("\"x\":3.93700")), "{went:?}");
    let measured =
        "T2     diameter        6 mm  length        -7 mm  measured  in the spindle  end-mill";
    shop.kerf("machine tools").exits(0).says(measured).says("length       -10 mm  measured\n");
    // G43 takes nothing a second time: Z zero is 3 mm higher for a tool that is 3 mm longer.
    shop.kerf("run where.sbp").exits(0).says("stands at 3");
}

#[test]
fn a_tool_that_keeps_its_length_is_not_measured_again() {
    let shop = measuring();
    shop.kerf("run part.nc --script long.txt").exits(0);
    shop.kerf("machine set tool_change.keeps_lengths true").exits(0);
    // Nothing is there to be touched: the length of the table is taken.
    shop.kerf("run back.nc").exits(0);
    shop.kerf("run where.sbp").exits(0).says("stands at 0");
    shop.kerf("machine tools").exits(0).says("length       -10 mm  measured  in the spindle");
}

#[test]
fn a_tool_that_does_not_touch_its_sensor_keeps_its_length() {
    let shop = measuring();
    shop.kerf("run part.nc").exits(0).says("was not touched");
    shop.kerf("machine tools")
        .exits(0)
        .says("T2     diameter        6 mm  length         0 mm  end-mill");
    shop.kerf("run where.sbp").exits(0);
}
