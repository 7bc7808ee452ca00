//! The card of the fake in the words of `FluidNC`: `$SD/…`, `$Xmodem/Receive=`, folders told before their files.

use super::card::Card;
use super::xmodem::{End, Xmodem};
use std::collections::BTreeSet;

/// Its refusals: it moves, no card can be mounted, a file cannot be opened, a file did not come whole.
const BUSY: u16 = 8;
const NO_CARD: u16 = 60;
const NO_FILE: u16 = 66;
const UPLOAD_FAILED: u16 = 160;

/// A line of a file that it refuses so is passed over; any other refusal ends the file.
const PASSED_OVER: &str = "20";

fn error(number: u16, why: &str) -> Vec<String> {
    vec![format!("[MSG:ERR: {why}]"), format!("error:{number}")]
}

impl Card {
    /// Carries out a command about the card; returns the lines that it answers, or nothing where it is no such command.
    pub(super) fn fluid_command(&mut self, command: &str, stands: bool) -> Option<Vec<String>> {
        let (word, path) = command.split_once('=').unwrap_or((command, ""));
        let bare = path.trim_start_matches('/');
        let name = bare.strip_prefix("sd/").unwrap_or(bare).to_owned();
        match word {
            "SD/List" | "SD/Show" | "SD/Delete" | "SD/Run" if self.is_out => {
                return Some(error(NO_CARD, "Failed to mount SD card"));
            }
            "Xmodem/Receive" => return Some(self.receives(&name)),
            "SD/List" | "SD/Show" | "SD/Delete" | "SD/Run" => {}
            _ => return None,
        }
        let told: Vec<String> = match (word, self.files.get(&name)) {
            ("SD/List", _) => self.listed(),
            // What is not there is deleted well, and a folder with all that is in it.
            ("SD/Delete", _) => {
                let folder = format!("{name}/");
                self.files.retain(|known, _| *known != name && !known.starts_with(&folder));
                Vec::new()
            }
            (_, None) => return Some(error(NO_FILE, "File operation failed")),
            ("SD/Show" | "SD/Run", _) if !stands => {
                return Some(error(BUSY, "Command requires idle state"));
            }
            ("SD/Show", Some(it)) => {
                String::from_utf8_lossy(it).lines().map(str::to_owned).collect()
            }
            _ => Vec::new(),
        };
        Some(told.into_iter().chain(["ok".to_owned()]).collect())
    }

    /// Every folder before what is in it, each behind a blank for each folder that it lies in, files behind one more.
    fn listed(&self) -> Vec<String> {
        let (mut lines, mut known) = (Vec::new(), BTreeSet::new());
        for (name, content) in &self.files {
            let parts: Vec<&str> = name.split('/').collect();
            let folders = &parts[..parts.len() - 1];
            for (depth, folder) in folders.iter().enumerate() {
                if known.insert(folders[..=depth].join("/")) {
                    lines.push(format!("[DIR:{}{folder}]", " ".repeat(depth)));
                }
            }
            let (blanks, last) = (" ".repeat(folders.len()), parts[folders.len()]);
            lines.push(format!("[FILE: {blanks}{last}|SIZE:{}]", content.len()));
        }
        lines.push("[/sd/ Free:29.70 GB Used:1.25 MB Total:29.71 GB]".to_owned());
        lines
    }

    fn receives(&mut self, name: &str) -> Vec<String> {
        let folder = name.rsplit_once('/').map(|(folder, _)| format!("{folder}/"));
        let has_folder = |folder: &String| self.files.keys().any(|known| known.starts_with(folder));
        if self.is_out || folder.is_some_and(|folder| !has_folder(&folder)) {
            let lines = [format!("\u{18}[MSG:INFO: Cannot open /sd/{name}]")];
            return lines.into_iter().chain([format!("error:{UPLOAD_FAILED}")]).collect();
        }
        self.xmodem = Some(Xmodem::new(name.to_owned()));
        Vec::new()
    }

    /// Returns `true` while a file comes by XMODEM.
    pub const fn takes_by_xmodem(&self) -> bool {
        self.xmodem.is_some()
    }

    /// Returns what it says while a file comes, and when it has come.
    pub(super) fn takes_file(&mut self, now_s: f64) -> Vec<u8> {
        let Some(file) = &mut self.xmodem else { return Vec::new() };
        file.room = self.room;
        let faults = [&mut self.spoils, &mut self.loses, &mut self.mutes];
        let (mut said, end) = file.speak(now_s, faults);
        let Some(end) = end else { return said };
        let words = match end {
            End::Whole => {
                let told =
                    format!("Received {} bytes to file /sd/{}", file.content.len(), file.name);
                self.files.insert(file.name.clone(), file.content.clone());
                told
            }
            End::Full => {
                "Reception failed: not enough free space on the target filesystem".to_owned()
            }
            End::GivenUp => "Reception failed or was canceled".to_owned(),
        };
        let answer = if end == End::Whole { "ok" } else { "error:160" };
        said.extend(format!("[MSG:INFO: {words}]\r\n{answer}\r\n").bytes());
        self.xmodem = None;
        said
    }

    /// Tells the refusal of a line of the file that runs: to all, and to whoever has begun it.
    pub(super) fn fluid_refusal(&mut self, number: &str) -> String {
        let (line, name) = self.line();
        let why = format!("[MSG:ERR: {number} (Refused) in /sd/{name} at line {line}]\r\n");
        if number == PASSED_OVER {
            return why;
        }
        self.ends();
        why.repeat(2)
    }
}
