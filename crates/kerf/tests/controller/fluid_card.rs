//! `kerf machine card` on `FluidNC`: its own words, XMODEM on a line that loses packets, and its refusals.

use crate::bench::Bench;
use crate::card::{card, ctrl_c_ends_square, interrupted, started};
use crate::shop::Shop;
use kerf_driver_grbl::fake::{Board, Fake};

const SQUARE: &str =
    "G21 G90\nG0 Z5\nM3 S9000\nG1 Z-2 F600\nG1 X30 F900\nG1 Y30\nG1 X0\nG1 Y0\nG0 Z5\nM5\nM30\n";

fn bench(files: &[(&str, &str)]) -> Bench {
    Bench::of(Fake::of(Board::fluid_with_card(files), &[]))
}

/// A file of several packets, with characters that a controller obeys at once where it takes them for such.
fn long() -> String {
    let ways: String = (1..400).map(|n| format!("G1 X{} F3000 (?!~)\n", n % 3)).collect();
    format!("G21 G90\n{ways}M30\n")
}

#[test]
fn files_are_uploaded_listed_shown_run_and_deleted() {
    let (shop, bench) = (Shop::new(&[("way.nc", &long())]), bench(&[("sub/square.nc", SQUARE)]));
    bench.look(|fake| {
        let card = fake.card();
        (card.spoils, card.loses, card.mutes) = (1, 1, 1);
    });
    card(&bench, &shop, "upload way.nc").exits(0).says("bytes are on the card");
    assert_eq!(bench.look(|fake| fake.card().files["way.nc"].clone()), long().into_bytes());
    bench.look(|fake| {
        let card = fake.card();
        assert_eq!((card.spoils, card.loses, card.mutes), (0, 0, 0));
    });
    let listed = card(&bench, &shop, "list --format json");
    let (square, way) = (SQUARE.len(), long().len());
    let known = format!(
        r#"[{{"bytes":{square},"name":"sub/square.nc"}},{{"bytes":{way},"name":"way.nc"}}]"#
    );
    assert_eq!(listed.exits(0).out().trim(), known);
    assert_eq!(card(&bench, &shop, "show sub/square.nc").exits(0).out(), SQUARE);
    card(&bench, &shop, "upload way.nc").exits(1).complains("--force replaces it");
    let run = card(&bench, &shop, "run sub/square.nc");
    run.exits(0)
        .says("sub/square.nc has run to its end")
        .complains("sub/square.nc runs from the card");
    assert_eq!(bench.look(|fake| fake.position()).0[..3], [0.0, 0.0, 5.0]);
    card(&bench, &shop, "delete way.nc").exits(0);
    card(&bench, &shop, "delete way.nc").exits(1).complains("there is no file way.nc on its card");
    card(&bench, &shop, "delete sub").exits(1).complains("there is no file sub on its card");
    assert_eq!(card(&bench, &shop, "").exits(0).out().lines().count(), 1);
}

#[test]
fn a_full_card_a_missing_folder_and_no_card_are_told() {
    let (shop, bench) = (Shop::new(&[("way.nc", &long())]), bench(&[]));
    bench.look(|fake| fake.card().room = Some(2000));
    card(&bench, &shop, "upload way.nc").exits(1).complains("its card is full");
    card(&bench, &shop, "upload way.nc --name no/way.nc")
        .exits(1)
        .complains("the folder is not there");
    assert_eq!(card(&bench, &shop, "list").exits(0).out(), "");
    bench.look(|fake| fake.card().is_out = true);
    card(&bench, &shop, "list").exits(1).complains("there is no card in it");
    card(&bench, &shop, "run way.nc").exits(1).complains("there is no card in it");
}

#[test]
fn ctrl_c_ends_an_upload_and_its_line_is_one_of_lines_again() {
    let (shop, bench) = (Shop::new(&[("way.nc", &long())]), bench(&[]));
    bench.look(|fake| fake.card().loses = 1);
    let upload = started(&bench, &shop, "upload way.nc");
    bench.until(|fake| fake.has_card_with(|card| card.takes_by_xmodem() && card.loses == 0));
    let done = interrupted(upload);
    let told = String::from_utf8_lossy(&done.stderr).into_owned();
    assert!(!done.status.success() && told.contains("it was stopped"), "{told}");
    assert!(bench.look(|fake| !fake.card().takes_by_xmodem() && fake.card().files.is_empty()));
    card(&bench, &shop, "list").exits(0);
}

#[test]
fn ctrl_c_ends_the_file_with_the_spindle_off_and_the_tool_lifted() {
    ctrl_c_ends_square(&bench(&[("square.nc", SQUARE)]));
}

#[test]
fn a_file_of_its_own_panel_that_has_a_bad_line_ends_with_the_spindle_off() {
    // More than its planner holds comes before the line.
    let ways: String = (1..200).map(|n| format!("G1 X{n} F3000\n")).collect();
    let bad = format!("G21\nM3 S9000\n{ways}G1 X1 Y\nG1 X300\n");
    for board in [Board::fluid_with_card, Board::hal_with_card] {
        let board = board(&[("bad.nc", &bad)]);
        let (shop, bench) = (Shop::new(&[]), Bench::of(Fake::of(board, &[])));
        bench.look(|fake| fake.runs_from_card("bad.nc"));
        let follows = started(&bench, &shop, "follow");
        let done = follows.wait_with_output().unwrap();
        let told = String::from_utf8_lossy(&done.stderr).into_owned();
        assert!(
            !done.status.success() && told.contains("line 202 of the file was refused"),
            "{told}"
        );
        assert_eq!(bench.look(|fake| fake.spindle()), None);
    }
}
