//! The entities of version 4.1: what groups belong to.

use std::collections::BTreeMap;

use crate::groups::{FreshTags, Table};
use crate::nodes::Nodes;
use crate::pslg::Tag;

/// A point, a curve or a surface.
pub(super) struct Entity {
    pub dim: u8,
    pub number: Tag,
    /// Its groups, as indices into the table's entries.
    pub groups: Vec<u32>,
    /// Least and largest coordinates.
    pub bounds: [[f64; 2]; 2],
}

impl Entity {
    fn new(dim: u8, number: Tag, groups: Vec<u32>) -> Self {
        Self { dim, number, groups, bounds: [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]] }
    }

    fn reach(&mut self, point: [f64; 2]) {
        let [least, most] = &mut self.bounds;
        for axis in 0..2 {
            least[axis] = least[axis].min(point[axis]);
            most[axis] = most[axis].max(point[axis]);
        }
    }
}

/// The entities of a mesh, and what lies on each.
pub(super) struct Entities {
    /// Points, then curves, then surfaces.
    pub all: Vec<Entity>,
    /// The nodes of the entities that are points.
    pub points: Vec<u32>,
    /// The entity of each edge, as an index into `all`.
    pub of_edges: Vec<u32>,
    /// That of each triangle.
    pub of_triangles: Vec<u32>,
    /// That of each node: the one of the lowest dimension whose cells have it.
    pub of_nodes: Vec<u32>,
}

impl Entities {
    pub fn new(nodes: &Nodes, table: &Table) -> Self {
        let mesh = nodes.mesh;
        let mut further: [BTreeMap<u32, Vec<u32>>; 2] = Default::default();
        for (membership, &group) in mesh.memberships.iter().zip(&table.memberships) {
            let of = &mut further[usize::from(membership.dim.min(1))];
            of.entry(membership.item).or_default().push(group);
        }
        let [of_points, of_edges] = further;
        let point = |(number, groups)| Entity::new(0, number, sorted(groups));
        let mut all: Vec<Entity> = (1..).zip(of_points.values().cloned()).map(point).collect();
        let sets = table.edges.iter().enumerate().map(|(edge, &group)| {
            let further = of_edges.get(&(edge as u32)).into_iter().flatten();
            sorted(further.chain([&group]).copied().collect())
        });
        let of_edges = add(&mut all, 1, sets, table);
        let mut last = None; // neighbours in the file mostly share their region
        let sets = (0..mesh.triangles.len()).map(|triangle| {
            let tag = mesh.triangle_tag(triangle);
            let group = match last {
                Some((same, group)) if same == tag => group,
                _ => table.region(tag) as u32,
            };
            last = Some((tag, group));
            [group]
        });
        let of_triangles = add(&mut all, 2, sets, table);
        let points = of_points.into_keys().collect();
        let of_nodes = vec![u32::MAX; nodes.len()];
        let mut entities = Self { all, points, of_edges, of_triangles, of_nodes };
        entities.take_nodes(nodes);
        entities
    }

    fn take_nodes(&mut self, nodes: &Nodes) {
        let Self { all, points, of_edges, of_triangles, of_nodes } = self;
        let mut take = |entity: u32, node: u32| {
            let of = &mut of_nodes[node as usize];
            if *of == entity {
                return;
            }
            *of = entity.min(*of);
            all[entity as usize].reach(nodes.point(node as usize));
        };
        (0..).zip(points).for_each(|(entity, point)| take(entity, *point));
        for (edge, &entity) in of_edges.iter().enumerate() {
            nodes.edge(edge).for_each(|node| take(entity, node));
        }
        for (triangle, &entity) in of_triangles.iter().enumerate() {
            nodes.triangle(triangle).for_each(|node| take(entity, node));
        }
        self.take_unused_nodes(nodes);
    }

    /// Gives the nodes that no cell has to the last surface, or to one of their own.
    fn take_unused_nodes(&mut self, nodes: &Nodes) {
        for (node, of) in self.of_nodes.iter_mut().enumerate().filter(|(_, of)| **of == u32::MAX) {
            if self.all.last().is_none_or(|entity| entity.dim < 2) {
                self.all.push(Entity::new(2, 1, Vec::new()));
            }
            *of = self.all.len() as u32 - 1;
            self.all[*of as usize].reach(nodes.point(node));
        }
    }
}

fn sorted(mut groups: Vec<u32>) -> Vec<u32> {
    groups.sort_unstable();
    groups.dedup();
    groups
}

/// Adds an entity for each set of groups; returns the entity of each item. An entity has the number
/// of its group where it is one alone, else a number that no group has.
fn add<S: AsRef<[u32]>>(
    all: &mut Vec<Entity>,
    dim: u8,
    sets: impl Iterator<Item = S>,
    table: &Table,
) -> Vec<u32> {
    let numbers = table.entries.iter().filter(|entry| entry.dim == dim).map(|entry| entry.number);
    let mut fresh = FreshTags::beside(numbers.collect());
    let mut known: BTreeMap<Vec<u32>, u32> = BTreeMap::new();
    let mut last: Option<(S, u32)> = None; // neighbours in the file mostly have the same groups
    let mut entity = |set: &[u32]| {
        if let Some(&entity) = known.get(set) {
            return entity;
        }
        let number = match set {
            [group] => table.entries[*group as usize].number,
            _ => fresh.take(),
        };
        all.push(Entity::new(dim, number, set.to_vec()));
        let entity = all.len() as u32 - 1;
        known.insert(set.to_vec(), entity);
        entity
    };
    sets.map(|set| {
        let found = match &last {
            Some((same, found)) if same.as_ref() == set.as_ref() => *found,
            _ => entity(set.as_ref()),
        };
        last = Some((set, found));
        found
    })
    .collect()
}
