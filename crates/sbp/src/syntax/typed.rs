//! The command line: what the operator types to be done at once.
//!
//! Commands and assignments can be typed. Statements (IF, GOTO, PRINT …) and labels make sense among
//! other lines only, so a line alone may not have them. Several lines together are a program (SI).

use crate::syntax::Program;
use crate::syntax::table::CommandSpec;
use crate::syntax::tree::{Node, Span, Statement};
use kerf_diag::{Code, Diagnostic};
use std::sync::Arc;

/// Reads what was typed.
pub fn read_typed(name: Arc<str>, text: &str) -> Program {
    let mut program = crate::syntax::read(name, text.as_bytes());
    if text.trim_end().lines().count() > 1 {
        return program;
    }
    let alone = program.lines.first().map(|line| line.node);
    if alone.is_some_and(|node| belongs_into_files(&program, node)) {
        let line = program.line_text(1);
        let span = Span { start: 0, end: line.trim_end().len() as u32 };
        let message = format!("'{}' can be used only in part files", line.trim());
        let hint = "type a command, as MX,1, or &NAME=VALUE; statements need lines around them";
        let diagnostic = Diagnostic::new(Code::OnlyInFiles, program.place(1, span), message);
        program.diagnostics.push(diagnostic.hint(hint));
    }
    program
}

fn belongs_into_files(program: &Program, node: Node) -> bool {
    match node {
        Node::Label(_) => true,
        Node::Statement(index) => {
            let statement = program.statements.get(index as usize);
            statement.is_some_and(|statement| {
                !matches!(
                    statement,
                    Statement::Command { .. }
                        | Statement::Assign { .. }
                        | Statement::Custom { .. }
                        | Statement::Gcode(_)
                )
            })
        }
        Node::Blank | Node::Comment | Node::Move { .. } | Node::Bad => false,
    }
}

impl Program {
    /// Returns `true` if a line of it changes what the machine is set to.
    pub fn sets_machine(&self) -> bool {
        self.statements.iter().any(sets_machine)
    }

    /// Returns `true` if no line of it can move or switch anything: values, speeds, modes, variables.
    pub fn moves_nothing(&self) -> bool {
        self.has_only(CommandSpec::moves_nothing)
    }

    /// Returns `true` if it moves and switches nothing, but may call the place where the tool stands by other numbers.
    pub fn names_places_at_most(&self) -> bool {
        self.has_only(|spec| spec.moves_nothing() || spec.names_place())
    }

    /// Returns `true` if every line of it is empty, an assignment, or a command that is one of those.
    fn has_only(&self, is_one: impl Fn(&CommandSpec) -> bool) -> bool {
        self.lines.iter().all(|line| match line.node {
            Node::Blank | Node::Comment => true,
            Node::Statement(index) => match self.statements.get(index as usize) {
                Some(Statement::Command { spec, .. }) => is_one(spec),
                Some(Statement::Assign { .. }) => true,
                _ => false,
            },
            Node::Label(_) | Node::Move { .. } | Node::Bad => false,
        })
    }
}

fn sets_machine(statement: &Statement) -> bool {
    match statement {
        Statement::Command { spec, .. } => spec.sets_machine(),
        Statement::If { then, .. } => sets_machine(then),
        Statement::OnInput { action: Some(action), .. } => sets_machine(action),
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(typed: &str, refused: bool) {
        let program = read_typed("typed".into(), typed);
        let codes: Vec<_> = program.diagnostics.iter().map(|d| d.code).collect();
        assert_eq!(codes.contains(&Code::OnlyInFiles), refused, "{typed}: {codes:?}");
    }

    #[test]
    fn sbp_lang_statement_keyboard() {
        for typed in ["MX,1", "&a=5", "C9", "VS,2", "VV", "'note", "", "SO,1,1\n"] {
            check(typed, false);
        }
        for typed in ["GOTO A", "IF 1 THEN MX,1", "PRINT 1", "A:", "PAUSE 2", "END", "RETURN"] {
            check(typed, true);
        }
        check("GOTO A\nMX,1\nA:\n", false);
    }

    #[test]
    fn lines_that_set_the_machine_are_known() {
        let sets = |typed: &str| read_typed("typed".into(), typed).sets_machine();
        for typed in ["VC,.375", "vs,2", "MS,1", "SF,0", "UR,mine", "MX,1\nIF &a = 1 THEN VR,,5"] {
            assert!(sets(typed), "{typed}");
        }
        for typed in ["MX,1", "VA,0", "&VC=1", "SR", "SO,1,1", "FP,a.sbp", "US,mine", "C9"] {
            assert!(!sets(typed), "{typed}");
        }
    }

    #[test]
    fn lines_that_name_the_place_at_most_are_known() {
        let names = |typed: &str| read_typed("typed".into(), typed).names_places_at_most();
        for typed in ["ZZ", "ZX\nVA,,,3", "VS,2", ""] {
            assert!(names(typed), "{typed}");
        }
        for typed in ["MZ,1", "ZZ\nMZ,1", "SO,1,1", "SK"] {
            assert!(!names(typed), "{typed}");
        }
    }

    #[test]
    fn lines_that_move_nothing_are_known() {
        let still = |typed: &str| read_typed("typed".into(), typed).moves_nothing();
        for typed in [
            "VC,.375",
            "vs,2",
            "MS,1",
            "JS,2",
            "SA",
            "SP",
            "SM",
            "&a=5",
            "VS,2\nVR,,5",
            "UV",
            "'x",
            "",
        ] {
            assert!(still(typed), "{typed}");
        }
        for typed in [
            "MX,1",
            "VA,0",
            "VN,,,3",
            "VO,1",
            "VH,,,,1",
            "SO,1,1",
            "TR,9000",
            "ZX",
            "SK",
            "FP,a.sbp",
            "UR,mine",
            "C9",
            "VS,2\nMX,1",
            "M3",
            "G1 X1",
            "RP",
            "VL,",
        ] {
            assert_eq!(still(typed), typed == "VL,", "{typed}");
        }
    }
}
