//! Programs as traces of signals.

use kerf_control::{RunContext, Session};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_machine::Configuration;
use kerf_machine::profile::profile;
use kerf_machine::settings::motors::FreeMotor;
use kerf_model::Change;
use kerf_trace::vcd::VcdSink;
use kerf_workspace::Workspace;

fn sim(edit: impl FnOnce(&mut Configuration)) -> Configuration {
    let mut machine = profile("sim").unwrap().configuration().unwrap();
    edit(&mut machine);
    machine
}

/// The trace of a program on a machine.
fn traced(machine: Configuration, program: &str, inputs: Vec<Change>) -> String {
    let mut session = Session::default();
    session.memory.settings = machine.program.clone();
    let (mut operator, mut pace, mut out) = ((), (), Vec::new());
    let mut sink = VcdSink::new(&mut out, machine);
    let context = RunContext {
        sink: &mut sink,
        operator: &mut operator,
        requests: &mut pace,
        machine: kerf_control::simulated(),
    };
    let options = RunOptions { inputs, ..RunOptions::default() };
    let program = kerf_part::read("a.sbp".into(), program.as_bytes());
    session.run(program, options, &mut Workspace::in_memory(MemoryDisk::default()), context);
    sink.finish().unwrap();
    String::from_utf8(out).unwrap()
}

/// Returns the changes of a signal: moment, nanoseconds, and value.
fn changes(trace: &str, name: &str) -> Vec<(u64, String)> {
    let end = format!(" {name} $end");
    let declares = |line: &&str| line.starts_with("$var") && line.ends_with(&end);
    let declared = trace.lines().find(declares).unwrap();
    let code = declared.split(' ').nth(3).unwrap();
    let (mut now, mut found) = (0, Vec::new());
    let (_, body) = trace.split_once("$dumpvars").unwrap();
    let (_, body) = body.split_once("$end").unwrap();
    for line in body.lines() {
        if let Some(time) = line.strip_prefix('#') {
            now = time.parse().unwrap();
        } else if let Some(value) = line.strip_suffix(code) {
            found.push((now, value.trim().to_owned()));
        }
    }
    found
}

fn rises(trace: &str, name: &str) -> Vec<u64> {
    changes(trace, name).into_iter().filter(|(_, it)| it == "1").map(|(t_ns, _)| t_ns).collect()
}

#[test]
fn pro_axes_stepdir__trace() {
    let trace = traced(sim(|_| ()), "MX,1\nMX,0\n", Vec::new());
    assert_eq!(rises(&trace, "xstep").len(), 500);
    let directions = changes(&trace, "xdir");
    assert_eq!(directions.iter().map(|(_, it)| it.as_str()).collect::<Vec<_>>(), ["1", "0"]);
    let positions = changes(&trace, "x_pos");
    assert_eq!(positions[249].1, format!("b{:b}", 250));
    assert_eq!(positions.last().unwrap().1, "b0");
}

#[test]
fn pro_io_outa_qr() {
    let trace = traced(sim(|m| m.motors.x2 = Some(FreeMotor::Q)), "MX,1\n", Vec::new());
    assert_eq!(rises(&trace, "xstep"), rises(&trace, "qstep"));
    assert_eq!(rises(&trace, "qstep").len(), 250);
    // Both motors step forwards from the first step on: port A and the high nibble of port C change together.
    let (a, c) = (changes(&trace, "port_a"), changes(&trace, "port_c"));
    let levels = |bytes: &[(u64, String)]| bytes.iter().map(|it| it.1.clone()).collect::<Vec<_>>();
    let times = |bytes: &[(u64, String)]| bytes.iter().map(|it| it.0).collect::<Vec<_>>();
    assert_eq!((a.len(), times(&a)), (500, times(&c)));
    assert_eq!(levels(&a)[..3], ["b00000011", "b00000001", "b00000011"]);
    assert_eq!(levels(&c)[..3], ["b00110000", "b00010000", "b00110000"]);
    assert!(changes(&traced(sim(|_| ()), "MX,1\n", Vec::new()), "port_c").is_empty());
    assert!(rises(&traced(sim(|_| ()), "MX,1\n", Vec::new()), "qstep").is_empty());
}

#[test]
fn pro_io_outa() {
    // A diagonal steps both motors in the same tick.
    let trace = traced(sim(|_| ()), "M2,1,1\n", Vec::new());
    assert_eq!(rises(&trace, "xstep"), rises(&trace, "ystep"));
    let bytes = changes(&trace, "port_a");
    let levels: Vec<&str> = bytes.iter().map(|it| it.1.as_str()).collect();
    assert_eq!(levels[..3], ["b00001111", "b00000101", "b00001111"]);
    assert_eq!(bytes.len(), 500, "a change where the steps of both rise, and where they fall");
}

#[test]
fn switches_and_inputs_are_in_the_trace() {
    let inputs = vec![Change { input: 3, at_s: 0.5, on: true }];
    let trace = traced(sim(|_| ()), "SO,2,1\nPAUSE 1\nSO,2,0\n", inputs);
    assert_eq!(changes(&trace, "out2"), [(0, "1".into()), (1_000_000_000, "0".into())]);
    assert_eq!(rises(&trace, "in3"), [500_000_000]);
}

#[test]
fn times_never_go_back() {
    let trace =
        traced(sim(|_| ()), "SO,1,1\nM3,5,6,-1\nSO,1,0\nMX,0\nPAUSE 1\nSO,1,1\n", Vec::new());
    let times: Vec<u64> =
        trace.lines().filter_map(|line| line.strip_prefix('#')?.parse().ok()).collect();
    assert!(times.is_sorted() && times.len() > 1000);
}

#[test]
fn pro_io_vcd__every_bit_has_a_signal() {
    let trace = traced(sim(|_| ()), "", Vec::new());
    let names = kerf_machine::wiring::OUTPUT_BITS.iter().chain(kerf_machine::wiring::INPUT_BITS);
    for bit in names {
        assert!(trace.contains(&format!(" {} $end", bit.name)), "{}", bit.name);
    }
    assert!(trace.contains("intensity_byte $end") && trace.contains("laser_hz $end"));
}
