//! From a text to a configuration, with every mistake in its place.

use super::entries::{Entry, entries};
use crate::contradictions::{Contradiction, contradictions};
use crate::settings::Configuration;
use crate::table::{self, Setting};
use kerf_diag::{Code, Diagnostic, Severity, SourcePlace, did_you_mean};
use std::ops::Range;
use std::sync::Arc;

/// The configuration that a file gives.
///
/// # Errors
/// Every mistake in it.
pub fn read(file: &Arc<str>, text: &str) -> Result<Configuration, Vec<Diagnostic>> {
    read_over(Configuration::default(), file, text)
}

/// The same where the file changes another configuration.
///
/// # Errors
/// Every mistake in it.
pub fn read_over(
    base: Configuration,
    file: &Arc<str>,
    text: &str,
) -> Result<Configuration, Vec<Diagnostic>> {
    let (entries, unreadable) = entries(text);
    let source = Source { file, text };
    let mut found: Vec<Diagnostic> = unreadable
        .into_iter()
        .map(|it| Diagnostic::new(Code::NoConfiguration, source.place(&it.span), it.message))
        .collect();
    found.extend(entries.iter().filter_map(|entry| unknown(&source, entry)));
    let configuration = apply(base, &source, &entries, &mut found);
    if found.is_empty() {
        let crossed = contradictions(&configuration);
        found.extend(crossed.into_iter().map(|it| tell(&source, &entries, it)));
    }
    found.sort_by(|a, b| a.place.cmp(&b.place));
    if found.is_empty() { Ok(configuration) } else { Err(found) }
}

/// A configuration as [`write`](super::write) wrote it, whatever it holds: options of a run may have made
/// it contradict itself.
///
/// # Errors
/// The first line that is none of it.
pub fn read_back(text: &str) -> Result<Configuration, Diagnostic> {
    let (entries, unreadable) = entries(text);
    let source = Source { file: &"machine".into(), text };
    if let Some(it) = unreadable.into_iter().next() {
        return Err(Diagnostic::new(Code::NoConfiguration, source.place(&it.span), it.message));
    }
    let mut found = Vec::new();
    let configuration = apply(Configuration::default(), &source, &entries, &mut found);
    found.into_iter().next().map_or(Ok(configuration), Err)
}

/// Values are applied in the order of the table, so that a file may be written in any.
fn apply(
    mut configuration: Configuration,
    source: &Source<'_>,
    entries: &[Entry],
    found: &mut Vec<Diagnostic>,
) -> Configuration {
    for setting in table::settings() {
        let given = entries.iter().find(|entry| entry.key == setting.key);
        if let Some(entry) = given {
            found.extend(put(&mut configuration, setting, source, entry));
        }
    }
    configuration
}

fn put(
    configuration: &mut Configuration,
    setting: &Setting,
    source: &Source<'_>,
    entry: &Entry,
) -> Option<Diagnostic> {
    let place = source.place(&entry.value_span);
    let Some(value) = &entry.value else {
        let message = format!("{} cannot be a date or a number this large", setting.key);
        return Some(Diagnostic::new(Code::BadSetting, place, message));
    };
    let refused = setting.set(configuration, value).err()?;
    Some(Diagnostic::new(Code::BadSetting, place, refused.to_string()).hint(setting.doc))
}

/// Settings of the old program that mean nothing here, and why.
const NEEDLESS: [(&str, &str); 2] = [
    ("options.irq", "the system knows the interrupts of its ports: options.devices names them"),
    ("general.irq", "the system knows the interrupts of its ports: options.devices names them"),
];

/// Returns a note for each setting of a configuration that means nothing here.
pub fn notes(file: &Arc<str>, text: &str) -> Vec<Diagnostic> {
    let (entries, _) = entries(text);
    let source = Source { file, text };
    let note = |entry: &Entry| {
        let (key, why) = NEEDLESS.iter().find(|(key, _)| *key == entry.key)?;
        let place = source.place(&entry.key_span);
        let text = format!("{key} is ignored: {why}");
        Some(Diagnostic::new(Code::UnknownSetting, place, text).severity(Severity::Note))
    };
    entries.iter().filter_map(note).collect()
}

fn unknown(source: &Source<'_>, entry: &Entry) -> Option<Diagnostic> {
    if NEEDLESS.iter().any(|(key, _)| *key == entry.key) {
        return None;
    }
    if table::settings().any(|setting| setting.key == entry.key) {
        return None;
    }
    let place = source.place(&entry.key_span);
    let message = format!("there is no setting {}", entry.key);
    let near = did_you_mean(&entry.key, table::settings().map(|setting| setting.key));
    let hint = near.unwrap_or_else(|| "`kerf get` lists every setting".into());
    Some(Diagnostic::new(Code::UnknownSetting, place, message).hint(hint))
}

/// A contradiction, told at the first of its settings that the file names.
fn tell(source: &Source<'_>, entries: &[Entry], it: Contradiction) -> Diagnostic {
    let named = it.keys.iter().find_map(|key| entries.iter().find(|entry| entry.key == *key));
    let place = match named {
        Some(entry) => source.place(&entry.key_span),
        None => SourcePlace::line(source.file.clone(), 1),
    };
    Diagnostic::new(Code::Contradiction, place, it.message).hint(it.hint)
}

struct Source<'a> {
    file: &'a Arc<str>,
    text: &'a str,
}

impl Source<'_> {
    /// A stretch of bytes as line and column; of several lines the first.
    fn place(&self, span: &Range<usize>) -> SourcePlace {
        let before = self.text.get(..span.start).unwrap_or(self.text);
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        let stretch = self.text.get(span.clone()).unwrap_or_default();
        let first_line = stretch.lines().next().unwrap_or_default();
        SourcePlace {
            file: self.file.clone(),
            line: before.matches('\n').count() as u32 + 1,
            column: before[line_start..].chars().count() as u32 + 1,
            length: first_line.chars().count() as u32,
        }
    }
}
