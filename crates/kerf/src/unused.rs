//! Options that a command shares with others and has no use for: not listed in its help, refused where they are given.

use crate::exit::Usage;
use clap::parser::ValueSource;
use clap::{ArgMatches, Command};

/// Parameters of FP.
const FILE: &[&str] =
    &["proportion", "repeat", "offset", "plunge", "tabs", "plunge_from_zero", "step", "from_line"];
/// Parameters of FP that mean nothing to typed lines.
const LINES_OF_A_FILE: &[&str] = &["step", "from_line"];
/// The operator of a run.
const OPERATOR: &[&str] = &["stop_at", "hold_at", "resume_at", "feed", "rapids", "spindle"];
/// Overrides that only a controller has.
const OF_CONTROLLERS: &[&str] = &["rapids", "spindle"];
/// The plan of motion.
const MOTION: &[&str] = &[
    "ramps",
    "tolerance",
    "axis_speed",
    "accel",
    "jerk",
    "smoothing",
    "stop_angle",
    "centripetal",
];
/// Events around the simulated machine.
const WORLD: &[&str] = &["input", "script", "sheet", "hand_move"];
/// Languages of part files, and how programs are followed.
const PROGRAM: &[&str] = &["set", "dialect", "max_lines", "allow_errors", "seed", "allow_shell"];
/// Folders where files of a program lie.
const FOLDERS: &[&str] = &["parts", "custom", "allow_path"];
/// What a run shows and writes.
const SHOWN: &[&str] = &["pace", "picture", "trace", "readings", "vcd", "controller_log"];

/// Options without a use, a row for each command that has some.
const UNUSED: &[(&str, &[&[&str]])] = &[
    ("check", &[OPERATOR, &["allow_errors"]]),
    ("preview", &[OF_CONTROLLERS]),
    ("plot", &[OF_CONTROLLERS]),
    ("time", &[OF_CONTROLLERS]),
    ("timing", &[OF_CONTROLLERS]),
    ("trace", &[OF_CONTROLLERS]),
    ("heights", &[FILE, PROGRAM, FOLDERS, OF_CONTROLLERS]),
    ("toolpath", &[FILE, OPERATOR, PROGRAM, FOLDERS]),
    ("convert", &[MOTION, OPERATOR, WORLD, &["step", "from_line", "start"]]),
    ("send", &[LINES_OF_A_FILE]),
    ("sysvars", &[&["custom", "allow_path", "allow_shell"]]),
    ("parts", &[&["machine", "custom", "allow_path", "allow_shell", "start"]]),
    ("settings show", &[&["custom", "allow_path", "allow_shell"]]),
    ("settings list", &[FOLDERS, &["machine", "allow_shell", "start"]]),
    ("settings save", &[FILE, OPERATOR, MOTION, WORLD, PROGRAM, SHOWN, &["answers"]]),
    ("settings load", &[FILE, OPERATOR, MOTION, WORLD, SHOWN]),
];

/// The options without a use of a command, by its words, as `settings save`.
fn unused(command: &str) -> impl Iterator<Item = &'static str> {
    let row = UNUSED.iter().find(|(name, _)| *name == command);
    row.into_iter().flat_map(|(_, groups)| groups.iter().copied().flatten().copied())
}

/// The command line, whose help lists what has a use.
pub fn hidden(cli: Command) -> Command {
    UNUSED.iter().fold(cli, |cli, (command, _)| {
        let words: Vec<&str> = command.split(' ').collect();
        hidden_in(cli, &words, command)
    })
}

fn hidden_in(command: Command, words: &[&str], row: &str) -> Command {
    match words {
        [] => unused(row).fold(command, |command, id| command.mut_arg(id, |arg| arg.hide(true))),
        [word, rest @ ..] => command.mut_subcommand(word, |below| hidden_in(below, rest, row)),
    }
}

/// Refuses options without a use.
///
/// # Errors
/// One is given.
pub fn refuse(cli: &Command, given: &ArgMatches) -> Result<(), Usage> {
    let (mut words, mut cli, mut given) = (Vec::new(), cli, given);
    while let Some((word, below)) = given.subcommand() {
        let Some(command) = cli.find_subcommand(word) else { break };
        words.push(command.get_name());
        (cli, given) = (command, below);
    }
    let row = words.join(" ");
    let is_given = |id: &&str| {
        let known = given.try_contains_id(id).is_ok();
        known && given.value_source(id) == Some(ValueSource::CommandLine)
    };
    let Some(id) = unused(&row).find(is_given) else { return Ok(()) };
    let long = cli.get_arguments().find(|arg| arg.get_id() == id).and_then(clap::Arg::get_long);
    Err(Usage(format!(
        "--{} is not heeded by kerf {row}: leave it out; kerf help {} lists its options",
        long.unwrap_or(id),
        words[0]
    )))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fmt::Write;

    /// The visible options of a command and of all below it, a line each: its words, what may be given.
    fn listed(words: &str, command: &Command, lines: &mut String) {
        let visible = command.get_arguments().filter(|arg| !arg.is_hide_set());
        let mut options: Vec<_> = visible.filter_map(|arg| arg.get_long()).collect();
        options.sort_unstable();
        let _ = writeln!(lines, "{words}: {}", options.join(" "));
        for below in command.get_subcommands().filter(|below| !below.is_hide_set()) {
            listed(&format!("{words} {}", below.get_name()), below, lines);
        }
    }

    /// A new option, or one that another command gets, is a decision: it stands in the list, and changes something there.
    #[test]
    fn each_option_of_each_command_is_in_the_list() {
        let mut lines = String::new();
        listed("kerf", &crate::command_line(), &mut lines);
        let mut sorted: Vec<&str> = lines.lines().collect();
        sorted.sort_unstable();
        let lines = sorted.join("\n") + "\n";
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/options.txt");
        if std::env::var_os("KERF_BLESS").is_some() {
            std::fs::write(path, &lines).unwrap_or_default();
        }
        let expected = std::fs::read_to_string(path).unwrap_or_default();
        for (line, expected) in lines.lines().zip(expected.lines()) {
            assert_eq!(line, expected);
        }
        assert_eq!(lines, expected);
    }

    #[test]
    fn an_option_without_a_use_is_refused_and_the_others_are_not() {
        let cli = crate::command_line();
        let check = |line: &str, refused: Option<&str>| {
            let given =
                cli.clone().try_get_matches_from(line.split(' ')).map_err(|e| e.to_string());
            let told = given.map(|given| refuse(&cli, &given).map_err(|why| why.0));
            match refused {
                Some(option) => {
                    let start = format!("{option} is not heeded by");
                    assert!(
                        matches!(&told, Ok(Err(why)) if why.starts_with(&start)),
                        "{line}: {told:?}"
                    );
                }
                None => assert_eq!(told, Ok(Ok(())), "{line}"),
            }
        };
        check("kerf toolpath a.rsg --hold-at 1", Some("--hold-at"));
        check("kerf path a.rsg --tabs", Some("--tabs"));
        check("kerf convert a.sbp a.nc --ramps optimal", Some("--ramps"));
        check("kerf settings save mine --override 50@1", Some("--override"));
        check("kerf toolpath a.rsg --ramps optimal --data d", None);
        check("kerf run a.sbp --hold-at 1 --tabs", None);
    }
}
