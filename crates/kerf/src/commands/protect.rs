//! `kerf machine password`: who may change the settings.

use crate::exit::Usage;
use crate::out;
use anyhow::{Result, bail};
use kerf_journal::machine_file::MachineFile;
use kerf_machine::password;
use kerf_machine::{Configuration, Value, file, table};
use std::io::{self, BufRead, IsTerminal};

/// The setting that holds the hash of the password.
pub const KEY: &str = "options.password";

/// Sees that the password of a machine was given; at a terminal it is asked for.
pub fn open(machine: &Configuration, given: Option<&str>) -> Result<()> {
    if self::given(machine, given)? {
        return Ok(());
    }
    if !io::stdin().is_terminal() {
        bail!(Usage("the settings are protected: give --password, or KERF_PASSWORD".into()));
    }
    self::given(machine, Some(&ask("password of the settings: ")?)).map(drop)
}

/// Tells whether settings may be changed: there is no password, or it was given. A wrong one is a mistake.
pub fn given(machine: &Configuration, given: Option<&str>) -> Result<bool> {
    let Some(kept) = &machine.options.password else { return Ok(true) };
    let Some(given) = of_option(given) else { return Ok(false) };
    if !password::fits(kept, &given) {
        bail!(Usage("this is not the password of the settings".into()));
    }
    Ok(true)
}

/// The password that an option or the environment gives.
pub fn of_option(given: Option<&str>) -> Option<String> {
    given.map(str::to_owned).or_else(|| std::env::var("KERF_PASSWORD").ok())
}

/// Sets a new password, which is asked for twice, or takes it away.
pub fn change(kept: &MachineFile, off: bool) -> Result<()> {
    let hash = if off { "none".to_owned() } else { new_hash()? };
    let _alone = kept.alone();
    let text = kept.text()?.unwrap_or_default();
    let mut wanted = kept.read(&text)?;
    let Some(setting) = table::setting(KEY) else { bail!("no setting {KEY}") };
    setting.set(&mut wanted, &Value::Text(hash)).map_err(|refused| Usage(refused.to_string()))?;
    kept.write(&file::edit(&text, setting, &wanted))?;
    out::print(if off {
        "the settings are open to everybody\n"
    } else {
        "the settings are protected\n"
    });
    Ok(())
}

fn new_hash() -> Result<String> {
    let new = [ask("new password: ")?, ask("again: ")?];
    if new[0] != new[1] {
        bail!(Usage("the two passwords are not the same".into()));
    }
    if new[0].chars().count() < password::SHORTEST {
        bail!(Usage(format!("a password has {} characters at least", password::SHORTEST)));
    }
    let mut salt = [0; 16];
    if getrandom::fill(&mut salt).is_err() {
        bail!("the system gives no random numbers");
    }
    Ok(password::hashed(&new[0], salt))
}

/// A line from whoever sits there, or from a script.
fn ask(words: &str) -> Result<String> {
    eprint!("{words}");
    let mut line = String::new();
    io::stdin().lock().read_line(&mut line)?;
    Ok(line.trim_end_matches(['\n', '\r']).to_owned())
}
