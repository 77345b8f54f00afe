//! Assignments to variables, and constants.

use super::Evaluator;
use super::functions::binary;
use super::value::Value;
use crate::geo::error::Problem;
use crate::geo::sources::Answer;
use crate::geo::syntax::{Assignment, Constant, Expression, Name, Operator, Target};

impl Evaluator<'_, '_> {
    /// `a = 1;`, `a[] += {2, 3};`, `a[1] *= 2;`
    pub(super) fn assign(
        &mut self,
        target: &Target,
        operator: Assignment,
        value: &Expression,
    ) -> Answer<()> {
        let new = self.value(value)?;
        match target {
            Target::Variable(name) => self.assign_variable(name, operator, new),
            Target::Whole(name) => self.assign_list(name, operator, new),
            Target::Elements(name, index) => self.assign_elements(name, index, operator, new),
        }
    }

    fn assign_variable(&mut self, name: &Name, operator: Assignment, new: Value) -> Answer<()> {
        let key = self.key(name)?;
        if operator == Assignment::Set {
            self.variables.insert(key, new);
            return Ok(());
        }
        match (self.variables.get(&key), &new) {
            (Some(Value::List(_)), Value::List(_)) => return self.assign_list(name, operator, new),
            (Some(Value::Number(_) | Value::List(_)), _) => {}
            (Some(other), _) => {
                let found = other.kind();
                return Err(Problem::Kind { expected: "a number".into(), found }.at(name.place));
            }
            (None, _) => return Err(unknown_variable(key).at(name.place)),
        }
        let old = self.variables.get(&key).and_then(Value::first);
        let old = old.map_or(Ok(0.0), |old| old.number());
        let changed = old.and_then(|old| self.changed(old, operator, new.number()?));
        let changed = changed.map_err(|problem| problem.at(name.place))?;
        self.variables.insert(key, Value::Number(changed));
        Ok(())
    }

    fn assign_list(&mut self, name: &Name, operator: Assignment, new: Value) -> Answer<()> {
        let key = self.key(name)?;
        let new = match new {
            Value::Number(number) => Value::List(vec![number]),
            Value::Text(text) => Value::Texts(vec![text]),
            list => list,
        };
        self.spend(new.size(), name.place)?;
        let old = self.variables.entry(key).or_insert(Value::List(Vec::new()));
        if let Value::Number(number) = *old {
            *old = Value::List(vec![number]);
        }
        match (old, operator, new) {
            (old, Assignment::Set, new) => *old = new,
            (Value::List(old), Assignment::Add, Value::List(new)) => old.extend(new),
            (Value::Texts(old), Assignment::Add, Value::Texts(new)) => old.extend(new),
            (old @ Value::List(_), Assignment::Add, new) if old.size() == 0 => *old = new,
            (Value::List(old), Assignment::Subtract, Value::List(new)) => {
                old.retain(|number| !new.contains(number));
            }
            (_, _, new) => {
                let (expected, found) = ("a list that `+=` or `-=` can change".into(), new.kind());
                return Err(Problem::Kind { expected, found }.at(name.place));
            }
        }
        Ok(())
    }

    /// `a[i] = 1;`, `a[{i, j}] = {1, 2};`: a list grows where it must.
    fn assign_elements(
        &mut self,
        name: &Name,
        index: &Expression,
        operator: Assignment,
        new: Value,
    ) -> Answer<()> {
        let key = self.key(name)?;
        let place = index.place;
        let indices = self.numbers(index)?;
        let new = new.numbers().map_err(|problem| problem.at(name.place))?;
        if new.len() != indices.len() {
            let expected = "as many numbers as there are indices";
            return Err(Problem::Count { what: "a list", expected, found: new.len() }.at(place));
        }
        let mut list = match self.variables.remove(&key) {
            None => Vec::new(),
            Some(old) => old.numbers().map_err(|problem| problem.at(name.place))?,
        };
        for (index, new) in indices.into_iter().zip(new) {
            let index =
                super::value::whole(index, "an index").map_err(|problem| problem.at(place))?;
            let Ok(position) = usize::try_from(index) else {
                let (index, length) = (i64::from(index), list.len());
                return Err(Problem::Index { name: key, index, length }.at(place));
            };
            if position >= list.len() {
                self.spend((position + 1 - list.len()) as u64, place)?;
                list.resize(position + 1, 0.0);
            }
            list[position] = match operator {
                Assignment::Set => new,
                operator => {
                    let changed = self.changed(list[position], operator, new);
                    changed.map_err(|problem| problem.at(place))?
                }
            };
        }
        self.variables.insert(key, Value::List(list));
        Ok(())
    }

    /// A number after `+=`, `-=`, …
    pub(super) fn changed(&self, old: f64, operator: Assignment, new: f64) -> Result<f64, Problem> {
        let operator = match operator {
            Assignment::Set => return Ok(new),
            Assignment::Add => Operator::Add,
            Assignment::Subtract => Operator::Subtract,
            Assignment::Multiply => Operator::Multiply,
            Assignment::Divide => Operator::Divide,
        };
        binary(operator, Value::Number(old), Value::Number(new))?.number()
    }

    /// Constants that have no value yet get one.
    pub(super) fn define(&mut self, constants: &[Constant]) -> Answer<()> {
        for Constant { target, value } in constants {
            let (Target::Variable(name) | Target::Whole(name) | Target::Elements(name, _)) = target;
            let key = self.key(name)?;
            if self.variables.contains_key(&key) {
                continue;
            }
            let value = match value {
                Some(value) => self.value(value)?,
                None => Value::Number(0.0),
            };
            self.spend(value.size(), name.place)?;
            self.variables.insert(key, value);
        }
        Ok(())
    }

    /// The whole name of a variable: `x~{1}` is `x_1`.
    pub(super) fn key(&mut self, name: &Name) -> Answer<String> {
        let mut key = name.base.clone();
        for suffix in &name.suffixes {
            let number = self.number(suffix)?;
            key = format!("{key}_{}", number.trunc());
        }
        self.spend(key.len() as u64 / 8, name.place)?;
        Ok(key)
    }
}

/// A variable that has no value.
pub(super) fn unknown_variable(key: String) -> Problem {
    Problem::Unknown { what: "variable", name: format!("`{key}`") }
}
