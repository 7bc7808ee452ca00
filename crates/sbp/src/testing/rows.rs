//! Tests as tables: a program and what is seen of it.
//!
//! ```text
//! rows! {
//!     sbp_cmd_mx: "MX,2.5" => "at 2.5,0,0; last cut", "MX" => "error value expected";
//! }
//! ```
//!
//! What is seen is a list of clauses with `;` between them:
//!
//! | clause | means |
//! |---|---|
//! | `at 1,2,3` | working location at the end, first axes, within half a thousandth |
//! | `base 1,2,3` | table base location at the end |
//! | `71=3` | `%(71)` before the end of the file shows 3; `28=` shows nothing |
//! | `&a=3` | a variable at the end |
//! | `moves 2` | so many motion commands |
//! | `last cut`, `last jog` | the kind of the last straight move |
//! | `error text`, `warning text`, `no warning` | a message or hint that contains the text |

use super::{FakeHost, Ran, run_as};
use crate::{Options, Session};
use kerf_diag::Severity;
use kerf_program::{Axes, Command, MoveKind};

/// Tests by the rows of the ledger; see the head of the file.
macro_rules! rows {
    ($($(#[$mark:meta])* $name:ident: $($program:expr => $seen:expr),+;)+) => {
        $(
            #[test]
            $(#[$mark])*
            fn $name() {
                $($crate::testing::check($program, $seen);)+
            }
        )+
    };
}
pub(crate) use rows;

/// Runs a program from the fresh state and checks what is seen of it.
#[track_caller]
pub(crate) fn check(program: &str, seen: &str) {
    check_as(Options::default(), program, seen);
}

/// The same with options.
#[track_caller]
pub(crate) fn check_as(options: Options, program: &str, seen: &str) {
    let clauses: Vec<&str> = seen.split(';').map(str::trim).filter(|c| !c.is_empty()).collect();
    let mut text = program.to_string();
    for (number, _) in clauses.iter().filter_map(|c| system_variable(c)) {
        text += &format!("⏎&seen{number} = %({number})");
    }
    let ran = run_as(&text, FakeHost::default(), Session::default(), options);
    for clause in &clauses {
        let told = warnings(&ran).map(|(message, _)| message).collect::<Vec<_>>();
        let values = ran.session.variables.list();
        assert!(
            holds(&ran, clause),
            "`{program}`: not `{clause}`\nat {:?}\n{values:?}\n{told:?}\n{:?}",
            ran.location(),
            ran.error,
        );
    }
    let failed = ran.error.is_some();
    let expected = clauses.iter().any(|c| c.starts_with("error"));
    assert!(failed == expected, "`{program}`: {:?}", ran.error);
}

/// `71=3`.
fn system_variable(clause: &str) -> Option<(u8, &str)> {
    let (number, value) = clause.split_once('=')?;
    Some((number.parse().ok()?, value))
}

fn holds(ran: &Ran, clause: &str) -> bool {
    if let Some((number, value)) = system_variable(clause) {
        return same(&ran.session, &format!("seen{number}"), value);
    }
    let (word, rest) = clause.split_once(' ').unwrap_or((clause, ""));
    match word {
        "at" => near(ran.location(), rest),
        "base" => {
            let s = &ran.session;
            near(s.settings.to_user(s.frame.base(s.position)), rest)
        }
        "moves" => {
            let count = ran.commands.iter().filter(|c| c.command.is_motion()).count();
            rest.parse() == Ok(count)
        }
        "last" => {
            ran.commands.iter().rev().find_map(|c| match &c.command {
                Command::Line(line) => Some(if line.kind == MoveKind::Jog { "jog" } else { "cut" }),
                _ => None,
            }) == Some(rest)
        }
        "error" => ran.error.as_ref().is_some_and(|e| contains(&e.message, &e.hint, rest)),
        "warning" => warnings(ran).any(|(message, hint)| contains(message, hint, rest)),
        "no" => warnings(ran).next().is_none(),
        _ => match clause.strip_prefix('&').and_then(|c| c.split_once('=')) {
            Some((name, value)) => same(&ran.session, name, value),
            None => panic!("unknown clause `{clause}`"),
        },
    }
}

fn same(session: &Session, name: &str, value: &str) -> bool {
    let Some(found) = session.variables.get(name) else { return false };
    match (found.number(), value.parse::<f64>()) {
        (Some(a), Ok(b)) => (a - b).abs() <= 1e-6 * b.abs().max(1e-3),
        _ => found.display() == value,
    }
}

fn contains(message: &str, hint: &str, part: &str) -> bool {
    format!("{message} {hint}").to_lowercase().contains(&part.to_lowercase())
}

fn near(at: Axes, expected: &str) -> bool {
    expected.split(',').enumerate().all(|(i, text)| {
        let wanted: f64 = text.trim().parse().expect("a number");
        (at.0[i] - wanted).abs() < 5e-4
    })
}

fn warnings(ran: &Ran) -> impl Iterator<Item = (&str, &str)> {
    ran.commands.iter().filter_map(|c| match &c.command {
        Command::Diagnostic(d) if d.severity == Severity::Warning => {
            Some((d.message.as_str(), d.hint.as_str()))
        }
        _ => None,
    })
}
