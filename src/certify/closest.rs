//! The least distance between items of which neighbours in the list are near each other.
//!
//! A few neighbours make a run with a rectangle around it; two rectangles make a larger one, and so
//! on up to one around all. Two parts whose rectangles are farther apart than the least distance so
//! far need not be looked into. Runs instead of single items keep the tree at a few bytes for each.

use crate::boxes::Rectangle;

/// How many items make a run.
const RUN: usize = 8;

/// Items, and the rectangles around their runs.
pub(super) struct Runs<F> {
    items: Vec<u32>,
    /// The rectangle around an item.
    around: F,
    /// Of runs; of pairs of those; and so on. The last one holds the rectangle around all.
    levels: Vec<Vec<Rectangle>>,
}

/// A rectangle of the tree.
#[derive(Clone, Copy, PartialEq)]
struct Node {
    level: usize,
    place: usize,
}

impl<F: Fn(u32) -> Rectangle> Runs<F> {
    pub(super) fn new(items: Vec<u32>, around: F) -> Self {
        let join = |all: &[Rectangle]| all.iter().copied().reduce(Rectangle::union);
        let of_run = |run: &[u32]| run.iter().map(|&item| around(item)).reduce(Rectangle::union);
        let mut level: Vec<Rectangle> = items.chunks(RUN).filter_map(of_run).collect();
        let mut levels = Vec::new();
        while level.len() > 1 {
            let next = level.chunks(2).filter_map(join).collect();
            levels.push(std::mem::replace(&mut level, next));
        }
        levels.push(level);
        Self { items, around, levels }
    }

    /// The least squared distance of two items, if it is less than `bound`.
    ///
    /// `distance_squared` is infinite for a pair that does not count. Each pair that is looked at is
    /// taken from `budget`; the search ends where that is used up.
    pub(super) fn least_within(
        &self,
        bound: f64,
        budget: &mut usize,
        distance_squared: impl Fn(u32, u32) -> f64,
    ) -> Option<f64> {
        let mut search = Search { least: bound, budget, distance_squared };
        let mut pending = vec![[self.root(); 2]];
        while let Some([first, second]) = pending.pop().filter(|_| search.goes_on()) {
            if first != second {
                search.between((self, first), (self, second));
                continue;
            }
            match self.halves(first) {
                [Some(left), Some(right)] => {
                    pending.extend([[left, right], [right; 2], [left; 2]]);
                }
                [Some(only), None] => pending.push([only; 2]),
                _ => search.within(self.run(first)),
            }
        }
        search.found(bound)
    }

    /// The least squared distance of one of these items and one of the others; see
    /// [`Runs::least_within`].
    pub(super) fn least_between<G: Fn(u32) -> Rectangle>(
        &self,
        other: &Runs<G>,
        bound: f64,
        budget: &mut usize,
        distance_squared: impl Fn(u32, u32) -> f64,
    ) -> Option<f64> {
        let mut search = Search { least: bound, budget, distance_squared };
        search.between((self, self.root()), (other, other.root()));
        search.found(bound)
    }

    fn root(&self) -> Node {
        Node { level: self.levels.len() - 1, place: 0 }
    }

    /// The rectangle of a node; there is none without items.
    fn rectangle(&self, node: Node) -> Option<&Rectangle> {
        self.levels[node.level].get(node.place)
    }

    /// The halves of a node; a run has none, the last node of a level may have one.
    fn halves(&self, Node { level, place }: Node) -> [Option<Node>; 2] {
        let Some(level) = level.checked_sub(1) else { return [None; 2] };
        [2 * place, 2 * place + 1]
            .map(|place| Some(Node { level, place }).filter(|&half| self.rectangle(half).is_some()))
    }

    fn run(&self, node: Node) -> &[u32] {
        let items = self.items.get(RUN * node.place..).unwrap_or_default();
        &items[..items.len().min(RUN)]
    }
}

/// A search for the least distance.
struct Search<'b, D> {
    least: f64,
    budget: &'b mut usize,
    distance_squared: D,
}

impl<D: Fn(u32, u32) -> f64> Search<'_, D> {
    fn goes_on(&self) -> bool {
        *self.budget > 0
    }

    /// The least distance, if it is less than the bound at the start.
    fn found(&self, bound: f64) -> Option<f64> {
        (self.least < bound).then_some(self.least)
    }

    fn look_at(&mut self, item: u32, other: u32) {
        *self.budget = self.budget.saturating_sub(1);
        self.least = self.least.min((self.distance_squared)(item, other));
    }

    fn within(&mut self, run: &[u32]) {
        for (i, &item) in run.iter().enumerate() {
            run[i + 1..].iter().for_each(|&other| self.look_at(item, other));
        }
    }

    fn between<F, G>(&mut self, first: (&Runs<F>, Node), second: (&Runs<G>, Node))
    where
        F: Fn(u32) -> Rectangle,
        G: Fn(u32) -> Rectangle,
    {
        let (items, others) = (first.0, second.0);
        let mut pending = vec![[first.1, second.1]];
        while let Some([first, second]) = pending.pop().filter(|_| self.goes_on()) {
            *self.budget -= 1;
            let (Some(near), Some(far)) = (items.rectangle(first), others.rectangle(second)) else {
                continue;
            };
            if near.gap_squared(far) >= self.least {
                continue;
            }
            if first.level == 0 && second.level == 0 {
                self.between_runs((items, items.run(first)), (others, others.run(second)), far);
            } else if first.level >= second.level {
                let halves = items.halves(first).into_iter().flatten();
                pending.extend(halves.map(|half| [half, second]));
            } else {
                let halves = others.halves(second).into_iter().flatten();
                pending.extend(halves.map(|half| [first, half]));
            }
        }
    }

    fn between_runs<F, G>(
        &mut self,
        (items, run): (&Runs<F>, &[u32]),
        (others, other_run): (&Runs<G>, &[u32]),
        around_others: &Rectangle,
    ) where
        F: Fn(u32) -> Rectangle,
        G: Fn(u32) -> Rectangle,
    {
        for &item in run {
            let around = (items.around)(item);
            if around.gap_squared(around_others) >= self.least {
                continue;
            }
            for &other in other_run {
                if around.gap_squared(&(others.around)(other)) < self.least {
                    self.look_at(item, other);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn rectangles() -> impl Strategy<Value = Vec<Rectangle>> {
        let corner = || [-8_i8..8, -8_i8..8].prop_map(|place| place.map(f64::from));
        let rectangle = (corner(), corner()).prop_map(|(a, b)| Rectangle::around(a, b));
        proptest::collection::vec(rectangle, 0..60)
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn the_least_distance_is_that_of_all_pairs(a in rectangles(), b in rectangles()) {
            let runs = |all: &[Rectangle]| {
                let all = all.to_vec();
                Runs::new((0..all.len() as u32).collect(), move |i| all[i as usize])
            };
            let least = |pairs: &mut dyn Iterator<Item = (&Rectangle, &Rectangle)>| {
                let least = pairs.map(|(a, b)| a.gap_squared(b)).fold(f64::INFINITY, f64::min);
                least.is_finite().then_some(least)
            };
            let (first, second) = (runs(&a), runs(&b));
            let gap = |i: u32, j: u32| a[i as usize].gap_squared(&b[j as usize]);
            let found = first.least_between(&second, f64::INFINITY, &mut usize::MAX.clone(), gap);
            prop_assert_eq!(found, least(&mut a.iter().flat_map(|p| b.iter().map(move |q| (p, q)))));
            let gap = |i: u32, j: u32| a[i as usize].gap_squared(&a[j as usize]);
            let found = first.least_within(f64::INFINITY, &mut usize::MAX.clone(), gap);
            let pairs = (0..a.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
            prop_assert_eq!(found, least(&mut pairs.map(|(i, j)| (&a[i], &a[j]))));
        }
    }
}
