//! The files a program names: what a checker reads too, also where the run never comes.

use crate::syntax::Dialect;
use crate::syntax::tree::{Arg, ArgKind, Node, Program, Statement};
use crate::syntax::{Expr, ExprNode};
use kerf_program::{FileRequest, Folder};
use std::sync::Arc;

/// A file that a line names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedFile {
    /// The line, from 1.
    pub line: u32,
    /// The file.
    pub request: FileRequest,
}

impl Program {
    /// Part files (FP, FG) and custom cuts (C#) whose names are written out, in order of lines. Names
    /// that are computed are left out.
    pub fn named_files(&self) -> Vec<NamedFile> {
        let lines = self.lines.iter().zip(1..);
        let named = lines.filter_map(|(node, line)| {
            let Node::Statement(index) = node.node else { return None };
            let statement = self.statements.get(index as usize)?;
            let request = statement.with_inner().find_map(|s| named(self, s))?;
            Some(NamedFile { line, request })
        });
        named.collect()
    }

    /// Returns `true` if a line changes the part folder (FS): names may then mean other files than at first.
    pub fn changes_folder(&self) -> bool {
        let changes =
            |s: &Statement| matches!(s, Statement::Command { spec, .. } if spec.letters == "FS");
        self.statements.iter().any(|s| s.with_inner().any(changes))
    }
}

fn named(program: &Program, statement: &Statement) -> Option<FileRequest> {
    match statement {
        Statement::Command { spec, args, .. } if matches!(spec.letters, "FP" | "FG") => {
            let name = literal_text(program, program.args[*args].first()?)?.trim().to_owned();
            Some(FileRequest { folder: Folder::Parts, name })
        }
        // Which file it is depends on whether there is a macro of FabMo.
        Statement::Custom { .. } if program.dialect == Dialect::Fabmo => None,
        Statement::Custom { number, .. } => {
            let ExprNode::Number(n) = number.node else { return None };
            Some(FileRequest { folder: Folder::Custom, name: format!("Custom{n}.sbc") })
        }
        _ => None,
    }
}

fn literal_text(program: &Program, arg: &Arg) -> Option<Arc<str>> {
    match &arg.kind {
        ArgKind::Word(word) => Some(word.clone()),
        ArgKind::Expr(Expr { node: ExprNode::Text(text) | ExprNode::Word(text), .. }) => {
            Some(program.expressions[*text].clone())
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use crate::syntax::read;

    fn check(text: &str, expected: &[(u32, &str)]) {
        let named = read("a.sbp".into(), text.as_bytes()).named_files();
        let named: Vec<_> = named.iter().map(|n| (n.line, n.request.name.as_str())).collect();
        assert_eq!(named, expected, "{text}");
    }

    #[test]
    fn files_that_are_written_out_are_found() {
        check("FP,a.sbp\nFP \"b c.sbp\",2", &[(1, "a.sbp"), (2, "b c.sbp")]);
        check("C#,90\nCN, 91\nC6", &[(1, "Custom90.sbc"), (2, "Custom91.sbc"), (3, "Custom6.sbc")]);
        check("IF &a = 1 THEN FP,x.sbp\nON INPUT(1,1) C9", &[(1, "x.sbp"), (2, "Custom9.sbc")]);
        check("&f = \"a.sbp\"\nFP,&f\nC#,&n\nMX,1", &[]);
    }
}
