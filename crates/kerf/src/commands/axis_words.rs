//! Axes, ways and places as they are written on the command line.

use crate::exit::Usage;
use anyhow::{Result, bail};
use kerf_machine::Configuration;
use kerf_program::{AXES, Axis, AxisSet};

/// Axes that can be homed: those that are named, else all that have a switch.
pub fn axes_with_switch(c: &Configuration, letters: Option<&str>) -> Result<AxisSet> {
    let fitted = |axis: &Axis| c.homing.of(*axis).fitted;
    let all = Axis::ALL.into_iter().filter(fitted).fold(AxisSet::EMPTY, AxisSet::with);
    let axes = axes_named(c, letters, all)?;
    if axes.is_empty() {
        bail!("no axis of this machine has a home switch: nothing was homed (homing.x.fitted)");
    }
    match axes.iter().find(|axis| !all.contains(*axis)) {
        None => Ok(axes),
        Some(axis) => bail!(
            "axis {0} has no home switch: nothing was homed (homing.{0}.fitted)",
            c.motors.axis_name(axis)
        ),
    }
}

/// Axes by their letters.
pub fn axes_named(c: &Configuration, letters: Option<&str>, all: AxisSet) -> Result<AxisSet> {
    let Some(letters) = letters else { return Ok(all) };
    if letters.is_empty() {
        bail!(Usage("name axes by their letters, as xy".into()));
    }
    letters.chars().try_fold(AxisSet::EMPTY, |set, letter| Ok(set.with(named(c, letter)?)))
}

fn named(c: &Configuration, letter: char) -> Result<Axis> {
    let axis = c.motors.axis_called(letter);
    axis.ok_or_else(|| Usage(format!("there is no axis {letter}")).into())
}

/// `10,20,-5`; empty places stay.
pub fn numbers(text: &str) -> Result<[Option<f64>; AXES]> {
    let mut all = [None; AXES];
    for (i, word) in text.split(',').enumerate() {
        let Some(place) = all.get_mut(i) else { bail!(Usage("six axes at the most".into())) };
        if !word.trim().is_empty() {
            let number = word.trim().parse().ok().filter(|n: &f64| n.is_finite());
            *place = Some(number.ok_or_else(|| Usage(format!("'{word}' is no number")))?);
        }
    }
    Ok(all)
}

/// `10,20`: X and Y.
pub fn pair(text: &str) -> Result<[f64; 2]> {
    match numbers(text)? {
        [Some(x), Some(y), None, None, None, None] => Ok([x, y]),
        _ => bail!(Usage("give X,Y".into())),
    }
}

/// `x+`, `x+y-`: which way each axis goes.
pub fn ways(c: &Configuration, text: &str) -> Result<[i8; AXES]> {
    let mut all = [0; AXES];
    let letters: Vec<char> = text.chars().filter(|c| *c != ',').collect();
    let wrong = || Usage("an axis and + or -, as x+".into());
    for pair in letters.chunks(2) {
        let &[letter, sign] = pair else { bail!(wrong()) };
        let way = &mut all[named(c, letter)?.index()];
        if *way != 0 {
            bail!(Usage(format!("{letter} is named twice: an axis goes one way")));
        }
        *way = match sign {
            '+' => 1,
            '-' => -1,
            _ => bail!(wrong()),
        };
    }
    if letters.is_empty() { Err(wrong().into()) } else { Ok(all) }
}
