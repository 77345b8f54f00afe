//! The physical groups of the entities of version 4.1.
//!
//! ```text
//! entities := $Entities <points> <curves> <surfaces> <volumes> point* curve* surface* volume*
//!             $EndEntities
//! point    := <tag> <x> <y> <z> groups
//! other    := <tag> <box: six numbers> groups <how many bound it> <entity>*
//! groups   := <how many> <physical tag>*
//! ```
//!
//! `$PartitionedEntities` begins with the number of partitions and the ghost entities, and each
//! entity names, after its tag, the entity that it is a part of, and its partitions.

use std::collections::BTreeMap;

use super::end;
use super::source::Source;
use crate::error::SyntaxError;
use crate::node::MOST;
use crate::pslg::Tag;

/// The physical groups that each entity is in, by dimension and tag.
#[derive(Default)]
pub(super) struct Entities {
    groups: BTreeMap<(u8, i64), Vec<Tag>>,
}

impl Entities {
    /// The groups of an entity; `None` where there is no such entity.
    pub fn groups(&self, dim: u8, tag: i64) -> Option<&[Tag]> {
        self.groups.get(&(dim, tag)).map(Vec::as_slice)
    }

    pub fn read<'a>(
        &mut self,
        source: &mut impl Source<'a>,
        is_partitioned: bool,
    ) -> Result<(), SyntaxError> {
        source.begin()?;
        if is_partitioned {
            source.row("the partitions", 0, 1)?;
            source.size("the number of partitions", 0, MOST)?;
            source.end_row()?;
            source.row("the ghost entities", 0, 1)?;
            let ghosts = source.size("the number of ghost entities", 0, MOST)?;
            source.end_row()?;
            for index in 0..ghosts {
                source.row("ghost entity", index, ghosts)?;
                source.int(TAG, i64::MIN, i64::MAX)?;
                source.int("a partition", i64::MIN, i64::MAX)?;
                source.end_row()?;
            }
        }
        source.row("the numbers of entities", 0, 1)?;
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = source.size("the number of entities of a dimension", 0, MOST)?;
        }
        source.end_row()?;
        for (dim, count) in (0..).zip(counts) {
            for index in 0..count {
                source.row("entity", index, count)?;
                self.entity(source, dim, is_partitioned)?;
                source.end_row()?;
            }
        }
        end(
            source.scanner(),
            if is_partitioned { "$EndPartitionedEntities" } else { "$EndEntities" },
        )
    }

    fn entity<'a>(
        &mut self,
        source: &mut impl Source<'a>,
        dim: u8,
        is_partitioned: bool,
    ) -> Result<(), SyntaxError> {
        let tag = source.int(TAG, i64::MIN, i64::MAX)?;
        if self.groups.contains_key(&(dim, tag)) {
            return Err(source.wrong("an entity with a new tag"));
        }
        if is_partitioned {
            source.int("the dimension of the whole entity", 0, 3)?;
            source.int("the tag of the whole entity", i64::MIN, i64::MAX)?;
            let partitions = source.size("the number of partitions", 0, MOST)?;
            for _ in 0..partitions {
                source.int("a partition", i64::MIN, i64::MAX)?;
            }
        }
        for _ in 0..if dim == 0 { 3 } else { 6 } {
            source.any_real("a coordinate")?;
        }
        let count = source.size("the number of physical groups", 0, MOST)?;
        let mut groups = Vec::new();
        for _ in 0..count {
            // A negative sign turns the entity around within its group.
            let least = -i64::from(Tag::MAX);
            groups.push(source.int("a physical group", least, Tag::MAX.into())?.abs() as Tag);
        }
        self.groups.insert((dim, tag), groups);
        if dim > 0 {
            let bounding = source.size("the number of bounding entities", 0, MOST)?;
            for _ in 0..bounding {
                source.int("a bounding entity", i64::MIN, i64::MAX)?;
            }
        }
        Ok(())
    }
}

const TAG: &str = "the tag of an entity";
