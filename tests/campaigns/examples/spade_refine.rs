//! Refines an outline with `spade`, for the benchmark: reads a `.poly` file, meshes it for the
//! smallest angle 26.45° (and a largest area), prints how many points and triangles there are.
//!
//! ```sh
//! cargo run --release -p meshwright-campaigns --example spade_refine -- outline.poly 0.001
//! ```

use std::error::Error;

use meshwright::formats::poly;
use spade::{
    AngleLimit, ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation,
};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let file = arguments.next().ok_or("an outline is wanted: spade_refine FILE.poly [AREA]")?;
    let (outline, _) = poly::read(&std::fs::read(&file)?, &file, |name| std::fs::read(name))?;

    let points = outline.points.iter().map(|&[x, y]| Point2::new(x, y)).collect();
    let segments = outline.segments.iter().map(|ends| ends.map(|end| end as usize)).collect();
    let mut mesh =
        ConstrainedDelaunayTriangulation::<Point2<f64>>::bulk_load_cdt(points, segments)?;

    let mut wanted = RefinementParameters::<f64>::new()
        .with_angle_limit(AngleLimit::from_deg(26.45))
        .with_max_additional_vertices(20 * outline.points.len() + 50_000_000)
        .exclude_outer_faces(true);
    if let Some(area) = arguments.next() {
        wanted = wanted.with_max_allowed_area(area.parse()?);
    }
    let refined = mesh.refine(wanted);
    let triangles = mesh.num_inner_faces() - refined.excluded_faces.len();
    let points = mesh.num_vertices();
    println!("{{\"mesh\":{{\"points\":{points},\"triangles\":{triangles}}}}}");
    Ok(())
}
