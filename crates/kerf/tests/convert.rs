//! Conversions as rows of the manuals ask for them, and as a person uses them.

use crate::shop::Shop;

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

/// A line, an arc of a quarter and a closed square, on two layers.
const DRAWING: &str = "0\nSECTION\n2\nENTITIES\n\
    0\nLINE\n8\nCUT\n10\n0\n20\n0\n11\n10\n21\n0\n\
    0\nARC\n8\nCUT\n10\n0\n20\n20\n40\n10\n50\n0\n51\n90\n\
    0\nLWPOLYLINE\n8\nFRAME\n90\n4\n70\n1\n10\n50\n20\n0\n10\n60\n20\n0\n10\n60\n20\n10\n10\n50\n20\n10\n\
    0\nENDSEC\n0\nEOF\n";

/// Ends of the cuts of a part file that move in the plane, as `x,y,z`.
fn cuts(shop: &Shop, part: &str) -> Vec<String> {
    let trace = shop.kerf(&format!("trace {part}"));
    let mut events: Vec<_> = trace.all("move").into_iter().chain(trace.all("arc")).collect();
    events.sort_by(|a, b| a["t0"].as_f64().unwrap().total_cmp(&b["t0"].as_f64().unwrap()));
    let round = |v: &serde_json::Value| (v.as_f64().unwrap() * 1e4).round() / 1e4 + 0.0;
    let to = |e: &serde_json::Value| {
        let to = &e["to"];
        format!("{},{},{}", round(&to["x"]), round(&to["y"]), round(&to["z"]))
    };
    events.iter().filter(|e| e["kind"] == "cut").map(to).collect()
}

#[test]
fn sbp_conv_dxf() {
    let shop = Shop::new(&[("part.dxf", DRAWING)]);
    let did = shop.kerf("convert part.dxf part.sbp --units mm --depth 2 --safe-height 6");
    did.exits(0).complains("layers: CUT (2 shapes), FRAME (1 shapes)");
    let expected = [
        "0,0,-2", "10,0,-2", "10,20,-2", "0,30,-2", "50,0,-2", "60,0,-2", "60,10,-2", "50,10,-2",
        "50,0,-2",
    ];
    assert_eq!(cuts(&shop, "part.sbp --units mm"), expected);
    let text = shop.read("part.sbp");
    assert!(text.contains("'Settings: depth 2 mm, safe height 6 mm, scale 1\n"), "{text}");
    shop.kerf("convert part.dxf inch.sbp --scale 25.4").exits(0);
    assert!(cuts(&shop, "inch.sbp").contains(&"10,0,-0.125".to_owned()));
    shop.kerf("convert part.dxf bad.sbp --depth 0").exits(2).complains("above 0");
}

#[test]
fn sbp_conv_dxf__fc() {
    let shop = Shop::new(&[("part.dxf", DRAWING), ("a.sbp", "FC,part.dxf\nFP,part.sbp\n")]);
    shop.kerf("run a.sbp").exits(0).says("1 arc");
    assert!(
        shop.read("part.sbp").contains("Settings: depth 0.125 in, safe height 0.5 in, scale 1")
    );
}

#[test]
fn sbp_conv_hpgl() {
    let plot = "IN;SP1;PU0,0;PD1016,0;PD1016,1016;PU;";
    let shop =
        Shop::new(&[("a.plt", plot), ("b.hpg", plot), ("c.xyz", plot), ("no.plt", "Dear Sir")]);
    let expected = ["0,0,-0.1", "1,0,-0.1", "1,1,-0.1"];
    for (file, more) in [("a.plt", ""), ("b.hpg", ""), ("c.xyz", "--type plt")] {
        shop.kerf(&format!("convert {file} out.sbp --force --depth .1 {more}")).exits(0);
        assert_eq!(cuts(&shop, "out.sbp"), expected, "{file}");
        shop.kerf("check out.sbp").exits(0);
    }
    shop.kerf("convert no.plt no.sbp").exits(1).complains("nothing is drawn");
    assert!(!shop.file("no.sbp").exists());
}

/// A picture of four by four dots in BMP, each row from the top a quarter brighter, but the first black
/// and the last white.
fn picture() -> Vec<u8> {
    let mut bytes = b"BM".to_vec();
    for word in [54 + 48, 0, 54, 40, 4, 4, 0x0018_0001u32, 0, 0, 0, 0, 0, 0] {
        bytes.extend(word.to_le_bytes());
    }
    for row in [255u8, 170, 85, 0] {
        bytes.extend([row; 12]);
    }
    bytes
}

#[test]
fn sbp_conv_bitmap() {
    let shop = Shop::new(&[]);
    shop.write("grey.bmp", &picture());
    let did = shop.kerf("convert grey.bmp grey.sbp --size 1,1 --depth .5");
    did.exits(0).complains("4 x 4 dots");
    // The lowest row is white, at the surface; the highest is black and deepest.
    let expected = [
        "0,0,0",
        "1,0,0",
        "1,0.3333,-0.1667",
        "0,0.3333,-0.1667",
        "0,0.6667,-0.3333",
        "1,0.6667,-0.3333",
        "1,1,-0.5",
        "0,1,-0.5",
    ];
    assert_eq!(cuts(&shop, "grey.sbp"), expected);
    assert!(shop.read("grey.sbp").contains("black deepest"));
    shop.kerf("convert grey.bmp white.sbp --size 1,1 --depth .5 --deepest white").exits(0);
    assert_eq!(cuts(&shop, "white.sbp")[0], "0,0,-0.5");
    shop.write("broken.png", b"\x89PNG\r\n\x1a\n");
    shop.kerf("convert broken.png broken.sbp").exits(1).complains("the picture cannot be read");
}

#[test]
fn sbp_conv_prompts__drawings() {
    let shop = Shop::new(&[("part.dxf", DRAWING)]);
    shop.kerf("convert part.dxf a.sbp").exits(0);
    let text = shop.read("a.sbp");
    assert!(text.contains("'Settings: depth 0.125 in, safe height 0.5 in, scale 1\n"), "{text}");
    shop.kerf("convert part.dxf b.sbp --units mm --depth 4 --scale 2 --safe-height 20").exits(0);
    let text = shop.read("b.sbp");
    assert!(text.contains("'Settings: depth 4 mm, safe height 20 mm, scale 2\n"), "{text}");
    assert!(cuts(&shop, "b.sbp --units mm").contains(&"20,0,-4".to_owned()));
}

#[test]
fn sbp_conv_prompts__in_a_part_file() {
    let said = "mm\n4, 20, 2\n";
    let shop = Shop::new(&[
        ("part.dxf", DRAWING),
        ("part.xyz", DRAWING),
        ("prog.nc", PROG),
        ("metric.nc", "G21 G0 X1\nG1 X2 F600\n"),
        ("a.sbp", "FC,part.dxf\nMX,1\n"),
        ("b.sbp", "FC,part.xyz\n"),
        ("c.sbp", "FC,prog.nc\n"),
        ("d.sbp", "FC,metric.nc\n"),
        ("said.txt", said),
        ("all.txt", "DXF\nyes\n\n.2,,3\n"),
        ("no.txt", "mm\ndeep\n"),
        ("miles.txt", "miles\n"),
    ]);
    // What nobody answers is as shown.
    let did = shop.kerf("run a.sbp");
    did.exits(0).says("Which unit has part.dxf: in or mm? → in");
    did.says("How is part.dxf cut? depth (in), safe height (in), scale → 0.125, 0.5, 1");
    let settings = |what: &str| {
        let text = shop.read("part.sbp");
        assert!(text.contains(&format!("'Settings: {what}\n")), "{text}");
    };
    settings("depth 0.125 in, safe height 0.5 in, scale 1");
    std::fs::remove_file(shop.file("part.sbp")).unwrap();
    shop.kerf("run a.sbp --answers said.txt").exits(0);
    settings("depth 4 mm, safe height 20 mm, scale 2");
    // A line asks as often as it has to: what it is, whether to write over one, unit and cut.
    shop.kerf("run b.sbp --answers all.txt").exits(0).says("Write over it? → Yes");
    settings("depth 0.2 in, safe height 0.5 in, scale 3");
    // What cannot be read ends the program and leaves the file as it was.
    std::fs::remove_file(shop.file("part.sbp")).unwrap();
    let refused = shop.kerf("run a.sbp --answers no.txt");
    refused.exits(1).complains("FC cannot read the answer 'deep'").complains("a.sbp:1");
    shop.kerf("run a.sbp --answers miles.txt").exits(1).complains("answer in or mm");
    assert!(!shop.file("part.sbp").exists());
    // G-code is asked for its unit where it does not say it.
    shop.kerf("run c.sbp --answers said.txt").exits(0).says("Which unit has prog.nc");
    assert!(shop.read("prog.sbp").contains("'UNITS: MM\n"));
    let metric = shop.kerf("run d.sbp");
    assert!(!metric.exits(0).out().contains("Which unit"), "{}", metric.out());
    assert!(shop.read("metric.sbp").contains("'UNITS: MM\n"));
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
    shop.kerf("run a.sbp --answers dxf.txt").exits(1).complains("was not converted");
    assert!(!shop.file("part.sbp").exists());
    // Headless by an option.
    shop.kerf("convert part.xyz part.sbp --type nc").exits(0);
    assert!(shop.read("part.sbp").contains("CG,,3,0,1,0,T,1\n"));
}

#[test]
fn a_height_that_nobody_said_is_told_and_not_made_up() {
    let shop = Shop::new(&[
        ("tool.nc", "G21 G90 G17 F600\nM6 T1\nG0 X10 Y10\nG1 X20\nM2\n"),
        ("arc.nc", "G20 G90 G17 F60\nG0 X0 Y0\nG2 X1 Y0 Z0 R.5\nG2 X0 Y0 Z-.1 R.5\nM2\n"),
    ]);
    shop.kerf("convert tool.nc tool.sbp --units mm").exits(0).complains("C002");
    shop.kerf("convert arc.nc arc.sbp").exits(0).complains("C002");
    let texts = ["tool.sbp", "arc.sbp"].map(|file| shop.read(file));
    // No digits of the place a hair beside zero.
    assert!(texts.iter().all(|text| !text.contains("0.0219") && !text.contains("0.00086")));
    assert!(texts[1].contains("CG,,0,0,-0.5,0,T,1,-0.1,1"), "{}", texts[1]);
}
