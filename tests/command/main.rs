//! The command as a user meets it: exit codes, messages, files.

mod bench;
mod converting;
mod drawing;
mod files;
mod json;
mod messages;
mod outlines;
mod repairing;
mod schema;
mod signals;
mod tracing;
mod triangle;
mod writing;
