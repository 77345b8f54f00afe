//! The status of a plane sweep: the segments that the sweep line meets, from bottom to top.
//!
//! A treap whose nodes are also linked in order, so that neighbours, replacement and insertion
//! beside a known node need no comparison.

use crate::predicates::{Side, side};
use crate::random::Random;

/// No node.
pub const NONE: u32 = u32::MAX;

/// A segment of the status.
#[derive(Clone, Copy)]
struct Node {
    segment: u32,
    /// The segment's ends, lexicographically ordered.
    ends: [[f64; 2]; 2],
    previous: u32,
    next: u32,
    parent: u32,
    children: [u32; 2],
    priority: u64,
}

/// Where a point lies in the status.
pub enum Position {
    /// Between the nodes `below` and `above`, either of which may be [`NONE`].
    Between {
        /// The highest node below the point.
        below: u32,
        /// The lowest node above it.
        above: u32,
    },
    /// On the segment of this node.
    On(u32),
}

/// The segments that the sweep line meets, from bottom to top.
pub struct Status {
    nodes: Vec<Node>,
    free: Vec<u32>,
    root: u32,
    first: u32,
    /// A fixed sequence of priorities.
    random: Random,
}

impl Status {
    /// The empty status.
    pub fn new() -> Self {
        Self {
            nodes: Vec::new(),
            free: Vec::new(),
            root: NONE,
            first: NONE,
            random: Random::default(),
        }
    }

    /// The segment of a node.
    pub fn segment(&self, node: u32) -> u32 {
        self.nodes[node as usize].segment
    }

    /// The node below; [`NONE`] at the bottom.
    pub fn below(&self, node: u32) -> u32 {
        self.nodes[node as usize].previous
    }

    /// The node above; [`NONE`] at the top.
    pub fn above(&self, node: u32) -> u32 {
        self.nodes[node as usize].next
    }

    /// The ends of a node's segment, lexicographically ordered.
    pub fn ends(&self, node: u32) -> [[f64; 2]; 2] {
        self.nodes[node as usize].ends
    }

    /// On which side of a node's segment, seen from left to right, a point lies.
    pub fn side(&self, node: u32, point: [f64; 2]) -> Side {
        let [left, right] = self.ends(node);
        side(left, right, point)
    }

    /// Where a point on the sweep line lies.
    pub fn find(&self, point: [f64; 2]) -> Position {
        let (mut below, mut above, mut node) = (NONE, NONE, self.root);
        while node != NONE {
            let children = self.nodes[node as usize].children;
            match self.side(node, point) {
                Side::Left => (below, node) = (node, children[1]),
                Side::Right => (above, node) = (node, children[0]),
                Side::On => return Position::On(node),
            }
        }
        Position::Between { below, above }
    }

    /// Puts another segment in the place of a node's.
    pub fn replace(&mut self, node: u32, segment: u32, ends: [[f64; 2]; 2]) {
        let node = &mut self.nodes[node as usize];
        node.segment = segment;
        node.ends = ends;
    }

    /// Inserts a segment directly above the node `below` ([`NONE`]: at the bottom).
    pub fn insert_above(&mut self, below: u32, segment: u32, ends: [[f64; 2]; 2]) -> u32 {
        let next = if below == NONE { self.first } else { self.above(below) };
        // Directly above `below` is its right child's place, or, where that is taken, the left
        // child's place of the next node, which is then the lowest below that right child.
        let (parent, right) = if below != NONE && self.nodes[below as usize].children[1] == NONE {
            (below, 1)
        } else {
            (next, 0)
        };
        let priority = self.random.bits();
        let fresh =
            Node { segment, ends, previous: below, next, parent, children: [NONE; 2], priority };
        let node = match self.free.pop() {
            Some(node) => {
                self.nodes[node as usize] = fresh;
                node
            }
            None => {
                self.nodes.push(fresh);
                self.nodes.len() as u32 - 1
            }
        };
        match parent {
            NONE => self.root = node,
            parent => self.nodes[parent as usize].children[right] = node,
        }
        self.link(below, node);
        self.link(node, next);
        loop {
            let parent = self.nodes[node as usize].parent;
            if parent == NONE || self.nodes[parent as usize].priority >= priority {
                break node;
            }
            self.rotate_up(node);
        }
    }

    /// Removes a node.
    pub fn remove(&mut self, node: u32) {
        loop {
            let [left, right] = self.nodes[node as usize].children;
            let child = match (left, right) {
                (NONE, child) | (child, NONE) => {
                    self.replace_child(node, child);
                    break;
                }
                _ if self.nodes[left as usize].priority > self.nodes[right as usize].priority => {
                    left
                }
                _ => right,
            };
            self.rotate_up(child);
        }
        let Node { previous, next, .. } = self.nodes[node as usize];
        self.link(previous, next);
        self.free.push(node);
    }

    /// Makes `above` follow `below` in the order from bottom to top.
    fn link(&mut self, below: u32, above: u32) {
        match below {
            NONE => self.first = above,
            below => self.nodes[below as usize].next = above,
        }
        if above != NONE {
            self.nodes[above as usize].previous = below;
        }
    }

    /// Hangs `child` where `node` hangs.
    fn replace_child(&mut self, node: u32, child: u32) {
        let parent = self.nodes[node as usize].parent;
        if child != NONE {
            self.nodes[child as usize].parent = parent;
        }
        match parent {
            NONE => self.root = child,
            parent => {
                let children = &mut self.nodes[parent as usize].children;
                children[usize::from(children[1] == node)] = child;
            }
        }
    }

    /// Makes `node` the parent of its parent; the order stays.
    fn rotate_up(&mut self, node: u32) {
        let parent = self.nodes[node as usize].parent;
        let side = usize::from(self.nodes[parent as usize].children[1] == node);
        let inner = self.nodes[node as usize].children[1 - side];
        self.replace_child(parent, node);
        self.nodes[parent as usize].children[side] = inner;
        if inner != NONE {
            self.nodes[inner as usize].parent = parent;
        }
        self.nodes[node as usize].children[1 - side] = parent;
        self.nodes[parent as usize].parent = node;
    }
}
