//! Edges as few long lines: each edge once, the next one where the last one ended.

/// How the ends of an edge may be walked.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Walk {
    /// From either end.
    BothWays,
    /// From the first end to the second.
    Forwards,
}

/// Trails that hold each edge once. Lines begin where an odd number of edges meet, so that the
/// others close.
pub fn trails(edges: &[[u32; 2]], walk: Walk) -> Vec<Vec<u32>> {
    let Some(largest) = edges.iter().flatten().max() else {
        return Vec::new();
    };
    let mut start = vec![0_u32; *largest as usize + 2];
    let ends = |edge: &[u32; 2]| match walk {
        Walk::BothWays => (edge[0], Some(edge[1])),
        Walk::Forwards => (edge[0], None),
    };
    for edge in edges {
        let (a, b) = ends(edge);
        start[a as usize + 1] += 1;
        b.into_iter().for_each(|b| start[b as usize + 1] += 1);
    }
    for i in 1..start.len() {
        start[i] += start[i - 1];
    }
    // The edges at vertex v are at[start[v]..start[v + 1]].
    let mut next = start.clone();
    let mut at = vec![0_u32; start[start.len() - 1] as usize];
    let mut put = |vertex: u32, edge: usize| {
        at[next[vertex as usize] as usize] = edge as u32;
        next[vertex as usize] += 1;
    };
    for (i, edge) in edges.iter().enumerate() {
        let (a, b) = ends(edge);
        put(a, i);
        b.into_iter().for_each(|b| put(b, i));
    }

    let mut walked = vec![false; edges.len()];
    let mut next = start.clone();
    let mut leave = |vertex: u32| {
        let end = start[vertex as usize + 1];
        let place = &mut next[vertex as usize];
        while *place < end {
            let edge = at[*place as usize] as usize;
            *place += 1;
            if !std::mem::replace(&mut walked[edge], true) {
                let [a, b] = edges[edge];
                return Some(if a == vertex { b } else { a });
            }
        }
        None
    };
    let degree = |vertex: usize| start[vertex + 1] - start[vertex];
    let vertices = start.len() - 1;
    let odd = (0..vertices).filter(|&v| walk == Walk::BothWays && degree(v) % 2 == 1);
    let mut trails = Vec::new();
    for vertex in odd.chain(0..vertices) {
        let first = vertex as u32;
        while let Some(second) = leave(first) {
            let mut trail = vec![first, second];
            while let Some(vertex) = leave(trail[trail.len() - 1]) {
                trail.push(vertex);
            }
            trails.push(trail);
        }
    }
    trails
}
