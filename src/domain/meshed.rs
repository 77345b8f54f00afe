//! Which faces are meshed, and what region each belongs to: the bounded faces that the outline's
//! [`Enclosed`] tells, but for those with a hole seed.

use super::conflicts::IN_FULL;
use super::error::{Error, Item, Kind, Warning};
use super::faces::{Faces, OUTSIDE};
use super::nesting::nested_oddly;
use super::open_ends::OpenEnds;
use super::sweep::{Linework, Located, Place};
use crate::formats::Enclosed;
use crate::{Pslg, Region};

/// A clean linework, what lies where in it, and what it was made from.
pub struct Clean<'a> {
    /// The outline.
    pub pslg: &'a Pslg,
    /// Its linework, perhaps with hull edges.
    pub linework: Linework<'a>,
    /// What the sweep found; the seeds are those of the holes, then those of the regions.
    pub located: Located,
    /// The input point that each point is.
    pub input_points: &'a [u32],
    /// The input segment that each segment is.
    pub input_segments: &'a [u32],
    /// What is to be meshed.
    pub region: Region,
}

/// What is meshed.
pub struct Meshed {
    /// The faces, with their regions.
    pub faces: Faces,
    /// The hole seeds that take a face out, as indices into those of the outline.
    pub holes: Vec<u32>,
    /// The region seeds that count, as indices into those of the outline.
    pub regions: Vec<u32>,
    /// For each point whether it lies in a meshed face or on the boundary of one.
    pub points: Vec<bool>,
}

impl Clean<'_> {
    /// Decides what is meshed.
    ///
    /// # Errors
    /// A seed on a point or a segment; no face that is left.
    pub fn meshed(&self, warnings: &mut Vec<Warning>) -> Result<Meshed, Error> {
        let mut faces = Faces::new(&self.linework, &self.located);
        self.take_enclosed(&mut faces)?;
        let holes = self.take_holes_out(&mut faces, warnings)?;
        let regions = self.set_regions(&mut faces, warnings)?;
        if !(0..faces.count()).any(|face| faces.is_meshed(face)) {
            let open_ends = OpenEnds::of(self.pslg, &self.linework, self.input_points);
            return Err(if !holes.is_empty() {
                let holes = holes.iter().map(|&hole| self.item(Kind::Hole, hole)).collect();
                Error::HolesLeaveNothing { holes, open_ends }
            } else if faces.count() > OUTSIDE + 1 {
                Error::NoFaceHasSeed { faces: faces.count() - OUTSIDE - 1 }
            } else {
                let last_line = self.pslg.source.last_line.filter(|_| open_ends.count > 0);
                Error::EnclosesNothing { open_ends, last_line }
            });
        }
        let points = self.points_in(&faces);
        self.report_left_out(&faces, &points, warnings);
        Ok(Meshed { faces, holes, regions, points })
    }

    /// Sets the faces that are meshed but for the holes.
    fn take_enclosed(&self, faces: &mut Faces) -> Result<(), Error> {
        let enclosed = match self.region {
            Region::Hull => Enclosed::All,
            _ => self.pslg.enclosed,
        };
        match enclosed {
            Enclosed::All => {
                (OUTSIDE + 1..faces.count()).for_each(|face| faces.set_meshed(face, true));
            }
            Enclosed::EvenOdd => {
                let is_odd = nested_oddly(&self.linework, faces);
                (0..).zip(is_odd).for_each(|(face, is_odd)| faces.set_meshed(face, is_odd));
            }
            Enclosed::Seeded => {
                for region in 0..self.pslg.regions.len() as u32 {
                    let face = self.face_of(faces, Kind::Region, region)?;
                    faces.set_meshed(face, face != OUTSIDE);
                }
            }
        }
        Ok(())
    }

    fn take_holes_out(
        &self,
        faces: &mut Faces,
        warnings: &mut Vec<Warning>,
    ) -> Result<Vec<u32>, Error> {
        let (mut holes, mut outside) = (Vec::new(), Vec::new());
        for hole in 0..self.pslg.holes.len() as u32 {
            match self.face_of(faces, Kind::Hole, hole)? {
                OUTSIDE => outside.push(hole),
                face => {
                    faces.set_meshed(face, false);
                    holes.push(hole);
                }
            }
        }
        if !outside.is_empty() {
            let (count, first) = (outside.len(), self.first(Kind::Hole, &outside));
            warnings.push(Warning::SeedsOutside { count, first });
        }
        Ok(holes)
    }

    fn set_regions(
        &self,
        faces: &mut Faces,
        warnings: &mut Vec<Warning>,
    ) -> Result<Vec<u32>, Error> {
        let mut regions: Vec<u32> = Vec::new();
        let (mut outside, mut in_hole, mut second) = (Vec::new(), Vec::new(), Vec::new());
        for region in 0..self.pslg.regions.len() as u32 {
            let face = self.face_of(faces, Kind::Region, region)?;
            if face == OUTSIDE {
                outside.push(region);
            } else if !faces.is_meshed(face) {
                in_hole.push(region);
            } else if let Some(first) = faces.region(face) {
                second.push([regions[first as usize], region]);
            } else {
                faces.set_region(face, regions.len() as u32);
                regions.push(region);
            }
        }
        if !outside.is_empty() {
            let (count, first) = (outside.len(), self.first(Kind::Region, &outside));
            warnings.push(Warning::SeedsOutside { count, first });
        }
        if !in_hole.is_empty() {
            let (count, first) = (in_hole.len(), self.first(Kind::Region, &in_hole));
            warnings.push(Warning::RegionsInHoles { count, first });
        }
        if !second.is_empty() {
            let item = |region| self.item(Kind::Region, region);
            let first = second.iter().take(IN_FULL).map(|pair| pair.map(item)).collect();
            warnings.push(Warning::RegionsShareFace { count: second.len(), first });
        }
        Ok(regions)
    }

    /// The face in which a seed lies.
    fn face_of(&self, faces: &Faces, kind: Kind, index: u32) -> Result<u32, Error> {
        let before = if kind == Kind::Hole { 0 } else { self.pslg.holes.len() };
        let on = match self.located.seeds[before + index as usize] {
            Place::Above(segment) => return Ok(faces.above(&self.linework, segment)),
            Place::Point(point) => self.item(Kind::Point, self.input_points[point as usize]),
            // A hull edge that the outline lacks is nothing that its author could name.
            Place::Segment(segment) => match self.input_segments[segment as usize] {
                u32::MAX => return Ok(OUTSIDE),
                input => self.item(Kind::Segment, input),
            },
        };
        Err(Error::SeedOnOutline { seed: self.item(kind, index), on: Box::new(on) })
    }

    /// For each point whether it lies in a meshed face or on the boundary of one.
    fn points_in(&self, faces: &Faces) -> Vec<bool> {
        if self.region == Region::Hull && faces.all_are_meshed() {
            return vec![true; self.linework.points.len()];
        }
        let is_bounding =
            |&segment: &u32| faces.sides(segment).iter().any(|&face| faces.is_meshed(face));
        let is_alone = |point: u32| self.linework.adjoining_at(point).is_empty();
        let bounds = |point: u32| self.linework.adjoining_at(point).iter().any(is_bounding);
        let all = 0..self.linework.points.len() as u32;
        let mut is_in: Vec<bool> =
            all.clone().map(|point| is_alone(point) || bounds(point)).collect();
        if !all.clone().any(is_alone) {
            return is_in;
        }
        // What lies in no meshed face is rare, and the order of the sweep is none of the memory.
        for (&point, &below) in self.linework.order.iter().zip(&self.located.below) {
            let face = faces.above(&self.linework, below);
            if !faces.is_meshed(face) && is_alone(point) {
                is_in[point as usize] = false;
            }
        }
        is_in
    }

    fn report_left_out(&self, faces: &Faces, points: &[bool], warnings: &mut Vec<Warning>) {
        let of_input = |input: &[u32], is_out: &dyn Fn(u32) -> bool| -> Vec<u32> {
            let indices = (0..input.len() as u32).filter(|&index| is_out(index));
            // A hull edge that the outline lacks is nobody's loss.
            indices.map(|index| input[index as usize]).filter(|&input| input != u32::MAX).collect()
        };
        let segments = of_input(self.input_segments, &|segment| {
            faces.sides(segment).iter().all(|&face| !faces.is_meshed(face))
        });
        let points = of_input(self.input_points, &|point| !points[point as usize]);
        for (kind, list) in [(Kind::Segment, segments), (Kind::Point, points)] {
            if !list.is_empty() {
                let (count, first) = (list.len(), self.first(kind, &list));
                warnings.push(Warning::LeftOut { count, first });
            }
        }
    }

    fn item(&self, kind: Kind, index: u32) -> Item {
        Item::new(self.pslg, kind, index)
    }

    fn first(&self, kind: Kind, indices: &[u32]) -> Vec<Item> {
        indices.iter().take(IN_FULL).map(|&index| self.item(kind, index)).collect()
    }
}
