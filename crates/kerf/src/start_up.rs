//! The start-up line: `file, port, open, timing, close, display, offset` (programming handbook,
//! Command Line Options; readings, A-119, A-120).

use kerf_workspace::system_log::Opening;

/// Items of a start-up line. Blank ones have their usual values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StartUp {
    /// The part file.
    pub file: String,
    /// The port to use from now on.
    pub port: Option<Port>,
    /// Action on the file.
    pub open: OpenMethod,
    /// Action at its end.
    pub close: CloseMethod,
    /// Display of the console: 0, 1, 2 or 9.
    pub display: u8,
    /// Offset of a file that runs at once: 0 none, 1 3D, 2 2D.
    pub offset: u8,
    /// The items as they were given, for the log.
    pub opening: Opening,
}

/// Connection of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Port {
    /// A port by its number, 1 … 16.
    Number(u8),
    /// The simulated machine.
    Sim,
}

/// Action on the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpenMethod {
    /// Its sheet is shown; nothing moves before OK (1).
    Sheet,
    /// The same in preview (2 and 3).
    SheetInPreview,
    /// It runs at once (4).
    Run,
    /// It is drawn at once (5).
    Preview,
    /// It becomes the current file (6).
    Current,
}

/// Action at the end of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CloseMethod {
    /// Kerf stays (0).
    Stay,
    /// Kerf asks, then closes (1).
    Ask,
    /// Kerf closes (2).
    Close,
}

impl StartUp {
    /// Reads a line. The file may stand in double quotes; a name with a comma has to.
    ///
    /// # Errors
    /// What is wrong with it, for the user.
    pub fn read(line: &str) -> Result<Self, String> {
        let items = items(line)?;
        let item = |i: usize| items.get(i).map_or("", String::as_str);
        if items.len() > 7 {
            return Err(format!("7 items at most, not {}: {line}", items.len()));
        }
        if item(0).is_empty() {
            return Err("the line begins with the part file".into());
        }
        let words = [1, 2, 3, 4, 5].map(|i| item(i).to_owned());
        Ok(Self {
            file: item(0).to_owned(),
            port: port(item(1))?,
            open: open_method(choice("open", item(2), &[1, 2, 3, 4, 5, 6], 1)?),
            close: close_method(choice("close", item(4), &[0, 1, 2], 0)?),
            display: choice("display", item(5), &[0, 1, 2, 9], 0)?,
            offset: choice("offset", item(6), &[0, 1, 2], 0)?,
            opening: Opening { file: true, words },
        })
    }
}

/// Splits a line at its commas; quotes hold a name with commas together.
fn items(line: &str) -> Result<Vec<String>, String> {
    let line = line.trim();
    let Some(quoted) = line.strip_prefix('"') else {
        return Ok(line.split(',').map(|item| item.trim().to_owned()).collect());
    };
    let (name, rest) = quoted.split_once('"').ok_or("the quote of the file name is not closed")?;
    let rest = rest.trim_start();
    let mut items = vec![name.trim().to_owned()];
    match rest.strip_prefix(',') {
        Some(rest) => items.extend(rest.split(',').map(|item| item.trim().to_owned())),
        None if rest.is_empty() => {}
        None => return Err(format!("a comma expected behind the file name, not '{rest}'")),
    }
    Ok(items)
}

fn port(text: &str) -> Result<Option<Port>, String> {
    match text {
        "" => Ok(None),
        sim if sim.eq_ignore_ascii_case("sim") => Ok(Some(Port::Sim)),
        number => match number.parse() {
            Ok(number @ 1..=16) => Ok(Some(Port::Number(number))),
            _ => Err(format!("port is 1 to 16, or sim, not '{text}'")),
        },
    }
}

fn choice(name: &str, text: &str, allowed: &[u8], usual: u8) -> Result<u8, String> {
    if text.is_empty() {
        return Ok(usual);
    }
    let value = text.parse().ok().filter(|value| allowed.contains(value));
    let allowed: Vec<String> = allowed.iter().map(u8::to_string).collect();
    value.ok_or_else(|| format!("{name} is one of {}, not '{text}'", allowed.join(", ")))
}

const fn open_method(number: u8) -> OpenMethod {
    match number {
        1 => OpenMethod::Sheet,
        4 => OpenMethod::Run,
        5 => OpenMethod::Preview,
        6 => OpenMethod::Current,
        _ => OpenMethod::SheetInPreview,
    }
}

const fn close_method(number: u8) -> CloseMethod {
    match number {
        0 => CloseMethod::Stay,
        1 => CloseMethod::Ask,
        _ => CloseMethod::Close,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn sbp_ctl_sb3() {
        let line = StartUp::read("a.sbp,3,4,,2,0,2").unwrap();
        assert_eq!((line.file.as_str(), line.port), ("a.sbp", Some(Port::Number(3))));
        assert_eq!((line.open, line.close), (OpenMethod::Run, CloseMethod::Close));
        assert_eq!((line.display, line.offset), (0, 2));
        let usual = StartUp::read("a.sbp").unwrap();
        assert_eq!(
            (usual.port, usual.open, usual.close),
            (None, OpenMethod::Sheet, CloseMethod::Stay)
        );
        assert_eq!(StartUp::read("a.sbp, SIM, 6").unwrap().port, Some(Port::Sim));
    }

    #[test]
    fn sbp_ctl_sb3_file() {
        let file = |line: &str| StartUp::read(line).map(|s| (s.file, s.open));
        let run = |name: &str| Ok((name.to_owned(), OpenMethod::Run));
        assert_eq!(file("\"my part.sbp\",,4"), run("my part.sbp"));
        assert_eq!(file("my part.sbp,,4"), run("my part.sbp"));
        assert_eq!(file("\"a,b.sbp\" , , 4"), run("a,b.sbp"));
        for wrong in ["", ",1", "\"a.sbp,,4", "\"a.sbp\" x", "a,1,4,,2,0,2,9"] {
            assert!(StartUp::read(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn sbp_ctl_sb3_port() {
        assert_eq!(StartUp::read("a.sbp,,4").unwrap().port, None);
        for wrong in [
            "a.sbp,17",
            "a.sbp,0",
            "a.sbp,x",
            "a.sbp,,7",
            "a.sbp,,,,3",
            "a.sbp,,,,,3",
            "a.sbp,,,,,,3",
        ] {
            assert!(StartUp::read(wrong).is_err(), "{wrong}");
        }
    }
}
