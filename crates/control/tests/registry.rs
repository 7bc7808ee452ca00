//! The status byte and the bytes of switches, as another program reads them while a run goes on
//! (programming handbook, Registry Interface; readings, A-46).

use crate::taking_up::on_record;
use kerf_control::answers::Operator;
use kerf_control::{OperatorRequest, Requests, RunContext, Session};
use kerf_files::{Folders, MemoryDisk};
use kerf_journal::{INCOMING_FILE, Journal, Live, MIRROR_FILE, RunOptions};
use kerf_model::Change;
use kerf_program::Question;
use kerf_workspace::{Workspace, stored::Stored};
use std::cell::RefCell;
use std::fs;
use std::rc::Rc;
use std::time::Duration;
use tempfile::TempDir;

/// Registry as another program saw it, with the question that was open or the machine time that passed.
type Seen = Rc<RefCell<Vec<(String, Live)>>>;

/// Looks from outside whenever the operator is asked or time passes.
struct Onlooker {
    journal: Journal,
    seen: Seen,
    /// The operator stops here once, seconds.
    stop_s: f64,
}

impl Onlooker {
    fn look(&self, when: String) {
        self.seen.borrow_mut().push((when, self.journal.registry.live().unwrap()));
    }
}

impl Operator for Onlooker {
    fn answer(&mut self, question: &Question, _: u32) -> Option<String> {
        self.look(question.text.clone());
        question.buttons.iter().find(|b| b.word() == "Resume").map(|b| b.word().to_owned())
    }
}

impl Requests for Onlooker {
    fn take(&mut self, from_s: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        if to_s > from_s {
            // What moves does not wait for the record: it follows soon, as it would in the world.
            std::thread::sleep(Duration::from_secs_f64((to_s - from_s).min(0.02) / 4.0));
            self.look("passing".into());
        }
        (to_s > self.stop_s).then_some((self.stop_s.max(from_s), OperatorRequest::Stop))
    }

    fn heard(&mut self) {
        self.stop_s = f64::INFINITY;
    }
}

/// Runs a program and tells what another program sees of it.
fn seen(folder: &TempDir, program: &str, typed: bool, stop_s: f64) -> Vec<(String, Live)> {
    seen_of(folder, program, typed.then_some("FP,a.sbp\n"), stop_s)
}

/// The status while something that was typed moves.
fn seen_typed(folder: &TempDir, typed: &str, file: &str) -> Vec<u8> {
    let seen = seen_of(folder, file, Some(typed), f64::INFINITY);
    let moving = seen.into_iter().filter(|(_, live)| live.status & 32 != 0);
    moving.map(|(_, live)| live.status).collect()
}

fn seen_of(
    folder: &TempDir,
    program: &str,
    typed: Option<&str>,
    stop_s: f64,
) -> Vec<(String, Live)> {
    let (journal, _) = Journal::open(folder.path()).unwrap();
    let disk = MemoryDisk::new([("a.sbp", program.as_bytes())]);
    let folders = Folders::new("".into(), Vec::new(), Vec::new());
    let stored = Stored::of(journal.clone()).unwrap();
    let mut workspace = Workspace::new(Box::new(disk), folders, stored, folder.path().into());
    let looks = || Journal::open(folder.path()).unwrap().0;
    let all = Seen::default();
    let mut operator = Onlooker { journal: looks(), seen: all.clone(), stop_s: f64::INFINITY };
    let mut pace = Onlooker { journal: looks(), seen: all.clone(), stop_s };
    let text = typed.unwrap_or(program);
    let read = kerf_part::read("a.sbp".into(), text.as_bytes());
    let mut options = RunOptions {
        inputs: vec![
            Change { input: 1, at_s: 0.0, on: true },
            Change { input: 3, at_s: 0.0, on: true },
            Change { input: 12, at_s: 0.0, on: true },
        ],
        ..RunOptions::default()
    };
    options.program.typed = typed.is_some();
    let context = RunContext {
        sink: &mut (),
        operator: &mut operator,
        requests: &mut pace,
        machine: on_record(),
    };
    let mut session = Session::default();
    session.memory.settings.warning_s = 0.0;
    session.run_on_record(read, options, None, &mut workspace, context).unwrap();
    assert_eq!(looks().registry.live().unwrap(), Live::default(), "nothing runs any more");
    all.take()
}

fn status(program: &str, when: &str) -> u8 {
    let seen = seen(&tempfile::tempdir().unwrap(), program, false, f64::INFINITY);
    seen.iter().find(|(at, _)| at == when).expect(when).1.status
}

#[test]
fn sbp_ctl_reg_status() {
    assert_eq!(status("MX,5\n", "passing"), 33);
    let idle = Journal::open(tempfile::tempdir().unwrap().path()).unwrap().0;
    assert_eq!(idle.registry.live().unwrap().status, 0);
}

#[test]
fn sbp_ctl_reg_bit1() {
    assert_eq!(status("MX,1\nPAUSE 2\n", "passing") & 1, 1);
    assert_eq!(status("MSGBOX(Sure?)\n", "Sure?") & 1, 1, "also while it pauses");
    let folder = tempfile::tempdir().unwrap();
    let typed = seen(&folder, "MSGBOX(In a file)\n", true, f64::INFINITY);
    assert_eq!(typed[0].1.status & 1, 1, "a file that a typed line runs");
    // One stack, as most files are: it was read to its end long before it is made.
    for program in ["MX,2\nMX,3\nMX,1\n", "MSGBOX(Go?)\nMX,2\nMX,3\n", "JX,3\n"] {
        let folder = tempfile::tempdir().unwrap();
        let moving = seen(&folder, program, true, f64::INFINITY);
        let passing: Vec<u8> =
            moving.iter().filter(|(at, _)| at == "passing").map(|(_, live)| live.status).collect();
        assert!(!passing.is_empty(), "{program}");
        assert!(passing.iter().all(|status| status & 33 == 33), "{program}: {passing:?}");
    }
    let folder = tempfile::tempdir().unwrap();
    let held = seen(&folder, "MX,5\nMX,0\n", true, 1.0);
    let held = held.iter().find(|(at, _)| at.starts_with("Stopped")).expect("a hold");
    assert_eq!(held.1.status & 17, 17, "also while it is held");
}

/// Typed lines count as no file, also behind one.
#[test]
fn sbp_ctl_reg_bit1__typed_lines() {
    let folder = tempfile::tempdir().unwrap();
    let alone = seen_typed(&folder, "MX,2\n", "");
    assert!(alone.iter().all(|status| status & 1 == 0), "{alone:?}");
    let behind = seen_typed(&folder, "FP,a.sbp\nPAUSE .1\nMX,9\n", "MX,1\n");
    assert_eq!([behind[0] & 1, behind[behind.len() - 1] & 1], [1, 0], "{behind:?}");
}

#[test]
fn sbp_ctl_reg_bit2() {
    assert_eq!(status("SP\nMX,1\nMSGBOX(Drawn)\nSM\n", "Drawn"), 1 + 2 + 8);
    assert_eq!(status("MX,1\nMSGBOX(Made)\n", "Made"), 1 + 8);
}

#[test]
fn sbp_ctl_reg_bit2__at_rest() {
    let mut session = Session::default();
    let mut type_line = |line: &str| {
        let mut options = RunOptions::default();
        options.program.typed = true;
        let mut workspace = Workspace::in_memory(MemoryDisk::default());
        let context = RunContext {
            sink: &mut (),
            operator: &mut (),
            requests: &mut (),
            machine: on_record(),
        };
        session.run(
            kerf_part::read("typed".into(), line.as_bytes()),
            options,
            &mut workspace,
            context,
        );
        session.look(Live::at_rest).status
    };
    assert_eq!(["SP\n", "MX,3\n", "SM\n", "MX,1\n"].map(&mut type_line), [2, 2, 0, 0]);
}

#[test]
fn sbp_ctl_reg_bit8() {
    for program in ["MSGBOX(Wait)\n", "INPUT \"Wait\" &a\n", "'Wait\nPAUSE\n"] {
        assert_eq!(status(program, "Wait") & 8, 8, "{program}");
    }
    assert_eq!(status("PAUSE 2\n", "passing") & 8, 8);
    assert_eq!(status("MX,5\n", "passing") & 8, 0);
}

#[test]
fn sbp_ctl_reg_bit4() {
    let folder = tempfile::tempdir().unwrap();
    let seen = seen(&folder, "SK\nMX,1\n", false, f64::INFINITY);
    assert_eq!(seen[0].1.status & 4, 4, "{seen:?}");
    assert_eq!(seen.last().unwrap().1.status & 4, 0, "{seen:?}");
}

#[test]
fn sbp_ctl_reg_bit16() {
    let folder = tempfile::tempdir().unwrap();
    let seen = seen(&folder, "MX,5\nMX,0\n", false, 1.0);
    let held = seen.iter().find(|(at, _)| at.starts_with("Stopped")).expect("a hold");
    assert_eq!(held.1.status & 16, 16, "{seen:?}");
    assert_eq!(seen.last().unwrap().1.status & 16, 0, "resumed: {seen:?}");
}

#[test]
fn sbp_lim_stop_flag() {
    sbp_ctl_reg_bit16();
}

#[test]
fn sbp_ctl_reg_bit32() {
    assert_eq!(status("JX,5\n", "passing") & 32, 32);
    assert_eq!(status("PAUSE 2\n", "passing") & 32, 0);
    assert_eq!(status("MX,1\nMSGBOX(Stands)\n", "Stands") & 32, 0);
}

#[test]
fn sbp_ctl_reg_inputs() {
    let folder = tempfile::tempdir().unwrap();
    let seen = seen(&folder, "MX,1\nMSGBOX(Now)\n", false, f64::INFINITY);
    let values = seen.last().unwrap().1.values();
    assert_eq!((values[1], values[2]), (("InputSwitches", 5), ("InputSwitchesUpper", 8)));
}

#[test]
fn sbp_ctl_reg_outputs() {
    let folder = tempfile::tempdir().unwrap();
    let program = "SO,2,1\nSO,8,1\nSO,9,1\nSO,12,1\nMSGBOX(Now)\n";
    let seen = seen(&folder, program, false, f64::INFINITY);
    let values = seen.last().unwrap().1.values();
    assert_eq!((values[3], values[4]), (("OutPutSwitches", 130), ("OutPutSwitchesUpper", 9)));
}

#[test]
fn other_programs_read_and_write_text_files() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join(INCOMING_FILE), "ShopBot/UserData/uValue=17\n$DEPTH=.5\nnoise\n")
        .unwrap();
    let program = "PAUSE .1\nPAUSE .1\nGetUsrVal, &v\n$w := &v\nSO,3,1\nMX,1\n";
    seen(&folder, program, false, f64::INFINITY);
    assert!(!folder.path().join(INCOMING_FILE).exists(), "it was taken");
    let (journal, _) = Journal::open(folder.path()).unwrap();
    assert_eq!(journal.registry.value("$W").unwrap().as_deref(), Some("17"), "the program saw it");
    let text = fs::read_to_string(folder.path().join(MIRROR_FILE)).unwrap();
    assert!(text.starts_with("Status=0\n") && text.contains("\nuValue=17\n"), "{text}");
}
