//! OPEN, CLOSE, WRITE #, INPUT #.

use super::{host_with, run_files};
use crate::testing::{FakeHost, run, run_with};
use crate::{Session, Status};

/// Checks the text of a file after a run.
#[track_caller]
fn writes(text: &str, name: &str, expected: &str) {
    let ran = run(text);
    ran.ended(Status::Ok);
    assert_eq!(ran.host.files.get(name).map(String::as_str), Some(expected), "{text}");
}

/// Checks what lines between OPEN and CLOSE write.
#[track_caller]
fn line_is(text: &str, expected: &str) {
    let whole = format!("OPEN \"out.txt\" FOR OUTPUT AS #1 ⏎ {text} ⏎ CLOSE #1");
    writes(&whole, "out.txt", expected);
}

#[test]
fn sbp_io_open_output() {
    let text = "OPEN \"myfile.sbp\" FOR OUTPUT as #1 ⏎ WRITE #1; \"A\" ⏎ CLOSE #1";
    let first = run(text);
    let again = run_with(text, first.host, Session::default());
    assert_eq!(again.host.files["myfile.sbp"], "A\n");
    assert_eq!(again.order(), "open myfile.sbp, write myfile.sbp, close myfile.sbp");
}

#[test]
fn sbp_io_open_input() {
    run("MX,1 ⏎ OPEN \"none.txt\" FOR INPUT AS #1").fails_at(2, "cannot open none.txt");
    let ran = run_files("OPEN \"a.txt\" FOR INPUT AS #1 ⏎ INPUT #1, &a", &[("a.txt", "5")]);
    assert_eq!(ran.variable("a"), "5");
}

#[test]
fn sbp_io_open_append() {
    let text = "OPEN \"f.txt\" FOR APPEND AS #1 ⏎ WRITE #1; \"B\"";
    let ran = run_with(text, host_with(&[("f.txt", "A⏎")]), Session::default());
    assert_eq!(ran.host.files["f.txt"], "A\nB\n");
    writes(text, "f.txt", "B\n");
}

#[test]
fn sbp_io_open_number() {
    let all: Vec<_> = (1..=9).map(|n| format!("OPEN \"f{n}\" FOR OUTPUT AS #{n}")).collect();
    run(&all.join(" ⏎ ")).ended(Status::Ok);
    for number in ["10", "0"] {
        run(&format!("OPEN \"f\" FOR OUTPUT AS #{number}")).fails_at(1, "1 to 9");
    }
    for number in ["10", "0", "1.5"] {
        run(&format!("&n={number} ⏎ OPEN \"f\" FOR OUTPUT AS #&n")).fails_at(2, "1 to 9");
    }
    run("OPEN \"a\" FOR OUTPUT AS #1 ⏎ OPEN \"b\" FOR OUTPUT AS #1").fails_at(2, "already open");
    run("OPEN \"a\" FOR OUTPUT AS #1 ⏎ CLOSE #1 ⏎ OPEN \"b\" FOR OUTPUT AS #1").ended(Status::Ok);
}

#[test]
fn sbp_io_open_relative() {
    writes("OPEN \"myfolder\\myfile.sbp\" FOR OUTPUT as #1", "myfolder/myfile.sbp", "");
}

#[test]
fn sbp_io_open_variable() {
    writes("&f=\"out.txt\" ⏎ OPEN &f FOR OUTPUT AS #2", "out.txt", "");
    writes("&p=a ⏎ OPEN &p & \"\\out.txt\" FOR OUTPUT AS #2", "a/out.txt", "");
    run("OPEN &nothing FOR OUTPUT AS #2").fails_at(1, "file name expected");
}

#[test]
fn sbp_io_close_one() {
    let open = "OPEN \"a\" FOR OUTPUT AS #1 ⏎ OPEN \"b\" FOR OUTPUT AS #2 ⏎ CLOSE #1";
    run(&format!("{open} ⏎ WRITE #1; \"x\"")).fails_at(4, "file #1 is not open");
    writes(&format!("{open} ⏎ WRITE #2; \"x\""), "b", "x\n");
    run("CLOSE #3 ⏎ MX,1").ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_io_close_all() {
    let open = "OPEN \"a\" FOR OUTPUT AS #1 ⏎ OPEN \"b\" FOR OUTPUT AS #2 ⏎ CLOSE";
    for number in [1, 2] {
        run(&format!("{open} ⏎ WRITE #{number}; \"x\"")).fails_at(4, "is not open");
    }
}

#[test]
fn sbp_io_close_auto() {
    let open = "OPEN \"a\" FOR OUTPUT AS #1 ⏎ WRITE #1; \"x\"";
    for end in ["END", "ENDALL", "MX,\"no\"", "&n=1/0"] {
        let ran = run(&format!("{open} ⏎ {end}"));
        assert!(ran.host.open.is_empty(), "{end}");
        assert_eq!(ran.order(), "open a, write a, close a", "{end}");
    }
    // A nested file may open files for its caller.
    let ran = run_files("FP,open.sbp ⏎ WRITE #1; \"y\"", &[("open.sbp", open)]);
    assert_eq!(ran.host.files["a"], "x\ny\n");
}

#[test]
fn sbp_io_inputfile() {
    let data = [("data.txt", "1, abc ⏎ 2")];
    let text = "OPEN \"data.txt\" FOR INPUT AS #1 ⏎ INPUT #1, &a, &b ⏎ INPUT #1, &c";
    let ran = run_files(text, &data);
    let values = ["a", "b", "c"].map(|n| ran.variable(n));
    assert_eq!(values, ["1", "abc", "2"]);
    // Fields are taken in order, whatever the lines.
    let ran =
        run_files("OPEN \"data.txt\" FOR INPUT AS #1 ⏎ INPUT #1, &a ⏎ INPUT #1, &b, &c", &data);
    assert_eq!(["a", "b", "c"].map(|n| ran.variable(n)), ["1", "abc", "2"]);
    assert_eq!(ran.order(), "open data.txt, read data.txt, read data.txt, close data.txt");
}

#[test]
fn sbp_io_inputfile_eof() {
    let text = "OPEN \"d\" FOR INPUT AS #1 ⏎ INPUT #1, &a ⏎ INPUT #1, &d ⏎ MX,9";
    run_files(text, &[("d", "1")]).fails_at(3, "end of file on #1").ends_at(0.0, 0.0, 0.0);
}

#[test]
fn sbp_io_inputfile_quoted() {
    let ran = run_files("OPEN \"d\" FOR INPUT AS #1 ⏎ INPUT #1, &x, &y", &[("d", "\"a, b\",3")]);
    assert_eq!((ran.variable("x").as_str(), ran.variable("y").as_str()), ("a, b", "3"));
}

#[test]
fn a_file_is_read_or_written_as_it_was_opened() {
    run("OPEN \"a\" FOR OUTPUT AS #1 ⏎ INPUT #1, &x").fails_at(2, "not open for reading");
    let ran = run_files("OPEN \"a\" FOR INPUT AS #1 ⏎ WRITE #1, 2", &[("a", "1")]);
    ran.fails_at(2, "not open for writing");
    run("INPUT #4, &x").fails_at(1, "file #4 is not open");
    for (line, way) in [("INPUT #4, &x", "FOR INPUT AS #4"), ("WRITE #4; 1", "FOR OUTPUT AS #4")] {
        let hint = run(line).error.map(|e| e.hint).unwrap_or_default();
        assert!(hint.contains(way), "{line}: {hint}");
    }
}

#[test]
fn sbp_io_write_comma() {
    line_is("&someVar = 23.5 ⏎ Write #1, \"M2\", &someVar, &someVar", "M2, 23.5, 23.5\n");
}

#[test]
fn sbp_io_write_comma_inquotes() {
    line_is("WRITE #1, \"a,b\"", "a, b\n");
    let program = crate::read("t".into(), b"WRITE #1, \"a,b\"");
    assert!(program.diagnostics[0].hint.contains("semicolons"), "{:?}", program.diagnostics);
}

#[test]
fn sbp_io_write_semi() {
    line_is("&someVar=23.5 ⏎ Write #1; \"&myVar = \"; &someVar", "&myVar = 23.5\n");
}

#[test]
fn sbp_io_write_semi_commas() {
    line_is("&v=23.5 ⏎ Write #1; \"M2, \"; &v; \", \"; &v", "M2, 23.5, 23.5\n");
}

#[test]
fn sbp_io_write_nolf() {
    line_is("WRITE #1; \"A\"; ⏎ WRITE #1; \"B\"", "AB\n");
    line_is("WRITE #1, \"A\"; ⏎ WRITE #1, \"B\"", "AB\n");
}

#[test]
fn sbp_io_write_sysvar() {
    line_is("M2,1,2 ⏎ WRITE #1, %(1), %(2)*2", "1, 4\n");
}

#[test]
fn sbp_io_write_numfmt() {
    line_is("WRITE #1, 2.50, 1/3, 100000, 9999999", "2.5, 0.3333333, 100000, 9999999\n");
}

#[test]
fn sbp_io_write_undefined() {
    line_is("WRITE #1; &nope", "&nope\n");
}

#[test]
fn sbp_io_print_file() {
    line_is("PRINT #1, \"a\", \"b\"", "a     b\n");
}

#[test]
fn writing_waits_for_the_motion_before_it() {
    let host = FakeHost { busy: 2, ..FakeHost::default() };
    let text = "OPEN \"a\" FOR OUTPUT AS #1 ⏎ MX,1 ⏎ WRITE #1, %(1) ⏎ MX,2";
    let ran = run_with(text, host, Session::default());
    assert_eq!(ran.order(), "open a, 1, write a, 2, close a");
    assert_eq!(ran.host.files["a"], "1\n");
}
