//! `kerf machine card`: the card of a controller, from the shell.

use crate::bench::Bench;
use crate::shop::{Did, Shop};
use kerf_driver_grbl::fake::{Board, Fake};
use nix::sys::signal::{Signal, kill};
use nix::unistd::Pid;
use std::process::{Child, Output, Stdio};

const SQUARE: &str =
    "G21 G90\nG0 Z5\nM3 S9000\nG1 Z-2 F600\nG1 X30 F900\nG1 Y30\nG1 X0\nG1 Y0\nG0 Z5\nM5\nM30\n";

fn bench() -> Bench {
    Bench::of(Fake::of(Board::hal_with_card(&[("square.nc", SQUARE)]), &[]))
}

fn words(bench: &Bench, words: &str) -> String {
    format!("machine card {words} --machine grbl:{}", bench.port)
}

pub fn card(bench: &Bench, shop: &Shop, asked: &str) -> Did {
    shop.kerf(&words(bench, asked))
}

pub fn started(bench: &Bench, shop: &Shop, asked: &str) -> Child {
    let mut command = shop.command();
    command.args(words(bench, asked).split_whitespace());
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

pub fn interrupted(child: Child) -> Output {
    kill(Pid::from_raw(child.id() as i32), Signal::SIGINT).unwrap();
    child.wait_with_output().unwrap()
}

#[test]
fn files_are_uploaded_listed_shown_run_and_deleted() {
    let (shop, bench) = (Shop::new(&[("way.nc", "G21\nG0 X3 Y4\n")]), bench());
    card(&bench, &shop, "upload way.nc").exits(0);
    let listed = card(&bench, &shop, "list --format json");
    assert_eq!(
        listed.exits(0).out().trim(),
        format!(
            r#"[{{"bytes":{},"name":"square.nc"}},{{"bytes":13,"name":"way.nc"}}]"#,
            SQUARE.len()
        )
    );
    assert_eq!(card(&bench, &shop, "show way.nc").exits(0).out(), "G21\nG0 X3 Y4\n");
    card(&bench, &shop, "upload way.nc").exits(1).complains("--force replaces it");
    card(&bench, &shop, "upload way.nc --force").exits(0);
    card(&bench, &shop, "run way.nc").exits(0);
    assert_eq!(bench.look(|fake| fake.position()).0[..2], [3.0, 4.0]);
    card(&bench, &shop, "delete way.nc").exits(0);
    assert!(!card(&bench, &shop, "").exits(0).out().contains("way.nc"));
}

#[test]
fn an_opensbp_file_goes_there_as_gcode_and_makes_the_same_way() {
    let (shop, bench) = (Shop::new(&[("way.sbp", "MX,1\nMY,2\n")]), bench());
    card(&bench, &shop, "upload way.sbp").exits(0);
    card(&bench, &shop, "run way.nc").exits(0);
    let [x, y, ..] = bench.look(|fake| fake.position()).0;
    assert!((x - 25.4).abs() < 0.01 && (y - 50.8).abs() < 0.01, "{x} {y}");
}

#[test]
fn a_file_beyond_the_limits_is_neither_put_there_nor_begun() {
    let far = "G21\nG0 X-900\n";
    let board = Board::hal_with_card(&[("far.nc", far)]);
    let bench = Bench::of(Fake::of(board, &[(20, 1.0), (22, 1.0)]));
    let shop = Shop::new(&[("far.nc", far)]);
    shop.kerf(&format!("machine home --machine grbl:{}", bench.port)).exits(0);
    card(&bench, &shop, "upload far.nc --name other.nc").exits(1).complains("X would go to");
    card(&bench, &shop, "run far.nc").exits(1).complains("was not begun");
    assert_eq!(bench.look(|fake| fake.card().files.len()), 1);
}

/// Runs a file of the card, and presses Ctrl-C while it cuts.
pub fn ctrl_c_ends_square(bench: &Bench) {
    let shop = Shop::new(&[]);
    let run = started(bench, &shop, "run square.nc");
    bench.until(|fake| fake.position().0[0] > 5.0);
    let done = interrupted(run);
    assert_eq!(done.status.code(), Some(3), "{}", String::from_utf8_lossy(&done.stderr));
    let (spindle, at) = bench.look(|fake| (fake.spindle(), fake.position().0));
    assert_eq!(spindle, None);
    assert!((at[2] - 25.4).abs() < 0.01 && at[0] < 29.0, "{at:?}");
}

#[test]
fn ctrl_c_ends_the_file_with_the_spindle_off_and_the_tool_lifted() {
    ctrl_c_ends_square(&bench());
}

#[test]
fn a_file_of_its_own_panel_is_left_alone_followed_and_stopped() {
    let board = Board::hal_with_card(&[("square.nc", "G21\nM3 S9000\nG1 X300 F900\n")]);
    let (shop, bench) = (Shop::new(&[]), Bench::of(Fake::of(board, &[])));
    bench.look(|fake| fake.runs_from_card("square.nc"));
    card(&bench, &shop, "list").exits(1).complains("runs a file from its own card");
    bench.until(|fake| fake.position().0[0] > 2.0);
    let follows = started(&bench, &shop, "follow");
    let at = bench.x_mm();
    bench.until(|fake| fake.position().0[0] > at + 20.0);
    let done = interrupted(follows);
    let told = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(3), "{told}");
    assert!(told.contains("square.nc runs from the card"), "{told}");
    assert_eq!(bench.look(|fake| fake.spindle()), None);
}

#[test]
fn a_controller_without_a_card_is_told() {
    let (shop, bench) = (Shop::new(&[]), Bench::new(&[]));
    card(&bench, &shop, "list").exits(1).complains("grbl 1.1 has no card");
    shop.kerf("machine card").exits(2).complains("name the controller");
}
