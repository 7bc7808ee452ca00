//! Settings of VP about the preview show in the picture (command reference, VP).

use std::process::Command;

/// The SVG that `kerf preview` draws of a program.
fn svg(program: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let part = folder.path().join("part.sbp");
    std::fs::write(&part, program).unwrap();
    let status = Command::new(env!("CARGO_BIN_EXE_kerf"))
        .current_dir(folder.path())
        .env("KERF_DATA", folder.path())
        .args(["preview", "part.sbp", "-o", "part.svg"])
        .output()
        .expect("kerf runs");
    assert!(status.status.success(), "{}", String::from_utf8_lossy(&status.stderr));
    std::fs::read_to_string(folder.path().join("part.svg")).unwrap()
}

/// The last path of a layer; empty when there is no such layer.
fn last_path<'a>(svg: &'a str, layer: &str) -> &'a str {
    let Some((_, layer)) = svg.split_once(&format!("<g id=\"{layer}\"")) else { return "" };
    let (layer, _) = layer.split_once("</g>").unwrap();
    layer.rsplit_once(" d=\"").unwrap().1.split('"').next().unwrap()
}

const PART: &str = "JZ,1\nJ2,10,5\nMZ,-.5\nM2,50,30\n";

#[test]
fn sbp_val_vp_grid() {
    let lines = |spacing: &str| {
        let svg = svg(&format!("VP,{spacing}\n{PART}"));
        assert!(svg.contains(&format!(">{spacing} in</text>")), "the legend says so");
        last_path(&svg, "grid").matches(['M', 'm']).count()
    };
    // 96 by 48 inches.
    assert_eq!((lines("12"), lines("6")), (9 + 5, 17 + 9));
}

#[test]
fn sbp_val_vp_table() {
    let usual = svg(PART);
    assert_eq!(last_path(&usual, "table-edge"), "M0 -1219.2h2438.4v1219.2h-2438.4z");
    let small = svg(&format!("VP,,24,18,4\n{PART}"));
    assert_eq!(last_path(&small, "table-edge"), "M0 -457.2h609.6v457.2h-609.6z");
    assert!(small.contains("24 × 18 × 4 in"));
}

#[test]
fn sbp_val_vp_jogs() {
    let shown = svg(PART);
    assert_eq!(last_path(&shown, "jogs"), "M0 0l254 127");
    assert!(shown.contains("stroke=\"#d62828\""), "jogs are red");
    let hidden = svg(&format!("VP,,,,,,,,0\n{PART}"));
    assert_eq!(last_path(&hidden, "jogs"), "");
    assert!(last_path(&hidden, "cuts").ends_with("M254 127l1016 635"));
}

#[cfg(unix)]
#[test]
fn the_picture_on_disk_outlives_a_full_disk() {
    let folder = tempfile::tempdir().unwrap();
    let program = env!("CARGO_BIN_EXE_kerf");
    std::fs::write(folder.path().join("part.sbp"), PART).unwrap();
    let pictures = [
        ("preview part.sbp -o", "picture.svg"),
        ("preview part.sbp -o", "picture.png"),
        ("preview part.sbp -o", "picture.html"),
        ("plot part.sbp -o", "curves.svg"),
        ("timing part.sbp -o", "lines.svg"),
    ];
    for (words, picture) in pictures {
        let file = folder.path().join(picture);
        std::fs::write(&file, "the picture of yesterday").unwrap();
        // A bound on the size of files fails as a full disk does.
        let full = format!("trap '' XFSZ; ulimit -f 1; exec '{program}' {words} {picture} --force");
        let shell = Command::new("sh")
            .current_dir(folder.path())
            .env("KERF_DATA", folder.path())
            .args(["-c", &full])
            .output()
            .unwrap();
        let told = String::from_utf8_lossy(&shell.stderr);
        assert_eq!(shell.status.code(), Some(1), "{picture}: {told}");
        assert!(told.contains(&format!("cannot write {picture}")), "{told}");
        assert_eq!(std::fs::read(&file).unwrap(), b"the picture of yesterday", "{picture}");
    }
    let left = std::fs::read_dir(folder.path()).unwrap().map(|it| it.unwrap().file_name());
    let left: Vec<_> = left.filter(|name| name.to_string_lossy().starts_with('.')).collect();
    assert!(left.is_empty(), "nothing is left beside them: {left:?}");
}
