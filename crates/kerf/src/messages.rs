//! Messages, help and pages name only commands and options that exist.

use clap::Command;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Crates that are no part of Kerf as users have it.
const TOOLS: [&str; 3] = ["xtask", "bench", "ledger"];

/// Options of other programs that pages name: cargo, npm, and the software of the handbooks.
const FOREIGN: [&str; 8] =
    ["lib", "test", "nocapture", "silent", "example", "release", "package", "quick"];

/// Options that no help lists, and that stay as they are: older names, a command line for editing alone, the rate of tests.
const LASTING: [&str; 3] = ["config", "edit_only", "rate"];

/// A text that users read: its place, and its words.
type UserText = (String, String);

/// The files below a folder with an extension, in order.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        match path.is_dir() {
            true => all.extend(files(&path, extension)),
            false if path.extension().is_some_and(|it| it == extension) => all.push(path),
            false => {}
        }
    }
    all.sort();
    all
}

/// The string literals of a source, without comments and tests.
fn literals(source: &str) -> Vec<String> {
    let shipped = source.split("#[cfg(test)]\n").next().unwrap_or_default();
    let code = shipped.lines().map(|line| match line.trim_start().strip_prefix("///") {
        // What clap shows is a comment of an option.
        Some(doc) => format!("\"{}\"", doc.replace('"', "'")),
        None if line.trim_start().starts_with("//") => String::new(),
        None => line.trim_end_matches('\\').trim().to_owned(),
    });
    let code = code.collect::<Vec<_>>().join(" ").replace("\\n", "\n").replace("\\\"", "'");
    code.split('"').skip(1).step_by(2).map(str::to_owned).collect()
}

/// All that users read: strings of the crates, the README and the pages of the book.
fn told() -> Vec<UserText> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let is_shipped = |path: &PathBuf| {
        let words: Vec<_> = path.iter().collect();
        words.iter().any(|it| *it == "src")
            && !path.ends_with("messages.rs")
            && !TOOLS.iter().any(|tool| words.contains(&tool.as_ref()))
    };
    let sources = files(&root.join("crates"), "rs").into_iter().filter(is_shipped);
    let of_source = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap_or_default();
        literals(&text).into_iter().map(move |it| (path.display().to_string(), it))
    };
    let pages = files(&root.join("docs/book"), "md").into_iter().chain([root.join("README.md")]);
    let of_page = |path: PathBuf| {
        let text = fs::read_to_string(&path).unwrap_or_default();
        (path.display().to_string(), text)
    };
    sources.flat_map(of_source).chain(pages.map(of_page)).collect()
}

/// The long options of a command and of all below it, with their aliases.
fn options(command: &Command) -> BTreeSet<String> {
    let shown = |arg: &&clap::Arg| !arg.is_hide_set() || LASTING.contains(&arg.get_id().as_str());
    let own = command.get_arguments().filter(shown).flat_map(|arg| {
        let aliases = arg.get_all_aliases().unwrap_or_default();
        arg.get_long().into_iter().chain(aliases).map(str::to_owned).collect::<Vec<_>>()
    });
    let below = command.get_subcommands().flat_map(options);
    own.chain(below).chain(["help", "version"].map(str::to_owned)).collect()
}

/// The options that a text names, without their dashes.
fn named_options(text: &str) -> impl Iterator<Item = &str> {
    text.match_indices("--").filter_map(|(at, _)| {
        let before = text[..at].chars().next_back();
        let word = &text[at + 2..];
        let end = word.find(|c: char| !(c.is_ascii_lowercase() || c == '-')).unwrap_or(word.len());
        let stands_alone =
            before.is_none_or(|c| !c.is_ascii_alphanumeric() && c != '-' && c != '<');
        Some(&word[..end]).filter(|it| stands_alone && it.starts_with(|c: char| c.is_alphabetic()))
    })
}

/// The calls in a text: what stands behind `kerf `, to the end of the line, the sentence or the quotation.
fn calls(text: &str) -> impl Iterator<Item = &str> {
    text.match_indices("kerf ").filter_map(|(at, call)| {
        let begins = text[..at].chars().next_back().is_none_or(|c| " `\n(|;:'$".contains(c));
        let rest = &text[at + call.len()..];
        let end = rest.find(['`', '\n', ';', '#', '|']).unwrap_or(rest.len());
        Some(&rest[..end]).filter(|it| begins && it.starts_with(|c: char| c.is_ascii_lowercase()))
    })
}

/// The options of every command by its name; without a name all of them.
fn by_command() -> BTreeMap<String, BTreeSet<String>> {
    let cli = crate::command_line();
    let each = cli.get_subcommands().flat_map(|command| {
        let names = command.get_all_aliases().chain([command.get_name()]);
        names.map(|name| (name.to_owned(), options(command))).collect::<Vec<_>>()
    });
    let foreign = FOREIGN.iter().map(|name| (*name).to_owned());
    let all = options(&cli).into_iter().chain(foreign).collect();
    each.chain([(String::new(), all)]).collect()
}

/// What a text names that does not exist.
fn unknown(commands: &BTreeMap<String, BTreeSet<String>>, text: &str) -> Vec<String> {
    let all = &commands[""];
    let mut wrong: Vec<String> = named_options(text)
        .filter(|name| !all.contains(*name))
        .map(|name| format!("no command has --{name}"))
        .collect();
    for call in calls(text) {
        let word = call.split(|c: char| !c.is_ascii_alphanumeric()).next().unwrap_or_default();
        let Some(own) = commands.get(word) else {
            wrong.push(format!("there is no kerf {word}"));
            continue;
        };
        let next = call.find("kerf ").unwrap_or(call.len());
        let foreign = named_options(&call[..next]).filter(|name| !own.contains(*name));
        wrong.extend(foreign.map(|name| format!("kerf {word} has no --{name}")));
    }
    wrong
}

#[test]
fn every_command_and_option_that_is_named_exists() {
    let commands = by_command();
    let wrong: Vec<String> = told()
        .iter()
        .flat_map(|(place, text)| {
            unknown(&commands, text)
                .into_iter()
                .map(move |why| format!("{place}: {why}: {text:.300}"))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// Longer texts are pages and helps, where calls stand in lines of their own.
const MESSAGE_LINES: usize = 20;

/// Whole calls in a text: in backticks, or a line that begins with one, without what stands behind it.
fn whole_calls(text: &str) -> Vec<String> {
    let quoted = text.split('`').skip(1).step_by(2).filter(|it| !it.contains('\n'));
    // Elsewhere a line of a message is a sentence.
    let is_page = text.lines().count() > MESSAGE_LINES;
    let shown = |line: &&str| !line.contains('`') && (is_page || line.starts_with("  "));
    let lines = text.lines().filter(shown).map(str::trim_start);
    let calls = quoted.chain(lines).filter(|it| it.starts_with("kerf "));
    let ends = ["  ", " #", " > ", " | ", " && ", " …"];
    let ended = |call: &str| {
        let end = ends.iter().filter_map(|end| call.find(end)).min();
        call[..end.unwrap_or(call.len())].trim_end_matches(['…', '.', ',']).to_owned()
    };
    calls.map(ended).collect()
}

/// The words of a call as a shell reads them, with a value in place of what only tells which one stands there.
fn words(call: &str) -> Vec<String> {
    let (mut words, mut word, mut quote) = (Vec::new(), String::new(), None);
    for c in call.chars() {
        match (c, quote) {
            ('\'' | '"', None) => quote = Some(c),
            (c, Some(open)) if c == open => quote = None,
            (' ', None) => words.push(std::mem::take(&mut word)),
            (c, _) => word.push(c),
        }
    }
    words.push(word);
    let filled = |word: String| match word.trim_end_matches('…') {
        "N" | "MM" | "SECONDS" | "VALUE" | "LEVEL" | "NUMBER" => "1".to_owned(),
        "X,Y" => "1,2".to_owned(),
        "X,Y,Z" => "1,2,3".to_owned(),
        "ADDR" => "127.0.0.1:1".to_owned(),
        "PERCENT@SECONDS" => "50@1".to_owned(),
        "N@T=0|1" => "1@1=1".to_owned(),
        word => word.to_owned(),
    };
    words.into_iter().filter(|word| !word.is_empty()).map(filled).collect()
}

/// Tells why the command line takes no such call. One that leaves something out is none to be typed, and may.
fn refused(cli: &Command, call: &str) -> Option<String> {
    use clap::error::ErrorKind::{
        DisplayHelp, DisplayHelpOnMissingArgumentOrSubcommand, DisplayVersion, InvalidValue,
        MissingRequiredArgument, MissingSubcommand,
    };
    if call.contains(['[', '<', '{', '|']) || call.contains("COMMAND") || call.contains("''") {
        return None;
    }
    let words = words(call);
    let names_option = words.last().is_some_and(|word| word.starts_with("--"));
    match cli.clone().try_get_matches_from(&words) {
        Ok(given) => crate::unused::refuse(cli, &given).err().map(|why| why.0),
        Err(error) => match error.kind() {
            MissingRequiredArgument | MissingSubcommand | DisplayHelp | DisplayVersion => None,
            DisplayHelpOnMissingArgumentOrSubcommand => None,
            InvalidValue if names_option => None,
            _ => Some(error.to_string().lines().next().unwrap_or_default().to_owned()),
        },
    }
}

#[test]
fn every_call_that_is_shown_is_taken_by_the_command_line() {
    let cli = crate::command_line();
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (place, text) in told() {
        for call in whole_calls(&text) {
            count += 1;
            let why = refused(&cli, &call);
            wrong.extend(why.map(|why| format!("{place}: {call}: {why}")));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 200, "{count} calls were found");
}

#[test]
fn a_call_that_is_refused_is_found() {
    let cli = crate::command_line();
    let check =
        |call: &str, taken: bool| assert_eq!(refused(&cli, call).is_none(), taken, "{call}");
    check("kerf run box.sbp --start kept", true);
    check("kerf run FILE --offset 2d", true);
    check("kerf send --resume-at", true);
    check("kerf run box.sbp --start warm", false);
    check("kerf io frobnicate", false);
    check("kerf toolpath a.rsg --hold-at 1", false);
    assert_eq!(
        whole_calls("say `kerf run A.sbp`;\n  kerf io list   all"),
        ["kerf run A.sbp", "kerf io list"]
    );
}

#[test]
fn names_that_do_not_exist_are_found() {
    let commands = by_command();
    let check = |text: &str, wrong: &[&str]| assert_eq!(unknown(&commands, text), wrong, "{text}");
    check("`kerf run box.sbp --start kept` has them; --force replaces it", &[]);
    check("say --anwers FILE", &["no command has --anwers"]);
    check("`kerf explain S002 --machine sim` tells", &["kerf explain has no --machine"]);
    check("kerf frobnicate does it", &["there is no kerf frobnicate"]);
}
