//! Height control on a board with step queues, in simulated time: a torch over a sheet in waves, whose voltage the board
//! measures.

use crate::queued::{Shop, World, machine_of};
use kerf_control::answers::Answers;
use kerf_control::controller::queued::Queued;
use kerf_control::{RunContext, Session};
use kerf_driver_klipper::fake::{Board as Fake, Faults};
use kerf_files::MemoryDisk;
use kerf_geom::{Point2, Polyarc};
use kerf_journal::{RunOptions, Work};
use kerf_machine::lines::Input;
use kerf_machine::profile::profile;
use kerf_machine::settings::height::HeightMode;
use kerf_machine::{Configuration, Driven, Going, LiftOfMove, Machine};
use kerf_motion::{Model, Move, Mover, Optimal, Plan};
use kerf_program::job::{Job, JobShape};
use kerf_program::{At, Axes, AxisSet, Dynamics, Feed, Gauge, HeightLaw, Line, MoveKind, Settings};
use kerf_trace::{Event, Sink};
use kerf_workspace::Workspace;
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;

const FILE: &str = "[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n[board]\nx = \"gpio0 gpio1\"\n\
    y = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\nheight = \"ADC\"\nboth_edges = true\npulse_us = 0.1";

/// Millimetres of gap for one unit of the reading.
const SCALE_MM: f64 = 0.038;
/// The reading that is wanted, and its gap.
const WANTED: f64 = 150.0;
pub const GAP_MM: f64 = WANTED * SCALE_MM;
/// The height at which the cut begins, Z of the machine frame: right over the sheet at X 0.
pub const Z_MM: f64 = -10.0;
/// Speed of the cut.
const CUT_MM_S: f64 = 50.0;

pub fn law() -> HeightLaw {
    let set_points = [WANTED; 2];
    HeightLaw {
        gauge: Gauge::Proportional {
            set_points,
            gain_mm: SCALE_MM,
            scale_mm: SCALE_MM,
            interval_s: 0.001,
        },
        speed_mm_s: 30.0,
        accel_mm_s2: 400.0,
        activation: 0.5,
        ceiling_mm: 0.0,
        floor_mm: -30.0,
        raised_mm: None,
    }
}

/// Waves of 3 mm from crest to trough, 300 mm long.
pub fn sheet_mm(x_mm: f64) -> f64 {
    Z_MM - GAP_MM + 1.5 * (x_mm / 300.0 * std::f64::consts::TAU).sin()
}

/// Places of X and Z: it begins to count at the beginning of the cut.
pub fn place(fake: &Fake) -> [f64; 2] {
    let steps = |oid: u8| fake.steppers[&oid].position as f64;
    [steps(0) / 100.0, Z_MM + steps(2) / 200.0]
}

fn voltage(fake: &Fake) -> f64 {
    let [x, z] = place(fake);
    (z - sheet_mm(x)) / SCALE_MM / 255.0
}

pub fn line(from: Axes, to: Axes) -> Plan {
    let dynamics = Dynamics {
        speed_mm_s: Axes::splat(200.0),
        accel_mm_s2: Axes::splat(500.0),
        jerk_mm_s3: Some(Axes::splat(10_000.0)),
        tolerance_mm: 0.01,
    };
    let mut mover = Mover::new(from, &Settings::default());
    let line = Line { kind: MoveKind::Cut, to, feed: Feed::Path(CUT_MM_S) };
    let moves: Vec<Move> = mover.line(At::default(), &line).into_iter().collect();
    Optimal { dynamics: &dynamics }.plan(moves)
}

/// A machine at the beginning of a cut, with its torch over the sheet.
fn shop(seed: u64, faults: Faults, voltage: fn(&Fake) -> f64) -> Shop {
    let mut shop = Shop::of(&machine_of(FILE), seed, faults, |_| {});
    shop.world.borrow_mut().voltage = Some(voltage);
    let begin = Axes::xyz(0.0, 0.0, Z_MM);
    shop.queued.is_at(begin);
    shop.queued.begin();
    shop
}

/// Makes a plan as a run does; tells the way beside it, and the inputs that changed.
pub fn make(
    shop: &mut Shop,
    plan: &Plan,
    mut each: impl FnMut(&Fake),
) -> (LiftOfMove, Vec<(u8, bool)>) {
    let (t0_s, until, mut inputs) = (10.0, plan.moves().len(), Vec::new());
    shop.queued.begin_plan();
    let going = Going { plan, index: 0, t0_s, until, part: 1.0, watches: &[] };
    let end_s = t0_s + plan.span_s(0).1;
    let mut reached_s = t0_s;
    while reached_s < end_s {
        let news = shop.queued.advance(&going, reached_s, end_s);
        assert_eq!(shop.queued.fault(), None);
        reached_s = news.reached_s;
        inputs.extend(news.input);
        each(&shop.world.borrow().fake);
    }
    while shop.queued.settle() {
        each(&shop.world.borrow().fake);
    }
    (shop.queued.made(t0_s, plan, &plan.span(0).unwrap()), inputs)
}

#[test]
fn a_torch_follows_a_sheet_in_waves() {
    for (seed, faults) in [(1, Faults::default()), (2, Faults::all(0.01 / 6.0))] {
        let mut shop = shop(seed, faults, voltage);
        let (begin, end) = (Axes::xyz(0.0, 0.0, Z_MM), Axes::xyz(450.0, 0.0, Z_MM));
        let plan = line(begin, end);
        assert_eq!(
            shop.queued.height_control(Some(law()), &begin),
            [(Input::ZHigh.number(), false)]
        );
        let mut worst_mm = 0.0_f64;
        let (carried, inputs) = make(&mut shop, &plan, |fake| {
            let [x, z] = place(fake);
            if (20.0..440.0).contains(&x) {
                worst_mm = worst_mm.max((z - sheet_mm(x) - GAP_MM).abs());
            }
        });
        eprintln!("worst {worst_mm:.3} mm at 50 mm/s");
        assert!(inputs.iter().all(|(input, _)| *input == Input::ZHigh.number()), "{inputs:?}");
        assert!(worst_mm < 0.35, "{worst_mm} mm");
        let [_, z] = place(&shop.world.borrow().fake);
        let [_, after_mm] = carried.lift.ends();
        assert!((Z_MM + after_mm - z).abs() < 0.006, "{after_mm} {z}");
        assert!(carried.readings.len() > 500, "{}", carried.readings.len());
    }
}

/// SIM on a board, with more lines of its pins.
pub fn table(pins: &str) -> Configuration {
    let mut machine = machine_of(&format!(
        "{}\n[board]\nx = \"gpio0 gpio1\"\ny = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\n{pins}\n\
         outputs = \"1 gpio20, 14 gpio21\"\nboth_edges = true\npulse_us = 0.1",
        profile("sim").unwrap().text
    ));
    (machine.height.on, machine.height.activation_percent) = (true, 50.0);
    machine
}

/// The same with a torch whose voltage is measured.
fn plasma_table() -> Configuration {
    let mut machine = table("height = \"ADC\"");
    (machine.height.mode, machine.height.k) = (HeightMode::Proportional, 9.5);
    machine
}

/// Places of X and Z on SIM, which stands at its home.
pub fn on_sim(fake: &Fake) -> [f64; 2] {
    [0, 2].map(|oid: u8| fake.steppers[&oid].position as f64 / 250.0)
}

/// The sheet of a job lies 20 mm below home, less the gap.
pub fn sim_sheet_mm(x_mm: f64) -> f64 {
    sheet_mm(x_mm) - 10.0
}

fn sim_voltage(fake: &Fake) -> f64 {
    let [x, z] = on_sim(fake);
    (z - sim_sheet_mm(x)) / SCALE_MM / 255.0
}

/// The cable breaks at X 150.
fn breaks(fake: &Fake) -> f64 {
    if on_sim(fake)[0] > 150.0 { 0.0 } else { sim_voltage(fake) }
}

/// Everything that a job tells.
pub struct Watched {
    pub world: Rc<RefCell<World>>,
    pub events: Vec<Event>,
}

impl Sink for Watched {
    fn event(&mut self, event: &Event) {
        self.events.push(event.clone());
    }
}

fn cuts(voltage: fn(&Fake) -> f64, answers: &str) -> (Watched, Rc<RefCell<Queued>>) {
    cuts_on(plasma_table(), |world| world.voltage = Some(voltage), answers)
}

/// A job of one line of 300 mm on a machine.
pub fn cuts_on(
    machine: Configuration,
    feels: impl Fn(&mut World),
    answers: &str,
) -> (Watched, Rc<RefCell<Queued>>) {
    let shop = Shop::of(&machine, 3, Faults::default(), |_| {});
    let world = shop.world.clone();
    feels(&mut world.borrow_mut());
    let line = JobShape::through(
        1,
        Polyarc::lines([Point2::new(0.0, 0.0), Point2::new(300.0, 0.0)], false),
    );
    let job =
        Job { name: "job.rsm".into(), shapes: [line].into_iter().collect(), ..Job::default() };
    let mut session = Session::default();
    session.homed = AxisSet::first(3);
    session.hold(machine.clone());
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let queued = Rc::new(RefCell::new(shop.queued));
    let driven: Driven = queued.clone();
    let mut sink = Watched { world, events: Vec::new() };
    let mut operator = Answers::read(answers);
    let context = RunContext {
        sink: &mut sink,
        operator: &mut operator,
        requests: &mut (),
        machine: driven.into(),
    };
    let work = Work::Job(Arc::new(job), Arc::new(machine));
    session.run(work, RunOptions::default(), &mut workspace, context);
    queued.borrow_mut().close(true, || false);
    (0..50).for_each(|_| sink.world.borrow_mut().pass());
    (sink, queued)
}

#[test]
fn a_job_keeps_its_torch_at_its_height_and_tells_how_far_behind_z_is() {
    let (sink, driven) = cuts(sim_voltage, "");
    assert_eq!(driven.borrow().fault(), None);
    assert!(!sink.events.iter().any(|event| matches!(event, Event::Diag(_))), "{:?}", sink.events);
    let readings = heights(&sink.events);
    let begin_s = readings[0].0;
    let worst_mm = |from_s: f64| {
        let late = readings.iter().filter(|(t_s, _)| *t_s > begin_s + from_s);
        late.map(|(_, error_mm)| error_mm.abs()).fold(0.0, f64::max)
    };
    eprintln!("{} readings, worst {:.3} mm", readings.len(), worst_mm(0.5));
    // 100 mm/s: Z is 0.16 s behind a sheet that rises by 3.1 mm/s.
    assert!(readings.len() > 250 && worst_mm(0.5) < 0.6, "{}", worst_mm(0.5));
    let told = sink.events.iter().filter_map(|event| match event {
        Event::Message { text, .. } => Some(text.to_string()),
        _ => None,
    });
    let told: Vec<String> = told.collect();
    assert!(told.len() == 1 && told[0].contains("a reading every 10 ms"), "{told:?}");
    // The cut begins where a reading says so, and not where the head ran on to.
    assert!((begins_mm(&sink.events) + 20.0).abs() < 0.2, "{}", begins_mm(&sink.events));
    let world = sink.world.borrow();
    let torch = &world.fake.outputs.values().nth(1).unwrap().made;
    let mut torch: Vec<bool> = torch.iter().map(|(_, on)| *on != 0).collect();
    torch.dedup();
    assert_eq!(torch, [true, false]);
    assert_eq!(world.fake.ran["query_analog_in"], 2, "on, and off at the end");
}

/// Moments and errors of the readings, mm.
fn heights(events: &[Event]) -> Vec<(f64, f64)> {
    let told = events.iter().filter_map(|event| match event {
        Event::Height { error, t, .. } => Some((*t, *error)),
        _ => None,
    });
    told.collect()
}

/// Height at which the cut along X begins, mm.
fn begins_mm(events: &[Event]) -> f64 {
    let cut = events.iter().find_map(|event| match event {
        Event::Move(made) if made.kind == MoveKind::Cut && made.to.x > 0.0 => Some(made.from.z),
        _ => None,
    });
    cut.unwrap()
}

#[test]
fn a_torch_whose_voltage_is_lost_stays_at_its_height_and_is_lifted_by_the_pause() {
    let (sink, driven) = cuts(breaks, "abort");
    assert_eq!(driven.borrow().fault(), None);
    let asked = sink.events.iter().find_map(|event| match event {
        Event::Ask(ask) => Some((ask.text.to_string(), ask.t)),
        _ => None,
    });
    let (text, asked_s) = asked.expect("it pauses");
    assert!(text.contains("no height readings"), "{text}");
    let last_s = heights(&sink.events).last().unwrap().0;
    assert!(asked_s - last_s < 2.0, "{asked_s} {last_s}");
    let world = sink.world.borrow();
    let z = &world.fake.steppers[&2].made;
    let torch = &world.fake.outputs.values().nth(1).unwrap().made;
    let (off, on) = *torch.last().unwrap();
    assert_eq!(on, 0, "the torch is off");
    // From the loss on Z stays: it moves on from where it was by what it had to follow then, and then stands.
    let lost = lost_at(&world);
    let while_lost = z.iter().filter(|(at, _)| (lost + 3_600_000..off).contains(at)).count();
    assert!(while_lost < 5, "{while_lost} steps of 0.004 mm");
    let [_, up] = on_sim(&world.fake);
    assert!(up > -12.0, "it is lifted to ZTop: {up}");
}

/// The clock at which the cable broke: X passed 150.
fn lost_at(world: &World) -> u64 {
    let passed = world.fake.steppers[&0].made.iter().filter(|(_, forward)| *forward);
    passed.map(|(at, _)| *at).nth(150 * 250).unwrap()
}
