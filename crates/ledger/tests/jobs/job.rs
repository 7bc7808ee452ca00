//! Area `job`: where a job lies, with what it begins and ends, jigs, door, repeats, limits.

use kerf_geom::Point2;
use kerf_ledger::jobs::{JobRun, JobTrace, Signals, job, line, square, t1, t2};
use kerf_machine::Errand;
use kerf_machine::lines::Input;
use kerf_machine::settings::job::Heads;
use kerf_machine::settings::motors::FreeMotor;
use kerf_program::{Axis, AxisSet, Status};

fn ends(trace: &JobTrace) -> Vec<String> {
    let moves = trace.moves();
    moves.iter().map(|m| m.split_once(' ').map_or("", |(_, end)| end).to_owned()).collect()
}

fn messages(trace: &JobTrace) -> Vec<String> {
    let told = |event: &kerf_trace::Event| match event {
        kerf_trace::Event::Message { text, .. } => Some(text.to_string()),
        _ => None,
    };
    trace.events.iter().filter_map(told).collect()
}

/// Names of shapes in the order in which they are cut.
fn cut(trace: &JobTrace) -> Vec<u32> {
    let cuts = trace.events.iter().filter_map(|event| match event {
        kerf_trace::Event::Move(made) if made.kind == kerf_program::MoveKind::Cut => {
            let flat = (made.from.x, made.from.y) != (made.to.x, made.to.y);
            flat.then_some(made.line)
        }
        _ => None,
    });
    let mut all: Vec<u32> = cuts.collect();
    all.dedup();
    all
}

#[test]
fn pro_job_origin_any() {
    let placed = JobRun::new(job([line(1, (10.0, 5.0), (20.0, 5.0))]));
    let trace = placed.job(|job| job.origin = Some(Point2::new(300.0, 200.0))).run();
    // The display is relative to the origin; the machine ends where the origin lies.
    assert_eq!(ends(&trace)[0], "x10 y5");
    assert_eq!(trace.rests(), [300.0, 200.0, -10.0]);
}

#[test]
fn pro_job_origin_start_yes() {
    let run = JobRun::new(t1()).with(|machine| machine.job.change_origin_at_start = true);
    let run = run.job(|job| job.origin = Some(Point2::new(300.0, 200.0))).at(50.0, 60.0, 0.0).run();
    assert_eq!(run.rests(), [50.0, 60.0, -10.0]);
}

#[test]
fn pro_job_origin_start_no() {
    let run = JobRun::new(t1()).job(|job| job.origin = Some(Point2::new(300.0, 200.0)));
    assert_eq!(run.at(50.0, 60.0, 0.0).run().rests(), [300.0, 200.0, -10.0]);
}

#[test]
fn pro_job_finish() {
    let run = |origin: Point2| {
        let run = JobRun::new(t1()).job(|job| {
            (job.origin, job.finish) = (Some(origin), Some(Point2::new(25.0, 20.0)));
        });
        run.run()
    };
    let far = run(Point2::new(300.0, 200.0));
    assert_eq!(
        (far.rests(), ends(&far).last().map(String::as_str)),
        ([325.0, 220.0, -10.0], Some("x25 y20"))
    );
    assert_eq!(run(Point2::default()).rests(), [25.0, 20.0, -10.0]);
}

#[test]
fn pro_job_finish_default() {
    let run = JobRun::new(t1()).job(|job| job.origin = Some(Point2::new(300.0, 200.0)));
    assert_eq!(run.run().rests(), [300.0, 200.0, -10.0]);
}

#[test]
fn pro_job_end() {
    let trace = JobRun::new(t1()).run();
    assert_eq!(trace.edges()[6..], ["7.190 router-", "7.890 job_running-"]);
    assert_eq!(trace.states().last().map(String::as_str), Some("7.890 idle"));
}

#[test]
fn pro_job_raise_pause() {
    let stopped = |raise: bool| {
        let run = JobRun::new(t1()).with(|machine| machine.pause.raise = raise).stop(5.34);
        run.run().rests()[2]
    };
    assert_eq!((stopped(true), stopped(false)), (-10.0, -30.0));
    // Switched during a pause: the next one obeys.
    let again = JobRun::new(t1()).stop(5.34).stop(11.0).say("raise no ⏎ resume ⏎ abort").run();
    assert_eq!(again.rests()[2], -30.0);
}

#[test]
fn pro_job_repeats() {
    let trace = JobRun::new(t2()).with(|machine| machine.job.repeats = 3).run();
    assert_eq!(cut(&trace), [1, 2, 1, 2, 1, 2]);
    assert_eq!(messages(&trace), ["2 of 3", "3 of 3"]);
    // The finish move is made once, at the end.
    assert_eq!(ends(&trace).iter().filter(|end| *end == "y0").count(), 3, "{:?}", ends(&trace));
    let setting = kerf_machine::table::setting("job.repeats").expect("the setting");
    let mut machine = kerf_machine::Configuration::default();
    assert_eq!(machine.job.repeats, 1);
    assert!(setting.set(&mut machine, &kerf_machine::Value::Number(0.0)).is_err());
    let edges = trace.edges();
    assert_eq!(edges.iter().filter(|edge| edge.contains("router")).count(), 2);
    assert_eq!(trace.rests(), [0.0, 0.0, -10.0]);
}

fn five() -> JobRun {
    JobRun::new(job(
        (1..=5).map(|n| line(n, (0.0, 10.0 * f64::from(n)), (50.0, 10.0 * f64::from(n))))
    ))
}

#[test]
fn pro_job_start_number() {
    assert_eq!(cut(&five().job(|job| job.start = 4).run()), [4, 5]);
    let chosen = five().with(|machine| machine.misc.double_start = true).say("5 ⏎ resume").run();
    assert_eq!(ends(&chosen)[0], "y50");
    assert_eq!(cut(&chosen), [5]);
}

#[test]
fn pro_job_start_step() {
    let stepped = |words: &str| {
        cut(&five().with(|machine| machine.misc.double_start = true).say(words).run())[0]
    };
    assert_eq!(stepped("next ⏎ next ⏎ previous ⏎ start"), 2);
    assert_eq!(stepped("previous ⏎ start"), 1);
    assert_eq!(stepped("next ⏎ next ⏎ next ⏎ next ⏎ next ⏎ start"), 5);
}

#[test]
fn pro_misc_doublestart() {
    let two = JobRun::new(t1()).with(|machine| machine.misc.double_start = true).say("start").run();
    assert_eq!(two.states(), ["0.000 waiting", "0.000 running", "7.890 idle"]);
    // The first Start takes Z home where that is set, and waits; nothing is switched before the second.
    let homes = |machine: &mut kerf_machine::Configuration| {
        machine.misc.double_start = true;
        machine.homing.at_job_start = AxisSet::EMPTY.with(Axis::Z);
    };
    let away = JobRun::new(t1()).with(homes).at(40.0, 30.0, -25.0).say("start").run();
    let first = |is: &dyn Fn(&kerf_trace::Event) -> bool| away.events.iter().position(is).unwrap();
    let waits = first(&|event| matches!(event, kerf_trace::Event::Ask(_)));
    assert!(
        first(
            &|event| matches!(event, kerf_trace::Event::Homed { axis, .. } if axis.eq_ignore_ascii_case("z"))
        ) < waits
    );
    assert!(first(&|event| matches!(event, kerf_trace::Event::Output { on: true, .. })) > waits);
    let stood = away.events[..waits].iter().rev().find_map(|event| match event {
        kerf_trace::Event::Move(made) => Some([made.to.x, made.to.y, made.to.z]),
        _ => None,
    });
    let [x, y, z] = stood.unwrap();
    assert!((x, y) == (40.0, 30.0) && z > -1.0, "Z only, from -25 to its switch: {x} {y} {z}");
}

#[test]
fn pro_misc_singlestart() {
    assert_eq!(JobRun::new(t1()).run().states(), ["0.000 running", "7.890 idle"]);
}

#[test]
fn pro_job_ext_door() {
    let run = || JobRun::new(t1()).with(|machine| machine.job.external_start = true);
    let closed = run().input(Input::WHome, 60.0, true).run();
    assert_eq!(closed.edges()[..2], ["60.000 job_running+", "60.300 router+"]);
    assert_eq!(messages(&closed), ["close the door"], "while it waits");
    let is_closed = run().input(Input::WHome, 0.0, true).run();
    assert_eq!(
        (is_closed.edges()[0].as_str(), messages(&is_closed).len()),
        ("0.000 job_running+", 0)
    );
    let open = run().run();
    assert!(open.moves().is_empty() && open.summary.status == Status::Stopped);
}

#[test]
fn pro_job_ext_door__before_homing() {
    let run = || {
        JobRun::new(t1()).with(|machine| {
            machine.job.external_start = true;
            machine.homing.at_job_start = AxisSet::EMPTY.with(Axis::Z);
        })
    };
    let open = run().run();
    assert!(
        open.moves().is_empty() && open.summary.status == Status::Stopped,
        "{:?}",
        open.moves()
    );
    // A button: let go before the job begins.
    let pressed = run().input(Input::WHome, 60.0, true).input(Input::WHome, 60.5, false).run();
    assert_eq!(messages(&pressed), ["close the door"]);
    assert!(pressed.moves()[0].starts_with("60.000-"), "{:?}", pressed.moves());
    assert_eq!(pressed.homed(), ["z 500 steps"]);
    let [waits, runs, _] = &pressed.states()[..] else { panic!("{:?}", pressed.states()) };
    assert!(waits == "0.000 waiting" && runs.ends_with(" running"));
    assert_eq!(pressed.summary.status, Status::Ok);
}

#[test]
fn pro_job_ext_unchecked() {
    let run = JobRun::new(t1()).with(|machine| machine.job.external_start = true);
    let run = run.input(Input::WHome, 1.0, true).input(Input::WHome, 6.0, false).run();
    assert_eq!(run.states().last().map(String::as_str), Some("8.890 idle"));
}

/// Squares left and right of a divider at 1250.
fn jigs() -> JobRun {
    let shapes = [
        square(1, (100.0, 0.0), 500.0),
        square(2, (1300.0, 0.0), 700.0),
        square(3, (1200.0, 0.0), 100.0),
    ];
    let run = JobRun::new(job(shapes));
    run.with(|machine| (machine.job.two_jigs, machine.job.divider_mm) = (true, 1250.0))
}

#[test]
fn pro_job_jig_divider() {
    let both = jigs().input(Input::Jig1, 1.0, true).input(Input::Jig2, 2.0, true).run();
    assert_eq!(cut(&both), [1, 2]);
    // The divider is a place of the machine, not of the drawing: 200 mm further shape 3 lies beyond it.
    let further = jigs().job(|job| job.origin = Some(Point2::new(200.0, 0.0)));
    let further = further.input(Input::Jig1, 1.0, true).input(Input::Jig2, 2.0, true).run();
    assert_eq!((cut(&further), messages(&further)), (vec![1, 2, 3], vec![]));
}

#[test]
fn pro_job_jig_straddle() {
    let both = jigs().input(Input::Jig1, 1.0, true).input(Input::Jig2, 2.0, true).run();
    assert_eq!(messages(&both), ["shape 3 lies across the divider and is not cut"]);
    let touching = JobRun::new(job([square(1, (1150.0, 0.0), 100.0)]));
    let touching = touching
        .with(|machine| (machine.job.two_jigs, machine.job.divider_mm) = (true, 1250.0))
        .input(Input::Jig1, 1.0, true);
    assert_eq!(cut(&touching.run()), [1]);
}

#[test]
fn pro_job_jig_init() {
    let waits = jigs().input(Input::Jig1, 60.0, true).run();
    assert!(waits.moves()[0].starts_with("60.000-"), "{:?}", waits.moves());
    assert_eq!(waits.edges()[..2], ["0.000 job_running+", "60.000 jig1+"]);
}

#[test]
fn pro_job_jig_inputs() {
    let trace = jigs().input(Input::Jig1, 1.0, true).input(Input::Jig2, 5.0, true).run();
    assert_eq!(cut(&trace), [1, 2]);
    let states = trace.states();
    // After jig 1 nobody does anything.
    assert_eq!(states.iter().filter(|state| state.ends_with("running")).count(), 2);
}

#[test]
fn pro_job_jig_outputs() {
    let trace = jigs().input(Input::Jig1, 1.0, true).run();
    let latch = trace.events.iter().any(|event| {
        matches!(event, kerf_trace::Event::Input { name: Some("jig1"), on: false, t, .. } if *t == 1.0)
    });
    assert!(latch, "the output switches the start switch off");
    let edges: Vec<_> = trace.edges().into_iter().filter(|edge| edge.contains("jig1")).collect();
    assert_eq!(edges.len(), 2, "{edges:?}");
    // It stays on until jig 1 is done, which is when its cut is and the tool is up.
    let at = |name: &str| trace.edges().into_iter().rev().find(|edge| edge.ends_with(name));
    let at_s = |name: &str| -> f64 {
        at(name).and_then(|edge| edge.split(' ').next()?.parse().ok()).expect("a time")
    };
    assert!(at_s("jig1-") >= at_s("tool1-"), "{:?}", trace.edges());
}

#[test]
fn pro_job_jig_first() {
    let second = jigs().job(|job| job.start = 2);
    let trace = second.input(Input::Jig1, 1.0, true).input(Input::Jig2, 1.0, true).run();
    assert_eq!(cut(&trace), [2, 1]);
}

#[test]
fn pro_job_jig_cycle() {
    let pressed = jigs().input(Input::Jig1, 1.0, true).input(Input::Jig2, 5.0, true);
    let trace = pressed.input(Input::Jig1, 80.0, false).input(Input::Jig1, 80.5, true).run();
    assert_eq!(cut(&trace), [1, 2, 1]);
    // At the end it waits at the finish position, until nobody comes for an hour.
    assert_eq!(trace.summary.status, Status::Stopped);
    assert_eq!(trace.rests()[..2], [0.0, 0.0]);
    // The job runs all the while, until key Stop.
    let stopped = jigs().input(Input::Jig1, 1.0, true).stop(500.0).run();
    let (moves, edges) = (stopped.moves(), stopped.edges());
    let last_s: f64 = moves[moves.len() - 1].split(['-', ' ']).nth(1).unwrap().parse().unwrap();
    assert!(last_s < 100.0 && moves[moves.len() - 1].ends_with(" x0"), "{moves:?}");
    let running: Vec<_> = edges.iter().filter(|edge| edge.contains("job_running")).collect();
    assert_eq!(running, ["0.000 job_running+", "500.000 job_running-"]);
}

#[test]
fn a_job_outside_the_table_does_not_begin() {
    let outside = JobRun::new(t1()).job(|job| job.origin = Some(Point2::new(2450.0, 0.0))).run();
    assert!(outside.moves().is_empty() && outside.edges().is_empty());
    assert_eq!(outside.refused(), "Out of bounds: shape 1 reaches X 2550.000");
}

#[test]
fn a_knife_turns_at_every_corner() {
    let knife = JobRun::new(job([square(1, (0.0, 0.0), 100.0)]));
    let trace = knife.with(|machine| machine.misc.tangential = true).run();
    let turns: Vec<_> = ends(&trace).into_iter().filter(|end| end.starts_with('c')).collect();
    assert_eq!(turns, ["c90", "c180", "c270", "c360"]);
}

#[test]
fn pro_io_inb0() {
    let trace = jigs().input(Input::Jig1, 1.0, true).run();
    assert!(trace.edges().contains(&"1.000 jig1+".into()), "{:?}", trace.edges());
}

#[test]
fn pro_io_inb1() {
    let trace = jigs().input(Input::Jig2, 1.0, true).run();
    assert!(trace.edges().contains(&"1.000 jig2+".into()), "{:?}", trace.edges());
}

/// A door that starts: closed at these times, open a second later.
fn started_by(doubles: bool, at_s: &[f64], say: &str) -> JobTrace {
    let mut run = JobRun::new(t1()).with(|machine| {
        (machine.job.external_start, machine.misc.double_start) = (true, doubles);
    });
    for t in at_s {
        run = run.input(Input::WHome, *t, true).input(Input::WHome, t + 1.0, false);
    }
    run.say(say).run()
}

#[test]
fn pro_job_ext_option() {
    assert!(started_by(false, &[5.0], "").edges()[0].starts_with("5.000 job_running+"));
    // With the double start it takes two.
    let twice = started_by(true, &[5.0, 9.0], "");
    assert!(twice.edges()[0].starts_with("9.000 job_running+"), "{:?}", twice.edges());
    let key = started_by(true, &[5.0], "start");
    assert!(key.edges()[0].starts_with("5.000 job_running+"), "or the key: {:?}", key.edges());
    let ignored = JobRun::new(t1()).input(Input::WHome, 5.0, true).run();
    assert!(ignored.edges()[0].starts_with("0.000 job_running+"), "without the option");
}

#[test]
fn pro_options_doublestart() {
    let two = JobRun::new(t2()).with(|machine| machine.misc.double_start = true).say("start").run();
    let asked = two.events.iter().find_map(|event| match event {
        kerf_trace::Event::Ask(ask) => Some(ask.text.clone()),
        _ => None,
    });
    assert_eq!(asked.as_deref(), Some("Start with shape 1?"));
    assert_eq!(cut(&two), [1, 2]);
}

/// Compares the profiles on the same line, and shows a punch that hits points.
#[test]
fn pro_misc_tools__what_each_does_with_a_line() {
    let run = |name: &str| {
        let preset = kerf_machine::profile::profile(name).unwrap().configuration().unwrap();
        JobRun::new(t1()).with(|machine| *machine = preset).run()
    };
    let has = |trace: &JobTrace, end: &str| trace.edges().iter().any(|edge| edge.ends_with(end));
    let [router, laser, plasma, knife] = ["router-96x48", "laser-pwm", "plasma", "knife"].map(run);
    // A router cuts once; a laser pierces first, and its beam pulses, slower there than in the cut.
    let cuts = |trace: &JobTrace| trace.edges().iter().filter(|e| e.ends_with(" cut1+")).count();
    assert_eq!([&router, &laser, &plasma, &knife].map(cuts), [1, 2, 0, 1]);
    assert!(has(&laser, "hz 500") && has(&laser, "hz 5000") && !has(&router, "hz 5000"));
    // A torch that finds no sheet pauses. A knife has an axis that turns it, which wants to be homed.
    assert!(plasma.states().iter().any(|state| state.ends_with("paused: surface not found")));
    assert_eq!(messages(&router), [""; 0]);
    assert_eq!(messages(&knife), ["not homed: w"]);
    // A punch goes down and up at each point and cuts nothing between them.
    let punch = JobRun::new(kerf_ledger::jobs::drawn("point 10,10; point 40,10")).run();
    let expected = ["x10 y10", "z-10", "z-30", "z-10", "x40", "z-30", "z-10", "x0 y0"];
    assert_eq!((ends(&punch), cuts(&punch)), (expected.map(str::to_owned).to_vec(), 2));
}

#[test]
fn pro_misc_tangential() {
    let steps = |tangential: bool| {
        let run = JobRun::new(job([square(1, (0.0, 0.0), 5.0)]));
        let run = run.with(|machine| {
            (machine.misc.tangential, machine.job.repeats) = (tangential, 2);
        });
        let positions = run.signals().changes("c_pos");
        let place = |(_, bits): &(u64, String)| i64::from_str_radix(&bits[1..], 2).unwrap_or(-1);
        positions.iter().map(place).max().unwrap_or_default()
    };
    // Two laps: four turns of 90 degrees each, the last one back into the first direction.
    assert_eq!((steps(true), steps(false)), (2 * 4 * 9000, 0));
}

#[test]
fn pro_motors_z2() {
    let both = |heads: Heads| {
        move |machine: &mut kerf_machine::Configuration| {
            machine.motors.z2 = Some(FreeMotor::Q);
            machine.job.heads = heads;
        }
    };
    let mut place = [None; kerf_program::AXES];
    place[Axis::A.index()] = Some(-5.0);
    let errand = Errand::To { place, relative: false, flat: false };
    let alone = JobRun::hand(errand).with(both(Heads::One)).signals();
    assert!(alone.changes("z_pos").is_empty() && !alone.changes("qstep").is_empty());
    assert_eq!(last(&alone, "a_pos"), -5 * 250);
    let run = |heads: Heads| {
        JobRun::new(job([line(1, (0.0, 0.0), (2.0, 0.0))])).with(both(heads)).signals()
    };
    let (one, two) = (run(Heads::One), run(Heads::Both));
    assert!(one.changes("qstep").is_empty(), "Q has no steps");
    assert_eq!(two.changes("a_pos"), two.changes("z_pos"), "z2 follows z, step for step");
}

/// End of a count of steps.
fn last(signals: &Signals, name: &str) -> i64 {
    let changes = signals.changes(name);
    let bits = &changes.last().expect("steps").1[1..];
    i64::from(i64::from_str_radix(bits, 2).expect("binary") as u32 as i32)
}

/// Short lines left and right of the divider, and when their jigs and cuts are on.
fn small_jigs() -> Signals {
    let lines = [line(1, (10.0, 0.0), (11.0, 0.0)), line(2, (20.0, 0.0), (21.0, 0.0))];
    let run = JobRun::new(job(lines)).with(|machine| {
        (machine.job.two_jigs, machine.job.divider_mm) = (true, 15.0);
    });
    run.input(Input::Jig1, 1.0, true).input(Input::Jig2, 2.0, true).signals()
}

#[test]
fn pro_io_outc0() {
    let signals = small_jigs();
    let (on, cuts) = (signals.on("jig1"), signals.on("cut1"));
    assert_eq!(on.len(), 1);
    assert!(on[0].0 < cuts[0].0 && on[0].1 > cuts[0].1 && on[0].1 < cuts[1].0, "{on:?} {cuts:?}");
    let bytes: Vec<String> = signals.changes("port_c").into_iter().map(|(_, it)| it).collect();
    assert_eq!(bytes, ["b00000001", "b00000000", "b00000010", "b00000000"]);
}

#[test]
fn pro_io_outc1() {
    let signals = small_jigs();
    let (on, cuts) = (signals.on("jig2"), signals.on("cut1"));
    assert_eq!(on.len(), 1);
    assert!(on[0].0 > cuts[0].1 && on[0].0 < cuts[1].0 && on[0].1 > cuts[1].1, "{on:?} {cuts:?}");
}

#[test]
fn pro_motors_z2__adjusted_where_it_was_homed() {
    let run = |adjustment_mm: f64| {
        let run = JobRun::new(job([line(1, (0.0, 0.0), (2.0, 0.0))])).unhomed();
        let trace = run.with(|machine| {
            machine.motors.z2 = Some(FreeMotor::Q);
            machine.job.heads = Heads::Both;
            machine.homing.switches[3] = machine.homing.switches[2];
            machine.homing.z2_adjustment_mm = adjustment_mm;
            machine.homing.at_job_start = kerf_program::AxisSet::EMPTY.with(Axis::Z).with(Axis::A);
            machine.simulated.switch_at[4] = machine.simulated.switch_at[2];
        });
        let trace = trace.run();
        trace.session.truth()[3][0]
    };
    let lower = run(0.0) - run(-0.35);
    assert!(
        (lower - 0.35).abs() < 0.005,
        "the second head is lower by what it is adjusted: {lower}"
    );
}

/// Places at which each cut of an array goes down, in order.
fn plunges(drawing: &str) -> Vec<[f64; 2]> {
    let trace = JobRun::new(kerf_ledger::jobs::drawn(drawing)).run();
    let down = |event: &kerf_trace::Event| match event {
        kerf_trace::Event::Move(made) if made.to.z < made.from.z && made.to.z == -30.0 => {
            Some([made.to.x, made.to.y])
        }
        _ => None,
    };
    trace.events.iter().filter_map(down).collect()
}

#[test]
fn pro_array_spacing__as_it_is_cut() {
    // Blocks of 100 x 50, 10 apart in x and 20 in y: they repeat every 110 and 70.
    let rows = |y: f64| [[0.0, y], [110.0, y], [220.0, y]];
    let block = "rect 0,0 100,50; array block";
    assert_eq!(plunges(&format!("{block} 2x3 gap 10,20")), [rows(0.0), rows(70.0)].concat());
    // A negative gap lays them into each other.
    let points = plunges("point 0,0; point 100,50; array block 1x2 gap -60,0");
    assert_eq!(points, [[0.0, 0.0], [100.0, 50.0], [40.0, 0.0], [140.0, 50.0]]);
    // A job of two blocks of 210 in all is repeated with a gap of its own.
    let places = plunges(&format!("{block} 1x2 gap 10,0; array job 1x2 gap 5,0"));
    let places: Vec<_> = places.into_iter().map(|[x, _]| x).collect();
    assert_eq!(places, [0.0, 110.0, 215.0, 325.0]);
}
