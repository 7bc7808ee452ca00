//! Outputs of a board with step queues at their places in the motion, in simulated time: on and off (M62 … M65), and
//! with a share of time (M67, M68).

use crate::queued::{Shop, World, machine_of};
use kerf_control::{RunContext, Session};
use kerf_driver_klipper::fake::Faults;
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::{Driven, Machine};
use kerf_trace::{Event, Sink};
use kerf_workspace::Workspace;
use std::cell::RefCell;
use std::rc::Rc;

const FILE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n\
    [board]\nx = \"gpio0 gpio1\"\ny = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\noutputs = \"2 gpio20\"\n\
    pwm = \"1 gpio21, 2 !gpio22\"\npwm_hz = 5000\nboth_edges = true\npulse_us = 0.1";

/// Ticks of the board in a microsecond.
const TICKS_PER_US: u64 = 12;

struct Quiet;

impl Sink for Quiet {
    fn event(&mut self, _: &Event) {}
}

/// Runs G-code on a board; its world, and its fault.
fn ran(seed: u64, faults: Faults, lines: &str) -> (Rc<RefCell<World>>, Option<String>) {
    let shop = Shop::of(&machine_of(FILE), seed, faults, |_| {});
    let world = shop.world.clone();
    let mut session = Session::default();
    session.hold(machine_of(FILE));
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let program = kerf_part::read("part.nc".into(), lines.as_bytes());
    let queued = Rc::new(RefCell::new(shop.queued));
    let driven: Driven = queued.clone();
    let context = RunContext {
        sink: &mut Quiet,
        operator: &mut (),
        requests: &mut (),
        machine: driven.into(),
    };
    session.run(program, RunOptions::default(), &mut workspace, context);
    queued.borrow_mut().close(true, || false);
    let fault = queued.borrow().fault().map(|fault| fault.message.clone());
    (world, fault)
}

/// Changes of an output, each with its clock: repetitions of what stands are left out.
fn changes(world: &World, output: usize) -> Vec<(u64, u32)> {
    let made = &world.fake.outputs.values().nth(output).unwrap().made;
    let mut changes: Vec<(u64, u32)> = made.clone();
    changes.dedup_by_key(|(_, value)| *value);
    changes
}

/// The clock in the middle between the steps of X before and behind a place, mm.
fn passes(world: &World, x_mm: f64) -> u64 {
    let made = &world.fake.steppers[&0].made;
    let nth = (x_mm * 100.0) as usize;
    u64::midpoint(made[nth - 1].0, made[nth].0)
}

#[test]
fn outputs_change_within_ten_microseconds_of_their_place() {
    let lines = "G21 G90 G64\nG1 X20 F3000\nM67 E0 Q40\nM62 P1\nG1 X40\nM67 E0 Q80\nM67 E1 Q25\nG1 X60\nM63 P1\n\
                 M68 E0 Q0\nG1 X80\nM2\n";
    for (seed, faults) in [(1, Faults::default()), (2, Faults::all(0.01 / 6.0))] {
        let (world, fault) = ran(seed, faults, lines);
        assert_eq!(fault, None);
        let world = world.borrow();
        // On and off, then the channels; the second has its level turned round.
        let [switched, first, second] = [0, 1, 2].map(|n| changes(&world, n));
        let values = |all: &[(u64, u32)]| all.iter().map(|(_, value)| *value).collect::<Vec<_>>();
        assert_eq!(values(&switched), [1, 0]);
        assert_eq!(values(&first), [102, 204, 0]);
        assert_eq!(values(&second), [191]);
        let [a, b] = [20.0, 40.0].map(|x_mm| passes(&world, x_mm));
        let pairs = [(switched[0].0, a), (first[0].0, a), (first[1].0, b), (second[0].0, b)];
        // M63 and M68 change at once, where the machine stands.
        let made = &world.fake.steppers[&0].made;
        let stands = made[5_999].0..made[6_000].0;
        assert!(stands.end - stands.start > 50_000 * TICKS_PER_US, "{stands:?}");
        assert!(stands.contains(&switched[1].0) && stands.contains(&first[2].0), "{stands:?}");
        let off = pairs.iter().map(|(made, place)| made.abs_diff(*place));
        let worst_us = off.max().unwrap() as f64 / TICKS_PER_US as f64;
        eprintln!("{worst_us:.2} µs from the place");
        assert!(worst_us < 10.0, "{worst_us} µs");
    }
}

#[test]
fn a_channel_that_has_no_pin_is_told_with_those_that_have_one() {
    let (_, fault) = ran(1, Faults::default(), "G21\nM67 E4 Q40\nG1 X2 F3000\nM2\n");
    let why = fault.expect("a fault");
    assert!(why.contains("has no PWM channel 5, but 1, 2"), "{why}");
}
