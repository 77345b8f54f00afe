//! Where an outline is open: points at which a single segment ends, and the gaps between them.

use std::fmt;

use super::conflicts::IN_FULL;
use super::error::{Item, Kind, Quoted, count_of, number, significant};
use super::sweep::Linework;
use crate::Pslg;
use crate::boxes::{Boxes, Rectangle};

/// Gaps narrower than this part of the outline's extent are likely not meant.
const NARROW: f64 = 0.01;

/// Points at which a single segment ends.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenEnds {
    /// How many there are.
    pub count: usize,
    /// Those with the narrowest gaps.
    pub first: Vec<OpenEnd>,
    /// The tolerance of a [`repair`](super::repair()) that closes the gaps which are narrow beside
    /// the outline, if any are.
    pub closing_tolerance: Option<f64>,
}

/// A point at which a single segment ends.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenEnd {
    /// The point.
    pub point: Item,
    /// The nearest other one and its distance, in the units of the outline.
    pub nearest: Option<(Item, f64)>,
}

impl OpenEnds {
    /// The open ends of an outline, each with the nearest other one, the narrowest gaps first.
    pub(super) fn of(pslg: &Pslg, linework: &Linework, input_points: &[u32]) -> Self {
        let is_open = |&point: &u32| linework.adjoining_at(point).len() == 1;
        let ends: Vec<u32> = (0..linework.points.len() as u32).filter(is_open).collect();
        let places: Vec<[f64; 2]> = ends.iter().map(|&p| linework.points[p as usize]).collect();
        let distance = |[i, j]: [u32; 2]| apart([places[i as usize], places[j as usize]]);
        let pairs = nearest_pairs(&places);

        let inputs = |pair: [u32; 2]| pair.map(|i| input_points[ends[i as usize] as usize]);
        let gap = |pair| apart(inputs(pair).map(|input| pslg.points[input as usize]));
        let first = pairs.iter().take(IN_FULL).map(|&pair| {
            let [point, other] = inputs(pair).map(|input| Item::new(pslg, Kind::Point, input));
            OpenEnd { point, nearest: (pair[0] != pair[1]).then(|| (other, gap(pair))) }
        });
        let narrow = NARROW * extent(linework.points);
        let is_narrow = |pair: &&[u32; 2]| pair[0] != pair[1] && distance(**pair) < narrow;
        let widest = pairs.iter().take_while(is_narrow).last();
        Self {
            count: ends.len(),
            first: first.collect(),
            closing_tolerance: widest.map(|&pair| rounded_up(gap(pair))),
        }
    }

    /// `` `--repair --tolerance 2e-9` closes what is narrow ``
    pub(super) fn advice(&self) -> Option<String> {
        let tolerance = number(self.closing_tolerance?);
        Some(format!("`--repair --tolerance {tolerance}` closes what is narrow"))
    }
}

impl fmt::Display for OpenEnds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, OpenEnd { point, nearest }) in self.first.iter().enumerate() {
            f.write_str(if index == 0 { ": " } else { "\n" })?;
            match nearest {
                None => write!(f, "{point} is an open end{}", Quoted(&[point]))?,
                Some((other, distance)) => {
                    let [a, b] = [point.number, other.number];
                    write!(
                        f,
                        "points {a} and {b} are open ends, {} apart",
                        significant(*distance)
                    )?;
                    write!(f, "{}", Quoted(&[point, other]))?;
                }
            }
        }
        let named = |end: &OpenEnd| 1 + usize::from(end.nearest.is_some());
        let named: usize = self.first.iter().map(named).sum();
        if self.count > named {
            write!(f, "\nand {} more", count_of(self.count - named, "open end"))?;
        }
        Ok(())
    }
}

/// Pairs of a place and the nearest other one (itself where there is none), the nearest first,
/// each pair once.
fn nearest_pairs(places: &[[f64; 2]]) -> Vec<[u32; 2]> {
    let rectangles: Vec<_> = places.iter().map(|&p| Rectangle::around(p, p)).collect();
    let boxes = Boxes::new(&rectangles);
    let distance = |[i, j]: [u32; 2]| apart([places[i as usize], places[j as usize]]);
    let mut budget = usize::MAX;
    let mut nearest = |i: u32| {
        let squared = |j: u32| match distance([i, j]) {
            _ if i == j => f64::INFINITY,
            distance => distance * distance,
        };
        let place = places[i as usize];
        let found = boxes.nearest(place, f64::INFINITY, &mut budget, |_| false, squared);
        found.map_or(i, |(j, _)| j)
    };
    let indices = 0..places.len() as u32;
    let mut pairs: Vec<[u32; 2]> =
        indices.map(|i| (i, nearest(i))).map(|(i, j)| [i.min(j), i.max(j)]).collect();
    pairs.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)).then(a.cmp(&b)));
    pairs.dedup();
    pairs
}

fn apart([[ax, ay], [bx, by]]: [[f64; 2]; 2]) -> f64 {
    libm::hypot(ax - bx, ay - by)
}

/// The longer side of the rectangle around places.
fn extent(places: &[[f64; 2]]) -> f64 {
    let around = places.iter().map(|&p| Rectangle::around(p, p)).reduce(Rectangle::union);
    around.map_or(0.0, |Rectangle { low, high }| (high[0] - low[0]).max(high[1] - low[1]))
}

/// A positive number to one digit, not below it.
fn rounded_up(x: f64) -> f64 {
    let text = format!("{x:.0e}");
    match text.parse() {
        Ok(rounded) if rounded >= x => rounded,
        _ => match text.split_once('e') {
            Some(("9", exponent)) => {
                let exponent = exponent.parse::<i32>().map_or(0, |exponent| exponent + 1);
                format!("1e{exponent}").parse().unwrap_or(x)
            }
            Some((digit, exponent)) => {
                let digit = digit.parse::<u32>().map_or(0, |digit| digit + 1);
                format!("{digit}e{exponent}").parse().unwrap_or(x)
            }
            None => x,
        },
    }
}
