//! `kerf help`: the options of a command, or what a word means.

use crate::Cli;
use crate::exit::{Exit, Usage};
use crate::groups;
use crate::out;
use anyhow::{Result, bail};
use clap::{Args, CommandFactory};

/// Lists the options of a command, or tells what a word means
#[derive(Args)]
#[command(after_help = "Examples: kerf help run, kerf help terms, kerf help term kerf")]
pub struct HelpArgs {
    /// A command; `terms` for all words; `term` and a word
    words: Vec<String>,
}

pub fn run(args: &HelpArgs) -> Result<Exit> {
    let words: Vec<&str> = args.words.iter().map(String::as_str).collect();
    match words.as_slice() {
        ["terms"] => terms(),
        ["term", word @ ..] if !word.is_empty() => term(&word.join(" "))?,
        [] | ["help"] => {
            out::print(&groups::grouped(Cli::command()).render_long_help().to_string())
        }
        [name, ..] => match options(name, &words[1..]) {
            Some(text) => out::print(&text),
            None => term(&words.join(" "))?,
        },
    }
    Ok(Exit::Good)
}

/// The help of a command; those of a command are named after it.
fn options(name: &str, below: &[&str]) -> Option<String> {
    let mut cli = Cli::command();
    cli.build();
    let first = cli.find_subcommand_mut(name)?;
    let found = below.iter().try_fold(first, |command, name| command.find_subcommand_mut(name))?;
    Some(found.render_long_help().to_string())
}

/// The words of the project with what they mean.
const GLOSSARY: &str = include_str!("../../../../docs/glossary.md");

/// The rows of the glossary's table: a word and what it means.
fn rows() -> impl Iterator<Item = (&'static str, &'static str)> {
    let cells = |line: &'static str| {
        let (word, means) = line.strip_prefix("| ")?.strip_suffix(" |")?.split_once(" | ")?;
        (word != "word").then_some((word, means))
    };
    GLOSSARY.lines().filter_map(cells)
}

fn terms() {
    let lines = rows().map(|(word, means)| format!("{word:<20} {means}\n"));
    out::print(&lines.collect::<String>());
}

/// The word itself in any case, else all words that hold it.
fn term(wanted: &str) -> Result<()> {
    let wanted = wanted.to_lowercase();
    let is = |word: &str| word.to_lowercase() == wanted;
    let holds = |word: &str| word.to_lowercase().contains(&wanted);
    let exact: Vec<_> = rows().filter(|(word, _)| is(word)).collect();
    let found =
        if exact.is_empty() { rows().filter(|(word, _)| holds(word)).collect() } else { exact };
    if found.is_empty() {
        bail!(Usage(format!(
            "there is no command and no term `{wanted}`; `kerf help terms` lists all terms"
        )));
    }
    let lines = found.iter().map(|(word, means)| format!("{word}: {means}\n"));
    out::print(&lines.collect::<String>());
    Ok(())
}
