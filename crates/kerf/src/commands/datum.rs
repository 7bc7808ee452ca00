//! `kerf machine zset` and `origin`: special heights and the job origin, kept in the machine's file.

use super::axis_words::numbers;
use super::shop::{Shop, not_beside_a_server};
use super::which::Which;
use crate::exit::{Exit, Usage};
use crate::out;
use anyhow::{Result, bail};
use kerf_machine::{Configuration, Errand, Value, file, table};
use kerf_program::{AXES, Axis, AxisSet, rounded};
use std::sync::Arc;

/// A special height.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum SpecialHeight {
    Top,
    Surface,
    Bottom,
}

impl SpecialHeight {
    const fn key(self) -> &'static str {
        match self {
            Self::Top => "zpos.top_mm",
            Self::Surface => "zpos.surface_mm",
            Self::Bottom => "zpos.bottom_mm",
        }
    }
}

/// Records where Z is as one of its special heights, or puts the height by a distance.
pub fn zset(
    which: &Which,
    height: SpecialHeight,
    to: Option<f64>,
    by: Option<f64>,
) -> Result<Exit> {
    not_beside_a_server(which, "set Z top, surface or bottom on its page Job")?;
    let mut shop = Shop::open(which, false)?;
    let setting = table::setting(height.key());
    let Some(setting) = setting else { bail!("no setting {}", height.key()) };
    if by.is_none() {
        let z = to.unwrap_or(shop.session.memory.position[Axis::Z]);
        changed(&shop.machine, setting, &Value::Number(rounded(z, 6)))?;
        let exit = drive_there(&mut shop, height, to)?;
        if exit != Exit::Good {
            return Ok(exit);
        }
    }
    let before = setting.get(&shop.machine);
    let z = match (by, before) {
        (Some(by), Value::Number(before)) => before + by,
        _ => shop.session.memory.position[Axis::Z],
    };
    keep(which, &shop.machine, setting, Value::Number(rounded(z, 6)))
}

/// Changes a setting in the file of the machine, and tells it.
fn keep(
    which: &Which,
    machine: &Configuration,
    setting: &'static table::Setting,
    value: Value,
) -> Result<Exit> {
    let kept = which.to_change()?;
    let _alone = kept.alone();
    let text = kept.text()?.unwrap_or_default();
    let wanted = changed(machine, setting, &value)?;
    kept.write(&file::edit(&text, setting, &wanted))?;
    out::print(&format!("{} = {}\n", setting.key, setting.get(&wanted)));
    Ok(Exit::Good)
}

/// The machine with another value of a setting.
///
/// # Errors
/// The value is none of the setting, or contradicts another one.
fn changed(
    machine: &Configuration,
    setting: &'static table::Setting,
    value: &Value,
) -> Result<Configuration> {
    let mut wanted = machine.clone();
    setting.set(&mut wanted, value).map_err(|refused| Usage(refused.to_string()))?;
    if let Some(crossed) = kerf_machine::contradictions::contradictions(&wanted).first() {
        bail!(Usage(format!("{}; {}", crossed.message, crossed.hint)));
    }
    Ok(wanted)
}

/// Prints the job origin, or sets it: to where the tool is, or to a place from home.
pub fn origin(which: &Which, place: Option<&str>) -> Result<Exit> {
    let shop = Shop::open(which, false)?;
    let Some(setting) = table::setting("job.origin_mm") else { bail!("no setting job.origin_mm") };
    if place.is_some() {
        not_beside_a_server(which, "set the origin on its page Job")?;
    }
    let at = match place {
        None => {
            out::print(&format!("{} = {}\n", setting.key, setting.get(&shop.machine)));
            return Ok(Exit::Good);
        }
        Some("here") => {
            shop.stands_for_sure()?;
            let position = shop.session.memory.position;
            [position[Axis::X], position[Axis::Y]]
        }
        Some(place) => {
            let [Some(x), Some(y), None, None, None, None] = numbers(place)? else {
                bail!(Usage("give X,Y or here".into()))
            };
            [x, y]
        }
    };
    let value = Value::List(at.map(|v| Value::Number(rounded(v, 6))).into());
    keep(which, &shop.machine, setting, value)
}

/// Z is homed first where jobs home it; then it goes to the height that is to be recorded.
fn drive_there(shop: &mut Shop, height: SpecialHeight, to: Option<f64>) -> Result<Exit> {
    let stood = shop.session.memory.position[Axis::Z];
    let homes = shop.machine.homing.at_job_start.contains(Axis::Z);
    let mut shift = 0.0;
    if homes {
        let exit = shop.errand(Errand::FindHome(AxisSet::EMPTY.with(Axis::Z)), Vec::new())?;
        if exit != Exit::Good {
            return Ok(exit);
        }
        shift = stood;
    }
    let Some(z) = to.or(homes.then_some(shift)) else { return Ok(Exit::Good) };
    let mut free = (*shop.machine).clone();
    if height == SpecialHeight::Bottom {
        // It is being set: it does not bound the way.
        free.zpos.bottom_mm = free.zpos.bottom_mm.min(z);
    }
    let machine = std::mem::replace(&mut shop.machine, Arc::new(free));
    let mut place = [None; AXES];
    place[Axis::Z.index()] = Some(z);
    let exit = shop.errand(Errand::To { place, relative: false, flat: false }, Vec::new());
    shop.machine = machine;
    exit
}
