//! The largest numbers in use, and the next ones that are free.

/// The largest tags so far.
#[derive(Debug)]
pub(in crate::geo) struct Tags {
    pub point: i32,
    pub curve: i32,
    pub curve_loop: i32,
    pub surface: i32,
    /// Of physical groups, whatever their dimension.
    pub group: i32,
    /// Whether curves, loops, surfaces and groups count together (`Geometry.OldNewReg`), which is
    /// Gmsh's default.
    pub together: bool,
}

impl Default for Tags {
    fn default() -> Self {
        Self { point: 0, curve: 0, curve_loop: 0, surface: 0, group: 0, together: true }
    }
}

impl Tags {
    pub(super) fn use_point(&mut self, tag: i32) {
        self.point = self.point.max(tag);
    }

    pub(super) fn use_curve(&mut self, tag: i32) {
        self.curve = self.curve.max(tag);
    }

    pub(super) fn use_loop(&mut self, tag: i32) {
        self.curve_loop = self.curve_loop.max(tag);
    }

    pub(super) fn use_surface(&mut self, tag: i32) {
        self.surface = self.surface.max(tag);
    }

    /// `newp`
    pub(in crate::geo) fn next_point(&self) -> i32 {
        self.point.saturating_add(1)
    }

    /// `newl`
    pub(in crate::geo) fn next_curve(&self) -> i32 {
        if self.together { self.next() } else { self.curve.saturating_add(1) }
    }

    /// `newll`
    pub(in crate::geo) fn next_loop(&self) -> i32 {
        if self.together { self.next() } else { self.curve_loop.saturating_add(1) }
    }

    /// `news`
    pub(in crate::geo) fn next_surface(&self) -> i32 {
        if self.together { self.next() } else { self.surface.saturating_add(1) }
    }

    /// `newreg`
    pub(in crate::geo) fn next(&self) -> i32 {
        let largest = self.curve.max(self.curve_loop).max(self.surface).max(self.group);
        largest.saturating_add(1)
    }

    /// The number of a physical group that is given none: one more than any group has.
    pub(in crate::geo) fn next_group(&self) -> i32 {
        self.group.saturating_add(1)
    }
}
