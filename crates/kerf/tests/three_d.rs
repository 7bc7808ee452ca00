//! Shapes with heights of their own are cut at them, wherever they come from; long programs are drawn.

use crate::shop::{Did, Shop};

/// The heights at which a drawing is cut, from where the first cut ends on.
fn cut_at(shop: &Shop, drawing: &str) -> Vec<f64> {
    shop.kerf(&format!("toolpath {drawing} --config sim -o cut.rsm")).exits(0);
    let run = shop.kerf("trace cut.rsm --config sim --units mm");
    run.exits(0);
    let moves = run.all("move");
    let cuts = moves.iter().filter(|made| made["kind"] == "cut");
    cuts.map(|made| (made["to"]["z"].as_f64().unwrap() * 1e3).round() / 1e3).collect()
}

const SLOPE: &str = "G21 G90 F600\nG0 X0 Y0\nG1 Z-2\nX10 Z-4\nX20\n";

#[test]
fn pro_import_nc_path2d3d__a_program_is_cut_at_its_own_heights() {
    let shop = Shop::new(&[("n.nc", SLOPE)]);
    let made = shop.kerf("draw n.nc -o n.rsg");
    made.exits(0).complains("group black is 3D now: its shapes have heights of their own");
    let heights = cut_at(&shop, "n.rsg");
    assert!(heights.ends_with(&[-24.0, -24.0]) && heights.contains(&-22.0), "{heights:?}");
}

#[test]
fn a_line_of_a_dxf_file_in_space_is_cut_at_its_own_heights() {
    let line = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n30\n-1\n11\n30\n21\n0\n31\n-3\n0\nENDSEC\n0\nEOF\n";
    let shop = Shop::new(&[("a.dxf", line)]);
    shop.kerf("draw a.dxf -o a.rsg").exits(0).complains("group black is 3D now");
    let heights = cut_at(&shop, "a.rsg");
    assert!(
        heights.contains(&-21.0) && heights.contains(&-23.0) && !heights.contains(&-30.0),
        "{heights:?}"
    );
}

#[test]
fn a_single_point_in_space_is_drilled_to_its_height_and_the_job_is_whole() {
    let shop = Shop::new(&[]);
    let script = "line 0,0 10,0; line3d 5,5,-4";
    let made = shop.command().args(["draw", "--do", script, "-o", "p.rsg"]).output().unwrap();
    Did::of(made).exits(0).complains("group blue, which is 3D");
    let heights = cut_at(&shop, "p.rsg");
    assert!(heights.contains(&-24.0), "{heights:?}");
    assert!(heights.contains(&-30.0), "the flat line stays THRU: {heights:?}");
}

#[test]
fn controllers_are_dialects() {
    let shop = Shop::new(&[("a.nc", "G21 G90 F600\nG0 X0\nG2 I5\nM2\n")]);
    shop.kerf("check a.nc --dialect grbl")
        .exits(1)
        .says("grbl has no arcs without an end in their plane");
    for dialect in ["grblhal", "mach3", "linuxcnc", "generic"] {
        shop.kerf(&format!("check a.nc --dialect {dialect}")).exits(0);
    }
    shop.write("b.nc", b"G21 G90 F600\nG0 X1\n#1=1\nIF [#1 LT 5] GOTO 10\nG1 X2\nM2\n");
    shop.kerf("check b.nc").exits(1).says("this is Fanuc's macro language");
}

#[test]
fn the_picture_of_a_long_program_is_thinned_and_says_so() {
    let place = |n: u32| {
        let angle = f64::from(n) / 5e5 * std::f64::consts::TAU;
        format!("G1 X{:.4} Y{:.4}\n", 200.0 * angle.cos(), 200.0 * angle.sin())
    };
    let moves: String = (0..=500_000).map(place).collect();
    let shop = Shop::new(&[("long.nc", &format!("G21 G90 F6000\n{moves}M2\n"))]);
    shop.kerf("preview long.nc -o long.html").exits(0);
    let page = shop.read("long.html");
    assert!(page.contains("moves are drawn as"), "told in the page");
    assert!(page.len() < 12_000_000, "{} bytes", page.len());
}
