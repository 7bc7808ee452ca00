//! The card of a controller: its files, listed, taken, deleted, and run by the controller itself.
//!
//! grblHAL says in `[NEWOPT:]` that it has a card (`SD`) and takes files by YMODEM (`YM`), `FluidNC` in `[OPT:]` (`S`). grbl
//! 1.1 has none.
//!
//! ```text
//!                grblHAL            FluidNC
//!  list          $F+                $SD/List
//!  show          $F<=NAME           $SD/Show=NAME
//!  delete        $FD=NAME           $SD/Delete=NAME
//!  run           $F=NAME            $SD/Run=NAME
//!  upload        YMODEM             $Xmodem/Receive=/sd/NAME, then XMODEM
//!  while it runs |SD:12.5,NAME      the same
//! ```
//!
//! While it runs a file grblHAL drops every line that it is sent, and hears characters such as `?` and `!` only: nothing else is
//! sent then. A reset ends the file.

use crate::at_once::ASK;
use crate::facts::{KnownFacts, Words};
use crate::report::{Doing, Report};
use crate::upload::{Upload, Went};
use kerf_machine::driver::{CardAnswer, CardFile, CardJob, CardNews, CardTask};

/// One that was told to run a file and stands so long afterwards has run it already, seconds.
const BEGUN_S: f64 = 0.6;

/// A name with more bytes is none: grblHAL takes no longer one.
const LONGEST: usize = 31;

/// Refusals of grblHAL: no card is mounted.
const NOT_MOUNTED: [u16; 2] = [61, 64];

/// Said of a task that comes at a wrong time.
pub(crate) const BUSY: &str = "it is at work, or takes no orders";

/// Opening of a task, as it goes to the controller.
pub(crate) enum Opening {
    /// A line, which it answers.
    Line(String),
    /// Bytes, behind which a file goes.
    Bytes(Vec<u8>),
}

/// State of the card: the task under way, and the file that runs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Card {
    /// The task under way, and its line.
    task: Option<(CardTask, String)>,
    answer: CardAnswer,
    upload: Option<Upload>,
    news: Option<CardNews>,
    job: Option<CardJob>,
    /// The moment at which it was told to run a file of which no report has told yet.
    begun_s: Option<f64>,
}

impl Card {
    /// A file runs, or was told to.
    pub(crate) const fn runs(&self) -> bool {
        self.job.is_some()
    }

    /// Something is done on it: it may say nothing meanwhile.
    pub(crate) const fn is_asked(&self) -> bool {
        self.task.is_some() || self.uploads()
    }

    /// A file is on its way: nothing else is sent.
    pub(crate) const fn uploads(&self) -> bool {
        self.upload.is_some()
    }

    /// The controller was reset: what it ran is over.
    pub(crate) fn was_reset(&mut self) {
        (self.job, self.begun_s) = (None, None);
        self.fails("the controller was reset");
    }

    fn fails(&mut self, why: &str) {
        if self.task.take().is_some() || self.upload.take().is_some() {
            self.news = Some(CardNews::Failed(why.to_owned()));
        }
    }

    /// A line that belongs to the answer of the task.
    fn hears(&mut self, line: &str) -> bool {
        let file = line.strip_prefix("[FILE:").and_then(|rest| rest.strip_suffix(']'));
        match (&self.task, file) {
            (Some((CardTask::Show(_), _)), _) if !line.starts_with("[MSG:") => {
                self.answer.text += line;
                self.answer.text.push('\n');
                self.news = Some(CardNews::Going(self.answer.text.len(), 0));
                true
            }
            (_, Some(told)) => {
                self.answer.files.extend(file_told(told));
                true
            }
            _ => false,
        }
    }
}

/// Reads `/box.nc|SIZE:1234`; a folder, and a file whose name cannot be sent back, is none.
fn file_told(told: &str) -> Option<CardFile> {
    let mut parts = told.split('|');
    let name = parts.next()?.trim();
    let bytes = parts.next()?.strip_prefix("SIZE:")?.trim().parse().ok()?;
    let usable = parts.all(|word| word != "UNUSABLE") && name != "..";
    usable.then(|| CardFile { name: name.trim_start_matches('/').to_owned(), bytes })
}

/// Refuses a name that would be another line, or a character that the controller obeys at once.
fn takes_name(name: &str) -> Result<(), String> {
    let spoils = |c: char| c.is_control() || !c.is_ascii() || "?!~<>|\"*:\\[]".contains(c);
    if name.is_empty() || name.len() > LONGEST {
        return Err(format!("'{name}' is no name for its card: 1 to {LONGEST} characters"));
    }
    match name.chars().find(|c| spoils(*c)) {
        Some(c) => Err(format!("'{name}' is no name for its card: it takes no {c:?} in one")),
        None => Ok(()),
    }
}

impl Card {
    /// Begins a task while nothing else is done on the card; returns what is said to the controller for it.
    pub(crate) fn begins(&mut self, task: CardTask, words: Words) -> Result<Opening, String> {
        if self.runs() || self.is_asked() {
            return Err(BUSY.into());
        }
        let line = match (&task, words) {
            (CardTask::List, Words::Hal { .. }) => "$F+".to_owned(),
            (CardTask::List, Words::Fluid) => "$SD/List".to_owned(),
            (CardTask::Show(name), _) => named(words, ["$F<=", "$SD/Show="], name)?,
            (CardTask::Delete(name), _) => named(words, ["$FD=", "$SD/Delete="], name)?,
            (CardTask::Run(name), _) => named(words, ["$F=", "$SD/Run="], name)?,
            (CardTask::Upload { name, content }, words) => {
                return self.begins_upload(words, name, content.clone()).map(Opening::Bytes);
            }
        };
        self.answer = CardAnswer::default();
        self.task = Some((task, line.clone()));
        Ok(Opening::Line(line))
    }

    fn begins_upload(
        &mut self,
        words: Words,
        name: &str,
        content: Vec<u8>,
    ) -> Result<Vec<u8>, String> {
        takes_name(name)?;
        let (upload, first) = match words {
            Words::Hal { takes: false } => {
                return Err("its firmware takes no files on this line: build it with YMODEM, or put the file on the card in this computer".into());
            }
            _ if content.is_empty() => return Err(format!("{name} is empty")),
            Words::Hal { takes: true } => (Upload::named(name, content), String::new()),
            Words::Fluid => (Upload::bare(content), format!("$Xmodem/Receive=/sd/{name}\n")),
        };
        (self.upload, self.answer) = (Some(upload), CardAnswer::default());
        Ok(first.into_bytes())
    }

    /// Adds what goes out of a file on its way; tells whether there is one. A question would be a byte of it.
    pub(crate) fn speaks(&mut self, out: &mut Vec<u8>, now_s: f64) -> bool {
        let Some(upload) = &mut self.upload else { return false };
        out.retain(|byte| *byte != ASK);
        out.extend(upload.speak(now_s));
        let went = upload.went();
        self.news = Some(match went {
            Went::On(done) => CardNews::Going(done, upload.size()),
            Went::Well => CardNews::Done(CardAnswer::default()),
            Went::Wrong(why) => CardNews::Failed(why.to_owned()),
        });
        if !matches!(went, Went::On(_)) {
            self.upload = None;
        }
        true
    }

    /// Takes a byte of the answers to a file that is on its way; tells whether one is.
    pub(crate) fn hears_byte(&mut self, byte: u8, now_s: f64) -> bool {
        self.upload.iter_mut().for_each(|upload| upload.hear(byte, now_s));
        self.uploads()
    }

    /// Gives up what is done; returns what ends it.
    pub(crate) fn gives_up(&mut self) -> Vec<u8> {
        let end = self.upload.as_mut().map(Upload::cancel);
        if end.is_some() {
            self.fails("it was stopped");
        }
        self.task = None;
        end.unwrap_or_default()
    }

    /// Takes a line that is about the card; tells whether it is.
    pub(crate) fn hears_line(&mut self, line: &str, told: &KnownFacts) -> bool {
        if let Some((why, place)) = line.split_once(" in SD file at line ") {
            let number = why.strip_prefix("error:").and_then(|number| number.parse().ok());
            let why = number.map_or_else(|| why.into(), |number| told.error(number));
            self.news =
                Some(CardNews::Failed(format!("line {place} of the file was refused: {why}")));
            return true;
        }
        self.hears(line)
    }

    /// The line of the task is answered.
    pub(crate) fn answered(&mut self, line: &str, now_s: f64) {
        let Some((task, _)) = self.task.take_if(|(_, own)| own == line) else { return };
        if let CardTask::Run(name) = task {
            self.job = Some(CardJob { name, ..CardJob::default() });
            self.begun_s = Some(now_s);
        }
        self.news = Some(CardNews::Done(std::mem::take(&mut self.answer)));
    }

    /// The line of the task is refused; tells whether it is one.
    pub(crate) fn is_refused(
        &mut self,
        line: Option<&str>,
        (number, why): (u16, &str),
        told: &KnownFacts,
    ) -> bool {
        let is_it = self.task.take_if(|(_, own)| Some(&**own) == line).is_some();
        if is_it {
            let why = match NOT_MOUNTED.contains(&number) && told.is_hal() {
                true => "there is no card in it, or none that it can read".to_owned(),
                false => format!("error {number}: {why}"),
            };
            self.news = Some(CardNews::Failed(why));
        }
        is_it
    }

    /// Follows a file that the controller runs by itself; tells whether it is over just now.
    pub(crate) fn follows(&mut self, report: &Report, now_s: f64) -> bool {
        if let Some((percent, name)) = &report.card {
            let job = CardJob {
                name: name.trim_start_matches('/').to_owned(),
                percent: Some(*percent),
                line: report.line,
            };
            (self.job, self.begun_s) = (Some(job), None);
            return false;
        }
        let Some(job) = &mut self.job else { return false };
        job.line = report.line.or(job.line);
        let has_begun = self.begun_s.is_none_or(|at_s| now_s - at_s > BEGUN_S);
        let ends = matches!(report.doing, Doing::Idle | Doing::Alarm(_)) && has_begun;
        if ends {
            (self.job, self.begun_s) = (None, None);
        }
        ends
    }

    pub(crate) const fn takes_news(&mut self) -> Option<CardNews> {
        self.news.take()
    }

    pub(crate) fn job(&self) -> Option<CardJob> {
        self.job.clone()
    }
}

fn named(words: Words, [hal, fluid]: [&str; 2], name: &str) -> Result<String, String> {
    let bare = name.trim_start_matches('/');
    takes_name(bare)?;
    Ok(match words {
        Words::Hal { .. } => format!("{hal}/{bare}"),
        Words::Fluid => format!("{fluid}/{bare}"),
    })
}
