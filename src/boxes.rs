//! A tree of bounding boxes: which items lie near a place, without asking all of them.
//!
//! Items are halved at the median of their centers, again and again, across the longer side; so
//! the tree is balanced whatever their distribution.
//!
//! It holds no judgement, only rectangles: so the domain and the judge, who share nothing else, may
//! both search with it.

use std::ops::ControlFlow;

/// A closed rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// The corner with the smallest coordinates.
    pub low: [f64; 2],
    /// The corner with the largest coordinates.
    pub high: [f64; 2],
}

impl Rectangle {
    /// The smallest rectangle around two points.
    pub fn around(a: [f64; 2], b: [f64; 2]) -> Self {
        Self { low: [a[0].min(b[0]), a[1].min(b[1])], high: [a[0].max(b[0]), a[1].max(b[1])] }
    }

    /// A rectangle within the convex hull of points, so that most of them need not be looked at when
    /// the hull is wanted: of four points each lies no nearer than one of its corners, in both
    /// coordinates (Akl & Toussaint 1978). Inside out where there is none; for finite points.
    pub fn within_hull(points: impl Iterator<Item = [f64; 2]>) -> Self {
        let mut farthest = [(f64::NEG_INFINITY, [0.0; 2]); 4];
        for [x, y] in points {
            for (best, outwards) in farthest.iter_mut().zip([-x - y, x - y, y - x, x + y]) {
                if outwards > best.0 {
                    *best = (outwards, [x, y]);
                }
            }
        }
        let [(_, sw), (_, se), (_, nw), (_, ne)] = farthest;
        Self {
            low: [sw[0].max(nw[0]), sw[1].max(se[1])],
            high: [se[0].min(ne[0]), nw[1].min(ne[1])],
        }
    }

    /// Whether a point lies in the rectangle, farther than `margin` from its sides.
    pub fn holds_well(&self, point: [f64; 2], margin: f64) -> bool {
        (0..2).all(|k| self.low[k] + margin < point[k] && point[k] < self.high[k] - margin)
    }

    /// The distance between the two rectangles, squared.
    pub fn gap_squared(&self, other: &Self) -> f64 {
        let gap =
            |k: usize| (self.low[k] - other.high[k]).max(other.low[k] - self.high[k]).max(0.0);
        gap(0) * gap(0) + gap(1) * gap(1)
    }

    /// The smallest rectangle around both.
    pub fn union(self, other: Self) -> Self {
        Self {
            low: [self.low[0].min(other.low[0]), self.low[1].min(other.low[1])],
            high: [self.high[0].max(other.high[0]), self.high[1].max(other.high[1])],
        }
    }

    /// Whether the two have a point in common.
    pub fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|k| self.low[k] <= other.high[k] && other.low[k] <= self.high[k])
    }

    /// What the two have in common, if they overlap.
    pub fn intersection(&self, other: &Self) -> Self {
        let corner = |k: usize| (self.low[k].max(other.low[k]), self.high[k].min(other.high[k]));
        let [(left, right), (bottom, top)] = [corner(0), corner(1)];
        Self { low: [left, bottom], high: [right, top] }
    }

    /// Whether a point lies in the rectangle.
    pub fn contains(&self, point: [f64; 2]) -> bool {
        (0..2).all(|k| self.low[k] <= point[k] && point[k] <= self.high[k])
    }

    /// The distance from a point to the rectangle, squared.
    pub fn distance_squared(&self, point: [f64; 2]) -> f64 {
        let outside = |k: usize| (self.low[k] - point[k]).max(point[k] - self.high[k]).max(0.0);
        outside(0) * outside(0) + outside(1) * outside(1)
    }
}

/// The tree. Nodes stand in preorder: the left child of a node follows it, the right child
/// follows the left one's subtree (2m − 1 nodes for m items).
#[derive(Debug, Clone)]
pub struct Boxes {
    items: Vec<u32>,
    nodes: Vec<Rectangle>,
}

/// A node of the tree: a subtree with at least one item.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Node {
    /// Its place in preorder: 0 to 2m − 2.
    pub index: usize,
    start: usize,
    end: usize,
}

impl Node {
    /// How many items the node holds.
    fn size(self) -> usize {
        self.end - self.start
    }
}

/// What a node holds.
pub enum Below {
    /// One item.
    Item(u32),
    /// Two subtrees.
    Halves([Node; 2]),
}

impl Boxes {
    /// The tree of the items 0, 1, …, given by their bounding rectangles.
    pub fn new(rectangles: &[Rectangle]) -> Self {
        let mut items: Vec<u32> = (0..rectangles.len() as u32).collect();
        let mut nodes = Vec::with_capacity(2 * rectangles.len());
        if !items.is_empty() {
            build(rectangles, &mut items, &mut nodes);
        }
        Self { items, nodes }
    }

    /// The whole tree; `None` without items.
    pub fn root(&self) -> Option<Node> {
        (!self.items.is_empty()).then_some(Node { index: 0, start: 0, end: self.items.len() })
    }

    /// What a node holds.
    pub fn below(&self, Node { index, start, end }: Node) -> Below {
        if end - start == 1 {
            return Below::Item(self.items[start]);
        }
        let middle = start + (end - start) / 2;
        let right = index + 2 * (middle - start);
        Below::Halves([
            Node { index: index + 1, start, end: middle },
            Node { index: right, start: middle, end },
        ])
    }

    /// The rectangle around everything that a node holds.
    pub fn rectangle(&self, node: Node) -> &Rectangle {
        &self.nodes[node.index]
    }

    /// For each node, in preorder, what its items have in common: `of_item` of one, `join` of two
    /// subtrees.
    pub fn in_common<T: Copy>(
        &self,
        of_item: impl Fn(u32) -> T,
        join: impl Fn(T, T) -> T,
    ) -> Vec<T> {
        let mut pending: Vec<Node> = self.root().into_iter().collect();
        let mut preorder = Vec::with_capacity(self.nodes.len());
        while let Some(node) = pending.pop() {
            preorder.push(node);
            if let Below::Halves([left, right]) = self.below(node) {
                pending.extend([right, left]);
            }
        }
        // From the last node back: what a node holds stands behind it, what the left half holds
        // before what the right half holds.
        let mut done: Vec<T> = Vec::with_capacity(self.nodes.len());
        for &node in preorder.iter().rev() {
            let of = |part: Node| done[self.nodes.len() - 1 - part.index];
            done.push(match self.below(node) {
                Below::Item(item) => of_item(item),
                Below::Halves([left, right]) => join(of(left), of(right)),
            });
        }
        done.reverse();
        done
    }

    /// Visits the items whose rectangles meet `rectangle`, until told to stop.
    pub fn overlapping<B>(
        &self,
        rectangle: &Rectangle,
        mut visit: impl FnMut(u32) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let mut pending: Vec<Node> = self.root().into_iter().collect();
        while let Some(node) = pending.pop() {
            if !self.rectangle(node).overlaps(rectangle) {
                continue;
            }
            match self.below(node) {
                Below::Item(item) => visit(item)?,
                Below::Halves([left, right]) => pending.extend([right, left]),
            }
        }
        ControlFlow::Continue(())
    }

    /// Visits each pair of items whose rectangles meet once, until told to stop.
    pub fn overlapping_pairs<B>(
        &self,
        mut visit: impl FnMut([u32; 2]) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let mut pending: Vec<[Node; 2]> = self.root().into_iter().map(|root| [root; 2]).collect();
        while let Some([first, second]) = pending.pop() {
            if first == second {
                if let Below::Halves([left, right]) = self.below(first) {
                    pending.extend([[left, right], [right, right], [left, left]]);
                }
                continue;
            }
            if !self.rectangle(first).overlaps(self.rectangle(second)) {
                continue;
            }
            let (larger, smaller) =
                if first.size() >= second.size() { (first, second) } else { (second, first) };
            match (self.below(larger), self.below(smaller)) {
                (Below::Halves([left, right]), _) => {
                    pending.extend([[right, smaller], [left, smaller]]);
                }
                (Below::Item(item), Below::Item(other)) => visit([item, other])?,
                (Below::Item(_), Below::Halves(_)) => unreachable!("the larger one has one item"),
            }
        }
        ControlFlow::Continue(())
    }

    /// The nearest item to a point, if one is nearer than the square root of `bound`: its number
    /// and its squared distance, as `distance_squared` gives it. Subtrees that `skips` names are
    /// left out. Each node visited is taken from `budget`; the search ends where that is used up.
    pub fn nearest(
        &self,
        point: [f64; 2],
        mut bound: f64,
        budget: &mut usize,
        skips: impl Fn(Node) -> bool,
        distance_squared: impl Fn(u32) -> f64,
    ) -> Option<(u32, f64)> {
        let mut nearest = None;
        let away = |node| self.rectangle(node).distance_squared(point);
        let mut pending: Vec<Node> = self.root().into_iter().collect();
        while let Some(node) = pending.pop() {
            if *budget == 0 {
                break;
            }
            *budget -= 1;
            if away(node) >= bound || skips(node) {
                continue;
            }
            match self.below(node) {
                Below::Item(item) => {
                    let distance = distance_squared(item);
                    if distance < bound {
                        bound = distance;
                        nearest = Some((item, distance));
                    }
                }
                Below::Halves([left, right]) => {
                    let is_left_nearer = away(left) <= away(right);
                    pending.extend(if is_left_nearer { [right, left] } else { [left, right] });
                }
            }
        }
        nearest
    }
}

/// Appends the subtree of `items`, which it sorts into tree order.
fn build(rectangles: &[Rectangle], items: &mut [u32], nodes: &mut Vec<Rectangle>) {
    let around = |items: &[u32]| {
        let all = items.iter().map(|&item| rectangles[item as usize]);
        all.reduce(Rectangle::union).expect("a subtree has items")
    };
    let rectangle = around(items);
    nodes.push(rectangle);
    if items.len() == 1 {
        return;
    }
    let side = |k: usize| rectangle.high[k] - rectangle.low[k];
    let axis = usize::from(side(1) > side(0));
    let center = |item: u32| {
        let Rectangle { low, high } = rectangles[item as usize];
        low[axis] + high[axis]
    };
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |&i, &j| center(i).total_cmp(&center(j)).then(i.cmp(&j)));
    let (left, right) = items.split_at_mut(middle);
    build(rectangles, left, nodes);
    build(rectangles, right, nodes);
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn what_lies_within_the_hull_well_is_on_no_line_that_bounds_it(
            points in proptest::collection::vec([-8_i8..8, -8_i8..8], 3..40),
        ) {
            let points: Vec<_> = points.into_iter().map(|place| place.map(f64::from)).collect();
            let within = Rectangle::within_hull(points.iter().copied());
            let left = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| {
                (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
            };
            for (&a, &b) in points.iter().flat_map(|a| points.iter().map(move |b| (a, b))) {
                let bounds = a != b && points.iter().all(|&p| left(a, b, p) >= 0.0);
                let mut held = points.iter().filter(|&&p| within.holds_well(p, 0.0));
                prop_assert!(!bounds || held.all(|&p| left(a, b, p) > 0.0));
            }
        }
    }
}
