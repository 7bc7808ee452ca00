//! The card of `FluidNC`: its own words, folders, XMODEM, and refusals in messages.

use crate::card::{does, done, job, looks};
use crate::wire::{Wire, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{
    CardAnswer, CardFile, CardNews, CardTask, Link, LinkState, Trouble, Wired,
};

const SQUARE: &str = "G21G90\nM3S9000\nG1X20F1200\nG1Y20\nG1X0\nG1Y0\nM5\nM30\n";

fn attached(files: &[(&str, &str)]) -> Link<Wire> {
    Link::new(Wire::new(Fake::of(Board::fluid_with_card(files), &[])))
}

fn fails(news: Option<CardNews>, why: &str) {
    assert!(matches!(&news, Some(CardNews::Failed(told)) if told.contains(why)), "{news:?}");
}

/// Its line is one of lines: nothing of an earlier answer is taken for another one.
fn takes_lines(link: &mut Link<Wire>, from_s: f64) {
    let files = link.driver().fake.card().files.clone();
    let told = does(link, from_s, CardTask::List);
    let Some(CardNews::Done(CardAnswer { files: listed, .. })) = told else { panic!("{told:?}") };
    assert!(listed.iter().map(|file| &file.name).eq(files.keys()));
    assert_eq!(link.driver().grbl.trouble(), None);
}

#[test]
fn files_are_told_with_their_folders_and_shown() {
    let names = ["a/b/deep.nc", "a/low.nc", "b.nc", "c d/e f.nc"];
    let mut link = attached(&names.map(|name| (name, SQUARE)));
    let files = names.map(|name| CardFile { name: name.into(), bytes: SQUARE.len() as u64 });
    let all = CardAnswer { files: files.into(), ..CardAnswer::default() };
    assert_eq!(does(&mut link, 0.0, CardTask::List), done(all));
    let text = CardAnswer { text: SQUARE.into(), ..CardAnswer::default() };
    assert_eq!(does(&mut link, 1.0, CardTask::Show("a/b/deep.nc".into())), done(text));
}

#[test]
fn a_file_alone_is_deleted_and_what_is_not_there_is_told() {
    let mut link = attached(&[("a/b.nc", SQUARE), ("c.nc", SQUARE)]);
    fails(does(&mut link, 0.0, CardTask::Delete("d.nc".into())), "no file d.nc");
    fails(does(&mut link, 1.0, CardTask::Delete("a".into())), "no file a");
    assert_eq!(link.driver().fake.card().files.len(), 2);
    assert_eq!(
        does(&mut link, 2.0, CardTask::Delete("a/b.nc".into())),
        done(CardAnswer::default())
    );
    takes_lines(&mut link, 3.0);
    assert_eq!(link.driver().fake.card().files.len(), 1);
}

#[test]
fn a_card_that_is_out_and_a_file_that_is_not_there_are_told() {
    let mut link = attached(&[("c.nc", SQUARE)]);
    fails(does(&mut link, 0.0, CardTask::Run("d.nc".into())), "66");
    link.driver().fake.card().is_out = true;
    fails(does(&mut link, 1.0, CardTask::List), "no card in it");
    fails(does(&mut link, 2.0, upload(b"G0X1\n")), "cannot open");
    link.driver().fake.card().is_out = false;
    let folder = CardTask::Upload { name: "no/a.nc".into(), content: b"G0X1\n".into() };
    fails(does(&mut link, 3.0, folder), "the folder is not there");
    takes_lines(&mut link, 4.0);
}

fn upload(content: &[u8]) -> CardTask {
    CardTask::Upload { name: "a.nc".into(), content: content.into() }
}

/// Packets that are spoiled, that do not come, and whose answers do not.
fn arrives(size: usize, [spoils, loses, mutes]: [u32; 3]) {
    let mut link = attached(&[]);
    let content: Vec<u8> = (0..size).map(|n| b"G1X?!~\n"[n % 7]).collect();
    let card = link.driver().fake.card();
    (card.spoils, card.loses, card.mutes) = (spoils, loses, mutes);
    link.driver().grbl.does_on_card(upload(&content)).unwrap();
    assert_eq!(looks(&mut link, 0.0, 40.0), done(CardAnswer::default()), "{size}");
    assert_eq!(link.driver().fake.card().files.get("a.nc"), Some(&content), "{size}");
    let card = link.driver().fake.card();
    assert_eq!([card.spoils, card.loses, card.mutes], [0; 3]);
    takes_lines(&mut link, 41.0);
    assert!(link.driver().fake.lines.iter().all(|line| !line.contains("X?")), "none was obeyed");
}

#[test]
fn a_file_arrives_byte_for_byte_behind_spoiled_lost_and_repeated_packets() {
    arrives(1, [0; 3]);
    arrives(2048, [2, 0, 0]);
    arrives(3001, [0, 1, 0]);
    arrives(4100, [0, 0, 2]);
    arrives(9000, [1, 1, 1]);
    // More packets than there are numbers.
    arrives(270_000, [0; 3]);
}

#[test]
fn a_full_card_and_a_stop_end_an_upload_and_its_line_is_one_of_lines_again() {
    let mut link = attached(&[]);
    link.driver().fake.card().room = Some(1500);
    link.driver().grbl.does_on_card(upload(&[b'\n'; 6000])).unwrap();
    fails(looks(&mut link, 0.0, 5.0), "full");
    link.driver().fake.card().room = None;
    takes_lines(&mut link, 5.0);
    for (at_s, spoils) in [(10.0, 0), (20.0, 1)] {
        link.driver().fake.card().spoils = spoils;
        link.driver().grbl.does_on_card(upload(&[b'\n'; 6000])).unwrap();
        looks(&mut link, at_s, 1.1);
        link.driver().grbl.leaves_card();
        assert!(link.driver().grbl.sends_file(), "its receiver has not answered yet");
        let begun = link.driver().grbl.does_on_card(CardTask::List);
        assert!(begun.is_err_and(|why| why.contains("at work")));
        let news = looks(&mut link, at_s + 1.1, 3.0);
        assert_eq!(news, Some(CardNews::Failed("it was stopped".into())));
        assert!(link.driver().fake.card().files.is_empty());
        takes_lines(&mut link, at_s + 5.0);
    }
}

#[test]
fn a_file_that_it_runs_is_followed_to_its_end() {
    let mut link = attached(&[("sub/box.nc", SQUARE)]);
    does(&mut link, 0.0, CardTask::Run("sub/box.nc".into()));
    let told = job(&mut link).unwrap();
    assert_eq!(told.name, "sub/box.nc");
    assert!(link.driver().grbl.stands().unwrap().moving);
    looks(&mut link, 1.0, 10.0);
    assert_eq!((job(&mut link), link.driver().grbl.trouble()), (None, None));
    link.order(to(5.0, 0.0));
    looks(&mut link, 11.0, 2.0);
    assert!(link.is_idle() && link.state() == LinkState::Up);
    assert_eq!(link.driver().fake.position().0[..2], [5.0, 0.0]);
}

#[test]
fn a_file_that_is_begun_at_its_panel_is_named_without_the_folder_of_the_card() {
    let ways: String = (1..60).map(|n| format!("G1X{n}F1200\n")).collect();
    let mut link = attached(&[("box.nc", &ways)]);
    looks(&mut link, 0.0, 1.0);
    assert!(link.driver().fake.runs_from_card("box.nc"));
    looks(&mut link, 1.0, 1.0);
    assert_eq!(job(&mut link).unwrap().name, "box.nc");
}

#[test]
fn a_line_that_is_refused_ends_the_file_and_one_that_is_unknown_does_not() {
    let mut link = attached(&[("bad.nc", "G21\nG1X1F600\nG1X1Y\nG1X9\n"), ("odd.nc", SQUARE)]);
    let news = does(&mut link, 0.0, CardTask::Run("bad.nc".into()));
    fails(news, "line 3 of the file");
    looks(&mut link, 1.0, 2.0);
    assert_eq!((job(&mut link), link.driver().fake.position().0[0]), (None, 1.0));
    let trouble = link.driver().grbl.trouble().cloned();
    assert!(
        matches!(&trouble, Some(Trouble::Refused { why, .. }) if why.contains("line 3")),
        "{trouble:?}"
    );
}

#[test]
fn a_line_that_is_unknown_to_it_is_told_and_the_file_goes_on() {
    let mut link = attached(&[("odd.nc", "G21\nG1X1F600\nG999\nG1X9\n")]);
    let news = does(&mut link, 0.0, CardTask::Run("odd.nc".into()));
    fails(news, "line 3 of the file was refused");
    looks(&mut link, 1.0, 3.0);
    assert_eq!((job(&mut link), link.driver().grbl.trouble()), (None, None));
    assert_eq!(link.driver().fake.position().0[0], 9.0);
}

#[test]
fn a_stop_ends_the_file_where_it_stands_with_the_spindle_off() {
    let ways: String = (1..400).map(|n| format!("X{n}\n")).collect();
    let mut link = attached(&[("box.nc", &format!("G21G90\nM3S9000\nG1F1200\n{ways}M5\n"))]);
    does(&mut link, 0.0, CardTask::Run("box.nc".into()));
    link.stop(1.0);
    looks(&mut link, 1.0, 2.0);
    assert_eq!((job(&mut link), link.driver().fake.spindle()), (None, None));
    assert!(link.driver().grbl.begin_anew());
    let stands = link.driver().fake.position();
    looks(&mut link, 3.0, 3.0);
    assert_eq!(link.driver().fake.position(), stands);
    assert!(stands.0[0] > 1.0, "{stands:?}");
}
