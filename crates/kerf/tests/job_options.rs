//! Runs of a job under options and under the machine of the data folder.

use crate::shop::{Did, Shop};

/// A shop with a job of two lines, 100 mm each.
fn lines() -> Shop {
    let shop = Shop::new(&[]);
    let script = "line 0,0 100,0; line 100,50 0,50";
    let made = shop.command().args(["draw", "--do", script, "-o", "t2.rsg"]).output().unwrap();
    Did::of(made).exits(0);
    shop.kerf("toolpath t2.rsg --config sim -o t2.rsm").exits(0);
    shop
}

/// Shapes that are cut, in order: where each begins.
fn cuts(did: &Did) -> Vec<String> {
    did.exits(0);
    let flat = |event: &serde_json::Value| event["kind"] == "cut" && event["to"]["z"] == -30.0;
    let moves = did.all("move");
    let pairs = moves.windows(2).filter(|pair| flat(&pair[0]) && flat(&pair[1]));
    pairs.map(|pair| format!("{} to {}", pair[0]["to"]["x"], pair[1]["to"]["x"])).collect()
}

const TRACE: &str = "run t2.rsm --config sim --start fresh --trace -";

#[test]
fn a_job_begins_at_a_shape_and_is_repeated() {
    let shop = lines();
    let cut = |more: &str| cuts(&shop.kerf(&format!("{TRACE} {more}")));
    let (first, second) = ("0 to 100", "100 to 0");
    assert_eq!(cut(""), [first, second]);
    assert_eq!(cut("--from-line 2"), [second]);
    assert_eq!(cut("--repeat 2"), [first, second, first, second]);
    let total = |more: &str| {
        let did = shop.kerf(&format!("time t2.rsm --config sim --format json {more}"));
        did.exits(0).json()["cut"].as_f64().unwrap()
    };
    assert!((total("--repeat 3") - 3.0 * total("")).abs() < 0.1, "{}", total("--repeat 3"));
}

#[test]
fn a_job_that_was_stopped_begins_again_at_its_last_shape() {
    let shop = lines();
    shop.kerf("run t2.rsm --config sim --from-line last").exits(2).complains("no run of t2.rsm");
    shop.kerf("run t2.rsm --config sim --stop-at 11").exits(3);
    shop.kerf("send MZ,0").exits(0);
    let did = shop.kerf("run t2.rsm --config sim --from-line last --trace -");
    assert_eq!(cuts(&did), ["100 to 0"]);
}

#[test]
fn what_says_nothing_of_a_job_is_refused_by_name() {
    let shop = lines();
    for (option, instead) in [
        ("--proportion 2,2,1", "scale its drawing"),
        ("--proportion 0,0,0", "scale its drawing"),
        ("--offset 2d", "kerf toolpath --origin"),
        ("--plunge 1", "zpos.bottom_mm"),
        ("--tabs", "tag=2"),
        ("--plunge-from-zero", "zpos.top_mm"),
        ("--step", "pause on"),
        ("--hold-at 5.3 --resume-at 8", "paused=Continue"),
        ("--from-line 99", "has 2 shapes"),
        ("--from-line 0", "number of a line"),
        ("--from-line x", "number of a line"),
    ] {
        let name = option.split(' ').rev().find(|word| word.starts_with("--")).unwrap();
        for command in ["run --start fresh", "time", "check", "trace", "preview -o p.svg"] {
            let did = shop.kerf(&format!("{command} t2.rsm --config sim {option}"));
            // Nobody works at a machine that is only read for.
            let unheeded = command == "check" && option.starts_with("--hold-at");
            let why = if unheeded { "--hold-at is not heeded" } else { instead };
            did.exits(2).complains(if unheeded { "--hold-at" } else { name }).complains(why);
        }
    }
    shop.kerf("toolpath t2.rsg --repeat 3").exits(2).complains("--repeat");
    let hold = "run t2.rsm --config sim --start fresh --hold-at 5.3 --answers yes.txt";
    shop.write("yes.txt", b"paused=Continue\n");
    shop.kerf(hold).exits(0);
}

#[test]
fn a_run_takes_the_whole_machine_or_none_of_it() {
    let shop = lines();
    for setting in ["smoothing.cut_speed_mm_s 20", "delays.end_s 5", "zpos.top_mm -11"] {
        shop.kerf(&format!("machine set {setting}")).exits(0);
    }
    let mine = "cutting at 1200 mm/min, plunging at 1200 mm/min; Z top -11,";
    shop.kerf("run t2.rsm").exits(0).says(mine);
    let plain = Shop::new(&[]);
    std::fs::copy(shop.file("t2.rsm"), plain.file("t2.rsm")).unwrap();
    for command in ["run t2.rsm --start fresh", "time t2.rsm", "trace t2.rsm"] {
        assert_eq!(shop.kerf(command).exits(0).out(), plain.kerf(command).exits(0).out());
    }
    assert_ne!(shop.kerf("time t2.rsm --start kept").out(), plain.kerf("time t2.rsm").out());
    // Who names no data folder has a fresh machine, and is told so.
    let mut unnamed = shop.command();
    unnamed.env_remove("KERF_DATA").env("XDG_DATA_HOME", shop.path());
    std::fs::rename(shop.file("data"), shop.file("kerf")).unwrap();
    let did = Did::of(unnamed.args(["run", "t2.rsm"]).output().unwrap());
    did.exits(0).complains("--start kept").says("plunging");
    assert!(!did.out().contains(mine), "{}", did.out());
}

#[test]
fn the_origin_told_is_the_one_that_is_used() {
    let shop = lines();
    shop.kerf("toolpath t2.rsg --origin 10,20 -o o.rsm").exits(0);
    shop.kerf("run o.rsm --start fresh").exits(0).says("origin 10,20");
    shop.kerf("machine set job.origin_mm 3,4").exits(0);
    shop.kerf("run t2.rsm").exits(0).says("origin 3,4");
    shop.kerf("machine set job.change_origin_at_start true").exits(0);
    shop.kerf("run o.rsm").exits(0).says("origin where the tool is");
}
