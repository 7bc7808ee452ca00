//! Conversions as rows of the manuals ask for them, and as a person uses them.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod shop;

use shop::Shop;

const PROG: &str = "G0 X1\nG1 Z-.1 F60\nG2 X3 Y0 I1 J0\n";

#[test]
fn sbp_conv_gcode() {
    let shop = Shop::new(&[("prog.nc", PROG)]);
    shop.kerf("convert prog.nc prog.sbp").exits(0);
    let text = shop.read("prog.sbp");
    assert!(text.contains("JX,1\nVS,,1\nMZ,-0.1\nVS,1\nCG,,3,0,1,0,T,1\n"), "{text}");
    let trace = shop.kerf("trace prog.sbp");
    let arcs = trace.all("arc");
    assert_eq!(arcs.len(), 1);
    assert_eq!((&arcs[0]["dir"], &arcs[0]["sweep"]), (&"cw".into(), &180.into()));
    assert_eq!(trace.end()["bounds"]["max"]["x"], 3);
}

#[test]
fn sbp_conv_result() {
    let shop = Shop::new(&[("prog.nc", PROG)]);
    let mut command = shop.command();
    command.env("SOURCE_DATE_EPOCH", "1800000000").args(["convert", "prog.nc", "prog.sbp"]);
    assert!(command.output().unwrap().status.success());
    let text = shop.read("prog.sbp");
    let head = "'Converted from prog.nc by kerf 0.1.0, 2027-01-15\n'Settings: machine in in\n\
                'UNITS: INCHES\n";
    assert!(text.starts_with(head), "{text}");
    shop.kerf("check prog.sbp").exits(0);
    shop.kerf("fmt --check prog.sbp").exits(0);
}

#[test]
fn sbp_conv_prompts() {
    let shop = Shop::new(&[("prog.nc", PROG), ("cool.nc", "G21 G0 X1\nM8\nG1 X2 F600\nM9\n")]);
    // Without a word the machine is in inches; an option says otherwise.
    shop.kerf("convert prog.nc prog.sbp --units mm").exits(0);
    assert!(shop.read("prog.sbp").contains("'UNITS: MM\n"));
    // What flood coolant switches is asked for by name; without an answer it is told.
    shop.kerf("convert cool.nc a.sbp").exits(0).complains("--flood-output N");
    shop.kerf("convert cool.nc b.sbp --flood-output 3").exits(0);
    let text = shop.read("b.sbp");
    assert!(text.contains("SO,3,1\nVS,10\nMX,2\nSO,3,0\n"), "{text}");
}

#[test]
fn variables_are_kept_where_both_languages_can() {
    let grid = "MS,1,.5\n&x = 0\nAGAIN:\nJ2,&x,0\nMZ,-.1\nJZ,.5\n&x = &x + 1\n\
                IF &x < 3 THEN GOTO AGAIN\nEND\n";
    let shop = Shop::new(&[("grid.sbp", grid), ("inp.sbp", "MSGBOX(Go?)\nJX,1\nMX,2\n")]);
    shop.kerf("convert grid.sbp grid.ngc --keep-variables").exits(0);
    let text = shop.read("grid.ngc");
    assert!(text.contains("O101 while [#<_v_x> LT 3]"), "{text}");
    let grbl = shop.kerf("convert grid.sbp grid.nc --keep-variables --to grbl");
    grbl.exits(0).complains("note[C004]").complains("grbl has no variables");
    shop.kerf("convert grid.ngc back.sbp --keep-variables").exits(0);
    assert!(shop.read("back.sbp").contains("IF (&g_v_x < 3) THEN GOTO AGAIN_101"));
    let inp = shop.kerf("convert inp.sbp inp.nc --keep-variables");
    inp.complains("inp.sbp:1").complains("variables are not kept");
}

#[test]
fn sbp_conv_fc() {
    let shop = Shop::new(&[("prog.nc", PROG), ("a.sbp", "FC,prog.nc\nFP,prog.sbp\n")]);
    let did = shop.kerf("run a.sbp");
    did.exits(0).says("1 arc");
    let text = shop.read("prog.sbp");
    assert!(text.contains("CG,,3,0,1,0,T,1\n"), "{text}");
    // An existing part file is written over only where somebody says so.
    shop.write("prog.sbp", b"MX,9\n");
    shop.kerf("run a.sbp").exits(0).says("Write over it? → No");
    assert_eq!(shop.read("prog.sbp"), "MX,9\n");
    shop.write("yes.txt", b"Yes\n");
    shop.kerf("run a.sbp --answers yes.txt").exits(0);
    assert_eq!(shop.read("prog.sbp"), text);
    // A preview writes nothing.
    std::fs::remove_file(shop.file("prog.sbp")).unwrap();
    shop.kerf("trace a.sbp").exits(0);
    assert!(!shop.file("prog.sbp").exists());
}

#[test]
fn sbp_conv_fc_unknown() {
    let shop = Shop::new(&[
        ("part.xyz", PROG),
        ("a.sbp", "FC,part.xyz\n"),
        ("gcode.txt", "G-code\n"),
        ("dxf.txt", "DXF\n"),
    ]);
    let did = shop.kerf("run a.sbp --answers gcode.txt");
    did.exits(0).says("What is part.xyz? DXF, HPGL, G-code or bitmap");
    assert!(shop.read("part.sbp").contains("CG,,3,0,1,0,T,1\n"));
    std::fs::remove_file(shop.file("part.sbp")).unwrap();
    shop.kerf("run a.sbp --answers dxf.txt").exits(1).complains("not converted yet");
    assert!(!shop.file("part.sbp").exists());
    // Headless by an option.
    shop.kerf("convert part.xyz part.sbp --type nc").exits(0);
    assert!(shop.read("part.sbp").contains("CG,,3,0,1,0,T,1\n"));
}
