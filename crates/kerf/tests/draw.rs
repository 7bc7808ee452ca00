//! `kerf draw` as a user has it.

use std::path::Path;
use std::process::{Command, Output};

fn kerf(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kerf"));
    command.current_dir(folder).env("KERF_DATA", folder.join("data"));
    command.args(args).output().unwrap()
}

fn told(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn shapes(folder: &Path, file: &str) -> Vec<serde_json::Value> {
    let output = kerf(folder, &["draw", file, "--list"]);
    assert_eq!(output.status.code(), Some(0), "{}", told(&output));
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn a_drawing_is_made_written_and_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let script = "line 0,0 100,0 100,100 0,100 close; circle 50,50 25; select 2; group red; \
        directions auto";
    let made = kerf(folder.path(), &["draw", "--do", script, "-o", "part.rsg"]);
    assert_eq!(made.status.code(), Some(0), "{}", told(&made));
    let shapes = shapes(folder.path(), "part.rsg");
    assert_eq!(shapes.len(), 2);
    assert_eq!(shapes[0]["kind"], "polyarc");
    assert_eq!(shapes[0]["area"], 10000.0);
    assert_eq!(shapes[1]["group"], "red");
    assert_eq!(shapes[1]["points"][0], serde_json::json!([75.0, 50.0, -1.0]));
    assert_eq!(shapes[1]["bounds"]["min"], serde_json::json!({"x": 25.0, "y": 25.0}));
}

#[test]
fn pro_import_dxf_manipulate() {
    let folder = tempfile::tempdir().unwrap();
    let circle =
        "0\nSECTION\n2\nENTITIES\n0\nCIRCLE\n8\ncut\n10\n5\n20\n6\n40\n2.5\n0\nENDSEC\n0\nEOF\n";
    std::fs::write(folder.path().join("part.dxf"), circle).unwrap();
    let script = "select all; group blue; set blue offset=3 lead-in=5,90";
    let made = kerf(folder.path(), &["draw", "part.dxf", "--do", script, "-o", "part.rsg"]);
    assert_eq!(made.status.code(), Some(0), "{}", told(&made));
    let dxf = kerf(folder.path(), &["draw", "part.rsg", "-o", "out.dxf"]);
    assert!(told(&dxf).contains("groups and arrays will not be saved"));
    let (rsg, dxf) = (shapes(folder.path(), "part.rsg"), shapes(folder.path(), "out.dxf"));
    assert_eq!(rsg[0]["group"], "blue");
    assert_eq!(dxf[0]["group"], "black");
    assert_eq!(rsg[0]["points"], dxf[0]["points"]);
}

/// Number of shapes that `kerf draw FILE --list` draws, and its words.
fn listed(folder: &Path, file: &str, text: &str, options: &[&str]) -> (usize, String) {
    std::fs::write(folder.join(file), text).unwrap();
    let did = kerf(folder, &[&["draw", file, "--list"], options].concat());
    (String::from_utf8_lossy(&did.stdout).lines().count(), told(&did))
}

#[test]
fn what_is_not_drawn_is_told_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let svg = "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm' viewBox='0 0 9 9'>\n  \
               <style>.fold { visibility: hidden }</style>\n  <rect width='50%' height='1'/>\n  \
               <rect class='fold' width='3' height='3'/><text>a</text>\n</svg>";
    let (drawn, told) = listed(folder.path(), "box.svg", svg, &[]);
    assert_eq!(drawn, 1);
    assert!(told.contains("box.svg:4:3: warning: <rect> is hidden (visibility: hidden)"), "{told}");
    assert!(told.contains("box.svg:4:44: warning: <text> is left out"), "{told}");
    let dxf = "0\nSECTION\n2\nTABLES\n0\nLAYER\n2\nfold\n62\n-1\n70\n0\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n\
               0\nCIRCLE\n8\nfold\n10\n0\n20\n0\n40\n1\n0\nCIRCLE\n8\ncut\n10\n0\n20\n0\n40\n2\n0\nENDSEC\n0\nEOF\n";
    let (drawn, told) = listed(folder.path(), "box.dxf", dxf, &[]);
    assert_eq!(drawn, 1);
    assert!(
        told.contains("warning: 1 entity left out: layer `fold` is off in the drawing"),
        "{told}"
    );
    assert_eq!(listed(folder.path(), "box.dxf", dxf, &["--hidden"]), (2, String::new()));
}

#[test]
fn a_drawing_of_nothing_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let svg = "<svg xmlns='http://www.w3.org/2000/svg'/>";
    let told = |file: &str, text: &str| listed(folder.path(), file, text, &[]).1;
    assert!(told("a.svg", svg).contains("a.svg: warning: nothing is drawn in this file"));
    assert!(
        told("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n").contains("nothing is drawn")
    );
}

#[test]
fn a_mistake_names_the_clause_and_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    for (script, message) in [
        ("circle 0,0 5; move 1,1", "clause 2 `move 1,1`: no shapes selected"),
        ("circle 0,0", "clause 1 `circle 0,0`: the radius is missing; write `circle X,Y RADIUS`"),
    ] {
        let output = kerf(folder.path(), &["draw", "--do", script, "-o", "x.rsg"]);
        assert_eq!(output.status.code(), Some(1));
        assert!(told(&output).contains(message), "{}", told(&output));
        assert!(!folder.path().join("x.rsg").exists());
    }
}

#[test]
fn what_cannot_be_read_is_told() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("photo.dxf"), b"\x89PNG\r\n\x1a\n\0\0\0").unwrap();
    let output = kerf(folder.path(), &["draw", "photo.dxf", "--list"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(told(&output).contains("photo.dxf: nothing of a drawing could be read"));
    // A disk that was full leaves files without a byte.
    for words in ["draw --list a.dxf", "draw --list a.rsg", "toolpath a.rsg", "run a.rsm"] {
        let words: Vec<&str> = words.split(' ').collect();
        let file = words[words.len() - 1];
        std::fs::write(folder.path().join(file), b"").unwrap();
        let output = kerf(folder.path(), &words);
        assert_eq!(output.status.code(), Some(1), "{words:?}");
        assert!(told(&output).contains(&format!("{file}:1: warning: the file is empty")));
        assert!(told(&output).contains(&format!("{file}: nothing of a drawing could be read")));
    }
    let output = kerf(folder.path(), &["draw", "missing.dxf", "--list"]);
    assert_eq!(output.status.code(), Some(2));
    let output = kerf(folder.path(), &["draw", "photo.dxf"]);
    assert!(told(&output).contains("name an output with -o photo.rsg, or --list"));
}

#[test]
fn the_layers_of_a_file_become_groups_when_asked() {
    let folder = tempfile::tempdir().unwrap();
    let point = |layer: &str| format!("0\nPOINT\n8\n{layer}\n10\n5\n20\n6\n");
    let text = point("holes") + &point("cuts") + &point("holes") + &point("Black") + "0\nEOF\n";
    std::fs::write(folder.path().join("part.dxf"), text).unwrap();
    let output = kerf(folder.path(), &["draw", "part.dxf", "--layers", "-o", "part.rsg"]);
    assert!(told(&output).contains("layer cuts is group green"));
    let groups: Vec<_> =
        shapes(folder.path(), "part.rsg").iter().map(|shape| shape["group"].clone()).collect();
    // A layer named as a group is that group.
    assert_eq!(groups, ["blue", "green", "blue", "black"]);
}

#[test]
fn pro_files_rsm_name() {
    let folder = tempfile::tempdir().unwrap();
    let script = "line 0,0 100,0 100,100 0,100 close; set black offset=5; array block 2x3";
    kerf(folder.path(), &["draw", "--do", script, "-o", "job.rsg"]);
    let made = kerf(folder.path(), &["toolpath", "job.rsg", "--report"]);
    assert_eq!(made.status.code(), Some(0), "{}", told(&made));
    let report = String::from_utf8(made.stdout).unwrap();
    let black: Vec<_> = report.lines().nth(1).unwrap().split_whitespace().collect();
    assert_eq!(black[..3], ["black", "6", "2588.5"], "{report}");
    assert_eq!(black.last(), Some(&"1"));
    assert_eq!(shapes(folder.path(), "job.rsm").len(), 6);
}

/// The motion lines of the part program of a drawing, one a line.
fn program(script: &str) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    kerf(folder.path(), &["draw", "--do", script, "-o", "job.rsg"]);
    let made = kerf(folder.path(), &["toolpath", "job.rsg", "-o", "job.sbp"]);
    assert_eq!(made.status.code(), Some(0), "{}", told(&made));
    let text = std::fs::read_to_string(folder.path().join("job.sbp")).unwrap();
    // C# is the answer to a machine set to the other unit.
    let motion = text.lines().filter(|line| line.starts_with(['M', 'J', 'P']));
    motion.map(str::to_owned).collect()
}

#[test]
fn pro_group_multi_order() {
    let closed = "line 0,0 9,0 9,9 close; line 50,0 59,0 59,9 close; set black height=-8 pass=4";
    let around = |x: u32| {
        let (a, b) = (x, x + 9);
        let lap = [format!("MX,{b}"), "MY,9".into(), format!("M2,{a},0")];
        [vec!["MZ,-4".into()], lap.to_vec(), vec!["MZ,-8".into()], lap.to_vec()].concat()
    };
    let travel = |words: &[&str]| words.iter().map(|w| w.to_string()).collect::<Vec<_>>();
    let home = travel(&["JZ,10", "JX,0"]);
    let expected =
        [travel(&["JZ,10"]), around(0), travel(&["JZ,10", "JX,50"]), around(50), home].concat();
    assert_eq!(program(closed), expected);
    let open = program("line 0,0 9,0; set black height=-8 pass=4");
    assert_eq!(open, ["JZ,10", "MZ,-4", "MX,9", "JZ,10", "JX,0", "MZ,-8", "MX,9", "JZ,10", "JX,0"]);
}

#[test]
fn pro_group_rough_multi() {
    let script = "line 0,0 100,0; set black height=-9 pass=4 offset=3 rough=0.5";
    let lines = program(script);
    let depths: Vec<_> = lines.iter().filter(|line| line.starts_with("MZ")).collect();
    assert_eq!(depths, ["MZ,-4", "MZ,-8", "MZ,-9", "MZ,-4", "MZ,-8", "MZ,-9"]);
    let sides: Vec<_> =
        lines.iter().filter(|l| l.starts_with("J2") || l.starts_with("JY")).collect();
    assert_eq!(sides[..2], ["JY,-3.5", "J2,0,-3"], "rough first: {lines:?}");
}

#[test]
fn traversal_shapes_lead_the_head_at_the_height_of_travel() {
    let script = "line 0,0 0,100 200,100; select 1; group red; set red traversal=on";
    assert_eq!(program(script), ["JZ,10", "JY,100", "JX,200", "J2,0,0"]);
}

#[test]
fn the_program_waits_before_a_pause_shape() {
    let script = "point 0,0; point 50,0; select 2; pause on; set black height=-2";
    let expected = ["JZ,10", "MZ,-2", "JZ,10", "JX,50", "PAUSE", "MZ,-2", "JZ,10", "JX,0"];
    let lines = program(script);
    let words: Vec<_> = lines.iter().map(|line| line.split(' ').next().unwrap()).collect();
    assert_eq!(words, expected, "{lines:?}");
}

#[test]
fn a_job_below_z_bottom_is_refused_with_its_shape() {
    let folder = tempfile::tempdir().unwrap();
    let script = "point 0,0; set black height=-13";
    kerf(folder.path(), &["draw", "--do", script, "-o", "job.rsg"]);
    let made = kerf(folder.path(), &["toolpath", "job.rsg", "-o", "job.sbp"]);
    assert_eq!(made.status.code(), Some(1));
    assert!(
        told(&made).contains("shape 1 at 0,0: it would be cut at -13 mm, below ZBottom"),
        "{}",
        told(&made)
    );
    assert!(!folder.path().join("job.sbp").exists());
    let deeper = ["toolpath", "job.rsg", "-o", "job.sbp", "--z-bottom", "-20"];
    assert_eq!(kerf(folder.path(), &deeper).status.code(), Some(0));
}

#[test]
fn drawings_and_jobs_are_previewed_timed_and_run() {
    let folder = tempfile::tempdir().unwrap();
    let script = "circle 50,50 25; set black offset=5 lead-in=5,90";
    kerf(folder.path(), &["draw", "--do", script, "-o", "job.rsg"]);
    kerf(folder.path(), &["toolpath", "job.rsg"]);
    for args in [
        &["run", "job.rsm", "--units", "mm"][..],
        &["time", "job.rsg", "--units", "mm"],
        &["preview", "job.rsg", "-o", "job.svg", "--units", "mm"],
    ] {
        let output = kerf(folder.path(), args);
        assert_eq!(output.status.code(), Some(0), "{args:?}: {}", told(&output));
    }
    let trace = kerf(folder.path(), &["trace", "job.rsm", "--units", "mm"]);
    let trace = String::from_utf8(trace.stdout).unwrap();
    let arcs = trace.lines().filter(|line| line.contains("\"e\":\"arc\"")).count();
    assert_eq!(arcs, 3, "the lead and two halves of the circle");
}

/// Script that audits files with ezdxf, a reader of DXF that is not ours: errors it would mend, and entities.
const AUDIT: &str = "
import sys, ezdxf
for name in sys.argv[1:]:
    drawing = ezdxf.readfile(name)
    audit = drawing.audit()
    print(len(audit.errors) + len(audit.fixes), len(drawing.modelspace()))
";

/// Runs where python3 has ezdxf; elsewhere it says that it is skipped.
#[test]
fn other_programs_read_what_is_written() {
    let has = Command::new("python3").args(["-c", "import ezdxf"]).output();
    if !has.is_ok_and(|python| python.status.success()) {
        eprintln!("skipped: ezdxf is not installed");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let script = "circle 50,50 25; line 0,0,0.3 10,1 20,5 close; point 3,4; select 1; group red; \
        array block 2x3 gap 5,5; comment birch";
    kerf(folder.path(), &["draw", "--do", script, "-o", "a.rsg"]);
    kerf(folder.path(), &["draw", "a.rsg", "-o", "a.dxf"]);
    kerf(folder.path(), &["toolpath", "a.rsg"]);
    let mut python = Command::new("python3");
    python.current_dir(folder.path()).args(["-c", AUDIT, "a.rsg", "a.dxf", "a.rsm"]);
    let told = String::from_utf8(python.output().unwrap().stdout).unwrap();
    assert_eq!(told, "0 3\n0 3\n0 18\n");
}

/// Number of shapes that a script leaves of `a.dxf`, which has three; `b.rsm` and its like have two.
fn after_loading(folder: &Path, script: &str) -> usize {
    let made = kerf(folder, &["draw", "a.dxf", "--do", script, "-o", "out.rsg"]);
    assert_eq!(made.status.code(), Some(0), "{}", told(&made));
    shapes(folder, "out.rsg").len()
}

fn folder_with_drawings() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    kerf(path, &["draw", "--do", "point 1,1; point 2,2; circle 9,9 3", "-o", "a.dxf"]);
    kerf(path, &["draw", "--do", "rect 30,40 80,60; circle 55,50 5", "-o", "b.dxf"]);
    kerf(path, &["draw", "b.dxf", "-o", "b.rsg"]);
    kerf(path, &["toolpath", "b.rsg"]);
    folder
}

#[test]
fn pro_clipboard_loadfile() {
    let folder = folder_with_drawings();
    for file in ["b.dxf", "b.rsg", "b.rsm"] {
        let script = format!("load-clipboard {file}");
        assert_eq!(after_loading(folder.path(), &script), 3, "the drawing stays as it is");
        let made = kerf(folder.path(), &["draw", "a.dxf", "--do", &script, "--list"]);
        assert!(told(&made).contains(&format!("2 shapes of {file} are on the clipboard")));
    }
    std::fs::copy(folder.path().join("b.dxf"), folder.path().join("b.txt")).unwrap();
    for (file, message) in [
        ("b.txt", "the clipboard takes .dxf, .svg, .rsg and .rsm files"),
        ("no.dxf", "cannot read"),
    ] {
        let script = format!("load-clipboard {file}");
        let made = kerf(folder.path(), &["draw", "a.dxf", "--do", &script, "-o", "no.rsg"]);
        assert!(told(&made).contains(message), "{}", told(&made));
        assert!(told(&made).contains(&format!("clause 1 `{script}`: ")), "{}", told(&made));
        assert_eq!(made.status.code(), Some(1), "the clause is wrong, not the command line");
        assert!(!folder.path().join("no.rsg").exists());
    }
}

#[test]
fn pro_clipboard_dxf_via_clip() {
    let folder = folder_with_drawings();
    assert_eq!(after_loading(folder.path(), "load-clipboard b.dxf; paste 0,0"), 5);
    let placed = &shapes(folder.path(), "out.rsg")[3];
    assert_eq!(placed["bounds"]["max"], serde_json::json!({"x": 50.0, "y": 20.0}));
    // What a program cuts goes the same way, once it is a drawing.
    std::fs::write(folder.path().join("c.nc"), "G71\nG0 X0 Y0\nG1 X10 F500\nG1 Y10\n").unwrap();
    kerf(folder.path(), &["draw", "c.nc", "-o", "c.rsg"]);
    assert_eq!(after_loading(folder.path(), "load-clipboard c.rsg; paste absolute 0,0"), 4);
}

#[test]
fn a_program_that_cuts_nothing_is_no_drawing() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in
        [("e.nc", ""), ("j.nc", "G71\nG0 X10\n"), ("e.sbp", ""), ("c.sbp", "' no\n")]
    {
        std::fs::write(folder.path().join(name), text).unwrap();
        let made = kerf(folder.path(), &["draw", name, "--list"]);
        assert!(told(&made).contains("the program cuts nothing"), "{name}: {}", told(&made));
        assert_eq!(made.status.code(), Some(1), "{name}");
    }
}

#[test]
fn pro_sequence_full_show__list() {
    let folder = folder_with_drawings();
    let made = kerf(folder.path(), &["draw", "a.dxf", "--do", "pick 3; pick 1", "--list"]);
    let text = String::from_utf8(made.stdout).unwrap();
    let picks: Vec<_> = text
        .lines()
        .map(|line| serde_json::from_str::<serde_json::Value>(line).unwrap()["pick"].clone())
        .collect();
    assert_eq!(picks, [serde_json::json!(2), serde_json::Value::Null, serde_json::json!(1)]);
}

#[cfg(unix)]
#[test]
fn the_drawing_on_disk_outlives_a_full_disk_and_a_kill() {
    let folder = tempfile::tempdir().unwrap();
    let read = || std::fs::read(folder.path().join("a.rsg")).unwrap();
    kerf(folder.path(), &["draw", "--do", "rect 0,0 10,10", "-o", "a.rsg"]);
    let before = read();
    let grow = "select all; array rect 30x30 spacing 1,1";
    // A bound on the size of files fails as a full disk does.
    let program = env!("CARGO_BIN_EXE_kerf");
    let full =
        format!("trap '' XFSZ; ulimit -f 8; exec '{program}' draw a.rsg --do '{grow}' -o a.rsg");
    let mut shell = Command::new("sh");
    shell.current_dir(folder.path()).env("KERF_DATA", folder.path().join("data"));
    let shell = shell.args(["-c", &full]).output().unwrap();
    assert_eq!(shell.status.code(), Some(1), "{}", told(&shell));
    assert!(told(&shell).contains("cannot write a.rsg"), "{}", told(&shell));
    assert_eq!(read(), before);
    // The drawing and the data folder.
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2, "nothing is left beside it");
    kerf(folder.path(), &["draw", "a.rsg", "--do", grow, "-o", "b.rsg"]);
    let after = std::fs::read(folder.path().join("b.rsg")).unwrap();
    for moment in 0..40 {
        let args = ["draw", "a.rsg", "--do", grow, "-o", "a.rsg", "--force"];
        let mut command = Command::new(program);
        command.current_dir(folder.path()).env("KERF_DATA", folder.path().join("data"));
        let mut child = command.args(args).spawn().unwrap();
        std::thread::sleep(std::time::Duration::from_millis(2 * moment));
        let _ = child.kill();
        child.wait().unwrap();
        let now = read();
        assert!(now == before || now == after, "half a drawing after {moment}: {}", now.len());
        std::fs::write(folder.path().join("a.rsg"), &before).unwrap();
    }
}

#[test]
fn pro_files_dxf_in() {
    let folder = folder_with_drawings();
    let output = kerf(folder.path(), &["draw", "a.dxf", "--do", "select all; group red"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(told(&output).contains("name an output with -o a.rsg"), "{}", told(&output));
    kerf(folder.path(), &["draw", "a.dxf", "--do", "select all; group red", "-o", "a.rsg"]);
    assert_eq!(shapes(folder.path(), "a.rsg")[0]["group"], "red", "augmented and kept");
}

/// Entities and the bounds of their vertices as ezdxf has them; nothing where it is not installed.
fn by_ezdxf(folder: &Path, file: &str) -> Option<(u64, u64, Vec<f64>)> {
    let script = "
import sys, json, ezdxf
from ezdxf import bbox
drawing = ezdxf.readfile(sys.argv[1])
audit = drawing.audit()
box = bbox.extents(drawing.modelspace(), fast=False)
corners = list(box.extmin)[:2] + list(box.extmax)[:2]
print(json.dumps([len(audit.errors) + len(audit.fixes), len(drawing.modelspace()), corners]))
";
    let python = Command::new("python3").current_dir(folder).args(["-c", script, file]).output();
    let text = python.ok().filter(|run| run.status.success())?.stdout;
    serde_json::from_slice(&text).ok()
}

/// Every line of a file is DXF; what is Kerf's own stands in comments.
fn only_comments_are_our_own(folder: &Path, file: &str) {
    let text = std::fs::read_to_string(folder.join(file)).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    for pair in lines.chunks(2).filter(|pair| pair[1].starts_with("KERF ")) {
        assert_eq!(pair[0].trim(), "999");
    }
}

#[test]
fn pro_files_rsg_dxf() {
    let folder = tempfile::tempdir().unwrap();
    let script = "rect 10,20 110,80; circle 60,50 15; point 3,4; select 2; group red; comment birch; \
                  set red offset=3; array block 2x3 gap 5,5";
    kerf(folder.path(), &["draw", "--do", script, "-o", "job.rsg"]);
    only_comments_are_our_own(folder.path(), "job.rsg");
    let own = shapes(folder.path(), "job.rsg");
    if let Some((mistakes, count, corners)) = by_ezdxf(folder.path(), "job.rsg") {
        assert_eq!((mistakes, count as usize), (0, own.len()));
        for (found, expected) in corners.iter().zip([3.0, 4.0, 110.0, 80.0]) {
            assert!((found - expected).abs() < 1e-6, "{corners:?}");
        }
    }
    // Renamed, it is a drawing like any other: geometry and order, without what is Kerf's own.
    std::fs::copy(folder.path().join("job.rsg"), folder.path().join("plain.dxf")).unwrap();
    let plain = shapes(folder.path(), "plain.dxf");
    let boxes =
        |all: &[serde_json::Value]| all.iter().map(|s| s["bounds"].clone()).collect::<Vec<_>>();
    assert_eq!(boxes(&plain), boxes(&own));
}

#[test]
fn pro_files_rsm_dxf() {
    let folder = tempfile::tempdir().unwrap();
    let script = "line 0,0 100,0 100,100 0,100 close; array block 2x3 gap 10,10";
    kerf(folder.path(), &["draw", "--do", script, "-o", "job.rsg"]);
    kerf(folder.path(), &["toolpath", "job.rsg"]);
    only_comments_are_our_own(folder.path(), "job.rsm");
    if let Some((mistakes, count, corners)) = by_ezdxf(folder.path(), "job.rsm") {
        assert_eq!((mistakes, count), (0, 6));
        assert_eq!(corners, [0.0, 0.0, 320.0, 210.0]);
    }
    let text = std::fs::read_to_string(folder.path().join("job.rsm")).unwrap();
    assert_eq!(text.lines().filter(|line| *line == "POLYLINE").count(), 6);
}

#[test]
fn pro_files_rsm_edit() {
    let folder = tempfile::tempdir().unwrap();
    let run = |args: &[&str]| kerf(folder.path(), args);
    run(&["draw", "--do", "rect 0,0 10,10; circle 50,50 5", "-o", "job.rsg"]);
    run(&["toolpath", "job.rsg"]);
    let edited = run(&["draw", "job.rsm", "--do", "select 2; move 0,30", "-o", "job.rsm"]);
    assert_eq!(edited.status.code(), Some(0), "{}", told(&edited));
    let caution = "caution: tool paths were changed by hand";
    assert_eq!(told(&edited).matches(caution).count(), 1, "{}", told(&edited));
    let bounds = |file: &str| shapes(folder.path(), file)[1]["bounds"]["max"]["y"].clone();
    assert_eq!(bounds("job.rsm"), 85.0);
    let made = run(&["toolpath", "job.rsg"]);
    assert_eq!(made.status.code(), Some(1));
    assert!(told(&made).contains("--force makes them anew"), "{}", told(&made));
    assert_eq!(bounds("job.rsm"), 85.0, "it is as it was");
    assert_eq!(run(&["toolpath", "job.rsg", "-o", "other.rsm"]).status.code(), Some(0));
    assert_eq!(run(&["toolpath", "job.rsg", "--force"]).status.code(), Some(0));
    assert_eq!(bounds("job.rsm"), 55.0);
    // Made anew it is nobody's work any more.
    assert_eq!(run(&["toolpath", "job.rsg"]).status.code(), Some(0));
}

/// Ends of the moves of a job, working coordinates, and the shapes that are cut.
fn traced(folder: &Path, file: &str) -> (Vec<[f64; 2]>, Vec<u64>, Vec<serde_json::Value>) {
    let run =
        kerf(folder, &["trace", file, "--config", "sim", "--units", "mm", "--ramps", "profiler"]);
    assert_eq!(run.status.code(), Some(0), "{}", told(&run));
    let text = String::from_utf8(run.stdout).unwrap();
    let events: Vec<serde_json::Value> =
        text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let moves: Vec<_> = events.iter().filter(|event| event["e"] == "move").collect();
    let end =
        |event: &&serde_json::Value| ["x", "y"].map(|axis| event["to"][axis].as_f64().unwrap());
    let ends = moves.iter().map(end).collect();
    let cuts = moves.iter().filter(|event| event["kind"] == "cut");
    let mut lines: Vec<u64> = cuts.map(|event| event["line"].as_u64().unwrap()).collect();
    lines.dedup();
    let places = events.into_iter().filter(|event| event["e"] == "location").collect();
    (ends, lines, places)
}

#[test]
fn pro_files_rsm_origin() {
    let folder = tempfile::tempdir().unwrap();
    kerf(folder.path(), &["draw", "--do", "line 0,0 50,0", "-o", "job.rsg"]);
    let place = ["toolpath", "job.rsg", "--origin", "300,200", "--finish", "25,20"];
    assert_eq!(kerf(folder.path(), &place).status.code(), Some(0));
    // Opened again: the machine stands at home, which lies 300, 200 from the origin.
    let (ends, _, places) = traced(folder.path(), "job.rsm");
    assert_eq!(ends.last(), Some(&[25.0, 20.0]));
    assert_eq!((&places[0]["set"]["x"], &places[0]["set"]["y"]), (&(-300).into(), &(-200).into()));
    // Saved again without a word, both stay.
    kerf(folder.path(), &["toolpath", "job.rsm", "-o", "again.rsm"]);
    let (ends, _, again) = traced(folder.path(), "again.rsm");
    assert_eq!((ends.last(), &again[0]["set"]), (Some(&[25.0, 20.0]), &places[0]["set"]));
}

#[test]
fn pro_files_rsm_start() {
    let folder = tempfile::tempdir().unwrap();
    let lines: Vec<String> = (1..=6).map(|n| format!("line 0,{n} 50,{n}")).collect();
    kerf(folder.path(), &["draw", "--do", &lines.join("; "), "-o", "job.rsg"]);
    kerf(folder.path(), &["toolpath", "job.rsg"]);
    let saved = kerf(folder.path(), &["toolpath", "job.rsm", "-o", "job.rsm", "--begin-with", "5"]);
    assert_eq!(saved.status.code(), Some(0), "{}", told(&saved));
    assert_eq!(traced(folder.path(), "job.rsm").1, [5, 6]);
    let beyond = kerf(folder.path(), &["toolpath", "job.rsg", "--begin-with", "7"]);
    assert_eq!(beyond.status.code(), Some(2));
    assert!(told(&beyond).contains("--begin-with 7: the job has 6 paths"));
}

#[test]
fn pro_files_editonly() {
    let folder = folder_with_drawings();
    let run = |words: &str| {
        let args: Vec<&str> = words.split(' ').collect();
        kerf(folder.path(), &args)
    };
    for words in ["draw a.dxf -o c.rsg", "toolpath c.rsg", "preview c.rsg -o c.svg", "send --help"]
    {
        let done = run(&format!("{words} --edit-only"));
        assert_eq!(done.status.code(), Some(0), "{words}: {}", told(&done));
    }
    for words in ["run c.rsm", "machine home", "machine set zpos.top_mm -5", "io", "registry get a"]
    {
        let refused = run(&format!("--edit-only {words}"));
        assert_eq!(refused.status.code(), Some(2), "{words}");
        assert!(
            told(&refused).contains("not available in editing version") || words == "io",
            "{words}: {}",
            told(&refused)
        );
    }
}
