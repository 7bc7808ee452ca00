//! The card of a controller: files on it, and one that the controller runs from it by itself.
//!
//! A file that runs from a card goes on when Kerf ends and when the line is lost. To follow it is to see the place of the
//! machine, and to hold and stop it; a stop is that of a run, and the reset in it ends the file.

use super::Connection;
use super::connection::NAP;
use kerf_machine::driver::{CardAnswer, CardJob, CardNews, CardTask, Hold, Override, Signal};
use kerf_program::Axes;

/// A controller that says nothing of a task for so long does not do it, seconds.
const SILENT_S: f64 = 15.0;

/// A controller that stands answers what it was asked within this, seconds.
const ANSWER_S: f64 = 2.0;

/// A controller that was told to end an upload has done so within this, seconds.
const ENDS_S: f64 = 6.0;

/// A file that was stopped is over, and its controller asked about itself, within this, seconds.
const STOPPED_S: f64 = 12.0;

/// Request about a file that runs from a card.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CardWish {
    /// Slow down on the path; the file is over where the machine stands.
    Stop,
    /// Slow down on the path and stand there.
    Hold,
    /// Go on.
    Resume,
    /// The tool is in for which it waits.
    ToolIn,
    /// Make moves at so many percent of their speed.
    Feed(u8),
    /// The operator turns something else.
    Override(Override),
    /// Nobody follows it any more: the file goes on.
    Leave,
}

/// State of a file that runs from a card.
#[derive(Clone, Debug, PartialEq)]
pub struct CardState {
    /// The file, and how far it is.
    pub job: CardJob,
    /// Place of the machine, machine frame.
    pub place: Option<Axes>,
    /// It is held by Kerf.
    pub is_held: bool,
    /// Act at its own controls for which it waits.
    pub waits: Option<&'static str>,
    /// It waits for a tool.
    pub wants_tool: bool,
    /// The line to it is lost at the moment; the file goes on.
    pub is_lost: bool,
}

/// The end of a file that ran from a card.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CardEnd {
    /// It ran to its end.
    Ended,
    /// It was stopped.
    Stopped,
    /// It ended by itself before, for a reason.
    Failed(String),
    /// It goes on, and nobody follows it any more.
    Left,
}

/// Does something on the card of a controller that stands.
///
/// # Errors
/// It has none, is at work, refuses, says nothing, or it was stopped meanwhile.
pub fn do_on_card(
    connection: &mut Connection,
    task: CardTask,
    tells: &mut dyn FnMut(usize, usize),
    is_stopped: &mut dyn FnMut() -> bool,
) -> Result<CardAnswer, String> {
    let refused = |name: &str, why: &str| format!("{name}: {why}");
    if connection.open > 0 || connection.failure.is_some() {
        return Err(refused(&connection.name, "it is at work, or takes no orders"));
    }
    // It may be asked about itself at the moment.
    let rests_s = connection.now_s() + ANSWER_S;
    while !connection.link.driver().knows_zeros() && connection.now_s() < rests_s {
        connection.tend(NAP);
    }
    let begun = connection.link.driver().does_on_card(task);
    begun.map_err(|why| refused(&connection.name, &why))?;
    let mut until_s = connection.now_s() + SILENT_S;
    loop {
        connection.tend(NAP);
        match connection.link.driver().card_news() {
            Some(CardNews::Done(answer)) => return Ok(answer),
            Some(CardNews::Failed(why)) => return Err(refused(&connection.name, &why)),
            Some(CardNews::Going(done, all)) => {
                until_s = connection.now_s() + SILENT_S;
                tells(done, all);
            }
            None => {}
        }
        if let Some(fault) = &connection.failure {
            return Err(fault.message.clone());
        }
        let is_late = connection.now_s() > until_s;
        if is_late || is_stopped() {
            connection.link.driver().leaves_card();
            connection.tend(NAP);
            // A receiver that was stopped says so, and takes no line before.
            let until_s = connection.now_s() + ENDS_S;
            while connection.link.driver().sends_file() && connection.now_s() < until_s {
                connection.tend(NAP);
            }
            let why = if is_late { "it says nothing of its card" } else { "it was stopped" };
            return Err(refused(&connection.name, why));
        }
    }
}

/// Follows a file that runs from a card to its end, and tells of it at every look. One that ends before its end is stopped: what
/// it has switched on would stay on, and its last moves would still be made.
///
/// # Errors
/// The controller refuses to go on, or does not say that it has stopped; or the line is lost for good, and the file goes on.
pub fn follow_card(
    connection: &mut Connection,
    tells: &mut dyn FnMut(&CardState),
    wishes: &mut dyn FnMut() -> Option<CardWish>,
) -> Result<CardEnd, String> {
    let ended = look_on(connection, tells, wishes);
    match &ended {
        Ok(CardEnd::Failed(_)) => stop_card(connection)?,
        // The first reason is the one that matters.
        Err(_) if !connection.dead => drop(stop_card(connection)),
        _ => {}
    }
    ended
}

fn look_on(
    connection: &mut Connection,
    tells: &mut dyn FnMut(&CardState),
    wishes: &mut dyn FnMut() -> Option<CardWish>,
) -> Result<CardEnd, String> {
    let mut held = false;
    let mut failed = None;
    while let Some(job) = connection.link.driver().card_job() {
        let driver = connection.link.driver();
        held &= driver.hold() != Hold::WentOn;
        let (waits, wants_tool) = (driver.waits(), driver.waits_for_tool());
        let is_lost = connection.lost.is_some();
        tells(&CardState {
            job: job.clone(),
            place: connection.place(),
            is_held: held,
            waits,
            wants_tool,
            is_lost,
        });
        match wishes() {
            Some(CardWish::Stop) => return stop_card(connection).map(|()| CardEnd::Stopped),
            Some(CardWish::Leave) => return Ok(CardEnd::Left),
            Some(wish) => {
                held = (held || wish == CardWish::Hold) && wish != CardWish::Resume;
                signal(wish).into_iter().for_each(|signal| connection.signal(signal));
            }
            None => {}
        }
        connection.tend(NAP);
        if let Some(CardNews::Failed(why)) = connection.link.driver().card_news() {
            failed = Some(why);
        }
        if let Some(fault) = &connection.failure {
            return Err(match connection.dead {
                true => format!("{}; {} runs on from its card", fault.message, job.name),
                false => fault.message.clone(),
            });
        }
    }
    Ok(failed.map_or(CardEnd::Ended, CardEnd::Failed))
}

/// Returns what is signalled for a wish; nothing for what ends the following.
const fn signal(wish: CardWish) -> Option<Signal> {
    Some(match wish {
        CardWish::Stop | CardWish::Leave => return None,
        CardWish::Hold => Signal::Hold,
        CardWish::Resume => Signal::Resume,
        CardWish::ToolIn => Signal::ToolIn,
        CardWish::Feed(percent) => Signal::Feed(percent),
        CardWish::Override(turned) => Signal::Override(turned),
    })
}

/// Ends the file where the machine stands; its reset switches outputs off.
///
/// # Errors
/// It does not say that it has stopped.
pub fn stop_card(connection: &mut Connection) -> Result<(), String> {
    if connection.link.driver().facts().is_some() {
        connection.stop_at_once();
        return connection.failure.as_ref().map_or(Ok(()), |fault| Err(fault.message.clone()));
    }
    // It has not told who it is yet, and does so behind its reset.
    let until_s = connection.now_s() + STOPPED_S;
    connection.signal(Signal::Stop);
    while connection.link.driver().facts().is_none() {
        connection.tend(NAP);
        if connection.now_s() > until_s {
            return Err(format!(
                "{} does not say that it has stopped: press its emergency stop and look at it",
                connection.name
            ));
        }
    }
    Ok(())
}
