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
//!  while it runs |SD:12.5,NAME      |SD:12.50,/sd/NAME
//!  a file        [FILE:/a/b.nc|SIZE:5]    [DIR:a], then [FILE:  b.nc|SIZE:5]: a blank, and one for each folder
//!  a bad line    error:22 in SD file …    [MSG:ERR: 22 (…) in /sd/NAME at line 3]
//! ```
//!
//! `FluidNC` answers `ok` to the deletion of a file that is not there, and deletes a folder with all that is in it: the card is
//! listed first, and only a file on it is deleted. It says `S` whether it has a slot or not; one without refuses the list.
//!
//! While it runs a file grblHAL drops every line that it is sent, and hears characters such as `?` and `!` only: nothing else is
//! sent then. A reset ends the file.

use crate::at_once::ASK;
use crate::facts::{KnownFacts, Words};
use crate::report::{Doing, Report};
use crate::upload::{Upload, Went};
use kerf_machine::driver::{
    CardAnswer, CardFile, CardJob, CardNews, CardTask, NO_CARD_IN, TAKES_NO_FILES,
};

/// One that was told to run a file and stands so long afterwards has run it already, seconds.
const BEGUN_S: f64 = 0.6;

/// A name with more bytes is none: grblHAL takes no longer one, and a line of `FluidNC` ends behind 255.
const LONGEST: usize = 31;
const LONGEST_FLUID: usize = 200;

/// The folder under which `FluidNC` knows its card.
const FLUID_CARD: &str = "/sd/";

/// Has `FluidNC` list its card.
const FLUID_LIST: &str = "$SD/List";

/// `FluidNC` passes over a line of a file with this refusal, an unknown word; every other one ends the file.
const PASSED_OVER: u16 = 20;

/// Refusals of grblHAL, and of `FluidNC`: no card is mounted.
const NOT_MOUNTED: [u16; 3] = [60, 64, 65];
const NOT_MOUNTED_FLUID: [u16; 1] = [60];

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
    /// The folders in which the file that is told next lies (`FluidNC`).
    folders: Vec<String>,
    upload: Option<Upload>,
    /// Its end was told already: somebody has stopped it.
    is_told: bool,
    news: Option<CardNews>,
    job: Option<CardJob>,
    /// The moment at which it was told to run a file of which no report has told yet.
    begun_s: Option<f64>,
    /// Its own refusal of a line of the file, which ended it.
    fault: Option<(u16, String)>,
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
        if let (Some((CardTask::Show(_), _)), false) = (&self.task, line.starts_with("[MSG:")) {
            self.answer.text += line;
            self.answer.text.push('\n');
            self.news = Some(CardNews::Going(self.answer.text.len(), 0));
            return true;
        }
        let inner = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
        match inner.and_then(|inner| inner.split_once(':')) {
            Some(("FILE", told)) => {
                let file = file_told(told).map(|file| self.in_folder(told, file));
                self.answer.files.extend(file);
            }
            // A folder is told before what is in it, behind a blank for each folder that it lies in.
            Some(("DIR", told)) => {
                self.folders.truncate(blanks(told));
                self.folders.push(told.trim_start().to_owned());
            }
            _ => return false,
        }
        true
    }

    /// Puts the folders before the name of a file that is told behind a blank, and another for each folder.
    fn in_folder(&self, told: &str, file: CardFile) -> CardFile {
        let Some(depth) = blanks(told).checked_sub(1) else { return file };
        let folders = self.folders.iter().take(depth).map(String::as_str);
        let name = folders.chain([&*file.name]).collect::<Vec<_>>().join("/");
        CardFile { name, ..file }
    }
}

/// Returns the number of blanks before words.
fn blanks(told: &str) -> usize {
    told.len() - told.trim_start_matches(' ').len()
}

/// Reads `/box.nc|SIZE:1234`; a file whose name cannot be sent back is none.
fn file_told(told: &str) -> Option<CardFile> {
    let mut parts = told.split('|');
    let name = parts.next()?.trim();
    let bytes = parts.next()?.strip_prefix("SIZE:")?.trim().parse().ok()?;
    let usable = parts.all(|word| word != "UNUSABLE") && name != "..";
    usable.then(|| CardFile { name: name.trim_start_matches('/').to_owned(), bytes })
}

/// Refuses a name that would be another line, or a character that the controller obeys at once.
fn takes_name(name: &str, words: Words) -> Result<(), String> {
    let longest = if words == Words::Fluid { LONGEST_FLUID } else { LONGEST };
    let spoils = |c: char| c.is_control() || !c.is_ascii() || "?!~<>|\"*:\\[]".contains(c);
    if name.is_empty() || name.len() > longest {
        return Err(format!("'{name}' is no name for its card: 1 to {longest} characters"));
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
        // What nobody has asked for of a task before is no answer to this one.
        self.news = None;
        let line = match (&task, words) {
            (CardTask::List, Words::Hal { .. }) => "$F+".to_owned(),
            (CardTask::List, Words::Fluid) => FLUID_LIST.to_owned(),
            (CardTask::Delete(name), Words::Fluid) => {
                named(words, ["", "$SD/Delete="], name)?;
                FLUID_LIST.to_owned()
            }
            (CardTask::Show(name), _) => named(words, ["$F<=", "$SD/Show="], name)?,
            (CardTask::Delete(name), Words::Hal { .. }) => named(words, ["$FD=", ""], name)?,
            (CardTask::Run(name), _) => named(words, ["$F=", "$SD/Run="], name)?,
            (CardTask::Upload { name, content }, words) => {
                return self.begins_upload(words, name, content.clone()).map(Opening::Bytes);
            }
        };
        (self.answer, self.folders) = (CardAnswer::default(), Vec::new());
        self.fault = None;
        self.task = Some((task, line.clone()));
        Ok(Opening::Line(line))
    }

    fn begins_upload(
        &mut self,
        words: Words,
        name: &str,
        content: Vec<u8>,
    ) -> Result<Vec<u8>, String> {
        let name = name.trim_start_matches('/');
        takes_name(name, words)?;
        let (upload, first) = match words {
            Words::Hal { takes: false } => {
                return Err(TAKES_NO_FILES.into());
            }
            _ if content.is_empty() => return Err(format!("{name} is empty")),
            Words::Hal { takes: true } => (Upload::named(name, content), String::new()),
            Words::Fluid => {
                (Upload::bare(content), format!("$Xmodem/Receive={FLUID_CARD}{name}\n"))
            }
        };
        (self.upload, self.is_told) = (Some(upload), false);
        self.answer = CardAnswer::default();
        Ok(first.into_bytes())
    }

    /// Adds what goes out of a file on its way; tells whether there is one. A question would be a byte of it.
    pub(crate) fn speaks(&mut self, out: &mut Vec<u8>, now_s: f64) -> bool {
        let Some(upload) = &mut self.upload else { return false };
        out.retain(|byte| *byte != ASK);
        out.extend(upload.speak(now_s));
        let went = upload.went();
        let is_over = !matches!(went, Went::On(_));
        if !self.is_told && (is_over || !upload.is_left()) {
            self.news = Some(match went {
                Went::On(done) => CardNews::Going(done, upload.size()),
                Went::Well => CardNews::Done(CardAnswer::default()),
                Went::Wrong(why) => CardNews::Failed(why),
            });
        }
        if is_over {
            self.upload = None;
        }
        true
    }

    /// Takes a byte of the answers to a file that is on its way; tells whether one is.
    pub(crate) fn hears_byte(&mut self, byte: u8, now_s: f64) -> bool {
        self.upload.iter_mut().for_each(|upload| upload.hear(byte, now_s));
        self.uploads()
    }

    /// Gives up what is done; returns what ends it. A receiver of XMODEM answers that, and takes no line before.
    pub(crate) fn gives_up(&mut self, now_s: f64) -> Vec<u8> {
        self.task = None;
        let Some(upload) = &mut self.upload else { return Vec::new() };
        let why = "it was stopped";
        let end = upload.cancel(why, now_s);
        if !matches!(upload.went(), Went::On(_)) {
            self.upload = None;
        }
        (self.news, self.is_told) = (Some(CardNews::Failed(why.to_owned())), true);
        end
    }

    /// Takes a line that is about the card; tells whether it is.
    pub(crate) fn hears_line(&mut self, line: &str, told: &KnownFacts) -> bool {
        if let Some((number, place)) = refused_line(line) {
            let why = format!("line {place} of the file was refused: {}", told.error(number));
            if number == PASSED_OVER && !told.is_hal() {
                let passed = format!("{why}; the controller passed over it");
                self.news = Some(CardNews::Failed(passed));
            } else {
                self.fault = Some((number, why.clone()));
                self.news = Some(CardNews::Failed(why));
            }
            return true;
        }
        self.hears(line)
    }

    /// Returns its refusal of a line of the file that it ran, once.
    pub(crate) const fn takes_fault(&mut self) -> Option<(u16, String)> {
        self.fault.take()
    }

    /// The line of the task is answered; returns another one that belongs to it.
    pub(crate) fn answered(&mut self, line: &str, now_s: f64) -> Option<String> {
        let (task, _) = self.task.take_if(|(_, own)| own == line)?;
        match task {
            CardTask::Delete(name) if line == FLUID_LIST => {
                let bare = name.trim_start_matches('/');
                let files = std::mem::take(&mut self.answer.files);
                if files.iter().any(|file| file.name.eq_ignore_ascii_case(bare)) {
                    let line = format!("$SD/Delete=/{bare}");
                    self.task = Some((CardTask::Delete(name), line.clone()));
                    return Some(line);
                }
                let why = format!("there is no file {bare} on its card");
                self.news = Some(CardNews::Failed(why));
                return None;
            }
            CardTask::Run(name) => {
                let name = name.trim_start_matches('/').to_owned();
                self.job = Some(CardJob { name, ..CardJob::default() });
                self.begun_s = Some(now_s);
            }
            _ => {}
        }
        self.news = Some(CardNews::Done(std::mem::take(&mut self.answer)));
        None
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
            let not_mounted: &[u16] = if told.is_hal() { &NOT_MOUNTED } else { &NOT_MOUNTED_FLUID };
            let why = match not_mounted.contains(&number) {
                true => NO_CARD_IN.to_owned(),
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
                name: name.trim_start_matches(FLUID_CARD).trim_start_matches('/').to_owned(),
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

/// Reads the refusal of a line of a file: its number, and that of the line.
fn refused_line(line: &str) -> Option<(u16, &str)> {
    if let Some((why, place)) = line.split_once(" in SD file at line ") {
        return Some((why.strip_prefix("error:")?.parse().ok()?, place));
    }
    let (why, place) = line.strip_prefix("[MSG:ERR:")?.split_once(") in ")?;
    let (_, place) = place.strip_suffix(']')?.rsplit_once(" at line ")?;
    Some((why.trim_start().split(' ').next()?.parse().ok()?, place))
}

fn named(words: Words, [hal, fluid]: [&str; 2], name: &str) -> Result<String, String> {
    let bare = name.trim_start_matches('/');
    takes_name(bare, words)?;
    Ok(match words {
        Words::Hal { .. } => format!("{hal}/{bare}"),
        Words::Fluid => format!("{fluid}/{bare}"),
    })
}
