//! `kerf toolpath` as a user has it: its report, its warnings, its pictures.

use crate::shop::{Did, Shop};
use serde_json::Value;

/// A plate with a hole in another group.
const PLATE: &str = "rect 0,0 100,60; circle 50,30 12; directions auto; set black offset=3 height=-4; \
                     select 2; group red; set red tool=2 offset=2 height=-2; sequence 2,1";

/// A folder with the drawing that a script makes, `job.rsg`.
fn drawn(script: &str) -> Shop {
    let shop = Shop::new(&[]);
    let made = shop.command().args(["draw", "--do", script, "-o", "job.rsg"]).output().unwrap();
    Did::of(made).exits(0);
    shop
}

/// A number of the JSON that a command prints.
fn total_of(shop: &Shop, args: &str, name: &str) -> f64 {
    shop.kerf(&format!("{args} --format json")).json()[name].as_f64().unwrap()
}

#[test]
fn a_report_tells_lengths_and_times_of_groups() {
    let shop = drawn(PLATE);
    let made = shop.kerf("toolpath job.rsg --report --format json --table 101,200");
    let told = made.exits(0).json();
    let groups = told["groups"].as_array().unwrap();
    let names: Vec<_> = groups.iter().map(|group| group["group"].as_str().unwrap()).collect();
    assert_eq!(names, ["black", "red"]);
    assert_eq!((&groups[0]["paths"], &groups[1]["tool"]), (&1.into(), &2.into()));
    let length = groups[1]["length_mm"].as_f64().unwrap();
    assert!((length - 20.0 * std::f64::consts::PI).abs() < 1e-6, "{length}");
    // The same plan as `kerf time` follows, of the job or of the program.
    let total = total_of(&shop, "time job.rsm", "total");
    let told_total = told["seconds"].as_f64().unwrap();
    assert!((total - told_total).abs() < 1e-6, "{total} {told_total}");
    let told_program = total_of(&shop, "toolpath job.rsg -o job.sbp --report", "seconds");
    let program = total_of(&shop, "time job.sbp --units mm", "total");
    assert!((program - told_program).abs() < 1e-6, "{program} {told_program}");
    let sum: f64 = groups.iter().map(|group| group["seconds"].as_f64().unwrap()).sum();
    assert!(sum > 0.5 * total && sum <= total + 1e-6, "{sum} of {total}");
    let warnings = told["warnings"].as_array().unwrap();
    let left = "shape 2 at 0,-3: leaves the table: 3.000 mm at the left, 2.000 mm at the right, 3.000 mm at the front";
    assert_eq!(warnings, &[Value::from(left)]);
}

#[test]
fn a_report_counts_every_pass_of_what_is_cut() {
    let shop = drawn("rect 10,10 20,20; set black height=-3 pass=1");
    let report = "toolpath job.rsg --report";
    // Round three times, and down from 10 mm above the surface to 3 mm below it.
    assert_eq!(total_of(&shop, report, "length_mm"), 40.0);
    let cut = total_of(&shop, report, "cut_mm");
    assert!((cut - 133.0).abs() < 1e-6, "{cut}");
}

#[test]
fn a_job_too_deep_for_the_machine_is_told_when_it_is_made() {
    let shop = drawn("rect 0,0 10,10; set black height=-12; array block 3x3 gap 5,5");
    let warned = |options: &str| {
        let made = shop.kerf(&format!("toolpath job.rsg {options}"));
        made.exits(0).err()
    };
    let why = "shape 1 at 0,0: it would be cut at -32 mm, below ZBottom at -30 mm";
    assert_eq!(warned("").trim_end(), format!("job.rsg: warning: {why}"), "once for nine copies");
    assert_eq!(warned("--z-bottom -40"), "");
    assert_eq!(warned("--z-surface=-18 --z-top=-5"), "");
    // The machine that is asked refuses it.
    let refused = shop.kerf("toolpath job.rsg --report");
    refused.exits(1).complains("below ZBottom");
    refused.complains("job.rsg: it does not run to its end: no report");
    assert_eq!(refused.out(), "", "no table of zeros");
}

#[test]
fn smoothing_is_for_every_model_of_motion_when_paths_are_made() {
    let shop = drawn(PLATE);
    for args in [
        "toolpath job.rsg --smoothing 0 --report",
        "toolpath job.rsg --smoothing 0 --report -o job.nc",
        "preview job.rsg --smoothing 0 -o job.svg",
    ] {
        shop.kerf(args).exits(0);
    }
}

/// The words of a picture's key about a script's groups.
/// Vertices that are too near to each other are left out of paths, whether a job file is made or the drawing is run.
#[test]
fn pro_options_filter__at_the_command_line() {
    let shop = drawn("line 0,0 0.01,0 10,0");
    let drawing = shop.read("job.rsg");
    let ends = || {
        let trace = shop.kerf("run job.rsg --trace - --quiet --data d --start kept").exits(0).out();
        let events = trace.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
        let cuts = events.filter(|event| event["e"] == "move" && event["kind"] == "cut");
        let level = cuts.filter(|cut| cut["t1"].as_f64() > cut["t0"].as_f64());
        let x: Vec<f64> = level.map(|cut| cut["to"]["x"].as_f64().unwrap()).collect();
        (x.contains(&0.01), x.last() == Some(&10.0))
    };
    shop.kerf("machine use sim --data d").exits(0);
    shop.kerf("machine set options.filter_mm 0 --data d").exits(0);
    assert_eq!(ends(), (true, true));
    shop.kerf("machine set options.filter_mm 0.02 --data d").exits(0);
    assert_eq!(ends(), (false, true));
    let vertices = |args: &str| {
        shop.kerf(&format!("toolpath job.rsg -o {args} --data d --start kept")).exits(0);
        shop.kerf("run f.rsm --trace - --quiet --config sim").out().contains("\"x\":0.01")
    };
    assert!(!vertices("f.rsm"));
    shop.kerf("machine set options.filter_mm 0 --data d").exits(0);
    assert!(vertices("f.rsm"));
    assert_eq!(shop.read("job.rsg"), drawing, "the drawing stays");
}

fn key_of(script: &str) -> Vec<String> {
    let shop = drawn(script);
    shop.kerf("toolpath job.rsg -o job.svg").exits(0);
    let picture = shop.read("job.svg");
    let told = ["black, tool 1", "red, tool 1", "a cut begins", "bounds of the cuts"];
    told.into_iter().filter(|words| picture.contains(words)).map(str::to_owned).collect()
}

#[test]
fn groups_that_only_drill_are_in_the_key_of_a_picture() {
    let cut = "rect 0,0 40,30; point 10,10; point 30,10; select 2,3; group red";
    let all = ["black, tool 1", "red, tool 1", "a cut begins", "bounds of the cuts"];
    assert_eq!(key_of(&format!("{cut}; set red height=-3")), all);
    let drilled = format!("{cut}; set black on=off; set red height=-3");
    assert_eq!(key_of(&drilled), ["red, tool 1", "bounds of the cuts"]);
}

#[test]
fn pictures_of_jobs_have_the_colours_of_groups_or_directions() {
    let shop = drawn(PLATE);
    let picture = |colours: &str| {
        shop.kerf(&format!("toolpath job.rsg -o job.svg --colours {colours}")).exits(0);
        shop.read("job.svg")
    };
    let (group, direction, depth) = (picture("group"), picture("direction"), picture("depth"));
    for words in
        ["black, tool 1, 6 mm wide", "red, tool 2, 4 mm wide", "a cut begins", "bounds of the cuts"]
    {
        assert!(group.contains(words), "{words}");
        assert!(!depth.contains(words), "{words}");
    }
    assert!(
        direction.contains("closed, counter-clockwise") && direction.contains("closed, clockwise")
    );
    assert!(depth.contains("Depth of cut"));
    shop.kerf("toolpath job.rsg -o job.png").exits(0);
    assert!(std::fs::read(shop.file("job.png")).unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn a_damaged_job_is_not_cut() {
    let script = "rect 50,50 150,150; select all; directions auto; set black height=-2 tool=2 cut=2 speed=1000";
    let shop = drawn(script);
    shop.kerf("toolpath job.rsg --config sim -o job.rsm").exits(0);
    let text = shop.read("job.rsm");
    let lines: Vec<&str> = text.lines().collect();
    let hurt = [&lines[..2], &lines[4..]].concat().join("\n");
    shop.write("hurt.rsm", hurt.as_bytes());
    let why = "the job is damaged and is not cut";
    for command in ["run --start fresh", "time", "trace", "preview -o p.svg", "convert"] {
        let out = if command == "convert" { "hurt.sbp" } else { "--config sim" };
        shop.kerf(&format!("{command} hurt.rsm {out}")).exits(1).complains(why);
    }
    shop.kerf("check hurt.rsm").exits(1).says("F005").says(why);
    shop.kerf("check job.rsm hurt.rsm --format json").exits(1).says("\"severity\":\"error\"");
    shop.kerf("toolpath hurt.rsm -o again.rsm").exits(1).complains(why);
    assert!(!shop.file("again.rsm").exists() && !shop.file("hurt.sbp").exists());
    // What is left of it can be looked at.
    shop.kerf("draw hurt.rsm -o left.rsg").exits(0).complains("groups and arrays are lost");
    // Line ends that another system wrote are no damage, and files of the old program have no data of Kerf's own.
    shop.write("dos.rsm", lines.join("\r\n").as_bytes());
    shop.kerf("run dos.rsm --config sim --start fresh").exits(0);
    let pairs = lines.chunks(2).filter(|pair| pair[0].trim() != "999");
    shop.write("old.rsm", pairs.flatten().copied().collect::<Vec<_>>().join("\n").as_bytes());
    shop.kerf("run old.rsm --config sim --start fresh").exits(0).says("cut ");
}
