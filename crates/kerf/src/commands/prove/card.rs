//! Cases of the card of a controller, and of the record of its lines. A controller without a card is told to have none.

use super::bench::{OnBench, socket};
use super::outcome::Outcome;
use super::own::Case;
use crate::machine_name::DriverName;
use anyhow::{Result, anyhow};
use kerf_control::controller::{CardEnd, Connection, do_on_card, follow_card};
use kerf_machine::driver::{CardAnswer, CardTask, NO_CARD_IN, TAKES_NO_FILES};

/// The file that is put on the card for a moment.
const FILE: &str = "kerf-prove.nc";

/// Lines of a comment before its end: more than a packet of either protocol holds.
const LINES: usize = 60;

pub const CARD: &[Case] = &[
    Case { name: "its card lists its files", check: lists },
    Case { name: "a file goes to its card, comes back the same, runs and is deleted", check: goes },
    Case { name: "what is sent and answered is on record", check: records },
];

fn does(board: &mut Connection, task: CardTask) -> Result<CardAnswer> {
    do_on_card(board, task, &mut |_, _| {}, &mut || false).map_err(|why| anyhow!(why))
}

/// Its names; or why it has no card to be tried.
fn names(bench: &mut OnBench) -> Result<Result<Vec<String>, String>> {
    if let Err(why) = bench.board.has_card() {
        return Ok(Err(why.to_owned()));
    }
    Ok(match does(&mut bench.board, CardTask::List) {
        Ok(told) => Ok(told.files.into_iter().map(|file| file.name).collect()),
        Err(why) if why.to_string().contains(NO_CARD_IN) => Err(NO_CARD_IN.to_owned()),
        Err(why) => return Err(why),
    })
}

fn lists(name: &DriverName) -> Result<Outcome> {
    Ok(match names(&mut OnBench::as_it_stands(name)?)? {
        Ok(names) => Outcome::Held(format!("{} files", names.len())),
        Err(why) => Outcome::NotTried(why),
    })
}

fn goes(name: &DriverName) -> Result<Outcome> {
    let mut bench = OnBench::as_it_stands(name)?;
    match names(&mut bench)? {
        Err(why) => return Ok(Outcome::NotTried(why)),
        Ok(names) if names.iter().any(|name| name == FILE) => {
            return Ok(Outcome::NotTried(format!("{FILE} is on it already: delete it")));
        }
        Ok(_) => {}
    }
    let comments: String = (1..=LINES).map(|n| format!("(line {n} of a proof)\n")).collect();
    let text = format!("{comments}G21\nG90\nM5\n");
    let task = CardTask::Upload { name: FILE.into(), content: text.clone().into_bytes() };
    match does(&mut bench.board, task) {
        Err(why) if why.to_string().contains(TAKES_NO_FILES) => {
            return Ok(Outcome::NotTried(TAKES_NO_FILES.to_owned()));
        }
        done => drop(done?),
    }
    let outcome = shown_and_run(&mut bench.board, &text);
    does(&mut bench.board, CardTask::Delete(FILE.into()))?;
    let is_left = names(&mut bench)?.is_ok_and(|names| names.iter().any(|name| name == FILE));
    if is_left {
        return Ok(Outcome::Wrong(format!("{FILE} is on it still")));
    }
    outcome
}

fn shown_and_run(board: &mut Connection, text: &str) -> Result<Outcome> {
    let shown = does(board, CardTask::Show(FILE.into()))?.text;
    if shown != text {
        let (came, size) = (shown.len(), text.len());
        return Ok(Outcome::Wrong(format!("it shows {came} bytes that are not the {size} sent")));
    }
    does(board, CardTask::Run(FILE.into()))?;
    Ok(match follow_card(board, &mut |_| {}, &mut || None).map_err(|why| anyhow!(why))? {
        CardEnd::Ended => Outcome::Held(String::new()),
        ended => Outcome::Wrong(format!("it ran to this end: {ended:?}")),
    })
}

fn records(name: &DriverName) -> Result<Outcome> {
    let socket = socket(name)?;
    let (driver, line) = (socket.opens)().map_err(|why| anyhow!(why))?;
    let board = Connection::open_logged(&socket.name, (driver, line), socket.log.clone(), false);
    drop(board.map_err(|why| anyhow!(why))?);
    let lines = socket.log.since(0, |_| true).lines;
    let sent = lines.iter().filter(|line| line.is_sent).count();
    let came = lines.len() - sent;
    Ok(match sent > 0 && came > 0 {
        true => Outcome::Held(String::new()),
        false => Outcome::Wrong(format!("{sent} lines sent and {came} that came")),
    })
}
