//! Rings joined into a tree by short links.
//!
//! Each cluster of rings is joined to the nearest other one until there is one cluster (Borůvka's way to a
//! shortest spanning tree). A shortest link never leaves the places where the centre may go: where it left
//! them it would cross a ring, and the link to that ring would be shorter.

use crate::inside::Inside;
use crate::islands::Island;
use kerf_geom::{BoxTree, Point2, Polyarc, PolyarcPlace, Segment};

/// A place on a node: a ring, or after all rings a stroke.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    pub node: usize,
    pub place: PolyarcPlace,
}

/// A straight way between two nodes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Link {
    pub from: Spot,
    pub to: Spot,
}

impl Link {
    pub fn length(&self) -> f64 {
        self.from.place.at.distance(self.to.place.at)
    }

    fn is_inside(&self, inside: &Inside) -> bool {
        inside.joins(self.from.place.at, self.to.place.at)
    }
}

/// The links of an island. A link that would leave the places where the centre may go is left out, and
/// the tool is lifted there.
pub(crate) fn links(island: &Island, inside: &Inside) -> Vec<Link> {
    let listed = Listed::of(&island.rings);
    let mut links = spanning(&island.rings, &listed);
    let strokes = island.strokes.iter().enumerate();
    links.extend(strokes.filter_map(|(n, stroke)| {
        let to = island.rings.len() + n;
        from_nearest(&listed, to, stroke)
    }));
    links.retain(|link| link.is_inside(inside));
    links
}

/// The link from the rings to the nearer end of a stroke.
fn from_nearest(listed: &Listed, node: usize, stroke: &Polyarc) -> Option<Link> {
    let last = stroke.segment_count().saturating_sub(1);
    let start = stroke.start().map(|at| PolyarcPlace { segment: 0, share: 0.0, at });
    let end = stroke.end().map(|at| PolyarcPlace { segment: last, share: 1.0, at });
    let link = |place: PolyarcPlace| {
        let (from, _) = listed.nearest(place.at, f64::INFINITY, |_| true)?;
        Some(Link { from, to: Spot { node, place } })
    };
    let both = [start, end].into_iter().flatten().filter_map(link);
    both.min_by(|a, b| a.length().total_cmp(&b.length()))
}

/// The segments of rings, to be asked what is near.
struct Listed {
    segments: Vec<Segment>,
    /// The ring of each segment and its number there.
    owners: Vec<(usize, usize)>,
    tree: BoxTree,
}

impl Listed {
    fn of(rings: &[Polyarc]) -> Self {
        let owned = |(n, ring): (usize, &Polyarc)| (0..ring.segment_count()).map(move |k| (n, k));
        let owners: Vec<(usize, usize)> = rings.iter().enumerate().flat_map(owned).collect();
        let segments: Vec<Segment> = rings.iter().flat_map(|ring| ring.segments()).collect();
        let tree = BoxTree::new(segments.iter().map(Segment::bounds));
        Self { segments, owners, tree }
    }

    /// The nearest place on a ring that is wanted, nearer than a limit.
    fn nearest(
        &self,
        at: Point2,
        limit: f64,
        wanted: impl Fn(usize) -> bool,
    ) -> Option<(Spot, f64)> {
        let measure = |k: usize| {
            if wanted(self.owners[k].0) { self.segments[k].distance(at) } else { f64::INFINITY }
        };
        let (number, distance) = self.tree.nearest(at, limit, measure)?;
        let (node, segment) = self.owners[number];
        let foot = self.segments[number].nearest(at);
        Some((
            Spot { node, place: PolyarcPlace { segment, share: foot.share, at: foot.at } },
            distance,
        ))
    }
}

fn spanning(rings: &[Polyarc], listed: &Listed) -> Vec<Link> {
    let mut clusters = Clusters((0..rings.len()).collect());
    let mut links = Vec::new();
    loop {
        let names: Vec<usize> = (0..rings.len()).map(|n| clusters.name(n)).collect();
        let before = links.len();
        for link in shortest(rings, listed, &names).into_iter().flatten() {
            if clusters.unite(link.from.node, link.to.node) {
                links.push(link);
            }
        }
        if links.len() == before {
            return links;
        }
    }
}

/// The shortest link found from each cluster to another one.
fn shortest(rings: &[Polyarc], listed: &Listed, names: &[usize]) -> Vec<Option<Link>> {
    let mut best: Vec<Option<(Link, f64)>> = vec![None; rings.len()];
    for (node, ring) in rings.iter().enumerate() {
        let name = names[node];
        for place in places(ring) {
            let limit = best[name].as_ref().map_or(f64::INFINITY, |found| found.1);
            let found = listed.nearest(place.at, limit, |other| names[other] != name);
            if let Some((to, distance)) = found {
                best[name] = Some((Link { from: Spot { node, place }, to }, distance));
            }
        }
    }
    best.into_iter().map(|found| found.map(|(link, _)| link)).collect()
}

/// Returns the places where links from a ring may begin: its vertices and the middles of its segments.
fn places(ring: &Polyarc) -> impl Iterator<Item = PolyarcPlace> + '_ {
    ring.segments().enumerate().flat_map(|(segment, s)| {
        [0.0, 0.5].map(|share| PolyarcPlace { segment, share, at: s.at(share) })
    })
}

/// Which rings hang together: each points to another of its cluster, the first one to itself.
struct Clusters(Vec<usize>);

impl Clusters {
    fn name(&mut self, mut node: usize) -> usize {
        while self.0[node] != node {
            self.0[node] = self.0[self.0[node]];
            node = self.0[node];
        }
        node
    }

    /// Makes one cluster of two; false when they were one.
    fn unite(&mut self, a: usize, b: usize) -> bool {
        let (a, b) = (self.name(a), self.name(b));
        self.0[a.max(b)] = a.min(b);
        a != b
    }
}
