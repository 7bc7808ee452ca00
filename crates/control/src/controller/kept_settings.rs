//! Settings that a controller keeps by number (`$120`), written and read back.

use super::Connection;
use super::connection::NAP;
use kerf_machine::driver::Wired;
use kerf_program::Axis;

/// The setting of the steps of X; those of the other axes follow.
pub const STEPS: u16 = 100;

/// A controller writes a setting and tells all of them within this, seconds.
const WRITTEN_S: f64 = 4.0;

/// Controllers keep three decimals: what was read back is the same within this, and this share.
const SAME: f64 = 0.000_6;
const SAME_SHARE: f64 = 1e-4;

/// A setting that was written into a controller.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WrittenSetting {
    /// Its number.
    pub number: u16,
    /// Its value before, as the controller told it.
    pub was: String,
    /// The one that it told since.
    pub kept: String,
}

impl WrittenSetting {
    /// Returns the letter of the axis whose steps it is: by others the controller's own count of where it stands is another.
    pub fn letter_of_steps(&self) -> Option<char> {
        let axis = usize::from(self.number.checked_sub(STEPS)?);
        Axis::ALL.get(axis).map(|axis| axis.letter())
    }

    /// Tells of it in a sentence.
    pub fn sentence(&self) -> String {
        let Self { number, was, kept } = self;
        match self.letter_of_steps() {
            Some(letter) => format!(
                "the controller keeps {kept} steps a millimetre of {letter} now: it counts anew where {letter} stands, so home it or set its location"
            ),
            None => format!("the controller keeps ${number}={kept} now, and kept {was} before"),
        }
    }
}

/// Returns the settings of a controller that typed lines set, `$120=300`; none where no line is such a one.
///
/// # Errors
/// One stands among lines of a program.
pub fn settings_in(lines: &str) -> Result<Vec<(u16, String)>, String> {
    let lines: Vec<&str> = lines.lines().map(str::trim).filter(|line| !line.is_empty()).collect();
    let set: Vec<_> = lines.iter().filter_map(|line| setting_in(line)).collect();
    match set.first() {
        Some((number, _)) if set.len() < lines.len() => Err(format!(
            "${number} is a setting of the controller: write it by itself, beside no other lines"
        )),
        _ => Ok(set),
    }
}

fn setting_in(line: &str) -> Option<(u16, String)> {
    let (number, value) = line.strip_prefix('$')?.split_once('=')?;
    let value = value.trim();
    Some((number.trim().parse().ok().filter(|_| !value.is_empty())?, value.to_owned()))
}

/// Returns the question in the controller's own language that a typed line is: `$I`.
pub fn question_in(lines: &str) -> Option<&str> {
    let line = lines.trim();
    let is_one = line.starts_with('$') && !line.contains(['=', '\n', ' ']);
    is_one.then_some(line)
}

/// Asks the controller a question, and waits until it is answered: the answer is among the lines that came.
///
/// # Errors
/// The controller is busy, the text is no question, or the controller does not know it.
pub fn ask(
    connection: &mut Connection,
    question: &str,
    is_stopped: impl FnMut() -> bool,
) -> Result<(), String> {
    let refused = |name: &str, why: String| format!("{name}: {why}");
    let asks = |driver: &mut dyn Wired| driver.asks(question);
    answered(connection, asks, || format!("it has not answered {question}"), is_stopped)?;
    match connection.link.driver().takes_refusal() {
        Some(why) => Err(refused(&connection.name, why)),
        None => Ok(()),
    }
}

/// Says something to a controller that rests, and waits until it is answered.
fn answered(
    connection: &mut Connection,
    says: impl FnOnce(&mut dyn Wired) -> Result<(), String>,
    silent: impl Fn() -> String,
    mut is_stopped: impl FnMut() -> bool,
) -> Result<(), String> {
    let refused = |name: &str, why: String| format!("{name}: {why}");
    if connection.open > 0 || connection.failure.is_some() {
        return Err(refused(&connection.name, "it is at work, or takes no orders".into()));
    }
    says(&mut **connection.link.driver()).map_err(|why| refused(&connection.name, why))?;
    let until_s = connection.now_s() + WRITTEN_S;
    while !connection.link.driver().knows_zeros() && connection.failure.is_none() {
        if connection.now_s() > until_s || is_stopped() {
            return Err(refused(&connection.name, silent()));
        }
        connection.tend(NAP);
    }
    connection.failure.as_ref().map_or(Ok(()), |fault| Err(fault.message.clone()))
}

/// Has the controller keep another value of a setting; returns what it told then.
///
/// # Errors
/// It keeps no such setting, is at work, refuses the value, was stopped meanwhile, or keeps another value.
pub fn change_setting(
    connection: &mut Connection,
    number: u16,
    value: &str,
    is_stopped: impl FnMut() -> bool,
) -> Result<String, String> {
    let refused = |name: &str, why: String| format!("{name}: {why}");
    let keeps = |driver: &mut dyn Wired| driver.keeps_setting(number, value);
    let silent = || format!("it has not said that ${number} is written");
    answered(connection, keeps, silent, is_stopped)?;
    if let Some(why) = connection.link.driver().takes_refusal() {
        return Err(refused(&connection.name, why));
    }
    connection.hears_facts();
    let kept = connection.link.driver().setting(number).unwrap_or_default().trim().to_owned();
    if !same(&kept, value) {
        let why = format!("it keeps ${number}={kept}, and not the {value} that was written");
        return Err(refused(&connection.name, why));
    }
    Ok(kept)
}

/// Returns `true` if a value that was read back is the one that was written.
fn same(kept: &str, value: &str) -> bool {
    let number = |text: &str| text.split_whitespace().next()?.parse::<f64>().ok();
    match (number(kept), number(value)) {
        (Some(kept), Some(value)) => (kept - value).abs() < SAME.max(value.abs() * SAME_SHARE),
        _ => kept == value.trim(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const AMONG_OTHERS: &str =
        "$120 is a setting of the controller: write it by itself, beside no other lines";

    #[test]
    fn settings_of_a_controller_stand_by_themselves() {
        let check = |lines: &str, expected: Result<&[(u16, &str)], &str>| {
            let own =
                |all: &[(u16, &str)]| all.iter().map(|(n, v)| (*n, (*v).to_owned())).collect();
            assert_eq!(settings_in(lines), expected.map(own).map_err(str::to_owned), "{lines}");
        };
        check("$120=300", Ok(&[(120, "300")]));
        check(" $120 = 300 \n\n$74=my shop\n", Ok(&[(120, "300"), (74, "my shop")]));
        check("MX,1\n$uValue=3\n", Ok(&[]));
        check("$120=", Ok(&[]));
        check("$120=300\nMX,1", Err(AMONG_OTHERS));
    }
}
