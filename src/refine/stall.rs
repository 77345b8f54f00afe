//! Where a run was refused something, told by the points of the outline.

use super::Refinement;

impl Refinement<'_> {
    /// The vertices of the domain near which a split or a Steiner point was refused at the
    /// precision floor, in the order of their numbers: the apex of the angle across which the
    /// refused feature lies, where it lies across one.
    #[must_use]
    pub fn stalled_at(&self) -> Vec<u32> {
        let subsegments = self.refused.subsegments.iter().map(|&ends| self.nearer_end(ends));
        let triangles = self.refused.triangles.iter().filter_map(|entry| {
            let vertices = self.mesh.triangles[entry.slot() as usize].vertices;
            (vertices[0] == entry.newest).then(|| self.apex_of(vertices)).flatten()
        });
        let mut found: Vec<u32> = subsegments.flatten().chain(triangles).collect();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// The end of its segment that a subsegment is nearer to.
    fn nearer_end(&self, ends: [u32; 2]) -> Option<u32> {
        let segment = self.segment_of(ends)?;
        let [a, b] = self.segments.ends[segment as usize];
        let twice_middle: f64 = ends.iter().map(|&v| self.distance_along(segment, v)).sum();
        Some(if twice_middle < self.distance_along(segment, b) { a } else { b })
    }

    /// The common end of two segments that a triangle has points of, or a corner that is a point
    /// of the domain.
    fn apex_of(&self, vertices: [u32; 3]) -> Option<u32> {
        let on = vertices.map(|v| self.provenances.segment_point(v).map(|point| point.segment));
        let common = [(0, 1), (1, 2), (2, 0)].into_iter().find_map(|(i, j)| {
            let (s, t) = (on[i]?, on[j]?);
            let shared = self.segments.shared_end(s, t).filter(|_| s != t)?;
            Some(self.segments.ends[s as usize][usize::from(shared[0])])
        });
        common.or_else(|| vertices.into_iter().find(|&v| self.provenances.is_input(v)))
    }
}
