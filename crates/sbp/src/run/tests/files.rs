//! Files within files, folders, custom cuts.

use super::file_parameters::{path, tool_at};
use super::rig::Rig;
use super::{host_with, run_files};
use crate::run::GcodeDue;
use crate::testing::{run, run_with};
use crate::{Interpreter, Options, Session, Status};
use kerf_program::{Answer, Button, Command, QuestionKind};

#[test]
fn sbp_file_fp_name() {
    let files = [("mypart.sbp", "MX,1"), ("sub/part.sbp", "MX,2"), ("c:/sbparts/x.sbp", "MX,3")];
    for (call, x) in [
        ("FP, MYPART.SBP ", 1.0),
        ("FP MyPart.sbp", 1.0),
        ("FP, sub\\part.sbp", 2.0),
        ("FP,C:\\SbParts\\x.sbp", 3.0),
        ("FP,\"mypart.sbp\"", 1.0),
        ("&f=mypart.sbp ⏎ FP,&f", 1.0),
        ("&f=sub ⏎ FP,&f & \"\\part.sbp\"", 2.0),
        ("FP,mypart", 1.0),
        ("FP,sub/part", 2.0),
    ] {
        let ran = run_files(call, &files);
        ran.ended(Status::Ok);
        assert_eq!(path(&ran), [[x, 0.0, 0.0]], "{call}");
    }
    run("MX,1 ⏎ FP,none.sbp ⏎ MX,9").fails_at(2, "none.sbp").ends_at(1.0, 0.0, 0.0);
    run("FP,cut.nc").fails_at(1, "cut.nc");
}

#[test]
fn g_code_files_are_refused_honestly() {
    run_files("FP,cut.nc", &[("cut.nc", "G1 X1")]).fails_at(1, "G-code files cannot be run");
    run("G1 X1").fails_at(1, "G-code in a part file");
}

#[test]
fn g_code_is_due_when_the_program_has_begun() {
    let mut program = crate::read("cut.nc".into(), b"");
    program.language = crate::Language::Gcode;
    let interpreter = Interpreter::new(program, Session::default(), Options::default());
    let mut rig = Rig::of(interpreter, host_with(&[]));
    assert_eq!(rig.interpreter.gcode_due(), None);
    rig.step();
    assert_eq!(rig.interpreter.gcode_due(), Some(GcodeDue::File(0)));
}

#[test]
fn sbp_file_fp_last() {
    for call in ["FP", "FP,", "FP,,2"] {
        run_files(call, &[("a.sbp", "MX,1")]).fails_at(1, "file name expected");
    }
    run("FP,&nothing").fails_at(1, "&NOTHING has no value");
    run("&empty = ⏎ FP,&empty").fails_at(2, "file name expected");
}

#[test]
fn a_file_that_is_called_again_is_the_same_file() {
    let ran =
        run_files("FP,B ⏎ FP,C ⏎ FP,B", &[("b.sbp", "MX,1 ⏎ MX,0"), ("c.sbp", "MX,2 ⏎ MX,0")]);
    let moves = ran.commands.iter().filter(|c| matches!(c.command, Command::Line(_)));
    assert_eq!(moves.map(|c| c.at.file).collect::<Vec<_>>(), [1, 1, 2, 2, 1, 1]);
}

#[test]
fn sbp_file_nest_return() {
    run_files("MX,1 ⏎ FP,B ⏎ MX,5", &[("b.sbp", "MY,2")]).ended(Status::Ok).ends_at(5.0, 2.0, 0.0);
}

#[test]
fn a_repetition_begins_without_open_subroutines() {
    let file = "IF &n=1 THEN RETURN ⏎ &n=1 ⏎ GOSUB A ⏎ A: ⏎ END";
    run_files("&n=0 ⏎ FP,t.sbp,,,,2", &[("t.sbp", file)]).fails_at(1, "RETURN without GOSUB");
}

/// f1 calls f2 … up to the last, which moves.
fn chain(last: usize) -> Vec<(String, String)> {
    let file = |n: usize| match n {
        n if n == last => "MX,1".to_string(),
        n => format!("FP,f{}.sbp", n + 1),
    };
    (1..=last).map(|n| (format!("f{n}.sbp"), file(n))).collect()
}

#[test]
fn sbp_file_nest_depth() {
    let run_chain = |last| {
        let files = chain(last);
        let files: Vec<_> = files.iter().map(|(n, t)| (n.as_str(), t.as_str())).collect();
        run_files(files[0].1, &files)
    };
    run_chain(8).ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    let ran = run_chain(9);
    ran.fails_at(1, "nested deeper than 8").ends_at(0.0, 0.0, 0.0);
    let error = ran.error.unwrap();
    assert_eq!((&*error.place.file, error.callers.len()), ("f8.sbp", 7));
}

#[test]
fn sbp_file_nest_recursion() {
    let mut session = Session::default();
    session.settings.speeds.cut.xy = 10.0;
    let ran = run_with("FP,self.sbp", host_with(&[("self.sbp", "FP,self.sbp")]), session);
    ran.fails_at(1, "nested deeper than 8").ends_at(0.0, 0.0, 0.0);
    assert_eq!(ran.session.settings.speeds.cut.xy, 10.0);
}

#[test]
fn sbp_file_nest_subroutine() {
    let master = "&depth=-.5 ⏎ M2,1,0 ⏎ FP,drill.sbp ⏎ M2,2,0 ⏎ &depth=-.7 ⏎ FP,drill.sbp";
    let ran = run_files(master, &[("drill.sbp", "MZ,&depth ⏎ JZ,.5 ⏎ &holes=&holes & x")]);
    let holes: Vec<_> = path(&ran).into_iter().filter(|p| p[2] < 0.0).collect();
    assert_eq!(holes, [[1.0, 0.0, -0.5], [2.0, 0.0, -0.7]]);
    ran.ended(Status::Ok);
}

#[test]
fn sbp_file_error_line() {
    let ran = run_files("MX,1 ⏎ ⏎ ⏎ ⏎ FP,B.sbp", &[("b.sbp", "MX,2 ⏎ MX,1/0")]);
    let error = ran.error.unwrap();
    assert_eq!((&*error.place.file, error.place.line), ("B.sbp", 2));
    let callers: Vec<_> = error.callers.iter().map(|p| (&*p.file, p.line)).collect();
    assert_eq!(callers, [("test.sbp", 5)]);
}

#[test]
fn a_nested_file_with_errors_does_not_start() {
    let files = [("b.sbp", "FP,c.sbp"), ("c.sbp", "MX,2 ⏎ QQ,1 ⏎ M23,4")];
    let ran = run_files("MX,1 ⏎ FP,b.sbp", &files);
    ran.fails_at(2, "QQ").ends_at(1.0, 0.0, 0.0);
    assert!(ran.told().contains("M23"), "the second mistake is told too: {}", ran.told());
    let error = ran.error.unwrap();
    let callers: Vec<_> = error.callers.iter().map(|p| (&*p.file, p.line)).collect();
    assert_eq!(callers, [("b.sbp", 1), ("test.sbp", 2)]);
}

#[test]
fn warnings_of_a_nested_file_are_told_once() {
    let ran = run_files("FP,b.sbp ⏎ FP,b.sbp", &[("b.sbp", "GOTO A: ⏎ A: ⏎ MX,1")]);
    assert_eq!(ran.told().lines().count(), 1, "{}", ran.told());
}

#[test]
fn sbp_file_fg_params() {
    let spec = crate::table::find("FG").unwrap();
    let read = spec.params.iter().filter(|p| p.kind != crate::table::Kind::Obsolete);
    assert_eq!(read.count(), 9);
    let host = host_with(&[("part.sbp", "M2,1,1")]);
    let ran = run_with("FG,part.sbp,2,2,,,2", host, tool_at(10.0, 4.0, 0.0));
    ran.ended(Status::Ok).ends_at(12.0, 6.0, 0.0);
}

#[test]
fn sbp_file_fe_infile() {
    let ran = run("FE,notes.txt ⏎ MX,1");
    ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    let question = &ran.host.asked[0];
    assert_eq!((question.kind, question.text.as_str()), (QuestionKind::Editor, "notes.txt"));
    assert_eq!(question.buttons, [Button::OK]);
}

#[test]
fn fe_without_a_name_shows_the_last_file_and_fn_an_empty_page() {
    let ran = run_files("FE ⏎ FP,a.sbp ⏎ FE ⏎ FN", &[("a.sbp", "MX,1")]);
    let shown: Vec<_> = ran.host.asked.iter().map(|q| q.text.as_str()).collect();
    assert_eq!(shown, ["test.sbp", "a.sbp", ""]);
}

#[test]
fn sbp_file_fs_set() {
    assert_eq!(run("FS,C:\\SHOPBOT\\PARTS").host.folder, "C:\\SHOPBOT\\PARTS");
    assert_eq!(run("&f=doors ⏎ FS,&f").host.folder, "doors");
}

#[test]
fn sbp_file_fs_blank() {
    for line in ["FS", "FS,", "FS,,"] {
        assert_eq!(run(&format!("FS,x ⏎ {line}")).host.folder, "/", "{line}");
    }
}

#[test]
fn a_mask_alone_keeps_the_folder() {
    assert_eq!(run("FS,x ⏎ FS,,proj??.sbp").host.folder, "x");
    assert_eq!(run("FS,x,*.*").host.folder, "x");
}

#[test]
fn conversion_is_the_business_of_whoever_has_the_files() {
    run("FC,a.dxf").fails_at(1, "not converted here");
    run("FC").fails_at(1, "file name expected");
}

#[test]
fn sbp_ext_custom_cuts() {
    let files = [
        ("custom90.sbc", "MX,1"),
        ("custom6.sbc", "MY,2"),
        ("custom9.sbc", "MZ,3 ⏎ FP,n.sbp"),
        ("n.sbp", "MX,4"),
    ];
    for (call, x, y, z) in [
        ("C#,90", 1.0, 0.0, 0.0),
        ("CN, 90", 1.0, 0.0, 0.0),
        ("C6 'Spindle on", 0.0, 2.0, 0.0),
        ("&n=6 ⏎ CN,&n", 0.0, 2.0, 0.0),
        ("C9", 4.0, 0.0, 3.0),
    ] {
        run_files(call, &files).ended(Status::Ok).ends_at(x, y, z);
    }
    run("MX,1 ⏎ C7 ⏎ MX,9").fails_at(2, "Custom7.sbc");
    let ran = run("CN,90 ⏎ MX,1");
    ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    assert!(ran.told().contains("Custom90.sbc"), "{}", ran.told());
    run("CN,1.5").fails_at(1, "whole numbers");
}

#[test]
fn c9_is_a_tool_change_from_its_first_line_to_its_last() {
    let files = [("custom9.sbc", "MX,1 ⏎ FP,n.sbp"), ("n.sbp", "MX,2")];
    let ran = run_files("C9 ⏎ MX,3", &files);
    assert_eq!(ran.order(), "tool change true, 1, 2, tool change false, 3");
    let ran = run_files("C9", &[("custom9.sbc", "MX,1 ⏎ ENDALL")]);
    assert_eq!(ran.order(), "tool change true, 1, tool change false");
}

#[test]
fn sbp_file_temp_nested() {
    // The settings that a nested file changes hold for its caller: nothing is given back before
    // the outermost file ends.
    let ran = run_files("FP,a.sbp ⏎ MX,1", &[("a.sbp", "MS,4")]);
    let given: Vec<_> = ran
        .commands
        .iter()
        .filter_map(|c| match &c.command {
            Command::Settings(s) => Some(format!("{}", s.speeds.cut.xy / 25.4)),
            Command::Line(_) => Some("move".into()),
            _ => None,
        })
        .collect();
    assert_eq!(given, ["4", "move", "2"]);
}

#[test]
fn sbp_file_temp_settings() {
    let change = "VS,4 ⏎ VU,,,,,.2 ⏎ SF,1 ⏎ MX,1";
    for (end, status) in [
        ("END", Status::Ok),
        ("ENDALL", Status::Ended),
        ("&n=1/0", Status::Failed),
        ("PAUSE", Status::Stopped),
    ] {
        let mut host = host_with(&[]);
        host.answers = vec![Answer::Button(Button::Cancel)];
        let text = format!("{change} ⏎ &v=%(71) ⏎ {end}");
        let ran = run_with(&text, host, Session::default());
        ran.ended(status);
        let after = &ran.session.settings;
        assert_eq!(ran.variable("v"), "4");
        assert_eq!((after.speeds.cut.xy, after.limits.check), (50.8, false), "{end}");
        assert_eq!(after.resolution.circle_mm, 1.27, "{end}");
    }
}

#[test]
fn sbp_file_temp_others() {
    let ran = run("VC,.5 ⏎ SR");
    assert_eq!(ran.session.settings.cutter.diameter_mm, 12.7);
    run_with("MX,1 ⏎ MX,1", ran.host, ran.session).ends_at(2.0, 0.0, 0.0);
}
