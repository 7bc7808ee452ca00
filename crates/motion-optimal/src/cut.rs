//! Nodes of a plan up to a place, and those from there on.

use crate::node::{Node, Push, halve};

/// Nodes closer to the end of a move than this are at it, mm.
pub(crate) const SAME_MM: f64 = 1e-9;

/// Takes the nodes up to a place, and leaves those from there on.
pub(crate) fn cut(nodes: &mut Vec<Node>, at_mm: f64) -> Vec<Node> {
    let index = nodes.partition_point(|n| n.at_mm < at_mm - SAME_MM);
    let rest = nodes.split_off(index);
    let mut made = std::mem::replace(nodes, rest);
    let Some(next) = nodes.first_mut() else { return made };
    if next.at_mm <= at_mm + SAME_MM {
        next.at_mm = at_mm;
        made.push(*next);
    } else if let Some(before) = made.last() {
        let share = (at_mm - before.at_mm) / (next.at_mm - before.at_mm);
        let square = before.v * before.v;
        let v = (square + share * (next.v * next.v - square)).sqrt();
        let t_s = before.t_s + 2.0 * (at_mm - before.at_mm) / (before.v + v);
        let node = Node { at_mm, v, t_s };
        made.push(node);
        nodes.insert(0, node);
    }
    made
}

/// The same for how the motion goes on after each node; in the middle between two of them a node is
/// added.
pub(crate) fn cut_pushes(nodes: &mut Vec<Node>, pushes: &mut Vec<Push>, at_mm: f64) -> Vec<Push> {
    let index = nodes.partition_point(|n| n.at_mm < at_mm - SAME_MM);
    if index > 0 && nodes.get(index).is_some_and(|next| next.at_mm > at_mm + SAME_MM) {
        let (node, push) = halve(&nodes[index - 1], &pushes[index - 1], &nodes[index], at_mm);
        nodes.insert(index, node);
        pushes.insert(index, push);
    }
    let rest = pushes.split_off(index);
    let mut made = std::mem::replace(pushes, rest);
    made.extend(pushes.first());
    made
}
