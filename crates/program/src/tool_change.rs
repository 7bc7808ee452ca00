//! Changes of tools as printers see them.
//!
//! Programs change tools in their own ways: OpenSBP runs the owner's file C9 with the tool's number in
//! `&Tool`, G-code has `T5 M6`. Both come as the commands of the change between two
//! [`Command::ToolChange`]; the tool is known before, or named right behind.

use crate::{Command, ToolPathStart};

/// State of a change of tools.
#[derive(Debug, Default)]
pub struct Changing {
    under_way: bool,
    /// It is over, and no tool came yet.
    ended: bool,
    /// The tool that it puts in, where that is known before.
    tool: Option<String>,
    /// Text shown to the operator while it was under way.
    told: Option<String>,
}

/// Words to be written for a change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ChangeWords {
    /// Put this tool in.
    PutIn(String),
    /// No tool came: the operator reads this and goes on.
    Hold(String),
}

impl Changing {
    /// Names the tool of the next change.
    pub fn expect(&mut self, name: &str) {
        self.tool = Some(name.into());
    }

    /// Takes what the operator is told. False when no change is under way.
    pub fn tell(&mut self, text: &str) -> bool {
        if self.under_way {
            self.told = Some(text.into());
        }
        self.under_way
    }

    /// Returns `true` while a change is under way.
    pub const fn is_under_way(&self) -> bool {
        self.under_way
    }

    /// Follows a command; gives what is to be written before it.
    pub fn follow(&mut self, command: &Command) -> Option<ChangeWords> {
        match command {
            Command::ToolChange { begin } => {
                (self.under_way, self.ended) = (*begin, !begin);
                self.tool.take_if(|_| !begin).map(|tool| self.put_in(tool))
            }
            Command::ToolPath(ToolPathStart { tool: Some(tool), .. }) if self.ended => {
                Some(self.put_in(tool.to_string()))
            }
            Command::ToolPath(_) => None,
            _ => self.end(),
        }
    }

    /// Returns what is to be written when no more commands come.
    pub fn end(&mut self) -> Option<ChangeWords> {
        let told = std::mem::take(&mut self.ended).then(|| self.told.take());
        told.flatten().map(ChangeWords::Hold)
    }

    fn put_in(&mut self, tool: String) -> ChangeWords {
        (self.told, self.ended) = (None, false);
        ChangeWords::PutIn(tool)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(commands: &[Command], expected: &[ChangeWords]) {
        let mut changing = Changing::default();
        let mut words = Vec::new();
        for command in commands {
            words.extend(changing.follow(command));
            changing.tell("put it in");
        }
        words.extend(changing.end());
        assert_eq!(words, expected);
    }

    const BEGIN: Command = Command::ToolChange { begin: true };
    const END: Command = Command::ToolChange { begin: false };

    #[test]
    fn a_tool_named_behind_its_change_comes() {
        let named = ToolPathStart { name: None, tool: Some("T5".into()) };
        let put_in = [ChangeWords::PutIn("T5".into())];
        check(&[BEGIN, END, Command::ToolPath(named.clone())], &put_in);
        check(&[Command::ToolPath(named)], &[]);
    }

    #[test]
    fn a_change_without_a_tool_is_a_hold() {
        let hold = [ChangeWords::Hold("put it in".into())];
        check(&[BEGIN, END, Command::MotorsOff], &hold);
        check(&[BEGIN, END], &hold);
        check(&[Command::MotorsOff], &[]);
    }
}
