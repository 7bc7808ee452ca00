//! Rows whose words are of a warning, as the command prints it, and what the machine did all the same.

use crate::shop;
use crate::shop::Shop;

/// A part file runs to its end, prints these lines and warns of this, at a line.
#[track_caller]
fn check(program: &str, printed: &str, warning: &str, line: usize) {
    check_with(&[], program, printed, warning, &format!("part.sbp:{line}:"));
}

#[track_caller]
fn check_with(files: &[(&str, &str)], program: &str, printed: &str, warning: &str, place: &str) {
    let shop = Shop::new(files);
    shop.write("part.sbp", program.as_bytes());
    let did = shop.kerf("run part.sbp --start fresh");
    did.exits(0).complains(&format!("{warning}\n --> {place}"));
    assert!(did.out().starts_with(printed), "{printed:?} does not begin\n{}", did.out());
}

/// A part file that warns of nothing.
#[track_caller]
fn silent(program: &str, printed: &str) {
    let shop = Shop::new(&[("part.sbp", program)]);
    let did = shop.kerf("run part.sbp --start fresh");
    did.exits(0);
    assert!(!did.err().contains("warning"), "{}", did.err());
    assert!(did.out().starts_with(printed), "{printed:?} does not begin\n{}", did.out());
}

/// A part file that ends at an error.
#[track_caller]
fn fails(program: &str, error: &str) {
    let shop = Shop::new(&[("part.sbp", program)]);
    shop.kerf("run part.sbp --start fresh").exits(1).complains(error);
}

const PLACE: &str = "PRINT %(1);\" \";%(2);\" \";%(3)\n";

#[test]
fn sbp_cmd_home_safez_off() {
    let program = format!("M3,5,4,-.5\nVC,,,,OFF\nMH\nPRINT \"[\";%(28);\"]\"\n{PLACE}");
    check(&program, "[]\n0 0 -0.5\n", "Safe-Z is off: the tool goes home at its present height", 3);
}

#[test]
fn sbp_cmd_multi_blank() {
    let ends = |line: &str, place: &str| silent(&format!("M3,1,2,3\n{line}\n{PLACE}"), place);
    ends("M3,,5", "1 5 3\n");
    ends("J3,,,1", "1 2 1\n");
    ends("M2,4", "4 2 3\n");
    check(&format!("M3,1,2,3\nM2\n{PLACE}"), "1 2 3\n", "no location is given", 2);
}

#[test]
fn sbp_flow_goto_colon() {
    let program = "GOTO Out:\nMX,9\nOut:\nMX,1\nPRINT %(1)\n";
    check(program, "1\n", "a label is written without a colon after GOTO", 1);
    silent(&program.replace("GOTO Out:", "GOTO Out"), "1\n");
}

#[test]
fn sbp_flow_if_mixed() {
    silent("&a=\"10\"\nIF &a > 9 THEN MX,1\nPRINT %(1)\n", "1\n");
    check("&b=abc\nIF &b > 9 THEN MX,1\n", "", "'abc' and '9' are compared as text", 2);
}

#[test]
fn sbp_lang_label_duplicate() {
    let program = "A:\n&n=1\nGOTO B\nA:\n&n=2\nB:\nPRINT &n\n";
    check(program, "1\n", "label A repeated at line 4", 4);
    let jumps = "GOTO A\n&n=0\nA:\n&n=1\nGOTO B\nA:\n&n=2\nB:\nPRINT &n\n";
    check(jumps, "1\n", "label A repeated at line 6", 6);
}

#[test]
fn sbp_lang_label_spaces() {
    silent("GOTO SECOND PLUNGE\nMX,9\nSECOND PLUNGE:\nMX,1\nPRINT %(1)\n", "1\n");
}

#[test]
fn sbp_lang_sysvar_unknown() {
    fails("&a=%(500)\n", "no system variable 500");
    for number in [24, 26, 45, 59, 64, 65, 69, 70, 110] {
        let program = format!("&a=%({number})\nPRINT \"[\";&a;\"]\"\n");
        check(&program, "[]\n", &format!("system variable {number} is not assigned"), 1);
    }
}

#[test]
fn sbp_sys_unassigned() {
    let beyond = [124, 125, 130, 140, 143].into_iter().chain(146..=149).chain(157..=161);
    for number in beyond {
        let program = format!("&a=%({number})\nPRINT \"[\";&a;\"]\"\n");
        check(&program, "[]\n", &format!("system variable {number} is not assigned"), 1);
    }
    for number in [0, 162] {
        fails(&format!("&a=%({number})\n"), &format!("no system variable {number}"));
    }
}

#[test]
fn sbp_lang_var_limit() {
    let lines = |last: usize| (1..=last).map(|n| format!("&v{n}={n}\n")).collect::<String>();
    silent(&lines(100), "");
    let shop = Shop::new(&[("part.sbp", &format!("{}PRINT &v105\n", lines(105)))]);
    let did = shop.kerf("run part.sbp --start fresh");
    did.exits(0).says("105\n").complains("more than 100 variables\n   --> part.sbp:101:1");
    assert_eq!(did.err().matches("more than 100 variables").count(), 1, "{}", did.err());
}

#[test]
fn sbp_io_msgbox_comma() {
    let shop = Shop::new(&[("part.sbp", "MSGBOX(a, b, YesNo, t)\n")]);
    let did = shop.kerf("trace part.sbp");
    did.exits(0);
    let asked = did.all("ask").remove(0);
    assert_eq!((&asked["text"], &asked["title"]), (&"a".into(), &"YesNo".into()), "{asked}");
    check("MSGBOX(a, b, YesNo, t)\n", "", "MSGBOX takes three values", 1);
}

#[test]
fn sbp_io_write_comma_inquotes() {
    let shop = Shop::new(&[(
        "part.sbp",
        "OPEN \"o.txt\" FOR OUTPUT AS #1\nWRITE #1, \"a,b\"\nCLOSE #1\n",
    )]);
    let did = shop.kerf("run part.sbp --start fresh");
    did.exits(0).complains("the commas inside the quotes separate items").complains("semicolons");
    assert_eq!(shop.read("o.txt"), "a, b\n");
}

#[test]
fn sbp_out_so4_manual() {
    let program = "SO,4,1\nPRINT %(104)\nSO,4,-4\nSO,4,1\nPRINT %(104)\n";
    check(program, "0\n1\n", "output 4 is automatic; this line does nothing", 1);
}

#[test]
fn sbp_val_vc_plungedir() {
    silent("VC,,,,,+\nCC,4,T,1,0,360,.25,1,1,1,0,1\nPRINT %(3)\n", "0.25\n");
    check("VC,,,,,-\nCC,4,T,1,0,360,.25\n", "", "this plunge lifts the tool", 2);
}

#[test]
fn sbp_val_vd_version2() {
    let line = "VD,,3,0,0,2,1,0,.1,0,1,1,0,0,8800,4600,0,0,1";
    silent(&format!("{line}\n"), "");
    check(&format!("{line},7\n"), "", "the order of VD is that of version 3", 1);
}

#[test]
fn sbp_val_vr_warn() {
    check("VR,1.5\nPRINT \"on\"\n", "on\n", "xy move ramp speed is fast", 1);
    check("VR,.1\nPRINT \"on\"\n", "on\n", "xy move ramp speed is slow", 1);
    silent("VR,.5\n", "");
}

#[test]
fn sbp_val_vs_oldorder() {
    let program =
        "VD,,5\nVS, 1.25, .45, , 2.75, .80\nPRINT %(71);\" \";%(73);\" \";%(75);\" \";%(76)\n";
    check(program, "1.25 0.45 2.75 0.8\n", "this looks like the older order of speeds", 2);
}

#[test]
fn sbp_val_vu_noshift() {
    let program = "JS,20\nVU,,,,,,,,,,,,,,,,1\nJX,40\nPRINT %(1)\n";
    let words = "jogs are limited to 16 in/s (406.4 mm/s): resolution shifting is disabled";
    check(program, "40\n", words, 2);
    silent("VU,,,,,,,,,,,,,,,,1\nJS,16\nJX,40\n", "");
}

#[test]
fn sbp_cut_cp_nolift() {
    check("MZ,-.1\nCP,4,10,10\n", "", "CP moves to its first point below the surface", 2);
    silent("CP,4,10,10\n", "");
    let shop = Shop::new(&[("part.sbp", "MZ,-.1\nCP,4,10,10\n")]);
    let moves = shop.kerf("trace part.sbp").all("move");
    let to = &moves[1]["to"];
    assert_eq!(
        (to["x"].as_f64(), to["y"].as_f64(), to["z"].as_f64()),
        (Some(10.0), Some(12.0), Some(-0.1))
    );
}

#[test]
fn sbp_cmd_mi_oscillate() {
    silent("MI,Z,,,2,.5\nMX,5\nPRINT %(1)\n", "5\n");
    check("MI,Z,,,31,.1\n", "", "a very fast oscillation", 1);
    fails("MI,Z,,5,2,.5\n", "a rotary speed and a frequency exclude each other");
}

#[test]
fn sbp_file_fp_plunge_zmoves() {
    let words = "t.sbp has Z moves; plunge passes will not be correct";
    let inner = "MZ,-1\nMX,2\nPRINT %(1);\" \";%(3)\n";
    check_with(&[("t.sbp", inner)], "FP,t.sbp,,,,,,-.25\n", "2 -1\n", words, "part.sbp:1:");
}

#[test]
fn sbp_cmd_z_infile() {
    let inner = "MX,1\nZX\nPRINT %(1)\nMX,1\n";
    let program = "ZT\nM2,10,4\nFP,inner.sbp,,,,,2\nPRINT %(1);\" \";%(1)+%(6)\n";
    let words = "the offset of the file for X ends here";
    check_with(&[("inner.sbp", inner)], program, "0\n1 12\n", words, "inner.sbp:2:");
}

/// The warnings about the tool paths of a drawing, and how many paths there are.
#[track_caller]
fn paths(clauses: &str) -> (String, usize) {
    let shop = Shop::new(&[]);
    let mut draw = shop.command();
    draw.args(["draw", "--do", clauses, "-o", "job.rsg"]);
    shop::Did::of(draw.output().unwrap()).exits(0);
    let did = shop.kerf("toolpath job.rsg");
    did.exits(0);
    let list = shop.kerf("draw job.rsm --list").out();
    (did.err(), list.lines().count())
}

const HOLE: &str = "rect 0,0 100,100; select all; reverse";
const OTHER: &str = "rect 200,0 300,100; select 2; group red";

#[test]
fn pro_toolpath_offset_gone() {
    let (told, left) = paths(&format!("{HOLE}; set black offset=60; {OTHER}"));
    assert!(told.contains("shape 1 at 0,0: ") && told.contains("no path"), "{told}");
    assert_eq!(left, 1, "the other is cut");
}

#[test]
fn pro_toolpath_tag_long() {
    let (told, left) = paths(&format!("rect 0,0 100,100; set black tag=500; {OTHER}"));
    assert!(told.contains("shape 1 at 0,0: the tag of 500 mm is longer than its path"), "{told}");
    assert_eq!(left, 1, "the other is cut");
}

#[test]
fn pro_toolpath_leadin_gouge() {
    let lead = "set black offset=5 lead-in=10,90";
    let (told, _) = paths(&format!("{HOLE}; {lead}"));
    assert!(told.contains("shape 1 at 0,0: its lead-in cuts into it"), "{told}");
    let (told, _) = paths(&format!("{HOLE}; start 1 0,50; {lead}"));
    assert_eq!(told, "");
}

/// The warnings about an operation on a drawing, and the shapes it leaves.
#[track_caller]
fn drawn(clauses: &str) -> (String, Vec<serde_json::Value>) {
    let shop = Shop::new(&[]);
    let mut draw = shop.command();
    draw.args(["draw", "--do", clauses, "-o", "job.rsg"]);
    let did = shop::Did::of(draw.output().unwrap());
    did.exits(0);
    (did.err(), shop.kerf("draw job.rsg --list").events())
}

#[test]
fn pro_path_autodir_intersect() {
    let (told, shapes) =
        drawn("rect 0,0 60,60; rect 50,50 99,99; select all; reverse; directions auto");
    assert!(told.contains("shapes 1 and 2 cross each other: check their directions"), "{told}");
    assert!(shapes.iter().all(|shape| shape["area"].as_f64() > Some(0.0)), "{shapes:?}");
}

#[test]
fn pro_sequence_reverse() {
    let four = "rect 10,10 20,20; rect 0,0 100,100; rect 200,0 210,10; rect 300,0 310,10";
    let (_, before) = drawn(four);
    let (told, after) = drawn(&format!("{four}; sequence reverse"));
    assert!(told.contains("shape 3 is cut before shape 4, which lies in it"), "{told}");
    // Starts and directions are those of before.
    let points = |shapes: &[serde_json::Value]| -> Vec<_> {
        shapes.iter().map(|shape| shape["points"].to_string()).collect()
    };
    let mut turned = points(&before);
    turned.reverse();
    assert_eq!(points(&after), turned);
}
