//! The kinds of lines.

/// A line: what it is and where its text begins.
#[derive(Clone, Copy, Debug)]
pub struct LineNode {
    /// Index of its block, or one of the numbers behind [`LineNode::PLAIN`].
    what: u32,
    /// Byte offset of the line in [`Program::text`](super::tree::Program::text).
    pub start: u32,
}

impl LineNode {
    /// Larger numbers are nodes without a block: a text of 4 GB has fewer blocks.
    const PLAIN: u32 = u32::MAX - Self::NODES.len() as u32;
    const NODES: [Node; 5] = [Node::Blank, Node::Move, Node::Percent, Node::Console, Node::Bad];

    /// A line that begins at a byte.
    pub(crate) const fn new(node: Node, start: u32) -> Self {
        let plain = match node {
            Node::Block(index) => return Self { what: index, start },
            Node::Blank => 0,
            Node::Move => 1,
            Node::Percent => 2,
            Node::Console => 3,
            Node::Bad => 4,
        };
        Self { what: Self::PLAIN + plain, start }
    }

    /// Returns the kind of the line.
    pub const fn node(self) -> Node {
        match self.what.checked_sub(Self::PLAIN) {
            Some(plain) => Self::NODES[plain as usize],
            None => Node::Block(self.what),
        }
    }
}

/// Kind of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Node {
    /// Nothing.
    Blank,
    /// A move with literal values: see [`Program::move_of`](super::tree::Program::move_of).
    Move,
    /// Anything else; index into [`Program::blocks`](super::tree::Program::blocks).
    Block(u32),
    /// `%`: the beginning of the program, or its end.
    Percent,
    /// A line for the controller's console (`$…`).
    Console,
    /// A line that cannot be read; its diagnostics say why.
    Bad,
}
