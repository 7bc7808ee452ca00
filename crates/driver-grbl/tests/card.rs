//! The card of a controller: listed, filled, run, and followed.

use crate::wire::{Wire, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{
    CardAnswer, CardFile, CardJob, CardNews, CardTask, Driver, Link, LinkState, Signal, Trouble,
    Wired,
};

const SQUARE: &str = "G21G90\nM3S9000\nG1X20F1200\nG1Y20\nG1X0\nG1Y0\nM5\nM30\n";

fn attached(files: &[(&str, &str)]) -> Link<Wire> {
    Link::new(Wire::new(Fake::of(Board::hal_with_card(files), &[])))
}

/// It is looked at for so long, and asked where it is; the last news of its card is returned.
pub fn looks(link: &mut Link<Wire>, from_s: f64, seconds: f64) -> Option<CardNews> {
    let mut news = None;
    for tick in 0..(seconds / 0.02) as u32 {
        let now_s = from_s + 0.02 * f64::from(tick);
        if tick % 4 == 0 {
            link.driver().signal(Signal::Ask, now_s);
        }
        link.poll(now_s);
        news = link.driver().grbl.card_news().or(news);
    }
    news
}

pub fn does(link: &mut Link<Wire>, from_s: f64, task: CardTask) -> Option<CardNews> {
    link.driver().grbl.does_on_card(task).unwrap();
    looks(link, from_s, 1.0)
}

pub fn job(link: &mut Link<Wire>) -> Option<CardJob> {
    link.driver().grbl.card_job()
}

pub fn done(answer: CardAnswer) -> Option<CardNews> {
    Some(CardNews::Done(answer))
}

#[test]
fn files_are_told_shown_and_deleted() {
    let mut link = attached(&[("box.nc", SQUARE), ("sub/a b.nc", "G0X1\n")]);
    let file = |name: &str, bytes| CardFile { name: name.into(), bytes };
    let files = vec![file("box.nc", SQUARE.len() as u64), file("sub/a b.nc", 5)];
    let all = CardAnswer { files, ..CardAnswer::default() };
    assert_eq!(does(&mut link, 0.0, CardTask::List), done(all));
    let text = CardAnswer { text: SQUARE.into(), ..CardAnswer::default() };
    assert_eq!(does(&mut link, 1.0, CardTask::Show("box.nc".into())), done(text));
    does(&mut link, 2.0, CardTask::Delete("box.nc".into()));
    assert_eq!(link.driver().fake.card().files.len(), 1);
    let gone = does(&mut link, 3.0, CardTask::Delete("box.nc".into()));
    assert!(matches!(gone, Some(CardNews::Failed(why)) if why.contains("61")));
    link.driver().fake.card().is_out = true;
    let out = does(&mut link, 4.0, CardTask::List);
    assert!(matches!(out, Some(CardNews::Failed(why)) if why.contains("no card in it")));
    assert_eq!(link.driver().grbl.trouble(), None);
}

#[test]
fn a_controller_without_a_card_is_told_with_the_reason() {
    let check = |board: Board, why: &str| {
        let mut link = Link::new(Wire::new(Fake::of(board, &[])));
        assert!(link.driver().grbl.has_card().unwrap_err().contains(why));
        let told = link.driver().grbl.does_on_card(CardTask::List).unwrap_err();
        assert!(told.contains(why), "{told}");
    };
    check(Board::grbl(), "grbl 1.1 has no card");
    check(Board::hal(0), "tells no SD");
}

#[test]
fn a_name_that_is_another_command_is_refused() {
    let mut link = attached(&[]);
    for name in ["", "a\n$X", "a?.nc", "a!.nc", "~", "a-name-that-is-far-too-long-for-it.nc", "ä"]
    {
        let told = link.driver().grbl.does_on_card(CardTask::Run(name.into()));
        assert!(told.is_err_and(|why| why.contains("no name for its card")), "{name}");
    }
}

#[test]
fn a_file_arrives_as_it_is_also_when_packets_are_spoiled() {
    let mut link = attached(&[]);
    // A size that is no multiple of a packet, one that is, and bytes that would be commands at once.
    let files = [("a.nc", 3001, 0), ("b.nc", 2048, 2), ("c.nc", 1, 1)];
    for (at_s, (name, size, spoils)) in [0.0, 12.0, 24.0].into_iter().zip(files) {
        let content: Vec<u8> = (0..size).map(|n| b"G1X?!~\n"[n % 7]).collect();
        link.driver().fake.card().spoils = spoils;
        let task = CardTask::Upload { name: name.into(), content: content.clone() };
        link.driver().grbl.does_on_card(task).unwrap();
        let news = looks(&mut link, at_s, 12.0);
        assert_eq!(news, done(CardAnswer::default()), "{name}");
        assert_eq!(link.driver().fake.card().files.get(name), Some(&content), "{name}");
    }
    assert_eq!(link.state(), LinkState::Up);
}

#[test]
fn a_full_card_and_a_stop_end_an_upload_and_nothing_of_it_is_kept() {
    let mut link = attached(&[]);
    link.driver().fake.card().room = Some(1500);
    let task = || CardTask::Upload { name: "a.nc".into(), content: vec![b'\n'; 4000] };
    link.driver().grbl.does_on_card(task()).unwrap();
    let news = looks(&mut link, 0.0, 5.0);
    assert!(matches!(news, Some(CardNews::Failed(why)) if why.contains("full")));
    link.driver().fake.card().room = None;
    link.driver().grbl.does_on_card(task()).unwrap();
    looks(&mut link, 5.0, 0.04);
    assert!(link.driver().grbl.sends_file(), "its bytes are none that are obeyed at once");
    link.driver().grbl.leaves_card();
    assert!(!link.driver().grbl.sends_file());
    assert_eq!(looks(&mut link, 6.0, 2.0), Some(CardNews::Failed("it was stopped".into())));
    assert!(link.driver().fake.card().files.is_empty());
    assert!(does(&mut link, 8.0, CardTask::List).is_some(), "its line is one of lines again");
}

#[test]
fn the_end_of_an_upload_is_no_answer_to_what_is_asked_after_it() {
    let mut link = attached(&[("box.nc", SQUARE)]);
    looks(&mut link, 0.0, 1.0);
    let upload = CardTask::Upload { name: "a.nc".into(), content: vec![b'\n'; 5000] };
    link.driver().grbl.does_on_card(upload).unwrap();
    link.poll(1.0);
    link.driver().grbl.leaves_card();
    link.poll(1.02);
    link.driver().grbl.does_on_card(CardTask::Show("box.nc".into())).unwrap();
    let news = link.driver().grbl.card_news();
    assert_eq!(news, None, "nothing is answered yet");
    let text = CardAnswer { text: SQUARE.into(), ..CardAnswer::default() };
    assert_eq!(looks(&mut link, 1.04, 1.0), done(text));
}

#[test]
fn a_file_that_it_runs_is_followed_to_its_end() {
    let inches = "G20G90\nM3S9000\nG1X1F47\nG1X0\nM5\nM30\n";
    let mut link = attached(&[("box.nc", inches)]);
    does(&mut link, 0.0, CardTask::Run("box.nc".into()));
    let told = job(&mut link).unwrap();
    assert_eq!(told.name, "box.nc");
    assert!(told.percent.is_some_and(|percent| percent > 0.0));
    assert!(link.driver().grbl.stands().unwrap().moving);
    assert!(link.driver().fake.spindle().is_some());
    looks(&mut link, 1.0, 10.0);
    assert_eq!(job(&mut link), None);
    assert_eq!(link.driver().grbl.trouble(), None);
    // Its modes are Kerf's again, and it takes orders from where it stands.
    link.order(to(5.0, 0.0));
    looks(&mut link, 11.0, 2.0);
    assert!(link.is_idle());
    assert_eq!(link.driver().fake.position().0[..2], [5.0, 0.0]);
}

#[test]
fn a_file_that_somebody_begins_at_its_panel_is_seen_and_no_line_is_sent_to_it() {
    let mut link = attached(&[("box.nc", SQUARE)]);
    looks(&mut link, 0.0, 1.0);
    assert!(link.driver().fake.runs_from_card("box.nc"));
    looks(&mut link, 1.0, 1.0);
    assert_eq!(job(&mut link).unwrap().name, "box.nc");
    let lines = link.driver().fake.lines.len();
    let told = link.driver().grbl.does_on_card(CardTask::List).unwrap_err();
    assert!(told.contains("at work"));
    looks(&mut link, 2.0, 10.0);
    assert_eq!(job(&mut link), None);
    assert!(link.driver().fake.lines[..lines].iter().any(|line| line == "G1X20F1200"));
}

#[test]
fn a_stop_ends_the_file_where_it_stands_with_the_spindle_off() {
    // More than its planner holds: what it has not read yet must not come behind the stop.
    let ways: String = (1..400).map(|n| format!("X{n}\n")).collect();
    let mut link = attached(&[("box.nc", &format!("G21G90\nM3S9000\nG1F1200\n{ways}M5\n"))]);
    does(&mut link, 0.0, CardTask::Run("box.nc".into()));
    assert!(job(&mut link).is_some());
    link.stop(1.0);
    looks(&mut link, 1.0, 2.0);
    assert_eq!((job(&mut link), link.driver().fake.spindle()), (None, None));
    assert!(link.driver().grbl.begin_anew());
    let stands = link.driver().fake.position();
    looks(&mut link, 3.0, 3.0);
    let goes_on = link.driver().fake.position().minus(stands).0.iter().any(|mm| mm.abs() > 1e-6);
    assert!(!goes_on && stands.0[0] > 1.0, "{stands:?}");
    assert!((link.driver().grbl.stands().unwrap().position.0[0] - stands.0[0]).abs() < 1e-3);
}

#[test]
fn a_file_goes_on_when_the_line_is_lost_and_is_followed_again() {
    let mut link = attached(&[("box.nc", SQUARE)]);
    does(&mut link, 0.0, CardTask::Run("box.nc".into()));
    link.driver().loses(0);
    for tick in 0..40 {
        link.driver().carry(1.0 + 0.02 * f64::from(tick));
    }
    link.driver().is_back(1.8);
    looks(&mut link, 1.8, 0.5);
    assert!(job(&mut link).is_some());
    assert!(link.driver().fake.spindle().is_some());
    looks(&mut link, 2.3, 10.0);
    assert_eq!((job(&mut link), link.driver().fake.position().0[1]), (None, 0.0));
    assert!(!link.driver().fake.lines.iter().any(|line| line == "E"), "nothing was looked for");
    assert_eq!(link.driver().grbl.trouble(), None);
}

#[test]
fn kerf_that_comes_to_a_file_that_runs_leaves_it_alone() {
    let mut fake = Fake::of(Board::hal_with_card(&[("box.nc", SQUARE)]), &[]);
    fake.runs_from_card("box.nc");
    let mut link = Link::new(Wire::new(fake));
    // Its attachment took five seconds, in which the file ended.
    assert!(link.driver().grbl.facts().is_some());
    let lines = &link.driver().fake.lines;
    assert!(!lines.iter().any(|line| line == "$X" || line.starts_with("$J")));
    assert!(
        lines.iter().position(|line| line == "M5") < lines.iter().position(|line| line == "$I")
    );
}

#[test]
fn a_line_of_a_file_that_is_refused_is_told_with_its_number() {
    let mut link = attached(&[("bad.nc", "G21\nG1X1F600\nG999\nG1X9\n")]);
    let news = does(&mut link, 0.0, CardTask::Run("bad.nc".into()));
    assert!(matches!(news, Some(CardNews::Failed(why)) if why.contains("line 3")));
    looks(&mut link, 1.0, 2.0);
    assert_eq!(job(&mut link), None);
    assert!(!matches!(link.driver().grbl.trouble(), Some(Trouble::Alarm { .. })));
    assert_eq!(link.driver().fake.position().0[0], 1.0);
}

/// The receiver answers the packet that was on its way when the file was given up.
#[test]
fn what_a_receiver_still_says_of_a_file_that_was_given_up_is_in_no_line() {
    let mut link = attached(&[("box.nc", SQUARE)]);
    looks(&mut link, 0.0, 1.0);
    link.driver().grbl.hear(&[0x06, 0x15, 0x18], 1.0);
    let text = CardAnswer { text: SQUARE.into(), ..CardAnswer::default() };
    assert_eq!(does(&mut link, 1.0, CardTask::Show("box.nc".into())), done(text));
}
