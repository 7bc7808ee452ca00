//! The lines of a file by their number.
//!
//! A large file is millions of plain moves with little between them. Of a run of moves only every
//! 16th line has a mark; the others are found by counting line ends from there:
//!
//! ```text
//!  line    1      2     3     4          20         35    36
//!          %   block  blank  move …   move …     move   block
//!  marks   ·     ·      ·     ·          ·          ·     ·
//! ```

use super::node::{LineNode, Node};
use super::text::next_line;

/// Moves between two marks: more make finding a line slower. Ten million moves have 7.5 MB of them.
const STRIDE: u32 = 16;

/// Kind of every line, and its beginning.
#[derive(Debug, Default)]
pub(crate) struct Lines {
    /// In order of lines. Between two of them that are more than a line apart there are moves.
    marks: Vec<Mark>,
    count: u32,
}

#[derive(Clone, Copy, Debug)]
struct Mark {
    /// Its line, from 0.
    line: u32,
    node: LineNode,
}

impl Lines {
    /// Returns the number of lines.
    pub(crate) const fn len(&self) -> u32 {
        self.count
    }

    /// The next line, which begins at a byte.
    pub(crate) fn push(&mut self, node: Node, start: u32) {
        let line = self.count;
        self.count += 1;
        let near = |mark: &Mark| mark.node.node() == Node::Move && line - mark.line < STRIDE;
        if node != Node::Move || !self.marks.last().is_some_and(near) {
            self.marks.push(Mark { line, node: LineNode::new(node, start) });
        }
    }

    /// A line, from 0.
    pub(crate) fn get(&self, text: &str, index: u32) -> Option<LineNode> {
        let mark = self.marks.get(self.mark_of(index)?)?;
        let mut start = mark.node.start as usize;
        for _ in mark.line..index {
            start = next_line(text.as_bytes(), start);
        }
        // Behind a mark there are only moves.
        Some(if mark.line == index { mark.node } else { LineNode::new(Node::Move, start as u32) })
    }

    /// Counts the moves that follow each other from a line (from 0) on; no more than `most` are counted.
    pub(crate) fn moves_from(&self, index: u32, most: u32) -> u32 {
        let Some(first) = self.mark_of(index) else { return 0 };
        let here = self.marks.get(first..).unwrap_or_default();
        let bound = index.saturating_add(most).min(self.count);
        let other =
            here.iter().take_while(|m| m.line < bound).find(|m| m.node.node() != Node::Move);
        other.map_or(bound, |m| m.line.max(index)) - index
    }

    /// A mark, by its place in the list of marks: its line (from 0) and what that is. Every line that is
    /// no move has one.
    pub(crate) fn marked(&self, at: usize) -> Option<(u32, Node)> {
        self.marks.get(at).map(|m| (m.line, m.node.node()))
    }

    /// The lines that are no moves, from 0, in order.
    pub(crate) fn others(&self) -> impl Iterator<Item = (u32, Node)> {
        let marks = self.marks.iter().map(|m| (m.line, m.node.node()));
        marks.filter(|(_, node)| *node != Node::Move)
    }

    /// Every line in order.
    pub(crate) fn iter<'a>(&'a self, text: &'a str) -> impl Iterator<Item = LineNode> + 'a {
        let ends = self.marks.iter().skip(1).map(|m| m.line).chain([self.count]);
        self.marks.iter().zip(ends).flat_map(move |(mark, end)| {
            let mut node = mark.node;
            (mark.line..end).map(move |_| {
                let next = next_line(text.as_bytes(), node.start as usize);
                std::mem::replace(&mut node, LineNode::new(Node::Move, next as u32))
            })
        })
    }

    /// The last mark at a line or before it.
    fn mark_of(&self, index: u32) -> Option<usize> {
        if index >= self.count {
            return None;
        }
        self.marks.partition_point(|m| m.line <= index).checked_sub(1)
    }
}

#[cfg(test)]
mod tests {
    use crate::syntax::tree::Node;
    use crate::testing::program;

    #[test]
    fn lines_between_marks_are_found() {
        let mut text = String::from("%⏎G21 G90⏎⏎");
        for i in 0..1000 {
            let line = match i % 331 {
                330 => "M3⏎".to_owned(),
                329 => "⏎".to_owned(),
                _ => format!("X{i} F1⏎"),
            };
            text.push_str(&line);
        }
        let program = program(&text);
        let all: Vec<_> = program.lines.iter(&program.text).collect();
        assert_eq!(all.len(), program.lines.len() as usize);
        assert!(program.lines.marks.len() < 80, "{}", program.lines.marks.len());
        for (index, (line, text)) in all.iter().zip(program.text.lines()).enumerate() {
            let index = index as u32;
            let found = program.lines.get(&program.text, index).map(|l| (l.node(), l.start));
            assert_eq!(found, Some((line.node(), line.start)), "{index}");
            assert_eq!(program.line_text(index + 1), text);
            let moves = all[index as usize..].iter().take_while(|l| l.node() == Node::Move);
            let moves = moves.count() as u32;
            assert_eq!(program.lines.moves_from(index, u32::MAX), moves, "{index}");
            assert_eq!(program.lines.moves_from(index, 3), moves.min(3), "{index}");
        }
        assert_eq!(program.lines.moves_from(5000, 1), 0);
        assert!(program.lines.get(&program.text, 5000).is_none());
    }
}
