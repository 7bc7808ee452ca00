//! Pieces of path: what becomes one program file, or one command.

use kerf_machine::driver::{Axes, Order, Sent, Ticket};
use std::collections::VecDeque;

/// What a piece asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Lines of a program.
    Path,
    /// A move that ends at a contact.
    Probe,
    /// Going home.
    Home,
    /// Switching on.
    Unlock,
}

/// Most lines of a piece: what a file of it takes to write and to read is a tenth of a second.
const MOST_LINES: usize = 20_000;

/// A piece of path, gathered order by order.
#[derive(Clone, Debug)]
pub struct Piece {
    pub kind: Kind,
    pub lines: Vec<(Ticket, String)>,
    pub last: Ticket,
    /// Place where it leaves the machine.
    pub to: Axes,
}

/// Pieces that wait, the first one to be made first.
#[derive(Clone, Debug, Default)]
pub struct Pieces(VecDeque<Piece>);

impl Pieces {
    /// An order joins the last piece, or begins another.
    pub fn push(&mut self, sent: &Sent, lines: Vec<String>, to: Axes) {
        let kind = match sent.order {
            Order::Probe { .. } => Kind::Probe,
            Order::Home => Kind::Home,
            Order::Unlock => Kind::Unlock,
            _ => Kind::Path,
        };
        let open = self.0.back().is_some_and(|last| {
            kind == Kind::Path && last.kind == kind && last.lines.len() < MOST_LINES
        });
        if !open {
            self.0.push_back(Piece { kind, lines: Vec::new(), last: 0, to });
        }
        if let Some(last) = self.0.back_mut() {
            last.lines.extend(lines.into_iter().map(|line| (sent.ticket, line)));
            (last.last, last.to) = (sent.ticket, to);
        }
    }

    /// A piece comes before all others.
    pub fn push_front(&mut self, piece: Piece) {
        self.0.push_front(piece);
    }

    /// Takes the next piece; one that may grow only if nothing came for a while.
    pub fn take(&mut self, has_rested: bool) -> Option<Piece> {
        let grows = self.0.len() == 1 && self.0.front().is_some_and(Piece::grows);
        if grows && !has_rested { None } else { self.0.pop_front() }
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        self.0.clear();
    }
}

impl Piece {
    fn grows(&self) -> bool {
        self.kind == Kind::Path && self.lines.len() < MOST_LINES
    }
}
