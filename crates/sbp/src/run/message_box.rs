//! MSGBOX: a box with buttons, its answer in `&msganswer` (handbook, MSGBOX; readings, A-39, A-40).

use super::{Context, Stop, questions};
use crate::Value;
use crate::tree::MsgBox;
use kerf_diag::Code;
use kerf_program::{Answer, Button, Question, QuestionKind};

/// Names of the styles; a style is the sum of buttons, icon and default button.
const WORDS: [(&str, u32); 10] = [
    ("OKOnly", 0),
    ("OKCancel", 1),
    ("AbortRetryIgnore", 2),
    ("YesNoCancel", 3),
    ("YesNo", 4),
    ("RetryCancel", 5),
    ("Critical", 16),
    ("Question", 32),
    ("Exclamation", 48),
    ("Information", 64),
];

/// The buttons of styles 0 … 5.
const BUTTONS: [&[Button]; 6] = [
    &[Button::OK],
    &[Button::OK, Button::Cancel],
    &[Button::Abort, Button::Retry, Button::Ignore],
    &[Button::Yes, Button::No, Button::Cancel],
    &[Button::Yes, Button::No],
    &[Button::Retry, Button::Cancel],
];

/// The variable that gets the word on the button.
const ANSWER: &str = "MSGANSWER";

/// Appearance of a box.
#[derive(Debug, PartialEq)]
struct Style {
    buttons: &'static [Button],
    icon: u16,
    default: usize,
}

impl Style {
    /// Any style that is not in the handbook's table is 0, a plain OK.
    fn read(text: &str) -> Self {
        let sum = text.split('+').map(number_or_word).sum::<Option<u32>>();
        sum.and_then(Self::of_number).unwrap_or(Self { buttons: BUTTONS[0], icon: 0, default: 0 })
    }

    /// Ones: buttons, 16s: icon, 256s: default button, the first when there are not as many.
    fn of_number(n: u32) -> Option<Self> {
        let buttons = BUTTONS.get((n % 16) as usize)?;
        let icon = (n / 16) % 16;
        let default = (n / 256) as usize;
        let known = icon <= 4 && default <= 3;
        known.then_some(Self {
            buttons,
            icon: (icon * 16) as u16,
            default: if default < buttons.len() { default } else { 0 },
        })
    }
}

fn number_or_word(text: &str) -> Option<u32> {
    let text = text.trim();
    if let Some((_, n)) = WORDS.iter().find(|(word, _)| word.eq_ignore_ascii_case(text)) {
        return Some(*n);
    }
    if text.is_empty() { Some(0) } else { text.parse::<u16>().ok().map(u32::from) }
}

/// Shows the box and keeps the answer.
pub(super) fn message_box(c: &mut Context<'_>, shown: &MsgBox) -> Result<(), Stop> {
    let text = questions::dialog_text(c, &shown.body)?;
    let style = Style::read(&questions::dialog_text(c, &shown.style)?);
    let question = Question {
        title: questions::dialog_text(c, &shown.title)?,
        default: style.default,
        icon: style.icon,
        ..questions::question(c, QuestionKind::Msgbox, text, style.buttons)
    };
    let pressed = match c.ask(&question)? {
        Answer::Button(button) => button.word().to_string(),
        Answer::Text(word) => word,
    };
    let known = style.buttons.iter().find(|b| b.word().eq_ignore_ascii_case(pressed.trim()));
    let Some(button) = known else {
        let words: Vec<_> = style.buttons.iter().map(|b| b.word()).collect();
        let message = format!("'{pressed}' is no button of this box");
        let hint = format!("answer {}", words.join(" or "));
        return Err(c.fail_at(c.span, Code::OutOfRange, message, hint));
    };
    c.core.memory.variables.set(ANSWER, Value::text(button.word()));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn styles_are_numbers_words_and_sums() {
        for (text, buttons, icon, default) in [
            ("", 0, 0, 0),
            (" yesno ", 4, 0, 0),
            ("276", 4, 16, 1),
            ("515", 3, 0, 2),
            ("771", 3, 0, 0),
            ("52", 4, 48, 0),
            ("YesNo + Critical+256", 4, 16, 1),
            ("64", 0, 64, 0),
            ("7", 0, 0, 0),
            ("999", 0, 0, 0),
            ("1025", 0, 0, 0),
            ("80", 0, 0, 0),
            ("-1", 0, 0, 0),
            ("1.5", 0, 0, 0),
            ("Maybe", 0, 0, 0),
        ] {
            let expected = Style { buttons: BUTTONS[buttons], icon, default };
            assert_eq!(Style::read(text), expected, "{text}");
        }
    }
}
