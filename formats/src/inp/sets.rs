//! Sets of nodes or elements: lists of numbers, ranges of numbers, other sets.

use std::collections::BTreeMap;

use super::read::Line;
use crate::error::SyntaxError;
use crate::numbering::Numbering;
use crate::text::{Scanner, parse_integer};

/// A set, as it stands in the file.
pub(super) struct Set {
    pub name: String,
    members: Vec<Member>,
}

enum Member {
    /// A number, and where it stands.
    Number(i64, usize),
    /// From a number to another, by steps.
    Range([i64; 3], usize),
    /// Another set, and where its name stands.
    Set(String, usize),
}

impl Set {
    /// An empty set.
    pub fn new(name: String) -> Self {
        Self { name, members: Vec::new() }
    }

    /// Reads the lines behind the keyword.
    pub fn read(&mut self, scanner: &mut Scanner, are_ranges: bool) -> Result<(), SyntaxError> {
        while Line::of(scanner) == Line::Data {
            let place = scanner.next_place();
            if are_ranges {
                let what = "the number at the start of a range";
                let first = scanner.integer(what, i64::MIN, i64::MAX)?;
                let what = "the number at the end of a range";
                let last = scanner.integer(what, first, i64::MAX)?;
                let step = match scanner.word() {
                    Some(word) => scanner.integer_in(word, "a step of 1 or more", 1, i64::MAX)?,
                    None => 1,
                };
                self.members.push(Member::Range([first, last, step], place));
            } else {
                self.list(scanner);
            }
            scanner.leave_line();
        }
        Ok(())
    }

    fn list(&mut self, scanner: &mut Scanner) {
        let mut place = scanner.next_place();
        while let Some(word) = scanner.word() {
            self.push_word(word.bytes, place);
            place = scanner.next_place();
        }
    }

    /// Adds a number or the name of a set.
    pub fn push_word(&mut self, word: &[u8], place: usize) {
        self.members.push(match parse_integer(word) {
            Some(number) => Member::Number(number, place),
            None => Member::Set(String::from_utf8_lossy(word).into_owned(), place),
        });
    }

    /// Where its first member stands.
    pub fn place(&self) -> usize {
        self.members.first().map_or(0, |member| match *member {
            Member::Number(_, place) | Member::Range(_, place) | Member::Set(_, place) => place,
        })
    }

    /// Adds one number.
    pub fn push(&mut self, number: i64, place: usize) {
        self.members.push(Member::Number(number, place));
    }
}

/// The members of sets of nodes or of elements.
pub(super) struct Members<'a> {
    numbers: &'a Numbering,
    scanner: &'a Scanner<'a>,
    /// What a member is, for messages.
    what: &'static str,
    /// By the name of the set in capitals; sorted, each once.
    all: BTreeMap<String, Vec<u32>>,
    /// How much ranges and sets may still name: far more than the file has bytes.
    left: u64,
}

impl<'a> Members<'a> {
    pub fn new(numbers: &'a Numbering, what: &'static str, scanner: &'a Scanner<'a>) -> Self {
        let left = MOST_TIMES.saturating_mul(numbers.count().into());
        Self { numbers, scanner, what, all: BTreeMap::new(), left }
    }

    /// Takes a set; one of a name that is known adds to it.
    pub fn add(&mut self, set: &Set) -> Result<(), SyntaxError> {
        let mut members = self.of(set)?;
        let known = self.all.entry(set.name.to_ascii_uppercase()).or_default();
        known.append(&mut members);
        known.sort_unstable();
        known.dedup();
        Ok(())
    }

    /// The members of the set of this name.
    pub fn named(&self, name: &str) -> &[u32] {
        self.all.get(&name.to_ascii_uppercase()).map_or(&[], Vec::as_slice)
    }

    /// The members of a set that may hold sets that are known.
    pub fn of(&mut self, set: &Set) -> Result<Vec<u32>, SyntaxError> {
        let mut members = Vec::new();
        for member in &set.members {
            match member {
                Member::Number(number, place) => members.push(self.index(*number, *place)?),
                &Member::Range([first, last, step], place) => {
                    let inside = self.numbers.between(first, last);
                    self.spend(inside.len(), place)?;
                    let on_step =
                        |&&(number, _): &&(i64, u32)| number.wrapping_sub(first) % step == 0;
                    members.extend(inside.iter().filter(on_step).map(|&(_, index)| index));
                }
                Member::Set(name, place) => {
                    let Some(other) = self.all.get(&name.to_ascii_uppercase()) else {
                        let expected = format!("{} or the name of a set above", self.what);
                        return Err(self.scanner.unexpected_at(*place, expected));
                    };
                    members.extend(other);
                    self.spend(self.named(name).len(), *place)?;
                }
            }
            // Ranges and sets may hold what is there already, again and again.
            if members.len() > 2 * self.numbers.count() as usize {
                members.sort_unstable();
                members.dedup();
            }
        }
        Ok(members)
    }

    fn index(&self, number: i64, place: usize) -> Result<u32, SyntaxError> {
        let index = self.numbers.index(number);
        index.ok_or_else(|| self.scanner.unexpected_at(place, self.what))
    }

    fn spend(&mut self, count: usize, place: usize) -> Result<(), SyntaxError> {
        self.left = self.left.checked_sub(count as u64).ok_or_else(|| {
            self.scanner.unexpected_at(place, "sets that name each member a few times")
        })?;
        Ok(())
    }
}

/// How many times ranges and sets may go through all numbers.
const MOST_TIMES: u64 = 100;
