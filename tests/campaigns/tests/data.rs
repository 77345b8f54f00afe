//! Real outlines with known answers.

fn main() {}
