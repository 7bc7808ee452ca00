//! One path round all rings of an island.
//!
//! A ring is followed from where the tool comes to it all the way round; at each link on the way the tool
//! goes over to what hangs on it and comes back the same way, over what is already cut. What hangs near
//! the end of a ring comes last, and from the last one of all there is no way back.

use crate::cutter::CutDirection;
use crate::inside::Inside;
use crate::islands::Island;
use crate::route::Route;
use crate::tree::{Link, links};
use kerf_geom::{Point2, Polyarc, PolyarcPlace, Segment, tol};

/// A link from the end of a ring may be so much longer than the shortest one: it saves the way back.
const LONGER: f64 = 1.5;

/// The paths of an island: one, or more where links are missing.
pub(crate) fn paths(island: &Island, inside: &Inside, way: CutDirection) -> Vec<Polyarc> {
    let first = island.rings.first().and_then(longest_middle).map(|at| (0, at));
    let paths = Tree::of(island, inside, way, first).paths();
    let turned = |path: Polyarc| if way.outward { path.reversed() } else { path };
    paths.into_iter().map(turned).collect()
}

/// The middle of the longest segment of a ring: the tool goes down where there is room, not in a corner.
fn longest_middle(ring: &Polyarc) -> Option<Point2> {
    let longest = ring.segments().max_by(|a, b| a.length().total_cmp(&b.length()));
    longest.map(|segment| segment.at(0.5))
}

/// Once round every ring of an island, beginning with the one that is nearest.
pub(crate) fn along_walls(island: &Island, inside: &Inside, way: CutDirection, route: &mut Route) {
    let nearest = |to: Point2| {
        let found =
            |(n, ring): (usize, &Polyarc)| ring.nearest(to).map(|(place, far)| (n, place.at, far));
        let rings = island.rings.iter().enumerate().filter_map(found);
        rings.min_by(|a, b| a.2.total_cmp(&b.2)).map(|(n, at, _)| (n, at))
    };
    let tree = Tree::of(island, inside, way, route.end().and_then(nearest));
    tree.paths().into_iter().for_each(|path| route.add(path, &island.rings));
}

/// Rings come with the material on their right when their outermost runs counter-clockwise. A path that
/// is turned round in the end is made the other way.
fn directed(ring: &Polyarc, way: CutDirection) -> Polyarc {
    if way.climb == way.outward { ring.reversed() } else { ring.clone() }
}

/// A branch that hangs on a node: where the link begins, what it leads to, and where it arrives.
#[derive(Clone, Copy)]
struct Branch {
    from: PolyarcPlace,
    node: usize,
    to: PolyarcPlace,
}

struct Tree {
    nodes: Vec<Polyarc>,
    branches: Vec<Vec<Branch>>,
    /// Nodes with which paths begin, and where on them.
    roots: Vec<(usize, PolyarcPlace)>,
    /// Number of nodes that hang below each one, one below the other.
    height: Vec<usize>,
}

/// A task that is still to be done; the next one is the last.
enum Task {
    Visit { node: usize, entry: PolyarcPlace, last: bool },
    Follow(Polyarc),
    Go { from: Point2, to: Point2 },
}

impl Tree {
    /// The tree of links, hung up at a ring where the path begins, or at the first one. What has no link
    /// to it begins a tree of its own.
    fn of(
        island: &Island,
        inside: &Inside,
        way: CutDirection,
        first: Option<(usize, Point2)>,
    ) -> Self {
        let rings = island.rings.iter().map(|ring| directed(ring, way)).collect();
        let island = Island { rings, strokes: island.strokes.clone() };
        let links = links(&island, inside);
        let nodes: Vec<Polyarc> = island.rings.into_iter().chain(island.strokes).collect();
        let count = nodes.len();
        let mut ends: Vec<Vec<Branch>> = vec![Vec::new(); count];
        for Link { from, to } in links {
            ends[from.node].push(Branch { from: from.place, node: to.node, to: to.place });
            ends[to.node].push(Branch { from: to.place, node: from.node, to: from.place });
        }
        let branches = vec![Vec::new(); count];
        let mut tree = Self { nodes, branches, roots: Vec::new(), height: vec![0; count] };
        let mut seen = vec![false; count];
        if let Some((root, at)) = first {
            tree.hang(root, at, &ends, &mut seen, inside);
        }
        for root in 0..count {
            if let (false, Some(at)) = (seen[root], tree.nodes[root].start()) {
                tree.hang(root, at, &ends, &mut seen, inside);
            }
        }
        tree
    }

    /// The paths, one a root.
    fn paths(&self) -> Vec<Polyarc> {
        self.roots.iter().map(|(root, entry)| self.walk(*root, *entry)).collect()
    }

    fn hang(
        &mut self,
        root: usize,
        at: Point2,
        ends: &[Vec<Branch>],
        seen: &mut [bool],
        inside: &Inside,
    ) {
        let start = PolyarcPlace { segment: 0, share: 0.0, at };
        let entry = self.nodes[root].nearest(at).map_or(start, |(place, _)| place);
        self.roots.push((root, entry));
        seen[root] = true;
        let mut order = vec![(root, entry)];
        let mut next = 0;
        while let Some(&(node, entry)) = order.get(next) {
            next += 1;
            for branch in &ends[node] {
                if !seen[branch.node] {
                    seen[branch.node] = true;
                    let branch = self.nearer_to(entry, branch, inside);
                    self.branches[node].push(branch);
                    order.push((branch.node, branch.to));
                }
            }
        }
        for (node, _) in order.iter().rev() {
            let below = self.branches[*node].iter().map(|branch| self.height[branch.node] + 1);
            self.height[*node] = below.max().unwrap_or_default();
        }
    }

    /// The same branch from where the node ends, if the link does not become much longer.
    fn nearer_to(&self, entry: PolyarcPlace, branch: &Branch, inside: &Inside) -> Branch {
        let to = self.nodes[branch.node].nearest(entry.at).map(|(to, _)| to);
        let long = LONGER * branch.from.at.distance(branch.to.at);
        let fits =
            |to: &PolyarcPlace| to.at.distance(entry.at) <= long && inside.joins(entry.at, to.at);
        let is_ring = self.nodes[branch.node].closed;
        let near = to.filter(|to| is_ring && fits(to));
        near.map_or(*branch, |to| Branch { from: entry, to, ..*branch })
    }

    /// The path round everything that hangs on a root.
    fn walk(&self, root: usize, entry: PolyarcPlace) -> Polyarc {
        let mut path = Vec::new();
        let mut tasks = vec![Task::Visit { node: root, entry, last: true }];
        while let Some(task) = tasks.pop() {
            match task {
                Task::Visit { node, entry, last } => {
                    let todo = self.visit(node, entry, last);
                    tasks.extend(todo.into_iter().rev());
                }
                Task::Follow(part) => path.extend(part.segments()),
                Task::Go { from, to } => path.push(Segment::line(from, to)),
            }
        }
        path.retain(|segment: &Segment| segment.length() > tol::SAME_PLACE_MM);
        if path.is_empty() {
            return Polyarc::lines([entry.at], false);
        }
        Polyarc::from_segments(&path, false)
    }

    fn visit(&self, node: usize, entry: PolyarcPlace, last: bool) -> Vec<Task> {
        let path = &self.nodes[node];
        if path.closed { self.round(node, entry, last) } else { there_and_back(path, entry, last) }
    }

    /// Round a ring, with its branches on the way and those at its end after it. On the way to the last
    /// node of all the branch that is deepest waits until then, and there is no coming back from it.
    fn round(&self, node: usize, entry: PolyarcPlace, last: bool) -> Vec<Task> {
        let ring = self.nodes[node].started_at(&entry);
        let start = PolyarcPlace { segment: 0, share: 0.0, at: entry.at };
        let end = PolyarcPlace { segment: ring.segment_count() - 1, share: 1.0, at: entry.at };
        let mut stops: Vec<(PolyarcPlace, &Branch)> = self.branches[node]
            .iter()
            .map(|branch| (place_on(&ring, branch, end), branch))
            .collect();
        stops.sort_by(|a, b| {
            let (a, b) = (a.0, b.0);
            a.segment.cmp(&b.segment).then(a.share.total_cmp(&b.share))
        });
        let deepest = stops.iter().enumerate().max_by_key(|(_, stop)| self.height[stop.1.node]);
        let onward = deepest.map(|(n, _)| n).filter(|_| last).map(|n| stops.remove(n));
        let mut tasks = Vec::new();
        let mut from = start;
        for (place, branch) in stops {
            tasks.push(Task::Follow(part(&ring, &from, &place)));
            tasks.extend(there(branch, false));
            from = place;
        }
        tasks.push(Task::Follow(part(&ring, &from, &end)));
        if let Some((place, branch)) = onward {
            let (there_way, back) = (part(&ring, &start, &place), part(&ring, &place, &end));
            let shorter = back.length() < there_way.length();
            tasks.push(Task::Follow(if shorter { back.reversed() } else { there_way }));
            tasks.extend(there(branch, true));
        }
        tasks
    }
}

/// Returns the place where a branch begins on a ring; at its start it is the end, so that the ring is cut first.
fn place_on(ring: &Polyarc, branch: &Branch, end: PolyarcPlace) -> PolyarcPlace {
    if branch.from.at.distance(end.at) <= tol::SAME_PLACE_MM {
        return end;
    }
    ring.nearest(branch.from.at).map_or(end, |(place, _)| place)
}

/// Over to a branch, and back unless it is the last one.
fn there(branch: &Branch, last: bool) -> Vec<Task> {
    let (from, to) = (branch.from.at, branch.to.at);
    let mut tasks = vec![Task::Go { from, to }];
    tasks.push(Task::Visit { node: branch.node, entry: branch.to, last });
    if !last {
        tasks.push(Task::Go { from: to, to: from });
    }
    tasks
}

/// Along a stroke from the end where it is entered, and back unless it is the last thing.
fn there_and_back(stroke: &Polyarc, entry: PolyarcPlace, last: bool) -> Vec<Task> {
    let from_start =
        stroke.start().is_none_or(|start| start.distance(entry.at) <= tol::SAME_PLACE_MM);
    let there = if from_start { stroke.clone() } else { stroke.reversed() };
    let back = (!last).then(|| Task::Follow(there.reversed()));
    std::iter::once(Task::Follow(there)).chain(back).collect()
}

fn part(ring: &Polyarc, from: &PolyarcPlace, to: &PolyarcPlace) -> Polyarc {
    if (to.segment, to.share) <= (from.segment, from.share) {
        return Polyarc::default();
    }
    ring.between(from, to)
}
