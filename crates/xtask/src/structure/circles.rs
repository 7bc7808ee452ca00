//! Strongly connected components of a graph of files (Tarjan, "Depth-first search and linear graph algorithms", 1972).

use super::Graph;
use std::collections::{BTreeMap, BTreeSet};

/// A visited file.
struct Visit {
    /// Number in the order of visits.
    index: usize,
    /// Smallest number that is reached from here over files that still lie on the stack.
    low: usize,
    on_stack: bool,
}

#[derive(Default)]
struct Search<'a> {
    visits: BTreeMap<&'a str, Visit>,
    stack: Vec<&'a str>,
    found: Vec<Vec<String>>,
}

/// The circles of two files or more, largest first, files in order of their names.
pub fn circles(graph: &Graph) -> Vec<Vec<String>> {
    let mut search = Search::default();
    for file in graph.keys() {
        if !search.visits.contains_key(file.as_str()) {
            search.visit(graph, file);
        }
    }
    search.found.sort_by(|a, b| b.len().cmp(&a.len()).then_with(|| a.cmp(b)));
    search.found
}

impl<'a> Search<'a> {
    fn visit(&mut self, graph: &'a Graph, file: &'a str) -> usize {
        let index = self.visits.len();
        self.visits.insert(file, Visit { index, low: index, on_stack: true });
        self.stack.push(file);
        let mut low = index;
        for next in graph.get(file).into_iter().flat_map(|known| known.keys()) {
            low = low.min(match self.visits.get(next.as_str()) {
                None => self.visit(graph, next),
                Some(visit) if visit.on_stack => visit.index,
                Some(_) => index,
            });
        }
        if let Some(visit) = self.visits.get_mut(file) {
            visit.low = low;
        }
        if low == index {
            self.close(file);
        }
        low
    }

    /// Takes the component that begins with this file off the stack.
    fn close(&mut self, file: &str) {
        let from = self.stack.iter().rposition(|other| *other == file).unwrap_or(0);
        let component: BTreeSet<&str> = self.stack.drain(from..).collect();
        for member in &component {
            if let Some(visit) = self.visits.get_mut(member) {
                visit.on_stack = false;
            }
        }
        if component.len() > 1 {
            self.found.push(component.into_iter().map(str::to_owned).collect());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(edges: &[(&str, &str)], expected: &[&str]) {
        let mut graph = Graph::new();
        for (from, to) in edges {
            graph.entry((*from).to_owned()).or_default().entry((*to).to_owned()).or_default();
        }
        let found: Vec<String> = circles(&graph).iter().map(|circle| circle.join(" ")).collect();
        assert_eq!(found, expected, "{edges:?}");
    }

    #[test]
    fn files_that_reach_each_other_are_one_circle() {
        check(&[("a", "b"), ("b", "c"), ("a", "c")], &[]);
        check(&[("a", "b"), ("b", "a"), ("b", "c"), ("c", "d")], &["a b"]);
        check(
            &[("a", "b"), ("b", "c"), ("c", "a"), ("d", "a"), ("d", "e"), ("e", "d")],
            &["a b c", "d e"],
        );
        check(&[("a", "b"), ("b", "c"), ("c", "b"), ("c", "d"), ("d", "a")], &["a b c d"]);
    }
}
