//! Random jobs on random machines: routers, lasers, plasma tables, knives.

use crate::simulated::dice::Dice;
use kerf_geom::{Point2, Polyarc, Vertex};
use kerf_ledger::jobs::{job, sim};
use kerf_machine::Configuration;
use kerf_machine::settings::delays::BottomDelayType;
use kerf_machine::settings::height::HeightMode;
use kerf_machine::settings::laser::LaserType;
use kerf_program::job::{CutDepth, Job, JobShape, Plunge};

fn point(dice: &mut Dice) -> Point2 {
    Point2::new(dice.between(0.0, 400.0), dice.between(0.0, 300.0))
}

fn path(dice: &mut Dice) -> Polyarc {
    let at = point(dice);
    if dice.in_percent(25) {
        let side = dice.between(5.0, 80.0);
        return Polyarc::rectangle(at, Point2::new(at.x + side, at.y + side));
    }
    let count = 2 + dice.below(5);
    let near = |dice: &mut Dice| {
        let (dx, dy) = (dice.between(1.0, 60.0), dice.between(1.0, 60.0));
        Point2::new(at.x + dx, at.y + dy)
    };
    let bulges = dice.in_percent(40);
    let mut vertices: Vec<Vertex> = (0..count)
        .map(|_| {
            let bulge = if bulges { dice.between(-0.9, 0.9) } else { 0.0 };
            Vertex { at: near(dice), bulge }
        })
        .collect();
    vertices.insert(0, Vertex { at, bulge: 0.0 });
    Polyarc { vertices, closed: dice.in_percent(50) }
}

fn shape(dice: &mut Dice, number: u32) -> JobShape {
    let path = path(dice);
    let mut shape = JobShape::through(number, path);
    match dice.below(8) {
        0 => {
            let pass_mm = dice.in_percent(60).then(|| dice.between(1.0, 4.0));
            (shape.height, shape.pass_mm) = (CutDepth::Mm(dice.between(-9.0, -1.0)), pass_mm);
        }
        1 => {
            shape.height = CutDepth::ThreeD;
            let count = shape.path.vertices.len();
            shape.z_mm = (0..count).map(|_| dice.between(-9.0, 3.0)).collect();
        }
        2 => {
            (shape.height, shape.pass_mm) = (CutDepth::Mm(-3.0), Some(1.5));
            shape.plunge = Plunge::Ramp { angle_deg: dice.between(3.0, 20.0) };
        }
        _ => {}
    }
    shape.tool = 1 + dice.below(3) as u8;
    shape.cut = 1 + dice.below(3) as u8;
    shape.speed_mm_s = dice.in_percent(30).then(|| dice.between(5.0, 150.0));
    shape.pause = dice.in_percent(8);
    shape.traversal = dice.in_percent(5);
    shape.group = dice.of(&["black", "red", "blue"]).into();
    shape
}

/// A job, sometimes one that does not fit on the table.
pub fn random(dice: &mut Dice) -> Job {
    let count = 1 + dice.below(5) as u32;
    let shapes: Vec<JobShape> = (1..=count).map(|n| shape(dice, n)).collect();
    let far = if dice.in_percent(4) { 2400.0 } else { 500.0 };
    Job {
        origin: Some(Point2::new(dice.between(0.0, far), dice.between(0.0, 500.0))),
        finish: Some(point(dice)),
        start: 1 + dice.below(count as usize),
        repeats: dice.of(&[1, 1, 1, 2]),
        ..job(shapes)
    }
}

/// A machine that cuts it.
pub fn machine(dice: &mut Dice) -> Configuration {
    let mut machine = sim();
    machine.axes.limit_movement = true;
    machine.pause.raise = dice.in_percent(70);
    machine.delays.bottom_s = dice.of(&[0.0, 0.2, 1.0]);
    machine.delays.air_tool_s = dice.of(&[0.0, 0.5]);
    machine.misc.double_start = dice.in_percent(10);
    machine.job.change_origin_at_start = dice.in_percent(10);
    match dice.below(8) {
        0 | 1 => {
            machine.intensity.output = true;
            machine.laser.use_laser = true;
            machine.laser.kind = Some(dice.of(&[LaserType::Continuous, LaserType::Pulsed]));
            machine.laser.pierce.use_sequence = dice.in_percent(60);
            machine.laser.pierce.time_ms = 200.0;
            machine.laser.pierce.intensity = 90;
            machine.laser.pierce.gas_tool = dice.of(&[None, Some(3)]);
        }
        2 => machine.plasma.use_sequence = true,
        3 => machine.misc.tangential = true,
        4 => {
            machine.height.on = true;
            machine.height.mode = HeightMode::Proportional;
            machine.height.k = 9.5;
            machine.height.activation_percent = dice.of(&[0.0, 50.0]);
        }
        5 => machine.delays.bottom_type = BottomDelayType::Input,
        _ => {}
    }
    machine
}
