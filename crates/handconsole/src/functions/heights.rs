//! Functions of the heights of Z, and of the height that is controlled.

use super::moves::to_height;
use super::settings::{set, with};
use super::spec::Step::{Height, Number};
use super::spec::{Done, Function, Refusal, shown, to_millionth};
use crate::{ConsoleRequest, JobRequest, View};
use kerf_machine::Errand;
use kerf_program::{Axis, AxisSet};

/// Z is homed first where jobs home it, for heights count from there.
pub(super) const SETTING: Function = Function {
    number: "2",
    name: "Z settings",
    doc: "The tool goes to ZTop, ZSurface and ZBottom in turn; digits move it, Enter records where it stands. Z is homed \
         first where jobs home it. Nothing is set before the third. `zpos.*`",
    steps: &[
        Height {
            prompt: "ZTop: move, Enter",
            there: |view| {
                let homes = view.machine.homing.at_job_start.contains(Axis::Z);
                let home = homes.then_some(Errand::FindHome(AxisSet::EMPTY.with(Axis::Z)));
                home.into_iter().chain([to_height(view.machine.zpos.top_mm)]).collect()
            },
        },
        Height {
            prompt: "ZSurface: move,Enter",
            there: |view| vec![to_height(view.machine.zpos.surface_mm)],
        },
        Height {
            prompt: "ZBottom: move, Enter",
            there: |view| vec![to_height(view.machine.zpos.bottom_mm)],
        },
    ],
    does: |heights, view| {
        let keys = ["zpos.top_mm", "zpos.surface_mm", "zpos.bottom_mm"];
        let values =
            keys.into_iter().zip(heights).map(|(key, z)| (key, to_millionth(*z).to_string()));
        Ok(set(view, values.collect())?.into())
    },
};

pub(super) const BOTTOM_ADJUST: Function = Function {
    number: "3",
    name: "ZBottom adjust",
    doc: "ZBottom by a distance, negative down. `zpos.bottom_mm`",
    steps: &[Number { prompt: "ZBottom adjust mm:", now: |_| None }],
    does: |typed, view| lowered(view, typed[0]),
};

pub(super) const BOTTOM_JUSTIFY: Function = Function {
    number: "300",
    name: "ZBottom justify",
    doc: "As 3; then the 3D paths of the open job lie with their lowest place at ZBottom",
    steps: &[Number { prompt: "ZBottom adjust mm:", now: |_| Some(0.0) }],
    does: |typed, view| {
        let mut done = lowered(view, typed[0])?;
        done.requests.push(ConsoleRequest::Job(JobRequest::Justify));
        Ok(done)
    },
};

/// A function that moves set points of height control: shares of the distance that X and Y get.
macro_rules! adjusts {
    ($number:literal, $name:literal, $doc:literal, $prompt:literal, $shares:expr) => {
        Function {
            number: $number,
            name: $name,
            doc: $doc,
            steps: &[Number { prompt: $prompt, now: |_| None }],
            does: |typed, view| adjusted(view, $shares.map(|share: f64| share * typed[0])),
        }
    };
}

pub(super) const ADJUST: Function = adjusts!(
    "19",
    "XY adjust mm",
    "Both set points by a distance; held between 0 and 255, which is told",
    "Adjust x and y mm:",
    [1.0, 1.0]
);

pub(super) const ADJUST_X: Function =
    adjusts!("19.1", "X adjust mm", "That of X", "Adjust x mm:", [1.0, 0.0]);

pub(super) const ADJUST_Y: Function =
    adjusts!("19.2", "Y adjust mm", "That of Y", "Adjust y mm:", [0.0, 1.0]);

/// Z bottom by a distance.
fn lowered(view: &View, by_mm: f64) -> Result<Done, Refusal> {
    let bottom_mm = to_millionth(view.machine.zpos.bottom_mm + by_mm);
    let requests = with(view, &["zpos.bottom_mm"], bottom_mm)?;
    Ok(Done::from(requests).saying(format!("ZBottom {}", shown(bottom_mm))))
}

/// The set points by distances.
fn adjusted(view: &View, by_mm: [f64; 2]) -> Result<Done, Refusal> {
    let mut height = view.machine.height;
    let free = height.adjust(by_mm);
    let [x, y] = [height.x_set_point, height.y_set_point];
    let points = [("height.x_set_point", x), ("height.y_set_point", y)];
    let requests = set(view, points.map(|(key, point)| (key, point.to_string())).into())?;
    let held = if free { "" } else { " (limit)" };
    Ok(Done::from(requests).saying(format!("X {x} Y {y}{held}")))
}
