//! Programs that are added as tools: `virtualtools.ini` (programming handbook, Virtual Tool System).
//!
//! ```ini
//! [Q]
//! Name = Nesting
//! Command = /opt/nest/nest --quick
//! Wait = 1
//! ```

use crate::tool;

/// A program that was added.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct AddIn {
    /// The letter behind the T.
    pub letter: char,
    /// Its name, as a menu shows it.
    pub name: String,
    /// The command line that starts it; what the call gives stands behind.
    pub command: String,
    /// A part file waits until the tool ends.
    pub wait: bool,
}

/// The tools that a file adds, and what is wrong with it: line and words. Letters of built-in tools
/// and of commands cannot be taken (readings, A-121).
pub fn add_ins(text: &str) -> (Vec<AddIn>, Vec<(usize, String)>) {
    let (mut found, mut mistakes): (Vec<AddIn>, _) = (Vec::new(), Vec::new());
    let mut current: Option<AddIn> = None;
    let mut keep = |tool: Option<AddIn>| found.extend(tool.filter(|tool| !tool.command.is_empty()));
    for (n, line) in text.lines().enumerate().map(|(n, line)| (n + 1, line.trim())) {
        if line.is_empty() || line.starts_with([';', '#']) {
            continue;
        }
        if let Some(section) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            keep(current.take());
            match letter(section.trim()) {
                Ok(letter) => {
                    let (name, wait) = (format!("T{letter}"), true);
                    current = Some(AddIn { letter, name, wait, ..AddIn::default() });
                }
                Err(why) => mistakes.push((n, why)),
            }
            continue;
        }
        let Some((key, value)) = line.split_once('=') else {
            mistakes.push((n, format!("Name = …, Command = … or Wait = 0 expected, not '{line}'")));
            continue;
        };
        let (Some(tool), value) = (&mut current, value.trim()) else { continue };
        match key.trim().to_ascii_lowercase().as_str() {
            "name" => tool.name = value.into(),
            "command" => tool.command = value.into(),
            "wait" => tool.wait = value != "0",
            other => mistakes.push((n, format!("there is no {other} of a tool"))),
        }
    }
    keep(current.take());
    (found, mistakes)
}

fn letter(section: &str) -> Result<char, String> {
    let mut signs = section.chars();
    let letter = signs.next().filter(|_| signs.as_str().is_empty()).map(|c| c.to_ascii_uppercase());
    match letter.filter(char::is_ascii_uppercase) {
        None => Err(format!("a tool is called by one letter, not '{section}'")),
        Some(letter) if tool(letter).is_some() || ['C', 'R', 'T'].contains(&letter) => {
            Err(format!("T{letter} is taken"))
        }
        Some(letter) => Ok(letter),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tools_are_read_with_their_mistakes() {
        let text = "; mine\n[q]\nName = Nesting\nCommand=nest --quick\nWait=0\n[D]\nCommand=x\n\
                    [V]\nCommand = v\n[W]\nName=no command\nrubbish\n";
        let (found, mistakes) = add_ins(text);
        let nest = AddIn {
            letter: 'Q',
            name: "Nesting".into(),
            command: "nest --quick".into(),
            wait: false,
        };
        assert_eq!(found.len(), 2);
        assert_eq!(found[0], nest);
        assert_eq!((found[1].letter, &*found[1].name, found[1].wait), ('V', "TV", true));
        assert_eq!(mistakes[0], (6, "TD is taken".into()));
        assert_eq!(mistakes[1].0, 12);
    }
}
