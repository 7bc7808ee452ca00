//! Checking a part file without a machine: everything that can be said about it and the files it
//! names, and what a dry run finds.

use kerf_control::answers::Operator;
use kerf_control::{RunContext, Session};
use kerf_diag::{Code, Diagnostic, Repetitions, Severity, SourcePlace};
use kerf_journal::{LimitPolicy, RunOptions, Work};
use kerf_part::Program;
use kerf_program::settings::LinearUnit;
use kerf_program::{FileRequest, HostError, SourceFile};
use kerf_sbp::{Language, NamedFile};
use kerf_trace::{Event, Sink, Summary};
use kerf_workspace::Workspace;
use std::collections::VecDeque;
use std::sync::Arc;

/// Checks a program.
///
/// The program and every file it names is read once, also where a run would not come. A program
/// without errors is then run as a preview; `workspace` has to be one for previews. Branches that are not
/// taken are not explored.
pub fn check(
    session: &Session,
    work: impl Into<Work>,
    options: RunOptions,
    workspace: &mut Workspace,
    operator: &mut dyn Operator,
) -> Checked {
    let mut findings = Findings::default();
    let program = match work.into() {
        Work::Part(program) => *program,
        job @ (Work::Job(..) | Work::Hand(..)) => {
            let context = RunContext {
                sink: &mut findings,
                operator,
                requests: &mut (),
                machine: kerf_control::simulated(),
            };
            let summary = session.clone().run(job, options, workspace, context);
            return findings.checked(Some(summary));
        }
    };
    let good = !program.has_errors();
    findings.follow(&program, session.memory.settings.linear_unit, workspace);
    let gcode = program.language() == Language::Gcode;
    let summary = (good || gcode).then(|| {
        let mut session = session.clone();
        let context = RunContext {
            sink: &mut findings,
            operator,
            requests: &mut (),
            machine: kerf_control::simulated(),
        };
        let mut options = RunOptions { limits: LimitPolicy::List, ..options };
        options.program.preview = true;
        // What of a block of G-code is wrong shows only when it is carried out: the next ones are
        // tried all the same.
        options.gcode.keep_going = true;
        options.program.allow_errors |= gcode;
        session.run(program, options, workspace, context)
    });
    findings.checked(summary)
}

/// Result of a check.
#[derive(Debug)]
pub struct Checked {
    /// Everything wrong or doubtful: file by file in the order in which they were read, each in order
    /// of lines.
    pub diagnostics: Vec<Diagnostic>,
    /// Summary of the dry run; nothing when the file has errors.
    pub summary: Option<Summary>,
}

/// Findings of a check so far.
#[derive(Default)]
struct Findings {
    list: Vec<Diagnostic>,
    /// Names of the files that were read, in order.
    files: Vec<Arc<str>>,
    /// Findings of the dry run that come again and again.
    again: Repetitions,
    /// 0 stands for an answer since.
    sampled: bool,
}

impl Findings {
    /// Returns the findings; a run with errors has no summary.
    fn checked(mut self, summary: Option<Summary>) -> Checked {
        self.list.extend(self.again.diagnostics());
        let summary = summary.filter(|_| !self.list.iter().any(Diagnostic::is_error));
        Checked { diagnostics: self.sorted(), summary }
    }

    /// Reads a program, started on a machine in a unit, and everything it names.
    fn follow(&mut self, program: &Program, unit: LinearUnit, workspace: &mut Workspace) {
        let mut waiting: VecDeque<NamedFile> = self.read(program, Some(unit), workspace).into();
        while let Some(named) = waiting.pop_front() {
            let Ok(source) = find(workspace, &named.request) else { continue };
            if !self.files.contains(&source.name) {
                let program = kerf_part::read_as(source.name, &*source.bytes, program.sbp.dialect);
                waiting.extend(self.read(&program, None, workspace));
            }
        }
    }

    /// Takes over what is wrong with one file; gives the files it names.
    fn read(
        &mut self,
        program: &Program,
        alone: Option<LinearUnit>,
        workspace: &mut Workspace,
    ) -> Vec<NamedFile> {
        self.files.push(program.name().clone());
        program.diagnostics.iter().for_each(|d| self.add(d));
        kerf_sbp::check(&program.sbp, alone).iter().for_each(|d| self.add(d));
        let named = program.sbp.named_files();
        if !program.sbp.changes_folder() {
            for file in &named {
                if let Err(HostError::NotFound(message)) = find(workspace, &file.request) {
                    self.missing(program, file.line, message);
                }
            }
        }
        named
    }

    /// A file that is not there is an error only where a run comes to it.
    fn missing(&mut self, program: &Program, line: u32, message: String) {
        let place = SourcePlace::line(program.name().clone(), line);
        let diagnostic = Diagnostic::new(Code::FileNotFound, place, message);
        self.add(&diagnostic.severity(Severity::Warning));
    }

    /// Adds what is not known yet. The same at the same line but worse takes the place of the milder.
    fn add(&mut self, new: &Diagnostic) {
        let same = |d: &&mut Diagnostic| {
            d.code == new.code && d.place.file == new.place.file && d.place.line == new.place.line
        };
        let known = self.list.iter_mut().filter(same);
        for known in known {
            if known.message == new.message {
                if new.severity < known.severity {
                    *known = new.clone();
                }
                return;
            }
        }
        self.list.push(new.clone());
    }

    /// Makes a warning of an error behind an answer that nobody gave: with the operator's it may well run.
    fn doubted(&self, found: &Diagnostic) -> Diagnostic {
        if !self.sampled || !found.is_error() {
            return found.clone();
        }
        let message = format!("{} (with 0 for what the operator answers)", found.message);
        Diagnostic { message, ..found.clone() }.severity(Severity::Warning)
    }

    fn sorted(mut self) -> Vec<Diagnostic> {
        let files = self.files;
        self.list.sort_by_key(|d| {
            let file = files.iter().position(|f| *f == d.place.file).unwrap_or(files.len());
            (file, d.place.line, d.place.column)
        });
        self.list
    }
}

impl Sink for Findings {
    fn event(&mut self, event: &Event) {
        if let Event::Diag(diagnostic) = event
            && self.again.is_new(diagnostic)
        {
            self.sampled |= diagnostic.code == Code::SampleAnswer;
            self.add(&self.doubted(diagnostic));
        }
    }

    fn looks_at_motion(&self) -> bool {
        false
    }
}

/// The file itself, or the one with `.sbp` added, as FP looks for it.
fn find(workspace: &mut Workspace, request: &FileRequest) -> Result<SourceFile, HostError> {
    workspace.source(request).or_else(|error| {
        let name = format!("{}.sbp", request.name);
        workspace.source(&FileRequest { name, ..request.clone() }).map_err(|_| error)
    })
}

#[cfg(test)]
#[allow(non_snake_case)] // rows and their variants
mod tests {
    use super::*;
    use kerf_files::MemoryDisk;

    fn check_text(files: &[(&str, &str)], expected: &[&str]) {
        let disk = MemoryDisk::new(files.iter().map(|(n, t)| (*n, t.as_bytes())));
        let (name, text) = files[0];
        let program = kerf_part::read(name.into(), text.as_bytes());
        let mut workspace = Workspace::in_memory(disk);
        let found =
            check(&Session::default(), program, RunOptions::default(), &mut workspace, &mut ());
        let found: Vec<String> = found
            .diagnostics
            .iter()
            .map(|d| format!("{}:{} {} {:?}", d.place.file, d.place.line, d.code, d.severity))
            .collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn files_that_are_named_are_read_once_also_when_not_reached() {
        let files = [
            ("a.sbp", "MX,1\nFP,b.sbp\nEND\nFP,c.sbp\nFP,d.sbp"),
            ("b.sbp", "MX,2\n"),
            ("c.sbp", "FP,b.sbp\nFP,a.sbp\nM23,1\n"),
        ];
        check_text(&files, &["a.sbp:4 W018 Note", "a.sbp:5 F001 Warning", "c.sbp:3 S002 Error"]);
    }

    #[test]
    fn a_dry_run_finds_what_reading_cannot() {
        check_text(&[("a.sbp", "&a=0\nMX,1/&a\n")], &["a.sbp:2 R003 Error"]);
        check_text(&[("a.sbp", "FP,none.sbp")], &["a.sbp:1 F001 Error"]);
    }

    #[test]
    fn every_bad_block_of_g_code_is_told() {
        let text = "G20 G1 X1 F60\nG777\nG2 X5 Y0 I1 J0\nG1 X1 X2\n#1=[1/0]\nG2 X1\n";
        let found = [2, 3, 4, 5, 6].map(|line| format!("a.nc:{line} "));
        let codes = ["G002", "R018", "G006", "R003", "G008"];
        let expected: Vec<String> =
            found.iter().zip(codes).map(|(at, code)| format!("{at}{code} Error")).collect();
        check_text(&[("a.nc", text)], &expected.iter().map(String::as_str).collect::<Vec<_>>());
    }

    #[test]
    fn every_move_outside_the_limits_is_told() {
        let text = "VL,0,10\nSF,1\nMX,12\nMX,5\nMX,-1\n";
        check_text(&[("a.sbp", text)], &["a.sbp:3 M001 Error", "a.sbp:5 M001 Error"]);
    }

    #[test]
    fn sbp_file_check__a_program_that_asks() {
        check_text(&[("a.sbp", "INPUT \"How deep?\" &d\nMZ,-&d\n")], &["a.sbp:1 W023 Note"]);
        check_text(&[("a.sbp", "INPUT \"xy\" &x,&y\nM2,&x,&y\n")], &["a.sbp:1 W023 Note"]);
        check_text(&[("a.sbp", "INPUT \"How deep?\":.5,&d\nMZ,-&d\n")], &[]);
        check_text(
            &[("a.sbp", "INPUT \"Passes?\" &n\nMZ,-1/&n\n")],
            &["a.sbp:1 W023 Note", "a.sbp:2 R003 Warning"],
        );
        let other = "&a=0\nMZ,1/&a\nINPUT \"?\" &n\n";
        check_text(&[("a.sbp", other)], &["a.sbp:2 R003 Error"]);
    }

    #[test]
    fn sbp_file_check__answers_beside_the_file() {
        let files: [(&str, &[u8]); 2] = [("a.sbp", b""), ("a.sbp.answers", b"# depth\n.5\n")];
        let workspace = Workspace::in_memory(MemoryDisk::new(files));
        let mut answers = kerf_control::answers::Answers::read(
            &workspace.answers_beside("a.sbp").unwrap_or_default(),
        );
        let text = b"INPUT \"How deep?\" &d\nMZ,-&d\n";
        let program = kerf_part::read("a.sbp".into(), text);
        let mut workspace = Workspace::in_memory(MemoryDisk::new(files));
        let options = RunOptions::default();
        let found = check(&Session::default(), program, options, &mut workspace, &mut answers);
        assert!(found.diagnostics.is_empty(), "{:?}", found.diagnostics);
        assert_eq!(found.summary.map(|s| s.tally.cut_mm.round()), Some(13.0));
    }

    #[test]
    fn a_file_with_errors_is_not_run() {
        check_text(&[("a.sbp", "&a=0\nM23,1\nMX,1/&a\n")], &["a.sbp:2 S002 Error"]);
    }
}
