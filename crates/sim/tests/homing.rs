//! Homing on a bench of axes, with the numbers of readings, Events of a job.

use crate::bench::Bench;
use kerf_machine::Configuration;
use kerf_machine::homing::{self, Homed, NotFound, Which, soft_bounds};
use kerf_machine::profile::profile;
use kerf_machine::settings::homing::HomeEnd;
use kerf_machine::settings::motors::{FreeMotor, Motor};
use kerf_program::{Axis, AxisSet};

fn sim(edit: impl FnOnce(&mut Configuration)) -> Configuration {
    let mut machine = profile("sim").unwrap().configuration().unwrap();
    edit(&mut machine);
    machine
}

/// The ends of the motions of an axis that is homed, thousandths.
fn ends(machine: &Configuration, axis: Axis) -> Vec<f64> {
    let bench = homed(machine, axis);
    bench.legs().iter().map(|leg| thousandth(leg.to)).collect()
}

fn thousandth(v: f64) -> f64 {
    (v * 1000.0).round() / 1000.0
}

fn home(machine: &Configuration, bench: &mut Bench, axes: AxisSet) -> Result<Vec<Homed>, NotFound> {
    let mut homed = Vec::new();
    homing::home(machine, bench, axes, &mut homed).map(|()| homed)
}

fn homed(machine: &Configuration, axis: Axis) -> Bench {
    let mut bench = Bench::new(machine);
    home(machine, &mut bench, AxisSet::EMPTY.with(axis)).unwrap();
    bench
}

#[test]
fn pro_homing_step1() {
    assert_eq!(ends(&sim(|_| ()), Axis::X)[0], -121.25);
}

#[test]
fn pro_homing_step2() {
    let bench = homed(&sim(|_| ()), Axis::X);
    let leg = bench.legs()[1];
    assert_eq!(
        (leg.from, leg.edge.map(thousandth), thousandth(leg.to)),
        (-121.25, Some(-120.0), -118.75)
    );
}

#[test]
fn pro_homing_step3() {
    let leg = homed(&sim(|_| ()), Axis::X).legs()[2];
    assert_eq!(
        (leg.peak, leg.edge.map(thousandth), thousandth(leg.to)),
        (2.0, Some(-120.0), -120.002)
    );
}

#[test]
fn pro_homing_step4() {
    assert_eq!(thousandth(homed(&sim(|_| ()), Axis::X).places()[0]), -117.0);
}

#[test]
fn pro_homing_step5() {
    let machine = sim(|m| m.homing.switches[0].off = 80.0);
    let mut bench = homed(&machine, Axis::X);
    let leg = bench.legs()[3];
    assert_eq!((thousandth(leg.from), thousandth(leg.to), leg.peak), (-120.002, -40.0, 200.0));
    assert_eq!(bench.shaft(Axis::X).shown(0), 0.0);
}

#[test]
fn pro_homing_slowzero() {
    let machine = sim(|m| m.homing.switches[0].slow = 0.0);
    assert_eq!(ends(&machine, Axis::X), [-121.25, -118.75, -117.0]);
}

#[test]
fn pro_homing_speeds() {
    for (axis, fast, slow) in [(Axis::X, 50.0, 2.0), (Axis::Z, 20.0, 1.0)] {
        // Far enough from the switch to reach the speed.
        let legs = homed(&sim(|_| ()), axis).legs();
        assert_eq!((legs[1].peak, legs[2].peak), (fast, slow));
    }
}

#[test]
fn pro_homing_offdist() {
    let machine = sim(|m| m.homing.switches[1].off = 5.0);
    assert_eq!(thousandth(homed(&machine, Axis::X).places()[0]), -117.0);
    assert_eq!(thousandth(homed(&machine, Axis::Y).places()[1]), -115.0);
    let machine = sim(|m| m.homing.switches[0].off = 0.0);
    assert_eq!(thousandth(homed(&machine, Axis::X).places()[0]), -120.0);
}

#[test]
fn pro_homing_xhome() {
    assert_eq!(soft_bounds(&sim(|_| ()), Axis::X), Some((0.0, 2500.0)));
    let right = sim(|m| {
        m.homing.switches[0].end = HomeEnd::High;
        m.simulated.switch_at[0] = Some(120.0);
    });
    assert_eq!(ends(&right, Axis::X), [121.25, 118.75, 120.002, 117.0]);
    assert_eq!(soft_bounds(&right, Axis::X), Some((-2500.0, 0.0)));
}

#[test]
fn pro_homing_yhome() {
    assert_eq!(ends(&sim(|_| ()), Axis::Y)[0], -121.25);
    assert_eq!(soft_bounds(&sim(|_| ()), Axis::Y), Some((0.0, 1250.0)));
    let back = sim(|m| {
        m.homing.switches[1].end = HomeEnd::High;
        m.simulated.switch_at[1] = Some(120.0);
    });
    assert_eq!(ends(&back, Axis::Y)[0], 121.25);
    assert_eq!(soft_bounds(&back, Axis::Y), Some((-1250.0, 0.0)));
}

#[test]
fn pro_axes_lengths() {
    let machine = sim(|_| ());
    let bounds = [Axis::X, Axis::Y, Axis::Z].map(|axis| soft_bounds(&machine, axis).unwrap());
    assert_eq!(bounds, [(0.0, 2500.0), (0.0, 1250.0), (-150.0, 0.0)]);
}

#[test]
fn pro_homing_zdir() {
    let mut bench = homed(&sim(|_| ()), Axis::Z);
    assert_eq!(bench.legs()[0].edge, Some(5.0));
    assert_eq!((thousandth(bench.legs()[0].to), thousandth(bench.places()[2])), (5.4, 2.0));
    assert_eq!(bench.shaft(Axis::Z).shown(0), 0.0);
}

#[test]
fn pro_zpos_origin() {
    let mut bench = homed(&sim(|_| ()), Axis::Z);
    assert_eq!((thousandth(bench.places()[2]), bench.shaft(Axis::Z).shown(0)), (2.0, 0.0));
}

#[test]
fn pro_homing_wdir() {
    let machine = sim(|m| {
        m.homing.switches[5].fitted = true;
        m.simulated.switch_at[3] = Some(30.0);
    });
    let mut bench = homed(&machine, Axis::C);
    assert_eq!(bench.legs()[0].edge, Some(30.0));
    assert_eq!((thousandth(bench.places()[5]), bench.shaft(Axis::C).shown(0)), (28.0, 0.0));
}

#[test]
fn pro_homing_starton() {
    let machine = sim(|m| m.simulated.start_at[0] = -121.0);
    let legs = homed(&machine, Axis::X).legs();
    assert!(legs[0].from == -121.0 && legs[0].to > -120.0 && legs[1].to < -120.0);
    assert_eq!(thousandth(legs.last().unwrap().to), -117.0);
}

#[test]
fn pro_homing_notfound() {
    let machine = sim(|m| m.simulated.switch_at[0] = None);
    let mut bench = Bench::new(&machine);
    let axes = AxisSet::EMPTY.with(Axis::X).with(Axis::Y);
    let error = home(&machine, &mut bench, axes).unwrap_err();
    assert_eq!(error.to_string(), "x home not found");
    assert_eq!(bench.legs().len(), 1, "nothing moves any more");
    assert_eq!(thousandth(bench.places()[0]), -2750.0);
}

#[test]
fn pro_homing_switch() {
    let machine = sim(|m| m.homing.switches[0].fitted = false);
    let mut bench = Bench::new(&machine);
    let axes = AxisSet::EMPTY.with(Axis::X).with(Axis::Y);
    let found = home(&machine, &mut bench, axes).unwrap();
    assert_eq!(found.iter().map(|it| it.axis).collect::<Vec<_>>(), [Axis::Y]);
    assert_eq!((bench.places()[0], bench.shaft(Axis::X).shown(0)), (0.0, 0.0));
}

#[test]
fn pro_homing_z2adj() {
    let machine = sim(|m| {
        m.motors.z2 = Some(FreeMotor::Q);
        m.program.rotary_units[0] = kerf_program::settings::AxisUnit::Linear(Default::default());
        m.homing.switches[3].fitted = true;
        m.homing.z2_adjustment_mm = -0.35;
        m.simulated.switch_at[Motor::Q.index()] = Some(2.0);
    });
    let mut bench = homed(&machine, Axis::A);
    assert_eq!(thousandth(bench.places()[3]), -1.35);
    assert_eq!(bench.shaft(Axis::A).shown(0), 0.0);
}

/// Two motors of X whose switches are 0.4 mm apart.
fn pair(separate: bool) -> Configuration {
    sim(|m| {
        m.motors.x2 = Some(FreeMotor::Q);
        m.homing.separate_x = separate;
        m.simulated.switch_at[Motor::Q.index()] = Some(-119.6);
    })
}

#[test]
fn pro_homing_pair() {
    let mut bench = homed(&pair(true), Axis::X);
    let rounds: Vec<Which> = bench.legs().iter().map(|leg| leg.which).collect();
    assert_eq!(&rounds[..4], [Which::All; 4]);
    assert_eq!(&rounds[4..8], [Which::One(0); 4]);
    assert_eq!(&rounds[8..], [Which::One(1); 4]);
    let shaft = bench.shaft(Axis::X);
    assert_eq!(thousandth(shaft.place(1) - shaft.place(0)), 0.4, "skew corrected");
    let together = homed(&pair(false), Axis::X);
    assert!(together.legs().iter().all(|leg| leg.which == Which::All));
    assert_eq!(thousandth(together.legs()[2].edge.unwrap()), -119.6, "whichever trips first");
}

#[test]
fn pro_homing_pair_align() {
    let mut bench = homed(&pair(true), Axis::X);
    let shaft = bench.shaft(Axis::X);
    assert_eq!((thousandth(shaft.place(0)), thousandth(shaft.place(1))), (-117.0, -116.6));
    assert_eq!((shaft.shown(0), shaft.shown(1)), (0.0, 0.0));
}

#[test]
fn pro_homing_diff__steps() {
    let machine = sim(|_| ());
    let axes = AxisSet::EMPTY.with(Axis::X);
    let mut bench = Bench::new(&machine);
    home(&machine, &mut bench, axes).unwrap();
    assert_eq!(home(&machine, &mut bench, axes).unwrap()[0].difference_steps, 0);
    bench.shaft(Axis::X).put_switch(0, Some(-120.0 + 0.012));
    assert_eq!(home(&machine, &mut bench, axes).unwrap()[0].difference_steps, 3);
}

#[test]
fn pro_homing_auto_program__order() {
    let machine = sim(|_| ());
    let mut bench = Bench::new(&machine);
    let axes = AxisSet::EMPTY.with(Axis::X).with(Axis::Y).with(Axis::Z);
    let found = home(&machine, &mut bench, axes).unwrap();
    assert_eq!(found.iter().map(|it| it.axis).collect::<Vec<_>>(), [Axis::Z, Axis::X, Axis::Y]);
    let mut legs = bench.legs();
    legs.sort_by(|a, b| a.span_s[0].total_cmp(&b.span_s[0]));
    assert!(legs.windows(2).all(|pair| pair[0].span_s[1] <= pair[1].span_s[0] + 1e-12));
}

#[test]
fn the_edge_is_the_same_with_hysteresis() {
    let machine = sim(|m| m.simulated.hysteresis = 0.5);
    assert_eq!(thousandth(homed(&machine, Axis::X).places()[0]), -117.0);
}
