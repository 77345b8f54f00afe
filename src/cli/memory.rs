//! How much memory a run may take: past what is free the machine would swap, and the run hardly end.

use bytesize::ByteSize;
use clap::Args;
use sysinfo::{MemoryRefreshKind, RefreshKind, System};

use super::failure::Failure;
use super::wording::{bytes, count};

/// What a point of the mesh takes, with its triangles and all that is made on the way: measured from
/// 123 bytes (a million points, not judged) to 333 (100 000 points on a line in a box), and a fifth more.
const BYTES_PER_POINT: u64 = 400;

/// The limit, if it is set.
#[derive(Debug, Clone, Copy, Args)]
pub struct MemoryOption {
    /// Take no more memory than this, as 500MB or 8GiB: the run stops at as many points as fit
    /// [default: nine tenths of what is free].
    #[arg(long, value_name = "SIZE")]
    memory: Option<ByteSize>,
}

/// How many points there is room for.
#[derive(Debug, Clone, Copy)]
pub struct Room {
    /// So many points.
    pub points: usize,
    bytes: u64,
    is_given: bool,
}

impl MemoryOption {
    /// The room that a run has; `None` where the system does not tell what is free.
    pub fn room(self) -> Option<Room> {
        let given = self.memory.map(|size| size.as_u64());
        let bytes = given.or_else(free)?;
        let points = usize::try_from(bytes / BYTES_PER_POINT).unwrap_or(usize::MAX);
        Some(Room { points, bytes, is_given: given.is_some() })
    }
}

impl Room {
    /// Refuses an outline of more points than there is room for.
    pub fn expect(&self, points: usize) -> Result<(), Failure> {
        if points <= self.points {
            return Ok(());
        }
        let outline = count(points, "point");
        Err(self.failure(format!("an outline of {outline} does not fit into {}", self.told())))
    }

    /// Why the run stopped.
    pub fn failure_of_run(&self) -> Failure {
        let points = count(self.points, "point");
        let message = format!(
            "the run stopped at {points}, as many as fit into {}: the mesh is complete, its angles \
             are not",
            self.told()
        );
        self.failure(message)
    }

    fn failure(&self, message: String) -> Failure {
        let help = match self.is_given {
            true => "a larger --memory, or a coarser mesh",
            false => "--memory SIZE sets the limit; a coarser mesh needs less",
        };
        Failure::promise(message).with_help(help)
    }

    fn told(&self) -> String {
        let whose = if self.is_given { "(--memory)" } else { "of free memory" };
        format!("{} {whose}", bytes(self.bytes))
    }
}

/// Nine tenths of the memory that is free, here or within the limits of a container.
fn free() -> Option<u64> {
    let memory = RefreshKind::nothing().with_memory(MemoryRefreshKind::nothing().with_ram());
    let system = System::new_with_specifics(memory);
    let limits = system.cgroup_limits();
    let free = limits.map_or(system.available_memory(), |limits| {
        limits.free_memory.min(system.available_memory())
    });
    (free > 0).then_some(free / 10 * 9)
}
