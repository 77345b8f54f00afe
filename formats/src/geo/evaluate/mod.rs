//! The evaluator: runs statements, which make the geometry.
//!
//! Nothing is executed, written or read but included files; work, memory and depth are bounded.

mod assign;
mod budget;
mod commands;
mod expressions;
mod format;
mod functions;
mod geometry;
mod options;
mod value;

use std::collections::BTreeMap;
use std::io;
use std::rc::Rc;

use super::error::Problem;
use super::grammar::{Text, next_statement};
use super::model::Model;
use super::sources::{Answer, SourceText, Sources};
use super::syntax::{Action, Block, Expression, Place, Statement};
use budget::{Budget, MOST_CALLS, STATEMENT};
pub(super) use options::Options;
use value::Value;

/// Gives the text of an included file, by its name.
pub(super) type Include<'i> = &'i mut dyn FnMut(&str) -> io::Result<Vec<u8>>;

/// Whether a script goes on after a statement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Flow {
    On,
    /// `Exit;`
    Stop,
}

/// What a script knows and has made so far.
pub(super) struct Evaluator<'a, 'i> {
    pub sources: Sources<'a>,
    pub model: Model,
    pub options: Options,
    /// Statements that were passed over: how often, and where first, by their name.
    pub skipped: BTreeMap<String, (u32, Place)>,
    include: Include<'i>,
    variables: BTreeMap<String, Value>,
    macros: BTreeMap<String, Block>,
    budget: Budget,
    /// How many macros and files are open.
    calls: u32,
}

impl<'a, 'i> Evaluator<'a, 'i> {
    /// An evaluator that knows nothing yet.
    pub(super) fn new(include: Include<'i>) -> Self {
        Self {
            sources: Sources::default(),
            model: Model::default(),
            options: Options::default(),
            skipped: BTreeMap::new(),
            include,
            variables: BTreeMap::new(),
            macros: BTreeMap::new(),
            budget: Budget::new(0),
            calls: 0,
        }
    }

    /// Reads and runs a whole script.
    pub(super) fn run_script(&mut self, text: &'a [u8], name: &str) -> Answer<()> {
        self.budget = Budget::new(text.len());
        let file = self.sources.add(name.to_owned(), SourceText::Script(text));
        self.run_file(file, text).map(|_| ())
    }

    /// Reads and runs a file, statement by statement.
    fn run_file(&mut self, file: u32, text: &[u8]) -> Answer<Flow> {
        let mut rest = Text::new(text, file);
        if text.starts_with(b"\xef\xbb\xbf") {
            rest = rest.after(3);
        }
        loop {
            let statement = match next_statement(rest) {
                Ok((_, None)) => return Ok(Flow::On),
                Ok((after, Some(statement))) => {
                    rest = after;
                    statement
                }
                Err(nom::Err::Error(fault) | nom::Err::Failure(fault)) => {
                    return Err(self.sources.syntax(fault));
                }
                Err(nom::Err::Incomplete(_)) => unreachable!("the whole text is there"),
            };
            if self.run(&statement)? == Flow::Stop {
                return Ok(Flow::Stop);
            }
        }
    }

    fn run_block(&mut self, block: &Block) -> Answer<Flow> {
        for statement in block.iter() {
            if self.run(statement)? == Flow::Stop {
                return Ok(Flow::Stop);
            }
        }
        Ok(Flow::On)
    }

    fn run(&mut self, statement: &Statement) -> Answer<Flow> {
        let place = statement.place;
        self.spend(STATEMENT, place)?;
        match &statement.action {
            Action::Assign { target, operator, value } => self.assign(target, *operator, value)?,
            Action::Option { name, operator, value } => {
                self.set_option(place, name, *operator, value)?
            }
            Action::Define(constants) => self.define(constants)?,
            Action::Entity { kind, tag, value } => self.make_entity(place, *kind, tag, value)?,
            Action::Physical { dim, name, tag, operator, members } => {
                self.make_group(place, *dim, [name.as_ref(), tag.as_ref()], *operator, members)?;
            }
            Action::Size { points, size } => self.set_sizes(points, size)?,
            Action::Transfinite { curves, points, law } => {
                self.set_spread(place, curves, points, law.as_ref())?;
            }
            Action::Embed { dim, members, surfaces } => {
                self.embed(place, *dim, members, surfaces)?
            }
            Action::Command(command) => {
                self.command(command)?;
            }
            Action::Delete { shapes, recursive } => self.delete(place, shapes, *recursive)?,
            Action::DeletePhysicals => self.model.groups.clear(),
            Action::Coherence => self.cohere(place)?,
            Action::Factory(name) => {
                let name = self.text(name)?;
                self.model.is_occ = name == "OpenCASCADE";
            }
            Action::If { branches, otherwise } => return self.run_if(branches, otherwise),
            Action::For { variable, first, last, step, body } => {
                return self.run_for(variable.as_deref(), [first, last], step.as_ref(), body);
            }
            Action::Macro { name, body } => {
                self.macros.insert(name.clone(), Rc::clone(body));
            }
            Action::Call(name) => return self.run_macro(place, name),
            Action::Include { name, merge } => return self.run_include(place, name, *merge),
            Action::Fail(message) => return Err(self.raised(place, message.as_deref())?),
            Action::Exit => return Ok(Flow::Stop),
            Action::Skipped(name) => self.skip(name, place),
            Action::Unsupported(statement) => return Err(unsupported(statement).at(place)),
        }
        Ok(Flow::On)
    }

    fn run_if(&mut self, branches: &[(Expression, Block)], otherwise: &Block) -> Answer<Flow> {
        for (condition, body) in branches {
            if self.number(condition)? != 0.0 {
                return self.run_block(body);
            }
        }
        self.run_block(otherwise)
    }

    fn run_for(
        &mut self,
        variable: Option<&str>,
        [first, last]: [&Expression; 2],
        step: Option<&Expression>,
        body: &Block,
    ) -> Answer<Flow> {
        let place = first.place;
        let (first, last) = (self.number(first)?, self.number(last)?);
        let step = step.map_or(Ok(1.0), |step| self.number(step))?;
        if step == 0.0 {
            return Err(Problem::Endless.at(place));
        }
        // As Gmsh counts: by adding the step, with some room for rounding at the end.
        let room = 1e-12 * step.abs();
        let mut value = first;
        while if step > 0.0 { value <= last + room } else { value >= last - room } {
            self.spend(STATEMENT, place)?;
            if let Some(name) = variable {
                self.variables.insert(name.to_owned(), Value::Number(value));
            }
            if self.run_block(body)? == Flow::Stop {
                return Ok(Flow::Stop);
            }
            let next = value + step;
            if next == value {
                return Err(Problem::Endless.at(place));
            }
            value = next;
        }
        if let Some(name) = variable {
            self.variables.insert(name.to_owned(), Value::Number(value));
        }
        Ok(Flow::On)
    }

    fn run_macro(&mut self, place: Place, name: &Expression) -> Answer<Flow> {
        let name = self.text(name)?;
        let Some(body) = self.macros.get(&name).map(Rc::clone) else {
            return Err(Problem::Unknown { what: "macro", name }.at(place));
        };
        self.enter(place, "macros call one another more than 100 deep")?;
        let flow = self.run_block(&body);
        self.calls -= 1;
        flow
    }

    /// Runs an included script. `Merge` also takes meshes and other geometry, which are not read.
    fn run_include(&mut self, place: Place, name: &Expression, merge: bool) -> Answer<Flow> {
        let name = self.text(name)?;
        if merge && !name.ends_with(".geo") {
            return Err(unsupported("Merge of a file that is no .geo script").at(place));
        }
        let fail = |reason: String| Problem::Include { name: name.clone(), reason }.at(place);
        let Some(path) = beside(self.sources.name(place.file), &name) else {
            return Err(fail("it is not beside the script".to_owned()));
        };
        self.enter(place, "files include one another more than 100 deep")?;
        let bytes: Rc<[u8]> = match (self.include)(&path) {
            Ok(bytes) if bytes.len() < u32::MAX as usize => bytes.into(),
            Ok(_) => return Err(fail("it is larger than 4 GiB".to_owned())),
            Err(error) => return Err(fail(error.to_string())),
        };
        self.spend(bytes.len() as u64, place)?;
        let file = self.sources.add(path, SourceText::Included(Rc::clone(&bytes)));
        let flow = self.run_file(file, &bytes);
        self.calls -= 1;
        flow
    }

    fn enter(&mut self, place: Place, what: &'static str) -> Answer<()> {
        if self.calls == MOST_CALLS {
            return Err(Problem::Limit { what }.at(place));
        }
        self.calls += 1;
        Ok(())
    }

    /// The script's own error.
    fn raised(
        &mut self,
        place: Place,
        message: Option<&[Expression]>,
    ) -> Answer<super::sources::Trouble> {
        let message = match message {
            Some(parts) => {
                let mut values = Vec::new();
                for part in parts {
                    values.push(self.value(part)?);
                }
                format!("`{}`", format::sprintf(values).map_err(|problem| problem.at(place))?)
            }
            None => "`Abort`".to_owned(),
        };
        Ok(Problem::Raised { message }.at(place))
    }

    /// Notes a statement that is passed over.
    fn skip(&mut self, name: &str, place: Place) {
        if name == ";" {
            return;
        }
        match self.skipped.get_mut(name) {
            Some((count, _)) => *count += 1,
            None => {
                self.skipped.insert(name.to_owned(), (1, place));
            }
        }
    }

    fn spend(&mut self, work: u64, place: Place) -> Answer<()> {
        self.budget.spend(work).map_err(|problem| problem.at(place))
    }
}

/// A statement that is not read; a file of another program is known by its first word.
fn unsupported(statement: &str) -> Problem {
    match statement.split(' ').next() {
        Some("algebraic3d" | "splinecurves2d" | "splinecurves2dv2" | "solid" | "tlo") => {
            Problem::Foreign { of: "Netgen" }
        }
        _ => Problem::Unsupported { statement: statement.to_owned() },
    }
}

/// The name of a file beside another one, or in a folder below; `None` if it is elsewhere.
fn beside(script: &str, name: &str) -> Option<String> {
    let is_below = |part: &str| !matches!(part, "" | "..") && !part.contains(['\\', ':', '\0']);
    if !name.split('/').all(is_below) {
        return None;
    }
    let folder = script.rfind(['/', '\\']).map_or("", |end| &script[..=end]);
    Some(format!("{folder}{name}"))
}
