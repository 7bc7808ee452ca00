//! Height control by two switches, and by the input of VH, on a board with step queues, in simulated time.

use crate::queued::{Levels, Ran, Shop, World, machine_of, ran};
use crate::queued_height::{
    GAP_MM, Watched, Z_MM, cuts_on, law, line, make, on_sim, place, sheet_mm, sim_sheet_mm, table,
};
use kerf_driver_klipper::fake::{Board as Fake, Faults};
use kerf_machine::Machine;
use kerf_machine::lines::Input;
use kerf_program::{Axes, Gauge, HeightLaw, MoveKind};
use kerf_trace::{Event, Sink};

const FILE: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 200, 100, 100, 100]\n[board]\nx = \"gpio0 gpio1\"\n\
    y = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\ninputs = \"17 gpio10, 20 gpio11\"\nboth_edges = true\npulse_us = 0.1";

/// Distance from the height that is wanted at which a switch of the head closes, mm.
const BAND_MM: f64 = 0.3;

fn switches() -> HeightLaw {
    let [high, low] = [Input::ZHigh, Input::ZLow].map(Input::number);
    HeightLaw { gauge: Gauge::Simple { high, low }, ..law() }
}

/// Levels of the pins of the two switches at a gap.
fn levels(gap_mm: f64) -> Levels {
    vec![(10, gap_mm > GAP_MM + BAND_MM), (11, gap_mm < GAP_MM - BAND_MM)]
}

fn over_waves(fake: &Fake) -> Levels {
    let [x, z] = place(fake);
    levels(z - sheet_mm(x))
}

#[test]
fn a_head_with_two_switches_follows_a_sheet_in_waves() {
    for (seed, faults) in [(1, Faults::default()), (2, Faults::all(0.01 / 6.0))] {
        let mut shop = Shop::of(&machine_of(FILE), seed, faults, |_| {});
        shop.world.borrow_mut().levels = Some(over_waves);
        let (begin, end) = (Axes::xyz(0.0, 0.0, Z_MM), Axes::xyz(450.0, 0.0, Z_MM));
        shop.queued.is_at(begin);
        shop.queued.begin();
        assert_eq!(shop.queued.height_control(Some(switches()), &begin), []);
        let (plan, mut worst_mm) = (line(begin, end), 0.0_f64);
        let (carried, inputs) = make(&mut shop, &plan, |fake| {
            let [x, z] = place(fake);
            if (20.0..440.0).contains(&x) {
                worst_mm = worst_mm.max((z - sheet_mm(x) - GAP_MM).abs());
            }
        });
        eprintln!("worst {worst_mm:.3} mm at 50 mm/s");
        assert!(worst_mm < BAND_MM + 0.55, "{worst_mm} mm");
        let [_, z] = place(&shop.world.borrow().fake);
        let [_, after_mm] = carried.lift.ends();
        assert!((Z_MM + after_mm - z).abs() < 0.006, "{after_mm} {z}");
        let own = [Input::ZHigh, Input::ZLow].map(Input::number);
        assert!(inputs.iter().all(|(input, _)| own.contains(input)), "{inputs:?}");
        assert!(inputs.len() > 4 && carried.readings.is_empty(), "{inputs:?}");
    }
}

fn over_sim(fake: &Fake) -> Levels {
    let [x, z] = on_sim(fake);
    levels(z - sim_sheet_mm(x))
}

/// Both switches close at X 150.
fn conflict(fake: &Fake) -> Levels {
    if on_sim(fake)[0] > 150.0 { vec![(10, true), (11, true)] } else { over_sim(fake) }
}

fn two_switches(levels: fn(&Fake) -> Levels, answers: &str) -> Watched {
    let machine = table("inputs = \"17 gpio10, 20 gpio11\"");
    let (sink, queued) = cuts_on(machine, |world: &mut World| world.levels = Some(levels), answers);
    assert_eq!(queued.borrow().fault(), None);
    sink
}

#[test]
fn a_job_keeps_a_head_with_two_switches_at_its_height() {
    let sink = two_switches(over_sim, "");
    assert!(!sink.events.iter().any(|event| matches!(event, Event::Diag(_))), "{:?}", sink.events);
    let told = sink.events.iter().find_map(|event| match event {
        Event::Message { text, .. } => Some(text.to_string()),
        _ => None,
    });
    assert!(told.as_ref().is_some_and(|it| it.contains("answer its switches")), "{told:?}");
    let begins_mm = sink.events.iter().find_map(|event| match event {
        Event::Move(made) if made.kind == MoveKind::Cut && made.to.x > 0.0 => Some(made.from.z),
        _ => None,
    });
    // The switch that is too high lets go at the upper edge of its band, in the board.
    assert!((begins_mm.unwrap() + 20.0 - BAND_MM).abs() < 0.1, "{begins_mm:?}");
    let surfaces: Vec<f64> = sink
        .events
        .iter()
        .filter_map(|event| match event {
            Event::Heights { surface, .. } => Some(*surface),
            _ => None,
        })
        .collect();
    let [low, high] = surfaces
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(*z), high.max(*z)]);
    assert!(high - low > 2.0, "ZSurface goes with the sheet: {low} … {high}");
}

#[test]
fn two_switches_that_are_on_at_once_pause_the_job() {
    let sink = two_switches(conflict, "abort");
    let asked = sink.events.iter().find_map(|event| match event {
        Event::Ask(ask) => Some(ask.text.to_string()),
        _ => None,
    });
    assert!(asked.as_ref().is_some_and(|it| it.contains("sensors conflict")), "{asked:?}");
}

/// Input 1 of VH on a board, in inches.
const TORCH: &str = "[steps]\nper_unit = [100, 100, 100, 100, 100, 100]\n[board]\nx = \"gpio0 gpio1\"\n\
    y = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\ninputs = \"1 gpio10\"\nboth_edges = true\npulse_us = 0.1\ndeadline_s = 0.3";

struct Quiet;

impl Sink for Quiet {
    fn event(&mut self, _: &Event) {}
}

/// On until X has come 100 mm.
fn on_for_the_first_part(fake: &Fake) -> Levels {
    vec![(10, fake.steppers[&0].position < 10_000)]
}

/// Runs lines with the torch; steps of X and Z in order, with their moments, and the place of Z in mm that is believed.
fn rides(lines: &str) -> (Vec<(f64, i64)>, Vec<f64>, f64) {
    rides_on(TORCH, on_for_the_first_part, lines)
}

/// The same on another machine, whose input has other levels.
fn rides_on(
    file: &str,
    levels: fn(&Fake) -> Levels,
    lines: &str,
) -> (Vec<(f64, i64)>, Vec<f64>, f64) {
    let shop = Shop::of(&machine_of(file), 5, Faults::default(), |_| {});
    let world = shop.world.clone();
    world.borrow_mut().levels = Some(levels);
    let Ran { summary, session, queued } =
        ran(shop.queued, machine_of(file), lines, &mut Quiet, &mut ());
    assert_eq!(queued.borrow().fault(), None, "{summary:?}");
    queued.borrow_mut().close(true, || false);
    let world = world.borrow();
    let fake = &world.fake;
    let mut z = 0;
    let z: Vec<(f64, i64)> = fake.steppers[&2]
        .made
        .iter()
        .map(|(clock, up)| {
            z += if *up { 1 } else { -1 };
            (fake.time_at(*clock), z)
        })
        .collect();
    let x = fake.steppers[&0].made.iter().map(|(clock, _)| fake.time_at(*clock)).collect();
    (z, x, session.memory.position[kerf_program::Axis::Z])
}

#[test]
fn sbp_val_vh_torch__on_a_board() {
    // 4 in/s, and Z at a quarter of it: 25.4 mm/s, 2540 steps a second.
    let (z, x, believed_mm) = rides("VS,4\nVN,,,1\nVH,1\nMX,8\n");
    let (from_s, end_s) = (x[0], x[x.len() - 1]);
    let edge_s = x[10_000];
    let last = z.last().unwrap().1;
    assert!((believed_mm - last as f64 / 100.0).abs() < 0.011, "{believed_mm} {last}");
    // Down from the beginning on, and up once the torch has let go and the motion that was handed over is made.
    let (lowest_s, lowest) = *z.iter().min_by_key(|(_, z)| *z).unwrap();
    assert!(lowest_s > edge_s && lowest_s < edge_s + 0.35, "{lowest_s} {edge_s}");
    assert!(
        z[0].0 < from_s + 0.2 && z.iter().all(|(t_s, _)| *t_s < end_s + 0.01),
        "only in XY moves"
    );
    let rate = |from_s: f64, to_s: f64| {
        let at = |t_s: f64| z.iter().take_while(|(z_s, _)| *z_s < t_s).last().unwrap().1 as f64;
        (at(to_s) - at(from_s)) / (to_s - from_s)
    };
    let down = rate(edge_s - 0.4, edge_s - 0.1);
    assert!((down + 2540.0).abs() < 30.0, "{down} steps/s");
    let up = rate(lowest_s + 0.15, lowest_s + 0.35);
    assert!((up - 2540.0).abs() < 30.0, "{up} steps/s, lowest {lowest}");
    // Another rate, and none: Z alone and a torch that is off leave Z to the program.
    let (z, ..) = rides("VS,4\nVN,,,1\nVH,1,.1\nMX,8\n");
    let slow = z.windows(2).map(|pair| pair[1].0 - pair[0].0).fold(f64::INFINITY, f64::min);
    assert!((slow - 1.0 / 1016.0).abs() < 2e-5, "{slow} s from step to step");
    let (z, _, believed_mm) = rides("VS,4\nVN,,,1\nVH,1\nMX,8\nMZ,1\nVH,0\nMX,0\n");
    assert_eq!((z.last().unwrap().1, believed_mm), (2540, 25.4));
}

/// The same in mm, with limits of Z and a link as quick as usual.
const LIMITED: &str = "units = \"mm\"\n[steps]\nper_unit = [100, 100, 100, 100, 100, 100]\n\
    [limits]\ncheck = true\nlow = [0, 0, -20, 0, 0, 0]\nhigh = [900, 900, 15, 0, 0, 0]\n[board]\nx = \"gpio0 gpio1\"\n\
    y = \"gpio2 gpio3\"\nz = \"gpio4 gpio5\"\ninputs = \"1 gpio10\"\nboth_edges = true\npulse_us = 0.1";

fn always(_: &Fake) -> Levels {
    vec![(10, true)]
}

fn never(_: &Fake) -> Levels {
    vec![(10, false)]
}

/// Z comes to a limit with its ramp and stays there: while the input is always on, and while its cable is torn.
#[test]
fn vh_leads_z_no_farther_than_its_limits() {
    for (levels, limit) in [(always as fn(&Fake) -> Levels, -2000), (never, 1500)] {
        let (z, x, believed_mm) = rides_on(LIMITED, levels, "VS,100\nVN,,,1\nVH,1\nMX,400\n");
        assert_eq!((z.last().unwrap().1, believed_mm), (limit, limit as f64 / 100.0));
        assert!(z.iter().all(|(_, z)| z.abs() <= limit.abs()), "{limit}");
        assert_eq!(x.len(), 40_000, "the path is whole");
        let gaps: Vec<f64> = z.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
        let fastest_s = gaps.iter().copied().fold(f64::INFINITY, f64::min);
        let last_s = gaps[gaps.len() - 3..].iter().copied().fold(f64::INFINITY, f64::min);
        assert!((fastest_s - 0.0004).abs() < 2e-5, "{fastest_s} s from step to step");
        assert!(last_s > 2.0 * fastest_s, "it stops from {last_s} s a step");
    }
}

/// Changes each 31.37 mm.
fn alternates(fake: &Fake) -> Levels {
    vec![(10, fake.steppers[&0].position / 3_137 % 2 == 0)]
}

/// Longest time from a change of the input of VH to the ramp of Z: the lead of the board, a piece of 5 ms, a look.
#[test]
fn vh_answers_its_input_as_soon_as_the_lead_allows() {
    let (z, x, _) = rides_on(LIMITED, alternates, "VS,100\nVN,,,1\nVH,1,.05\nMX,400\n");
    let gap_s = |n: usize| z[n + 1].0 - z[n].0;
    let steady_s = (0..z.len() - 1).map(gap_s).fold(f64::INFINITY, f64::min);
    let answered = (2..12).map(|change| {
        let edge_s = x[change * 3_137];
        let begun = z.iter().position(|(t_s, _)| *t_s > edge_s).unwrap();
        let slows = (begun..z.len() - 1).find(|n| gap_s(*n) > 1.05 * steady_s).unwrap();
        z[slows].0 - edge_s
    });
    let longest_s = answered.fold(0.0, f64::max);
    eprintln!("at most {longest_s:.3} s from a change of the input to the ramp of Z");
    assert!(longest_s < 0.135, "{longest_s} s");
}
