//! Running much work on a few threads: results in order, nothing lost to a panic or a hang.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use meshwright::Pslg;

use crate::poly;

/// How long one piece of work may take before it counts as hung.
pub const PATIENCE: Duration = Duration::from_secs(120);

/// How a piece of work ended.
#[derive(Debug, Clone, PartialEq)]
pub enum Ending<T> {
    /// With a result.
    Done(T),
    /// With a panic that says this.
    Panicked(String),
    /// It did not end within [`PATIENCE`].
    Hung,
}

/// A result and the time that it took.
#[derive(Debug, Clone, PartialEq)]
pub struct Timed<T> {
    /// How the work ended.
    pub ending: Ending<T>,
    /// Wall-clock time.
    pub time: Duration,
}

/// Does a piece of work on a thread of its own, and gives it up if it takes too long.
pub fn guarded<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> Timed<T> {
    let (sender, receiver) = mpsc::channel();
    let start = Instant::now();
    thread::spawn(move || {
        let result = catch_unwind(AssertUnwindSafe(work));
        // Nobody listens any more if the patience is at its end.
        let _ = sender.send(result);
    });
    let ending = match receiver.recv_timeout(PATIENCE) {
        Ok(Ok(result)) => Ending::Done(result),
        Ok(Err(panic)) => Ending::Panicked(message(&*panic)),
        Err(_) => Ending::Hung,
    };
    Timed { ending, time: start.elapsed() }
}

fn message(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "a panic".to_owned())
}

/// Does `count` pieces of work on so many threads and hands the results over in order.
pub fn in_order<T: Send>(
    count: usize,
    threads: usize,
    work: impl Fn(usize) -> T + Sync,
    mut report: impl FnMut(usize, T),
) {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..threads.max(1) {
            let (sender, next, work) = (sender.clone(), &next, &work);
            scope.spawn(move || {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= count || sender.send((index, work(index))).is_err() {
                        break;
                    }
                }
            });
        }
        drop(sender);
        let mut waiting = BTreeMap::new();
        let mut expected = 0;
        for (index, result) in receiver {
            waiting.insert(index, result);
            while let Some(result) = waiting.remove(&expected) {
                report(expected, result);
                expected += 1;
            }
        }
    });
}

/// A folder that failing outlines are written to, as `.poly` files.
#[derive(Debug, Clone)]
pub struct FailureFolder(Option<PathBuf>);

impl FailureFolder {
    /// The folder of this name; `None`: nothing is written.
    ///
    /// # Errors
    /// It can neither be found nor made.
    pub fn new(folder: Option<PathBuf>) -> io::Result<Self> {
        if let Some(folder) = &folder {
            fs::create_dir_all(folder)?;
        }
        Ok(Self(folder))
    }

    /// Whether nothing is written.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.0.is_none()
    }

    /// Writes an outline that failed, with the reason on top.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn keep(&self, name: &str, outline: &Pslg, reason: &str) -> io::Result<()> {
        match &self.0 {
            Some(folder) => {
                fs::write(folder.join(format!("{name}.poly")), poly::text(outline, reason))
            }
            None => Ok(()),
        }
    }
}

/// The largest memory that this process has used, in MiB, where the system tells.
#[must_use]
pub fn peak_memory() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kibibytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kibibytes / 1024)
}
