//! The curves of shapes, cut at every place where two of them meet.

use std::collections::BTreeMap;

use super::track::{Place, Track, distance, meetings};
use crate::geo::error::Problem;
use crate::geo::model::Model;

/// The most pieces that an operation may cut its curves into.
const MOST_PIECES: usize = 20_000;

/// A part of a curve between two vertices that nothing meets in between.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece {
    pub track: Track,
    /// Its first and its last vertex.
    pub ends: [usize; 2],
    /// The curve, where the piece is the whole of one.
    pub whole: Option<i32>,
}

/// A piece, run along from its first end to its last or the other way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Side {
    pub piece: usize,
    pub forward: bool,
}

impl Side {
    pub(super) fn reversed(self) -> Self {
        Self { forward: !self.forward, ..self }
    }
}

/// Vertices and pieces.
#[derive(Debug, Default)]
pub(super) struct Arrangement {
    pub vertices: Vec<Place>,
    /// The point that each vertex is, where it is one; the first of several.
    pub points: Vec<Option<i32>>,
    /// Whether several points lie at a vertex.
    pub merged: Vec<bool>,
    /// The vertices at which whole circles begin and end.
    pub seams: Vec<usize>,
    pub pieces: Vec<Piece>,
    /// By curve: its pieces in the order in which they were cut off, run along as the curve.
    pub curves: Vec<(i32, Vec<Side>)>,
    pub tolerance: f64,
    /// The vertices in each cell of a grid.
    grid: BTreeMap<[i64; 2], Vec<usize>>,
}

impl Arrangement {
    /// Cuts curves. What is nearer than `tolerance` is in one place.
    ///
    /// # Errors
    /// A curve that is no straight line or arc of a circle.
    pub(super) fn new(model: &Model, curves: &[i32], tolerance: f64) -> Result<Self, Problem> {
        let mut arrangement = Self { tolerance, ..Self::default() };
        let mut tracks = Vec::with_capacity(curves.len());
        for &tag in curves {
            let curve = model.curve(tag)?;
            let Some(track) = Track::of(model, curve) else {
                let statement = "a boolean operation of curves other than lines and circles";
                return Err(Problem::Unsupported { statement: statement.to_owned() });
            };
            let ends = curve.ends();
            let ends = [(ends[0], 0.0), (ends[1], 1.0)]
                .map(|(point, t)| arrangement.vertex(track.at(t), Some(point)));
            if ends[0] == ends[1] {
                arrangement.seams.push(ends[0]);
            }
            tracks.push((track, ends));
        }
        // Places where points of the model lie are known before those that are found.
        let known = arrangement.vertices.len();
        let boxes: Vec<[Place; 2]> = tracks.iter().map(|(track, _)| track.around()).collect();
        let meets = |[low, high]: [Place; 2], [from, to]: [Place; 2]| {
            (0..2).all(|k| low[k] <= to[k] + tolerance && from[k] <= high[k] + tolerance)
        };
        let mut cuts: Vec<Vec<usize>> = Vec::with_capacity(tracks.len());
        for (&(track, ends), &around) in tracks.iter().zip(&boxes) {
            let on = |v: &usize| {
                let at = arrangement.vertices[*v];
                !ends.contains(v)
                    && meets(around, [at; 2])
                    && track.parameter(at, tolerance).is_some()
            };
            cuts.push((0..known).filter(on).collect());
        }
        let mut found: Vec<Vec<usize>> = vec![Vec::new(); tracks.len()];
        for i in 0..tracks.len() {
            for j in (0..i).filter(|&j| meets(boxes[i], boxes[j])) {
                for p in meetings(&tracks[i].0, &tracks[j].0, tolerance) {
                    let on = |track: &Track| track.parameter(p, tolerance).is_some();
                    if !on(&tracks[i].0) || !on(&tracks[j].0) {
                        continue;
                    }
                    let v = arrangement.vertex(p, None);
                    for k in [i, j] {
                        if v >= known && !found[k].contains(&v) {
                            found[k].push(v);
                        }
                    }
                }
            }
            arrangement.is_small()?;
        }
        for (i, &tag) in curves.iter().enumerate() {
            let (track, ends) = tracks[i];
            let sides = arrangement.cut(tag, track, ends, &cuts[i], &found[i]);
            arrangement.curves.push((tag, sides));
            arrangement.is_small()?;
        }
        Ok(arrangement)
    }

    /// The pieces of a curve; nothing if it was not asked for.
    pub(super) fn sides(&self, curve: i32) -> &[Side] {
        let found = self.curves.iter().find(|(tag, _)| *tag == curve);
        found.map_or(&[], |(_, sides)| sides)
    }

    /// The vertex where a side begins and the one where it ends.
    pub(super) fn ends(&self, side: Side) -> [usize; 2] {
        let [first, last] = self.pieces[side.piece].ends;
        if side.forward { [first, last] } else { [last, first] }
    }

    /// The track of a side, run along from 0 to 1.
    pub(super) fn track(&self, side: Side) -> Track {
        let track = self.pieces[side.piece].track;
        if side.forward { track } else { track.part(1.0, 0.0) }
    }

    pub(super) fn places(&self, side: Side) -> [Place; 2] {
        self.ends(side).map(|v| self.vertices[v])
    }

    /// # Errors
    /// More pieces or vertices than a script may ask for.
    fn is_small(&self) -> Result<(), Problem> {
        match self.pieces.len().max(self.vertices.len()) > MOST_PIECES {
            true => {
                Err(Problem::Limit { what: "a boolean operation makes more than 20000 pieces" })
            }
            false => Ok(()),
        }
    }

    /// The vertex at a place, perhaps a new one.
    fn vertex(&mut self, p: Place, point: Option<i32>) -> usize {
        let cell = |x: f64| (x / (4.0 * self.tolerance)).floor();
        let [x, y] = p.map(|x| cell(x) as i64);
        let cells = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy)));
        let cells = cells.map(|(dx, dy)| [x.saturating_add(dx), y.saturating_add(dy)]);
        let near = |v: &usize| distance(self.vertices[*v], p) <= self.tolerance;
        let known = cells.filter_map(|cell| self.grid.get(&cell)).flatten().copied();
        if let Some(v) = known.filter(near).min() {
            // Of two points in one place a new one is made.
            self.merged[v] |= point.is_some() && point != self.points[v];
            return v;
        }
        let v = self.vertices.len();
        self.vertices.push(p);
        self.points.push(point);
        self.merged.push(false);
        self.grid.entry([x, y]).or_default().push(v);
        v
    }

    /// Cuts a curve at the points of the model that lie on it, then each part at the places that
    /// were found; a part that is cut goes to the end. (OpenCASCADE's order.)
    fn cut(
        &mut self,
        tag: i32,
        track: Track,
        ends: [usize; 2],
        cuts: &[usize],
        found: &[usize],
    ) -> Vec<Side> {
        let tolerance = self.tolerance;
        let along = |v: usize| track.parameter(self.vertices[v], tolerance).unwrap_or_default();
        let parts = |from: (f64, usize), to: (f64, usize), at: &[usize]| {
            let mut at: Vec<(f64, usize)> = at.iter().map(|&v| (along(v), v)).collect();
            at.retain(|&(t, _)| from.0 < t && t < to.0);
            at.sort_by(|a, b| a.0.total_cmp(&b.0));
            let all: Vec<(f64, usize)> = [&[from][..], &at, &[to]].concat();
            all.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()
        };
        let (mut whole, mut cut) = (Vec::new(), Vec::new());
        for [from, to] in parts((0.0, ends[0]), (1.0, ends[1]), cuts) {
            match &parts(from, to, found)[..] {
                [one] => whole.push(*one),
                many => cut.extend(many),
            }
        }
        whole.append(&mut cut);
        let is_whole = whole.len() == 1 && !ends.iter().any(|&v| self.merged[v]);
        let sides = whole.into_iter().map(|[(from, v), (to, w)]| {
            let part = if (from, to) == (0.0, 1.0) { track } else { track.part(from, to) };
            self.piece(Piece { track: part, ends: [v, w], whole: is_whole.then_some(tag) })
        });
        sides.collect()
    }

    /// A piece, perhaps one that is there already.
    fn piece(&mut self, new: Piece) -> Side {
        let is_at = |a: Place, b: Place| distance(a, b) <= 10.0 * self.tolerance;
        let same = |old: &Piece| {
            let [a, b] = old.ends;
            let ends_agree = [a, b] == new.ends || [b, a] == new.ends;
            ends_agree && is_at(old.track.at(0.5), new.track.at(0.5))
        };
        let Some(piece) = self.pieces.iter().position(same) else {
            self.pieces.push(new);
            return Side { piece: self.pieces.len() - 1, forward: true };
        };
        let forward = is_at(self.pieces[piece].track.at(0.25), new.track.at(0.25));
        if self.pieces[piece].whole.is_none() && new.whole.is_some() {
            // The whole of a curve stands for the parts of others.
            self.pieces[piece] = new;
            if !forward {
                let sides = self.curves.iter_mut().flat_map(|(_, sides)| sides);
                sides.filter(|side| side.piece == piece).for_each(|side| *side = side.reversed());
            }
            return Side { piece, forward: true };
        }
        Side { piece, forward }
    }
}
