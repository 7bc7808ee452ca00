//! Area `timing`: the steps of a job, to the millisecond.

use kerf_ledger::jobs::{JobRun, JobTrace, line, t1, t2};
use kerf_machine::lines::Input;
use kerf_machine::settings::delays::BottomDelayType;

fn run(run: JobRun, edges: &[&str], moves: &[&str]) -> JobTrace {
    let trace = run.run();
    assert_eq!(trace.edges(), edges);
    assert_eq!(trace.moves(), moves);
    trace
}

/// Checks that a run shows these lines somewhere, in this order.
fn shows(run: JobRun, expected: &[&str]) {
    let trace = run.run();
    let told: Vec<String> = trace.edges().into_iter().chain(trace.moves()).collect();
    for event in expected {
        assert!(told.iter().any(|one| one == event), "{event} is missing in {told:#?}");
    }
}

const T1: [&str; 8] = [
    "0.000 job_running+",
    "0.300 router+",
    "2.300 tool1+",
    "3.840 cut1+",
    "5.940 cut1-",
    "6.690 tool1-",
    "7.190 router-",
    "7.890 job_running-",
];

const T1_MOVES: [&str; 5] = [
    "0.000-0.300 z-10",
    "2.800-3.840 z-30",
    "4.840-5.940 x100",
    "6.190-6.690 z-10",
    "7.190-7.890 x0",
];

#[test]
fn pro_timing_router() {
    run(JobRun::new(t1()), &T1, &T1_MOVES);
}

#[test]
fn pro_timing_step1() {
    shows(JobRun::new(t1()), &["0.000-0.300 z-10", "0.300 router+", "2.300 tool1+"]);
    // The way to the first shape is at z = 0.
    let away = JobRun::new(t1()).at(0.0, 30.0, -5.0).run();
    assert_eq!(away.moves()[..3], ["0.000-0.200 z0", "0.200-0.546 y0", "0.546-0.846 z-10"]);
}

#[test]
fn pro_timing_step2() {
    shows(JobRun::new(t1()), &["2.300 tool1+", "2.800-3.840 z-30"]);
}

#[test]
fn pro_timing_step3() {
    shows(JobRun::new(t1()), &["2.800-3.840 z-30"]);
}

#[test]
fn pro_timing_step4() {
    shows(JobRun::new(t1()), &["3.840 cut1+", "4.840-5.940 x100"]);
}

#[test]
fn pro_timing_step5() {
    shows(JobRun::new(t1()), &["4.840-5.940 x100"]);
}

#[test]
fn pro_timing_step6() {
    shows(JobRun::new(t1()), &["5.940 cut1-", "6.190-6.690 z-10"]);
}

#[test]
fn pro_timing_step7() {
    shows(JobRun::new(t1()), &["6.190-6.690 z-10", "6.690 tool1-", "7.190 router-"]);
}

const T2: [&str; 12] = [
    "0.000 job_running+",
    "0.300 router+",
    "2.300 tool1+",
    "3.840 cut1+",
    "5.940 cut1-",
    "6.690 tool1-",
    "7.640 tool1+",
    "9.180 cut1+",
    "11.280 cut1-",
    "12.030 tool1-",
    "12.530 router-",
    "12.980 job_running-",
];

const T2_MOVES: [&str; 9] = [
    "0.000-0.300 z-10",
    "2.800-3.840 z-30",
    "4.840-5.940 x100",
    "6.190-6.690 z-10",
    "7.190-7.640 y50",
    "8.140-9.180 z-30",
    "10.180-11.280 x0",
    "11.530-12.030 z-10",
    "12.530-12.980 y0",
];

#[test]
fn pro_timing_step8() {
    run(JobRun::new(t2()), &T2, &T2_MOVES);
}

#[test]
fn pro_timing_step9() {
    let trace = run(JobRun::new(t1()), &T1, &T1_MOVES);
    assert_eq!(trace.states(), ["0.000 running", "7.890 idle"]);
    run(JobRun::new(t2()), &T2, &T2_MOVES);
}

#[test]
fn pro_timing_toolsel() {
    let tools = |job: &mut kerf_program::job::Job| {
        let mut shapes = job.shapes.to_vec();
        (shapes[1].tool, shapes[1].cut) = (2, 3);
        job.shapes = shapes.into();
    };
    let edges = JobRun::new(t2()).job(tools).run().edges();
    assert_eq!(edges[..5], T2[..5]);
    assert_eq!(edges[6..10], ["7.640 tool2+", "9.180 cut3+", "11.280 cut3-", "12.030 tool2-"]);
}

#[test]
fn pro_timing_bdel() {
    let pulse = JobRun::new(t1()).with(|machine| {
        machine.delays.bottom_type = BottomDelayType::Input;
        machine.delays.bottom_s = 0.2;
    });
    let pulse = pulse.input(Input::EndBottomDelay, 4.64, true);
    run(pulse.input(Input::EndBottomDelay, 4.65, false), &T1, &T1_MOVES);
}

#[test]
fn pro_timing_runpause() {
    let trace = JobRun::new(t1()).stop(5.34).run();
    let edges = trace.edges();
    let router: Vec<_> = edges.iter().filter(|edge| edge.contains("router")).collect();
    assert_eq!(router, ["0.300 router+", "5.440 router-"]);
    // Nobody is there: the job is given up, which alone ends it.
    assert_eq!(edges.last().map(String::as_str), Some("5.940 job_running-"));
}

#[test]
fn a_job_of_one_point_is_drilled() {
    let point = line(1, (10.0, 0.0), (10.0, 0.0));
    let edges = JobRun::new(kerf_ledger::jobs::job([point])).run().edges();
    assert!(edges.iter().any(|edge| edge.contains("cut1+")), "{edges:?}");
}
