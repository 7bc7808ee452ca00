//! A part file that a running server runs, with whoever sits here.

use super::ended::{Ended, findings, number_of_run};
use super::{LOOK, Refused, Remote, still_the_same};
use crate::args::FileArgs;
use crate::job_options::Choice;
use anyhow::{Result, bail};
use kerf_control::answers::{self, Operator};
use kerf_diag::{Diagnostic, Severity};
use kerf_program::{Button, Question};
use serde_json::{Value, json};
use std::thread::sleep;

/// Message where a page has the machine.
const BESIDE: &str = "the file was not run: a page has the machine";

/// Functions of somebody who goes along with a run.
pub struct Along<'a> {
    /// Answers its questions; a page may be first.
    pub operator: &'a mut dyn Operator,
    /// Returns `true` once the run is to be stopped.
    pub stopped: &'a dyn Fn() -> bool,
    /// Takes the lines that it prints.
    pub print: &'a mut dyn FnMut(&str),
    /// Takes what is wrong with the file, or worth knowing.
    pub show: &'a dyn Fn(&Diagnostic),
}

/// Kind of file that is run, with its options.
pub enum How {
    /// A part file, with the parameters of FP, and line by line where that is wanted.
    Part(FileArgs),
    /// A job.
    Job(Choice),
}

impl How {
    /// Returns `true` if the file is gone through line by line.
    const fn steps(&self) -> bool {
        matches!(self, Self::Part(FileArgs { step: true, .. }))
    }

    /// The parameters as a server takes them, with lengths of so many mm.
    fn parameters(&self, unit_mm: f64) -> Value {
        let Self::Part(file) = self else { return json!({}) };
        json!({
            "proportion": file.proportion.unwrap_or([1.0; 3]),
            "repetitions": file.repeat,
            "offset": file.offset.unwrap_or(0),
            "plunge": file.plunge.unwrap_or(0.0) * unit_mm,
            "tabs": file.tabs,
            "plungeFromZero": file.plunge_from_zero,
        })
    }

    /// Returns what is chosen of a job, where anything is.
    fn choice(&self) -> Option<Value> {
        match self {
            Self::Job(choice) if *choice != Choice::default() => {
                Some(json!({ "start": choice.start, "offset": choice.offset_mm }))
            }
            _ => None,
        }
    }
}

impl Remote {
    /// Has a file of the server's part folder run, after arming the machine where that is wanted.
    pub fn run(&self, name: &str, how: &How, arm: bool, along: Along<'_>) -> Result<Ended> {
        let unit_mm = self.state()?["units"]["mm"].as_f64().unwrap_or(1.0);
        self.act("open", json!({ "name": name, "parameters": how.parameters(unit_mm) }))?;
        if let Some(choice) = how.choice() {
            self.act("choose", json!({ "choice": choice }))?;
        }
        let (hash, found) = self.previewed(name)?;
        let show = along.show;
        let mut ended = self.driving(BESIDE, arm, |lease, before| {
            let starts =
                self.act("run", json!({ "lease": lease, "hash": hash, "step": how.steps() }));
            if starts.as_ref().is_err_and(is_mistake) {
                found.iter().for_each(show);
            }
            starts?;
            found.iter().filter(|it| it.severity == Severity::Warning).for_each(show);
            self.goes_along(before, along)
        })?;
        // Of an error that the preview met as well it knows more.
        let notes = found.into_iter().filter(|it| it.severity == Severity::Note);
        ended.told.extend(notes);
        Ok(ended)
    }

    /// Waits until a file that was opened is previewed; its hash, and what was found in it.
    fn previewed(&self, name: &str) -> Result<(Value, Vec<Diagnostic>)> {
        loop {
            let state = self.state()?;
            let opened = &state["opened"];
            if opened["name"] != name {
                bail!("another file was opened meanwhile: {}", opened["name"]);
            }
            match opened["preview"]["state"].as_str() {
                Some("working") => sleep(LOOK),
                Some("failed") => {
                    bail!("{name}: {}", opened["preview"]["why"].as_str().unwrap_or_default())
                }
                _ => return Ok((opened["hash"].clone(), findings(&state))),
            }
        }
    }

    fn goes_along(&self, before: &Value, along: Along<'_>) -> Result<Ended> {
        let Along { operator, stopped, print, .. } = along;
        let (mut printed, mut answered, mut stops) = (lines(before), None, false);
        let mut last = number_of_run(before);
        loop {
            let now = self.state()?;
            let told = lines(&now);
            news(&printed, &told).iter().for_each(|line| print(line));
            printed = told;
            if let Some(ended) = Ended::of(&now, number_of_run(before)) {
                return Ok(ended);
            }
            last = still_the_same(&now, last)?;
            if stopped() && !std::mem::replace(&mut stops, true) {
                self.act("stop", json!({}))?;
            }
            let asked = &now["asked"];
            if !asked.is_null() && answered != asked["number"].as_u64() {
                answered = asked["number"].as_u64();
                if let Some(told) = self.answer(asked, operator)? {
                    print(&told);
                }
            }
            sleep(LOOK);
        }
    }

    /// Answers an open question; without an operator as nobody would. Gives what is shown of that.
    fn answer(&self, asked: &Value, operator: &mut dyn Operator) -> Result<Option<String>> {
        let Some(question) = question(asked) else { return Ok(None) };
        let file = asked["file"].as_str().unwrap_or_default();
        let line = asked["line"].as_u64().unwrap_or_default() as u32;
        let answer = operator.answer_in(&question, file, line);
        let by = if answer.is_some() { "" } else { " (default)" };
        let answer =
            answer.unwrap_or_else(|| answers::words(&answers::unattended_answer(&question)));
        let number = &asked["number"];
        let told = self.act("answer", json!({ "question": number, "answer": answer }));
        // Somebody at a page may have been first.
        match (told, self.state()?["asked"]["number"] == *number) {
            (Err(why), true) => Err(why),
            (Err(_), false) => Ok(None),
            (Ok(()), _) => Ok(Some(format!("? {} → {answer}{by}", question.text))),
        }
    }
}

/// Returns `true` if a server did not start a file because of what is wrong with it.
fn is_mistake(why: &anyhow::Error) -> bool {
    why.downcast_ref::<Refused>().is_some_and(|refused| refused.mistake)
}

/// The print window.
fn lines(state: &Value) -> Vec<String> {
    let lines = state["printed"].as_array().into_iter().flatten();
    lines.filter_map(|line| line.as_str().map(str::to_owned)).collect()
}

/// Returns the lines that came to a list that forgets its oldest lines.
fn news<'a>(before: &[String], now: &'a [String]) -> &'a [String] {
    let still = (0..=before.len()).find(|from| now.starts_with(&before[*from..]));
    &now[before.len() - still.unwrap_or(before.len())..]
}

/// The question as the machine asked it.
fn question(asked: &Value) -> Option<Question> {
    let text = |key: &str| asked[key].as_str().unwrap_or_default().to_owned();
    let words = asked["buttons"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let button = |word: &str| Button::ALL.into_iter().find(|button| button.word() == word);
    Some(Question {
        kind: answers::kind_of(&text("kind"))?,
        text: text("text"),
        title: text("title"),
        buttons: words.filter_map(button).collect(),
        default: asked["default"].as_u64().unwrap_or_default() as usize,
        prefill: text("prefill"),
        icon: asked["icon"].as_u64().unwrap_or_default() as _,
        until: None,
    })
}

#[cfg(test)]
mod tests {
    use super::news;

    #[test]
    fn lines_are_printed_once() {
        let list = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        for (before, now, new) in [
            ("", "a b", "a b"),
            ("a b", "a b c", "c"),
            ("a b c", "b c d e", "d e"),
            ("a", "b c", "b c"),
            ("a b", "", ""),
        ] {
            assert_eq!(news(&list(before), &list(now)), list(new), "{before} | {now}");
        }
    }
}
