//! Place of a job, its cutting values, and the offset of the whole.

use crate::shop::Shop;
use serde_json::Value;

/// A shop with the simulated machine and a drawing.
fn shop(clauses: &str) -> Shop {
    let shop = Shop::new(&[]);
    shop.kerf("machine use sim").exits(0);
    let did = shop.command().args(["draw", "--do", clauses, "-o", "job.rsg"]).output().unwrap();
    assert!(did.status.success());
    shop
}

/// Lines of `kerf machine pos`.
fn position(shop: &Shop) -> Vec<String> {
    shop.kerf("machine pos").out().lines().map(str::to_owned).collect()
}

/// Place at which the head ended, machine frame.
fn ended(shop: &Shop) -> [f64; 2] {
    let lines = position(shop);
    [0, 1].map(|i| lines[i].split_whitespace().nth(1).unwrap().parse().unwrap())
}

#[test]
fn pro_job_origin_cmp() {
    let shop = shop("line 0,0 10,0");
    shop.kerf("machine move to 120,80,").exits(0);
    shop.kerf("machine origin here").exits(0).says("job.origin_mm = [120, 80]");
    let lines = position(&shop);
    assert!(lines[0].starts_with("x  120.000") && lines[1].starts_with("y  80.000"));
    assert_eq!(lines.last().unwrap(), "0.000,0.000 from the job origin");
    shop.kerf("machine origin 300,200").exits(0);
    shop.kerf("machine origin").exits(0).says("[300, 200]");
    shop.kerf("machine origin there").exits(2);
}

/// Jobs that begin where the tool is leave the origin there afterwards.
#[test]
fn pro_job_origin_start_yes__at_the_command_line() {
    let shop = shop("line 0,0 10,0");
    shop.kerf("toolpath job.rsg").exits(0);
    let origin_behind = |starts_there: &str, options: &str| {
        shop.kerf(&format!("machine set job.change_origin_at_start {starts_there}")).exits(0);
        shop.kerf("machine origin 300,200").exits(0);
        shop.kerf("machine move to -250,-140,").exits(0);
        shop.kerf(&format!("run job.rsm {options}")).exits(0);
        shop.kerf("machine origin").exits(0).out()
    };
    assert_eq!(origin_behind("true", "--start kept"), "job.origin_mm = [50, 60]\n");
    assert_eq!(origin_behind("false", "--start kept"), "job.origin_mm = [300, 200]\n");
    assert_eq!(origin_behind("true", "--start fresh"), "job.origin_mm = [300, 200]\n");
}

#[test]
fn pro_job_origin_saved() {
    let shop = shop("line 0,0 10,0");
    shop.kerf("toolpath job.rsg --origin 300,200 --finish 0,0").exits(0);
    shop.kerf("run job.rsm --start kept").exits(0);
    let [x, y] = ended(&shop);
    // One step is 0.004 mm.
    assert!((x - 300.0).abs() <= 0.004 && (y - 200.0).abs() <= 0.004, "{x} {y}");
}

#[test]
fn pro_job_origin_reopen() {
    let shop = shop("line 0,0 10,0");
    shop.kerf("toolpath job.rsg --origin 300,200").exits(0);
    shop.kerf("machine move to 1,1,").exits(0);
    shop.kerf("machine origin here").exits(0).says("[1, 1]");
    // The job is opened again: it has the origin it was saved with.
    shop.kerf("run job.rsm --start kept").exits(0);
    assert_eq!(ended(&shop), [300.0, 200.0]);
}

#[test]
fn pro_job_finish_saved() {
    let shop = shop("line 0,0 10,0");
    shop.kerf("toolpath job.rsg --finish 25,20").exits(0);
    shop.kerf("toolpath job.rsm -o again.rsm").exits(0);
    shop.kerf("run again.rsm --start kept").exits(0);
    assert_eq!(ended(&shop), [25.0, 20.0]);
}

/// The origin and the finish of the machine are for jobs that name none; 0,0 is a place.
#[test]
fn a_place_of_zero_is_a_place() {
    let shop = shop("line 0,0 10,0");
    shop.kerf("machine set job.origin_mm 300,200").exits(0);
    shop.kerf("machine set job.finish_mm 25,20").exits(0);
    let ends = |options: &str| {
        shop.kerf(&format!("toolpath job.rsg {options}")).exits(0);
        shop.kerf("run job.rsm --start kept").exits(0);
        ended(&shop)
    };
    assert_eq!(ends(""), [325.0, 220.0]);
    assert_eq!(ends("--origin 0,0"), [25.0, 20.0]);
    assert_eq!(ends("--finish 0,0"), [300.0, 200.0]);
    assert_eq!(ends("--origin 0,0 --finish 0,0"), [0.0, 0.0]);
}

#[test]
fn pro_job_step_speeds() {
    let shop = shop("line 0,0 1000,0");
    shop.kerf("toolpath job.rsg").exits(0);
    let run = |words: &str| {
        let did = shop.kerf("run job.rsm --trace out.jsonl --start kept");
        did.exits(0).says(words);
        let cut = |e: &Value| e["e"] == "move" && e["kind"] == "cut";
        let events = shop.read("out.jsonl");
        let events = events.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
        let speeds: Vec<f64> = events.filter(cut).map(|e| e["speed"].as_f64().unwrap()).collect();
        (speeds[0], speeds[1])
    };
    assert_eq!(run("cutting at 6000 mm/min, plunging at 1200 mm/min"), (20.0, 100.0));
    shop.kerf("machine set smoothing.cut_speed_mm_s 50").exits(0);
    shop.kerf("machine set plunge.speed_mm_s 10").exits(0);
    assert_eq!(run("cutting at 3000 mm/min, plunging at 600 mm/min"), (10.0, 50.0));
}

#[test]
fn pro_speeds_cut_group__told() {
    let shop = shop("line 0,0 100,0; set black speed=9000");
    shop.kerf("toolpath job.rsg").exits(0);
    let did = shop.kerf("run job.rsm --start kept");
    did.exits(0).complains("group black: 9000 mm/min is limited to 6000 mm/min");
    did.complains("1 | shape 1");
}

#[test]
fn pro_job_step_z() {
    let shop = shop("line 0,0 10,0");
    shop.kerf("toolpath job.rsg").exits(0);
    shop.kerf("run job.rsm --start kept").says("Z top -10, surface -20, bottom -30 mm");
    for (which, z) in [("bottom", "-28"), ("surface", "-19"), ("top", "-9")] {
        shop.kerf(&format!("machine zset {which} {z}")).exits(0).says(z);
    }
    // In the configuration, for every run from now on.
    shop.kerf("machine get zpos.surface_mm").says("-19");
    shop.kerf("run job.rsm --start kept").says("Z top -9, surface -19, bottom -28 mm");
}

/// Bounds of what is cut, X and Y.
fn cut(shop: &Shop, options: &str) -> [f64; 2] {
    shop.kerf(&format!("run job.rsm --trace out.jsonl --start fresh {options}")).exits(0);
    let events = shop.read("out.jsonl");
    let end: Value = serde_json::from_str(events.lines().last().unwrap()).unwrap();
    let side = |axis: &str| {
        let [max, min] = ["max", "min"].map(|end_of| end["bounds"][end_of][axis].as_f64().unwrap());
        ((max - min) * 1e6).round() / 1e6
    };
    [side("x"), side("y")]
}

#[test]
fn pro_job_offsetjob() {
    let shop = shop("line 10,10 10,100 100,100 100,10 10,10");
    shop.kerf("toolpath job.rsg").exits(0);
    let before = shop.read("job.rsm");
    assert_eq!(cut(&shop, ""), [90.0, 90.0]);
    let whole = shop.read("out.jsonl");
    assert_eq!(cut(&shop, "--offset-job 1"), [88.0, 88.0]);
    // From the original each time.
    assert_eq!(cut(&shop, "--offset-job 2"), [86.0, 86.0]);
    assert_eq!(cut(&shop, "--offset-job=-1"), [92.0, 92.0]);
    assert_eq!(cut(&shop, "--offset-job 0"), [90.0, 90.0]);
    assert_eq!(shop.read("out.jsonl"), whole);
    assert_eq!(shop.read("job.rsm"), before);
    shop.kerf("run job.rsm --offset-job 60")
        .exits(2)
        .complains("shape 1: no path lies 60 mm beside it");
}

#[test]
fn pro_job_offsetjob__with_leads() {
    let shop = shop("rect 20,20 110,110; set black lead-in=5,90 lead-out=5,90");
    shop.kerf("toolpath job.rsg").exits(0);
    // Both leads lie outside at the lower left, 5 mm from where the path begins and ends: at the corner of the square, and
    // then 1 mm below it.
    assert_eq!(cut(&shop, ""), [95.0, 95.0]);
    assert_eq!(cut(&shop, "--offset-job 1"), [96.0, 97.0]);
    assert_eq!(cut(&shop, "--offset-job=-1"), [93.0, 93.0]);
}
