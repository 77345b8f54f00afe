//! The values of expressions.

use super::Evaluator;
use super::assign::unknown_variable;
use super::functions::{binary, call, finite};
use super::value::{Value, whole};
use crate::geo::error::Problem;
use crate::geo::sources::Answer;
use crate::geo::syntax::{Expression, Fresh, Name, Operator, Place, Term};

impl Evaluator<'_, '_> {
    /// The value of an expression.
    pub(super) fn value(&mut self, expression: &Expression) -> Answer<Value> {
        let place = expression.place;
        self.spend(1, place)?;
        Ok(match &expression.term {
            Term::Number(number) => Value::Number(*number),
            Term::Text(text) => {
                self.spend(text.len() as u64 / 8, place)?;
                Value::Text(text.clone())
            }
            Term::Variable(name) => self.variable(name)?,
            Term::Whole(name) => {
                let value = self.stored(name)?.clone();
                self.spend(value.size(), place)?;
                match value {
                    Value::Number(number) => Value::List(vec![number]),
                    value => value,
                }
            }
            Term::Elements(name, index) => self.elements(name, index)?,
            Term::Count(name) => Value::Number(match self.stored(name)? {
                Value::Number(_) | Value::Text(_) => 1.0,
                Value::List(list) => list.len() as f64,
                Value::Texts(texts) => texts.len() as f64,
            }),
            Term::Increment(name, by) => self.increment(name, *by)?,
            Term::Option(name) => match self.option_value(name) {
                Some(value) => value,
                None => {
                    let name = format!("`{name}` that matters to a plane mesh");
                    return Err(Problem::Unknown { what: "option", name }.at(place));
                }
            },
            Term::Fresh(fresh) => Value::Number(f64::from(self.fresh(*fresh))),
            Term::Negative(operand) => match self.value(operand)? {
                Value::List(list) => Value::List(list.into_iter().map(|x| -x).collect()),
                other => Value::Number(-other.number().map_err(|problem| problem.at(place))?),
            },
            Term::Not(operand) => Value::Number(f64::from(u8::from(self.number(operand)? == 0.0))),
            Term::Binary(operator, operands) => self.binary(place, *operator, operands)?,
            Term::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                if self.number(condition)? != 0.0 { self.value(yes)? } else { self.value(no)? }
            }
            Term::Range(ends, step) => Value::List(self.range(place, ends, step.as_deref())?),
            Term::List(items) => self.list(place, items)?,
            Term::Call(function, arguments) => {
                let mut values = Vec::with_capacity(arguments.len());
                for argument in arguments {
                    values.push(self.value(argument)?);
                }
                let value = call(*function, values).map_err(|problem| problem.at(place))?;
                self.spend(value.size(), place)?;
                value
            }
            Term::Default(value) => self.value(value)?,
            Term::Exists(name) => {
                let key = self.key(name)?;
                Value::Number(f64::from(u8::from(self.variables.contains_key(&key))))
            }
            Term::All(dim) => {
                let all = self.model.all(*dim);
                self.spend(all.len() as u64, place)?;
                Value::List(all.into_iter().map(f64::from).collect())
            }
            Term::InBox(dim, corners) => self.in_box(*dim, corners)?,
            Term::Coordinates(tag) => self.coordinates(tag)?,
            Term::Members(dim, tag) => self.members(*dim, tag)?,
            Term::Command(command) => {
                let shapes = self.command(command)?;
                Value::List(shapes.into_iter().map(|(_, tag)| f64::from(tag)).collect())
            }
        })
    }

    /// The one number that an expression is.
    pub(super) fn number(&mut self, expression: &Expression) -> Answer<f64> {
        self.value(expression)?.number().map_err(|problem| problem.at(expression.place))
    }

    /// The numbers that an expression is.
    pub(super) fn numbers(&mut self, expression: &Expression) -> Answer<Vec<f64>> {
        self.value(expression)?.numbers().map_err(|problem| problem.at(expression.place))
    }

    /// The one text that an expression is.
    pub(super) fn text(&mut self, expression: &Expression) -> Answer<String> {
        self.value(expression)?.text().map_err(|problem| problem.at(expression.place))
    }

    /// The whole number that an expression is; `what` says of what.
    pub(super) fn tag(&mut self, expression: &Expression, what: &'static str) -> Answer<i32> {
        let number = self.number(expression)?;
        whole(number, what).map_err(|problem| problem.at(expression.place))
    }

    /// The whole numbers that an expression is.
    pub(super) fn tags(&mut self, expression: &Expression, what: &'static str) -> Answer<Vec<i32>> {
        let numbers = self.numbers(expression)?;
        let tags = numbers.into_iter().map(|number| whole(number, what));
        tags.collect::<Result<_, _>>().map_err(|problem| problem.at(expression.place))
    }

    /// Exactly so many numbers.
    pub(super) fn exactly<const N: usize>(
        &mut self,
        expression: &Expression,
        what: &'static str,
        expected: &'static str,
    ) -> Answer<[f64; N]> {
        let numbers = self.numbers(expression)?;
        let found = numbers.len();
        let failed = |_| Problem::Count { what, expected, found }.at(expression.place);
        numbers.try_into().map_err(failed)
    }

    fn stored(&mut self, name: &Name) -> Answer<&Value> {
        let key = self.key(name)?;
        match self.variables.get(&key) {
            Some(value) => Ok(value),
            None => Err(unknown_variable(key).at(name.place)),
        }
    }

    /// A variable's value; of a list the first element, as in Gmsh.
    fn variable(&mut self, name: &Name) -> Answer<Value> {
        if let (Some(&Value::Number(number)), []) =
            (self.variables.get(&name.base), &name.suffixes[..])
        {
            return Ok(Value::Number(number));
        }
        let first = self.stored(name)?.first();
        match first {
            Some(first) => {
                self.spend(first.size() / 8, name.place)?;
                Ok(first)
            }
            None => {
                let (name_of, place) = (self.key(name)?, name.place);
                Err(Problem::Index { name: name_of, index: 0, length: 0 }.at(place))
            }
        }
    }

    fn elements(&mut self, name: &Name, index: &Expression) -> Answer<Value> {
        let indices = self.value(index)?;
        let is_one = matches!(indices, Value::Number(_));
        let indices = indices.numbers().map_err(|problem| problem.at(index.place))?;
        let key = self.key(name)?;
        let stored = self.stored(name)?;
        let mut found = Vec::with_capacity(indices.len());
        let mut texts = Vec::new();
        for value in indices {
            let position = whole(value, "an index").map_err(|problem| problem.at(index.place))?;
            let at = usize::try_from(position).ok();
            let length = match stored {
                Value::List(list) => {
                    if let Some(&element) = at.and_then(|at| list.get(at)) {
                        found.push(element);
                        continue;
                    }
                    list.len()
                }
                Value::Texts(list) => {
                    if let Some(element) = at.and_then(|at| list.get(at)) {
                        texts.push(element.clone());
                        continue;
                    }
                    list.len()
                }
                &Value::Number(number) if position == 0 => {
                    found.push(number);
                    continue;
                }
                _ => 1,
            };
            let index_of = i64::from(position);
            return Err(Problem::Index { name: key, index: index_of, length }.at(index.place));
        }
        if let Some(text) = texts.pop() {
            if texts.is_empty() && is_one {
                return Ok(Value::Text(text));
            }
            texts.push(text);
            return Ok(Value::Texts(texts));
        }
        self.spend(found.len() as u64, name.place)?;
        Ok(if is_one { Value::Number(found[0]) } else { Value::List(found) })
    }

    /// `a++`: the value after it.
    fn increment(&mut self, name: &Name, by: f64) -> Answer<Value> {
        let number = self.variable(name)?.number().map_err(|problem| problem.at(name.place))?;
        let key = self.key(name)?;
        let value = Value::Number(number + by);
        self.variables.insert(key, value.clone());
        Ok(value)
    }

    fn fresh(&self, fresh: Fresh) -> i32 {
        let tags = &self.model.tags;
        match fresh {
            Fresh::Point => tags.next_point(),
            Fresh::Curve => tags.next_curve(),
            Fresh::CurveLoop => tags.next_loop(),
            Fresh::Surface => tags.next_surface(),
            Fresh::Region => tags.next(),
            Fresh::Solid => {
                if tags.together {
                    tags.next()
                } else {
                    1
                }
            }
        }
    }

    /// An operation; `&&` and `||` leave out what does not matter.
    fn binary(
        &mut self,
        place: Place,
        operator: Operator,
        operands: &[Expression; 2],
    ) -> Answer<Value> {
        let [left, right] = operands;
        let left = self.value(left)?;
        match operator {
            Operator::And | Operator::Or => {
                let truth = left.number().map_err(|problem| problem.at(place))? != 0.0;
                if truth == (operator == Operator::Or) {
                    return Ok(Value::Number(f64::from(u8::from(truth))));
                }
            }
            _ => {}
        }
        let right = self.value(right)?;
        binary(operator, left, right).map_err(|problem| problem.at(place))
    }

    fn range(
        &mut self,
        place: Place,
        ends: &[Expression; 2],
        step: Option<&Expression>,
    ) -> Answer<Vec<f64>> {
        let (first, last) = (self.number(&ends[0])?, self.number(&ends[1])?);
        let step = match step {
            Some(step) => self.number(step)?,
            None if last >= first => 1.0,
            None => -1.0,
        };
        let count = ((last - first) / step * (1.0 + 1e-12) + 1e-12).floor();
        if step == 0.0 {
            return Err(Problem::Endless.at(place));
        }
        if count < 0.0 {
            return Ok(Vec::new());
        }
        finite(count, || format!("{first}:{last}:{step}")).map_err(|problem| problem.at(place))?;
        self.spend(count.min(1e18) as u64 + 1, place)?;
        Ok((0..=count as u64).map(|i| first + step * i as f64).collect())
    }

    /// `{1, a[], 3:5}`: numbers in a row, or texts.
    fn list(&mut self, place: Place, items: &[Expression]) -> Answer<Value> {
        let mut numbers = Vec::with_capacity(items.len());
        let mut texts = Vec::new();
        for item in items {
            match self.value(item)? {
                Value::Number(number) => numbers.push(number),
                Value::List(list) => numbers.extend(list),
                Value::Text(text) => texts.push(text),
                Value::Texts(list) => texts.extend(list),
            }
        }
        match (numbers.is_empty(), texts.is_empty()) {
            (_, true) => Ok(Value::List(numbers)),
            (true, false) => Ok(Value::Texts(texts)),
            (false, false) => {
                let expected = "a list of numbers or a list of texts".into();
                Err(Problem::Kind { expected, found: "both" }.at(place))
            }
        }
    }

    fn in_box(&mut self, dim: u8, corners: &Expression) -> Answer<Value> {
        let [x, y, z, to_x, to_y, to_z] = self.exactly(corners, "a box", "six coordinates")?;
        let work = self.model.size();
        self.spend(work, corners.place)?;
        let found = self.model.in_box(dim, [x, y, z], [to_x, to_y, to_z]);
        Ok(Value::List(found.into_iter().map(f64::from).collect()))
    }

    fn coordinates(&mut self, tag: &Expression) -> Answer<Value> {
        let number = self.tag(tag, "the number of a point")?;
        let point = self.model.point(number).map_err(|problem| problem.at(tag.place))?;
        Ok(Value::List(point.at.to_vec()))
    }

    fn members(&mut self, dim: u8, tags: &Expression) -> Answer<Value> {
        let mut members = Vec::new();
        for tag in self.tags(tags, "the number of a group")? {
            match self.model.groups.get(&(dim, tag)) {
                Some(group) => members.extend(group.members.iter().copied().map(f64::from)),
                None => {
                    return Err(crate::geo::model::unknown("physical group", tag).at(tags.place));
                }
            }
        }
        self.spend(members.len() as u64, tags.place)?;
        Ok(Value::List(members))
    }
}
