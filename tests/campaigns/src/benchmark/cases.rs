//! Outlines whose meshing is timed. All are made from seeds, but for the world's coasts.

use std::path::Path;

use meshwright::Pslg;
use meshwright::domain::repair;

use crate::Random;
use crate::tangle::Tangle;

/// An outline and how it is to be meshed.
#[derive(Debug, Clone)]
pub struct Case {
    /// Its name in tables and of its file.
    pub name: &'static str,
    /// What it is.
    pub kind: Kind,
    /// Whether Triangle is asked for `-D`: a Delaunay mesh, which is what meshwright makes.
    pub is_conforming: bool,
    /// Whether it is among the cases that take minutes.
    pub is_large: bool,
}

/// What is meshed.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// So many random points in the unit square.
    Points(usize),
    /// So many points where most questions are close calls, in a box.
    Close(Close, usize),
    /// The unit square, in up to so many triangles of one size.
    Square(usize),
    /// So many random segments in the unit square, cut where they cross.
    Segments(usize),
    /// The coasts of the world, as the collection has them.
    World,
    /// The coasts of the world in a box, each segment refined to so many of a rough line.
    RoughWorld(usize),
}

/// Points for which rounding decides little.
#[derive(Debug, Clone, Copy)]
pub enum Close {
    /// The points of a square grid: four on each circle.
    Grid,
    /// The same, turned: nearly so.
    TurnedGrid,
    /// All on one circle, as far as doubles can tell.
    Circle,
    /// All on one line.
    Line,
    /// Half of them on a line, half on another that crosses it: they see each other.
    Cross,
    /// All but a few in a square of a millionth of the width.
    Cluster,
}

impl Close {
    /// So many of them; of a grid as many as fill it.
    fn points(self, count: usize, random: &mut Random) -> Vec<[f64; 2]> {
        let side = (count as f64).sqrt() as usize;
        let grid = || {
            let step = |i: usize| i as f64 / side as f64;
            (0..side * side).map(move |i| [step(i % side), step(i / side)])
        };
        match self {
            Self::Grid => grid().collect(),
            Self::TurnedGrid => {
                let (sine, cosine) = (libm::sin(0.3), libm::cos(0.3));
                grid().map(|[x, y]| [cosine * x - sine * y, sine * x + cosine * y]).collect()
            }
            Self::Circle => (0..count)
                .map(|i| std::f64::consts::TAU * i as f64 / count as f64)
                .map(|angle| [libm::cos(angle), libm::sin(angle)])
                .collect(),
            Self::Line => (0..count).map(|i| [i as f64 / count as f64, 0.5]).collect(),
            Self::Cross => (0..count)
                .map(|i| (i as f64 / count as f64, i.is_multiple_of(2)))
                .map(|(along, is_level)| if is_level { [along, 0.5] } else { [0.5, along] })
                .collect(),
            Self::Cluster => (0..count)
                .map(|_| [0.5 + 1e-6 * random.unit(), 0.5 + 1e-6 * random.unit()])
                .collect(),
        }
    }
}

impl Case {
    /// All cases.
    #[must_use]
    pub fn all() -> Vec<Self> {
        use Kind::{Points, RoughWorld, Segments, Square, World};
        let close = |name, close| Self {
            name,
            kind: Kind::Close(close, 100_000),
            is_conforming: false,
            is_large: false,
        };
        let case = |name, kind| Self { name, kind, is_conforming: false, is_large: false };
        let conforming = |name, kind| Self { is_conforming: true, ..case(name, kind) };
        let large = |name, kind| Self { is_large: true, ..case(name, kind) };
        vec![
            case("points-100k", Points(100_000)),
            case("points-1M", Points(1_000_000)),
            case("square-1M", Square(1_000_000)),
            large("square-5M", Square(5_000_000)),
            large("square-10M", Square(10_000_000)),
            conforming("segments-20k", Segments(20_000)),
            conforming("world50", World),
            conforming("world-400k", RoughWorld(4)),
            close("grid-100k", Close::Grid),
            close("turned-grid-100k", Close::TurnedGrid),
            close("circle-100k", Close::Circle),
            close("line-100k", Close::Line),
            close("cross-100k", Close::Cross),
            close("cluster-100k", Close::Cluster),
        ]
    }

    /// The largest area of a triangle, where there is one.
    ///
    /// With a largest area A the triangles of a mesh have some 0.65 A in the mean (measured); for
    /// 0.57 A, which this allows for, there are an eighth fewer.
    #[must_use]
    pub fn max_area(&self) -> Option<f64> {
        match self.kind {
            Kind::Square(triangles) => Some(1.0 / (0.57 * triangles as f64)),
            _ => None,
        }
    }

    /// The outline. `world` holds the world's coasts; `None` without it where it is needed.
    ///
    /// # Errors
    /// What kept it from being read or made.
    pub fn outline(&self, world: Option<&Path>) -> Result<Option<Pslg>, String> {
        match self.kind {
            Kind::Points(count) => Ok(Some(points(count, &mut Random::new(1)))),
            Kind::Close(close, count) => {
                let points = close.points(count, &mut Random::new(4));
                Ok(Some(boxed(Pslg { points, ..Pslg::default() }, [-2.0; 2], [2.0; 2])))
            }
            Kind::Square(_) => Ok(Some(boxed(Pslg::default(), [0.0; 2], [1.0; 2]))),
            Kind::Segments(count) => segments(count, &mut Random::new(2)).map(Some),
            Kind::World => world.map(read).transpose(),
            Kind::RoughWorld(pieces) => {
                let rough = |world| rough(&read(world)?, pieces, &mut Random::new(3));
                world.map(rough).transpose()
            }
        }
    }
}

fn points(count: usize, random: &mut Random) -> Pslg {
    let points = (0..count).map(|_| [random.unit(), random.unit()]).collect();
    boxed(Pslg { points, ..Pslg::default() }, [0.0; 2], [1.0; 2])
}

fn segments(count: usize, random: &mut Random) -> Result<Pslg, String> {
    // A third as many crossings as segments.
    let soup = Tangle::Soup.outline(count, count / 3, random);
    noded(&boxed(soup, [-0.1; 2], [1.1; 2]))
}

fn read(world: &Path) -> Result<Pslg, String> {
    crate::corpus::read(world).map(|(outline, _)| outline)
}

/// The coasts in a box, each segment replaced by `pieces` (a power of two) of a line whose middles are
/// moved sideways by up to a fifth of its length, again and again; then cut where it crosses itself.
fn rough(world: &Pslg, pieces: usize, random: &mut Random) -> Result<Pslg, String> {
    let mut rough = Pslg { points: world.points.clone(), ..Pslg::default() };
    for &ends in &world.segments {
        let mut line = vec![ends[0], ends[1]];
        while line.len() <= pieces {
            let mut finer = vec![line[0]];
            for pair in line.windows(2) {
                let [a, b] = [0, 1].map(|i| rough.points[pair[i] as usize]);
                let aside = random.range(-0.2, 0.2);
                let middle = rough.points.len() as u32;
                rough.points.push([
                    0.5 * (a[0] + b[0]) - aside * (b[1] - a[1]),
                    0.5 * (a[1] + b[1]) + aside * (b[0] - a[0]),
                ]);
                finer.extend([middle, pair[1]]);
            }
            line = finer;
        }
        rough.segments.extend(line.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    rough.segment_tags = vec![1; rough.segments.len()];
    let [low, high] = [f64::min, f64::max].map(|pick: fn(f64, f64) -> f64| {
        [0, 1].map(|i| rough.points.iter().map(|p| p[i]).reduce(pick).unwrap_or(0.0))
    });
    noded(&boxed(rough, low.map(|x| x - 10.0), high.map(|x| x + 10.0)))
}

/// With a box around it.
fn boxed(mut outline: Pslg, [left, bottom]: [f64; 2], [right, top]: [f64; 2]) -> Pslg {
    let first = outline.points.len() as u32;
    outline.points.extend([[left, bottom], [right, bottom], [right, top], [left, top]]);
    outline.segments.extend((0..4).map(|i| [first + i, first + (i + 1) % 4]));
    outline.segment_tags.resize(outline.segments.len(), 1);
    outline
}

/// Cut where its segments cross.
fn noded(outline: &Pslg) -> Result<Pslg, String> {
    let repaired = repair(outline, 0.0).map_err(|error| error.to_string())?;
    Ok(repaired.outline)
}

#[cfg(test)]
mod tests {
    use meshwright::{Parameters, mesh};

    use super::*;

    #[test]
    fn a_square_has_up_to_an_eighth_fewer_triangles_than_it_is_made_for() {
        let case = Case { kind: Kind::Square(20_000), ..Case::all()[2].clone() };
        let square = case.outline(None).expect("a square is made").expect("it needs no file");
        let parameters = Parameters { max_area: case.max_area(), ..Parameters::default() };
        let found = mesh(&square, &parameters).expect("a square is meshed").mesh.triangles.len();
        assert!((17_000..20_000).contains(&found), "{found}");
    }

    #[test]
    fn points_for_close_calls_are_distinct_and_lie_in_their_box() {
        use Close::{Circle, Cluster, Cross, Grid, Line, TurnedGrid};
        for close in [Grid, TurnedGrid, Circle, Line, Cross, Cluster] {
            let mut points = close.points(1000, &mut Random::new(4));
            assert!((900..=1000).contains(&points.len()), "{close:?}: {}", points.len());
            assert!(points.iter().flatten().all(|x| x.abs() < 2.0), "{close:?}");
            points.sort_by(|p, q| p[0].total_cmp(&q[0]).then(p[1].total_cmp(&q[1])));
            assert!(points.windows(2).all(|pair| pair[0] != pair[1]), "{close:?}");
        }
    }

    #[test]
    fn random_segments_are_cut_where_they_cross() {
        let outline = segments(500, &mut Random::new(2)).expect("they are repaired");
        assert!(outline.segments.len() > 600, "{}", outline.segments.len());
        assert!(mesh(&outline, &Parameters::default()).expect("it is clean").certificate.holds());
    }
}
