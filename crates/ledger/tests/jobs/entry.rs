//! Ways down that are not as they were asked for are told, each once, before anything moves.

use kerf_ledger::jobs::{JobRun, job, line, square};
use kerf_machine::settings::height::HeightMode;
use kerf_machine::settings::laser::LaserType;
use kerf_program::job::{CutDepth, Job, JobShape, Plunge};
use kerf_sim::Sheet;
use kerf_trace::Event;

const RAMP: Plunge = Plunge::Ramp { angle_deg: 3.0 };
const HELIX: Plunge = Plunge::Helix { radius_mm: 2.0, angle_deg: 3.0 };

fn entered(shape: JobShape, group: &str, plunge: Plunge) -> JobShape {
    JobShape { group: group.into(), plunge, ..shape }
}

/// A line with a ramp, one more of its group, a square with a helix, and one that is entered straight down.
fn plate() -> Job {
    job([
        entered(line(1, (0., 10.), (100., 10.)), "black", RAMP),
        entered(line(2, (0., 20.), (100., 20.)), "black", RAMP),
        entered(square(3, (20., 40.), 30.), "red", HELIX),
        line(4, (0., 90.), (100., 90.)),
    ])
}

/// Warnings of a run, each with the number of the shape in front.
fn told(run: JobRun) -> Vec<String> {
    let trace = run.run();
    let first_move = trace.events.iter().position(|event| matches!(event, Event::Move(_)));
    let told = |(at, event): (usize, &Event)| match event {
        Event::Diag(told) => {
            assert!(Some(at) < first_move, "{} is told too late", told.message);
            Some(format!("{}: {}", told.place.line, told.message))
        }
        _ => None,
    };
    trace.events.iter().enumerate().filter_map(told).collect()
}

fn straight(why: &str) -> [String; 2] {
    [("1: group black", "ramp"), ("3: group red", "helix")].map(|(shape, asked)| {
        format!("{shape}: the tool goes straight down, without its {asked}: {why}")
    })
}

#[test]
fn nothing_is_told_of_ways_down_that_are_as_asked() {
    assert_eq!(told(JobRun::new(plate())), Vec::<String>::new());
}

#[test]
fn height_control_takes_no_ramp_and_says_so() {
    let run = || {
        JobRun::new(plate()).sheet(Sheet::flat(-20.0)).with(|machine| {
            (machine.height.on, machine.height.mode) = (true, HeightMode::Proportional);
            machine.height.k = 9.5;
        })
    };
    assert_eq!(told(run()), straight("height control follows the sheet"));
    // It follows THRU shapes only.
    let shallow = |job: &mut Job| {
        let height = CutDepth::Mm(-3.0);
        job.shapes = job.shapes.iter().map(|s| JobShape { height, ..s.clone() }).collect();
    };
    assert_eq!(told(run().job(shallow)), Vec::<String>::new());
}

#[test]
fn a_laser_that_pierces_takes_no_ramp_and_says_so() {
    let run = JobRun::new(plate()).with(|machine| {
        let laser = &mut machine.laser;
        (laser.use_laser, laser.kind) = (true, Some(LaserType::Pulsed));
        (laser.cut_hz, laser.max_pulse_us) = (5000.0, 1e6);
        (laser.pierce.use_sequence, laser.pierce.hz) = (true, 500.0);
    });
    assert_eq!(told(run), straight("the laser pierces"));
}

#[test]
fn a_plasma_torch_takes_no_ramp_and_says_so() {
    let run = JobRun::new(plate())
        .sheet(Sheet::flat(-20.0))
        .with(|machine| machine.plasma.use_sequence = true);
    assert_eq!(told(run), straight("the plasma torch starts above the sheet"));
}

#[test]
fn a_ramp_too_flat_for_its_path_is_told_with_the_angle_it_gets() {
    // 10 mm down on 2,000 times 10 mm are 0.02865 degrees.
    let flat = Plunge::Ramp { angle_deg: 0.02 };
    let shapes = [
        entered(line(1, (0., 0.), (10., 0.)), "black", flat),
        entered(line(2, (0., 20.), (10., 20.)), "black", flat),
        entered(line(3, (0., 30.), (15., 30.)), "black", flat),
    ];
    let why = "at 0.02 degrees it would go down in more than 1000 rounds: it goes down at 0.0287 degrees instead";
    assert_eq!(told(JobRun::new(job(shapes.clone()))), [format!("1: group black: {why}")]);
    let steeper = shapes.map(|shape| entered(shape, "black", Plunge::Ramp { angle_deg: 0.0287 }));
    assert_eq!(told(JobRun::new(job(steeper))), Vec::<String>::new());
}

#[test]
fn a_job_that_is_offset_tells_which_helices_it_loses() {
    let offset = kerf_toolpath::offset_job(&plate(), 1.0).expect("room");
    let why = "beside its paths nobody knows the room for a helix: the tool goes down along them instead, as steeply";
    assert_eq!(told(JobRun::new(offset)), [format!("3: group red: {why}")]);
    let same = kerf_toolpath::offset_job(&plate(), 0.0).expect("the same");
    assert_eq!(told(JobRun::new(same)), Vec::<String>::new());
}
