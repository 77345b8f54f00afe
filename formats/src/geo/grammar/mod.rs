//! The grammar: from the text of a script to its syntax tree, one statement at a time.
//!
//! [`statements`] opens with the productions of statements, which [`control`], [`assignments`],
//! [`entities`] and [`skipping`] hold by kind; [`expressions`] opens with those of expressions,
//! [`commands`] with those of operations on shapes, [`tokens`] with words and numbers.
//! Each production has a function of its name.

mod assignments;
mod commands;
mod control;
mod entities;
mod expressions;
mod input;
mod skipping;
mod statements;
mod tokens;

pub(super) use input::{Fault, Text};
pub(super) use statements::next_statement;
