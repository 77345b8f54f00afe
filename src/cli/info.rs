//! `meshwright info`: what a file holds, and whether an outline is ready to mesh.

use std::path::PathBuf;

use clap::Args;
use meshwright::domain::{self, Angle, ClosestPair, Domain, Feature};
use meshwright::formats::{Mesh, Pslg};
use meshwright::statistics::{GroupCount, Statistics};
use meshwright::{MinAngle, Region};

use super::failure::{Exit, Failure};
use super::format::Format;
use super::input::{self, Content, Input};
use super::json;
use super::options::ReadOptions;
use super::repair::{Mended, RepairOptions};
use super::summary::outline_counts;
use super::voice::{Voice, print};
use super::wording::{angle, count, grouped, place, significant};

/// What `info` is asked.
#[derive(Debug, Args)]
pub struct Arguments {
    /// The outline or the mesh (`-`: stdin).
    file: PathBuf,
    /// The format of the file, where its name does not tell.
    #[arg(long, value_name = "FORMAT")]
    from: Option<Format>,
    #[command(flatten)]
    read: ReadOptions,
    #[command(flatten)]
    repair: RepairOptions,
    /// Print the answer as JSON.
    #[arg(long)]
    json: bool,
}

/// What there is to say about an outline.
pub struct OutlineFacts {
    /// Smallest and largest coordinates, `[xmin, ymin, xmax, ymax]`; `None` without points.
    pub extent: Option<[f64; 4]>,
    /// Segments by tag.
    pub groups: Vec<GroupCount>,
    /// What is known where the outline is clean, or what is wrong with it.
    pub domain: Result<DomainFacts, domain::Error>,
}

/// What there is to say about an outline that can be meshed.
pub struct DomainFacts {
    /// The domain.
    pub domain: Domain,
    /// What was merged, dropped or left out.
    pub warnings: Vec<domain::Warning>,
    /// The smallest angle between two adjoining segments.
    pub smallest: Option<Angle>,
    /// How many angles are below the default of `--min-angle`.
    pub small: usize,
    /// The closest pair of features.
    pub closest: Option<ClosestPair>,
    /// lfs_min: the least local feature size, in the units of the outline.
    pub lfs_min: Option<f64>,
}

/// Tells. A file that can be read is a success, whatever it holds.
pub fn run(arguments: &Arguments, voice: &Voice) -> Result<Exit, Failure> {
    let mut input = input::any(&arguments.file, arguments.from, arguments.read, voice)?;
    let text = match input.take() {
        Content::Outline(pslg) => {
            let mended = arguments.repair.mend(pslg, voice)?;
            let facts = OutlineFacts::of(mended.outline());
            if arguments.json {
                json::outline_info(&input, &mended, &facts, voice.warnings())
            } else {
                outline(&input, &mended, &facts, voice).into_bytes()
            }
        }
        Content::Mesh(mesh) => {
            let statistics = Statistics::of(&mesh);
            if arguments.json {
                json::mesh_info(&input, &statistics, voice.warnings())
            } else {
                self::mesh(&input, &mesh, &statistics).into_bytes()
            }
        }
    };
    print(&text).map(|()| Exit::Done)
}

impl OutlineFacts {
    fn of(pslg: &Pslg) -> Self {
        let domain = Domain::new(pslg, Region::Domain).map(|(domain, warnings)| DomainFacts {
            smallest: domain.smallest_angle(),
            small: domain.angles_below(MinAngle::default().radians()).len(),
            closest: domain.closest_pair(),
            lfs_min: domain.lfs_min().map(|lfs| domain.unscaled(lfs)),
            domain,
            warnings,
        });
        Self { extent: extent(&pslg.points), groups: segments_by_tag(pslg), domain }
    }
}

fn outline(input: &Input, mended: &Mended, facts: &OutlineFacts, voice: &Voice) -> String {
    let pslg = mended.outline();
    let base = match pslg.source.first_number {
        0 => "zero-based",
        _ => "one-based",
    };
    let (format, counts) = (input.format.name(), outline_counts(pslg));
    let mut text = line("file", &format!("{}: {format}, {base}, {counts}", input.name));
    if let Some(mended) = mended.text(voice.verbose) {
        text += &line("repaired", &indented(&mended));
    }
    if let Some(extent) = facts.extent {
        text += &line("extent", &extent_text(extent));
    }
    if let Ok(facts) = &facts.domain {
        if let Some(smallest) = facts.smallest {
            text += &line("angles", &smallest_text(smallest, facts, pslg));
        }
        if let Some(closest) = facts.closest {
            text += &line("detail", &closest_text(closest, &facts.domain, pslg));
        }
    }
    if !facts.groups.is_empty() {
        text += &line("groups", &groups_text(&facts.groups, "segment"));
    }
    match &facts.domain {
        Ok(facts) => {
            for warning in &facts.warnings {
                text += &line("warning", &indented(&warning.to_string()));
            }
            text += &line("outline", "ready to mesh");
        }
        Err(error) => {
            text +=
                &line("outline", &format!("not ready to mesh: {}", indented(&error.to_string())));
        }
    }
    text
}

fn mesh(input: &Input, mesh: &Mesh, statistics: &Statistics) -> String {
    let counts = format!(
        "{}: {}, {}, {}, {}",
        input.name,
        input.format.name(),
        count(statistics.points, "point"),
        count(statistics.triangles, "triangle"),
        count(statistics.edges, "boundary and interface edge")
    );
    let mut text = line("file", &counts);
    if let Some(extent) = extent(&mesh.points) {
        text += &line("extent", &extent_text(extent));
    }
    if statistics.triangles > 0 {
        let (smallest, largest) = (statistics.smallest_angle, statistics.largest_angle);
        text += &line("angles", &format!("{} to {}", angle(smallest), angle(largest)));
        text += &line("area", &significant(statistics.area, 6));
    }
    if let Some(kinds) = statistics.kinds {
        let kinds = [
            (kinds.input, "input"),
            (kinds.shell, "shell"),
            (kinds.midpoint, "midpoint"),
            (kinds.circumcenter, "circumcenter"),
        ];
        let kinds = kinds.map(|(number, kind)| format!("{} {kind}", grouped(number as u64)));
        text += &line("points", &kinds.join(", "));
    }
    if !statistics.groups.is_empty() {
        text += &line("groups", &groups_text(&statistics.groups, "edge"));
    }
    text
}

/// A line of the answer: a label and what it says.
fn line(label: &str, text: &str) -> String {
    format!("{label:<11} {text}\n")
}

/// A text of several lines, below a label.
fn indented(text: &str) -> String {
    text.replace('\n', &format!("\n{:12}", ""))
}

fn extent_text([xmin, ymin, xmax, ymax]: [f64; 4]) -> String {
    let size = (xmax - xmin).max(ymax - ymin);
    let largest = [xmin, ymin, xmax, ymax].into_iter().fold(0.0_f64, |m, x| m.max(x.abs()));
    let resolution = largest.next_up() - largest;
    format!(
        "{} to {}: doubles resolve {} here",
        place([xmin, ymin], size),
        place([xmax, ymax], size),
        significant(resolution, 1)
    )
}

/// `smallest 0.42° at point 31 (segments 30, 31): excused in the mesh; 4 below 26.45°`
fn smallest_text(smallest: Angle, facts: &DomainFacts, pslg: &Pslg) -> String {
    let (domain, source) = (&facts.domain, &pslg.source);
    let at = source.point_number(domain.input_points[smallest.apex as usize]);
    let between = match smallest.segments.map(|s| domain.input_segments[s as usize]) {
        [u32::MAX, _] | [_, u32::MAX] => String::new(), // an edge of the convex hull
        segments => {
            let [a, b] = segments.map(|segment| source.segment_number(segment));
            format!(" (segments {a}, {b})")
        }
    };
    let excused = match facts.small {
        0 => String::new(),
        n => {
            let least = angle(MinAngle::default().radians());
            format!(": excused in the mesh; {} below {least}", grouped(n as u64))
        }
    };
    format!("smallest {} at point {at}{between}{excused}", angle(smallest.radians))
}

/// `closest pair: point 88 and segment 12, 0.003 apart; lfs_min 0.0015`
fn closest_text(closest: ClosestPair, domain: &Domain, pslg: &Pslg) -> String {
    let point = |p: u32| pslg.source.point_number(domain.input_points[p as usize]);
    let pair = match closest.feature {
        Feature::Point(other) => format!("points {} and {}", point(closest.point), point(other)),
        Feature::Segment(segment) => match domain.input_segments[segment as usize] {
            u32::MAX => format!("point {} and the convex hull", point(closest.point)),
            input => {
                let segment = pslg.source.segment_number(input);
                format!("point {} and segment {segment}", point(closest.point))
            }
        },
    };
    let apart = significant(closest.distance, 2);
    let lfs_min = significant(0.5 * closest.distance, 2);
    format!("closest pair: {pair}, {apart} apart; lfs_min {lfs_min}")
}

/// `wall (1): 88 segments · inlet (2): 4 segments · untagged: 114 segments`
pub fn groups_text(groups: &[GroupCount], line_noun: &str) -> String {
    const MOST: usize = 12;
    let counted = |group: &GroupCount| {
        count(group.count, if group.dim == 1 { line_noun } else { "triangle" })
    };
    let (tagged, untagged): (Vec<_>, Vec<_>) = groups.iter().partition(|group| group.tag != 0);
    let mut texts: Vec<String> = Vec::new();
    for group in tagged.iter().take(MOST) {
        let name = match (&group.name, group.dim) {
            (Some(name), _) => format!("{name} ({})", group.tag),
            (None, 1) => format!("boundary {}", group.tag),
            (None, _) => format!("region {}", group.tag),
        };
        texts.push(format!("{name}: {}", counted(group)));
    }
    if tagged.len() > MOST {
        texts.push(format!("and {} more", count(tagged.len() - MOST, "group")));
    }
    if !untagged.is_empty() {
        let counts: Vec<String> = untagged.into_iter().map(counted).collect();
        texts.push(format!("untagged: {}", counts.join(", ")));
    }
    texts.join(" · ")
}

fn segments_by_tag(pslg: &Pslg) -> Vec<GroupCount> {
    let as_mesh = Mesh {
        edges: pslg.segments.clone(),
        edge_tags: pslg.segment_tags.clone(),
        groups: pslg.groups.clone(),
        ..Mesh::default()
    };
    Statistics::of(&as_mesh).groups
}

fn extent(points: &[[f64; 2]]) -> Option<[f64; 4]> {
    let [first, ..] = points else { return None };
    let start = [first[0], first[1], first[0], first[1]];
    Some(points.iter().fold(start, |[xmin, ymin, xmax, ymax], &[x, y]| {
        [xmin.min(x), ymin.min(y), xmax.max(x), ymax.max(y)]
    }))
}
