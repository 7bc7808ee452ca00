//! Two-letter commands: looked up in the table, their values read by the kind of each parameter.

use super::line::{Failed, Line, Read};
use super::{assign, expression};
use crate::syntax::expr::{Expr, ExprNode};
use crate::syntax::table::{CommandSpec, Default, Kind, ParamSpec};
use crate::syntax::tree::{Arg, ArgKind, ArgList, Span, Statement};
use kerf_diag::Code;

/// The values of a command; the cursor stands right behind its letters.
pub(super) fn command(
    l: &mut Line<'_, '_>,
    spec: &'static CommandSpec,
    start: usize,
) -> Read<Statement> {
    let head = l.span_from(start);
    if l.peek() == b',' {
        l.at += 1;
    }
    if spec.letters == "VV" {
        l.skip_blanks();
        if let sign @ (b'&' | b'$') = l.peek() {
            return assign::assignment(l, sign == b'$');
        }
    }
    let (args, read) = arguments(l, spec);
    if !l.second_command {
        check_required(l, spec, args, head)?;
    }
    read?;
    let span = Span { start: start as u32, end: l.end as u32 };
    Ok(Statement::Command { spec, args, span })
}

/// Every field up to the end of the code, trailing blank ones left out; and whether all of them
/// could be read.
fn arguments(l: &mut Line<'_, '_>, spec: &CommandSpec) -> (ArgList, Read<()>) {
    let mut args = l.file.program.args.begin();
    let mut read = Ok(());
    while !l.at_end() && !l.second_command {
        let span = l.field();
        l.at += 1;
        match spec.params.get(args.len()) {
            Some(param) => {
                let arg = argument(l, param, span).unwrap_or_else(|failed| {
                    read = Err(failed);
                    unreadable(span)
                });
                l.file.program.args.push(&mut args, arg);
            }
            None if span.start == span.end => {}
            None => {
                read = Err(surplus(l, spec, span));
                break;
            }
        }
    }
    l.at = l.end;
    l.file.program.args.trim(&mut args);
    (args, read)
}

fn argument(l: &mut Line<'_, '_>, param: &ParamSpec, span: Span) -> Read<Arg> {
    let kind = if span.start == span.end {
        ArgKind::Blank
    } else {
        match param.kind {
            Kind::Number(_) | Kind::NumberOrOff(_) | Kind::Whole | Kind::OneOf(_) => {
                ArgKind::Expr(expression::whole_expression(l, span)?)
            }
            Kind::Text => text_argument(l, span)?,
            Kind::File | Kind::Word(_) | Kind::AxisLetter | Kind::Obsolete => {
                computed_argument(l, span)?
            }
        }
    };
    Ok(match kind {
        ArgKind::Expr(Expr { node: ExprNode::Word(word), .. }) => {
            let word = l.file.program.expressions[word].clone();
            Arg { span, kind: ArgKind::Word(word) }
        }
        kind => Arg { span, kind },
    })
}

/// Words and file names are taken as written unless they begin like something computed.
fn computed_argument(l: &mut Line<'_, '_>, span: Span) -> Read<ArgKind> {
    let text = l.slice(span.start as usize, span.end as usize);
    if text.starts_with(['"', '&', '$', '%']) {
        return Ok(ArgKind::Expr(expression::whole_expression(l, span)?));
    }
    Ok(ArgKind::Word(text.into()))
}

/// Text is computed where all of it can be, and taken as written otherwise.
fn text_argument(l: &mut Line<'_, '_>, span: Span) -> Read<ArgKind> {
    let mark = l.mark();
    let computed = expression::whole_expression(l, span);
    let text = l.slice(span.start as usize, span.end as usize);
    match computed {
        Ok(expr) if !l.file.program.expressions.has_words(&expr) => return Ok(ArgKind::Expr(expr)),
        // A number and then a command: a comma or a line end was forgotten.
        Err(failed) if l.second_command && !text.starts_with(char::is_alphabetic) => {
            return Err(failed);
        }
        _ => {}
    }
    l.forget(mark);
    l.second_command = false;
    Ok(ArgKind::Word(text.into()))
}

/// A field behind the last parameter may only be blank.
fn surplus(l: &mut Line<'_, '_>, spec: &CommandSpec, span: Span) -> Failed {
    let takes = match spec.params.len() {
        0 => "no values".to_string(),
        1 => "1 value".to_string(),
        n => format!("{n} values"),
    };
    let message = format!("{} takes {takes}, this is one too many", spec.letters);
    l.fault(Code::TooManyParameters, span, message, "leave it out, or check the commas")
}

fn check_required(l: &mut Line<'_, '_>, spec: &CommandSpec, args: ArgList, head: Span) -> Read<()> {
    let mut result = Ok(());
    for (index, param) in spec.params.iter().enumerate() {
        let arg = l.file.program.args[args].get(index);
        let blank = arg.is_none_or(|a| a.kind == ArgKind::Blank);
        if blank && param.default == Default::Required {
            let message = format!("{} expected", param.name.to_lowercase());
            let span = arg.map_or(head, |a| a.span);
            let hint = format!("{} needs this value, it has no default", spec.letters);
            result = Err(l.fault(Code::MissingParameter, span, message, hint));
        }
    }
    result
}

/// Stands for an argument whose diagnostics are told already.
fn unreadable(span: Span) -> Arg {
    Arg { span, kind: ArgKind::Word("".into()) }
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn separators_follow_the_handbook() {
        for (text, tree) in [
            ("M2,  &a, 4.2", "M2 &A 4.2"),
            ("M2  &a, 4.2", "M2 &A 4.2"),
            ("M2\t&a,4", "M2 &A 4"),
            ("M2,, &a", "M2 _ &A"),
            ("M2 , &a", "M2 _ &A"),
            (
                "M2 ,, &a",
                "bad S009 1:7+2 M2 takes 2 values, this is one too many [leave it out, or check the commas]",
            ),
            ("M2, &a", "M2 &A"),
            ("M2 -&a,4", "M2 (-&A) 4"),
            ("m3,&a,,", "M3 &A"),
            ("ZX,", "ZX"),
            ("ZX , ,", "ZX"),
            ("  zx  'comment", "ZX"),
        ] {
            check(text, tree);
        }
    }

    #[test]
    fn too_many_and_too_few_values() {
        finds("ZX,1", &["S009 1:4+1 ZX takes no values, this is one too many"]);
        finds("MX,1,2", &["S009 1:6+1 MX takes 1 value, this is one too many"]);
        finds("MX,1,2,3", &["S009 1:6+1"]);
        finds("MX , 1", &["S009 1:6+1", "S010 1:1+2 value expected"]);
        finds("MX", &["S010 1:1+2 value expected"]);
        finds("MX,", &["S010 1:1+2 value expected"]);
    }

    #[test]
    fn vv_is_an_assignment() {
        check("VV,&a=5+1", "&A = (5 + 1)");
        check("vv $a := x", "$A := 'x'");
        finds("VV", &["S010 1:1+2 assignment expected"]);
    }

    #[test]
    fn one_command_a_line() {
        finds("MX,1 MY,2", &["S013 1:6+2 a second command"]);
        finds("MD,10,90 MX,1", &["S013 1:10+2 a second command"]);
        finds("M2,&a,1 GOTO X", &["S013 1:9+6 a second command"]);
        finds(
            "MX,1 ; up",
            &["S004 1:6+4 '; up' does not belong here [a comment begins with an apostrophe]"],
        );
        finds(
            "IF 1=1 THEN MX,1 ELSE JX,2",
            &[
                "S004 1:18+7 'ELSE JX' does not belong here [there is no ELSE: write another IF",
                "S009 1:26+1",
            ],
        );
        finds("M2 3 4", &["S004 1:6+1 '4' does not belong here [values are separated by commas]"]);
    }
}
