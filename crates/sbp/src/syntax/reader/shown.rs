//! Trees and diagnostics as short text, for tests.

use crate::syntax::expr::{Expr, ExprId, ExprNode, Path, PathStep, UnaryOp};
use crate::syntax::tree::{
    Arg, ArgKind, Assigned, DialogText, NameId, Node, Output, Program, Separator, Statement,
    Target, TextPart,
};
use crate::syntax::{format_number, read};

/// Checks the tree of the last line of a text in a dialect.
#[track_caller]
pub(crate) fn check_as(dialect: crate::syntax::Dialect, text: &str, expected: &str) {
    let program =
        crate::syntax::read_as("t.sbp".into(), text.replace('⏎', "\n").as_bytes(), dialect);
    assert_eq!(node(&program, program.lines.len() - 1), expected, "{text}");
}

/// The last line of a text as a tree; for a bad line its diagnostics.
pub(crate) fn tree(text: &str) -> String {
    let program = read("t.sbp".into(), text.replace('⏎', "\n").as_bytes());
    let last = program.lines.len();
    node(&program, last - 1)
}

/// All diagnostics of a text: `code line:column+length message [hint]`.
pub(crate) fn findings(text: &str) -> Vec<String> {
    let program = read("t.sbp".into(), text.replace('⏎', "\n").as_bytes());
    program.diagnostics.iter().map(finding).collect()
}

pub(crate) fn finding(d: &kerf_diag::Diagnostic) -> String {
    let p = &d.place;
    let hint = if d.hint.is_empty() { String::new() } else { format!(" [{}]", d.hint) };
    format!("{} {}:{}+{} {}{hint}", d.code, p.line, p.column, p.length, d.message)
}

/// Checks the tree of the last line.
#[track_caller]
pub(crate) fn check(text: &str, expected: &str) {
    assert_eq!(tree(text), expected, "{text}");
}

/// Checks the diagnostics; each begins with what is expected.
#[track_caller]
pub(crate) fn finds(text: &str, expected: &[&str]) {
    let found = findings(text);
    let same = found.len() == expected.len()
        && found.iter().zip(expected).all(|(f, e)| f.starts_with(e) || f.contains(e));
    assert!(same, "{text}\n found {found:#?}\n expected {expected:#?}");
}

/// One line of a program as text.
pub(crate) fn node(program: &Program, index: usize) -> String {
    match program.lines[index].node {
        Node::Blank => "blank".into(),
        Node::Comment => "comment".into(),
        Node::Label(label) => {
            format!("label {}", program.label_name(program.labels[label as usize].name))
        }
        Node::Bad => {
            let line = index as u32 + 1;
            let found = program.diagnostics.iter().filter(|d| d.place.line == line).map(finding);
            format!("bad {}", found.collect::<Vec<_>>().join(" / "))
        }
        Node::Move { command, given, first } => {
            let kind = if command.jog { 'J' } else { 'M' };
            let axes = "XYZABC".chars().skip(command.first.into()).take(command.count.into());
            let name = if command.count == 1 { axes.collect() } else { command.count.to_string() };
            let mut at = first as usize;
            let mut values = String::new();
            for i in 0..command.count {
                values.push(' ');
                if given & (1 << i) == 0 {
                    values.push('_');
                } else {
                    values.push_str(&format_number(program.numbers[at]));
                    at += 1;
                }
            }
            format!("move {kind}{name}{values}")
        }
        Node::Statement(at) => statement(program, &program.statements[at as usize]),
    }
}

fn statement(p: &Program, s: &Statement) -> String {
    let e = |expr: &Expr| expression(p, expr);
    let o = |expr: &Option<Expr>| optional(p, expr.as_ref());
    match s {
        Statement::Command { spec, args, .. } => {
            let args = p.args[*args].iter().map(|a| format!(" {}", argument(p, a)));
            format!("{}{}", spec.letters, args.collect::<String>())
        }
        Statement::Assign { name, persistent, only_if_undefined, value, .. } => {
            let sign = if *persistent { '$' } else { '&' };
            let place = format!("{sign}{}", p.names[name.0 as usize]);
            assignment(p, &place, *only_if_undefined, value)
        }
        Statement::AssignMember { path, only_if_undefined, value, .. } => {
            let place = member(p, &p.expressions[*path]);
            assignment(p, &place, *only_if_undefined, value)
        }
        Statement::If { condition, then } => {
            format!("if {} then {}", e(condition), statement(p, then))
        }
        Statement::Goto(t) => jump(p, "goto", t),
        Statement::Gosub(t) => jump(p, "gosub", t),
        Statement::OnInput { switch, state, action } => {
            let action = action.as_ref().map_or("_".into(), |a| statement(p, a));
            format!("on {} {} {action}", e(switch), e(state))
        }
        Statement::Pause { seconds } => format!("pause {}", o(seconds)),
        Statement::PauseUntil { switch, state } => format!("until {} {}", e(switch), e(state)),
        Statement::Fail(text) => format!("fail {}", o(text)),
        Statement::Custom { number, .. } => format!("custom {}", e(number)),
        Statement::Gcode(text) => format!("gcode {text}"),
        Statement::Mention(_) => "mention".into(),
        other => outward(p, other),
    }
}

/// A statement that speaks to the operator, to files or to other programs.
fn outward(p: &Program, s: &Statement) -> String {
    let e = |expr: &Expr| expression(p, expr);
    let o = |expr: &Option<Expr>| optional(p, expr.as_ref());
    match s {
        Statement::Output(out) => output(p, out),
        Statement::Input(i) => {
            format!("input {} {}{}", o(&i.text), o(&i.default), names(p, &i.variables))
        }
        Statement::InputFile { file, variables, .. } => {
            format!("input #{}{}", e(file), names(p, variables))
        }
        Statement::MsgBox(b) => {
            let [body, style, title] = [&b.body, &b.style, &b.title].map(|text| dialog(p, text));
            format!("msgbox {body} {style} {title}")
        }
        Statement::Open { path, mode, number } => {
            format!("open {} {mode:?} {}", e(path), e(number))
        }
        Statement::Close(number) => format!("close {}", o(number)),
        Statement::Play(path) => format!("play {}", dialog(p, path)),
        Statement::Shell(shell) => {
            format!("shell {} {} {}", dialog(p, &shell.line), o(&shell.display), shell.wait)
        }
        Statement::Store { which, value, .. } => format!("{which:?} {}", dialog(p, value)),
        Statement::Fetch { which, variable, .. } => {
            format!("{which:?} &{}", p.names[variable.0 as usize])
        }
        Statement::Dialog(d) => {
            let variable = d.variable.map_or(String::new(), |n| names(p, &[n]));
            let word = |name: &str, x: &Option<Expr>| {
                x.as_ref().map_or(String::new(), |x| format!(" {name} {}", e(x)))
            };
            let (ok, cancel) = (word("ok", &d.ok), word("cancel", &d.cancel));
            format!("dialog {}{variable}{ok}{cancel}", e(&d.text))
        }
        Statement::Data { request, items } => {
            let items: String = items.iter().map(|i| format!(" {}", e(i))).collect();
            format!("data {}{items}", if *request { "request" } else { "send" })
        }
        other => format!("{other:?}").to_lowercase(),
    }
}

fn optional(p: &Program, expr: Option<&Expr>) -> String {
    expr.map_or("_".to_string(), |x| expression(p, x))
}

fn names(p: &Program, ids: &[NameId]) -> String {
    ids.iter().map(|n| format!(" &{}", p.names[n.0 as usize])).collect()
}

fn jump(p: &Program, word: &str, target: &Target) -> String {
    format!("{word} {} {:?}", p.label_name(target.label), p.line_of(target).unwrap_or(0))
}

fn assignment(p: &Program, place: &str, only_if_undefined: bool, value: &Assigned) -> String {
    let op = if only_if_undefined { ":=" } else { "=" };
    let value = match value {
        Assigned::Nothing => "nothing".into(),
        Assigned::Expr(x) => expression(p, x),
        Assigned::Text(t) => format!("'{t}'"),
    };
    format!("{place} {op} {value}")
}

fn output(p: &Program, out: &Output) -> String {
    let word = if out.write { "write" } else { "print" };
    let file = out.file.as_ref().map_or(String::new(), |f| format!(" #{}", expression(p, f)));
    let mode = if out.separator == Separator::Comma { ',' } else { ';' };
    let items: String = out.items.iter().map(|i| format!(" {}", expression(p, i))).collect();
    format!("{word}{file} {mode}{items}{}", if out.newline { "" } else { " ..." })
}

fn argument(p: &Program, arg: &Arg) -> String {
    match &arg.kind {
        ArgKind::Blank => "_".into(),
        ArgKind::Expr(expr) => expression(p, expr),
        ArgKind::Word(word) => format!("'{word}'"),
    }
}

fn dialog(p: &Program, text: &DialogText) -> String {
    match text {
        DialogText::Expr(expr) => expression(p, expr),
        DialogText::Parts(parts) => {
            let parts = parts.iter().map(|part| match part {
                TextPart::Literal(t) => t.to_string(),
                TextPart::Variable(name, written) => {
                    format!("{{{written}={}}}", p.names[name.0 as usize])
                }
            });
            format!("<{}>", parts.collect::<String>())
        }
    }
}

/// An expression with every operator in parentheses.
pub(crate) fn expression(p: &Program, expr: &Expr) -> String {
    let e = |id: &ExprId| expression(p, &p.expressions[*id]);
    match &expr.node {
        ExprNode::Number(n) => n.to_string(),
        ExprNode::Text(t) => format!("\"{}\"", p.expressions[*t]),
        ExprNode::Word(t) => format!("'{}'", p.expressions[*t]),
        ExprNode::Variable(name) => format!("&{}", p.names[name.0 as usize]),
        ExprNode::Persistent(name) => format!("${}", p.names[name.0 as usize]),
        ExprNode::System(index) => format!("%{}", e(index)),
        ExprNode::Unary(UnaryOp::Not, x) => format!("(NOT {})", e(x)),
        ExprNode::Unary(op, x) => {
            format!("({}{})", if *op == UnaryOp::Minus { '-' } else { '+' }, e(x))
        }
        ExprNode::Binary(op, a, b) => format!("({} {} {})", e(a), op.symbol(), e(b)),
        ExprNode::Member(path) => member(p, &p.expressions[*path]),
        ExprNode::Call(f, x) => {
            format!("{}[{}]", f.name(), x.as_ref().map_or(String::new(), e))
        }
    }
}

fn member(p: &Program, path: &Path) -> String {
    let sign = if path.persistent { '$' } else { '&' };
    let steps = path.steps.iter().map(|step| match step {
        PathStep::Index(index) => format!("[{}]", expression(p, index)),
        PathStep::BothUnits => "[]".into(),
        PathStep::Field(name) => format!(".{name}"),
    });
    format!("{sign}{}{}", p.names[path.name.0 as usize], steps.collect::<String>())
}
