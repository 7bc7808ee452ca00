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
