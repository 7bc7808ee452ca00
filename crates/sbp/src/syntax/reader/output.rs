//! PRINT and WRITE: items and what joins them (handbook, "PRINT"; readings, A-31 to A-35).

use super::expression;
use super::line::{Line, Read};
use crate::syntax::expr::{BinaryOp, Expr, ExprNode};
use crate::syntax::tree::{Output, Separator, Span, Statement};
use kerf_diag::Code;

/// Items of one PRINT or WRITE; a bound for memory.
const MOST_ITEMS: usize = 1000;

/// The rest of PRINT, or of WRITE; the cursor stands behind the word.
pub(super) fn output(l: &mut Line<'_, '_>, write: bool) -> Read<Statement> {
    let file = if l.take(b'#') { Some(single_value(l)?) } else { None };
    if write && file.is_none() {
        let span = l.span_to_end();
        let hint = "write WRITE #1; \"text\" after OPEN ... AS #1";
        let message = "WRITE needs a file number";
        return Err(l.fault(Code::MissingParameter, span, message, hint));
    }
    let leading = [(b',', Separator::Comma), (b';', Separator::Semicolon)]
        .into_iter()
        .find_map(|(byte, separator)| l.take(byte).then_some(separator));
    let commas = has_outside_quotes(l, b',');
    let semicolons = has_outside_quotes(l, b';');
    let separator = leading.unwrap_or(match (commas, semicolons) {
        (Some(comma), Some(semicolon)) if comma > semicolon => Separator::Semicolon,
        (None, Some(_)) => Separator::Semicolon,
        _ => Separator::Comma,
    });
    let newline = !drop_last_semicolon(l);
    let items = match separator {
        Separator::Comma => comma_items(l, write, leading.is_some() || commas.is_some())?,
        Separator::Semicolon => semicolon_items(l)?,
    };
    Ok(Statement::Output(Output { file, write, items, separator, newline }))
}

fn has_outside_quotes(l: &Line<'_, '_>, byte: u8) -> Option<usize> {
    Some(l.until(l.at, byte)).filter(|at| *at < l.end)
}

/// A semicolon at the very end keeps the next text on the same line.
fn drop_last_semicolon(l: &mut Line<'_, '_>) -> bool {
    let mut at = l.at;
    loop {
        let semicolon = l.until(at, b';');
        if semicolon + 1 == l.end {
            l.end -= 1;
            return true;
        }
        if semicolon >= l.end {
            return false;
        }
        at = semicolon + 1;
    }
}

/// Items between semicolons; a comma between quotes is shown as it is.
fn semicolon_items(l: &mut Line<'_, '_>) -> Read<Vec<Expr>> {
    let mut items = Vec::new();
    while !l.at_end() {
        let stop = l.until(l.at, b';');
        while l.at < stop {
            let comma = l.until_within(l.at, stop, b',');
            item(l, comma, &mut items)?;
            if comma < stop {
                let span = Span { start: comma as u32, end: comma as u32 + 1 };
                items.push(expression::text_at(l, ",", span));
            }
            l.at = comma + 1;
        }
        l.at = stop + 1;
    }
    Ok(items)
}

/// Items between commas, those inside quotes included.
fn comma_items(l: &mut Line<'_, '_>, write: bool, split: bool) -> Read<Vec<Expr>> {
    if let Some(at) = has_outside_quotes(l, b';') {
        let span = Span { start: at as u32, end: at as u32 + 1 };
        let hint = "separate all items with semicolons, or all with commas";
        let message = "after a comma a semicolon may only be the last character";
        return Err(l.fault(Code::Syntax, span, message, hint));
    }
    let mut items = Vec::new();
    while !l.at_end() {
        let stop = l.field_end(l.at);
        let before = items.len();
        item(l, stop, &mut items)?;
        if items.len() == before && stop < l.end {
            items.push(expression::text_at(l, "", Span { start: stop as u32, end: stop as u32 }));
        }
        l.at = stop + 1;
    }
    if !split {
        return Ok(items);
    }
    let given = items.len();
    let items: Vec<Expr> = items.into_iter().flat_map(|item| split_at_commas(l, item)).collect();
    if write && items.len() > given {
        let span = Span { start: l.text.len() as u32, end: l.text.len() as u32 };
        let hint = "write WRITE #1; ... with semicolons to keep commas inside quotes";
        let message = "the commas inside the quotes separate items";
        l.warn(Code::DoubtfulSpelling, span, message, hint);
    }
    Ok(items)
}

/// An item of the comma form: text is cut at its commas, also within a join.
fn split_at_commas(l: &mut Line<'_, '_>, item: Expr) -> Vec<Expr> {
    match item.node {
        ExprNode::Text(written) if l.file.program.expressions[written].contains(',') => {
            let written = l.file.program.expressions[written].clone();
            written.split(',').map(|part| expression::text_at(l, part, item.span)).collect()
        }
        ExprNode::Binary(BinaryOp::Join, left, right) => {
            let (left, right) =
                (l.file.program.expressions[left], l.file.program.expressions[right]);
            let mut items = split_at_commas(l, left);
            let mut more = split_at_commas(l, right).into_iter();
            if let (Some(left), Some(right)) = (items.pop(), more.next()) {
                let span = Span { start: left.span.start, end: right.span.end };
                items.push(Expr { node: expression::join(l, BinaryOp::Join, left, right), span });
            }
            items.extend(more);
            items
        }
        node => vec![Expr { node, span: item.span }],
    }
}

/// The item up to a place; blank ones are left out.
fn item(l: &mut Line<'_, '_>, stop: usize, items: &mut Vec<Expr>) -> Read<()> {
    l.skip_blanks();
    let start = l.at.min(stop);
    l.at = stop;
    let span = l.span_from(start);
    if span.start >= span.end {
        return Ok(());
    }
    if items.len() >= MOST_ITEMS {
        let message = format!("more than {MOST_ITEMS} items");
        let hint = "use several lines; a semicolon at the end keeps them together";
        return Err(l.fault(Code::TooManyParameters, span, message, hint));
    }
    items.push(loosely_quoted(l, span).map_or_else(|| expression::whole_expression(l, span), Ok)?);
    Ok(())
}

/// Text with a stray quote inside, and the lone quote that some files print for an empty line.
fn loosely_quoted(l: &mut Line<'_, '_>, span: Span) -> Option<Expr> {
    let written = l.slice(span.start as usize, span.end as usize);
    let inner = written.strip_prefix('"')?;
    let odd = written.bytes().filter(|b| *b == b'"').count() % 2 == 1;
    let inner = inner.strip_suffix('"').or_else(|| inner.is_empty().then_some(inner))?;
    if !odd {
        return None;
    }
    let hint = "text begins and ends with one double quote";
    l.warn(Code::DoubtfulSpelling, span, "the quotes of this text do not match", hint);
    Some(expression::text_at(l, inner, span))
}

/// One value without operators.
pub(super) fn single_value(l: &mut Line<'_, '_>) -> Read<Expr> {
    l.skip_blanks();
    let start = l.at;
    let stop = match l.peek() {
        b'0'..=b'9' => l.word_end(start),
        b'&' | b'$' => l.word_end(start + 1),
        b'(' | b'%' => l.until(start, b')') + 1,
        _ => {
            let span = l.span_to_end();
            let hint = "file numbers are 1 to 9";
            return Err(l.fault(Code::Syntax, span, "a number is expected here", hint));
        }
    };
    let span = Span { start: start as u32, end: stop.min(l.end) as u32 };
    let value = expression::whole_expression(l, span);
    l.at = stop.min(l.end);
    value
}

#[cfg(test)]
mod tests {
    use super::super::shown::{check, finds};

    #[test]
    fn the_first_separator_decides() {
        for (text, tree) in [
            ("PRINT", "print ,"),
            ("PRINT \"Hello\"", "print , \"Hello\""),
            ("PRINT \"it's on\"", "print , \"it's on\""),
            ("PRINT it's on", "print , 'it'"),
            ("PRINT \"a\", \"b\", 3", "print , \"a\" \"b\" 3"),
            ("PRINT &firstvar, \" = 123,456 \"", "print , &FIRSTVAR \" = 123\" \"456 \""),
            ("PRINT \"a,b\"", "print , \"a,b\""),
            ("PRINT \"a\", \"b\";", "print , \"a\" \"b\" ..."),
            ("PRINT \"a\",,\"b\"", "print , \"a\" \"\" \"b\""),
            ("PRINT \"a\",", "print , \"a\""),
            ("PRINT &firstvar; \" = 123,456 \"", "print ; &FIRSTVAR \" = 123,456 \""),
            ("PRINT \"a\"; \"b\", \"c\"", "print ; \"a\" \"b\" \",\" \"c\""),
            ("PRINT \"A\";", "print ; \"A\" ..."),
            ("PRINT &x;", "print ; &X ..."),
            ("PRINT; \"Starting \" &tile", "print ; (\"Starting \" & &TILE)"),
            ("PRINT %(48); \"/\"; %(49)", "print ; %48 \"/\" %49"),
            (
                "PRINT \"Tool #\"; &in & \" at = \"; %(3)",
                "print ; \"Tool #\" (&IN & \" at = \") %3",
            ),
            ("PRINT \"X is: \", %(1) * -1", "print , \"X is: \" (%1 * -1)"),
            ("PRINT #1, \"a\", \"b\"", "print #1 , \"a\" \"b\""),
            ("Write #1, \"M2\", &v, &v", "write #1 , \"M2\" &V &V"),
            ("WRITE #1; \"&myVar = \"; &v", "write #1 ; \"&myVar = \" &V"),
            ("WRITE #1;\"&CLIP_X = \";&X10name", "write #1 ; \"&CLIP_X = \" &X10NAME"),
            ("WRITE #&n; \"A\";", "write #&N ; \"A\" ..."),
            ("WRITE #1, %(1), %(2)*2", "write #1 , %1 (%2 * 2)"),
            ("WRITE #1, \"a,b\"", "write #1 , \"a\" \"b\""),
            ("WRITE #1, \"a,b\" & &c", "write #1 , \"a\" (\"b\" & &C)"),
        ] {
            check(text, tree);
        }
    }

    #[test]
    fn mistakes_in_output() {
        for (text, finding) in [
            (
                "PRINT \"a\", \"b\"; \"c\"",
                "S004 1:15+1 after a comma a semicolon may only be the last character",
            ),
            ("WRITE \"a\"", "S010 1:7+3 WRITE needs a file number"),
            ("WRITE #; \"a\"", "S004 1:8+5 a number is expected here"),
            (
                "WRITE #1, \"a,b\"",
                "W003 1:16+0 the commas inside the quotes separate items [write WRITE #1; ... with semicolons",
            ),
            ("PRINT \"open", "S005 1:7+5 a quote is not closed"),
            ("PRINT \"a 1/4\" rod\"", "W003 1:7+12 the quotes of this text do not match"),
            ("PRINT 3*", "S007 1:8+1"),
            (&format!("PRINT {}", "1;".repeat(2000)), "S009 1:2007+1 more than 1000 items"),
        ] {
            finds(text, &[finding]);
        }
        check("PRINT \"a 1/4\" rod\"", "print , \"a 1/4\" rod\"");
        check("PRINT \"", "print , \"\"");
    }
}
