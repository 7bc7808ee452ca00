//! FC: a drawing, a picture or a G-code file becomes a part file beside it.

use crate::run::questions;
use crate::run::{Arguments, Context, Stop};
use kerf_diag::Code;
use kerf_program::settings::LinearUnit;
use kerf_program::{
    Answer, Button, Command, ConversionRequest, CutChoice, FileConversion, QuestionKind, decimal,
};

/// Converts a file; asks for what the host wants to know, one thing after the other, with the usual in the entry.
pub(super) fn convert(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    let name = a.text(0).unwrap_or_default().trim().to_string();
    if name.is_empty() {
        let hint = "FC, prog.nc converts prog.nc to prog.sbp";
        return Err(c.fail_at(c.span, Code::MissingParameter, "file name expected", hint));
    }
    c.settle()?;
    let mut request = ConversionRequest { name, ..ConversionRequest::default() };
    loop {
        let name = &request.name;
        match c.host.convert(&request).map_err(|e| c.refused(e))? {
            FileConversion::Made(path) => {
                let text = format!("{name} was converted to {path}").into();
                c.emit(Command::Message { text });
                return Ok(());
            }
            FileConversion::Unknown if request.kind.is_some() => {
                let (what, hint) = ("no such conversion", "DXF, HPGL, G-code or bitmap");
                return Err(c.fail_at(c.span, Code::NotSupported, format!("{name}: {what}"), hint));
            }
            FileConversion::Unknown => request.kind = Some(ask_kind(c, name)?),
            FileConversion::Exists(path) => {
                if !may_overwrite(c, &path)? {
                    return Ok(());
                }
                request.overwrite = true;
            }
            FileConversion::Unit(usual) => request.unit = Some(ask_unit(c, name, usual)?),
            FileConversion::Cut(usual) => {
                let unit = request.unit.unwrap_or(c.settings().linear_unit);
                request.cut = Some(ask_cut(c, name, unit, usual)?);
            }
        }
    }
}

/// Asks for the kind of a file whose name does not say it.
fn ask_kind(c: &mut Context<'_>, name: &str) -> Result<String, Stop> {
    let question = questions::entry(c, format!("What is {name}? DXF, HPGL, G-code or bitmap"), "");
    Ok(questions::typed(c, &question)?.trim().to_ascii_lowercase())
}

fn may_overwrite(c: &mut Context<'_>, path: &str) -> Result<bool, Stop> {
    let text = format!("{path} is there already. Write over it?");
    let question = questions::question(c, QuestionKind::Msgbox, text, &[Button::No, Button::Yes]);
    Ok(c.ask(&question)? == Answer::Button(Button::Yes))
}

fn ask_unit(c: &mut Context<'_>, name: &str, usual: LinearUnit) -> Result<LinearUnit, Stop> {
    let text = format!("Which unit has {name}: in or mm?");
    let typed = questions::typed(c, &questions::entry(c, text, usual.symbol()))?;
    match typed.trim().to_ascii_lowercase().as_str() {
        "" => Ok(usual),
        "in" => Ok(LinearUnit::Inch),
        "mm" => Ok(LinearUnit::Mm),
        _ => Err(wrong(c, &typed, "answer in or mm")),
    }
}

/// Depth, safe height, scale, what is deepest: as many of them as the file has to do with.
fn ask_cut(
    c: &mut Context<'_>,
    name: &str,
    unit: LinearUnit,
    usual: CutChoice,
) -> Result<CutChoice, Stop> {
    let length = |mm: f64| decimal(mm / unit.mm(), 4);
    let mut words = vec![
        (format!("depth ({})", unit.symbol()), length(usual.depth_mm)),
        (format!("safe height ({})", unit.symbol()), length(usual.safe_mm)),
    ];
    words.extend(usual.scale.map(|scale| ("scale".into(), decimal(scale, 4))));
    words.extend(usual.white_deepest.map(|_| ("deepest: black or white".into(), "black".into())));
    let (names, values): (Vec<String>, Vec<String>) = words.into_iter().unzip();
    let names = names.join(", ");
    let question = questions::entry(c, format!("How is {name} cut? {names}"), values.join(", "));
    let typed = questions::typed(c, &question)?;
    read_cut(&typed, unit, usual).ok_or_else(|| {
        let hint = format!("answer {names}, with commas between them; numbers above 0");
        wrong(c, &typed, &hint)
    })
}

/// Reads what was typed; a blank is what is usual.
fn read_cut(typed: &str, unit: LinearUnit, usual: CutChoice) -> Option<CutChoice> {
    let mut words = typed.split(',').map(str::trim);
    let mut above_zero = |usual: f64, unit: f64| match words.next() {
        None | Some("") => Some(usual),
        Some(word) => {
            let number = word.parse::<f64>().ok().filter(|n| n.is_finite() && *n > 0.0)?;
            Some(number * unit)
        }
    };
    let depth_mm = above_zero(usual.depth_mm, unit.mm())?;
    let safe_mm = above_zero(usual.safe_mm, unit.mm())?;
    let scale = match usual.scale {
        Some(scale) => Some(above_zero(scale, 1.0)?),
        None => None,
    };
    let white_deepest = match usual.white_deepest {
        Some(usual) => Some(match words.next().unwrap_or_default().to_ascii_lowercase().as_str() {
            "" => usual,
            "white" => true,
            "black" => false,
            _ => return None,
        }),
        None => None,
    };
    words.next().is_none().then_some(CutChoice { depth_mm, safe_mm, scale, white_deepest })
}

fn wrong(c: &Context<'_>, typed: &str, hint: &str) -> Stop {
    c.fail_at(c.span, Code::Terminated, format!("FC cannot read the answer '{typed}'"), hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    const USUAL: CutChoice =
        CutChoice { depth_mm: 3.0, safe_mm: 12.0, scale: Some(1.0), white_deepest: Some(false) };

    #[test]
    fn blanks_are_usual_and_lengths_have_the_unit() {
        let read = |typed: &str, unit| read_cut(typed, unit, USUAL);
        assert_eq!(read("", LinearUnit::Mm), Some(USUAL));
        assert_eq!(read(" 3 , 12, 1, Black", LinearUnit::Mm), Some(USUAL));
        let deep = CutChoice { depth_mm: 50.8, white_deepest: Some(true), ..USUAL };
        assert_eq!(read("2,,,white", LinearUnit::Inch), Some(deep));
        let plain = CutChoice { scale: None, white_deepest: None, ..USUAL };
        assert_eq!(read_cut("3,12", LinearUnit::Mm, plain), Some(plain));
    }

    #[test]
    fn what_is_no_answer_is_refused() {
        for typed in ["deep", "0", "-3", "1,2,0", "1,2,3,grey", "1,2,3,black,5", "inf", "NaN"] {
            assert_eq!(read_cut(typed, LinearUnit::Mm, USUAL), None, "{typed}");
        }
    }
}
