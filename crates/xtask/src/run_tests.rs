//! Runs every test program of the workspace.
//!
//! Cargo runs test programs one after another, and most of the longer ones wait for a machine half of their time. Here
//! as many as there are processors run side by side, those that wait most and the largest first; each tells its result
//! when it has ended. The programs that measure time run afterwards.

use crate::{Finding, Tree};
use anyhow::{Context, Result, bail};
use serde_json::Value;
use std::collections::VecDeque;
use std::io::{Write, stdout};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::{Mutex, mpsc};
use std::thread;

/// Tests at once of programs that wait for a machine most of the time: name of the crate's folder, of the target, tests.
const WAITING: [(&str, &str, usize); 2] = [("server", "all", 5), ("kerf", "all", 4)];

/// Programs that measure time, and the number of their tests that may run at once. Those of a row run side by side: a
/// controller and a slow link are waited for most of the time. A bound on STOP is measured by itself.
const MEASURING: [&[(&str, usize)]; 2] =
    [&[("controller", 8), ("jog_link", 1)], &[("stop_under_load", 1)]];

/// The configuration of Cargo, whose `[env]` Cargo gives to the programs that it runs itself.
const CONFIGURATION: &str = ".cargo/config.toml";

/// Names of environment variables and their values.
type Variables = Vec<(String, String)>;

/// One test program.
#[derive(Clone, Debug)]
struct Program {
    /// Name of its target: `all`, or the crate's own for the tests beside the code.
    target: String,
    path: PathBuf,
    /// Folder of its crate, in which it runs.
    folder: PathBuf,
    bytes: u64,
    /// Tests at once; nothing for one per processor.
    threads: Option<usize>,
    /// Row of [`MEASURING`] in which it stands.
    measuring: Option<usize>,
}

/// Builds and runs all test programs and the examples in documentation; returns what failed.
///
/// # Errors
///
/// Cargo or a program cannot be started, or the workspace does not compile.
pub fn run(tree: &Tree) -> Result<Vec<Finding>> {
    let variables = configured(tree)?;
    let mut programs = built()?;
    programs.sort_by_key(|program| (program.threads.is_none(), std::cmp::Reverse(program.bytes)));
    let mut failed = Vec::new();
    for measuring in std::iter::once(None).chain((0..MEASURING.len()).map(Some)) {
        let these = programs.iter().filter(|program| program.measuring == measuring);
        failed.extend(side_by_side(these.cloned().collect(), &variables)?);
    }
    let documented = Command::new(cargo())
        .args(["test", "--workspace", "--locked", "--no-fail-fast", "--doc"])
        .status();
    if !documented.context("cargo does not start")?.success() {
        failed.push(Finding::file("crates", "an example in documentation fails"));
    }
    Ok(failed)
}

fn cargo() -> String {
    std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned())
}

/// Reads the variables that Cargo gives to the programs it runs, without those that are set already.
fn configured(tree: &Tree) -> Result<Variables> {
    let text = tree.text(CONFIGURATION).with_context(|| format!("{CONFIGURATION} is not there"))?;
    let mut config: toml::Table = text.parse().context(CONFIGURATION)?;
    let Some(toml::Value::Table(env)) = config.remove("env") else { return Ok(Vec::new()) };
    env.into_iter()
        .filter(|(name, _)| std::env::var_os(name).is_none())
        .map(|(name, value)| match value {
            toml::Value::String(value) => Ok((name, value)),
            other => bail!("{CONFIGURATION}: {name} is {other}, not a text"),
        })
        .collect()
}

fn built() -> Result<Vec<Program>> {
    let made = Command::new(cargo())
        .args([
            "test",
            "--workspace",
            "--locked",
            "--no-run",
            "--message-format=json-render-diagnostics",
        ])
        .stderr(Stdio::inherit())
        .output()
        .context("cargo does not start")?;
    if !made.status.success() {
        bail!("the workspace does not compile");
    }
    String::from_utf8_lossy(&made.stdout)
        .lines()
        .filter_map(|line| program(line).transpose())
        .collect()
}

/// Reads a message of cargo, where it tells of a test program.
fn program(line: &str) -> Result<Option<Program>> {
    let message: Value = serde_json::from_str(line).context("a message of cargo")?;
    let text = |of: &Value| of.as_str().map(str::to_owned);
    let tested = message["profile"]["test"] == true;
    let (Some(path), Some(manifest), Some(target)) = (
        text(&message["executable"]),
        text(&message["manifest_path"]),
        text(&message["target"]["name"]),
    ) else {
        return Ok(None);
    };
    if !tested {
        return Ok(None);
    }
    let path = PathBuf::from(path);
    let bytes = path.metadata().with_context(|| format!("{} is not there", path.display()))?.len();
    let folder = PathBuf::from(manifest).parent().context("a crate without a folder")?.to_owned();
    let (measuring, threads) = placed(&folder, &target);
    Ok(Some(Program { target, path, folder, bytes, threads, measuring }))
}

/// Finds the row of [`MEASURING`] of a program, and how many of its tests run at once.
fn placed(folder: &Path, target: &str) -> (Option<usize>, Option<usize>) {
    for (row, programs) in MEASURING.iter().enumerate() {
        if let Some((_, threads)) = programs.iter().find(|(name, _)| *name == target) {
            return (Some(row), Some(*threads));
        }
    }
    let waits = |(of, name, _): &&(&str, &str, usize)| folder.ends_with(of) && *name == target;
    (None, WAITING.iter().find(waits).map(|(_, _, threads)| *threads))
}

fn side_by_side(programs: Vec<Program>, variables: &Variables) -> Result<Vec<Finding>> {
    let waiting = Mutex::new(VecDeque::from(programs));
    let next = || waiting.lock().ok().and_then(|mut waiting| waiting.pop_front());
    let workers = thread::available_parallelism().map_or(2, usize::from);
    let (ended, told) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..workers {
            let ended = ended.clone();
            scope.spawn(move || {
                while let Some(program) = next() {
                    let output = output(&program, variables);
                    if ended.send((program, output)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(ended);
        let mut failed = Vec::new();
        for (program, output) in told {
            failed.extend(tell(&program, &output?)?);
        }
        Ok(failed)
    })
}

fn output(program: &Program, variables: &Variables) -> Result<Output> {
    let mut command = Command::new(&program.path);
    command
        .arg("--show-output")
        .envs(variables.iter().map(|(name, value)| (name, value)))
        .current_dir(&program.folder)
        .env("CARGO_MANIFEST_DIR", &program.folder);
    if let Some(threads) = program.threads {
        command.env("RUST_TEST_THREADS", threads.to_string());
    }
    command.output().with_context(|| format!("{} does not start", program.path.display()))
}

/// Prints what a program told; returns a finding where it failed.
fn tell(program: &Program, output: &Output) -> Result<Option<Finding>> {
    let name = format!("{} of {}", program.target, program.folder.display());
    let mut out = stdout().lock();
    writeln!(out, "     Running {name}")?;
    out.write_all(&output.stdout)?;
    out.write_all(&output.stderr)?;
    let finding = || {
        Finding::file(
            program.folder.to_string_lossy(),
            format!("a test of `{}` fails", program.target),
        )
    };
    Ok((!output.status.success()).then(finding))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_of_another_kind_is_no_program() -> Result<()> {
        let check = |line: &str| -> Result<()> {
            assert!(program(line)?.is_none(), "{line}");
            Ok(())
        };
        check(r#"{"reason":"build-finished","success":true}"#)?;
        check(
            r#"{"reason":"compiler-artifact","executable":null,"profile":{"test":true},"target":{"name":"a"}}"#,
        )?;
        check(
            r#"{"executable":"/x","manifest_path":"/a/Cargo.toml","profile":{"test":false},"target":{"name":"kerf"}}"#,
        )
    }

    #[test]
    fn programs_have_the_variables_that_cargo_gives_them() -> Result<()> {
        let check = |text: &str, expected: &[(&str, &str)]| -> Result<()> {
            let found = configured(&Tree::of(&[(CONFIGURATION, text)]))?;
            let expected: Variables = expected
                .iter()
                .map(|(name, value)| (name.to_string(), value.to_string()))
                .collect();
            assert_eq!(found, expected, "{text}");
            Ok(())
        };
        check("[env]\nKERF_NOWHERE = \"1\"", &[("KERF_NOWHERE", "1")])?;
        check("[env]\nPATH = \"/\"", &[])?;
        check("[alias]\nx = \"y\"", &[])?;
        assert!(configured(&Tree::of(&[(CONFIGURATION, "[env]\nX = 1")])).is_err());
        Ok(())
    }

    #[test]
    fn a_program_that_measures_time_runs_behind_the_others() -> Result<()> {
        let check = |folder: &str, target: &str, row, threads| -> Result<()> {
            let here = std::env::current_exe()?;
            let line = serde_json::json!({
                "executable": here, "manifest_path": format!("{folder}/Cargo.toml"),
                "profile": { "test": true }, "target": { "name": target },
            });
            let found = program(&line.to_string())?.context("a program")?;
            assert_eq!((found.measuring, found.threads), (row, threads), "{target} of {folder}");
            assert_eq!(found.folder, PathBuf::from(folder));
            Ok(())
        };
        check("/a/geom", "all", None, None)?;
        check("/a/server", "all", None, Some(5))?;
        check("/a/server", "kerf_server", None, None)?;
        check("/a/kerf", "controller", Some(0), Some(8))?;
        check("/a/server", "jog_link", Some(0), Some(1))?;
        check("/a/kerf", "stop_under_load", Some(1), Some(1))
    }
}
