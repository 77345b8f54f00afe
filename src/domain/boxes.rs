//! A tree of bounding boxes: which items lie near a place, without asking all of them.
//!
//! Items are halved at the median of their centers, again and again, across the longer side; so
//! the tree is balanced whatever their distribution.

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

    fn union(self, other: Self) -> Self {
        Self {
            low: [self.low[0].min(other.low[0]), self.low[1].min(other.low[1])],
            high: [self.high[0].max(other.high[0]), self.high[1].max(other.high[1])],
        }
    }

    fn overlaps(&self, other: &Self) -> bool {
        (0..2).all(|k| self.low[k] <= other.high[k] && other.low[k] <= self.high[k])
    }

    /// The distance from a point to the rectangle, squared.
    fn distance_squared(&self, point: [f64; 2]) -> f64 {
        let outside = |k: usize| (self.low[k] - point[k]).max(point[k] - self.high[k]).max(0.0);
        outside(0) * outside(0) + outside(1) * outside(1)
    }
}

/// The tree. Nodes stand in preorder: the left child of a node follows it, the right child
/// follows the left one's subtree (2m − 1 nodes for m items).
pub struct Boxes {
    items: Vec<u32>,
    nodes: Vec<Rectangle>,
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

    /// Visits the items whose rectangles meet `rectangle`, until told to stop.
    pub fn overlapping<B>(
        &self,
        rectangle: &Rectangle,
        mut visit: impl FnMut(u32) -> ControlFlow<B>,
    ) -> ControlFlow<B> {
        let mut pending = vec![(0, 0, self.items.len())];
        while let Some((node, start, end)) = pending.pop() {
            if start == end || !self.nodes[node].overlaps(rectangle) {
                continue;
            }
            if end - start == 1 {
                visit(self.items[start])?;
            } else {
                let middle = start + (end - start) / 2;
                pending.push((right_child(node, start, middle), middle, end));
                pending.push((node + 1, start, middle));
            }
        }
        ControlFlow::Continue(())
    }

    /// The nearest item to a point, if one is nearer than the square root of `bound`: its number
    /// and its squared distance, as `distance_squared` gives it. Each node visited is taken from
    /// `budget`; the search ends where that is used up.
    pub fn nearest(
        &self,
        point: [f64; 2],
        mut bound: f64,
        budget: &mut usize,
        mut distance_squared: impl FnMut(u32) -> f64,
    ) -> Option<(u32, f64)> {
        let mut nearest = None;
        let mut pending = vec![(0, 0, self.items.len())];
        while let Some((node, start, end)) = pending.pop() {
            if *budget == 0 {
                break;
            }
            *budget -= 1;
            if start == end || self.nodes[node].distance_squared(point) >= bound {
                continue;
            }
            if end - start == 1 {
                let distance = distance_squared(self.items[start]);
                if distance < bound {
                    bound = distance;
                    nearest = Some((self.items[start], distance));
                }
                continue;
            }
            let middle = start + (end - start) / 2;
            let left = (node + 1, start, middle);
            let right = (right_child(node, start, middle), middle, end);
            let is_left_nearer = self.nodes[left.0].distance_squared(point)
                <= self.nodes[right.0].distance_squared(point);
            pending.extend(if is_left_nearer { [right, left] } else { [left, right] });
        }
        nearest
    }
}

fn right_child(node: usize, start: usize, middle: usize) -> usize {
    node + 2 * (middle - start)
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
