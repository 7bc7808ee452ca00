//! The machine's configuration: the form of all settings, and a change of one.

use crate::clock::Clock;
use crate::handconsole::Happening;
use crate::hub::Hub;
use crate::last_runs::now_s;
use crate::locks::lock;
use crate::machine::{LastState, Order};
use crate::orders::Orders;
use crate::people::Tries;
use crate::protect::Unlocked;
use crate::refusal::problem;
use crate::setting_changes::SettingChanges;
use kerf_control::Session;
use kerf_machine::contradictions::contradictions;
use kerf_machine::table::{self, Area, Bounds, Setting, Unit};
use kerf_machine::value::NONE;
use kerf_machine::{Configuration, Value};
use kerf_program::{AXES, Axis, AxisSet};
use kerf_wire::{
    Problem, SettingArea, SettingChange, SettingEntry, SettingKind, Setup, Who, Why, ZHeights,
};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

/// Time that whoever changes a setting waits for the disk.
const ON_DISK_WITHIN: Duration = Duration::from_secs(10);

/// The setting that holds the password's hash: no page sees it, and only [`MachineSettings::protect`] changes it.
pub const PASSWORD: &str = "options.password";

/// Every setting that says something on this machine, with what it is now.
pub fn form(configuration: &Configuration) -> Vec<SettingArea> {
    let shown = |it: &&Setting| it.key != PASSWORD;
    let area = |area: &Area| SettingArea {
        title: area.title.into(),
        manual: area.manual.into(),
        settings: area
            .shown(configuration)
            .filter(shown)
            .map(|row| entry(row, configuration))
            .collect(),
    };
    table::areas().map(area).collect()
}

/// Returns the settings that pages follow which work on drawings.
pub fn setup(session: &Session) -> Setup {
    let configuration = &session.configuration();
    let letters = |axes: AxisSet| axes.iter().map(Axis::letter).collect();
    let (zpos, options) = (&configuration.zpos, &configuration.options);
    let length = configuration.axes.length.0;
    Setup {
        heights: ZHeights { top: zpos.top_mm, surface: zpos.surface_mm, bottom: zpos.bottom_mm },
        reach: [length[0], length[1]],
        protected: options.password.is_some(),
        outputs_stay_on: configuration.misc.outputs_stay_on,
        pick_radius: options.pick_radius_px,
        window_expansion: options.window_expansion_percent,
        homed: letters(session.homed),
        not_homed: letters(session.not_homed(configuration)),
    }
}

fn entry(setting: &Setting, configuration: &Configuration) -> SettingEntry {
    let (least, most) = match setting.bounds {
        Bounds::NotNegative => (Some(0.0), None),
        Bounds::Range(least, most) => (Some(least), Some(most)),
        Bounds::RangeOrNone(_, most) => (Some(0.0), Some(most)),
        Bounds::OneOf(values) => (values.first().copied(), values.last().copied()),
        Bounds::Any | Bounds::Positive | Bounds::PositiveOrInfinite => (None, None),
    };
    let bound = match setting.bounds {
        Bounds::Any => String::new(),
        bounds => bounds.to_string(),
    };
    SettingEntry {
        key: setting.key.into(),
        kind: kind(setting),
        unit: setting.unit.symbol().into(),
        bound,
        least,
        most,
        default: written(&setting.default()),
        value: written(&setting.get(configuration)),
        doc: setting.doc.into(),
    }
}

fn kind(setting: &Setting) -> SettingKind {
    let words = setting.words();
    let none = words.contains(&NONE);
    match setting.default() {
        Value::Flag(_) => SettingKind::Flag,
        Value::Number(_) => SettingKind::Number { none },
        Value::List(values) => SettingKind::List { length: values.len() as u32, none },
        Value::Text(_) if words.is_empty() => SettingKind::Text,
        Value::Text(_) if words == [NONE] && is_of_axes(setting) => {
            SettingKind::List { length: AXES as u32, none }
        }
        // Absent at first: a number, unless there are other words.
        Value::Text(_) if words == [NONE] => SettingKind::Number { none },
        Value::Text(_) => {
            SettingKind::Choice { words: words.into_iter().map(str::to_owned).collect() }
        }
    }
}

/// Returns `true` if a setting has a value for each axis.
const fn is_of_axes(setting: &Setting) -> bool {
    matches!(setting.unit, Unit::AxisSpeed | Unit::AxisAccel | Unit::AxisJerk)
}

/// A value as a person types it.
/// The change of a setting between two configurations, now.
fn change_of(setting: &Setting, before: &Configuration, after: &Configuration) -> SettingChange {
    SettingChange {
        at: now_s(),
        key: setting.key.into(),
        from: written(&setting.get(before)),
        to: written(&setting.get(after)),
        by: String::new(),
        through: String::new(),
    }
}

/// The changes that a typed line or a part file made, by whose hands it ran.
pub fn changes_through(
    through: &str,
    by: &str,
    [before, after]: [&Configuration; 2],
) -> Vec<SettingChange> {
    let made = |setting| SettingChange {
        by: by.into(),
        through: through.into(),
        ..change_of(setting, before, after)
    };
    let shown = |change: &SettingChange| change.key != PASSWORD && change.from != change.to;
    table::changed(before, after).map(made).filter(shown).collect()
}

fn written(value: &Value) -> String {
    match value {
        Value::Text(text) => text.clone(),
        other => other.to_string().replace('"', ""),
    }
}

/// The settings of the machine, and who may change them.
pub struct MachineSettings {
    pub hub: Arc<Hub>,
    pub left: Arc<Mutex<LastState>>,
    pub orders: Arc<Orders>,
    pub clock: Clock,
    /// Pages and scripts that gave the password.
    pub unlocked: Unlocked,
    /// Wrong passwords, by the device that they came from. It is held while one is tried: one at a time.
    pub passwords: Mutex<Tries<String>>,
    /// The changes made so far.
    pub changes: Arc<SettingChanges>,
}

impl MachineSettings {
    /// Changes a setting, and comes back when it is on the disk.
    ///
    /// # Errors
    /// There is no such setting, it does not accept the value, it would contradict another, or it cannot be kept.
    pub fn configure(&self, by: &Who, key: &str, value: &str) -> Result<(), Problem> {
        let mut wanted = lock(&self.left).session.configuration();
        let before = wanted.clone();
        let setting = set(&mut wanted, key, value)?;
        check(&wanted)?;
        let change = change_of(setting, &before, &wanted);
        let change = SettingChange { by: by.device.clone(), ..change };
        let change = Some(change).filter(|change| change.from != change.to);
        self.keep_on_disk(setting, wanted, change)
    }

    /// Has another configuration, of which this setting is new, and comes back when that is on the disk, and the change
    /// in the history.
    ///
    /// # Errors
    /// The machine is busy, or the setting cannot be kept.
    pub fn keep_on_disk(
        &self,
        setting: &'static Setting,
        wanted: Configuration,
        change: Option<SettingChange>,
    ) -> Result<(), Problem> {
        let (tells, told) = channel();
        let wanted = Box::new(wanted);
        self.orders.order(Order::Configure { setting, wanted, change, tells })?;
        match told.recv_timeout(ON_DISK_WITHIN) {
            Ok(kept) => kept.map_err(|why| problem(Why::Server, why)),
            Err(_) => {
                let within = ON_DISK_WITHIN.as_secs();
                let text = format!(
                    "{} is not on the disk after {within} s: look at the disk, and whether the setting is as you want it",
                    setting.key
                );
                Err(problem(Why::Server, text))
            }
        }
    }

    /// Changes settings until Kerf ends, all of them or none; somebody is told when they hold.
    ///
    /// # Errors
    /// As [`MachineSettings::configure`].
    pub fn hold(
        &self,
        settings: &[(&str, String)],
        tells: &Sender<Happening>,
    ) -> Result<(), Problem> {
        let mut wanted = lock(&self.left).session.configuration();
        for (key, value) in settings {
            set(&mut wanted, key, value)?;
        }
        check(&wanted)?;
        let order = Order::Hold { wanted: Box::new(wanted), tells: tells.clone() };
        self.orders.order(order)
    }

    /// The joining distance used last is the one offered next, also after a restart. Where the machine is
    /// at work, or a password protects the settings, it is offered until then.
    pub fn keep_join(&self, join_mm: f64) {
        let mut wanted = lock(&self.left).session.configuration();
        if wanted.options.password.is_some() {
            return;
        }
        let Some(setting) = table::setting("options.join_mm") else { return };
        if setting.set(&mut wanted, &Value::Number(join_mm)).is_ok() {
            let (tells, _) = channel();
            let wanted = Box::new(wanted);
            let order = Order::Configure { setting, wanted, change: None, tells };
            drop(self.orders.order(order));
        }
    }
}

/// Gives a setting of a configuration a value as a person writes it.
fn set(
    configuration: &mut Configuration,
    key: &str,
    value: &str,
) -> Result<&'static Setting, Problem> {
    let known = table::setting(key).filter(|setting| setting.key != PASSWORD);
    let setting = known.ok_or_else(|| {
        let keys = table::settings().map(|setting| setting.key);
        let hint = kerf_diag::did_you_mean(key, keys).unwrap_or_default();
        problem(Why::Mistake, format!("there is no setting {key}; {hint}"))
    })?;
    let value = match setting.default() {
        // A text may look like a number or a list.
        Value::Text(_) if setting.words().is_empty() => Value::Text(value.into()),
        _ => Value::typed(value),
    };
    let done = setting.set(configuration, &value).map(|()| setting);
    done.map_err(|refused| problem(Why::Mistake, refused.to_string()))
}

fn check(wanted: &Configuration) -> Result<(), Problem> {
    match contradictions(wanted).first() {
        Some(crossed) => {
            Err(problem(Why::Mistake, format!("{}; {}", crossed.message, crossed.hint)))
        }
        None => Ok(()),
    }
}
