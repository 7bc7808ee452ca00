//! `kerf plot`: what a plot says, as a user would read it.

use std::process::{Command, Output};

/// Runs `kerf plot part.sbp` with options, words separated by blanks; gives what was written.
fn plot(program: &str, options: &str) -> (Output, Option<Vec<u8>>) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("part.sbp"), program).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_kerf"))
        .current_dir(folder.path())
        .env("KERF_DATA", folder.path())
        .args(["plot", "part.sbp"])
        .args(options.split_whitespace())
        .output()
        .expect("kerf runs");
    let file = options.split_whitespace().find(|word| word.starts_with("out."));
    let written = file.and_then(|file| std::fs::read(folder.path().join(file)).ok());
    (output, written)
}

fn svg(program: &str, options: &str) -> String {
    let (output, written) = plot(program, &format!("-o out.svg {options}"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(written.unwrap()).unwrap()
}

fn check(svg: &str, words: &[&str]) {
    for word in words {
        assert!(svg.contains(&format!(">{word}</text>")), "no {word:?}");
    }
}

#[test]
fn a_single_ramp_is_the_one_of_the_manual() {
    let svg = svg("MX,4\n", "");
    check(
        &svg,
        &[
            "0:00:02.1 · 4.00 in · at most 2.00 in/s, 2.00 programmed · ramps shopbot",
            "Speed, in/s",
            "Acceleration, in/s²",
            "Jerk, over 1 ms, in/s³",
            "time, s",
            "way along the path, in",
            "programmed speed",
        ],
    );
    // Up, level and down: the area under the speed is six corners; a step of .4 in/s at each end.
    let area = svg.split("fill=\"#e2e5f0\" d=\"").nth(1).unwrap().split('"').next().unwrap();
    assert!(area.len() < 120, "{area}");
}

#[test]
fn units_models_axes_and_sides_are_as_asked() {
    let mm = svg("MX,100\nMY,50\n", "--units mm --ramps optimal --axes xz --over time");
    check(&mm, &["Speed, mm/s", "X", "Z"]);
    assert!(mm.contains("ramps optimal") && !mm.contains(">Y</text>"));
    assert!(!mm.contains("way along the path"));
    assert!(!svg("MX,4\n", "--over path").contains("time, s"));
}

#[test]
fn lines_tool_paths_jogs_and_waits_are_marked() {
    let program = "'Toolpath Name = Pocket\nJZ,1\nPAUSE 2\nMX,4\n'Toolpath Name = Outline\nMY,4\n";
    let svg = svg(program, "");
    check(&svg, &["Pocket", "Outline", "cut", "jog", "stands", "2", "4", "6"]);
}

#[test]
fn a_window_shows_its_stretch_of_time() {
    let svg = svg("MX,4\n", "--from 1 --to 1.5");
    check(&svg, &["0:00:00.5 · 1.00 in · at most 2.00 in/s, 2.00 programmed · ramps shopbot"]);
}

#[test]
fn a_png_is_as_wide_as_asked() {
    let (_, written) = plot("MX,4\n", "-o out.png --pixels 600");
    let png = written.unwrap();
    assert_eq!(&png[1..4], b"PNG");
    assert_eq!(u32::from_be_bytes(png[16..20].try_into().unwrap()), 600);
}

#[test]
fn mistakes_are_told_and_nothing_is_written() {
    for (options, words) in [
        ("-o out.gif", "plots end in .svg or .png"),
        ("-o out.svg --from 2 --to 1", "--to must be later than --from"),
        ("-o out.svg --axes q", "give letters of axes"),
    ] {
        let (output, written) = plot("MX,4\n", options);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && told.contains(words), "{options}: {told}");
        assert!(written.is_none());
    }
    let (output, written) = plot("'nothing moves\n", "-o out.svg");
    assert!(output.status.success());
    check(std::str::from_utf8(&written.unwrap()).unwrap(), &["nothing moves"]);
}

#[test]
fn degrees_stay_degrees_beside_inches() {
    // A quarter of a turn at 10 degrees a second, B; the lengths are inches.
    let svg = svg("VD,,5\nVS,,,,10\nMX,1\nMB,90\n", "--axes xb");
    assert!(svg.contains("at most 10.00 in/s") && svg.contains("B in degrees"), "{svg}");
}
