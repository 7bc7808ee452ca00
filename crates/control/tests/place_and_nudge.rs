//! Place of a run, and nudging: requests of a console to a session.

use kerf_control::answers::Answers;
use kerf_control::{RunContext, Session, StopAt};
use kerf_files::MemoryDisk;
use kerf_journal::{RunOptions, Work};
use kerf_program::Axis;
use kerf_trace::{Event, RunStatus, Sink};
use kerf_workspace::Workspace;
use std::sync::Arc;

/// Notes every place where a run stands.
#[derive(Default)]
struct Watcher(Vec<RunStatus>);

impl Sink for Watcher {
    fn event(&mut self, _: &Event) {}

    fn run_status(&mut self, standing: &RunStatus) {
        self.0.push(standing.clone());
    }

    fn looks_at_status(&self) -> bool {
        true
    }
}

/// Runs `a.sbp`; `status:file line,file line` whenever that changes.
fn watch(files: &[(&str, &str)], options: RunOptions, stop_at_s: f64) -> Vec<String> {
    let mut workspace =
        Workspace::in_memory(MemoryDisk::new(files.iter().map(|(n, t)| (*n, t.as_bytes()))));
    let mut watcher = Watcher::default();
    let context = RunContext {
        sink: &mut watcher,
        operator: &mut Answers::default(),
        requests: &mut StopAt(stop_at_s),
        machine: kerf_control::simulated(),
    };
    let program = kerf_sbp::read(files[0].0.into(), files[0].1.as_bytes());
    Session::default().run(program, options, &mut workspace, context);
    let told = watcher.0.iter().map(|standing| {
        let files: Vec<String> =
            standing.files.iter().map(|f| format!("{} {}", f.file, f.line)).collect();
        format!("{}:{}", standing.status, files.join(","))
    });
    let mut told: Vec<String> = told.collect();
    told.dedup();
    told
}

#[test]
fn sbp_lang_line_display() {
    let files = [("a.sbp", "MX,1\nFP,b.sbp\nMX,3\n"), ("b.sbp", "MY,1\nMY,2\n")];
    let told = watch(&files, RunOptions::default(), f64::INFINITY);
    let expected = [
        "1:a.sbp 1",
        "1:a.sbp 2",
        "1:a.sbp 3,b.sbp 1",
        "1:a.sbp 3,b.sbp 2",
        "1:a.sbp 3,b.sbp 3",
        "1:a.sbp 3",
        "1:a.sbp 4",
        "0:",
    ];
    assert_eq!(told, expected);
}

#[test]
fn sbp_flow_pause_status() {
    for pause in ["PAUSE 2", "PAUSE", "PAUSE UNTIL 1,1"] {
        let told = watch(
            &[("a.sbp", &format!("MX,1\n{pause}\nMX,2"))],
            RunOptions::default(),
            f64::INFINITY,
        );
        let paused = told.iter().any(|t| t.starts_with("9:"));
        assert!(paused && told.last().unwrap() == "0:", "{pause}: {told:?}");
    }
    let told = watch(&[("a.sbp", "MX,1\nMX,2")], RunOptions::default(), f64::INFINITY);
    assert!(told.iter().all(|t| t.starts_with("1:") || t == "0:"), "{told:?}");
}

#[test]
fn previews_and_stops_are_flags() {
    let mut options = RunOptions::default();
    options.program.preview = true;
    let told = watch(&[("a.sbp", "MX,1\nMX,2")], options, f64::INFINITY);
    assert!(told.contains(&"3:a.sbp 1".into()), "{told:?}");
    let told = watch(&[("a.sbp", "MX,10")], RunOptions::default(), 1.0);
    assert_eq!(told.last().unwrap(), "16:");
}

/// The working and the base location of an axis, in.
fn places(session: &Session, axis: Axis) -> (f64, f64) {
    let m = &session.memory;
    let user = |place| m.settings.to_user(place)[axis];
    (user(m.frame.working(m.position)), user(m.frame.base(m.position)))
}

/// A session in which a program ran.
fn after(session: &mut Session, program: &str) -> Vec<Event> {
    let mut events = Vec::new();
    let context = RunContext {
        sink: &mut events,
        operator: &mut Answers::default(),
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let program = kerf_sbp::read("a.sbp".into(), program.as_bytes());
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    session.run(program, RunOptions::default(), &mut workspace, context);
    events
}

/// Moves the tool a little, as a page does.
pub fn nudge(session: &mut Session, axis: Axis, distance: f64) {
    let (errand, before) = (session.nudge(axis, distance).unwrap(), session.memory.position);
    let work = Work::Hand(errand, Arc::new(session.configuration()));
    let context = RunContext {
        sink: &mut (),
        operator: &mut Answers::default(),
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    session.run(work, RunOptions::default(), &mut workspace, context);
    session.nudged(before);
}

#[test]
fn sbp_cmd_mn() {
    let mut session = Session::default();
    after(&mut session, "M2,5,5\n");
    nudge(&mut session, Axis::X, 2.54);
    assert_eq!(places(&session, Axis::X), (5.0, 5.1));
    assert_eq!(places(&session, Axis::Y), (5.0, 5.0));
    let events = after(&mut session, "MX,6\n");
    assert!(events.iter().any(|e| matches!(e, Event::Move(m) if m.to.x == 6.0)));
    assert_eq!(places(&session, Axis::X), (6.0, 6.1), "what is cut next is shifted");
}

#[test]
fn sbp_cmd_mn_st() {
    let mut session = Session::default();
    after(&mut session, "M2,5,5\n");
    nudge(&mut session, Axis::X, 2.54);
    after(&mut session, "ST\n");
    assert_eq!(places(&session, Axis::X), (5.1, 5.1));
}

#[test]
fn a_nudge_stays_on_the_table() {
    let mut session = Session::default();
    session.memory.settings.limits.check = true;
    let before = session.memory.clone();
    let high_mm = before.settings.limits.high[Axis::X];
    let outside = session.nudge(Axis::X, high_mm + 1.0).unwrap_err();
    assert!(matches!(outside, kerf_control::Outside::Table(Axis::X, _)), "{outside}");
    assert_eq!(session.memory, before);
}

#[test]
fn sbp_file_fs_dialog() {
    let files = [("x/part.sbp", "MX,1"), ("main.sbp", "FP,part.sbp\nUV\n")];
    let disk = MemoryDisk::new(files.iter().map(|(name, text)| (*name, text.as_bytes())));
    let mut workspace = Workspace::in_memory(disk);
    workspace.enter(Some("nowhere")).unwrap_err();
    workspace.enter(Some("x")).unwrap();
    assert_eq!(kerf_workspace::parts::listing(&workspace).unwrap().files[0].name, "part.sbp");
    let mut events = Vec::new();
    let context = RunContext {
        sink: &mut events,
        operator: &mut Answers::default(),
        requests: &mut (),
        machine: kerf_control::simulated(),
    };
    let program = kerf_sbp::read("main.sbp".into(), files[1].1.as_bytes());
    Session::default().run(program, RunOptions::default(), &mut workspace, context);
    let shown =
        events.iter().any(|e| matches!(e, Event::Message { text, .. } if text.contains("FS,x,")));
    assert!(shown, "{events:?}");
}

#[test]
fn sbp_file_fs_mask() {
    let names = ["proj1.sbp", "proj12.sbp", "project.sbp", "readme.txt"];
    let listed = |program: &str| {
        let mut workspace =
            Workspace::in_memory(MemoryDisk::new(names.map(|name| (name, &b""[..]))));
        let (sink, operator) = (&mut Vec::<Event>::new(), &mut Answers::default());
        let context =
            RunContext { sink, operator, requests: &mut (), machine: kerf_control::simulated() };
        let program = kerf_sbp::read("main.sbp".into(), program.as_bytes());
        Session::default().run(program, RunOptions::default(), &mut workspace, context);
        let files = kerf_workspace::parts::listing(&workspace).unwrap().files;
        files.into_iter().map(|file| file.name).collect::<Vec<_>>()
    };
    assert_eq!(listed(""), names[..3]);
    assert_eq!(listed("FS,,*.*"), names);
    assert_eq!(listed("FS,,proj??.sbp"), ["proj12.sbp"]);
}

#[test]
fn sbp_cmd_sp_space() {
    // A console can tell what the space bar means: stop while a file runs, another view when not.
    let told = watch(&[("a.sbp", "SP\nMX,1\n")], RunOptions::default(), f64::INFINITY);
    assert!(told.contains(&"3:a.sbp 3".into()), "runs, and only draws: {told:?}");
    assert_eq!(told.last().unwrap(), "2:", "idle, still in preview");
}
