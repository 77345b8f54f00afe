//! What an interrupt from the keyboard does.
//!
//! It ends the process, and what is half-written is removed. But for what may stop at any time with
//! a whole mesh (thinning): there the first interrupt only asks it to stop.

use std::io::{self, IsTerminal, Write};
use std::sync::atomic::{AtomicBool, Ordering};

use super::failure::Exit;
use super::output::remove_half_written_and_exit;

/// Whether what runs stops when it is asked to.
static STOPS: AtomicBool = AtomicBool::new(false);
/// Whether it was asked to.
static ASKED: AtomicBool = AtomicBool::new(false);

/// Handles interrupts from now on.
pub fn handle() {
    // Where no handler can be set the process is interrupted as any other is.
    let _ = ctrlc::set_handler(|| {
        if STOPS.load(Ordering::SeqCst) && !ASKED.swap(true, Ordering::SeqCst) {
            return;
        }
        if io::stderr().is_terminal() {
            let _ = write!(io::stderr(), "\r\x1b[2K"); // the line that moves
        }
        remove_half_written_and_exit(Exit::Interrupted);
    });
}

/// Tells whether what runs now will stop when it is asked to.
pub fn stops_when_asked(stops: bool) {
    STOPS.store(stops, Ordering::SeqCst);
}

/// Whether it was asked to.
pub fn asked() -> bool {
    ASKED.load(Ordering::SeqCst)
}
