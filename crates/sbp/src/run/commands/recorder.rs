//! What was typed is recorded and can be run again (readings, A-132).

use super::files;
use crate::run::Replay;
use crate::run::recorder;
use crate::run::{Arguments, Context, Stop};
use crate::syntax::table::act::Record;
use kerf_diag::Code;

/// Commands that can be run again or saved at most.
const MOST: usize = 100;

/// The file that RS writes when none is named.
const USUAL_FILE: &str = "SBTEMP.SBP";

/// Carries a command of the recorder out.
pub(super) fn run(c: &mut Context<'_>, act: Record, a: &Arguments) -> Result<(), Stop> {
    match act {
        Record::Switch(on) => recorder::set_recording(c.host, on),
        Record::PlayAll => return replay(c, None, 1),
        Record::Replay => return replay_last(c, a),
        Record::Save => return save(c, a),
        Record::Clear => recorder::forget_recorded(c.host),
    }
    Ok(())
}

fn replay_last(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let back = match a.text(0).as_deref().map(str::trim) {
        None | Some("") => Some(1),
        Some(all) if all.eq_ignore_ascii_case("a") => None,
        Some(count) => Some(counted(c, count)?),
    };
    let times = a.whole(1).unwrap_or(1);
    let Some(times) = u32::try_from(times).ok().filter(|n| *n > 0) else {
        return Err(c.fail_at(a.span(1), Code::OutOfRange, "repetitions begin at 1", ""));
    };
    replay(c, back, times)
}

fn save(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let back = a.whole(1).map(|n| counted(c, &n.to_string())).transpose()?;
    let lines = recorded(c, back)?;
    let name = a.text(0).map_or(USUAL_FILE.into(), |name| file_name(&name));
    recorder::save_recorded(c, &name, &lines)?;
    files::edit(c, &name)
}

fn counted(c: &Context<'_>, text: &str) -> Result<usize, Stop> {
    let count = text.parse::<usize>().ok().filter(|n| (1..=MOST).contains(n));
    count.ok_or_else(|| {
        let message = format!("1 to {MOST} commands back, or A for all, not '{text}'");
        c.fail(Code::OutOfRange, message)
    })
}

/// The last so many recorded lines, as many as there are and can be used.
fn recorded(c: &mut Context<'_>, back: Option<usize>) -> Result<Vec<String>, Stop> {
    let lines = recorder::recorded(c.host);
    if lines.is_empty() {
        return Err(c.fail(Code::NothingRecorded, "no commands are recorded"));
    }
    let first = lines.len().saturating_sub(back.unwrap_or(MOST));
    Ok(lines[first..].to_vec())
}

fn replay(c: &mut Context<'_>, back: Option<usize>, times: u32) -> Result<(), Stop> {
    let lines = recorded(c, back)?;
    recorder::replay(c, Replay { lines: &lines, times })
}

/// A name without an extension is that of a part file.
fn file_name(name: &str) -> String {
    let name = name.trim();
    let file = name.rsplit(['/', '\\']).next().unwrap_or(name);
    if file.contains('.') { name.into() } else { format!("{name}.sbp") }
}

#[cfg(test)]
mod tests {
    use crate::testing::{FakeHost, Ran, check, run_as};
    use crate::{Options, Session};
    use kerf_program::QuestionKind;

    /// Types lines, one after the other.
    fn type_in(lines: &[&str]) -> Ran {
        type_with(FakeHost::default(), Session::default(), lines)
    }

    fn type_with(mut host: FakeHost, mut session: Session, lines: &[&str]) -> Ran {
        let typed = || Options { typed: true, ..Options::default() };
        let (last, first) = lines.split_last().expect("a line");
        for line in first {
            let ran = run_as(line, host, session, typed());
            (host, session) = (ran.host, ran.session);
        }
        run_as(last, host, session, typed())
    }

    /// The recorded lines.
    fn list(ran: &Ran) -> String {
        ran.host.stored.get("Recorded").cloned().unwrap_or_default()
    }

    #[test]
    fn sbp_cmd_ra() {
        assert_eq!(list(&type_in(&["MX,1", "&a=2", "my,3 'up"])), "MX,1\nmy,3 'up");
        assert_eq!(list(&type_in(&["RI", "MX,1", "RA", "MX,2"])), "MX,2");
    }

    #[test]
    fn sbp_cmd_ri() {
        assert_eq!(list(&type_in(&["MX,1", "RI", "MX,2"])), "MX,1");
    }

    #[test]
    fn sbp_cmd_rz() {
        assert_eq!(list(&type_in(&["MX,1", "RZ"])), "");
        assert_eq!(list(&type_in(&["MX,1", "RZ", "MX,2"])), "MX,2", "recording goes on");
        assert_eq!(list(&type_in(&["RI", "RZ", "MX,2"])), "", "or stays off");
    }

    #[test]
    fn sbp_cmd_rp() {
        let ran = type_in(&["M2,1,1", "RZ", "SR", "MX,1", "MY,1", "M2,-1,-1", "RP"]);
        // SR, MX, MY and M2 once more.
        ran.ends_at(1.0, 1.0, 0.0);
        let ran = type_in(&["RZ", "SR", "MX,1", "MY,1", "RP"]);
        ran.ends_at(2.0, 2.0, 0.0);
    }

    #[test]
    fn sbp_cmd_rr() {
        let typed = ["RZ", "SR", "MX,1", "MY,1", "RR"];
        type_in(&typed).ends_at(1.0, 2.0, 0.0);
        type_in(&[&typed[..], &["RR,2,3"]].concat()).ends_at(4.0, 5.0, 0.0);
        check("RR,1,0", "error repetitions begin at 1");
        check("RR", "error no commands are recorded");
    }

    #[test]
    fn sbp_cmd_rr_all() {
        type_in(&["SR", "MX,1", "RR,A,20"]).ends_at(21.0, 0.0, 0.0);
        type_in(&["SR", "MX,1", "RR a,20"]).ends_at(21.0, 0.0, 0.0);
    }

    #[test]
    fn sbp_cmd_rr_max() {
        let mut lines = vec!["SR"];
        lines.extend(["MX,1"; 120]);
        let ran = type_in(&lines);
        assert_eq!(list(&ran).lines().count(), 100, "the last 100 are kept");
        let more = type_with(ran.host, ran.session, &["RR,101"]);
        more.fails_with("1 to 100");
        type_with(more.host, more.session, &["RR,A"]).ends_at(220.0, 0.0, 0.0);
    }

    #[test]
    fn sbp_cmd_rr_params() {
        type_in(&["&a=1", "SR", "RZ", "MX,&a*2", "&a=5", "RR"]).ends_at(12.0, 0.0, 0.0);
        let ran = type_in(&["RZ", "MX,12+11/16", "RI", "MX,0", "RP"]);
        ran.ends_at(12.6875, 0.0, 0.0);
    }

    #[test]
    fn sbp_cmd_rr_drill() {
        let lines = ["SA", "M3 1,1,.2", "SR", "RZ", "MZ -.45", "JZ .45", "JX 1.5", "RI", "RR A,20"];
        type_in(&lines).ends_at(32.5, 1.0, 0.2);
        let at_bottom = |m: &(_, [f64; 3])| (m.1[2] + 0.25).abs() < 1e-6;
        let holes: Vec<f64> =
            type_in(&lines).moves().into_iter().filter(at_bottom).map(|m| m.1[0]).collect();
        let expected: Vec<f64> = (1..=20).map(|i| 1.0 + 1.5 * f64::from(i)).collect();
        assert_eq!(holes, expected, "besides the first, typed by hand");
    }

    #[test]
    fn sbp_cmd_rs() {
        let ran = type_in(&["SA", "MX,1", "RS,holes"]);
        assert_eq!(ran.host.files["holes.sbp"], "SA\nMX,1\n");
        let asked = ran.host.asked.last().expect("a question");
        assert_eq!((asked.kind, asked.text.as_str()), (QuestionKind::Editor, "holes.sbp"));
    }

    #[test]
    fn sbp_cmd_rs_defaults() {
        let typed = ["MX,1", "MX,2", "MX,3", "MX,4"];
        let rs = |line| type_in(&[&typed[..], &[line]].concat());
        assert_eq!(rs("RS").host.files["sbtemp.sbp"], "MX,1\nMX,2\nMX,3\nMX,4\n");
        assert_eq!(rs("RS,a.txt,3").host.files["a.txt"], "MX,2\nMX,3\nMX,4\n");
        assert!(type_in(&["RS"]).error.is_some(), "nothing to save");
    }

    #[test]
    fn sbp_cmd_r_notrecorded() {
        assert_eq!(list(&type_in(&["MX,1", "RR", "RP", "RS"])), "MX,1");
        let file = run_as("MX,1⏎MX,2", FakeHost::default(), Session::default(), Options::default());
        assert_eq!(list(&file), "", "a part file is not typed");
    }
}
