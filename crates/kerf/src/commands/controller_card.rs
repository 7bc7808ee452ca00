//! `kerf machine card`: the card of a controller, whose files it runs by itself.

use super::shop::{Shop, not_beside_a_server};
use super::which::Which;
use crate::args::Format;
use crate::controller::{self, First, socket};
use crate::exit::{Exit, Usage};
use crate::machine_name::DriverName;
use crate::stop::Stop;
use crate::{given, out, setup};
use anyhow::{Result, anyhow, bail};
use clap::Subcommand;
use kerf_control::answers::Answers;
use kerf_control::controller::{
    CardEnd, CardState, CardWish, Connection, Controller, Place, follow_card,
};
use kerf_import::card_file::{self, CardFile};
use kerf_journal::{RunOptions, Work};
use kerf_machine::driver::{CardAnswer, CardTask};
use serde_json::json;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

/// Act on the card.
#[derive(Clone, Debug, Subcommand)]
pub enum CardAction {
    /// Lists the files
    List {
        /// Form in which they are printed
        #[arg(long, default_value = "text", value_name = "FORMAT")]
        format: Format,
    },
    /// Prints a file
    Show {
        /// Its name
        name: String,
    },
    /// Puts a part file or a job there: G-code as it is, .sbp and .rsm as the G-code of kerf convert
    Upload {
        /// The file
        file: PathBuf,
        /// Its name on the card [default: that of the file]
        #[arg(long, value_name = "NAME")]
        name: Option<String>,
        /// Replaces a file of that name without a question
        #[arg(long)]
        force: bool,
    },
    /// Has the controller run a file by itself, and follows it; Ctrl-C stops the machine, ends the file and lifts the tool
    Run {
        /// Its name
        name: String,
        /// Runs it although the controller does not show what it does: nothing of it is checked
        #[arg(long)]
        unseen: bool,
    },
    /// Follows a file that the controller runs, whoever has begun it; Ctrl-C stops it
    Follow,
    /// Deletes a file
    Delete {
        /// Its name
        name: String,
    },
}

pub fn run(which: &Which, name: &DriverName, action: Option<&CardAction>) -> Result<Exit> {
    not_beside_a_server(which, "see that nothing runs there")?;
    if matches!(action, Some(CardAction::Follow)) {
        return follow(which, name);
    }
    let first =
        if matches!(action, Some(CardAction::Run { .. })) { First::NONE } else { First::LOOK };
    let mut shop = Shop::open_after(which, first, false)?;
    let missing = || anyhow!("there is no controller that has a card");
    let controller = shop.controller.clone().ok_or_else(missing)?;
    let has = controller.has_card().map_err(|why| anyhow!("{}: {why}", controller.name()));
    let done = has.and_then(|()| does(&mut shop, &controller, which, action));
    shop.leave();
    done
}

fn does(
    shop: &mut Shop,
    controller: &Controller,
    which: &Which,
    action: Option<&CardAction>,
) -> Result<Exit> {
    match action {
        None => out::print(&listed(&ask(controller, CardTask::List)?, Format::Text)),
        Some(CardAction::List { format }) => {
            out::print(&listed(&ask(controller, CardTask::List)?, *format));
        }
        Some(CardAction::Show { name }) => {
            out::print(&ask(controller, CardTask::Show(name.clone()))?.text);
        }
        Some(CardAction::Delete { name }) => drop(ask(controller, CardTask::Delete(name.clone()))?),
        Some(CardAction::Upload { file, name, force }) => {
            return upload(shop, controller, which, (file, name.as_deref(), *force));
        }
        Some(CardAction::Run { name, unseen }) => {
            return runs(shop, controller, which, name, *unseen);
        }
        // Done by `follow`, which opens a controller that is at work.
        Some(CardAction::Follow) => {}
    }
    Ok(Exit::Good)
}

/// Does something on the card; Ctrl-C ends it.
fn ask(controller: &Controller, task: CardTask) -> Result<CardAnswer> {
    let stop = Stop::listen()?;
    let shows = matches!(task, CardTask::Upload { .. }) && io::stderr().is_terminal();
    let mut tells = |done: usize, all: usize| {
        if shows {
            eprint!("\r{done} of {all} bytes");
        }
    };
    let done = controller.does_on_card(task, &mut tells, &mut || stop.is_wanted());
    if shows {
        eprintln!();
    }
    done.map_err(|why| anyhow!(why))
}

/// A line for each file, its size first.
fn listed(told: &CardAnswer, format: Format) -> String {
    if format == Format::Json {
        let files: Vec<_> = told
            .files
            .iter()
            .map(|file| json!({ "name": file.name, "bytes": file.bytes }))
            .collect();
        return format!("{}\n", json!(files));
    }
    told.files.iter().map(|file| format!("{:>10}  {}\n", file.bytes, file.name)).collect()
}

fn upload(
    shop: &mut Shop,
    controller: &Controller,
    which: &Which,
    (file, name, force): (&Path, Option<&str>, bool),
) -> Result<Exit> {
    let bytes = given::bytes(file)?;
    let parts = file.parent().unwrap_or(Path::new(""));
    let mut workspace = setup::workspace(parts, &which.place(), true)?;
    let machine = which.machine()?;
    let settings = &shop.session.memory.settings;
    let made = card_file::for_card(
        &file.display().to_string(),
        &bytes,
        (settings, &machine),
        &mut workspace,
    );
    let CardFile { name: own, content, notes } = made.map_err(|why| anyhow!(Usage(why)))?;
    notes.iter().for_each(|note| eprintln!("kerf: {note}"));
    let name = name.map_or(own, str::to_owned);
    if let Some(exit) = looked_through(shop, controller, which, &name, &content)? {
        eprintln!("kerf: {name} was not put on the card");
        return Ok(exit);
    }
    let there = ask(controller, CardTask::List)?;
    if there.files.iter().any(|it| it.name == name) && !force && !agrees(&name)? {
        bail!("{name} is on the card already: --force replaces it, --name gives another name");
    }
    let size = content.len();
    ask(controller, CardTask::Upload { name: name.clone(), content })?;
    out::print(&format!("{name}: {size} bytes are on the card\n"));
    Ok(Exit::Good)
}

/// Asks whether a file on the card is replaced; a script says it beforehand.
fn agrees(name: &str) -> Result<bool> {
    if !io::stdin().is_terminal() {
        return Ok(false);
    }
    eprint!("{name} is on the card already. Replace it? [y/N] ");
    io::stderr().flush()?;
    let mut words = String::new();
    io::stdin().read_line(&mut words)?;
    Ok(words.trim().eq_ignore_ascii_case("y"))
}

/// Looks at a dry run of G-code for what the controller lacks, its limits too; the exit where something is wrong.
fn looked_through(
    shop: &Shop,
    controller: &Controller,
    which: &Which,
    name: &str,
    content: &[u8],
) -> Result<Option<Exit>> {
    let program = kerf_part::read_as(name.into(), content.to_vec(), kerf_sbp::Dialect::default());
    let files = setup::workspace(Path::new(""), &which.place(), true)?;
    let (work, options, answers) = (Work::from(program), RunOptions::default(), Answers::default());
    Ok(controller::look_through(controller, &work, &shop.session, &options, files, answers))
}

fn runs(
    shop: &mut Shop,
    controller: &Controller,
    which: &Which,
    name: &str,
    unseen: bool,
) -> Result<Exit> {
    match ask(controller, CardTask::Show(name.to_owned())) {
        Ok(shown) => {
            let looked = looked_through(shop, controller, which, name, shown.text.as_bytes())?;
            if let Some(exit) = looked {
                eprintln!("kerf: {name} was not begun");
                return Ok(exit);
            }
        }
        Err(why) if !unseen => bail!("{why}; --unseen runs it all the same, unchecked"),
        Err(why) => eprintln!("kerf: {why}: {name} runs unchecked"),
    }
    ask(controller, CardTask::Run(name.to_owned()))?;
    let stop = Stop::listen()?;
    let ended = controller.follows_card(&mut Shown::default().tells(), &mut || {
        stop.is_wanted().then_some(CardWish::Stop)
    });
    let exit = told(name, ended)?;
    shop.stands_where_it_stands()?;
    if exit == Exit::Stopped {
        shop.lifts()?;
    }
    Ok(exit)
}

/// Tells how the file ended.
fn told(name: &str, ended: Result<CardEnd, String>) -> Result<Exit> {
    Ok(match ended.map_err(|why| anyhow!(why))? {
        CardEnd::Ended => {
            out::print(&format!("{name} has run to its end\n"));
            Exit::Good
        }
        CardEnd::Stopped => {
            eprintln!("kerf: {name} was stopped, and is over");
            Exit::Stopped
        }
        CardEnd::Failed(why) => {
            eprintln!("kerf: {name} has ended: {why}");
            Exit::Failed
        }
        CardEnd::Left => {
            eprintln!("kerf: {name} runs on from the card, and is followed no longer");
            Exit::Good
        }
    })
}

/// A file that runs, as it is shown: a line each time it has come further by so much.
#[derive(Default)]
struct Shown {
    percent: Option<u32>,
    line: String,
}

impl Shown {
    fn tells(&mut self) -> impl FnMut(&CardState) {
        |state: &CardState| {
            let percent = state.job.percent.map(|percent| percent as u32 / 5 * 5);
            let at = state.job.line.map_or(String::new(), |line| format!(", line {line}"));
            let waits = state.waits.map_or(String::new(), |why| format!(", {why}"));
            let lost = if state.is_lost { ", its line is lost and is opened again" } else { "" };
            let beside = format!("{waits}{lost}");
            if percent.is_some() && percent != self.percent || beside != self.line {
                let share = percent.map_or(String::new(), |percent| format!(" {percent} %"));
                eprintln!("kerf: {} runs from the card{share}{at}{beside}", state.job.name);
                (self.percent, self.line) = (percent, beside);
            }
        }
    }
}

/// Follows what the controller runs, also where it tells nothing of itself before that is over.
fn follow(which: &Which, name: &DriverName) -> Result<Exit> {
    let Place::Followed(socket) = socket(name) else {
        bail!("a board with step queues has no card of its own")
    };
    let (driver, line) = (socket.opens)().map_err(|why| anyhow!(why))?;
    let opened = Connection::open_beside_card(&socket.name, driver, line, socket.log.clone());
    let mut connection = opened.map_err(|why| anyhow!(why))?;
    let Some(job) = connection.card_job() else {
        bail!("{} runs nothing from its card", socket.name)
    };
    connection.opens_again(socket.opens.clone());
    let stop = Stop::listen()?;
    let ended = follow_card(&mut connection, &mut Shown::default().tells(), &mut || {
        stop.is_wanted().then_some(CardWish::Stop)
    });
    let exit = told(&job.name, ended)?;
    connection.put_back();
    drop(connection);
    if exit == Exit::Stopped {
        let mut shop = Shop::open_after(which, First::LOOK, false)?;
        shop.lifts()?;
        shop.leave();
    }
    Ok(exit)
}
