//! What the owner of the machine does besides moving it: its files, recorder, switches, configuration.

use super::owner::Owner;
use crate::setup::Workshop;
use crate::told;
use kerf_control::Press;
use kerf_machine::Configuration;
use kerf_machine::table::Setting;
use kerf_wire::{Change, Folder, NamedValue, Recorder, State, Tone};
use std::path::Path;

impl Owner {
    /// Moves a switch of the machine, which stands.
    pub(super) fn press(&mut self, press: Press) {
        self.workshop.session.press(press);
        self.rest(State::Idle, None);
    }

    /// Chooses the part folder.
    pub(super) fn enter(&mut self, path: &Path, mask: Option<&str>) {
        let shelf = &mut self.workshop.shelf;
        if let Err(error) = shelf.enter(Some(&path.display().to_string())) {
            self.hub.say(Tone::Error, format!("{} cannot be used: {error:?}", path.display()));
        } else if mask.is_some() {
            shelf.set_mask(mask);
        }
        self.rest(State::Idle, None);
    }

    /// Puts a line at the end of the recorder's list.
    pub(super) fn record(&mut self, line: &str) {
        self.workshop.shelf.record(line);
    }

    /// Has another configuration from now on, and keeps what is new of it.
    pub(super) fn configure(&mut self, setting: &'static Setting, wanted: Configuration) {
        let Workshop { session, shelf, .. } = &mut self.workshop;
        let told = session.configure(setting, wanted, shelf);
        if let Err(why) = told {
            let text = format!("{} holds until Kerf ends, it cannot be kept: {why}", setting.key);
            self.hub.say(Tone::Warning, text);
        }
        self.rest(State::Idle, None);
    }

    /// Tells what the shelf holds: recorder, folder, watched variables; and that settings are others.
    pub(super) fn tell_shelf(&mut self) {
        let shelf = &mut self.workshop.shelf;
        let (on, lines) = shelf.recorder();
        let recorder = Recorder { on, lines };
        let name = self.parts.name_of(&shelf.part_folder().display().to_string());
        let folder = Folder { name, mask: shelf.mask().to_owned() };
        let watched = self.watched();
        let setup = crate::configure::setup(&self.workshop.session.configuration());
        let other = {
            let (before, now) = (&crate::app::lock(&self.left).session, &self.workshop.session);
            before.memory.settings != now.memory.settings || before.machine_is != now.machine_is
        };
        self.hub.changing(|now| {
            let mut changes = Vec::new();
            let mut put = |differs: bool, change: Change| changes.extend(differs.then_some(change));
            put(now.recorder != recorder, Change::Recorder { recorder });
            put(now.folder != folder, Change::Folder { folder });
            put(now.watched != watched, Change::Watched { watched });
            put(now.setup != setup, Change::Setup { setup });
            put(other, Change::Settings { settings: now.settings.wrapping_add(1) });
            changes
        });
    }

    /// The watched variables as the last run left them.
    fn watched(&self) -> Vec<NamedValue> {
        let Workshop { session, shelf, .. } = &self.workshop;
        let value = |name: &String| {
            let variable = session.memory.variables.get(name.trim_start_matches('&'));
            let kept = || shelf.stored.get(name).map(str::to_owned);
            let value = variable.map(kerf_sbp::Value::display).or_else(kept)?;
            Some((name.clone(), value))
        };
        told::named(self.link.watched().iter().filter_map(value))
    }
}
