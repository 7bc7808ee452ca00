//! A surface is probed on a grid, and programs of both languages follow it.

use crate::shop::Shop;
use serde_json::Value;

/// 0.5 mm higher at X 40 than at X 0.
const RISES: &str = "kerf heights, mm\n0,0,0\n40,0,.5\n0,40,0\n40,40,.5\n";

fn shop() -> Shop {
    Shop::new(&[
        ("rises.map", RISES),
        ("part.sbp", "SA\nMS,1,1\nJ2,0,0\nMZ,-.1\nM2,1,0\nCG,,1,1,0,.5,T,1\nMZ,.2\n"),
        ("part.nc", "G21 F600\nG0 X0 Y0\nG1 Z-2\nX30 Y10\nG2 X30 Y20 J5\n"),
        ("far.nc", "G21 F600\nG0 X200 Y0\nG0 X0\nG1 Z-1\nX50\n"),
    ])
}

/// Moves of a run, as it was traced.
fn moves(shop: &Shop, file: &str) -> Vec<Value> {
    shop.kerf(&format!("run {file} --trace t.jsonl")).exits(0);
    let trace = shop.read("t.jsonl");
    let all = trace.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    all.filter(|event| event["e"] == "move" || event["e"] == "arc").collect()
}

/// The end of a move, mm.
fn to(made: &Value) -> [f64; 3] {
    ["x", "y", "z"].map(|axis| made["to"][axis].as_f64().unwrap() * 25.4)
}

#[test]
fn programs_of_both_languages_follow_the_map_in_force() {
    for (file, program_z) in [("part.sbp", -2.54), ("part.nc", -2.0)] {
        let shop = shop();
        let flat = moves(&shop, file).len();
        shop.kerf("map use rises.map")
            .exits(0)
            .says("2 by 2 places, X 0 … 40, Y 0 … 40, Z 0 … 0.5 mm");
        let raised = moves(&shop, file);
        assert!(raised.len() > flat + 40, "{file}: {} pieces", raised.len());
        let cuts: Vec<_> = raised.iter().filter(|made| made["kind"] != "jog").map(to).collect();
        let deep: Vec<_> = cuts.iter().filter(|at| at[2] < 0.0).collect();
        assert!(deep.len() > 40);
        for [x, _, z] in deep {
            let z_wanted = program_z + 0.5 * x.clamp(0.0, 40.0) / 40.0;
            assert!((z - z_wanted).abs() < 0.001, "{file}: {z} at X {x} is not {z_wanted}");
        }
        shop.kerf("map off").exits(0);
        assert!(moves(&shop, file).len() < flat + 3);
    }
}

#[test]
fn a_run_tells_that_it_follows_a_map() {
    let shop = shop();
    shop.kerf("map show").exits(0).says("no height map is in force");
    shop.kerf("map use rises.map").exits(0);
    shop.kerf("map show").exits(0).says("40.000     0.000    0.500");
    shop.kerf("run part.nc").exits(0).complains("M011");
    shop.kerf("map off").exits(0);
    assert!(!shop.kerf("run part.nc").err().contains("M011"));
}

#[test]
fn cuts_beyond_the_grid_end_the_program_and_jogs_do_not() {
    let shop = shop();
    shop.kerf("map use rises.map").exits(0);
    let ran = shop.kerf("run far.nc");
    ran.exits(1).complains("M010").complains("far.nc:5").complains("leaves the height map");
}

#[test]
fn what_is_no_map_is_refused_and_a_damaged_one_moves_nothing() {
    let shop = shop();
    shop.kerf("map use part.nc").exits(2).complains("line 1: a file of heights begins with");
    shop.kerf("map use rises.map").exits(0);
    shop.write("data/height.map", b"nothing\n");
    shop.kerf("run part.nc").exits(1).complains("M012");
    shop.kerf("map off").exits(0);
    shop.kerf("run part.nc").exits(0);
}

/// The tool stands where the program thinks after a run, and the next one begins there.
#[test]
fn a_run_begins_where_the_one_before_it_ended() {
    let shop = shop();
    shop.kerf("map use rises.map").exits(0);
    shop.write("out.nc", b"G21 F600\nG1 X40 Z-1\n");
    shop.write("deeper.nc", b"G21 F600\nG91 G1 Z-1\n");
    let last = |file: &str| to(moves(&shop, file).last().unwrap());
    assert!((last("out.nc")[2] + 0.5).abs() < 1e-6);
    assert!((last("deeper.nc")[2] + 1.5).abs() < 1e-6);
}

#[test]
fn a_surface_is_probed_on_a_grid() {
    // Three steps of a stair, each as wide as a column.
    let scene = "input 1 on in box *,*,* 5,*,-1\ninput 1 on in box 5,*,* 15,*,-1.25\ninput 1 on in box 15,*,* *,*,-.5\n";
    let shop = Shop::new(&[("scene.txt", scene)]);
    let entries =
        "units=mm,width=20,height=10,columns=3,rows=2,travel=2,lowest=-3,clear=.3,fast=5,slow=1.5";
    shop.kerf(&format!("send TM,{entries}")).exits(0);
    shop.kerf("machine move to 0,0,2").exits(0);
    shop.kerf("run probe_heights.sbp --units mm --script scene.txt")
        .exits(0)
        .says("heights.map is written");
    let map = shop.read("heights.map");
    let lines: Vec<&str> = map.lines().collect();
    let expected = [
        "kerf heights, mm",
        "0,0,-1",
        "10,0,-1.25",
        "20,0,-0.5",
        "20,10,-0.5",
        "10,10,-1.25",
        "0,10,-1",
    ];
    assert_eq!(lines, expected);
    shop.kerf("map use heights.map").exits(0).says("3 by 2 places");
}

/// A line that a job cuts from X 5 Y 5 to X 35 Y 25.
fn job_shop() -> Shop {
    let shop = shop();
    let lines = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nGROUP1\n10\n5\n20\n5\n11\n35\n21\n25\n0\nENDSEC\n0\nEOF\n";
    shop.write("line.dxf", lines.as_bytes());
    shop.kerf("toolpath line.dxf -o line.rsm").exits(0);
    shop
}

/// Ends of the cuts of the job, mm.
fn cuts(shop: &Shop) -> Vec<[f64; 3]> {
    let all = moves(shop, "line.rsm");
    all.iter().filter(|made| made["kind"] != "jog").map(end_of_job).collect()
}

/// The end of a move of a job, whose trace is in mm.
fn end_of_job(made: &Value) -> [f64; 3] {
    to(made).map(|inches| inches / 25.4)
}

#[test]
fn a_job_follows_the_map_in_force() {
    let shop = job_shop();
    let flat = cuts(&shop);
    let deepest = flat.iter().map(|at| at[2]).fold(0.0, f64::min);
    shop.kerf("map use rises.map").exits(0);
    let raised = cuts(&shop);
    assert!(raised.len() > flat.len() + 20, "{} pieces", raised.len());
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    for [x, _, z] in raised.iter().filter(|[_, _, z]| *z < deepest + 0.51) {
        let wanted = deepest + 0.5 * x / 40.0;
        assert!((z - wanted).abs() < 0.001, "{z} at X {x} is not {wanted}");
        (least, most) = (least.min(*x), most.max(*x));
    }
    assert!(least < 5.1 && most > 34.9, "{least} … {most}");
    shop.kerf("run line.rsm").exits(0).complains("M011");
}

/// A map lies where it was probed: an origin of the job elsewhere does not move it.
#[test]
fn a_job_whose_origin_is_elsewhere_finds_the_map_where_it_was_probed() {
    let shop = job_shop();
    shop.kerf("toolpath line.dxf --origin 4,0 -o line.rsm").exits(0);
    let deepest = cuts(&shop).iter().map(|at| at[2]).fold(0.0, f64::min);
    shop.kerf("map use rises.map").exits(0);
    let [x, _, z] = *cuts(&shop).last().unwrap();
    assert!((x - 35.0).abs() < 0.001 && (z - deepest - 0.5 * 39.0 / 40.0).abs() < 0.001, "{x} {z}");
}

#[test]
fn a_job_beyond_the_grid_is_not_begun() {
    let shop = job_shop();
    shop.kerf("toolpath line.dxf --origin 30,0 -o line.rsm").exits(0);
    shop.kerf("map use rises.map").exits(0);
    let ran = shop.kerf("run line.rsm --trace t.jsonl");
    ran.exits(1).complains("M010").complains("leaves the height map");
    assert!(!shop.read("t.jsonl").contains("\"e\":\"move\""));
}

#[test]
fn a_job_that_is_stopped_under_a_map_goes_on_where_it_was() {
    let shop = job_shop();
    shop.kerf("map use rises.map").exits(0);
    let whole = cuts(&shop);
    shop.write("goes-on.txt", b"continue\n");
    shop.kerf("run line.rsm --stop-at 1.9 --answers goes-on.txt --trace t.jsonl").exits(0);
    let trace = shop.read("t.jsonl");
    let all: Vec<_> =
        trace.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()).collect();
    let stop = all.iter().position(|it| it["e"] == "stop").expect("it is stopped");
    let is_cut = |it: &&Value| it["e"] == "move" && it["kind"] == "cut";
    let left = all[..stop].iter().rfind(is_cut).map(end_of_job).unwrap();
    let again = all[stop..].iter().find(is_cut).map(end_of_job).unwrap();
    assert!(left[0] > 6.0 && left[0] < 34.0, "{left:?} is within the line");
    assert_eq!(again, left);
    assert_eq!(all.iter().rfind(is_cut).map(end_of_job), whole.last().copied());
}

#[test]
fn a_nudge_moves_the_surface_with_the_workpiece() {
    let shop = shop();
    // What comes behind the pause is read when the workpiece lies elsewhere already.
    let program = "SA\nMS,.4,.4\nJ2,0,0\nMZ,-.1\nM2,1.2,.4\nPAUSE .2\nM2,.2,.8\nM2,1.2,.8\n";
    shop.write("slow.sbp", program.as_bytes());
    shop.kerf("map use rises.map").exits(0);
    let whole = moves(&shop, "slow.sbp");
    shop.write("nudged.txt", b"nudge x .1\nnudge z .05\nResume\n");
    let ran = shop.kerf("run slow.sbp --stop-at 5 --answers nudged.txt --trace t.jsonl");
    ran.exits(0);
    let trace = shop.read("t.jsonl");
    let all: Vec<_> =
        trace.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()).collect();
    let stop = all.iter().position(|it| it["e"] == "stop").expect("it is stopped");
    let rest: Vec<_> = all[stop..]
        .iter()
        .filter(|it| it["e"] == "move" && it["kind"] == "cut" || it["e"] == "arc")
        .map(to)
        .collect();
    assert!(rest.len() > 20, "{} pieces are left", rest.len());
    for [x, _, z] in &rest {
        let z_wanted = 0.5 * x.clamp(0.0, 40.0) / 40.0 - 2.54;
        assert!((z - z_wanted).abs() < 0.001, "{z} at X {x} is not {z_wanted}");
    }
    assert_eq!(rest.last().copied(), whole.last().map(to));
    shop.write("base.sbp", b"PRINT \"base \";INT((%(1) + %(6)) * 2540 + .5) / 100\n");
    // Its end lies 2.54 mm farther on the table.
    shop.kerf("run base.sbp").exits(0).says("base 33.02");
}

#[test]
fn a_job_that_is_moved_aside_under_a_map_goes_on_where_it_was() {
    let shop = job_shop();
    let deepest = cuts(&shop).iter().map(|at| at[2]).fold(0.0, f64::min);
    shop.kerf("map use rises.map").exits(0);
    let whole = cuts(&shop);
    // By hand the machine moves as it stands: the surface is none of that move's, and it ends beyond the grid.
    shop.write("aside.txt", b"raise yes\nmove x 60\ncontinue\n");
    shop.kerf("run line.rsm --stop-at 1.9 --answers aside.txt --trace t.jsonl").exits(0);
    let trace = shop.read("t.jsonl");
    let all: Vec<_> =
        trace.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()).collect();
    let stop = all.iter().position(|it| it["e"] == "stop").expect("it is stopped");
    let moves = all[stop..].iter().filter(|it| it["e"] == "move").map(end_of_job);
    assert!(moves.clone().any(|at| at[0] > 55.0), "it was moved aside");
    let deep: Vec<_> = moves.clone().filter(|at| at[2] < deepest + 0.51).collect();
    assert!(deep.len() > 10, "{} pieces are left", deep.len());
    for [x, _, z] in deep {
        let wanted = deepest + 0.5 * x / 40.0;
        assert!((z - wanted).abs() < 0.001, "{z} at X {x} is not {wanted}");
    }
    let is_cut = |it: &&Value| it["e"] == "move" && it["kind"] == "cut";
    assert_eq!(all.iter().rfind(is_cut).map(end_of_job), whole.last().copied());
}

#[test]
fn a_jog_at_the_top_of_z_does_not_pass_it() {
    let shop = shop();
    shop.write("top.nc", b"G21 F600\nG0 Z20\nG0 X40\nG1 X30\nG0 Z10\n");
    for (key, value) in [("limits.high", "[500,500,20]"), ("limits.check", "true")] {
        shop.kerf(&format!("machine set {key} {value}")).exits(0);
    }
    shop.kerf("map use rises.map").exits(0);
    let [_, jog, .., last] = &moves(&shop, "top.nc")[..] else { panic!("three moves at least") };
    assert_eq!(to(jog).map(|at| (at * 1e3).round()), [40_000.0, 0.0, 20_000.0]);
    let [x, _, z] = to(last);
    assert!((z - 10.0 - 0.5 * x / 40.0).abs() < 0.001, "below the top it is lifted: {z} at {x}");
}

#[test]
fn a_tool_is_measured_beside_the_map_and_not_above_it() {
    let shop = shop();
    shop.write("sensor.txt", b"input 1 on in box 90,10,-30 110,30,-7\n");
    shop.write("two.nc", b"G21 F600\nG0 X30\nG1 Z-1\nT2 M6\nG0 X10 Y0\nG1 Z-1\nX20\n");
    for (key, value) in [
        ("m6_runs_c9", "true"),
        ("tool_change.sensor_x", "100"),
        ("tool_change.sensor_y", "20"),
        ("tool_change.sensor_input", "1"),
    ] {
        shop.kerf(&format!("machine set {key} {value}")).exits(0);
    }
    shop.kerf("map use rises.map").exits(0);
    shop.write("measure.sbp", b"&Tool = 1\n&tool_measure = 1\nC9\n");
    shop.kerf("run measure.sbp --script sensor.txt").exits(0);
    let ran = shop.kerf("run two.nc --script sensor.txt --trace t.jsonl");
    ran.exits(0);
    let tools = shop.kerf("machine tools");
    tools.exits(0).says("T1     diameter        0 mm  length        -7 mm  measured\n");
    tools.says("T2     diameter        0 mm  length        -7 mm  measured  in the spindle");
    let trace = shop.read("t.jsonl");
    let mut all = trace.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
    let [x, _, z] = all.rfind(|it| it["e"] == "move").map(|it| to(&it)).unwrap();
    assert!((x - 20.0).abs() < 0.001 && (z + 1.0 - 0.25).abs() < 0.001, "{z} at {x}");
}
